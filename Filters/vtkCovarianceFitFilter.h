// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCovarianceFitFilter
 * @brief   measures the variogram of an image and fits seven covariance models to it
 *
 * Input: a vtkImageData of one layer with a scalar point array (SetInputArrayToProcess; default the active scalars),
 * typically the elevation [m] of a real place. NaN and, on request, a no-data value are left out.
 *
 * Output 0: a vtkTable, a row a model, best first and those at a bound last, as vtkTurningBandsTerrainSource takes it.
 * Columns: `Model` (name), `ModelId`, `Variance` [m^2], `Range` [m], `SecondRange` [m], `FractalDimension` (NaN where a
 * model has none), `Nugget` [m^2], `AnisotropyRatio`, `AnisotropyAngle` [rad], `Mean` [m], `SlopeX`, `SlopeY` (the
 * plane that was removed, with its height at the grid's middle), `TrendWidth`, `TrendHeight` [m] (the rectangle over
 * which it was removed; 0 where it was the mean alone), `VarianceDeviation` [m^2] (standard deviation of SampleVariance
 * from one realisation of the model to the next), `AtBound` (1 where a range stands at LongestRange or below a quarter
 * of the shortest lag, or the fractal dimension within 0.01 of 2 or 3: a bound decided, not the data), `WeightedSSE`,
 * `AICc`. Field data: `SampleVariance` [m^2] (of what remains when the plane is removed), `NumberOfValues`,
 * `PeriodogramDimension` and `VariogramDimension` (fractal dimension from the slope of either, in [2, 3], with its
 * standard error; NaN where the slope tells none, as of smooth fields and noise).
 *
 * Output 1: a vtkTable, a row a lag: `Lag` [m], `Semivariance` [m^2], `Pairs`, one column a model, and one a direction
 * (`Semivariance_000`, `Semivariance_015`..., degrees from x) where anisotropy is fitted. Ready for a line chart.
 *
 * The variogram is exact, by Fourier transform, with exact pair counts. Models are fitted by Levenberg-Marquardt to
 * logarithms of semivariances, as Setas et al. propose at the end of section 2.1. A plane that is removed takes part of
 * the field's variance with it: models are fitted to what they are expected to show when their plane is gone, and
 * Variance is the one at which that leaves SampleVariance in the place, less Nugget. The criterion AICc treats lags as
 * independent, which they are not: take differences as an order, not as a test.
 *
 * @sa vtkTurningBandsTerrainSource
 */
#ifndef vtkCovarianceFitFilter_h
#define vtkCovarianceFitFilter_h

#include "LittoralFiltersModule.h" // for export macro
#include "vtkTableAlgorithm.h"

class vtkDataArray;
class vtkImageData;

namespace littoral
{
class DetrendedWindow;
struct VariogramFitOptions;
}

class LITTORALFILTERS_EXPORT vtkCovarianceFitFilter : public vtkTableAlgorithm
{
public:
  static vtkCovarianceFitFilter* New();
  vtkTypeMacro(vtkCovarianceFitFilter, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Longest distance of pairs [m], not negative; 0: half the shorter side. Default 0.
  vtkSetMacro(MaximumLag, double);
  vtkGetMacro(MaximumLag, double);
  ///@}

  ///@{
  /// Number of distance classes up to MaximumLag, 6 to 10000. Default 40.
  vtkSetMacro(NumberOfLags, int);
  vtkGetMacro(NumberOfLags, int);
  ///@}

  ///@{
  /// Whether a plane is fitted and removed first; else the mean alone. Default on.
  vtkSetMacro(RemoveTrend, bool);
  vtkGetMacro(RemoveTrend, bool);
  vtkBooleanMacro(RemoveTrend, bool);
  ///@}

  ///@{
  /// Whether a jump of the variogram at distance zero (measurement noise) is looked for. It is kept, in all models,
  /// where it lowers the least AICc by more than 0.4 for each class of lags; else Nugget is 0. Default on.
  vtkSetMacro(FitNugget, bool);
  vtkGetMacro(FitNugget, bool);
  vtkBooleanMacro(FitNugget, bool);
  ///@}

  ///@{
  /// Whether an ellipse of ranges is fitted to the variograms of NumberOfDirections directions. Default on.
  vtkSetMacro(FitAnisotropy, bool);
  vtkGetMacro(FitAnisotropy, bool);
  vtkBooleanMacro(FitAnisotropy, bool);
  ///@}

  ///@{
  /// Number of directions over half a turn, 4 to 90. Default 12.
  vtkSetMacro(NumberOfDirections, int);
  vtkGetMacro(NumberOfDirections, int);
  ///@}

  ///@{
  /**
   * No model is given a longer range than this [m], not negative; Spherical, whose range is where correlation ends, no
   * more than twice this. 0: MaximumLag. What is longer than the lags looks like one more trend and cannot be
   * told. Default 0.
   */
  vtkSetMacro(LongestRange, double);
  vtkGetMacro(LongestRange, double);
  ///@}

  ///@{
  /// Largest wavelength of the Fractal model [m], not negative, which no variogram tells; 0: four times the longer
  /// side. Default 0.
  vtkSetMacro(FractalWavelength, double);
  vtkGetMacro(FractalWavelength, double);
  ///@}

  ///@{
  /// Whether values equal to NoDataValue are missing ones. Default off.
  vtkSetMacro(UseNoDataValue, bool);
  vtkGetMacro(UseNoDataValue, bool);
  vtkBooleanMacro(UseNoDataValue, bool);
  ///@}

  ///@{
  /// The value that marks a missing one. Default -9999.
  vtkSetMacro(NoDataValue, double);
  vtkGetMacro(NoDataValue, double);
  ///@}

protected:
  vtkCovarianceFitFilter();
  ~vtkCovarianceFitFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double MaximumLag;
  int NumberOfLags;
  bool RemoveTrend;
  bool FitNugget;
  bool FitAnisotropy;
  int NumberOfDirections;
  double LongestRange;
  double FractalWavelength;
  bool UseNoDataValue;
  double NoDataValue;

private:
  vtkCovarianceFitFilter(const vtkCovarianceFitFilter&) = delete;
  void operator=(const vtkCovarianceFitFilter&) = delete;

  struct Detrended;

  bool CheckProperties();
  vtkDataArray* FindArray(vtkImageData* image, vtkInformationVector** inputVector);
  bool Detrend(vtkImageData* image, vtkDataArray* array, Detrended& field);
  littoral::VariogramFitOptions MakeOptions(
    const Detrended& field, const littoral::DetrendedWindow& window, double maximumLag) const;
};

#endif
