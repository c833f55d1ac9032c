// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGroundStatisticsFilter
 * @brief   compute the statistics by which real ground differs from a random surface
 *
 * Input: a vtkImageData of one layer, at least 3 x 3, with a scalar point array, the elevation [m]
 * (SetInputArrayToProcess; default the active scalars, which also stand in for an absent `Elevation`), without missing
 * values and not constant. Each value is the height of a cell. Flow is routed to the neighbour of steepest descent of
 * eight (D8); outlets are the border and, with UseSeaLevel, the cells at or below SeaLevel.
 *
 * Output 0: a vtkTable of one row: `DepressionFraction` (cells in depressions, those that a priority-flood fills, over
 * all cells), `RelativeFillDepth` (mean fill depth of all cells over the standard deviation of the heights),
 * `HypsometricIntegral` ((mean - minimum)/(maximum - minimum)), `ElevationSkewness`, `ElevationStandardDeviation` [m],
 * `MeanSlope` [m/m] and `SlopeSkewness` (size of the gradient by central differences), `CurvatureStandardDeviation`
 * [1/m] and `CurvatureSkewness` (five-point Laplacian of inner cells, above 0 in valleys), `Concavity` and `Steepness`
 * (S = Steepness A^-Concavity, S the slope to the receiver, A [m^2]; see output 1), `HackExponent` (longest flow length
 * over A), `BifurcationRatio`, `LengthRatio` and `AreaRatio` (Horton's R_B, R_L, R_A; see output 3), `ThresholdSlope`
 * [m/m] (that a hundredth of the cells exceeds), `HeadArea` [m^2] (drainage area at which channels begin, where
 * the plateau of hillslopes and the power law of channels meet), `ChannelHeads` (their number) and `DrainageDensity`
 * [1/m] (length of channels over the area). NaN where the grid is too small for a number, of channels also where
 * hillslopes are shorter than cells. Hack's exponent and Horton's ratios hardly tell a random surface from real
 * ground.
 *
 * Output 1: a vtkTable with a row per bin of drainage area, 20 of equal ratio from 100 cells to a tenth of the grid:
 * `DrainageArea` [m^2], `Slope` [m/m] (mean; 0 on flats and in depressions), `PowerLaw` [m/m], `Cells`. Output 2: a
 * vtkTable of the distributions with 101 rows: `Fraction` of the cells below, `Elevation` [m], `Slope` [m/m],
 * `Curvature` [1/m]. Output 3: a vtkTable with a row per Strahler order: `Order`, `Streams`, `MeanLength` [m],
 * `MeanArea` [m^2]. Output 4: a vtkTable of geomorphons (Jasiewicz & Stepinski 2013) with a row per form: `Form` (1 to
 * 10, as of r.geomorphon of GRASS), `Name`, `Share` of the inner cells. Output 5: a vtkTable of the relief beside
 * streams with a row per distance, 1 to 10 cells: mean `Distance` [m] to the stream cell that cells drain to, mean `Height`
 * above it [m], `Cells`.
 *
 * The whole image is requested, and some 100 bytes of memory for each of its points. Piece 0 holds the whole tables,
 * other pieces are empty. A bad input or property is reported as one error.
 *
 * @sa vtkCovarianceFitFilter
 */
#ifndef vtkGroundStatisticsFilter_h
#define vtkGroundStatisticsFilter_h

#include "LittoralFiltersModule.h" // for export macro
#include "vtkTableAlgorithm.h"

class LITTORALFILTERS_EXPORT vtkGroundStatisticsFilter : public vtkTableAlgorithm
{
public:
  static vtkGroundStatisticsFilter* New();
  vtkTypeMacro(vtkGroundStatisticsFilter, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Lets no exception leave a request, as for want of memory: it becomes an error.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  ///@{
  /**
   * Flow accumulation at which streams begin [cells], 2 to 10^9; default 100. Also the smallest drainage area of Hack's
   * law.
   */
  vtkSetMacro(StreamThreshold, int);
  vtkGetMacro(StreamThreshold, int);
  ///@}

  ///@{
  /**
   * Outlets wherever the ground is at or below SeaLevel, besides those at the border; default off.
   */
  vtkSetMacro(UseSeaLevel, bool);
  vtkGetMacro(UseSeaLevel, bool);
  vtkBooleanMacro(UseSeaLevel, bool);
  ///@}

  ///@{
  /**
   * Height of the sea [m], a finite number; default 0. Used only with UseSeaLevel.
   */
  vtkSetMacro(SeaLevel, double);
  vtkGetMacro(SeaLevel, double);
  ///@}

  ///@{
  /**
   * Radius of the search for geomorphons [cells of the longer spacing], 1 to 10000; default 10. Lines of sight end
   * before it.
   */
  vtkSetMacro(SearchRadius, int);
  vtkGetMacro(SearchRadius, int);
  ///@}

  ///@{
  /**
   * Angle above or below the horizon up to which lines of sight of geomorphons are level [degrees], 0 to 45; default 1.
   */
  vtkSetMacro(Flatness, double);
  vtkGetMacro(Flatness, double);
  ///@}

protected:
  vtkGroundStatisticsFilter();
  ~vtkGroundStatisticsFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int StreamThreshold;
  bool UseSeaLevel;
  double SeaLevel;
  int SearchRadius;
  double Flatness;

private:
  vtkGroundStatisticsFilter(const vtkGroundStatisticsFilter&) = delete;
  void operator=(const vtkGroundStatisticsFilter&) = delete;
};

#endif
