// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralAonoKuniiTree_h
#define LittoralAonoKuniiTree_h

#include "Numerics/Parallel.h"
#include "Plants/Plant.h"

#include <string>

namespace littoral
{

/// Forms of branching.
enum class Branching
{
  Monopodial = 0, ///< a straight axis with side branches
  Sympodial = 1,  ///< two unequal branches at each fork, no straight axis
  Ternary = 2,    ///< three equal branches at each fork
};

/// Published sets of numbers: those of the figures 2.6, 2.7 and 2.8, a to d, of The Algorithmic Beauty of Plants.
enum class ForkPreset
{
  Custom = 0,
  MonopodialA = 1,
  MonopodialD = 4,
  SympodialA = 5,
  SympodialD = 8,
  TernaryA = 9,
  TernaryD = 12,
};

/// A tree that repeats one fork; individuals differ by seed.
struct AonoKuniiParameters
{
  Branching Form = Branching::Monopodial;
  int Iterations = 10;
  double LengthRatio1 = 0.9;      ///< of the stronger branch to its parent; not ternary
  double LengthRatio2 = 0.6;      ///< of the weaker branch; not ternary
  double Angle1 = 45.0;           ///< a0 of side branches on the trunk, a1 or a [degrees]
  double Angle2 = 45.0;           ///< a2 [degrees]; not ternary
  double DivergenceAngle = 137.5; ///< about the trunk, from branch to branch; ternary: d1 [degrees]
  double DivergenceAngle2 = 0.0;  ///< ternary: d2 [degrees]
  double WidthRatio = 0.707;      ///< of a branch to its parent
  double Elongation = 1.0;        ///< ternary: by which a step lengthens what is there
  Vector3 Tropism{ 0.0, 0.0, -1.0 };
  double Susceptibility = 0.0; ///< to the tropism [rad]
  double TrunkLength = 1.75;   ///< of the first segment [m]
  double TrunkRadius = 0.17;   ///< at the ground [m]
  double Variation = 0.1;      ///< standard deviation of lengths and angles, as part of their means
  int NumberOfLeaves = 9000;
  double LeafSize = 0.25; ///< [m]
  double LeafWidth = 0.6; ///< as part of its length
  LeafForm Outline = LeafForm::Spray;
  Color Leaf{ 112, 146, 60 }; ///< in the light
  Color Bark{ 105, 88, 70 };
  int Seed = 1;
};

inline constexpr int NumberOfForkPresets = 13;

/// The name of a preset, as users see it.
const char* ForkPresetName(ForkPreset preset);

/// The numbers of a preset; those of Custom are the defaults.
AonoKuniiParameters PresetParameters(ForkPreset preset);

/// The most iterations of a form that are allowed; a step doubles or triples the tree.
int MaximumIterations(Branching form);

/// Why there is no such tree, with the name of the parameter; empty when there is.
std::string WhyInvalid(const AonoKuniiParameters& parameters);

/**
 * Grows a tree by the rules of Aono and Kunii (1984), as written down by Prusinkiewicz and Lindenmayer: a segment, a
 * fork, and again. Without variation it is the tree of the rules exactly. The node at the foot of a segment has the
 * segment's radius; leaves stand on the segments of the last iteration. The parameters must be valid.
 */
Plant GrowAonoKuniiTree(const AonoKuniiParameters& parameters, const Poll& poll = NoPoll);

}

#endif
