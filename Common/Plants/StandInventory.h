// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralStandInventory_h
#define LittoralStandInventory_h

#include "Plants/StandSpecies.h"

#include <array>
#include <limits>
#include <string>
#include <vector>

namespace littoral
{

/// Units of lengths in inventories; Named: as the name of the column says, else the usual one.
enum class LengthUnit
{
  Named = 0,
  Metre = 1,
  Centimetre = 2,
  Millimetre = 3,
  Foot = 4,
  Inch = 5,
};

inline constexpr int NumberOfLengthUnits = 6;

/// A unit in metres; 0 for Named.
double MetresOf(LengthUnit unit);

/// What the columns of an inventory are called; empty: by the names that are known.
struct InventoryColumns
{
  std::string X;
  std::string Y;
  std::string Species;
  std::string Diameter;
  std::string Height;
  std::string Plot;
};

/// Plants for the trees of a kind, at most.
inline constexpr int MaximumDiameterClasses = 20;

/// How an inventory is read.
struct InventoryOptions
{
  InventoryColumns Columns;
  LengthUnit CoordinateUnit = LengthUnit::Named;    ///< usually metres
  LengthUnit DiameterUnit = LengthUnit::Named; ///< usually centimetres; millimetres in a table of ForestGEO
  LengthUnit HeightUnit = LengthUnit::Named;   ///< usually metres
  double CoordinateScale = 1.0;                     ///< factor of x and y, for plots on a unit square
  std::string Plot;                            ///< the only plot that is read; empty: all
  bool KeepDead = false;                       ///< keeps trees whose status is not alive
  bool AllowCoincident = false;                ///< allows trees at the same place
  std::string DefaultSpecies = "hardwood";       ///< as which species that are not in the table count
  double QuadraticMeanDiameter = 0.0;                   ///< quadratic mean of a stand without diameters [m]; 0: by its density
  double HeightVariation = 0.1;                ///< standard deviation of drawn heights, as part of them, 0 to 0.4
  int DiameterClasses = 1;                         ///< plants of a kind, at most, 1 to 20
  int Seed = 1;
};

/// A tree of an inventory. What is not known is NaN until it has been drawn.
struct StandTree
{
  long long Row = 0; ///< of the table, from 0
  double X = 0.0;    ///< [m]
  double Y = 0.0;    ///< [m]
  int Plot = 0;
  int Species = 0; ///< row of the table of species
  std::string Name;
  double Diameter = std::numeric_limits<double>::quiet_NaN(); ///< [m]
  double Height = std::numeric_limits<double>::quiet_NaN();   ///< [m]
  bool ImputedDiameter = false;
  bool ImputedHeight = false;
};

/// A stand as an inventory tells it.
struct StandInventory
{
  std::vector<StandTree> Trees;
  std::vector<std::string> Plots;    ///< names, in the order of the table
  std::vector<std::string> Unlisted; ///< species that are not in the table of species
  long long Dropped = 0;             ///< rows of dead trees, of other plots, of stems beside the main one
};

/**
 * Reads an inventory. Known names of columns, in any case: x, gx, px, easting; y, gy, py, northing; species, sp,
 * mnemonic, latin, and genus before it; dbh, diameter, d130, or of girths gbh, cbh, girth, circumference; height, ht;
 * plot; status, dfstatus; treeid, tag. A unit may follow in the name: dbh_mm, height (ft). Trees of several plots whose
 * rectangles overlap are set in a row of plots along x, 20 m apart. Of stems of one tree at one place the thickest
 * counts. Throws InvalidInput if it cannot be read.
 */
StandInventory ReadInventory(const TextTable& table, const StandSpeciesTable& species, const InventoryOptions& options);

/**
 * Draws the diameters and heights that are not known, each by the seed and the row of its tree. A diameter is that of
 * the curve at the tree's height, else one of those that were measured in the species or in the stand, interpolated,
 * else one of DiameterInStand(). A height is that of the curve, times what the trees measured in both have more than
 * theirs in the middle, times a normal variation, cut at two standard deviations.
 */
void CompleteStand(const StandSpeciesTable& species, const InventoryOptions& options, StandInventory& stand);

/// The area of the smallest upright rectangles around the plots of a stand, each a mean spacing wider, in all [m2].
double AreaOf(const StandInventory& stand);

}

#endif
