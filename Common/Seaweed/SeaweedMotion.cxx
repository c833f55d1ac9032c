// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Seaweed/SeaweedMotion.h"

#include "Seaweed/SeaweedJoint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace littoral
{

namespace
{

constexpr double StopFrequency = 40.0; // of a link that bears all that grows on it [rad/s]

/// A unit vector turned by a rotation vector at a right angle to it.
Vector3 RotateUnit(const Vector3& direction, const Vector3& turn)
{
  const double angle = glm::length(turn);
  const double ratio = angle > 1e-8 ? std::sin(angle) / angle : 1.0;
  return glm::normalize(std::cos(angle) * direction + ratio * glm::cross(turn, direction));
}

/// One link of each lane.
template <std::size_t Lanes>
LinkBody<SimdDoubles<Lanes>> GatherBody(const std::vector<SeaweedLink>& links, const std::array<std::size_t, Lanes>& at)
{
  LinkBody<SimdDoubles<Lanes>> body;
  const auto vector = [&](Vector3 SeaweedLink::*part) { return GatherVector(links.data(), at, part); };
  const auto number = [&](double SeaweedLink::*part) { return GatherNumber(links.data(), at, part); };
  body.Foot = vector(&SeaweedLink::Foot);
  body.Axis = vector(&SeaweedLink::Axis);
  body.Side = vector(&SeaweedLink::Side);
  body.Arm = vector(&SeaweedLink::Arm);
  body.Base = GatherRotation(links.data(), at, &SeaweedLink::Base);
  body.Theta = number(&SeaweedLink::Theta);
  body.Phi = number(&SeaweedLink::Phi);
  body.Length = number(&SeaweedLink::Length);
  body.Mass = number(&SeaweedLink::Mass);
  body.FaceMass = number(&SeaweedLink::FaceMass);
  body.EdgeMass = number(&SeaweedLink::EdgeMass);
  body.AxialInertia = number(&SeaweedLink::AxialInertia);
  body.WaterMass = number(&SeaweedLink::WaterMass);
  body.Buoyancy = number(&SeaweedLink::Buoyancy);
  body.Weight = number(&SeaweedLink::Weight);
  body.FrontalArea = number(&SeaweedLink::FrontalArea);
  body.EdgeFrontalArea = number(&SeaweedLink::EdgeFrontalArea);
  body.WettedArea = number(&SeaweedLink::WettedArea);
  body.Stiffness = number(&SeaweedLink::Stiffness);
  body.Damping = number(&SeaweedLink::Damping);
  body.StopStiffness = number(&SeaweedLink::StopStiffness);
  body.StopDamping = number(&SeaweedLink::StopDamping);
  body.Bed = number(&SeaweedLink::Bed);
  return body;
}

/// The links of all batches, which are `count` of one lane.
template <std::size_t Lanes>
BodiesInLanes<Lanes> GatherBodies(
  const std::vector<SeaweedLink>& links, const std::vector<LinkBatch>& batches, std::size_t count)
{
  BodiesInLanes<Lanes> bodies;
  bodies.reserve(count);
  for (const LinkBatch& batch : batches)
  {
    std::array<std::size_t, Lanes> at;
    std::copy_n(batch.First.begin(), Lanes, at.begin());
    for (std::size_t link = 0; link < batch.Links; ++link)
    {
      bodies.push_back(GatherBody(links, at));
      for (std::size_t& one : at)
      {
        ++one;
      }
    }
  }
  return bodies;
}

}

//----------------------------------------------------------------------------
SeaweedMotion::SeaweedMotion(std::vector<SeaweedLink> links, const SeaweedOptions& options)
  : Options(options)
  , Links(std::move(links))
{
  for (SeaweedLink& link : this->Links)
  {
    const SeaweedLink* parent = link.Parent < 0 ? nullptr : &this->Links[link.Parent];
    link.Arm = parent ? link.Foot - parent->Foot : Vector3(0.0);
    link.StopStiffness = 0.0;
    link.Base = (parent ? parent->Base : GroundBase<double>()) * BaseRotation(link.Theta, link.Phi);
  }
  // What keeps joints from folding flat: strong enough for all that grows on them, on the arm of one link.
  for (std::size_t i = this->Links.size(); i-- > 0;)
  {
    SeaweedLink& link = this->Links[i];
    link.StopStiffness += link.Mass + link.FaceMass;
    if (link.Parent >= 0)
    {
      this->Links[link.Parent].StopStiffness += link.StopStiffness;
    }
    link.StopStiffness *= StopFrequency * StopFrequency * link.Length * link.Length / 3.0;
    link.StopDamping = 2.0 / StopFrequency * link.StopStiffness;
  }
  this->MakeBatches();
}

//----------------------------------------------------------------------------
/// Trees of the same shape, in the order in which they come.
void SeaweedMotion::MakeBatches()
{
  const std::size_t lanes = LanesOfStep();
  std::map<std::vector<int>, std::size_t> open; // batches that have lanes left, by what their links grow on
  std::vector<int> shape;
  std::size_t end = 0;
  for (std::size_t first = 0; first < this->Links.size(); first = end)
  {
    shape.clear();
    for (end = first; end < this->Links.size() && (end == first || this->Links[end].Parent >= 0); ++end)
    {
      shape.push_back(end == first ? -1 : this->Links[end].Parent - static_cast<int>(first));
    }
    const auto known = open.find(shape);
    if (known == open.end())
    {
      open[shape] = this->Batches.size();
      LinkBatch batch;
      batch.First.fill(first);
      batch.Lanes = lanes;
      batch.Links = end - first;
      batch.Trees = 1;
      this->Batches.push_back(batch);
      continue;
    }
    LinkBatch& batch = this->Batches[known->second];
    batch.First[batch.Trees++] = first;
    if (batch.Trees == lanes)
    {
      open.erase(known);
    }
  }
  const auto bodies = std::make_shared<BatchBodies>();
  for (LinkBatch& batch : this->Batches)
  {
    batch.Bodies = bodies->Parents.size();
    for (std::size_t link = batch.First[0]; link < batch.First[0] + batch.Links; ++link)
    {
      const int parent = this->Links[link].Parent;
      bodies->Parents.push_back(parent < 0 ? -1 : parent - static_cast<int>(batch.First[0]));
    }
  }
  switch (lanes)
  {
    case 8:
      bodies->Bodies = GatherBodies<8>(this->Links, this->Batches, bodies->Parents.size());
      break;
    case 4:
      bodies->Bodies = GatherBodies<4>(this->Links, this->Batches, bodies->Parents.size());
      break;
    default:
      bodies->Bodies = GatherBodies<2>(this->Links, this->Batches, bodies->Parents.size());
  }
  this->Bodies = bodies;
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
  const bool stands = link.Parent < 0;
  PoseLink<double>(this->Options.Joint, link, state, stands ? nullptr : &this->Links[link.Parent],
    stands ? nullptr : &poses[link.Parent], poses[index]);
}

void SeaweedMotion::PoseAtRest(std::size_t index, LinkPose* poses) const
{
  const SeaweedLink& link = this->Links[index];
  if (link.Parent < 0)
  {
    this->PoseOne(this->RestOf(index), index, poses);
    return;
  }
  // The pose of PoseLink() without a turn at the joint
  const LinkPose& parent = poses[link.Parent];
  LinkPose& pose = poses[index];
  pose.Foot = link.Foot + (parent.Foot - this->Links[link.Parent].Foot) + RotationOffset(parent.Rotation, link.Arm);
  pose.Rotation = parent.Rotation;
  pose.Axis = Rotated(parent.Rotation, link.Axis);
  pose.Spin = parent.Spin;
  pose.Velocity = parent.Velocity + glm::cross(parent.Spin, pose.Foot - parent.Foot);
}

void SeaweedMotion::Pose(const LinkState* states, std::size_t begin, std::size_t end, LinkPose* poses) const
{
  for (std::size_t i = begin; i < end; ++i)
  {
    this->PoseOne(states[i], i, poses);
  }
}

//----------------------------------------------------------------------------
void SeaweedMotion::Middles(const LinkBatch& batch, const LinkPose* poses, Vector3* middles, double ahead) const
{
  const auto find = [&](const auto& bodies) {
    for (std::size_t i = 0; i < batch.Links; ++i)
    {
      for (std::size_t lane = 0; lane < batch.Lanes; ++lane)
      {
        const LinkPose& pose = poses[batch.First[lane] + i];
        const Vector3 half = 0.5 * bodies[batch.Bodies + i].Length.Values[lane] * pose.Axis;
        *middles++ = pose.Foot + half + ahead * (pose.Velocity + glm::cross(pose.Spin, half));
      }
    }
  };
  std::visit(find, this->Bodies->Bodies);
}

//----------------------------------------------------------------------------
LinkState SeaweedMotion::Procedural(const WaterAtLink& water, std::size_t index, const LinkPose* poses) const
{
  const SeaweedLink& link = this->Links[index];
  const SeaweedOptions& options = this->Options;
  LinkState state = this->RestOf(index);
  LinkPose rest;
  const glm::dquat below = link.Parent < 0 ? IdentityRotation<double>() : poses[link.Parent].Rotation;
  rest.Foot = link.Foot;
  rest.Axis = Rotated(below, link.Axis);
  // Buoyancy is part of the equilibrium.
  const Vector3 lift = options.Load == SeaweedLoad::Morison ? Vector3(0.0, 0.0, link.Buoyancy) : Vector3(0.0);
  rest.Rotation = below;
  // Blades that bend at once, as far as they may, would flap as the flow passes their edge: loads are those of a face
  // that is always turned to the flow.
  LinkBody<double> turned = link;
  turned.EdgeFrontalArea = link.FrontalArea;
  turned.EdgeMass = link.FaceMass;
  const Vector3 force = LoadOn<double>(options, turned, rest, FaceOf<double>(link, rest), water).Force - lift;
  // Torques go with the square of the length and turns with its cube, so that graded links would bend where they are
  // long: a link bends as a part of one of mean length does.
  const double share = link.MeanLength > 0.0 ? link.Length / link.MeanLength : 1.0;
  // eq. 5: tau = (part of L) Y x F
  const Vector3 torque = options.LeverArm * link.Length / (share * share) * glm::cross(rest.Axis, force);
  const double stiffness = std::max(1e-12, share * link.Stiffness + link.BuoyancyStiffness);
  const double most = options.MaximumAngle;
  const double less = std::min(1.0, share);
  const double more = std::max(1.0, share);
  const auto soft = [&](double angle) { return most > 0.0 ? less * most * std::tanh(more * angle / most) : 0.0; };
  if (options.Joint == SeaweedJoint::Tilting)
  {
    const glm::dquat frame = link.Parent < 0 ? GroundBase<double>() : below * this->Links[link.Parent].Base;
    const Vector3 y = Rotated(frame, Vector3(0.0, 1.0, 0.0));
    const Vector3 x = Rotated(frame, Vector3(std::cos(link.Theta), 0.0, -std::sin(link.Theta)));
    // eq. 6, with a stiffness in place of the mass
    state.Shape.x += soft(glm::dot(torque, y) / stiffness);
    state.Shape.y += soft(glm::dot(torque, x) / stiffness);
    return state;
  }
  const Vector3 turn = Rotated(Conjugate(below), torque / stiffness);
  const double angle = glm::length(turn);
  state.Shape = angle > 0.0 ? RotateUnit(link.Axis, soft(angle) / angle * turn) : link.Axis;
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
  mixed.Shape = RotateUnit(first.Shape, share * ArcVector(first.Shape, second.Shape, Perpendicular(first.Shape)));
  return mixed;
}

}
