// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTurningBandsTerrainSource
 * @brief   generate a terrain of given statistics by the turning bands method
 *
 * Output: a vtkImageData of one layer with the float point array `Elevation` [m], optionally `Reflectance` (0 to 1),
 * and the number of lines as field data (see NumberOfLines). The elevation is a Gaussian random field with one of seven
 * covariance models (Setas et al., section 2.1, algorithm 1 and eqs. 1-5; spectra and covariances in
 * Documentation/design/terrain.md), with optional geometric anisotropy, added to a mean and a linear trend.
 *
 * The field is a function of the position on the grid: any subextent and any number of threads or ranks give the same
 * bytes. With a MinimumWavelength above 0, grids of 2, 4, 8 ... times the spacing hold every 2nd, 4th, 8th ... value
 * of the finer grid, so that a coarse preview is exact: to the byte if that wavelength is below eight of the finer
 * spacings, else within 0.006 standard deviations.
 *
 * Optional input: a vtkTable of fits from vtkCovarianceFitFilter. Its first row then replaces Model, StandardDeviation,
 * Mean, Range, SecondRange, FractalDimension, AnisotropyRatio, AnisotropyAngle and Slope, each where the table has its
 * column, so that the output is a statistical twin of a measured terrain. The nugget is measurement noise and is not
 * simulated. Where the columns TrendWidth and TrendHeight [m] are present and positive, the least-squares plane of the
 * simulated field, over a rectangle of these sides or the whole extent where that is longer, centered on the extent, is
 * replaced by Mean and Slope: the twin then has the trend of the measured terrain and, on average, its variance about
 * the trend.
 *
 * With UseMeasuredGrid the output is on the grid that was measured, and has its place on earth (field data
 * `CoordinateSystem`, `CoordinateUnit` and `CoordinateOffset`, see vtkElevationReader).
 *
 * A parameter out of range, an extent of several layers or a table without a row is reported as one error.
 *
 * @sa vtkCovarianceFitFilter
 */
#ifndef vtkTurningBandsTerrainSource_h
#define vtkTurningBandsTerrainSource_h

#include "LittoralSourcesModule.h" // for export macro
#include "vtkRandomFieldAlgorithm.h"

#include <string> // for reasons

class vtkTable;

class LITTORALSOURCES_EXPORT vtkTurningBandsTerrainSource : public vtkRandomFieldAlgorithm
{
public:
  static vtkTurningBandsTerrainSource* New();
  vtkTypeMacro(vtkTurningBandsTerrainSource, vtkRandomFieldAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum HarmonicSpacingType
  {
    Adaptive = 0,
    Uniform = 1,
  };

  ///@{
  /**
   * First and last index of the grid along x, y and z, with a single layer along z; default 0 500 0 500 0 0. With the
   * default spacing it is a square of 1 km.
   */
  vtkSetVector6Macro(WholeExtent, int);
  vtkGetVector6Macro(WholeExtent, int);
  ///@}

  ///@{
  /**
   * Position of index (0, 0, 0) [m]; default 0 0 0.
   */
  vtkSetVector3Macro(Origin, double);
  vtkGetVector3Macro(Origin, double);
  ///@}

  ///@{
  /**
   * Distance between neighboring points along x, y and z [m], positive along x and y; default 2 2 1.
   */
  vtkSetVector3Macro(Spacing, double);
  vtkGetVector3Macro(Spacing, double);
  ///@}

  ///@{
  /**
   * Use of the measured grid and of its place on earth in place of WholeExtent, Origin and Spacing; default off. Used
   * only with a table of fits, which must name them.
   */
  vtkSetMacro(UseMeasuredGrid, bool);
  vtkGetMacro(UseMeasuredGrid, bool);
  vtkBooleanMacro(UseMeasuredGrid, bool);
  ///@}

  ///@{
  /**
   * Gradient of the linear trend along x and y [m/m]; default 0 0.
   */
  vtkSetVector2Macro(Slope, double);
  vtkGetVector2Macro(Slope, double);
  ///@}

  ///@{
  /**
   * Number M of harmonics per line (eq. 3), positive; default 300. If HarmonicSpacing is Uniform, it should be at least
   * twice the number of shortest wavelengths along the diagonal of the grid.
   */
  vtkSetMacro(NumberOfHarmonics, int);
  vtkGetMacro(NumberOfHarmonics, int);
  ///@}

  ///@{
  /**
   * Distribution of the harmonics over the wave numbers, a HarmonicSpacingType; default Adaptive. Adaptive: half of
   * them by variance and half evenly over the octaves (Fractal: all over the octaves). Uniform: the equal spacing of
   * the paper.
   */
  vtkSetMacro(HarmonicSpacing, int);
  vtkGetMacro(HarmonicSpacing, int);
  void SetHarmonicSpacingToAdaptive() { this->SetHarmonicSpacing(Adaptive); }
  void SetHarmonicSpacingToUniform() { this->SetHarmonicSpacing(Uniform); }
  ///@}

  ///@{
  /**
   * Minimum wavelength of a band-limited field [m], not negative; default 0, no limit. Without a limit the points
   * sample a surface with detail at all scales, and waves shorter than about six spacings are simulated as a moving
   * average of noise at the points instead of lines.
   */
  vtkSetMacro(MinimumWavelength, double);
  vtkGetMacro(MinimumWavelength, double);
  ///@}

  ///@{
  /**
   * Addition of the point array `Reflectance`, an independent random field with its own model; default off.
   */
  vtkSetMacro(Reflectance, bool);
  vtkGetMacro(Reflectance, bool);
  vtkBooleanMacro(Reflectance, bool);
  ///@}

  ///@{
  /**
   * Covariance model of the reflectance, a ModelType; default SimpleExponential. The second range of Telis is a tenth
   * of ReflectanceRange, and the fractal dimension is that of the elevation.
   */
  vtkSetMacro(ReflectanceModel, int);
  vtkGetMacro(ReflectanceModel, int);
  LITTORAL_SET_TO_MODELS(ReflectanceModel);
  ///@}

  ///@{
  /**
   * Range parameter of the reflectance [m], positive; default 100.
   */
  vtkSetMacro(ReflectanceRange, double);
  vtkGetMacro(ReflectanceRange, double);
  ///@}

  ///@{
  /**
   * Mean reflectance, a finite number, typically 0 to 1; default 0.5.
   */
  vtkSetMacro(ReflectanceMean, double);
  vtkGetMacro(ReflectanceMean, double);
  ///@}

  ///@{
  /**
   * Standard deviation of the reflectance, 0, or from 1e-15 to 3e7; default 0.15. Values below 0 and above 1 are
   * clamped.
   */
  vtkSetMacro(ReflectanceStandardDeviation, double);
  vtkGetMacro(ReflectanceStandardDeviation, double);
  ///@}

protected:
  vtkTurningBandsTerrainSource();
  ~vtkTurningBandsTerrainSource() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int WholeExtent[6];
  double Origin[3];
  double Spacing[3];
  bool UseMeasuredGrid;
  double Slope[2];
  int NumberOfHarmonics;
  int HarmonicSpacing;
  double MinimumWavelength;
  bool Reflectance;
  int ReflectanceModel;
  double ReflectanceRange;
  double ReflectanceMean;
  double ReflectanceStandardDeviation;

private:
  vtkTurningBandsTerrainSource(const vtkTurningBandsTerrainSource&) = delete;
  void operator=(const vtkTurningBandsTerrainSource&) = delete;

  class Recipe;
  /// The grid of the output, known after RequestInformation().
  struct TerrainGrid
  {
    int WholeExtent[6];
    double Origin[3];
    double Spacing[3];
  };
  TerrainGrid Grid;
  /// Sets the grid by the properties or by a measured one; empty if it can be used, else the reason.
  std::string TakeGrid(vtkInformationVector* fits);
  Recipe ElevationRecipe() const;
  Recipe ReflectanceRecipe() const;
  void TakeFit(vtkTable* fits, Recipe& recipe);
  void CheckRecipe(Recipe& recipe);
  void CheckMemory(const int extent[6]);
  /// Adds arrays of the elevation and, where it is asked for, of the reflectance. Throws Aborted.
  void GrowAll(const Recipe& elevation, const Recipe& reflectance, const int extent[6], vtkImageData* output);
  void Grow(const Recipe& recipe, const int extent[6], double first, double last, float* values);
};

#endif
