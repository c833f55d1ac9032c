// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkStandInventoryFilter
 * @brief   make sites of trees with dimensions from the table of a forest inventory
 *
 * Input, port 0: a vtkTable with a row a tree. Columns x and y are needed; species, dbh, height, plot, status and
 * treeid are used where there are. Known names, in any case and with a unit behind them, as in `dbh_mm` or `height
 * (ft)`: x, gx, px, easting; y, gy, py, northing; species, sp, mnemonic, latin, and genus before it; dbh, diameter,
 * d130, or of girths gbh, cbh, girth, circumference; height, ht; plot; status, dfstatus; treeid, tag. A table with gx
 * and gy, or px and py, is one of ForestGEO, whose dbh is in millimetres. Empty cells, NA, NaN, NULL and 0 are missing
 * diameters and heights, and so are codes: negative nines; 999, 9999 and the like and 5005 where they are more than
 * twice all other numbers of the column; and the largest number, if it is there twice and no tree has it.
 *
 * Input, port 1, optional: a vtkTable of species with the columns `species` (names, separated by semicolons), `kind`
 * (the plant that stands for it, as Pine, Oak, Birch or Shrub), and optionally `curve` (Curtis or Weibull), `a`, `b`,
 * `c`: height H [m] over diameter D [cm], H = 1.37 + a exp(-b D^c) or H = a (1 - exp(-b D^c)). Without it, the table of
 * Littoral: curves of 50 species and groups of the southern United States (Forest Vegetation Simulator, Keyser 2008)
 * and of all tropics (Feldpausch et al. 2012). A species is looked up by its whole name, then by its genus, else it
 * counts as DefaultSpecies.
 *
 * Output: vtkPolyData, a vertex a tree, in double precision. Point arrays: `SiteId` (row of the table, from 0),
 * `Species` (index of the plant, which is that of the prototype in vtkPlantScatterFilter), `DBH` and `Height` [m],
 * `CrownDiameter` [m] (by Jucker et al. 2017, from DBH and height), `Plot` (index in Plots), `Imputed` (0 measured, 1
 * DBH imputed, 2 height imputed, 3 both) and `SpeciesName`. Field data: `Kinds`, the kinds of the plants, in the order
 * of the table of species, and `PlantDBH`, `PlantHeight` and `PlantCrownDiameter` [m], the medians of the trees that
 * each plant stands for; `Plots`; `Unlisted`, species that are not in the table of species; `UnusedColumns`;
 * `MissingCodes`, as "dbh 9999"; `RowsDropped`; `Area` [m2], of the rectangles around the plots, each side wider by
 * (n + 1) / (n - 1) for n trees. Unused columns and codes are also a warning, once.
 *
 * Missing values are functions of Seed and of the row of the tree alone. A missing height is that of the curve, scaled
 * by trees with both measures where there are at least 5, with HeightVariation. A missing diameter is that of the curve
 * at the height, else one of those that were measured in the species or the stand where there are at least 10,
 * interpolated, else one of a Weibull law whose mean follows from the density of the stand (Reineke 1933), see
 * QuadraticMeanDiameter.
 *
 * Plots whose rectangles overlap are set in a row along x, 20 m apart. Of the stems of a tree, by treeid and within
 * 2 m, the thickest is taken. Rows of dead trees are left out.
 *
 * A column that is not there, columns of which none is known but places, plots and numbers, a cell that is no
 * number, trees at the same place, dimensions that no stand has in the unit that was said, a tree that is too thick,
 * too high or too slender or stands far from all others, a column that may be the diameter or the height but is not
 * known as such, and a table without trees are reported as one error.
 *
 * @sa vtkPlantScatterFilter
 */
#ifndef vtkStandInventoryFilter_h
#define vtkStandInventoryFilter_h

#include "LittoralFiltersModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

namespace littoral
{
struct InventoryOptions;
struct StandInventory;
class StandSpeciesTable;
}

class LITTORALFILTERS_EXPORT vtkStandInventoryFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkStandInventoryFilter* New();
  vtkTypeMacro(vtkStandInventoryFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Lets no exception leave a request, as for want of memory: it becomes an error.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  /// Units of lengths.
  enum UnitType
  {
    Named = 0, ///< as the name of the column says, else the usual one
    Metre = 1,
    Centimetre = 2,
    Millimetre = 3,
    Foot = 4,
    Inch = 5,
  };

  ///@{
  /**
   * Unit of x and y, a UnitType; default Named, which is metres unless the column says another.
   */
  vtkSetMacro(CoordinateUnit, int);
  vtkGetMacro(CoordinateUnit, int);
  void SetCoordinateUnitToNamed() { this->SetCoordinateUnit(Named); }
  void SetCoordinateUnitToMetre() { this->SetCoordinateUnit(Metre); }
  void SetCoordinateUnitToCentimetre() { this->SetCoordinateUnit(Centimetre); }
  void SetCoordinateUnitToMillimetre() { this->SetCoordinateUnit(Millimetre); }
  void SetCoordinateUnitToFoot() { this->SetCoordinateUnit(Foot); }
  void SetCoordinateUnitToInch() { this->SetCoordinateUnit(Inch); }
  ///@}

  ///@{
  /**
   * Unit of diameters, a UnitType; default Named, which is centimetres unless the column says another or the table is
   * one of ForestGEO (millimetres).
   */
  vtkSetMacro(DiameterUnit, int);
  vtkGetMacro(DiameterUnit, int);
  void SetDiameterUnitToNamed() { this->SetDiameterUnit(Named); }
  void SetDiameterUnitToMetre() { this->SetDiameterUnit(Metre); }
  void SetDiameterUnitToCentimetre() { this->SetDiameterUnit(Centimetre); }
  void SetDiameterUnitToMillimetre() { this->SetDiameterUnit(Millimetre); }
  void SetDiameterUnitToFoot() { this->SetDiameterUnit(Foot); }
  void SetDiameterUnitToInch() { this->SetDiameterUnit(Inch); }
  ///@}

  ///@{
  /**
   * Unit of heights, a UnitType; default Named, which is metres unless the column says another.
   */
  vtkSetMacro(HeightUnit, int);
  vtkGetMacro(HeightUnit, int);
  void SetHeightUnitToNamed() { this->SetHeightUnit(Named); }
  void SetHeightUnitToMetre() { this->SetHeightUnit(Metre); }
  void SetHeightUnitToCentimetre() { this->SetHeightUnit(Centimetre); }
  void SetHeightUnitToMillimetre() { this->SetHeightUnit(Millimetre); }
  void SetHeightUnitToFoot() { this->SetHeightUnit(Foot); }
  void SetHeightUnitToInch() { this->SetHeightUnit(Inch); }
  ///@}

  ///@{
  /**
   * Factor of x and y besides their unit, positive; default 1. For plots that were scaled, as to a unit square.
   */
  vtkSetMacro(CoordinateScale, double);
  vtkGetMacro(CoordinateScale, double);
  ///@}

  ///@{
  /**
   * Name of the column of x; default empty, by the known names.
   */
  vtkSetStringMacro(XColumn);
  vtkGetStringMacro(XColumn);
  ///@}

  ///@{
  /**
   * Name of the column of y; default empty, by the known names.
   */
  vtkSetStringMacro(YColumn);
  vtkGetStringMacro(YColumn);
  ///@}

  ///@{
  /**
   * Name of the column of species; default empty, by the known names; `-`: none.
   */
  vtkSetStringMacro(SpeciesColumn);
  vtkGetStringMacro(SpeciesColumn);
  ///@}

  ///@{
  /**
   * Name of the column of diameters at breast height; default empty, by the known names; `-`: none.
   */
  vtkSetStringMacro(DiameterColumn);
  vtkGetStringMacro(DiameterColumn);
  ///@}

  ///@{
  /**
   * Name of the column of heights; default empty, by the known names; `-`: none.
   */
  vtkSetStringMacro(HeightColumn);
  vtkGetStringMacro(HeightColumn);
  ///@}

  ///@{
  /**
   * Name of the column of plots; default empty, by the known names; `-`: none.
   */
  vtkSetStringMacro(PlotColumn);
  vtkGetStringMacro(PlotColumn);
  ///@}

  ///@{
  /**
   * Name of the only plot that is read; default empty, all plots.
   */
  vtkSetStringMacro(Plot);
  vtkGetStringMacro(Plot);
  ///@}

  ///@{
  /**
   * Species of the table that stands for those that are not in it; default `hardwood`.
   */
  vtkSetStringMacro(DefaultSpecies);
  vtkGetStringMacro(DefaultSpecies);
  ///@}

  ///@{
  /**
   * Reading of trees whose status says that they are dead, gone or missing; default off.
   */
  vtkSetMacro(KeepDead, bool);
  vtkGetMacro(KeepDead, bool);
  vtkBooleanMacro(KeepDead, bool);
  ///@}

  ///@{
  /**
   * Reading of several trees at the same place; default off, an error.
   */
  vtkSetMacro(AllowCoincident, bool);
  vtkGetMacro(AllowCoincident, bool);
  vtkBooleanMacro(AllowCoincident, bool);
  ///@}

  ///@{
  /**
   * Reading of sizes and places that no stand has, and of 999 and the like as measures; default off: an error, or a
   * missing value.
   */
  vtkSetMacro(AllowImplausible, bool);
  vtkGetMacro(AllowImplausible, bool);
  vtkBooleanMacro(AllowImplausible, bool);
  ///@}

  ///@{
  /**
   * Quadratic mean diameter of a stand without diameters and heights [m], 0 to 2.5; default 0: by the density of the
   * stand, as if it was half as dense as upland oaks can be (284 trees of 25.4 cm a hectare), 0.05 to 0.6 m.
   */
  vtkSetMacro(QuadraticMeanDiameter, double);
  vtkGetMacro(QuadraticMeanDiameter, double);
  ///@}

  ///@{
  /**
   * Relative standard deviation of imputed heights above 1.37 m, 0 to 0.4; default 0.1. Deviations are truncated at two
   * standard deviations.
   */
  vtkSetMacro(HeightVariation, double);
  vtkGetMacro(HeightVariation, double);
  ///@}

  ///@{
  /**
   * Maximum number of diameter classes of each kind, 1 to 20; default 1. Classes have equally many trees, and a plant
   * each.
   */
  vtkSetMacro(DiameterClasses, int);
  vtkGetMacro(DiameterClasses, int);
  ///@}

  ///@{
  /**
   * Seed of the random numbers, any integer; default 1.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  /// Connects a table of species, port 1.
  void SetSpeciesConnection(vtkAlgorithmOutput* species) { this->SetInputConnection(1, species); }

  /// Removes the connection of port 1.
  void RemoveSpecies() { this->RemoveAllInputConnections(1); }

protected:
  vtkStandInventoryFilter();
  ~vtkStandInventoryFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int CoordinateUnit;
  int DiameterUnit;
  int HeightUnit;
  double CoordinateScale;
  char* XColumn;
  char* YColumn;
  char* SpeciesColumn;
  char* DiameterColumn;
  char* HeightColumn;
  char* PlotColumn;
  char* Plot;
  char* DefaultSpecies;
  bool KeepDead;
  bool AllowCoincident;
  bool AllowImplausible;
  double QuadraticMeanDiameter;
  double HeightVariation;
  int DiameterClasses;
  int Seed;

private:
  vtkStandInventoryFilter(const vtkStandInventoryFilter&) = delete;
  void operator=(const vtkStandInventoryFilter&) = delete;

  littoral::InventoryOptions Options() const;
};

#endif
