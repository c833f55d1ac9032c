// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSkeleton_h
#define LittoralSkeleton_h

#include "Numerics/Vector3.h"

#include <string>
#include <vector>

namespace littoral
{

/// A joint of a plant.
struct SkeletonNode
{
  int Parent = -1;                   ///< index of the node towards the root; -1 for a root
  Vector3 Position{ 0.0, 0.0, 0.0 }; ///< [m]
  double Radius = 0.01;              ///< of the wood [m]
  int Branch = 0;                    ///< index of the branch that holds the node
};

/// A run of nodes, each the parent of the next. The first lies on the parent branch.
struct SkeletonBranch
{
  int First = 0;
  int Count = 0;
  int Order = 0; ///< 0 for a trunk, 1 more than the parent branch otherwise
};

/// A plant as a tree of joints; parents come before their children.
struct Skeleton
{
  std::vector<SkeletonNode> Nodes;
  std::vector<SkeletonBranch> Branches;

  /// Starts a branch at a position on the node `parent` (-1: a trunk); returns its index.
  int StartBranch(int parent, const Vector3& position, double radius);

  /// Adds a node to the end of the last branch; returns its index.
  int Grow(const Vector3& position, double radius);

  /// The last node of a branch.
  int Tip(int branch) const { return this->Branches[branch].First + this->Branches[branch].Count - 1; }

  /// Length of a branch [m].
  double BranchLength(int branch) const;

  /// A position on a branch [m], 0 at its first node and 1 at its last, and the node below it.
  Vector3 Along(int branch, double part, int& node) const;
};

/**
 * Why this is no skeleton, in words; empty when it is one: no nodes, values that are not finite, a radius that is not
 * positive, parents that do not exist or do not come first (hence cycles), branches of fewer than two nodes, that
 * overlap, or with two nodes at one place.
 */
std::string WhyInvalid(const Skeleton& skeleton);

/// The plants of a valid skeleton, one a trunk, with indices of their own and in the skeleton's order. None where a
/// branch grows on a plant before the last trunk.
std::vector<Skeleton> PlantsOf(const Skeleton& skeleton);

}

#endif
