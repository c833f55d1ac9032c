// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralReevesTree_h
#define LittoralReevesTree_h

#include "Numerics/Parallel.h"
#include "Plants/Plant.h"
#include "Plants/WoodParameters.h"

#include <string>

namespace littoral
{

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
  double CrownRadius = 5.4;  ///< largest [m]
  double CrownBase = 2.2;    ///< height of the lowest leaves [m]
  double TrunkRadius = 0.3;  ///< at breast height [m]
  double TrunkReach = 0.65;  ///< part of the height that the trunk grows to
  int Orders = 3;            ///< of branches on the trunk, 1 to 4
  int MainBranches = 22;     ///< on the trunk
  int SideBranches = 6;      ///< on each branch
  double BranchAngle = 62.0; ///< between a branch and its parent [degrees]
  double Lift = 0.08;        ///< bend of branches: up where positive, down where negative
  double Variation = 0.2;    ///< standard deviation of lengths and angles, as part of their means
  int NumberOfLeaves = 10000;
  double LeafSize = 0.32;     ///< length of a leaf or of a tuft of leaves [m]
  double LeafWidth = 0.7;     ///< as part of its length
  Color Leaf{ 112, 146, 60 }; ///< in the light
  Color Bark{ 105, 88, 70 };
  LeafForm Form = LeafForm::Spray;
  int Seed = 1;
};

inline constexpr int NumberOfTreePresets = 5;

/// The row of a preset.
struct TreePresetTraits
{
  const char* Name; ///< as in the enumeration
  ReevesTreeParameters (*Parameters)();
  WoodSpecies Wood;
};

/// The row of a preset, which must be one of the enumeration.
const TreePresetTraits& TraitsOf(TreePreset preset);

/// The numbers of a preset; those of Custom are the defaults.
ReevesTreeParameters PresetParameters(TreePreset preset);

/**
 * A tree of a preset with a height and a diameter at breast height [m]; 0: the preset's own; and with a diameter of its
 * crown [m]; 0: crowns are as wide as stems are thick. A slender tree has grown among others: its crown is the shorter
 * a part of the height, as the root of the stem's stoutness, and its trunk goes on the higher; that of a shrub reaches
 * down to the ground always. Leaves are as large as it takes to cover the crown as before.
 */
ReevesTreeParameters SizedParameters(TreePreset preset, double height, double diameter, double crown = 0.0);

/// Height at which the radius of a trunk is given, for a tree of a height [m]: 1.3 m, and less where the tree is lower
/// than 13 m.
double TrunkReferenceHeight(double height);

/// Why there is no such tree, with the name of the parameter; empty when there is.
std::string WhyInvalid(const ReevesTreeParameters& parameters);

/// The volume that bounds the crown of a valid tree.
CrownVolume CrownOf(const ReevesTreeParameters& parameters);

/**
 * Grows a tree as a structured particle system (Reeves and Blau 1985): a trunk, branches that repeat their parent's
 * rule with lengths cut by the bounding volume, leaves as particles on the branches of the highest order. Each number
 * is a function of the seed and of the branch or leaf it belongs to. The parameters must be valid.
 */
Plant GrowReevesTree(const ReevesTreeParameters& parameters, const Poll& poll = NoPoll);

}

#endif
