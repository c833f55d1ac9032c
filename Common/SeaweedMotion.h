// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSeaweedMotion_h
#define LittoralSeaweedMotion_h

#include "SeaweedPlant.h"
#include "Skinning.h"

#include <cstddef>
#include <vector>

namespace littoral
{

/// The water at the middle of a segment.
struct WaterAtLink
{
  Vector3 Velocity{ 0.0, 0.0, 0.0 };     ///< of waves and current [m/s]
  Vector3 Acceleration{ 0.0, 0.0, 0.0 }; ///< of the waves [m/s2]
  Vector3 Displacement{ 0.0, 0.0, 0.0 }; ///< by the waves [m]; of Direct loads in procedural motion only
};

/// The state of a joint: its shape and how fast it changes.
struct LinkState
{
  Vector3 Shape{ 0.0, 0.0, 1.0 }; ///< Bending: the segment's direction, as if its parent were at rest; else theta, phi
  Vector3 Rate{ 0.0, 0.0, 0.0 };  ///< Bending: of turning against the parent, in the same frame; else of the angles
};

/// Where a link is and how it moves.
struct LinkPose
{
  glm::dquat Turn{ 1.0, 0.0, 0.0, 0.0 }; ///< from rest
  Vector3 Foot{ 0.0, 0.0, 0.0 };         ///< [m]
  Vector3 Axis{ 0.0, 0.0, 1.0 };
  Vector3 Velocity{ 0.0, 0.0, 0.0 }; ///< of the foot [m/s]
  Vector3 Spin{ 0.0, 0.0, 0.0 };     ///< [rad/s]
};

/**
 * Seaweeds as trees of stiff segments on springs (Coulais et al., section 4, with its equations put right). The full
 * equations of motion of the tree are solved in one pass down and one pass up (joint forces, reactions of children and
 * centrifugal terms included), as a linearly implicit trapezoidal rule: springs, tension and drag are taken at the
 * middle of the step, so that a step may be long against the stiffest joint.
 */
class SeaweedMotion
{
public:
  /// Links must come after their parents.
  SeaweedMotion(std::vector<SeaweedLink> links, const SeaweedOptions& options);

  const std::vector<SeaweedLink>& GetLinks() const { return this->Links; }

  /// Trees stand side by side: [Trees[i], Trees[i + 1]) share nothing with others.
  const std::vector<std::size_t>& GetTrees() const { return this->Trees; }

  /// All at rest.
  std::vector<LinkState> AtRest() const;

  /// Poses of the links [begin, end), whole trees. `poses` and `states` are of all links.
  void Pose(const LinkState* states, std::size_t begin, std::size_t end, LinkPose* poses) const;

  /// The pose of one link whose parent's is known.
  void PoseOne(const LinkState& state, std::size_t link, LinkPose* poses) const;

  /// Takes the whole trees [begin, end) one step [s] further, from poses that go with the states; `water` is theirs
  /// alone.
  void Step(double step, const WaterAtLink* water, const LinkPose* poses, std::size_t begin, std::size_t end,
    LinkState* states) const;

  /// The state of a link by eqs. 5 and 6, from the pose of its parent; without rates.
  LinkState Procedural(const WaterAtLink& water, std::size_t link, const LinkPose* poses) const;

  /// Between two states, share 0 to 1; without rates.
  LinkState Mixed(const LinkState& first, const LinkState& second, double share) const;

  /// The state of a link that keeps its rest angles.
  LinkState RestOf(std::size_t link) const;

private:
  SeaweedOptions Options;
  std::vector<SeaweedLink> Links;
  std::vector<std::size_t> Trees;
  std::vector<glm::dquat> Bases; // of the paper, at rest
  std::vector<Vector3> Arms;     // from the parent's foot to the own, at rest

  struct Work;
  void Begin(double step, const WaterAtLink& water, const LinkPose* poses, std::size_t link, Work* works,
    std::size_t first, const LinkState& state) const;
  Vector3 ForceOn(const SeaweedLink& link, const LinkPose& pose, const WaterAtLink& water, double& resistance) const;
};

/// What a pose moved a joint of the skeleton by.
inline JointPose PoseOf(const SeaweedLink& link, const LinkPose& pose)
{
  return { pose.Turn, pose.Foot - link.Foot };
}

}

#endif
