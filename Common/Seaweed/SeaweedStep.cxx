// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Seaweed/SeaweedJoint.h"

#include <glm/mat3x3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

// A step of the equations of motion, for trees side by side.

namespace littoral
{

namespace
{

using Vector = glm::vec<3, Lanes>;
using Matrix = glm::mat<3, 3, Lanes>;
using Turn = glm::qua<Lanes>;

// The articulated-body algorithm (R. Featherstone, Rigid Body Dynamics Algorithms, 2008, chapter 7) about the feet of
// the links, in axes of the world, with an implicit midpoint rule around it. Symbols: v, w velocity of the foot and
// spin of a link; I its inertia, a quadratic form in both; I^A that of the link with all that grows on it
// (articulated); S the motion subspace of its joint; p^A the bias. Equations are those for a half step g, in impulses.

/// The midpoint rule: no joint turns further in a step [rad], whatever drives it; so that what blows up stays finite.
constexpr double MostTurn = 0.8;
/// A step in which a link turns further [rad] is taken in two halves.
constexpr double LongestTurn = 0.5;
/// The midpoint is iterated until no joint is corrected by more [rad of turn in the step]; after MostIterations, or
/// where corrections exceed the second number, the step is taken in two halves.
constexpr double SmallCorrection = 5e-3;
constexpr double LargeCorrection = 0.05;
constexpr int LeastIterations = 2; // which make it second order
constexpr int MostIterations = 4;
/// A step that gains more energy than loads give, by this part of the kinetic energy, is taken in two halves; of what
/// is left, all is taken from the rates.
constexpr double EnergyError = 0.05;
/// Parts of a step: sub-steps are a power of two of them, and no shorter.
constexpr int PartsOfStep = 64;
/// A blade does not fold flat: a joint bent further [rad] is pushed back, by x beyond it with the potential
/// K_s/2 x2 / (1 - x/X), which has no bounds at X [rad], but for a linear force in the last part of the way.
constexpr double MostBend = 1.75;
constexpr double WayOfStop = 1.05;
constexpr double PartOfStop = 0.95;

/// A symmetric matrix of three rows.
struct Symmetric
{
  Lanes xx, xy, xz, yy, yz, zz;

  LITTORAL_INLINE Symmetric(const Lanes& diagonal = 0.0)
    : xx(diagonal)
    , xy(0.0)
    , xz(0.0)
    , yy(diagonal)
    , yz(0.0)
    , zz(diagonal)
  {
  }
  LITTORAL_INLINE Vector operator*(const Vector& v) const
  {
    return { this->xx * v.x + this->xy * v.y + this->xz * v.z, this->xy * v.x + this->yy * v.y + this->yz * v.z,
      this->xz * v.x + this->yz * v.y + this->zz * v.z };
  }
  LITTORAL_INLINE void operator+=(const Symmetric& o)
  {
    this->xx += o.xx;
    this->xy += o.xy;
    this->xz += o.xz;
    this->yy += o.yy;
    this->yz += o.yz;
    this->zz += o.zz;
  }
  LITTORAL_INLINE void AddDiagonal(const Lanes& d)
  {
    this->xx += d;
    this->yy += d;
    this->zz += d;
  }
  /// Adds f a a^T.
  LITTORAL_INLINE void AddSquare(const Lanes& f, const Vector& a)
  {
    const Vector b = f * a;
    this->xx += a.x * b.x;
    this->xy += a.x * b.y;
    this->xz += a.x * b.z;
    this->yy += a.y * b.y;
    this->yz += a.y * b.z;
    this->zz += a.z * b.z;
  }
  /// Takes a b^T + c d^T away, a sum that is symmetric.
  LITTORAL_INLINE void Subtract(const Vector& a, const Vector& b, const Vector& c, const Vector& d)
  {
    this->xx -= a.x * b.x + c.x * d.x;
    this->xy -= a.x * b.y + c.x * d.y;
    this->xz -= a.x * b.z + c.x * d.z;
    this->yy -= a.y * b.y + c.y * d.y;
    this->yz -= a.y * b.z + c.y * d.z;
    this->zz -= a.z * b.z + c.z * d.z;
  }
};

/// The matrix of the cross product with a from the left, times a symmetric matrix from the left: S [a].
LITTORAL_INLINE Matrix TimesCross(const Symmetric& s, const Vector& a)
{
  // Columns of [a]: a x e_k.
  const Lanes none(0.0);
  return { s * Vector(none, a.z, -a.y), s * Vector(-a.z, none, a.x), s * Vector(a.y, -a.x, none) };
}

/// a x each column.
LITTORAL_INLINE Matrix CrossTimes(const Vector& a, const Matrix& m)
{
  return { glm::cross(a, m[0]), glm::cross(a, m[1]), glm::cross(a, m[2]) };
}

/// A unit vector turned by a small rotation vector at a right angle to it.
LITTORAL_INLINE Vector Swung(const Vector& direction, const Vector& turn)
{
  const Lanes square = glm::dot(turn, turn);
  const Vector swung = CosineOfSmall(square) * direction + SineRatioOfSmall(square) * glm::cross(turn, direction);
  return swung / LengthOf(swung);
}

/// What is known of a link during a step. Unknown is the correction of the velocities in the middle of the step; the
/// quadratic form in those of the foot and of the spin is [Linear Mixed; Mixed^T Angular].
struct LinkDynamics
{
  LinkStateOf<Lanes> Start; // of the sub-step
  LinkPoseOf<Lanes> StartPose;
  LinkStateOf<Lanes> End;
  LinkPoseOf<Lanes> EndPose;
  LinkStateOf<Lanes> State; // in its middle, as far as known
  Vector MiddleRate;        // Bending: that of State, tangent to the sphere at Start; Tilting: the same
  LinkPoseOf<Lanes> Pose;   // of State
  LinkFaceOf<Lanes> Face;
  Turn Below;                   // of the parent
  Vector Arm;                   // from the parent's foot, now
  Vector VelocityProductLinear; // change of the foot's velocity in g when joints change as they are known to
  Vector VelocityProductAngular;
  Vector B[2];              // axes of the joint, at right angles to the link
  Vector MotionSubspace[2]; // S: spin by a rate about these axes, twist included
  Vector Swerve;            // dS/dt q': acceleration of the spin when the joint does not accelerate
  Lanes Rate[2];            // along the axes
  Lanes Gain[2];            // what of it was gained since the start
  Lanes Spring[2];          // deflection along the axes
  Lanes StopTorque;         // of the stop, for a deflection of 1 [N m/rad]
  Lanes StopStiffness;      // [N m/rad]
  Symmetric Linear;         // I^A
  Matrix Mixed;
  Symmetric Angular;
  Vector BiasLinear; // -p^A, as impulses
  Vector BiasAngular;
  Vector Force;           // of the water on all from here on
  LinkLoadOf<Lanes> Load; // on the link itself
  Vector WorkForce;       // those of the last iteration of a lane
  Vector WorkMoment;
  Vector Spin;
  Lanes Tension; // arm times pull: what straightens the link
  Vector U[2];   // I^A S, linear
  Vector G[2];   // and angular
  Lanes InverseJointInertia[3];
  Lanes JointImpulse[2];
};

/// Lane by lane, one of two.
LITTORAL_INLINE Vector Choice(const Lanes& isFirst, const Vector& first, const Vector& second)
{
  const Lanes half(0.5);
  return { WhereLess(half, isFirst, first.x, second.x), WhereLess(half, isFirst, first.y, second.y),
    WhereLess(half, isFirst, first.z, second.z) };
}

LITTORAL_INLINE Turn Choice(const Lanes& isFirst, const Turn& first, const Turn& second)
{
  const Lanes half(0.5);
  return { WhereLess(half, isFirst, first.w, second.w), WhereLess(half, isFirst, first.x, second.x),
    WhereLess(half, isFirst, first.y, second.y), WhereLess(half, isFirst, first.z, second.z) };
}

LITTORAL_INLINE Lanes Square(const Lanes& x)
{
  return x * x;
}

/// What is tangent to the sphere at one direction, carried to another along the great circle between them.
LITTORAL_INLINE Vector Transported(const Vector& tangent, const Vector& from, const Vector& to)
{
  const Lanes open = Larger(Lanes(1.0) + glm::dot(from, to), Lanes(0.05));
  return tangent - (glm::dot(tangent, to) / open) * (from + to);
}

/// One iteration for the middle of a sub-step of a bunch, lanes with their own lengths.
class BunchStep
{
public:
  BunchStep(const SeaweedOptions& options)
    : Options(options)
    , IsImplicit(options.Integrator == SeaweedIntegrator::Implicit)
  {
  }

  Lanes Half{ 0.0 }; // g: half of the sub-step [s]; explicit Euler: the step

  /// The first guess of the middle: rates of the start.
  LITTORAL_INLINE void BeginLink(LinkDynamics& link) const
  {
    link.State.Shape = link.Start.Shape;
    link.State.Rate = link.Start.Rate;
    link.MiddleRate = link.Start.Rate;
    if (this->IsImplicit)
    {
      this->MoveToMiddle(link);
    }
  }

  /// Pose, axes, deflection, inertia, loads and velocity products of the link by itself.
  LITTORAL_INLINE void InitializeLink(const LinkBody<Lanes>& body, const WaterOf<Lanes>& water,
    const LinkBody<Lanes>* parentBody, const LinkDynamics* parent, LinkDynamics& link) const
  {
    const Lanes g = this->Half;
    PoseLink<Lanes>(this->Options.Joint, body, link.State, parentBody, parent ? &parent->Pose : nullptr, link.Pose);
    const LinkPoseOf<Lanes>& pose = link.Pose;
    link.Face = FaceOf<Lanes>(body, pose);
    link.Below = parent ? parent->Pose.Turn : NoTurn<Lanes>();
    const Vector relative = this->FindAxes(body, parentBody, link);

    // Velocity products c = g (dS/dt q' + w_p x S q') + S (q' - q0'), and those of the parent on the arm.
    link.Arm = Vector(Lanes(0.0));
    link.VelocityProductLinear = link.Arm;
    link.VelocityProductAngular =
      g * link.Swerve + link.Gain[0] * link.MotionSubspace[0] + link.Gain[1] * link.MotionSubspace[1];
    if (parent)
    {
      const Vector& spin = parent->Pose.Spin;
      link.Arm = pose.Foot - parent->Pose.Foot;
      link.VelocityProductAngular += parent->VelocityProductAngular + g * glm::cross(spin, relative);
      link.VelocityProductLinear = parent->VelocityProductLinear +
        glm::cross(parent->VelocityProductAngular, link.Arm) + g * glm::cross(spin, glm::cross(spin, link.Arm));
    }

    link.Load = LoadOn<Lanes>(this->Options, body, pose, link.Face, water);
    link.Force = link.Load.Force;
    link.Tension = glm::dot(pose.Axis, link.Load.Moment);
    // -p = g f - g (v x* I v) - I c
    this->SetBias(body, link);
    // Drag falls with the correction of the velocity: I + g df/dv.
    this->SetInertia(body, this->IsImplicit ? g : Lanes(0.0), link);
  }

  /// The joint itself: its inertia and what drives it, all that grows on the link being known.
  LITTORAL_INLINE void SolveJoint(const LinkBody<Lanes>& body, LinkDynamics& link) const
  {
    const Vector& e = link.Pose.Axis;
    const Lanes g = this->Half;
    const Lanes implicit = this->IsImplicit ? g : Lanes(0.0);
    // A pull T along a segment of length l straightens it as a spring l T would: I + g2 T l (1 - e e^T).
    const Lanes straightens = implicit * implicit * Larger(link.Tension, Lanes(0.0));
    link.Angular.AddDiagonal(straightens);
    link.Angular.AddSquare(-straightens, e);
    // U = I^A S
    for (int k = 0; k < 2; ++k)
    {
      link.G[k] = link.Angular * link.MotionSubspace[k];
      link.U[k] = link.Mixed * link.MotionSubspace[k];
    }
    // D = S^T I^A S
    Lanes n00 = glm::dot(link.MotionSubspace[0], link.G[0]);
    const Lanes n01 = glm::dot(link.MotionSubspace[0], link.G[1]);
    Lanes n11 = glm::dot(link.MotionSubspace[1], link.G[1]);
    const Lanes stiffness = body.Stiffness + link.StopStiffness;
    const Lanes damping = body.Damping + WhereLess(Lanes(0.0), link.StopTorque, body.StopDamping, Lanes(0.0));
    const Lanes bent = body.Stiffness + link.StopTorque;
    // Springs that the step does not resolve are damped by c = K g s / (1 + s), s = (g2 K / D)^2, on the rate at the
    // end of the step; others are not: c falls with the fifth power of the step.
    const Lanes stiff = implicit * implicit * body.Stiffness;
    const Lanes squared[2] = { Square(stiff * n11), Square(stiff * n00) };
    const Lanes det = Square(n00 * n11 - n01 * n01);
    const Lanes all = implicit * body.Stiffness;
    const Lanes filter[2] = { all * squared[0] / (squared[0] + det), all * squared[1] / (squared[1] + det) };
    // u = -S^T p^A - g (K q + d q' + c (2 q' - q0'))
    for (int k = 0; k < 2; ++k)
    {
      link.JointImpulse[k] = glm::dot(link.MotionSubspace[k], link.BiasAngular) -
        g * (bent * link.Spring[k] + damping * link.Rate[k] + filter[k] * (link.Rate[k] + link.Gain[k]));
    }
    // D + g (g K + d + 2 c)
    const Lanes soft = implicit * (implicit * stiffness + damping);
    n00 += soft + Lanes(2.0) * implicit * filter[0];
    n11 += soft + Lanes(2.0) * implicit * filter[1];
    const Lanes scale = Lanes(1.0) / (n00 * n11 - n01 * n01);
    link.InverseJointInertia[0] = scale * n11;
    link.InverseJointInertia[1] = -scale * n01;
    link.InverseJointInertia[2] = scale * n00;
  }

  /// What the parent feels of a link and of all that grows on it: I^a = I^A - U D^-1 U^T, p^a = p^A + U D^-1 u.
  LITTORAL_INLINE void PropagateToParent(LinkDynamics& link, LinkDynamics& parent) const
  {
    Vector uD[2];
    Vector gD[2];
    for (int k = 0; k < 2; ++k)
    {
      uD[k] = link.InverseJointInertia[k] * link.U[0] + link.InverseJointInertia[k + 1] * link.U[1];
      gD[k] = link.InverseJointInertia[k] * link.G[0] + link.InverseJointInertia[k + 1] * link.G[1];
    }
    link.Linear.Subtract(uD[0], link.U[0], uD[1], link.U[1]);
    link.Angular.Subtract(gD[0], link.G[0], gD[1], link.G[1]);
    Matrix mixed = link.Mixed;
    for (int column = 0; column < 3; ++column)
    {
      mixed[column] -= uD[0] * link.G[0][column] + uD[1] * link.G[1][column];
    }
    const Vector linear = link.BiasLinear - uD[0] * link.JointImpulse[0] - uD[1] * link.JointImpulse[1];
    const Vector angular = link.BiasAngular - gD[0] * link.JointImpulse[0] - gD[1] * link.JointImpulse[1];
    // Both about the foot of the parent: X^T I^a X.
    const Matrix shifted = mixed - TimesCross(link.Linear, link.Arm);
    const Matrix a = CrossTimes(link.Arm, shifted);
    const Matrix b = CrossTimes(link.Arm, mixed);
    parent.Linear += link.Linear;
    parent.Mixed += shifted;
    parent.Angular += link.Angular;
    parent.Angular.xx += a[0].x + b[0].x;
    parent.Angular.xy += a[1].x + b[0].y;
    parent.Angular.xz += a[2].x + b[0].z;
    parent.Angular.yy += a[1].y + b[1].y;
    parent.Angular.yz += a[2].y + b[1].z;
    parent.Angular.zz += a[2].z + b[2].z;
    parent.BiasLinear += linear;
    parent.BiasAngular += angular + glm::cross(link.Arm, linear);
    parent.Force += link.Force;
    parent.Tension += glm::dot(link.Arm, link.Force);
  }

  /// Corrects the middle of a link where lanes are open, the correction of its parent being known. Gives the turn of
  /// the correction in the step [rad].
  LITTORAL_INLINE Lanes IntegrateLink(const Lanes& isOpen, const LinkDynamics* parent, LinkDynamics& link) const
  {
    link.WorkForce = Choice(isOpen, link.Load.Force, link.WorkForce);
    link.WorkMoment = Choice(isOpen, link.Load.Moment, link.WorkMoment);
    link.Spin = Choice(isOpen, link.Pose.Spin, link.Spin);
    Vector dv(Lanes(0.0));
    Vector dw(Lanes(0.0));
    if (parent)
    {
      // The biases of a parent are not needed any more; they hold its corrections now.
      dw = parent->BiasAngular;
      dv = parent->BiasLinear + glm::cross(dw, link.Arm);
    }
    // q' += D^-1 (u - U^T a_p)
    Lanes impulse[2];
    for (int k = 0; k < 2; ++k)
    {
      impulse[k] = link.JointImpulse[k] - glm::dot(link.G[k], dw) - glm::dot(link.U[k], dv);
    }
    Lanes change[2];
    for (int k = 0; k < 2; ++k)
    {
      change[k] = WhereLess(Lanes(0.5), isOpen,
        link.InverseJointInertia[k] * impulse[0] + link.InverseJointInertia[k + 1] * impulse[1], Lanes(0.0));
      dw += change[k] * link.MotionSubspace[k];
    }
    link.BiasLinear = dv;
    link.BiasAngular = dw;
    this->Correct(change, link);
    return Lanes(2.0) * this->Half * SquareRoot(change[0] * change[0] + change[1] * change[1]);
  }

  /// The state at the end of the sub-step, twice the way to its middle, and the pose.
  LITTORAL_INLINE void EndLink(const LinkBody<Lanes>& body, const LinkBody<Lanes>* parentBody,
    const LinkDynamics* parent, LinkDynamics& link) const
  {
    Vector rate = Lanes(2.0) * link.MiddleRate - link.Start.Rate;
    Vector turn = Lanes(2.0) * this->Half * link.MiddleRate;
    if (!this->IsImplicit)
    {
      rate = link.MiddleRate;
      turn = this->Half * link.Start.Rate;
    }
    const Lanes most = Larger(LengthOf(turn), this->Half * LengthOf(rate));
    const Lanes factor = WhereLess(Lanes(MostTurn), most, Lanes(MostTurn) / Larger(most, Lanes(1e-300)), Lanes(1.0));
    turn *= factor;
    rate *= factor;
    link.End.Rate = rate;
    if (this->Options.Joint == SeaweedJoint::Tilting)
    {
      link.End.Shape = link.Start.Shape + turn;
    }
    else
    {
      link.End.Shape = Swung(link.Start.Shape, turn);
      link.End.Rate = Transported(rate, link.Start.Shape, link.End.Shape);
      link.End.Rate -= glm::dot(link.End.Rate, link.End.Shape) * link.End.Shape;
    }
    PoseLink<Lanes>(this->Options.Joint, body, link.End, parentBody, parent ? &parent->EndPose : nullptr, link.EndPose);
  }

  /// The work of loads on a link in the sub-step, by the ways of their points [J]; so that dead loads have a potential.
  LITTORAL_INLINE Lanes WorkOf(const LinkDynamics& link) const
  {
    return glm::dot(link.WorkForce, link.EndPose.Foot - link.StartPose.Foot) +
      glm::dot(link.WorkMoment, link.EndPose.Axis - link.StartPose.Axis);
  }

  /// T = 1/2 integral of (m v.v + m_n (v.n)2 + m_b (v.b)2) + J/2 (w.e)2 [J]
  LITTORAL_INLINE Lanes KineticEnergy(const LinkBody<Lanes>& body, const LinkPoseOf<Lanes>& pose) const
  {
    const LinkFaceOf<Lanes> face = FaceOf<Lanes>(body, pose);
    const Vector turning = body.Length * glm::cross(pose.Spin, pose.Axis);
    // The mean over the link of (v + s t)(v + s t): v v + v t + t t / 3.
    const auto mean = [](const Lanes& v, const Lanes& t) { return v * (v + t) + Lanes(1.0 / 3.0) * t * t; };
    const Lanes normal = mean(glm::dot(pose.Velocity, face.Normal), glm::dot(turning, face.Normal));
    const Lanes edge = mean(glm::dot(pose.Velocity, face.Edge), glm::dot(turning, face.Edge));
    const Lanes along = Square(glm::dot(pose.Velocity, pose.Axis));
    const Lanes spin = Square(glm::dot(pose.Spin, pose.Axis));
    return Lanes(0.5) *
      ((body.Mass + body.FaceMass) * normal + (body.Mass + body.EdgeMass) * edge + body.Mass * along +
        body.AxialInertia * spin);
  }

  /// V = K/2 q2, and that of the stop [J]
  LITTORAL_INLINE Lanes SpringEnergy(const LinkBody<Lanes>& body, const LinkStateOf<Lanes>& state) const
  {
    if (this->Options.Joint == SeaweedJoint::Tilting)
    {
      return Lanes(0.5) * body.Stiffness * (Square(state.Shape.x - body.Theta) + Square(state.Shape.y - body.Phi));
    }
    const Lanes angle = AngleOf(LengthOf(glm::cross(body.Axis, state.Shape)), glm::dot(body.Axis, state.Shape));
    const Lanes way = Larger(Lanes(0.0), angle - Lanes(MostBend)) * Lanes(1.0 / WayOfStop);
    const Lanes y = Smaller(way, Lanes(PartOfStop));
    const Lanes left = Lanes(1.0) / (Lanes(1.0) - y);
    const Lanes beyond = way - y;
    const Lanes stop = Lanes(0.5) * y * y * left + Lanes(0.5) * y * (Lanes(2.0) - y) * left * left * beyond +
      Lanes(0.5) * left * left * left * beyond * beyond;
    return Lanes(0.5) * body.Stiffness * angle * angle + body.StopStiffness * Lanes(WayOfStop * WayOfStop) * stop;
  }

private:
  const SeaweedOptions& Options;
  bool IsImplicit;

  /// I of the link about its foot, in axes b (width), n (face) and e (axis), with drag times a time.
  LITTORAL_INLINE void SetInertia(const LinkBody<Lanes>& body, const Lanes& time, LinkDynamics& link) const
  {
    const LinkLoadOf<Lanes>& load = link.Load;
    const Vector& b = link.Face.Edge;
    const Vector& n = link.Face.Normal;
    const Lanes half = Lanes(0.5) * body.Length;
    const Lanes third = Lanes(1.0 / 3.0) * body.Length * body.Length;
    const Lanes massB = body.Mass + body.EdgeMass;
    const Lanes massN = body.Mass + body.FaceMass;
    const Lanes linearB = massB + time * load.EdgeDrag.Sum;
    const Lanes linearN = massN + time * load.FaceDrag.Sum;
    const Lanes linearE = body.Mass + time * load.Friction;
    const Lanes firstB = half * massB + time * load.EdgeDrag.First;
    const Lanes firstN = half * massN + time * load.FaceDrag.First;
    const Lanes secondB = third * massB + time * load.EdgeDrag.Second;
    const Lanes secondN = third * massN + time * load.FaceDrag.Second;
    // Linear = m_b b b^T + m_n n n^T + m_e e e^T
    link.Linear = Symmetric(linearE);
    link.Linear.AddSquare(linearB - linearE, b);
    link.Linear.AddSquare(linearN - linearE, n);
    // Mixed = first_b b n^T - first_n n b^T
    const Vector fb = firstB * b;
    const Vector fn = firstN * n;
    link.Mixed = Matrix(fb * n.x - fn * b.x, fb * n.y - fn * b.y, fb * n.z - fn * b.z);
    // Angular = second_n b b^T + second_b n n^T + J e e^T
    link.Angular = Symmetric(body.AxialInertia);
    link.Angular.AddSquare(secondN - body.AxialInertia, b);
    link.Angular.AddSquare(secondB - body.AxialInertia, n);
  }

  /// The impulse of what the link itself feels when joints change as they are known to: loads, less what it takes to
  /// carry its momentum along, v x* I v, and to change it by the velocity products.
  LITTORAL_INLINE void SetBias(const LinkBody<Lanes>& body, LinkDynamics& link) const
  {
    const Lanes g = this->Half;
    const Vector& b = link.Face.Edge;
    const Vector& n = link.Face.Normal;
    const Vector& e = link.Pose.Axis;
    const auto inAxes = [&](const Vector& x) { return Vector(glm::dot(x, b), glm::dot(x, n), glm::dot(x, e)); };
    const Lanes half = Lanes(0.5) * body.Length;
    const Lanes third = Lanes(1.0 / 3.0) * body.Length * body.Length;
    const Vector mass(body.Mass + body.EdgeMass, body.Mass + body.FaceMass, body.Mass);
    // I (v, w) = (P, H) in axes b (width), n (face), e: momentum and its moment about the foot.
    const auto momentumOf = [&](const Vector& v, const Vector& w) {
      return Vector(mass.x * (v.x + half * w.y), mass.y * (v.y - half * w.x), mass.z * v.z);
    };
    const auto momentOf = [&](const Vector& v, const Vector& w) {
      return Vector(mass.y * (third * w.x - half * v.y), mass.x * (third * w.y + half * v.x), body.AxialInertia * w.z);
    };
    const Vector v = inAxes(link.Pose.Velocity);
    const Vector w = inAxes(link.Pose.Spin);
    const Vector momentum = momentumOf(v, w);
    // dP/dt = I dv/dt + w x P - I (w x v), dH/dt = ... + w x H + v x P
    const Vector linear = inAxes(link.VelocityProductLinear) - g * glm::cross(w, v);
    const Vector angular = inAxes(link.VelocityProductAngular);
    const Vector force = momentumOf(linear, angular) + g * glm::cross(w, momentum);
    const Vector torque = momentOf(linear, angular) + g * (glm::cross(w, momentOf(v, w)) + glm::cross(v, momentum));
    link.BiasLinear = g * link.Load.Force - (force.x * b + force.y * n + force.z * e);
    link.BiasAngular = g * glm::cross(e, link.Load.Moment) - (torque.x * b + torque.y * n + torque.z * e);
  }

  /// The state of the middle by its rates.
  LITTORAL_INLINE void MoveToMiddle(LinkDynamics& link) const
  {
    const Lanes speed = this->Half * LengthOf(link.MiddleRate);
    const Lanes most(0.5 * MostTurn);
    link.MiddleRate *= WhereLess(most, speed, most / Larger(speed, Lanes(1e-300)), Lanes(1.0));
    const Vector turn = this->Half * link.MiddleRate;
    link.State.Rate = link.MiddleRate; // about which the direction turns: the same at both ends
    link.State.Shape =
      this->Options.Joint == SeaweedJoint::Tilting ? link.Start.Shape + turn : Swung(link.Start.Shape, turn);
  }

  /// K_s/2 x2 / (1 - x/X), x: how far the joint is bent beyond MostBend. The paper has none.
  LITTORAL_INLINE void FindStop(const LinkBody<Lanes>& body, const Lanes& angle, LinkDynamics& link) const
  {
    const Lanes one(1.0);
    const Lanes strength = this->IsImplicit ? body.StopStiffness : Lanes(0.0);
    const Lanes way = Larger(Lanes(0.0), angle - Lanes(MostBend)) * Lanes(1.0 / WayOfStop);
    const Lanes y = Smaller(way, Lanes(PartOfStop));
    const Lanes left = one / (one - y);
    const Lanes stiffness = strength * left * left * left;
    const Lanes torque = strength * Lanes(0.5) * y * (Lanes(2.0) - y) * left * left + stiffness * (way - y);
    link.StopTorque = Lanes(WayOfStop) * torque / Larger(angle, Lanes(MostBend));
    link.StopStiffness = WhereLess(Lanes(0.0), way, stiffness, Lanes(0.0));
  }

  /// Axes of the joint, with deflection, rate and gain along them. Gives the spin against the parent.
  LITTORAL_INLINE Vector FindAxes(
    const LinkBody<Lanes>& body, const LinkBody<Lanes>* parentBody, LinkDynamics& link) const
  {
    const LinkStateOf<Lanes>& state = link.State;
    if (this->Options.Joint == SeaweedJoint::Bending)
    {
      const Vector& e = link.Pose.Axis;
      link.B[0] = link.Face.Edge;
      link.B[1] = link.Face.Normal;
      const Vector relative = Rotated(link.Below, state.Rate);
      const Vector gain = Rotated(link.Below, state.Rate - Transported(link.Start.Rate, link.Start.Shape, state.Shape));
      const Vector a = Rotated(link.Below, body.Axis);
      // S = B - (B.a) / (1 + a.e) e: the shortest arc from a to e twists.
      for (int k = 0; k < 2; ++k)
      {
        link.MotionSubspace[k] = link.B[k] + TwistOf(a, e, link.B[k]);
      }
      const Lanes open = OpeningOf(a, e);
      const Lanes part = glm::dot(relative, a) / open;
      const Vector swing = glm::cross(relative, e);
      link.Swerve = (part * glm::dot(swing, a) / open) * e - part * swing;
      const Vector bend = Rotated(link.Below, BendTo(body.Axis, state.Shape, body.Side));
      for (int k = 0; k < 2; ++k)
      {
        link.Rate[k] = glm::dot(relative, link.B[k]);
        link.Gain[k] = glm::dot(gain, link.B[k]);
        link.Spring[k] = glm::dot(bend, link.B[k]);
      }
      this->FindStop(body, LengthOf(bend), link);
      return relative + TwistOf(a, e, relative);
    }
    link.StopTorque = Lanes(0.0);
    link.StopStiffness = Lanes(0.0);
    const Turn frame = parentBody ? link.Below * parentBody->Base : GroundBase<Lanes>();
    const Vector y = Rotated(frame, Vector(Lanes(0.0), Lanes(1.0), Lanes(0.0)));
    const Vector x = Rotated(frame, Vector(Cosine(state.Shape.x), Lanes(0.0), -Sine(state.Shape.x)));
    link.MotionSubspace[0] = y;
    link.MotionSubspace[1] = x;
    link.Swerve = (state.Rate.x * state.Rate.y) * glm::cross(y, x); // the axis of the tilt goes with the azimuth
    for (int k = 0; k < 2; ++k)
    {
      link.Rate[k] = state.Rate[k];
      link.Gain[k] = state.Rate[k] - link.Start.Rate[k];
    }
    link.Spring[0] = state.Shape.x - body.Theta;
    link.Spring[1] = state.Shape.y - body.Phi;
    return link.Rate[0] * y + link.Rate[1] * x;
  }

  /// Adds a change of the rates along the axes.
  LITTORAL_INLINE void Correct(const Lanes change[2], LinkDynamics& link) const
  {
    if (this->Options.Joint == SeaweedJoint::Tilting)
    {
      link.MiddleRate += Vector(change[0], change[1], Lanes(0.0));
    }
    else
    {
      const Vector turned = Rotated(Opposite(link.Below), change[0] * link.B[0] + change[1] * link.B[1]);
      link.MiddleRate += Transported(turned, link.State.Shape, link.Start.Shape);
    }
    if (this->IsImplicit)
    {
      this->MoveToMiddle(link);
    }
  }
};

LITTORAL_INLINE WaterOf<Lanes> WaterAt(const WaterAtLink* water)
{
  constexpr LaneIndices at{ 0, 1, 2, 3 };
  WaterOf<Lanes> all;
  all.Velocity = GatherVector(water, at, &WaterAtLink::Velocity);
  all.Acceleration = GatherVector(water, at, &WaterAtLink::Acceleration);
  all.Displacement = GatherVector(water, at, &WaterAtLink::Displacement);
  return all;
}

/// A bunch, and how far its lanes are in a step. A lane has its own sub-steps and iterations: what it does is a
/// function of its own state alone.
class BunchMarch
{
public:
  BunchMarch(const SeaweedOptions& options, double step, std::size_t count, LinkDynamics* links,
    const LinkBody<Lanes>* bodies, const int* parents, const WaterAtLink* water)
    : Rules(options)
    , IsImplicit(options.Integrator == SeaweedIntegrator::Implicit)
    , Step(step)
    , Count(count)
    , Links(links)
    , Bodies(bodies)
    , Parents(parents)
    , Water(water)
  {
  }

  /// All sub-steps of all lanes.
  LITTORAL_INLINE void Run()
  {
    this->Begin();
    while (*std::min_element(this->Done.begin(), this->Done.end()) < PartsOfStep)
    {
      for (int lane = 0; lane < LaneCount; ++lane)
      {
        const double length = this->Step * this->Size[lane] / PartsOfStep;
        this->Rules.Half.Values[lane] = this->IsImplicit ? 0.5 * length : length;
      }
      this->FindMiddle();
      this->FindEnd();
      this->Take();
    }
  }

private:
  BunchStep Rules;
  bool IsImplicit;
  double Step;
  std::size_t Count;
  LinkDynamics* Links;
  const LinkBody<Lanes>* Bodies;
  const int* Parents; // -1: the ground
  const WaterAtLink* Water;
  std::array<int, LaneCount> Done{}; // parts of the step
  std::array<int, LaneCount> Size{}; // parts of the next sub-step
  Lanes Energy{ 0.0 };               // at the start of the sub-step [J]
  Lanes Kinetic{ 0.0 };              // the part of it in motion
  Lanes EndKinetic{ 0.0 };
  Lanes EndEnergy{ 0.0 };
  Lanes Gain{ 0.0 };       // of energy beyond what loads give
  Lanes Correction{ 0.0 }; // of the last iteration, the largest of the links [rad]
  Lanes Turned{ 0.0 };     // in the sub-step, the largest of the links [rad]

  LITTORAL_INLINE const LinkBody<Lanes>* ParentBody(std::size_t i) const
  {
    return this->Parents[i] < 0 ? nullptr : &this->Bodies[this->Parents[i]];
  }
  LITTORAL_INLINE LinkDynamics* ParentOf(std::size_t i) const
  {
    return this->Parents[i] < 0 ? nullptr : &this->Links[this->Parents[i]];
  }

  /// Energy, and first sub-steps by the fastest link.
  LITTORAL_INLINE void Begin()
  {
    Lanes fastest(0.0);
    for (std::size_t i = 0; this->IsImplicit && i < this->Count; ++i)
    {
      const LinkDynamics& link = this->Links[i];
      const Lanes kinetic = this->Rules.KineticEnergy(this->Bodies[i], link.StartPose);
      this->Kinetic += kinetic;
      this->Energy += kinetic + this->Rules.SpringEnergy(this->Bodies[i], link.Start);
      fastest = Larger(fastest, glm::dot(link.StartPose.Spin, link.StartPose.Spin));
    }
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      this->Size[lane] = PartsOfStep;
      double turn = this->Step * std::sqrt(fastest.Values[lane]);
      for (; turn > LongestTurn && this->Size[lane] > 1; turn *= 0.5)
      {
        this->Size[lane] /= 2;
      }
    }
  }

  /// The middle of the sub-step, by iteration.
  LITTORAL_INLINE void FindMiddle()
  {
    Lanes isOpen(1.0);
    bool isAnyOpen = true;
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      this->Rules.BeginLink(this->Links[i]);
    }
    for (int iteration = 1; isAnyOpen && iteration <= (this->IsImplicit ? MostIterations : 1); ++iteration)
    {
      for (std::size_t i = 0; i < this->Count; ++i)
      {
        this->Rules.InitializeLink(this->Bodies[i], WaterAt(this->Water + LaneCount * i), this->ParentBody(i),
          this->ParentOf(i), this->Links[i]);
      }
      for (std::size_t i = this->Count; i-- > 0;)
      {
        this->Rules.SolveJoint(this->Bodies[i], this->Links[i]);
        if (LinkDynamics* parent = this->ParentOf(i))
        {
          this->Rules.PropagateToParent(this->Links[i], *parent);
        }
      }
      Lanes worst(0.0);
      for (std::size_t i = 0; i < this->Count; ++i)
      {
        worst = Larger(worst, this->Rules.IntegrateLink(isOpen, this->ParentOf(i), this->Links[i]));
      }
      this->Correction = WhereLess(Lanes(0.5), isOpen, worst, this->Correction);
      isAnyOpen = false;
      for (int lane = 0; lane < LaneCount; ++lane)
      {
        const bool isEnough = iteration >= LeastIterations && this->Correction.Values[lane] <= SmallCorrection;
        isOpen.Values[lane] = isEnough ? 0.0 : isOpen.Values[lane];
        isAnyOpen = isAnyOpen || (isOpen.Values[lane] > 0.5 && this->Done[lane] < PartsOfStep);
      }
    }
  }

  /// States and poses of the end, with energy.
  LITTORAL_INLINE void FindEnd()
  {
    this->Turned = Lanes(0.0);
    this->EndKinetic = Lanes(0.0);
    Lanes springs(0.0);
    Lanes work(0.0);
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      LinkDynamics& link = this->Links[i];
      this->Rules.EndLink(this->Bodies[i], this->ParentBody(i), this->ParentOf(i), link);
      if (this->IsImplicit)
      {
        this->Turned = Larger(this->Turned, glm::dot(link.Spin, link.Spin));
        this->EndKinetic += this->Rules.KineticEnergy(this->Bodies[i], link.EndPose);
        springs += this->Rules.SpringEnergy(this->Bodies[i], link.End);
        work += this->Rules.WorkOf(link);
      }
    }
    this->Turned = Lanes(2.0) * this->Rules.Half * SquareRoot(this->Turned);
    this->EndEnergy = this->EndKinetic + springs;
    const Lanes rounding = Lanes(1e-11) * (this->EndEnergy + Magnitude(work));
    this->Gain = this->EndEnergy - this->Energy - work - rounding;
  }

  /// Takes the sub-step in lanes where it is good; a shorter one comes next in others.
  LITTORAL_INLINE void Take()
  {
    Lanes isTaken(0.0);
    Lanes factor(1.0);
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      int& size = this->Size[lane];
      int& done = this->Done[lane];
      if (done == PartsOfStep)
      {
        continue;
      }
      const double gain = this->Gain.Values[lane];
      const double kinetic = this->EndKinetic.Values[lane];
      const double turned = this->Turned.Values[lane];
      const double correction = this->Correction.Values[lane];
      const bool isBalanced =
        turned <= 0.1 * LongestTurn || gain <= EnergyError * (kinetic + this->Kinetic.Values[lane]);
      const bool isGood = turned <= 1.5 * LongestTurn && correction <= LargeCorrection && isBalanced;
      if (this->IsImplicit && !isGood && size > 1)
      {
        size /= 2;
        continue;
      }
      if (this->IsImplicit && gain > 0.0)
      {
        factor.Values[lane] = kinetic > gain ? std::sqrt(1.0 - gain / kinetic) : 0.0;
      }
      isTaken.Values[lane] = 1.0;
      done += size;
      const bool isEasy =
        turned <= 0.4 * LongestTurn && correction <= 0.1 * LargeCorrection && gain <= 0.1 * EnergyError * kinetic;
      size = isEasy && done % (2 * size) == 0 && done < PartsOfStep ? 2 * size : size;
    }
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      LinkDynamics& link = this->Links[i];
      link.Start.Shape = Choice(isTaken, link.End.Shape, link.Start.Shape);
      link.Start.Rate = Choice(isTaken, factor * link.End.Rate, link.Start.Rate);
      link.StartPose.Foot = Choice(isTaken, link.EndPose.Foot, link.StartPose.Foot);
      link.StartPose.Axis = Choice(isTaken, link.EndPose.Axis, link.StartPose.Axis);
      link.StartPose.Velocity = Choice(isTaken, factor * link.EndPose.Velocity, link.StartPose.Velocity);
      link.StartPose.Spin = Choice(isTaken, factor * link.EndPose.Spin, link.StartPose.Spin);
      link.StartPose.Turn = Choice(isTaken, link.EndPose.Turn, link.StartPose.Turn);
    }
    const Lanes kinetic = factor * factor * this->EndKinetic;
    this->Energy = WhereLess(Lanes(0.5), isTaken, this->EndEnergy - this->EndKinetic + kinetic, this->Energy);
    this->Kinetic = WhereLess(Lanes(0.5), isTaken, kinetic, this->Kinetic);
  }
};

}

//----------------------------------------------------------------------------
LITTORAL_SIMD_CLONES void SeaweedMotion::Step(
  double step, const SeaweedBunch& bunch, const WaterAtLink* water, LinkState* states, LinkPose* poses) const
{
  static thread_local std::vector<LinkDynamics> kept;
  kept.resize(std::max(kept.size(), bunch.Links));
  LinkDynamics* links = kept.data();
  LaneIndices at = bunch.First;
  for (std::size_t i = 0; i < bunch.Links; ++i)
  {
    links[i].Start.Shape = GatherVector(states, at, &LinkState::Shape);
    links[i].Start.Rate = GatherVector(states, at, &LinkState::Rate);
    links[i].StartPose.Turn = GatherTurn(poses, at, &LinkPose::Turn);
    links[i].StartPose.Foot = GatherVector(poses, at, &LinkPose::Foot);
    links[i].StartPose.Axis = GatherVector(poses, at, &LinkPose::Axis);
    links[i].StartPose.Velocity = GatherVector(poses, at, &LinkPose::Velocity);
    links[i].StartPose.Spin = GatherVector(poses, at, &LinkPose::Spin);
    for (std::size_t& one : at)
    {
      ++one;
    }
  }
  BunchMarch march(this->Options, step, bunch.Links, links, &this->Bodies->Bodies[bunch.Bodies],
    &this->Bodies->Parents[bunch.Bodies], water);
  march.Run();
  for (std::size_t i = 0; i < bunch.Links; ++i)
  {
    for (int lane = 0; lane < bunch.Trees; ++lane)
    {
      LinkState& state = states[bunch.First[lane] + i];
      LinkPose& pose = poses[bunch.First[lane] + i];
      state.Shape = LaneOf(links[i].Start.Shape, lane);
      state.Rate = LaneOf(links[i].Start.Rate, lane);
      pose.Turn = LaneOf(links[i].StartPose.Turn, lane);
      pose.Foot = LaneOf(links[i].StartPose.Foot, lane);
      pose.Axis = LaneOf(links[i].StartPose.Axis, lane);
      pose.Velocity = LaneOf(links[i].StartPose.Velocity, lane);
      pose.Spin = LaneOf(links[i].StartPose.Spin, lane);
    }
  }
}

}
