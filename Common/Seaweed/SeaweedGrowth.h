// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSeaweedGrowth_h
#define LittoralSeaweedGrowth_h

#include "Plants/PlantMesh.h"
#include "Plants/SeaweedSegment.h"

#include <string>
#include <vector>

namespace littoral
{

/// Seaweeds with numbers of their own.
enum class SeaweedPreset
{
  Custom = 0,
  SugarKelp = 1, ///< Saccharina latissima, which was Laminaria saccharina
  GiantKelp = 2, ///< Macrocystis pyrifera
  Eelgrass = 3,  ///< Zostera marina
};

/// Forms of seaweeds.
enum class SeaweedForm
{
  Tuft = 0,   ///< fronds on one holdfast: a stipe and an undivided blade each
  Canopy = 1, ///< long stipes on one holdfast, with blades at regular distances, each on a float
  Meadow = 2, ///< shoots of a few narrow leaves on a creeping rhizome
};

/// A seaweed of a kind; individuals differ by seed.
struct SeaweedParameters
{
  SeaweedForm Form = SeaweedForm::Tuft;
  int NumberOfFronds = 7;        ///< fronds, stipes or leaves
  double HoldfastRadius = 0.07;  ///< Meadow: of the patch [m]
  double StipeLength = 0.3;      ///< [m]; none in a Meadow
  double StipeRadius = 0.006;    ///< [m]
  double BladeLength = 1.7;      ///< [m]
  double BladeWidth = 0.2;       ///< where it is widest [m]
  double BladeThickness = 0.002; ///< [m]
  double BladeSpacing = 0.35;    ///< along a stipe [m]; Canopy only
  double FloatRadius = 0.018;    ///< [m], 0 for none; Canopy only
  double Ruffle = 0.3;           ///< height of the waves of blade edges, as part of half the width
  double SpreadAngle = 22.0;     ///< mean tilt of fronds [degrees]
  int SegmentsPerBranch = 10;    ///< of a frond or stipe; the blades of a Canopy have a quarter, at least 2
  double StipeModulus = 3e7;     ///< Young's modulus [Pa]
  double BladeModulus = 4e6;     ///< Young's modulus [Pa]
  double DampingRatio = 0.05;    ///< of the tissue, of critical
  double StipeDensity = 1020.0;  ///< [kg/m3]
  double BladeDensity = 1005.0;  ///< [kg/m3]
  double FloatDensity = 300.0;   ///< gas included [kg/m3]; Canopy only
  double Variation = 0.18;       ///< standard deviation of sizes and angles, as part of their means
  Color Blade{ 190, 136, 48 };
  Color Stipe{ 128, 90, 40 };
  int Seed = 1;
};

inline constexpr int NumberOfSeaweedPresets = 4;

/// The row of a preset.
struct SeaweedPresetTraits
{
  const char* Name; ///< as in the enumeration
  SeaweedParameters (*Parameters)();
};

/// The row of a preset, which must be one of the enumeration.
const SeaweedPresetTraits& TraitsOf(SeaweedPreset preset);

/**
 * The numbers of a preset; those of Custom are the defaults. Sizes are those of grown plants. Moduli of kelp lie within
 * what Harder, Hurd and Speck (2006) measured on stipes, from 6 MPa in tension to 109 MPa in bending; their tissue
 * loses half of its energy in a cycle, which is a damping ratio of 0.05. Densities are chosen so that each stands up in
 * still water.
 */
SeaweedParameters PresetParameters(SeaweedPreset preset);

/// Why there is no such seaweed, with the name of the parameter; empty when there is.
std::string WhyInvalid(const SeaweedParameters& parameters);

/// A flat part of a branch, from a node to its tip.
struct SeaweedBlade
{
  int Branch = 0;
  int FirstStep = 0;   ///< the node of the branch where it begins; its segments end at BladeSteps
  double Length = 1.0; ///< [m]
  double Width = 0.1;  ///< where it is widest [m]
  double Ruffle = 0.0; ///< height of the waves of its edges [m]
  double Phase = 0.0;  ///< of the waves [rad]
  Color Tint{ 0, 0, 0 };
};

/// A seaweed as it grew.
struct Seaweed
{
  SeaweedParameters Parameters;
  Skeleton Wood;                        ///< branch 0 is the holdfast
  std::vector<SeaweedSegment> Segments; ///< of each node
  std::vector<SeaweedBlade> Blades;
};

/**
 * Ends of the segments of a blade as parts of its length: `count` + 1 numbers from 0 to 1. The first half, at most
 * five, are each 1.6 times as long as the one before, the rest equal: limp blades bend next to their foot.
 */
std::vector<double> BladeSteps(int count);

/// The width of a blade at a part of its length, 0 at its foot and 1 at its tip, as part of the largest.
double BladeProfile(SeaweedForm form, double part);

/// Grows a seaweed. Each number is a function of the seed and of the frond or blade that it belongs to. The parameters
/// must be valid.
Seaweed GrowSeaweed(const SeaweedParameters& parameters);

}

#endif
