// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralReevesTree_h
#define LittoralReevesTree_h

#include "PlantMesh.h"
#include "Skeleton.h"

#include <string>
#include <vector>

namespace littoral
{

/// The volume that limits the growth of a crown.
enum class CrownShape
{
  Cone = 0,
  Ellipsoid = 1,
};

/// Trees with numbers of their own.
enum class TreePreset
{
  Custom = 0,
  Pine = 1,
  Oak = 2,
  Birch = 3,
  Shrub = 4,
};

/// A tree of a kind; individuals differ by seed.
struct ReevesTreeParameters
{
  CrownShape Shape = CrownShape::Ellipsoid;
  double Height = 12.0;      ///< [m]
  double CrownRadius = 5.0;  ///< largest [m]
  double CrownBase = 2.5;    ///< height of the lowest leaves [m]
  double TrunkRadius = 0.3;  ///< at the ground [m]
  double TrunkReach = 0.65;  ///< part of the height that the trunk grows to
  int Orders = 3;            ///< of branches on the trunk, 1 to 4
  int MainBranches = 16;     ///< on the trunk
  int SideBranches = 6;      ///< on each branch
  double BranchAngle = 55.0; ///< between a branch and its parent [degrees]
  double Lift = 0.15;        ///< bend of branches: up where positive, down where negative
  double Variation = 0.2;    ///< standard deviation of lengths and angles, as part of their means
  int NumberOfLeaves = 6000;
  double LeafSize = 0.32;     ///< length of a leaf or of a tuft of leaves [m]
  double LeafWidth = 0.7;     ///< as part of its length
  Colour Leaf{ 92, 122, 48 }; ///< in the light
  Colour Bark{ 105, 88, 70 };
  int Seed = 1;
};

/// A leaf, or a tuft of leaves, as a particle.
struct LeafParticle
{
  Vector3 Position{ 0.0, 0.0, 0.0 }; ///< [m]
  Vector3 Normal{ 0.0, 0.0, 1.0 };   ///< outward from the crown
  double Size = 0.1;                 ///< [m]
  Colour Tint{ 0, 0, 0 };
  int Node = 0; ///< of the skeleton that carries it
};

struct ReevesTree
{
  Skeleton Wood;
  std::vector<LeafParticle> Leaves;
};

/// The numbers of a preset; those of Custom are the defaults.
ReevesTreeParameters PresetParameters(TreePreset preset);

/// Why there is no such tree, with the name of the parameter; empty when there is.
std::string WhyInvalid(const ReevesTreeParameters& parameters);

/// How deep a position [m] is in the crown: 1 on the axis at mid-height (ellipsoid) or on the axis (cone), 0 on the
/// surface of the bounding volume, negative outside.
double CrownDepth(const ReevesTreeParameters& parameters, const Vector3& position);

/// The outward direction of the bounding volume's level surface at a position.
Vector3 CrownNormal(const ReevesTreeParameters& parameters, const Vector3& position);

/**
 * Grows a tree as a structured particle system (Reeves and Blau 1985): a trunk, branches that repeat their parent's
 * rule with lengths cut by the bounding volume, leaves as particles on the branches of the highest order. Each number
 * is a function of the seed and of the branch or leaf it belongs to. The parameters must be valid.
 */
ReevesTree GrowReevesTree(const ReevesTreeParameters& parameters);

}

#endif
