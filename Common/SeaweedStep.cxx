// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SeaweedMotion.h"

#include <glm/mat3x3.hpp>

#include <algorithm>
#include <vector>

// A step of the equations of motion, for trees side by side.

namespace littoral
{

namespace
{

using Vector = glm::vec<3, Lanes>;
using Matrix = glm::mat<3, 3, Lanes>;
using Turn = glm::qua<Lanes>;

/// No joint turns further in a step [rad], whatever drives it; so that what blows up stays finite.
constexpr double MostTurn = 0.8;
/// A blade does not fold flat: a joint bent further [rad] is pushed back as by a critically damped spring of this
/// frequency [rad/s] with all that grows on it.
constexpr double MostBend = 1.75;
constexpr double StopFrequency = 20.0;

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

/// What is known of a link during a step. Unknown are the changes of velocity and spin; the quadratic form in them is
/// [VV VW; VW^T WW], of the link with all that grows on it.
struct Work
{
  LinkStateOf<Lanes> State;
  LinkPoseOf<Lanes> Pose;
  Turn Below;        // of the parent
  Vector Arm;        // from the parent's foot, now
  Vector BiasLinear; // acceleration of the foot when no joint accelerates
  Vector BiasAngular;
  Vector B[2];     // axes of the joint, at right angles to the link
  Vector S[2];     // how it turns about them, with the twist that goes with it
  Vector Swerve;   // acceleration of the twist when the joint does not accelerate
  Lanes Rate[2];   // along them
  Lanes Spring[2]; // deflection along them
  Lanes Folded;    // by how much it is bent too far, as part of the deflection
  Symmetric VV;
  Matrix VW;
  Symmetric WW;
  Vector ImpulseV;
  Vector ImpulseW;
  Vector Force;  // of the water on all from here on
  Lanes Tension; // arm times pull: what straightens the link
  Vector U[2];
  Vector G[2];
  Lanes Inverse[3]; // of the joint's own matrix
  Lanes Drive[2];
};

/// A step of a bunch.
class BunchStep
{
public:
  BunchStep(const SeaweedOptions& options, double step)
    : Options(options)
    , Step(step)
    , Middle(options.Integrator == SeaweedIntegrator::ExplicitEuler ? 0.0 : 0.5)
  {
  }

  /// Axes, deflections, biases and the link's own part of matrix and impulses.
  LITTORAL_INLINE void Begin(const LinkBody<Lanes>& link, const WaterOf<Lanes>& water,
    const LinkBody<Lanes>* parentLink, const Work* parent, Work& work) const
  {
    const LinkPoseOf<Lanes>& pose = work.Pose;
    work.Below = parent ? parent->Pose.Turn : NoTurn<Lanes>();
    const Vector relative = this->FindAxes(link, parentLink, work);
    work.Arm = Vector(Lanes(0.0));
    work.BiasLinear = work.Arm;
    work.BiasAngular = work.Arm;
    if (parent)
    {
      const Vector& spin = parent->Pose.Spin;
      work.Arm = pose.Foot - parent->Pose.Foot;
      work.BiasAngular = parent->BiasAngular + glm::cross(spin, relative) + work.Swerve;
      work.BiasLinear =
        parent->BiasLinear + glm::cross(parent->BiasAngular, work.Arm) + glm::cross(spin, glm::cross(spin, work.Arm));
    }
    const Vector& e = pose.Axis;
    const Lanes half = Lanes(0.5) * link.Length;
    Lanes resistance;
    work.Force = ForceOn<Lanes>(this->Options, link, pose, water, resistance);
    work.Tension = half * glm::dot(e, work.Force);
    // Drag falls with the change of velocity: as if mass stood at the middle.
    const Lanes lag = Lanes(2.0 * this->Middle * this->Step) * resistance;
    const Lanes mass = link.Mass + lag;
    const Lanes moment = half * mass;
    const Lanes swinging = link.Mass * link.Length * link.Length * Lanes(1.0 / 3.0);
    const Lanes inertia = swinging + lag * half * half;
    work.VV = Symmetric(mass);
    const Lanes none(0.0);
    const Vector m = moment * e; // VW is -[m]
    work.VW = Matrix(Vector(none, -m.z, m.y), Vector(m.z, none, -m.x), Vector(-m.y, m.x, none));
    work.WW = Symmetric(inertia);
    work.WW.AddSquare(link.AxialInertia - inertia, e);
    const Vector centre = half * e;
    Vector swing = work.BiasLinear;
    if (this->Options.Load == SeaweedLoad::Morison)
    {
      // The paper has no centrifugal terms; without drag they would drive limp plants wild.
      swing += glm::cross(pose.Spin, glm::cross(pose.Spin, centre));
    }
    const Lanes step(this->Step);
    work.ImpulseV = step * (work.Force - link.Mass * (swing + glm::cross(work.BiasAngular, centre)));
    const Vector across = work.BiasAngular - glm::dot(work.BiasAngular, e) * e;
    work.ImpulseW = step * (glm::cross(centre, work.Force - link.Mass * swing) - swinging * across);
  }

  /// The joint itself: its matrix and what drives it, all that grows on the link being known.
  LITTORAL_INLINE void Close(const LinkBody<Lanes>& link, Work& work) const
  {
    const Vector& e = work.Pose.Axis;
    const Lanes step(this->Step);
    const Lanes half(this->Step * this->Middle);
    // Tension straightens a link, as seen at the middle of the step.
    const Lanes tension = Larger(work.Tension, Lanes(0.0));
    const Lanes straightens = half * half * tension;
    work.WW.AddDiagonal(straightens);
    work.WW.AddSquare(-straightens, e);
    const Vector& spin = work.Pose.Spin;
    work.ImpulseW -= step * half * tension * (spin - glm::dot(spin, e) * e);
    const Lanes inertia = Lanes(0.5) * (work.WW.xx + work.WW.yy + work.WW.zz);
    const Lanes stop = WhereLess(Lanes(0.0), work.Folded, Lanes(StopFrequency) * inertia, Lanes(0.0));
    const Lanes stiffness = link.Stiffness + Lanes(StopFrequency) * stop;
    const Lanes damping = link.Damping + Lanes(2.0) * stop;
    const Lanes bent = link.Stiffness + Lanes(StopFrequency) * stop * work.Folded;
    const Lanes soft = half * (half * stiffness + damping);
    for (int k = 0; k < 2; ++k)
    {
      work.G[k] = work.WW * work.S[k];
      work.U[k] = work.VW * work.S[k];
      work.Drive[k] = glm::dot(work.S[k], work.ImpulseW) -
        step * (bent * work.Spring[k] + (half * stiffness + damping) * work.Rate[k]);
    }
    const Lanes n00 = glm::dot(work.S[0], work.G[0]) + soft;
    const Lanes n01 = glm::dot(work.S[0], work.G[1]);
    const Lanes n11 = glm::dot(work.S[1], work.G[1]) + soft;
    const Lanes scale = Lanes(1.0) / (n00 * n11 - n01 * n01);
    work.Inverse[0] = scale * n11;
    work.Inverse[1] = -scale * n01;
    work.Inverse[2] = scale * n00;
  }

  /// What the parent feels of a link and of all that grows on it.
  LITTORAL_INLINE void HandDown(Work& work, Work& parent) const
  {
    Vector uN[2];
    Vector gN[2];
    for (int k = 0; k < 2; ++k)
    {
      uN[k] = work.Inverse[k] * work.U[0] + work.Inverse[k + 1] * work.U[1];
      gN[k] = work.Inverse[k] * work.G[0] + work.Inverse[k + 1] * work.G[1];
    }
    work.VV.Subtract(uN[0], work.U[0], uN[1], work.U[1]);
    work.WW.Subtract(gN[0], work.G[0], gN[1], work.G[1]);
    Matrix vw = work.VW;
    for (int column = 0; column < 3; ++column)
    {
      vw[column] -= uN[0] * work.G[0][column] + uN[1] * work.G[1][column];
    }
    const Vector impulseV = work.ImpulseV - uN[0] * work.Drive[0] - uN[1] * work.Drive[1];
    const Vector impulseW = work.ImpulseW - gN[0] * work.Drive[0] - gN[1] * work.Drive[1];
    const Matrix shifted = vw - TimesCross(work.VV, work.Arm);
    const Matrix a = CrossTimes(work.Arm, shifted);
    const Matrix b = CrossTimes(work.Arm, vw);
    parent.VV += work.VV;
    parent.VW += shifted;
    parent.WW += work.WW;
    parent.WW.xx += a[0].x + b[0].x;
    parent.WW.xy += a[1].x + b[0].y;
    parent.WW.xz += a[2].x + b[0].z;
    parent.WW.yy += a[1].y + b[1].y;
    parent.WW.yz += a[2].y + b[1].z;
    parent.WW.zz += a[2].z + b[2].z;
    parent.ImpulseV += impulseV;
    parent.ImpulseW += impulseW + glm::cross(work.Arm, impulseV);
    parent.Force += work.Force;
    parent.Tension += glm::dot(work.Arm, work.Force);
  }

  /// The new state of a link and its pose, those of its parent being known.
  LITTORAL_INLINE void Finish(
    const LinkBody<Lanes>& link, const LinkBody<Lanes>* parentLink, const Work* parent, Work& work) const
  {
    Vector dv(Lanes(0.0));
    Vector dw(Lanes(0.0));
    if (parent)
    {
      // The impulses of a parent are not needed any more; they hold its changes now.
      dw = parent->ImpulseW;
      dv = parent->ImpulseV + glm::cross(dw, work.Arm);
    }
    Lanes drive[2];
    for (int k = 0; k < 2; ++k)
    {
      drive[k] = work.Drive[k] - glm::dot(work.G[k], dw) - glm::dot(work.U[k], dv);
    }
    Lanes moved[2];
    for (int k = 0; k < 2; ++k)
    {
      const Lanes change = work.Inverse[k] * drive[0] + work.Inverse[k + 1] * drive[1];
      dw += change * work.S[k];
      moved[k] = Lanes(this->Step) * (work.Rate[k] + Lanes(this->Middle) * change);
      work.Rate[k] += change;
    }
    work.ImpulseV = dv;
    work.ImpulseW = dw;
    this->Move(moved, work);
    PoseLink<Lanes>(this->Options.Joint, link, work.State, parentLink, parent ? &parent->Pose : nullptr, work.Pose);
  }

private:
  const SeaweedOptions& Options;
  double Step;
  double Middle; // where in the step springs are taken

  /// Axes of the joint, with deflection and rate along them. Gives the rate of turning against the parent.
  LITTORAL_INLINE Vector FindAxes(const LinkBody<Lanes>& link, const LinkBody<Lanes>* parentLink, Work& work) const
  {
    const LinkStateOf<Lanes>& state = work.State;
    if (this->Options.Joint == SeaweedJoint::Bending)
    {
      work.B[0] = Rotated(work.Pose.Turn, link.Side);
      work.B[1] = glm::cross(work.Pose.Axis, work.B[0]);
      const Vector relative = Rotated(work.Below, state.Rate);
      const Vector a = Rotated(work.Below, link.Axis);
      const Vector& e = work.Pose.Axis;
      for (int k = 0; k < 2; ++k)
      {
        work.S[k] = work.B[k] + TwistOf(a, e, work.B[k]);
      }
      const Lanes open = OpeningOf(a, e);
      const Lanes part = glm::dot(relative, a) / open;
      const Vector swing = glm::cross(relative, e);
      work.Swerve = (part * glm::dot(swing, a) / open) * e - part * swing;
      const Vector bend = Rotated(work.Below, BendTo(link.Axis, state.Shape, link.Side));
      for (int k = 0; k < 2; ++k)
      {
        work.Rate[k] = glm::dot(relative, work.B[k]);
        work.Spring[k] = glm::dot(bend, work.B[k]);
      }
      const Lanes angle = LengthOf(bend);
      const Lanes beyond = Larger(Lanes(0.0), angle - Lanes(MostBend)) / Larger(angle, Lanes(MostBend));
      work.Folded = this->Options.Integrator == SeaweedIntegrator::Implicit ? beyond : Lanes(0.0); // the paper has none
      return relative + TwistOf(a, e, relative);
    }
    work.Folded = Lanes(0.0);
    work.Swerve = Vector(Lanes(0.0));
    const Turn frame = parentLink ? work.Below * parentLink->Base : GroundBase<Lanes>();
    work.S[0] = Rotated(frame, Vector(Lanes(0.0), Lanes(1.0), Lanes(0.0)));
    work.S[1] = Rotated(frame, Vector(Cosine(state.Shape.x), Lanes(0.0), -Sine(state.Shape.x)));
    work.Rate[0] = state.Rate.x;
    work.Rate[1] = state.Rate.y;
    work.Spring[0] = state.Shape.x - link.Theta;
    work.Spring[1] = state.Shape.y - link.Phi;
    return work.Rate[0] * work.S[0] + work.Rate[1] * work.S[1];
  }

  /// The state after its joint has moved along its axes [rad].
  LITTORAL_INLINE void Move(Lanes moved[2], Work& work) const
  {
    const Lanes speed = SquareRoot(work.Rate[0] * work.Rate[0] + work.Rate[1] * work.Rate[1]);
    const Lanes turn = Larger(SquareRoot(moved[0] * moved[0] + moved[1] * moved[1]), Lanes(this->Step) * speed);
    const Lanes factor = WhereLess(Lanes(MostTurn), turn, Lanes(MostTurn) / Larger(turn, Lanes(1e-300)), Lanes(1.0));
    for (int k = 0; k < 2; ++k)
    {
      moved[k] *= factor;
      work.Rate[k] *= factor;
    }
    LinkStateOf<Lanes>& state = work.State;
    if (this->Options.Joint == SeaweedJoint::Tilting)
    {
      state.Shape += Vector(moved[0], moved[1], Lanes(0.0));
      state.Rate = Vector(work.Rate[0], work.Rate[1], Lanes(0.0));
      return;
    }
    const Turn back = Opposite(work.Below);
    state.Shape = Swung(state.Shape, Rotated(back, moved[0] * work.B[0] + moved[1] * work.B[1]));
    const Vector rate = Rotated(back, work.Rate[0] * work.B[0] + work.Rate[1] * work.B[1]);
    state.Rate = rate - glm::dot(rate, state.Shape) * state.Shape;
  }
};

LITTORAL_INLINE void Load(const LaneIndices& at, const LinkState* states, const LinkPose* poses, Work& work)
{
  work.State.Shape = GatherVector(states, at, &LinkState::Shape);
  work.State.Rate = GatherVector(states, at, &LinkState::Rate);
  work.Pose.Turn = GatherTurn(poses, at, &LinkPose::Turn);
  work.Pose.Foot = GatherVector(poses, at, &LinkPose::Foot);
  work.Pose.Axis = GatherVector(poses, at, &LinkPose::Axis);
  work.Pose.Velocity = GatherVector(poses, at, &LinkPose::Velocity);
  work.Pose.Spin = GatherVector(poses, at, &LinkPose::Spin);
}

LITTORAL_INLINE void Store(const Work& work, int lane, LinkState& state, LinkPose& pose)
{
  state.Shape = LaneOf(work.State.Shape, lane);
  state.Rate = LaneOf(work.State.Rate, lane);
  pose.Turn = LaneOf(work.Pose.Turn, lane);
  pose.Foot = LaneOf(work.Pose.Foot, lane);
  pose.Axis = LaneOf(work.Pose.Axis, lane);
  pose.Velocity = LaneOf(work.Pose.Velocity, lane);
  pose.Spin = LaneOf(work.Pose.Spin, lane);
}

LITTORAL_INLINE WaterOf<Lanes> WaterAt(const WaterAtLink* water)
{
  constexpr LaneIndices at{ 0, 1, 2, 3 };
  WaterOf<Lanes> all;
  all.Velocity = GatherVector(water, at, &WaterAtLink::Velocity);
  all.Acceleration = GatherVector(water, at, &WaterAtLink::Acceleration);
  all.Displacement = GatherVector(water, at, &WaterAtLink::Displacement);
  return all;
}

}

//----------------------------------------------------------------------------
LITTORAL_SIMD_CLONES void SeaweedMotion::Step(
  double step, const SeaweedBunch& bunch, const WaterAtLink* water, LinkState* states, LinkPose* poses) const
{
  static thread_local std::vector<Work> kept;
  kept.resize(std::max(kept.size(), bunch.Links));
  Work* works = kept.data();
  const LinkBody<Lanes>* links = &this->Bodies[bunch.Bodies];
  const int* parents = &this->Parents[bunch.Bodies];
  const BunchStep bunchStep(this->Options, step);
  LaneIndices at = bunch.First;
  for (std::size_t i = 0; i < bunch.Links; ++i)
  {
    const bool stands = parents[i] < 0;
    Load(at, states, poses, works[i]);
    bunchStep.Begin(links[i], WaterAt(water + LaneCount * i), stands ? nullptr : &links[parents[i]],
      stands ? nullptr : &works[parents[i]], works[i]);
    for (std::size_t& one : at)
    {
      ++one;
    }
  }
  for (std::size_t i = bunch.Links; i-- > 0;)
  {
    bunchStep.Close(links[i], works[i]);
    if (parents[i] >= 0)
    {
      bunchStep.HandDown(works[i], works[parents[i]]);
    }
  }
  for (std::size_t i = 0; i < bunch.Links; ++i)
  {
    const bool stands = parents[i] < 0;
    bunchStep.Finish(links[i], stands ? nullptr : &links[parents[i]], stands ? nullptr : &works[parents[i]], works[i]);
    for (int lane = 0; lane < bunch.Trees; ++lane)
    {
      Store(works[i], lane, states[bunch.First[lane] + i], poses[bunch.First[lane] + i]);
    }
  }
}

}
