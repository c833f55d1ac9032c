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

using Vector = glm::vec<3, SimdDouble4>;
using Matrix = glm::mat<3, 3, SimdDouble4>;
using Turn = glm::qua<SimdDouble4>;

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
  SimdDouble4 xx, xy, xz, yy, yz, zz;

  LITTORAL_INLINE Symmetric(const SimdDouble4& diagonal = 0.0)
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
  LITTORAL_INLINE void AddDiagonal(const SimdDouble4& d)
  {
    this->xx += d;
    this->yy += d;
    this->zz += d;
  }
  /// Adds f a a^T.
  LITTORAL_INLINE void AddSquare(const SimdDouble4& f, const Vector& a)
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
  const SimdDouble4 none(0.0);
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
  const SimdDouble4 square = glm::dot(turn, turn);
  const Vector swung = CosineOfSmall(square) * direction + SineRatioOfSmall(square) * glm::cross(turn, direction);
  return swung / LengthOf(swung);
}

/// What is known of a link during a step. Unknown is the correction of the velocities in the middle of the step; the
/// quadratic form in those of the foot and of the spin is [Linear Mixed; Mixed^T Angular].
struct LinkDynamics
{
  LinkStateOf<SimdDouble4> Start; // of the sub-step
  LinkPoseOf<SimdDouble4> StartPose;
  LinkStateOf<SimdDouble4> End;
  LinkPoseOf<SimdDouble4> EndPose;
  LinkStateOf<SimdDouble4> State; // in its middle, as far as known
  Vector MiddleRate;              // Bending: that of State, tangent to the sphere at Start; Tilting: the same
  LinkPoseOf<SimdDouble4> Pose;   // of State
  LinkFaceOf<SimdDouble4> Face;
  Turn Below;                   // of the parent
  Vector Arm;                   // from the parent's foot, now
  Vector VelocityProductLinear; // change of the foot's velocity in g when joints change as they are known to
  Vector VelocityProductAngular;
  Vector B[2];               // axes of the joint, at right angles to the link
  Vector MotionSubspace[2];  // S: spin by a rate about these axes, twist included
  Vector Swerve;             // dS/dt q': acceleration of the spin when the joint does not accelerate
  SimdDouble4 Rate[2];       // along the axes
  SimdDouble4 Gain[2];       // what of it was gained since the start
  SimdDouble4 Spring[2];     // deflection along the axes
  SimdDouble4 StopTorque;    // of the stop, for a deflection of 1 [N m/rad]
  SimdDouble4 StopStiffness; // [N m/rad]
  Symmetric Linear;          // I^A
  Matrix Mixed;
  Symmetric Angular;
  Vector BiasLinear; // -p^A, as impulses
  Vector BiasAngular;
  Vector Force;                 // of the water on all from here on
  LinkLoadOf<SimdDouble4> Load; // on the link itself
  Vector WorkForce;             // those of the last iteration of a lane
  Vector WorkMoment;
  Vector Spin;
  SimdDouble4 Tension; // arm times pull: what straightens the link
  Vector U[2];         // I^A S, linear
  Vector G[2];         // and angular
  SimdDouble4 InverseJointInertia[3];
  SimdDouble4 JointImpulse[2];
};

/// Lane by lane, one of two.
LITTORAL_INLINE Vector Choice(const SimdDouble4& isFirst, const Vector& first, const Vector& second)
{
  const SimdDouble4 half(0.5);
  return { SelectLess(half, isFirst, first.x, second.x), SelectLess(half, isFirst, first.y, second.y),
    SelectLess(half, isFirst, first.z, second.z) };
}

LITTORAL_INLINE Turn Choice(const SimdDouble4& isFirst, const Turn& first, const Turn& second)
{
  const SimdDouble4 half(0.5);
  return { SelectLess(half, isFirst, first.w, second.w), SelectLess(half, isFirst, first.x, second.x),
    SelectLess(half, isFirst, first.y, second.y), SelectLess(half, isFirst, first.z, second.z) };
}

LITTORAL_INLINE SimdDouble4 Square(const SimdDouble4& x)
{
  return x * x;
}

/// What is tangent to the sphere at one direction, carried to another along the great circle between them.
LITTORAL_INLINE Vector Transported(const Vector& tangent, const Vector& from, const Vector& to)
{
  const SimdDouble4 open = Max(SimdDouble4(1.0) + glm::dot(from, to), SimdDouble4(0.05));
  return tangent - (glm::dot(tangent, to) / open) * (from + to);
}

/// One iteration for the middle of a sub-step of a batch, lanes with their own lengths.
class BatchStep
{
public:
  BatchStep(const SeaweedOptions& options)
    : Options(options)
    , IsImplicit(options.Integrator == SeaweedIntegrator::Implicit)
  {
  }

  SimdDouble4 Half{ 0.0 }; // g: half of the sub-step [s]; explicit Euler: the step

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
  LITTORAL_INLINE void InitializeLink(const LinkBody<SimdDouble4>& body, const WaterOf<SimdDouble4>& water,
    const LinkBody<SimdDouble4>* parentBody, const LinkDynamics* parent, LinkDynamics& link) const
  {
    const SimdDouble4 g = this->Half;
    PoseLink<SimdDouble4>(
      this->Options.Joint, body, link.State, parentBody, parent ? &parent->Pose : nullptr, link.Pose);
    const LinkPoseOf<SimdDouble4>& pose = link.Pose;
    link.Face = FaceOf<SimdDouble4>(body, pose);
    link.Below = parent ? parent->Pose.Turn : NoTurn<SimdDouble4>();
    const Vector relative = this->FindAxes(body, parentBody, link);

    // Velocity products c = g (dS/dt q' + w_p x S q') + S (q' - q0'), and those of the parent on the arm.
    link.Arm = Vector(SimdDouble4(0.0));
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

    link.Load = LoadOn<SimdDouble4>(this->Options, body, pose, link.Face, water);
    link.Force = link.Load.Force;
    link.Tension = glm::dot(pose.Axis, link.Load.Moment);
    // -p = g f - g (v x* I v) - I c
    this->SetBias(body, link);
    // Drag falls with the correction of the velocity: I + g df/dv.
    this->SetInertia(body, this->IsImplicit ? g : SimdDouble4(0.0), link);
  }

  /// The joint itself: its inertia and what drives it, all that grows on the link being known.
  LITTORAL_INLINE void SolveJoint(const LinkBody<SimdDouble4>& body, LinkDynamics& link) const
  {
    const Vector& e = link.Pose.Axis;
    const SimdDouble4 g = this->Half;
    const SimdDouble4 implicit = this->IsImplicit ? g : SimdDouble4(0.0);
    // A pull T along a segment of length l straightens it as a spring l T would: I + g2 T l (1 - e e^T).
    const SimdDouble4 straightens = implicit * implicit * Max(link.Tension, SimdDouble4(0.0));
    link.Angular.AddDiagonal(straightens);
    link.Angular.AddSquare(-straightens, e);
    // U = I^A S
    for (int k = 0; k < 2; ++k)
    {
      link.G[k] = link.Angular * link.MotionSubspace[k];
      link.U[k] = link.Mixed * link.MotionSubspace[k];
    }
    // D = S^T I^A S
    SimdDouble4 n00 = glm::dot(link.MotionSubspace[0], link.G[0]);
    const SimdDouble4 n01 = glm::dot(link.MotionSubspace[0], link.G[1]);
    SimdDouble4 n11 = glm::dot(link.MotionSubspace[1], link.G[1]);
    const SimdDouble4 stiffness = body.Stiffness + link.StopStiffness;
    const SimdDouble4 damping =
      body.Damping + SelectLess(SimdDouble4(0.0), link.StopTorque, body.StopDamping, SimdDouble4(0.0));
    const SimdDouble4 bent = body.Stiffness + link.StopTorque;
    // Springs that the step does not resolve are damped by c = K g s / (1 + s), s = (g2 K / D)^2, on the rate at the
    // end of the step; others are not: c falls with the fifth power of the step.
    const SimdDouble4 stiff = implicit * implicit * body.Stiffness;
    const SimdDouble4 squared[2] = { Square(stiff * n11), Square(stiff * n00) };
    const SimdDouble4 det = Square(n00 * n11 - n01 * n01);
    const SimdDouble4 all = implicit * body.Stiffness;
    const SimdDouble4 filter[2] = { all * squared[0] / (squared[0] + det), all * squared[1] / (squared[1] + det) };
    // u = -S^T p^A - g (K q + d q' + c (2 q' - q0'))
    for (int k = 0; k < 2; ++k)
    {
      link.JointImpulse[k] = glm::dot(link.MotionSubspace[k], link.BiasAngular) -
        g * (bent * link.Spring[k] + damping * link.Rate[k] + filter[k] * (link.Rate[k] + link.Gain[k]));
    }
    // D + g (g K + d + 2 c)
    const SimdDouble4 soft = implicit * (implicit * stiffness + damping);
    n00 += soft + SimdDouble4(2.0) * implicit * filter[0];
    n11 += soft + SimdDouble4(2.0) * implicit * filter[1];
    const SimdDouble4 scale = SimdDouble4(1.0) / (n00 * n11 - n01 * n01);
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
  LITTORAL_INLINE SimdDouble4 IntegrateLink(
    const SimdDouble4& isOpen, const LinkDynamics* parent, LinkDynamics& link) const
  {
    link.WorkForce = Choice(isOpen, link.Load.Force, link.WorkForce);
    link.WorkMoment = Choice(isOpen, link.Load.Moment, link.WorkMoment);
    link.Spin = Choice(isOpen, link.Pose.Spin, link.Spin);
    Vector dv(SimdDouble4(0.0));
    Vector dw(SimdDouble4(0.0));
    if (parent)
    {
      // The biases of a parent are not needed any more; they hold its corrections now.
      dw = parent->BiasAngular;
      dv = parent->BiasLinear + glm::cross(dw, link.Arm);
    }
    // q' += D^-1 (u - U^T a_p)
    SimdDouble4 impulse[2];
    for (int k = 0; k < 2; ++k)
    {
      impulse[k] = link.JointImpulse[k] - glm::dot(link.G[k], dw) - glm::dot(link.U[k], dv);
    }
    SimdDouble4 change[2];
    for (int k = 0; k < 2; ++k)
    {
      change[k] = SelectLess(SimdDouble4(0.5), isOpen,
        link.InverseJointInertia[k] * impulse[0] + link.InverseJointInertia[k + 1] * impulse[1], SimdDouble4(0.0));
      dw += change[k] * link.MotionSubspace[k];
    }
    link.BiasLinear = dv;
    link.BiasAngular = dw;
    this->Correct(change, link);
    return SimdDouble4(2.0) * this->Half * Sqrt(change[0] * change[0] + change[1] * change[1]);
  }

  /// The state at the end of the sub-step, twice the way to its middle, and the pose.
  LITTORAL_INLINE void EndLink(const LinkBody<SimdDouble4>& body, const LinkBody<SimdDouble4>* parentBody,
    const LinkDynamics* parent, LinkDynamics& link) const
  {
    Vector rate = SimdDouble4(2.0) * link.MiddleRate - link.Start.Rate;
    Vector turn = SimdDouble4(2.0) * this->Half * link.MiddleRate;
    if (!this->IsImplicit)
    {
      rate = link.MiddleRate;
      turn = this->Half * link.Start.Rate;
    }
    const SimdDouble4 most = Max(LengthOf(turn), this->Half * LengthOf(rate));
    const SimdDouble4 factor =
      SelectLess(SimdDouble4(MostTurn), most, SimdDouble4(MostTurn) / Max(most, SimdDouble4(1e-300)), SimdDouble4(1.0));
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
    PoseLink<SimdDouble4>(
      this->Options.Joint, body, link.End, parentBody, parent ? &parent->EndPose : nullptr, link.EndPose);
  }

  /// The work of loads on a link in the sub-step, by the ways of their points [J]; so that dead loads have a potential.
  LITTORAL_INLINE SimdDouble4 WorkOf(const LinkDynamics& link) const
  {
    return glm::dot(link.WorkForce, link.EndPose.Foot - link.StartPose.Foot) +
      glm::dot(link.WorkMoment, link.EndPose.Axis - link.StartPose.Axis);
  }

  /// T = 1/2 integral of (m v.v + m_n (v.n)2 + m_b (v.b)2) + J/2 (w.e)2 [J]
  LITTORAL_INLINE SimdDouble4 KineticEnergy(
    const LinkBody<SimdDouble4>& body, const LinkPoseOf<SimdDouble4>& pose) const
  {
    const LinkFaceOf<SimdDouble4> face = FaceOf<SimdDouble4>(body, pose);
    const Vector turning = body.Length * glm::cross(pose.Spin, pose.Axis);
    // The mean over the link of (v + s t)(v + s t): v v + v t + t t / 3.
    const auto mean = [](const SimdDouble4& v, const SimdDouble4& t) {
      return v * (v + t) + SimdDouble4(1.0 / 3.0) * t * t;
    };
    const SimdDouble4 normal = mean(glm::dot(pose.Velocity, face.Normal), glm::dot(turning, face.Normal));
    const SimdDouble4 edge = mean(glm::dot(pose.Velocity, face.Edge), glm::dot(turning, face.Edge));
    const SimdDouble4 along = Square(glm::dot(pose.Velocity, pose.Axis));
    const SimdDouble4 spin = Square(glm::dot(pose.Spin, pose.Axis));
    return SimdDouble4(0.5) *
      ((body.Mass + body.FaceMass) * normal + (body.Mass + body.EdgeMass) * edge + body.Mass * along +
        body.AxialInertia * spin);
  }

  /// V = K/2 q2, and that of the stop [J]
  LITTORAL_INLINE SimdDouble4 SpringEnergy(
    const LinkBody<SimdDouble4>& body, const LinkStateOf<SimdDouble4>& state) const
  {
    if (this->Options.Joint == SeaweedJoint::Tilting)
    {
      return SimdDouble4(0.5) * body.Stiffness *
        (Square(state.Shape.x - body.Theta) + Square(state.Shape.y - body.Phi));
    }
    const SimdDouble4 angle = AngleOf(LengthOf(glm::cross(body.Axis, state.Shape)), glm::dot(body.Axis, state.Shape));
    const SimdDouble4 way = Max(SimdDouble4(0.0), angle - SimdDouble4(MostBend)) * SimdDouble4(1.0 / WayOfStop);
    const SimdDouble4 y = Min(way, SimdDouble4(PartOfStop));
    const SimdDouble4 left = SimdDouble4(1.0) / (SimdDouble4(1.0) - y);
    const SimdDouble4 beyond = way - y;
    const SimdDouble4 stop = SimdDouble4(0.5) * y * y * left +
      SimdDouble4(0.5) * y * (SimdDouble4(2.0) - y) * left * left * beyond +
      SimdDouble4(0.5) * left * left * left * beyond * beyond;
    return SimdDouble4(0.5) * body.Stiffness * angle * angle +
      body.StopStiffness * SimdDouble4(WayOfStop * WayOfStop) * stop;
  }

private:
  const SeaweedOptions& Options;
  bool IsImplicit;

  /// I of the link about its foot, in axes b (width), n (face) and e (axis), with drag times a time.
  LITTORAL_INLINE void SetInertia(const LinkBody<SimdDouble4>& body, const SimdDouble4& time, LinkDynamics& link) const
  {
    const LinkLoadOf<SimdDouble4>& load = link.Load;
    const Vector& b = link.Face.Edge;
    const Vector& n = link.Face.Normal;
    const SimdDouble4 half = SimdDouble4(0.5) * body.Length;
    const SimdDouble4 third = SimdDouble4(1.0 / 3.0) * body.Length * body.Length;
    const SimdDouble4 massB = body.Mass + body.EdgeMass;
    const SimdDouble4 massN = body.Mass + body.FaceMass;
    const SimdDouble4 linearB = massB + time * load.EdgeDrag.Sum;
    const SimdDouble4 linearN = massN + time * load.FaceDrag.Sum;
    const SimdDouble4 linearE = body.Mass + time * load.Friction;
    const SimdDouble4 firstB = half * massB + time * load.EdgeDrag.First;
    const SimdDouble4 firstN = half * massN + time * load.FaceDrag.First;
    const SimdDouble4 secondB = third * massB + time * load.EdgeDrag.Second;
    const SimdDouble4 secondN = third * massN + time * load.FaceDrag.Second;
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
  LITTORAL_INLINE void SetBias(const LinkBody<SimdDouble4>& body, LinkDynamics& link) const
  {
    const SimdDouble4 g = this->Half;
    const Vector& b = link.Face.Edge;
    const Vector& n = link.Face.Normal;
    const Vector& e = link.Pose.Axis;
    const auto inAxes = [&](const Vector& x) { return Vector(glm::dot(x, b), glm::dot(x, n), glm::dot(x, e)); };
    const SimdDouble4 half = SimdDouble4(0.5) * body.Length;
    const SimdDouble4 third = SimdDouble4(1.0 / 3.0) * body.Length * body.Length;
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
    const SimdDouble4 speed = this->Half * LengthOf(link.MiddleRate);
    const SimdDouble4 most(0.5 * MostTurn);
    link.MiddleRate *= SelectLess(most, speed, most / Max(speed, SimdDouble4(1e-300)), SimdDouble4(1.0));
    const Vector turn = this->Half * link.MiddleRate;
    link.State.Rate = link.MiddleRate; // about which the direction turns: the same at both ends
    link.State.Shape =
      this->Options.Joint == SeaweedJoint::Tilting ? link.Start.Shape + turn : Swung(link.Start.Shape, turn);
  }

  /// K_s/2 x2 / (1 - x/X), x: how far the joint is bent beyond MostBend. The paper has none.
  LITTORAL_INLINE void FindStop(const LinkBody<SimdDouble4>& body, const SimdDouble4& angle, LinkDynamics& link) const
  {
    const SimdDouble4 one(1.0);
    const SimdDouble4 strength = this->IsImplicit ? body.StopStiffness : SimdDouble4(0.0);
    const SimdDouble4 way = Max(SimdDouble4(0.0), angle - SimdDouble4(MostBend)) * SimdDouble4(1.0 / WayOfStop);
    const SimdDouble4 y = Min(way, SimdDouble4(PartOfStop));
    const SimdDouble4 left = one / (one - y);
    const SimdDouble4 stiffness = strength * left * left * left;
    const SimdDouble4 torque =
      strength * SimdDouble4(0.5) * y * (SimdDouble4(2.0) - y) * left * left + stiffness * (way - y);
    link.StopTorque = SimdDouble4(WayOfStop) * torque / Max(angle, SimdDouble4(MostBend));
    link.StopStiffness = SelectLess(SimdDouble4(0.0), way, stiffness, SimdDouble4(0.0));
  }

  /// Axes of the joint, with deflection, rate and gain along them. Gives the spin against the parent.
  LITTORAL_INLINE Vector FindAxes(
    const LinkBody<SimdDouble4>& body, const LinkBody<SimdDouble4>* parentBody, LinkDynamics& link) const
  {
    const LinkStateOf<SimdDouble4>& state = link.State;
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
      const SimdDouble4 open = OpeningOf(a, e);
      const SimdDouble4 part = glm::dot(relative, a) / open;
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
    link.StopTorque = SimdDouble4(0.0);
    link.StopStiffness = SimdDouble4(0.0);
    const Turn frame = parentBody ? link.Below * parentBody->Base : GroundBase<SimdDouble4>();
    const Vector y = Rotated(frame, Vector(SimdDouble4(0.0), SimdDouble4(1.0), SimdDouble4(0.0)));
    const Vector x = Rotated(frame, Vector(Cos(state.Shape.x), SimdDouble4(0.0), -Sin(state.Shape.x)));
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
  LITTORAL_INLINE void Correct(const SimdDouble4 change[2], LinkDynamics& link) const
  {
    if (this->Options.Joint == SeaweedJoint::Tilting)
    {
      link.MiddleRate += Vector(change[0], change[1], SimdDouble4(0.0));
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

LITTORAL_INLINE WaterOf<SimdDouble4> WaterAt(const WaterAtLink* water)
{
  constexpr LaneIndices at{ 0, 1, 2, 3 };
  WaterOf<SimdDouble4> all;
  all.Velocity = GatherVector(water, at, &WaterAtLink::Velocity);
  all.Acceleration = GatherVector(water, at, &WaterAtLink::Acceleration);
  all.Displacement = GatherVector(water, at, &WaterAtLink::Displacement);
  return all;
}

/// A batch, and how far its lanes are in a step. A lane has its own sub-steps and iterations: what it does is a
/// function of its own state alone.
class BatchMarch
{
public:
  BatchMarch(const SeaweedOptions& options, double step, std::size_t count, LinkDynamics* links,
    const LinkBody<SimdDouble4>* bodies, const int* parents, const WaterAtLink* water)
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
  BatchStep Rules;
  bool IsImplicit;
  double Step;
  std::size_t Count;
  LinkDynamics* Links;
  const LinkBody<SimdDouble4>* Bodies;
  const int* Parents; // -1: the ground
  const WaterAtLink* Water;
  std::array<int, LaneCount> Done{}; // parts of the step
  std::array<int, LaneCount> Size{}; // parts of the next sub-step
  SimdDouble4 Energy{ 0.0 };         // at the start of the sub-step [J]
  SimdDouble4 Kinetic{ 0.0 };        // the part of it in motion
  SimdDouble4 EndKinetic{ 0.0 };
  SimdDouble4 EndEnergy{ 0.0 };
  SimdDouble4 Gain{ 0.0 };       // of energy beyond what loads give
  SimdDouble4 Correction{ 0.0 }; // of the last iteration, the largest of the links [rad]
  SimdDouble4 Turned{ 0.0 };     // in the sub-step, the largest of the links [rad]

  LITTORAL_INLINE const LinkBody<SimdDouble4>* ParentBody(std::size_t i) const
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
    SimdDouble4 fastest(0.0);
    for (std::size_t i = 0; this->IsImplicit && i < this->Count; ++i)
    {
      const LinkDynamics& link = this->Links[i];
      const SimdDouble4 kinetic = this->Rules.KineticEnergy(this->Bodies[i], link.StartPose);
      this->Kinetic += kinetic;
      this->Energy += kinetic + this->Rules.SpringEnergy(this->Bodies[i], link.Start);
      fastest = Max(fastest, glm::dot(link.StartPose.Spin, link.StartPose.Spin));
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
    SimdDouble4 isOpen(1.0);
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
      SimdDouble4 worst(0.0);
      for (std::size_t i = 0; i < this->Count; ++i)
      {
        worst = Max(worst, this->Rules.IntegrateLink(isOpen, this->ParentOf(i), this->Links[i]));
      }
      this->Correction = SelectLess(SimdDouble4(0.5), isOpen, worst, this->Correction);
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
    this->Turned = SimdDouble4(0.0);
    this->EndKinetic = SimdDouble4(0.0);
    SimdDouble4 springs(0.0);
    SimdDouble4 work(0.0);
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      LinkDynamics& link = this->Links[i];
      this->Rules.EndLink(this->Bodies[i], this->ParentBody(i), this->ParentOf(i), link);
      if (this->IsImplicit)
      {
        this->Turned = Max(this->Turned, glm::dot(link.Spin, link.Spin));
        this->EndKinetic += this->Rules.KineticEnergy(this->Bodies[i], link.EndPose);
        springs += this->Rules.SpringEnergy(this->Bodies[i], link.End);
        work += this->Rules.WorkOf(link);
      }
    }
    this->Turned = SimdDouble4(2.0) * this->Rules.Half * Sqrt(this->Turned);
    this->EndEnergy = this->EndKinetic + springs;
    const SimdDouble4 rounding = SimdDouble4(1e-11) * (this->EndEnergy + Abs(work));
    this->Gain = this->EndEnergy - this->Energy - work - rounding;
  }

  /// Takes the sub-step in lanes where it is good; a shorter one comes next in others.
  LITTORAL_INLINE void Take()
  {
    SimdDouble4 isTaken(0.0);
    SimdDouble4 factor(1.0);
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
    const SimdDouble4 kinetic = factor * factor * this->EndKinetic;
    this->Energy = SelectLess(SimdDouble4(0.5), isTaken, this->EndEnergy - this->EndKinetic + kinetic, this->Energy);
    this->Kinetic = SelectLess(SimdDouble4(0.5), isTaken, kinetic, this->Kinetic);
  }
};

}

//----------------------------------------------------------------------------
LITTORAL_SIMD_CLONES void SeaweedMotion::Step(
  double step, const LinkBatch& batch, const WaterAtLink* water, LinkState* states, LinkPose* poses) const
{
  static thread_local std::vector<LinkDynamics> kept;
  kept.resize(std::max(kept.size(), batch.Links));
  LinkDynamics* links = kept.data();
  LaneIndices at = batch.First;
  for (std::size_t i = 0; i < batch.Links; ++i)
  {
    links[i].Start.Shape = GatherVector(states, at, &LinkState::Shape);
    links[i].Start.Rate = GatherVector(states, at, &LinkState::Rate);
    links[i].StartPose.Turn = GatherRotation(poses, at, &LinkPose::Turn);
    links[i].StartPose.Foot = GatherVector(poses, at, &LinkPose::Foot);
    links[i].StartPose.Axis = GatherVector(poses, at, &LinkPose::Axis);
    links[i].StartPose.Velocity = GatherVector(poses, at, &LinkPose::Velocity);
    links[i].StartPose.Spin = GatherVector(poses, at, &LinkPose::Spin);
    for (std::size_t& one : at)
    {
      ++one;
    }
  }
  BatchMarch march(this->Options, step, batch.Links, links, &this->Bodies->Bodies[batch.Bodies],
    &this->Bodies->Parents[batch.Bodies], water);
  march.Run();
  for (std::size_t i = 0; i < batch.Links; ++i)
  {
    for (int lane = 0; lane < batch.Trees; ++lane)
    {
      LinkState& state = states[batch.First[lane] + i];
      LinkPose& pose = poses[batch.First[lane] + i];
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
