// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSeaweedJoint_h
#define LittoralSeaweedJoint_h

#include "Constants.h"
#include "Lanes.h"
#include "SeaweedPlant.h"
#include "Skinning.h"

#include <glm/gtc/quaternion.hpp>

namespace littoral
{

// What a segment is at a moment: of one, or of several side by side (Lanes.h).

/// The water at the middle of a segment.
template <typename Real>
struct WaterOf
{
  using Vector = glm::vec<3, Real>;
  Vector Velocity{ Real(0.0) };     ///< of waves and current [m/s]
  Vector Acceleration{ Real(0.0) }; ///< of the waves [m/s2]
  Vector Displacement{ Real(0.0) }; ///< by the waves [m]; of Direct loads in procedural motion only
};

/// The state of a joint: its shape and how fast it changes.
template <typename Real>
struct LinkStateOf
{
  using Vector = glm::vec<3, Real>;
  Vector Shape{ Real(0.0), Real(0.0), Real(1.0) }; ///< Bending: the segment's direction, as if its parent were at rest;
                                                   ///< else theta, phi
  Vector Rate{ Real(0.0) }; ///< Bending: of turning against the parent, in the same frame; else of the angles
};

/// Where a link is and how it moves.
template <typename Real>
struct LinkPoseOf
{
  using Vector = glm::vec<3, Real>;
  glm::qua<Real> Turn{ Real(1.0), Real(0.0), Real(0.0), Real(0.0) }; ///< from rest
  Vector Foot{ Real(0.0) };                                          ///< [m]
  Vector Axis{ Real(0.0), Real(0.0), Real(1.0) };
  Vector Velocity{ Real(0.0) }; ///< of the foot [m/s]
  Vector Spin{ Real(0.0) };     ///< [rad/s]
};

using WaterAtLink = WaterOf<double>;
using LinkState = LinkStateOf<double>;
using LinkPose = LinkPoseOf<double>;

/// The bed pushes up what lies below the holdfast: by so much for its depth [1/s2], and at most [m/s2].
constexpr double BedStiffness = 200.0;
constexpr double BedPush = 6.0;

/// Rotates a vector; cheaper than two quaternion products.
template <typename Real>
LITTORAL_INLINE glm::vec<3, Real> Rotated(const glm::qua<Real>& rotation, const glm::vec<3, Real>& vector)
{
  return vector + TurnedBy(rotation, vector);
}

template <typename Real>
LITTORAL_INLINE glm::qua<Real> Opposite(const glm::qua<Real>& q)
{
  return { q.w, -q.x, -q.y, -q.z };
}

template <typename Real>
LITTORAL_INLINE glm::qua<Real> NoTurn()
{
  return { Real(1.0), Real(0.0), Real(0.0), Real(0.0) };
}

/// The base of the ground: X = x, Y = up, Z = -y.
template <typename Real>
LITTORAL_INLINE glm::qua<Real> GroundBase()
{
  const Real half(0.70710678118654757);
  return { half, half, Real(0.0), Real(0.0) };
}

/// The paper's turn from a parent's base to that of a segment: theta about Y, then phi about X.
template <typename Real>
LITTORAL_INLINE glm::qua<Real> BaseTurn(const Real& theta, const Real& phi)
{
  const Real half(0.5);
  const glm::qua<Real> azimuth{ Cosine(half * theta), Real(0.0), Sine(half * theta), Real(0.0) };
  const glm::qua<Real> tilt{ Cosine(half * phi), Sine(half * phi), Real(0.0), Real(0.0) };
  return azimuth * tilt;
}

/// The rotation from one unit vector to another; about `aside`, at a right angle to the first, to its opposite.
template <typename Real>
LITTORAL_INLINE glm::qua<Real> TurnTo(
  const glm::vec<3, Real>& from, const glm::vec<3, Real>& to, const glm::vec<3, Real>& aside)
{
  // (1 + a.b, a x b) is the rotation but for its length.
  const Real real = Real(1.0) + glm::dot(from, to);
  const Real isOpposite = WhereLess(real, Real(1e-12), Real(1.0), Real(0.0));
  const glm::vec<3, Real> axis = glm::cross(from, to) + isOpposite * aside;
  const Real size = SquareRoot(real * real + glm::dot(axis, axis));
  const Real factor = Real(1.0) / size;
  return { real / size, factor * axis.x, factor * axis.y, factor * axis.z };
}

/// The rotation vector that takes one unit vector to another [rad]; along `aside` to its opposite.
template <typename Real>
LITTORAL_INLINE glm::vec<3, Real> BendTo(
  const glm::vec<3, Real>& from, const glm::vec<3, Real>& to, const glm::vec<3, Real>& aside)
{
  const glm::vec<3, Real> axis = glm::cross(from, to);
  const Real sine = LengthOf(axis);
  const Real cosine = glm::dot(from, to);
  const Real tiny(1e-9);
  const Real ratio = WhereLess(sine, tiny, Real(1.0), AngleOf(sine, cosine) / Larger(sine, tiny));
  const Real isOpposite = WhereLess(sine, tiny, WhereLess(cosine, Real(0.0), Real(1.0), Real(0.0)), Real(0.0));
  return ratio * axis + isOpposite * Real(Pi) * aside;
}

/// 1 + cos of the angle between directions; not nearer to 0 than at 162 degrees, where twists would grow beyond bounds.
template <typename Real>
LITTORAL_INLINE Real OpeningOf(const glm::vec<3, Real>& from, const glm::vec<3, Real>& to)
{
  return Larger(Real(1.0) + glm::dot(from, to), Real(0.05));
}

/// How fast the shortest turn from one direction to another turns about the latter as this swings at a rate [rad/s].
template <typename Real>
LITTORAL_INLINE glm::vec<3, Real> TwistOf(
  const glm::vec<3, Real>& from, const glm::vec<3, Real>& to, const glm::vec<3, Real>& rate)
{
  return -(glm::dot(rate, from) / OpeningOf(from, to)) * to;
}

/// The pose of a link by that of its parent; null: it stands on the ground.
template <typename Real>
LITTORAL_INLINE void PoseLink(SeaweedJoint joint, const LinkBody<Real>& link, const LinkStateOf<Real>& state,
  const LinkBody<Real>* parentLink, const LinkPoseOf<Real>* parent, LinkPoseOf<Real>& pose)
{
  using Vector = glm::vec<3, Real>;
  glm::qua<Real> below = NoTurn<Real>();
  pose.Foot = link.Foot;
  pose.Velocity = Vector(Real(0.0));
  pose.Spin = Vector(Real(0.0));
  if (parent)
  {
    below = parent->Turn;
    // At rest the foot is where it was, to the last bit.
    pose.Foot = link.Foot + (parent->Foot - parentLink->Foot) + TurnedBy(below, link.Arm);
    pose.Spin = parent->Spin;
    pose.Velocity = parent->Velocity + glm::cross(parent->Spin, pose.Foot - parent->Foot);
  }
  if (joint == SeaweedJoint::Bending)
  {
    pose.Turn = below * TurnTo(link.Axis, state.Shape, link.Side);
    pose.Axis = Rotated(below, state.Shape);
    pose.Spin += Rotated(below, state.Rate + TwistOf(link.Axis, state.Shape, state.Rate));
    return;
  }
  const glm::qua<Real> base = parent ? parentLink->Base : GroundBase<Real>();
  // At rest the turn is none, to the last bit.
  const Real bent = Magnitude(state.Shape.x - link.Theta) + Magnitude(state.Shape.y - link.Phi);
  const glm::qua<Real> turn = base * BaseTurn(state.Shape.x, state.Shape.y) * Opposite(link.Base);
  const Real none(0.0);
  pose.Turn = below *
    glm::qua<Real>(WhereLess(none, bent, turn.w, Real(1.0)), WhereLess(none, bent, turn.x, none),
      WhereLess(none, bent, turn.y, none), WhereLess(none, bent, turn.z, none));
  pose.Axis = Rotated(pose.Turn, link.Axis);
  const glm::qua<Real> frame = below * base;
  const Vector y = Rotated(frame, Vector(Real(0.0), Real(1.0), Real(0.0)));
  const Vector x = Rotated(frame, Vector(Cosine(state.Shape.x), Real(0.0), -Sine(state.Shape.x)));
  pose.Spin += state.Rate.x * y + state.Rate.y * x;
}

/// The force on a link [N], at its middle, and how much it falls per m/s of the link [N s/m].
template <typename Real>
LITTORAL_INLINE glm::vec<3, Real> ForceOn(const SeaweedOptions& options, const LinkBody<Real>& link,
  const LinkPoseOf<Real>& pose, const WaterOf<Real>& water, Real& resistance)
{
  using Vector = glm::vec<3, Real>;
  const Real none(0.0);
  const Real one(1.0);
  resistance = none;
  if (options.Load == SeaweedLoad::Direct)
  {
    return Real(options.ForceFactor) * link.Length * (water.Acceleration + water.Displacement + water.Velocity);
  }
  const Vector half = Real(0.5) * link.Length * pose.Axis;
  const Vector relative = water.Velocity - pose.Velocity - glm::cross(pose.Spin, half);
  const Vector along = glm::dot(relative, pose.Axis) * pose.Axis;
  const Vector across = relative - along;
  const Real drag = Real(0.5 * options.WaterDensity * options.DragCoefficient) * link.Frontage * LengthOf(across);
  const Real friction = Real(0.5 * options.WaterDensity * options.FrictionCoefficient) * link.Surface * LengthOf(along);
  resistance = drag;
  // A segment that comes out of the water loses its lift.
  const Real top = pose.Foot.z + Real(2.0) * half.z;
  const Real low = Smaller(top, pose.Foot.z);
  const Real reach = Larger(Magnitude(Real(2.0) * half.z), Real(0.1) * link.Length);
  const Real wet = Between((Real(options.SeaLevel) - low) / reach, none, one);
  const Real lift = wet * link.Buoyancy - (one - wet) * link.Weight;
  const Real depth = link.Bed - pose.Foot.z - half.z;
  const Real push = link.Mass * Between(Real(BedStiffness) * depth, none, Real(BedPush));
  return wet * (drag * across + friction * along + link.WaterMass * water.Acceleration) +
    Vector(none, none, push + lift);
}

}

#endif
