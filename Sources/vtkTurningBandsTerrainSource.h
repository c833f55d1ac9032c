// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTurningBandsTerrainSource
 * @brief   grows a terrain of given statistics by the turning bands method
 *
 * Output: a vtkImageData of one layer with the float point array `Elevation` [m] and, on request, `Reflectance`
 * [0..1], and the number of lines as field data (see NumberOfLines). The elevation is a Gaussian random field with one
 * of seven covariance models (Setas et al., section 2.1, algorithm 1 and eqs. 1-5; spectra and covariances in
 * Documentation/design.md), stretched along one direction on request, on top of a mean and a tilt.
 *
 * The field is a function of position on the grid: any part of the extent, any number of threads or ranks gives the
 * same bytes.
 * With a ShortestWavelength of its own, a grid of twice, four times... the spacing holds every second, fourth...
 * value of the finer one, so that a coarse preview is a true one: the same bytes if that wavelength is below eight of
 * the finer spacings, else within 0.006 standard deviations.
 *
 * Optional input: a table of fits, as vtkCovarianceFitFilter writes it. Its first row then replaces Model,
 * StandardDeviation, Mean, Range, SecondRange, FractalDimension, AnisotropyRatio, AnisotropyAngle and Slope, column
 * by column where a column is there: measure a real place, grow one like it. The nugget is measurement noise and is
 * not grown. Where the columns TrendWidth and TrendHeight [m] are there and positive, the field's own least squares
 * plane, over a rectangle of these sides or the whole extent where that is longer, about the middle of the extent,
 * makes room for Mean and Slope: the twin's plane is then the place's, and its variance about it on average the
 * place's.
 *
 * @sa vtkCovarianceFitFilter
 */
#ifndef vtkTurningBandsTerrainSource_h
#define vtkTurningBandsTerrainSource_h

#include "LittoralSourcesModule.h" // for export macro
#include "vtkImageAlgorithm.h"

class vtkTable;

class LITTORALSOURCES_EXPORT vtkTurningBandsTerrainSource : public vtkImageAlgorithm
{
public:
  static vtkTurningBandsTerrainSource* New();
  vtkTypeMacro(vtkTurningBandsTerrainSource, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ModelType
  {
    Fractal = 0,
    SimpleExponential = 1,
    DoubleExponential = 2,
    Bessel1 = 3,
    Bessel2 = 4,
    Telis = 5,
    Spherical = 6,
  };

  enum HarmonicSpacingType
  {
    Adaptive = 0,
    Uniform = 1,
  };

  ///@{
  /**
   * First and last index of the grid along x, y and z; one layer only. Default 0 500 0 500 0 0, which with the default
   * spacing is a square of 1 km.
   */
  vtkSetVector6Macro(WholeExtent, int);
  vtkGetVector6Macro(WholeExtent, int);
  ///@}

  ///@{
  /// Position of index (0, 0, 0) [m]. Default 0 0 0.
  vtkSetVector3Macro(Origin, double);
  vtkGetVector3Macro(Origin, double);
  ///@}

  ///@{
  /// Distance of neighbouring points [m], positive. Default 2 2 1.
  vtkSetVector3Macro(Spacing, double);
  vtkGetVector3Macro(Spacing, double);
  ///@}

  ///@{
  /// Covariance model, a ModelType 0 to 6. Default Fractal.
  vtkSetMacro(Model, int);
  vtkGetMacro(Model, int);
  const char* GetModelAsString() const;
  void SetModelToFractal() { this->SetModel(Fractal); }
  void SetModelToSimpleExponential() { this->SetModel(SimpleExponential); }
  void SetModelToDoubleExponential() { this->SetModel(DoubleExponential); }
  void SetModelToBessel1() { this->SetModel(Bessel1); }
  void SetModelToBessel2() { this->SetModel(Bessel2); }
  void SetModelToTelis() { this->SetModel(Telis); }
  void SetModelToSpherical() { this->SetModel(Spherical); }
  ///@}

  ///@{
  /// Standard deviation of the elevation [m], not negative. Default 40.
  vtkSetMacro(StandardDeviation, double);
  vtkGetMacro(StandardDeviation, double);
  ///@}

  ///@{
  /// Mean elevation [m], at the middle of the extent. Default 200.
  vtkSetMacro(Mean, double);
  vtkGetMacro(Mean, double);
  ///@}

  ///@{
  /// Rise per metre along x and y of a plane that is added. Default 0 0.
  vtkSetVector2Macro(Slope, double);
  vtkGetVector2Macro(Slope, double);
  ///@}

  ///@{
  /**
   * Length scale of the model [m], positive: 1/b of the exponential and Bessel models, one of the two scales of Telis,
   * the distance where correlation ends for Spherical, the largest wavelength for Fractal. Along AnisotropyAngle where
   * the field is stretched. Default 1000.
   */
  vtkSetMacro(Range, double);
  vtkGetMacro(Range, double);
  ///@}

  ///@{
  /// The other scale of Telis [m], positive; of no effect in other models. Default 50.
  vtkSetMacro(SecondRange, double);
  vtkGetMacro(SecondRange, double);
  ///@}

  ///@{
  /// Fractal dimension D of the surface, between 2 (smooth) and 3 (both excluded), eq. 5; of no effect in other models.
  /// Default 2.15.
  vtkSetMacro(FractalDimension, double);
  vtkGetMacro(FractalDimension, double);
  ///@}

  ///@{
  /**
   * Number L of lines (eq. 1). 0: as many as the spectrum needs on the whole grid, 64 to 1024, such that no gaps
   * between their rays in it show as streaks (Documentation/design.md). The number is the integer in the output's field
   * data `ElevationLines` (and `ReflectanceLines`). Time grows with lines times points. Default 0.
   */
  vtkSetMacro(NumberOfLines, int);
  vtkGetMacro(NumberOfLines, int);
  ///@}

  ///@{
  /// Number M of harmonics on a line (eq. 3), positive. With HarmonicSpacing Uniform, at least twice as many
  /// as the grid's diagonal holds of the shortest wavelengths are needed. Default 300.
  vtkSetMacro(NumberOfHarmonics, int);
  vtkGetMacro(NumberOfHarmonics, int);
  ///@}

  ///@{
  /**
   * How the harmonics share the wave numbers: Adaptive puts half of them where the variance is and half evenly over the
   * octaves (Fractal: all over the octaves), Uniform is the paper's equal spacing. Default Adaptive.
   */
  vtkSetMacro(HarmonicSpacing, int);
  vtkGetMacro(HarmonicSpacing, int);
  ///@}

  ///@{
  /**
   * Finest detail [m], not negative: shorter wavelengths are left out, which makes a band-limited field. 0 leaves it
   * open: the points then sample a surface with detail of every size, and waves shorter than some six spacings are a
   * moving average of noise at the points in place of lines. Default 0.
   */
  vtkSetMacro(ShortestWavelength, double);
  vtkGetMacro(ShortestWavelength, double);
  ///@}

  ///@{
  /// Longest over shortest range, at least 1. Default 1.
  vtkSetMacro(AnisotropyRatio, double);
  vtkGetMacro(AnisotropyRatio, double);
  ///@}

  ///@{
  /// Direction of the longest range [degrees], counter-clockwise from x. Default 0.
  vtkSetMacro(AnisotropyAngle, double);
  vtkGetMacro(AnisotropyAngle, double);
  ///@}

  ///@{
  /// Any whole number; the same seed gives the same terrain. Default 1.
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /// Whether the point array `Reflectance` is added, an independent field of its own model. Default off.
  vtkSetMacro(Reflectance, bool);
  vtkGetMacro(Reflectance, bool);
  vtkBooleanMacro(Reflectance, bool);
  ///@}

  ///@{
  /// Covariance model of the reflectance, a ModelType; the second scale of Telis is a tenth of the first and the
  /// fractal dimension that of the elevation. Default SimpleExponential.
  vtkSetMacro(ReflectanceModel, int);
  vtkGetMacro(ReflectanceModel, int);
  ///@}

  ///@{
  /// Length scale of the reflectance [m], positive. Default 100.
  vtkSetMacro(ReflectanceRange, double);
  vtkGetMacro(ReflectanceRange, double);
  ///@}

  ///@{
  /// Mean of the reflectance, 0 to 1. Default 0.5.
  vtkSetMacro(ReflectanceMean, double);
  vtkGetMacro(ReflectanceMean, double);
  ///@}

  ///@{
  /// Standard deviation of the reflectance, not negative; values beyond 0 and 1 are cut. Default 0.15.
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
  int Model;
  double StandardDeviation;
  double Mean;
  double Slope[2];
  double Range;
  double SecondRange;
  double FractalDimension;
  int NumberOfLines;
  int NumberOfHarmonics;
  int HarmonicSpacing;
  double ShortestWavelength;
  double AnisotropyRatio;
  double AnisotropyAngle;
  int Seed;
  bool Reflectance;
  int ReflectanceModel;
  double ReflectanceRange;
  double ReflectanceMean;
  double ReflectanceStandardDeviation;

private:
  vtkTurningBandsTerrainSource(const vtkTurningBandsTerrainSource&) = delete;
  void operator=(const vtkTurningBandsTerrainSource&) = delete;

  class Recipe;
  Recipe ElevationRecipe() const;
  Recipe ReflectanceRecipe() const;
  bool TakeFit(vtkTable* fits, Recipe& recipe);
  bool CheckRecipe(Recipe& recipe);
  bool Grow(const Recipe& recipe, const int extent[6], double first, double last, float* values);
};

#endif
