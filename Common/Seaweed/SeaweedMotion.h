// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSeaweedMotion_h
#define LittoralSeaweedMotion_h

#include "Plants/Skinning.h"
#include "Seaweed/LinkState.h"
#include "Seaweed/SeaweedPlant.h"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace littoral
{

/// Trees of the same topology, a SIMD lane each. Where there are fewer trees than lanes, the first fills the others.
struct LinkBatch
{
  static constexpr std::size_t MaximumLanes = 8;
  std::array<std::size_t, MaximumLanes> First; ///< first link of the tree in each lane
  std::size_t Lanes = 0;                       ///< as many as a register of this processor has
  std::size_t Links = 0;                       ///< of a tree
  std::size_t Trees = 0;                       ///< number of trees that count, 1 to Lanes
  std::size_t Bodies = 0;                      ///< index of the first of its bodies in BatchBodies

  /// Links of all lanes, filled ones included.
  std::size_t PaddedLinks() const { return this->Lanes * this->Links; }
};

struct BatchBodies;

/**
 * Seaweeds as trees of stiff segments on springs (Coulais et al., section 4, with its equations put right). The full
 * equations of motion of the tree are solved by the articulated-body algorithm (joint forces, reactions of children,
 * gyroscopic and centrifugal terms included), with the implicit midpoint rule around it: second order in the step. A
 * step is taken in parts where links turn far or energy would be gained.
 *
 * Trees share nothing with others: those of the same shape are moved side by side, each as it would move alone.
 */
class SeaweedMotion
{
public:
  /// Links must come after their parents.
  SeaweedMotion(std::vector<SeaweedLink> links, const SeaweedOptions& options);

  const std::vector<SeaweedLink>& GetLinks() const { return this->Links; }

  const std::vector<LinkBatch>& GetBatches() const { return this->Batches; }

  /// All at rest.
  std::vector<LinkState> AtRest() const;

  /// Poses of the links [begin, end), whole trees. `poses` and `states` are of all links.
  void Pose(const LinkState* states, std::size_t begin, std::size_t end, LinkPose* poses) const;

  /// The pose of one link whose parent's is known.
  void PoseOne(const LinkState& state, std::size_t link, LinkPose* poses) const;

  /// The same of a link whose joint is at rest.
  void PoseAtRest(std::size_t link, LinkPose* poses) const;

  /// The middles of the links of a batch [m], lane by lane within a link, `ahead` [s] of the poses at their
  /// velocities: where the water is to be known.
  void Middles(const LinkBatch& batch, const LinkPose* poses, Vector3* middles, double ahead = 0.0) const;

  /// Takes a batch one step [s] further, its states and the poses that go with them; `water` is at its middles in the
  /// middle of the step (ExplicitEuler: at its beginning), and stays the same throughout.
  void Step(double step, const LinkBatch& batch, const WaterAtLink* water, LinkState* states, LinkPose* poses) const;

  /// The state of a link by eqs. 5 and 6, from the pose of its parent; without rates.
  LinkState Procedural(const WaterAtLink& water, std::size_t link, const LinkPose* poses) const;

  /// State between two states, share 0 to 1; without rates.
  LinkState Mixed(const LinkState& first, const LinkState& second, double share) const;

  /// The state of a link that keeps its rest angles.
  LinkState RestOf(std::size_t link) const;

private:
  SeaweedOptions Options;
  std::vector<SeaweedLink> Links;
  std::vector<LinkBatch> Batches;
  std::shared_ptr<const BatchBodies> Bodies;

  void MakeBatches();
};

/// Displacement of all that follows a link in a pose.
inline JointChange ChangeOf(const SeaweedLink& link, const LinkPose& pose)
{
  return ChangeOf({ pose.Rotation, pose.Foot - link.Foot }, link.Foot);
}

}

#endif
