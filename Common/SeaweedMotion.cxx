// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SeaweedMotion.h"

#include "SimdClones.h"

#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#if defined(__GNUC__)
#define LITTORAL_INLINE inline __attribute__((always_inline)) // into each of the versions that SimdClones.h makes
#else
#define LITTORAL_INLINE inline
#endif

namespace littoral
{

namespace
{

/// No joint turns further in a step [rad], whatever drives it; so that what blows up stays finite.
constexpr double MostTurn = 0.8;
/// The bed pushes up what lies below the holdfast: by so much for its depth [1/s2], and at most [m/s2].
constexpr double BedStiffness = 200.0;
constexpr double BedPush = 6.0;

/// Rotates a vector; cheaper than two quaternion products.
LITTORAL_INLINE Vector3 Rotated(const glm::dquat& rotation, const Vector3& vector)
{
  return vector + TurnedBy(rotation, vector);
}

LITTORAL_INLINE glm::dquat Conjugate(const glm::dquat& q)
{
  return { q.w, -q.x, -q.y, -q.z };
}

/// The paper's turn from a parent's base to that of a segment: theta about Y, then phi about X.
glm::dquat BaseTurn(double theta, double phi)
{
  const glm::dquat azimuth{ std::cos(0.5 * theta), 0.0, std::sin(0.5 * theta), 0.0 };
  const glm::dquat tilt{ std::cos(0.5 * phi), std::sin(0.5 * phi), 0.0, 0.0 };
  return azimuth * tilt;
}

/// The base of the ground: X = x, Y = up, Z = -y.
const glm::dquat GroundBase{ std::sqrt(0.5), std::sqrt(0.5), 0.0, 0.0 };

/// The rotation vector that takes one unit vector to another [rad].
LITTORAL_INLINE Vector3 TurnBetween(const Vector3& from, const Vector3& to)
{
  const Vector3 axis = glm::cross(from, to);
  const double sine = glm::length(axis);
  const double cosine = glm::dot(from, to);
  if (sine < 1e-9)
  {
    return cosine > 0.0 ? axis : 3.14159265358979323846 * Perpendicular(from);
  }
  return std::atan2(sine, cosine) / sine * axis;
}

/// A unit vector turned by a rotation vector at a right angle to it.
LITTORAL_INLINE Vector3 Swung(const Vector3& direction, const Vector3& turn)
{
  const double angle = glm::length(turn);
  const double ratio = angle > 1e-8 ? std::sin(angle) / angle : 1.0;
  return glm::normalize(std::cos(angle) * direction + ratio * glm::cross(turn, direction));
}

/// A symmetric matrix of three rows.
struct Symmetric
{
  double xx = 0.0, xy = 0.0, xz = 0.0, yy = 0.0, yz = 0.0, zz = 0.0;

  LITTORAL_INLINE Vector3 operator*(const Vector3& v) const
  {
    return { this->xx * v.x + this->xy * v.y + this->xz * v.z, this->xy * v.x + this->yy * v.y + this->yz * v.z,
      this->xz * v.x + this->yz * v.y + this->zz * v.z };
  }
  LITTORAL_INLINE void AddScaled(double factor, const Symmetric& o)
  {
    this->xx += factor * o.xx;
    this->xy += factor * o.xy;
    this->xz += factor * o.xz;
    this->yy += factor * o.yy;
    this->yz += factor * o.yz;
    this->zz += factor * o.zz;
  }
  LITTORAL_INLINE void AddDiagonal(double d)
  {
    this->xx += d;
    this->yy += d;
    this->zz += d;
  }
  /// Adds f a a^T.
  LITTORAL_INLINE void AddSquare(double f, const Vector3& a)
  {
    const Vector3 b = f * a;
    this->xx += a.x * b.x;
    this->xy += a.x * b.y;
    this->xz += a.x * b.z;
    this->yy += a.y * b.y;
    this->yz += a.y * b.z;
    this->zz += a.z * b.z;
  }
  /// Takes a b^T + c d^T away, a sum that is symmetric.
  LITTORAL_INLINE void Subtract(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
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
LITTORAL_INLINE glm::dmat3 TimesCross(const Symmetric& s, const Vector3& a)
{
  // Columns of [a]: a x e_k.
  return { s * Vector3(0.0, a.z, -a.y), s * Vector3(-a.z, 0.0, a.x), s * Vector3(a.y, -a.x, 0.0) };
}

/// a x each column.
LITTORAL_INLINE glm::dmat3 CrossTimes(const Vector3& a, const glm::dmat3& m)
{
  return { glm::cross(a, m[0]), glm::cross(a, m[1]), glm::cross(a, m[2]) };
}

}

//----------------------------------------------------------------------------
/// What is known of a link during a step. Unknown are the changes of velocity and spin; the quadratic form in them is
/// [VV VW; WV WW], of the link with all that grows on it.
struct SeaweedMotion::Work
{
  Vector3 Arm{ 0.0 };        // from the parent's foot, now
  Vector3 BiasLinear{ 0.0 }; // acceleration of the foot when no joint accelerates
  Vector3 BiasAngular{ 0.0 };
  Vector3 S[2];     // axes of the joint
  double Rate[2];   // along them
  double Spring[2]; // deflection along them
  double Middle;    // where in the step springs are taken
  Symmetric VV;
  glm::dmat3 VW{ 0.0 };
  Symmetric WW;
  Vector3 ImpulseV{ 0.0 };
  Vector3 ImpulseW{ 0.0 };
  Vector3 Force{ 0.0 }; // of the water on all from here on
  double Tension = 0.0; // arm times pull: what straightens the link
  Vector3 U[2];
  Vector3 G[2];
  double Inverse[3]; // of the joint's own matrix
  double Drive[2];
};

//----------------------------------------------------------------------------
SeaweedMotion::SeaweedMotion(std::vector<SeaweedLink> links, const SeaweedOptions& options)
  : Options(options)
  , Links(std::move(links))
{
  for (std::size_t i = 0; i < this->Links.size(); ++i)
  {
    const SeaweedLink& link = this->Links[i];
    if (link.Parent < 0)
    {
      this->Trees.push_back(i);
    }
    this->Arms.push_back(link.Parent < 0 ? Vector3(0.0) : link.Foot - this->Links[link.Parent].Foot);
    const glm::dquat below = link.Parent < 0 ? GroundBase : this->Bases[link.Parent];
    this->Bases.push_back(below * BaseTurn(link.Theta, link.Phi));
  }
  this->Trees.push_back(this->Links.size());
}

//----------------------------------------------------------------------------
LinkState SeaweedMotion::RestOf(std::size_t link) const
{
  const SeaweedLink& one = this->Links[link];
  return this->Options.Joint == SeaweedJoint::Bending ? LinkState{ one.Axis, Vector3(0.0) }
                                                      : LinkState{ { one.Theta, one.Phi, 0.0 }, Vector3(0.0) };
}

std::vector<LinkState> SeaweedMotion::AtRest() const
{
  std::vector<LinkState> states;
  for (std::size_t i = 0; i < this->Links.size(); ++i)
  {
    states.push_back(this->RestOf(i));
  }
  return states;
}

//----------------------------------------------------------------------------
void SeaweedMotion::PoseOne(const LinkState& state, std::size_t index, LinkPose* poses) const
{
  const SeaweedLink& link = this->Links[index];
  LinkPose& pose = poses[index];
  glm::dquat below{ 1.0, 0.0, 0.0, 0.0 };
  pose.Foot = link.Foot;
  pose.Velocity = Vector3(0.0);
  pose.Spin = Vector3(0.0);
  if (link.Parent >= 0)
  {
    const LinkPose& parent = poses[link.Parent];
    below = parent.Turn;
    // At rest the foot is where it was, to the last bit.
    pose.Foot = link.Foot + (parent.Foot - this->Links[link.Parent].Foot) + TurnedBy(below, this->Arms[index]);
    pose.Spin = parent.Spin;
    pose.Velocity = parent.Velocity + glm::cross(parent.Spin, pose.Foot - parent.Foot);
  }
  if (this->Options.Joint == SeaweedJoint::Bending)
  {
    pose.Turn = below * RotationBetween(link.Axis, state.Shape);
    pose.Axis = Rotated(below, state.Shape);
    pose.Spin += Rotated(below, state.Rate);
    return;
  }
  const glm::dquat base = link.Parent < 0 ? GroundBase : this->Bases[link.Parent];
  if (state.Shape.x != link.Theta || state.Shape.y != link.Phi)
  {
    const glm::dquat turned = base * BaseTurn(state.Shape.x, state.Shape.y);
    below = below * turned * Conjugate(this->Bases[index]);
  }
  pose.Turn = below;
  pose.Axis = Rotated(below, link.Axis);
  const glm::dquat frame = link.Parent < 0 ? GroundBase : poses[link.Parent].Turn * base;
  const Vector3 y = Rotated(frame, { 0.0, 1.0, 0.0 });
  const Vector3 x = Rotated(frame, { std::cos(state.Shape.x), 0.0, -std::sin(state.Shape.x) });
  pose.Spin += state.Rate.x * y + state.Rate.y * x;
}

LITTORAL_SIMD_CLONES void SeaweedMotion::Pose(
  const LinkState* states, std::size_t begin, std::size_t end, LinkPose* poses) const
{
  for (std::size_t i = begin; i < end; ++i)
  {
    this->PoseOne(states[i], i, poses);
  }
}

//----------------------------------------------------------------------------
/// The force on a link [N], at its middle, and how much it falls per m/s of the link [N s/m].
Vector3 SeaweedMotion::ForceOn(
  const SeaweedLink& link, const LinkPose& pose, const WaterAtLink& water, double& resistance) const
{
  const SeaweedOptions& options = this->Options;
  resistance = 0.0;
  if (options.Load == SeaweedLoad::Direct)
  {
    return options.ForceFactor * link.Length * (water.Acceleration + water.Displacement + water.Velocity);
  }
  const Vector3 half = 0.5 * link.Length * pose.Axis;
  const Vector3 relative = water.Velocity - pose.Velocity - glm::cross(pose.Spin, half);
  const Vector3 along = glm::dot(relative, pose.Axis) * pose.Axis;
  const Vector3 across = relative - along;
  const double drag = 0.5 * options.WaterDensity * options.DragCoefficient * link.Frontage * glm::length(across);
  const double friction = 0.5 * options.WaterDensity * options.FrictionCoefficient * link.Surface * glm::length(along);
  resistance = drag;
  // A segment that comes out of the water loses its lift.
  const double top = pose.Foot.z + 2.0 * half.z;
  const double low = std::min(top, pose.Foot.z);
  const double reach = std::max(std::abs(2.0 * half.z), 0.1 * link.Length);
  const double wet = std::clamp((options.SeaLevel - low) / reach, 0.0, 1.0);
  const double lift = wet * link.Buoyancy - (1.0 - wet) * link.Weight;
  const double depth = link.Bed - pose.Foot.z - half.z;
  const double push = link.Mass * std::clamp(BedStiffness * depth, 0.0, BedPush);
  return Vector3(0.0, 0.0, push) + wet * (drag * across + friction * along + link.WaterMass * water.Acceleration) +
    Vector3(0.0, 0.0, lift);
}

//----------------------------------------------------------------------------
/// Axes, deflections, biases and the link's own part of matrix and impulses.
LITTORAL_SIMD_CLONES void SeaweedMotion::Begin(double step, const WaterAtLink& water, const LinkPose* poses,
  std::size_t index, Work* works, std::size_t first, const LinkState& state) const
{
  const SeaweedLink& link = this->Links[index];
  const LinkPose& pose = poses[index];
  Work& work = works[index - first];
  // The paper has no centrifugal terms; without drag they would drive limp plants wild.
  const bool spins = this->Options.Load == SeaweedLoad::Morison;
  const bool isExplicit = this->Options.Integrator == SeaweedIntegrator::ExplicitEuler;
  const glm::dquat below = link.Parent < 0 ? glm::dquat{ 1.0, 0.0, 0.0, 0.0 } : poses[link.Parent].Turn;
  Vector3 relative;
  if (this->Options.Joint == SeaweedJoint::Bending)
  {
    work.S[0] = Rotated(pose.Turn, link.Side);
    work.S[1] = glm::cross(pose.Axis, work.S[0]);
    relative = Rotated(below, state.Rate);
    const Vector3 bend = Rotated(below, TurnBetween(link.Axis, state.Shape));
    for (int k = 0; k < 2; ++k)
    {
      work.Rate[k] = glm::dot(relative, work.S[k]);
      work.Spring[k] = glm::dot(bend, work.S[k]);
    }
  }
  else
  {
    const glm::dquat frame = link.Parent < 0 ? GroundBase : below * this->Bases[link.Parent];
    work.S[0] = Rotated(frame, { 0.0, 1.0, 0.0 });
    work.S[1] = Rotated(frame, { std::cos(state.Shape.x), 0.0, -std::sin(state.Shape.x) });
    for (int k = 0; k < 2; ++k)
    {
      work.Rate[k] = state.Rate[k];
    }
    work.Spring[0] = state.Shape.x - link.Theta;
    work.Spring[1] = state.Shape.y - link.Phi;
    relative = work.Rate[0] * work.S[0] + work.Rate[1] * work.S[1];
  }
  work.Middle = isExplicit ? 0.0 : 0.5;
  if (link.Parent >= 0)
  {
    const Work& parent = works[link.Parent - static_cast<int>(first)];
    const Vector3& spin = poses[link.Parent].Spin;
    work.Arm = pose.Foot - poses[link.Parent].Foot;
    work.BiasAngular = parent.BiasAngular + glm::cross(spin, relative);
    work.BiasLinear =
      parent.BiasLinear + glm::cross(parent.BiasAngular, work.Arm) + glm::cross(spin, glm::cross(spin, work.Arm));
  }
  const Vector3& e = pose.Axis;
  const double half = 0.5 * link.Length;
  double resistance = 0.0;
  work.Force = this->ForceOn(link, pose, water, resistance);
  work.Tension = half * glm::dot(e, work.Force);
  // Drag falls with the change of velocity: as if mass stood at the middle.
  const double lag = 4.0 * work.Middle * step * resistance * 0.5;
  const double mass = link.Mass + lag;
  const double moment = half * mass;
  const double inertia = link.Mass * link.Length * link.Length / 3.0 + lag * half * half;
  work.VV.AddDiagonal(mass);
  // -moment [e]
  work.VW = moment * glm::dmat3(0.0, -e.z, e.y, e.z, 0.0, -e.x, -e.y, e.x, 0.0);
  work.WW.AddDiagonal(inertia);
  work.WW.AddSquare(link.AxialInertia - inertia, e);
  const Vector3 centre = half * e;
  const Vector3 swing = work.BiasLinear + (spins ? glm::cross(pose.Spin, glm::cross(pose.Spin, centre)) : Vector3(0.0));
  const Vector3 inertial = link.Mass * (swing + glm::cross(work.BiasAngular, centre));
  work.ImpulseV = step * (work.Force - inertial);
  const Vector3 across = work.BiasAngular - glm::dot(work.BiasAngular, e) * e;
  work.ImpulseW =
    step * (glm::cross(centre, work.Force - link.Mass * swing) - link.Mass * link.Length * link.Length / 3.0 * across);
}

//----------------------------------------------------------------------------
LITTORAL_SIMD_CLONES void SeaweedMotion::Step(double step, const WaterAtLink* water, const LinkPose* poses,
  std::size_t begin, std::size_t end, LinkState* states) const
{
  static thread_local std::vector<Work> kept;
  kept.assign(end - begin, Work());
  Work* works = kept.data();
  for (std::size_t i = begin; i < end; ++i)
  {
    this->Begin(step, water[i - begin], poses, i, works, begin, states[i]);
  }
  for (std::size_t i = end; i-- > begin;)
  {
    const SeaweedLink& link = this->Links[i];
    Work& work = works[i - begin];
    const Vector3& e = poses[i].Axis;
    const double middle = work.Middle;
    // Tension straightens a link, as seen at the middle of the step.
    const double tension = std::max(0.0, work.Tension);
    const double straightens = step * step * middle * middle * tension;
    work.WW.AddDiagonal(straightens);
    work.WW.AddSquare(-straightens, e);
    const Vector3& spin = poses[i].Spin;
    work.ImpulseW -= step * step * middle * tension * (spin - glm::dot(spin, e) * e);
    // The joint itself.
    const double soft = step * middle * (step * middle * link.Stiffness + link.Damping);
    for (int k = 0; k < 2; ++k)
    {
      work.G[k] = work.WW * work.S[k];
      work.U[k] = work.VW * work.S[k];
      work.Drive[k] = glm::dot(work.S[k], work.ImpulseW) -
        step * (link.Stiffness * (work.Spring[k] + middle * step * work.Rate[k]) + link.Damping * work.Rate[k]);
    }
    const double n00 = glm::dot(work.S[0], work.G[0]) + soft;
    const double n01 = glm::dot(work.S[0], work.G[1]);
    const double n11 = glm::dot(work.S[1], work.G[1]) + soft;
    const double scale = 1.0 / (n00 * n11 - n01 * n01);
    work.Inverse[0] = scale * n11;
    work.Inverse[1] = -scale * n01;
    work.Inverse[2] = scale * n00;
    if (link.Parent < 0)
    {
      continue;
    }
    // What the parent feels of it all.
    Work& parent = works[link.Parent - static_cast<int>(begin)];
    Vector3 uN[2];
    Vector3 gN[2];
    for (int k = 0; k < 2; ++k)
    {
      uN[k] = work.Inverse[k] * work.U[0] + work.Inverse[k + 1] * work.U[1];
      gN[k] = work.Inverse[k] * work.G[0] + work.Inverse[k + 1] * work.G[1];
    }
    work.VV.Subtract(uN[0], work.U[0], uN[1], work.U[1]);
    work.WW.Subtract(gN[0], work.G[0], gN[1], work.G[1]);
    glm::dmat3 vw = work.VW;
    for (int column = 0; column < 3; ++column)
    {
      vw[column] -= uN[0] * work.G[0][column] + uN[1] * work.G[1][column];
    }
    const Vector3 impulseV = work.ImpulseV - uN[0] * work.Drive[0] - uN[1] * work.Drive[1];
    const Vector3 impulseW = work.ImpulseW - gN[0] * work.Drive[0] - gN[1] * work.Drive[1];
    const glm::dmat3 shifted = vw - TimesCross(work.VV, work.Arm);
    const glm::dmat3 a = CrossTimes(work.Arm, shifted);
    const glm::dmat3 b = CrossTimes(work.Arm, vw);
    parent.VV.AddScaled(1.0, work.VV);
    parent.VW += shifted;
    parent.WW.AddScaled(1.0, work.WW);
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
  for (std::size_t i = begin; i < end; ++i)
  {
    const SeaweedLink& link = this->Links[i];
    Work& work = works[i - begin];
    Vector3 dv(0.0);
    Vector3 dw(0.0);
    if (link.Parent >= 0)
    {
      const Work& parent = works[link.Parent - static_cast<int>(begin)];
      // The impulses of a parent are not needed any more; they hold its changes now.
      dw = parent.ImpulseW;
      dv = parent.ImpulseV + glm::cross(dw, work.Arm);
    }
    double x[2];
    double drive[2];
    for (int k = 0; k < 2; ++k)
    {
      drive[k] = work.Drive[k] - glm::dot(work.G[k], dw) - glm::dot(work.U[k], dv);
    }
    x[0] = work.Inverse[0] * drive[0] + work.Inverse[1] * drive[1];
    x[1] = work.Inverse[1] * drive[0] + work.Inverse[2] * drive[1];
    work.ImpulseV = dv;
    work.ImpulseW = dw + x[0] * work.S[0] + x[1] * work.S[1];
    double moved[2];
    for (int k = 0; k < 2; ++k)
    {
      moved[k] = step * (work.Rate[k] + work.Middle * x[k]);
      work.Rate[k] += x[k];
    }
    const double speed = std::sqrt(work.Rate[0] * work.Rate[0] + work.Rate[1] * work.Rate[1]);
    const double turn = std::max(std::sqrt(moved[0] * moved[0] + moved[1] * moved[1]), step * speed);
    for (int k = 0; turn > MostTurn && k < 2; ++k)
    {
      moved[k] *= MostTurn / turn;
      work.Rate[k] *= MostTurn / turn;
    }
    LinkState& state = states[i];
    if (this->Options.Joint == SeaweedJoint::Tilting)
    {
      state.Shape += Vector3(moved[0], moved[1], 0.0);
      state.Rate = { work.Rate[0], work.Rate[1], 0.0 };
      continue;
    }
    const glm::dquat back = link.Parent < 0 ? glm::dquat{ 1.0, 0.0, 0.0, 0.0 } : Conjugate(poses[link.Parent].Turn);
    state.Shape = Swung(state.Shape, Rotated(back, moved[0] * work.S[0] + moved[1] * work.S[1]));
    const Vector3 rate = Rotated(back, work.Rate[0] * work.S[0] + work.Rate[1] * work.S[1]);
    state.Rate = rate - glm::dot(rate, state.Shape) * state.Shape;
  }
}

//----------------------------------------------------------------------------
LinkState SeaweedMotion::Procedural(const WaterAtLink& water, std::size_t index, const LinkPose* poses) const
{
  const SeaweedLink& link = this->Links[index];
  const SeaweedOptions& options = this->Options;
  LinkState state = this->RestOf(index);
  LinkPose rest;
  const glm::dquat below = link.Parent < 0 ? glm::dquat{ 1.0, 0.0, 0.0, 0.0 } : poses[link.Parent].Turn;
  rest.Foot = link.Foot;
  rest.Axis = Rotated(below, link.Axis);
  double resistance = 0.0;
  // Buoyancy is part of the equilibrium.
  const Vector3 lift = options.Load == SeaweedLoad::Morison ? Vector3(0.0, 0.0, link.Buoyancy) : Vector3(0.0);
  const Vector3 force = this->ForceOn(link, rest, water, resistance) - lift;
  const Vector3 torque = options.LeverArm * link.Length * glm::cross(rest.Axis, force);
  const double stiffness = std::max(1e-12, link.Stiffness + link.Restoring);
  const double most = options.LargestAngle;
  const auto soft = [&](double angle) { return most > 0.0 ? most * std::tanh(angle / most) : 0.0; };
  if (options.Joint == SeaweedJoint::Tilting)
  {
    const glm::dquat frame = link.Parent < 0 ? GroundBase : below * this->Bases[link.Parent];
    const Vector3 y = Rotated(frame, { 0.0, 1.0, 0.0 });
    const Vector3 x = Rotated(frame, { std::cos(link.Theta), 0.0, -std::sin(link.Theta) });
    state.Shape.x += soft(glm::dot(torque, y) / stiffness);
    state.Shape.y += soft(glm::dot(torque, x) / stiffness);
    return state;
  }
  const Vector3 turn = Rotated(Conjugate(below), torque / stiffness);
  const double angle = glm::length(turn);
  state.Shape = angle > 0.0 ? Swung(link.Axis, soft(angle) / angle * turn) : link.Axis;
  return state;
}

//----------------------------------------------------------------------------
LinkState SeaweedMotion::Mixed(const LinkState& first, const LinkState& second, double share) const
{
  if (share <= 0.0 || share >= 1.0)
  {
    return share <= 0.0 ? first : second;
  }
  LinkState mixed;
  if (this->Options.Joint == SeaweedJoint::Tilting)
  {
    mixed.Shape = (1.0 - share) * first.Shape + share * second.Shape;
    return mixed;
  }
  mixed.Shape = Swung(first.Shape, share * TurnBetween(first.Shape, second.Shape));
  return mixed;
}

}
