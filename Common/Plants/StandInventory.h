// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralStandInventory_h
#define LittoralStandInventory_h

#include "Plants/StandSpecies.h"

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

/// A unit as in "DBH in cm".
const char* NameOf(LengthUnit unit);

/// Names of the columns of an inventory; empty: by the names that are known; "-": there is none.
struct InventoryColumns
{
  std::string X;
  std::string Y;
  std::string Species;
  std::string Diameter;
  std::string Height;
  std::string Plot;
};

/// Maximum number of diameter classes of a kind.
inline constexpr int MaximumDiameterClasses = 20;

/// Options of the reading of an inventory.
struct InventoryOptions
{
  InventoryColumns Columns;
  LengthUnit CoordinateUnit = LengthUnit::Named; ///< usually metres
  LengthUnit DiameterUnit = LengthUnit::Named;   ///< usually centimetres; millimetres in a table of ForestGEO
  LengthUnit HeightUnit = LengthUnit::Named;     ///< usually metres
  double CoordinateScale = 1.0;  ///< factor of x and y beside their unit, positive, for plots on a unit square
  std::string Plot;              ///< the only plot that is read; empty: all
  bool KeepDead = false;         ///< keeps trees whose status is not alive
  bool AllowCoincident = false;  ///< allows trees at the same place
  bool AllowImplausible = false; ///< takes every positive number for a measure, see RequirePlausible()
  std::string DefaultSpecies = "hardwood"; ///< species of the table that stands for those that are not in it
  double QuadraticMeanDiameter = 0.0;      ///< of a stand without diameters [m], 0 to 2.5; 0: by its density
  double HeightVariation = 0.1;            ///< relative standard deviation of imputed heights, 0 to 0.4
  int DiameterClasses = 1;                 ///< maximum number of diameter classes of a kind, 1 to 20
  int Seed = 1;
};

/// Tree of an inventory. Missing dimensions are NaN until they are imputed.
struct StandTree
{
  long long Row = 0; ///< of the table, from 0
  double X = 0.0;    ///< [m]
  double Y = 0.0;    ///< [m]
  int Plot = 0;
  int Species = 0; ///< row of the table of species
  std::string Name;
  double Diameter = std::numeric_limits<double>::quiet_NaN(); ///< diameter at breast height [m]
  double Height = std::numeric_limits<double>::quiet_NaN();   ///< [m]
  bool ImputedDiameter = false;
  bool ImputedHeight = false;
};

/// Stand of an inventory.
struct StandInventory
{
  std::vector<StandTree> Trees;
  std::vector<std::string> Plots;        ///< names, in the order of the table
  std::vector<std::string> Unlisted;     ///< species that are not in the table of species
  std::vector<std::string> Unread;       ///< columns that nothing is read from
  std::vector<std::string> MissingCodes; ///< numbers that stand for missing values, as "dbh 9999"
  long long Dropped = 0;                 ///< rows of dead trees, of other plots, of stems beside the main one
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
 * Imputes missing diameters and heights, each by the seed and the row of its tree. A diameter is that of the curve at
 * the tree's height, else a quantile of those measured in the species or in the stand, else one of DiameterInStand(). A
 * height is H = 1.37 m + (r f(D) - 1.37 m) (1 + s z), with the curve f, the median ratio r of measured heights to the
 * curve, HeightVariation s, and a standard normal z truncated at 2.
 */
void CompleteStand(const StandSpeciesTable& species, const InventoryOptions& options, StandInventory& stand);

/// Area of the plots of a stand [m2]: of the rectangles around n trees, each side (n + 1) / (n - 1) of its length,
/// which is that of the plot on average if the trees stand at random; no side is below `narrowest` of the other.
double AreaOf(const StandInventory& stand, double narrowest = 1e-3);

}

#endif
