// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSeaweedJoint_h
#define LittoralSeaweedJoint_h

#include "Numerics/Constants.h"
#include "Numerics/SimdDouble4.h"
#include "Plants/Skinning.h"
#include "Seaweed/LinkState.h"
#include "Seaweed/SeaweedMotion.h"
#include "Seaweed/SeaweedPlant.h"

#include <glm/gtc/quaternion.hpp>

#include <cstddef>
#include <variant>
#include <vector>

namespace littoral
{

/// Upward acceleration by the bed of what lies below the holdfast: BedStiffness [1/s2] times its depth, at most
/// BedAcceleration [m/s2].
constexpr double BedStiffness = 200.0;
constexpr double BedAcceleration = 6.0;

/// The base of the ground: X = x, Y = up, Z = -y.
template <typename Real>
LITTORAL_INLINE glm::qua<Real> GroundBase()
{
  const Real half(0.70710678118654757);
  return { half, half, Real(0.0), Real(0.0) };
}

/// Rotation from a parent's base to that of a segment: theta about Y, then phi about X (Coulais et al., figure 7).
template <typename Real>
LITTORAL_INLINE glm::qua<Real> BaseRotation(const Real& theta, const Real& phi)
{
  const Real half(0.5);
  const glm::qua<Real> azimuth{ Cos(half * theta), Real(0.0), Sin(half * theta), Real(0.0) };
  const glm::qua<Real> tilt{ Cos(half * phi), Sin(half * phi), Real(0.0), Real(0.0) };
  return azimuth * tilt;
}

/// Shortest rotation from one unit vector to another; to the opposite one about `aside`, at a right angle to the first.
template <typename Real>
LITTORAL_INLINE glm::qua<Real> ShortestArc(
  const glm::vec<3, Real>& from, const glm::vec<3, Real>& to, const glm::vec<3, Real>& aside)
{
  // (1 + a.b, a x b) is the rotation but for its length.
  const Real real = Real(1.0) + glm::dot(from, to);
  const Real isOpposite = SelectLess(real, Real(1e-12), Real(1.0), Real(0.0));
  const glm::vec<3, Real> axis = glm::cross(from, to) + isOpposite * aside;
  const Real size = Sqrt(real * real + glm::dot(axis, axis));
  const Real factor = Real(1.0) / size;
  return { real / size, factor * axis.x, factor * axis.y, factor * axis.z };
}

/// Rotation vector of ShortestArc [rad].
template <typename Real>
LITTORAL_INLINE glm::vec<3, Real> ArcVector(
  const glm::vec<3, Real>& from, const glm::vec<3, Real>& to, const glm::vec<3, Real>& aside)
{
  const glm::vec<3, Real> axis = glm::cross(from, to);
  const Real sine = Length(axis);
  const Real cosine = glm::dot(from, to);
  const Real tiny(1e-9);
  const Real ratio = SelectLess(sine, tiny, Real(1.0), AngleOf(sine, cosine) / Max(sine, tiny));
  const Real isOpposite = SelectLess(sine, tiny, SelectLess(cosine, Real(0.0), Real(1.0), Real(0.0)), Real(0.0));
  return ratio * axis + isOpposite * Real(Pi) * aside;
}

/// 1 + cos of the angle between directions, at least 0.05 (162 degrees), as twists would grow without bounds.
template <typename Real>
LITTORAL_INLINE Real ArcOpening(const glm::vec<3, Real>& from, const glm::vec<3, Real>& to)
{
  return Max(Real(1.0) + glm::dot(from, to), Real(0.05));
}

/// Twist rate of the shortest arc from a to e about e, as e swings at a rate w: -(w.a) / (1 + a.e) e [rad/s].
template <typename Real>
LITTORAL_INLINE glm::vec<3, Real> ArcTwist(
  const glm::vec<3, Real>& from, const glm::vec<3, Real>& to, const glm::vec<3, Real>& rate)
{
  return -(glm::dot(rate, from) / ArcOpening(from, to)) * to;
}

/// Pose of a link from that of its parent; null: the link stands on the ground.
template <typename Real>
LITTORAL_INLINE void PoseLink(SeaweedJoint joint, const LinkBody<Real>& link, const LinkStateOf<Real>& state,
  const LinkBody<Real>* parentLink, const LinkPoseOf<Real>* parent, LinkPoseOf<Real>& pose)
{
  using Vector = glm::vec<3, Real>;
  glm::qua<Real> below = IdentityRotation<Real>();
  pose.Foot = link.Foot;
  pose.Velocity = Vector(Real(0.0));
  pose.Spin = Vector(Real(0.0));
  if (parent)
  {
    below = parent->Rotation;
    // At rest the foot is where it was, to the last bit.
    pose.Foot = link.Foot + (parent->Foot - parentLink->Foot) + RotationOffset(below, link.Arm);
    pose.Spin = parent->Spin;
    pose.Velocity = parent->Velocity + glm::cross(parent->Spin, pose.Foot - parent->Foot);
  }
  if (joint == SeaweedJoint::Bending)
  {
    pose.Rotation = below * ShortestArc(link.Axis, state.Shape, link.Side);
    pose.Axis = Rotated(below, state.Shape);
    pose.Spin += Rotated(below, state.Rate + ArcTwist(link.Axis, state.Shape, state.Rate));
    return;
  }
  const glm::qua<Real> base = parent ? parentLink->Base : GroundBase<Real>();
  // No turn at rest, to the last bit.
  const Real bent = Abs(state.Shape.x - link.Theta) + Abs(state.Shape.y - link.Phi);
  const glm::qua<Real> turn = base * BaseRotation(state.Shape.x, state.Shape.y) * Conjugate(link.Base);
  const Real none(0.0);
  pose.Rotation = below *
    glm::qua<Real>(SelectLess(none, bent, turn.w, Real(1.0)), SelectLess(none, bent, turn.x, none),
      SelectLess(none, bent, turn.y, none), SelectLess(none, bent, turn.z, none));
  pose.Axis = Rotated(pose.Rotation, link.Axis);
  const glm::qua<Real> frame = below * base;
  const Vector y = Rotated(frame, Vector(Real(0.0), Real(1.0), Real(0.0)));
  const Vector x = Rotated(frame, Vector(Cos(state.Shape.x), Real(0.0), -Sin(state.Shape.x)));
  pose.Spin += state.Rate.x * y + state.Rate.y * x;
}

/// Axes across a link, now: b along its width (Edge) and n normal to its face; b, n and its axis e are right-handed.
template <typename Real>
struct LinkFaceOf
{
  using Vector = glm::vec<3, Real>;
  Vector Edge;
  Vector Normal;
};

template <typename Real>
LITTORAL_INLINE LinkFaceOf<Real> FaceOf(const LinkBody<Real>& link, const LinkPoseOf<Real>& pose)
{
  const glm::vec<3, Real> edge = Rotated(pose.Rotation, link.Side);
  return { edge, glm::cross(pose.Axis, edge) };
}

/// A vector in axes b, n, e of a link.
template <typename Real>
LITTORAL_INLINE glm::vec<3, Real> InAxes(
  const LinkFaceOf<Real>& face, const glm::vec<3, Real>& axis, const glm::vec<3, Real>& vector)
{
  return { glm::dot(vector, face.Edge), glm::dot(vector, face.Normal), glm::dot(vector, axis) };
}

/// Force [N] of the added mass on a strip across a link that turns at w and moves at V through the water, beside
/// -m_b (dV/dt.b) b - m_n (dV/dt.n) n; in axes b, n, e. Water in cross flow has the momentum m_b V_c + (m_n - m_b)
/// (V.n) n, V_c = V - (V.e) e, and takes none along the axis:
///   f = -m_b (dV_c/dt)_c - (m_n - m_b) d/dt(V.n) n, hence f_A = m_b (V.e) w x e - (m_n - m_b) (V.w x n) n.
template <typename Real>
LITTORAL_INLINE glm::vec<3, Real> StripForce(
  const LinkBody<Real>& link, const glm::vec<3, Real>& spin, const glm::vec<3, Real>& velocity)
{
  return { link.EdgeMass * velocity.z * spin.y,
    (link.FaceMass - link.EdgeMass) * spin.z * velocity.x - link.FaceMass * velocity.z * spin.x, Real(0.0) };
}

/// Moments of order 0, 1 and 2 about the foot: sums of r, s r and s^2 r over points at distances s.
template <typename Real>
struct MomentsOf
{
  Real Sum{ 0.0 };
  Real First{ 0.0 };
  Real Second{ 0.0 };

  LITTORAL_INLINE void Add(const Real& value, const Real& distance)
  {
    this->Sum += value;
    this->First += distance * value;
    this->Second += distance * distance * value;
  }
};

/// Load of the water on a link, and its resistance R to the motion of the link.
template <typename Real>
struct LinkLoadOf
{
  using Vector = glm::vec<3, Real>;
  Vector Force{ Real(0.0) };   ///< [N]
  Vector Moment{ Real(0.0) };  ///< sum of forces times distances from the foot [N m]; axis x Moment is the torque
  Vector Turning{ Real(0.0) }; ///< what the water's velocity adds to the force of the added mass (StripForce) [N], at
                               ///< the middle; not in Force
  MomentsOf<Real> FaceDrag;    ///< resistance to motion normal to the face [N s/m], [N s], [N s m]
  MomentsOf<Real> EdgeDrag;    ///< resistance to motion along the width
  Real Friction{ 0.0 };        ///< resistance to motion along the axis [N s/m]
};

/// The part of a segment that is in the water, 0 to 1.
template <typename Real>
LITTORAL_INLINE Real SubmergedPart(const SeaweedOptions& options, const LinkBody<Real>& link,
  const LinkPoseOf<Real>& pose, const glm::vec<3, Real>& half)
{
  const Real top = pose.Foot.z + Real(2.0) * half.z;
  const Real low = Min(top, pose.Foot.z);
  const Real reach = Max(Abs(Real(2.0) * half.z), Real(0.1) * link.Length);
  return Clamp((Real(options.SeaLevel) - low) / reach, Real(0.0), Real(1.0));
}

/// Sums over points of a link of forces and of distances from the foot times forces, normal to its face and along its
/// width.
template <typename Real>
struct CrossForcesOf
{
  Real Normal{ 0.0 };
  Real Edge{ 0.0 };
  Real NormalFirst{ 0.0 };
  Real EdgeFirst{ 0.0 };
};

/// Drag F = rho/2 C |r| (A_face (r.n) n + A_edge (r.b) b) at two Gauss points, r: velocity of the water across the
/// segment, against it. Adds the resistance to the load. `slip` is that at the foot, `density` half of the water's.
template <typename Real>
LITTORAL_INLINE CrossForcesOf<Real> AddDrag(const SeaweedOptions& options, const LinkBody<Real>& link,
  const LinkPoseOf<Real>& pose, const LinkFaceOf<Real>& face, const glm::vec<3, Real>& slip, const Real& density,
  LinkLoadOf<Real>& load)
{
  const glm::vec<3, Real> turning = glm::cross(pose.Spin, pose.Axis);
  const Real slipNormal = glm::dot(slip, face.Normal);
  const Real slipEdge = glm::dot(slip, face.Edge);
  const Real turnNormal = glm::dot(turning, face.Normal);
  const Real turnEdge = glm::dot(turning, face.Edge);
  const Real weight = Real(0.5) * density * Real(options.DragCoefficient); // of a point: half of the segment
  CrossForcesOf<Real> forces;
  for (const double part : { 0.21132486540518713, 0.78867513459481287 })
  {
    const Real distance = Real(part) * link.Length;
    const Real n = slipNormal - distance * turnNormal;
    const Real b = slipEdge - distance * turnEdge;
    const Real speed = weight * Sqrt(n * n + b * b);
    const Real faceDrag = link.FrontalArea * speed;
    const Real edgeDrag = link.EdgeFrontalArea * speed;
    load.FaceDrag.Add(faceDrag, distance);
    load.EdgeDrag.Add(edgeDrag, distance);
    forces.Normal += faceDrag * n;
    forces.Edge += edgeDrag * b;
    forces.NormalFirst += distance * faceDrag * n;
    forces.EdgeFirst += distance * edgeDrag * b;
  }
  return forces;
}

/// Load on a link. Direct: eq. 4 of the paper, at the middle. Morison: drag at two Gauss points, inertia and lift at
/// the middle.
template <typename Real>
LITTORAL_INLINE LinkLoadOf<Real> LoadOn(const SeaweedOptions& options, const LinkBody<Real>& link,
  const LinkPoseOf<Real>& pose, const LinkFaceOf<Real>& face, const WaterOf<Real>& water)
{
  using Vector = glm::vec<3, Real>;
  const Real none(0.0);
  LinkLoadOf<Real> load;
  const Vector& e = pose.Axis;
  const Vector half = Real(0.5) * link.Length * e;
  if (options.Load == SeaweedLoad::Direct)
  {
    // eq. 4: F = L f, f = factor (acceleration or displacement, and current)
    load.Force = Real(options.ForceFactor) * link.Length * (water.Acceleration + water.Displacement + water.Velocity);
    load.Moment = Real(0.5) * link.Length * load.Force;
    return load;
  }
  const Real wet = SubmergedPart<Real>(options, link, pose, half);
  const Real density = wet * Real(0.5 * options.WaterDensity);
  const Vector slip = water.Velocity - pose.Velocity;
  const CrossForcesOf<Real> drag = AddDrag<Real>(options, link, pose, face, slip, density, load);
  // Friction F = rho/2 C_f A |r.e| (r.e) e
  const Real along = glm::dot(slip, e);
  load.Friction = density * Real(options.FrictionCoefficient) * link.WettedArea * Abs(along);
  // Inertia F = (rho V + A) a, added mass A by side (Froude and Krylov, Morison), and -f_A(u)
  const Real aNormal = glm::dot(water.Acceleration, face.Normal);
  const Real aEdge = glm::dot(water.Acceleration, face.Edge);
  const Vector inertia = wet *
    (link.WaterMass * water.Acceleration + (link.FaceMass * aNormal) * face.Normal +
      (link.EdgeMass * aEdge) * face.Edge);
  const Vector turning =
    StripForce<Real>(link, InAxes<Real>(face, e, pose.Spin), InAxes<Real>(face, e, water.Velocity));
  load.Turning = -wet * (turning.x * face.Edge + turning.y * face.Normal);
  // Net buoyancy in the water, weight out of it, and the push of the bed
  const Real lift = wet * link.Buoyancy - (Real(1.0) - wet) * link.Weight;
  const Real depth = link.Bed - pose.Foot.z - half.z;
  const Real push = (link.Mass + link.FaceMass) * Clamp(Real(BedStiffness) * depth, none, Real(BedAcceleration));
  const Vector central = inertia + (load.Friction * along) * e + Vector(none, none, push + lift);
  load.Force = central + drag.Normal * face.Normal + drag.Edge * face.Edge;
  load.Moment = Real(0.5) * link.Length * central + drag.EdgeFirst * face.Edge + drag.NormalFirst * face.Normal;
  return load;
}

/// Trees that are moved side by side: 2, 4 or 8, as many doubles as a register of this processor holds.
std::size_t LanesOfStep();

template <std::size_t Lanes>
using BodiesInLanes = std::vector<LinkBody<SimdDoubles<Lanes>>>;

/// Links of the trees of batches, those of the same index a lane each.
struct BatchBodies
{
  std::variant<BodiesInLanes<2>, BodiesInLanes<4>, BodiesInLanes<8>> Bodies; ///< of LanesOfStep() lanes
  std::vector<int> Parents; ///< index of the parent link within the batch; -1: the ground
};

}

#endif
