// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCovarianceFitFilter
 * @brief   compute the variogram of an image and fit seven covariance models to it
 *
 * Input: a vtkImageData of one layer with a scalar point array, typically the elevation [m] of a real terrain
 * (SetInputArrayToProcess; default the active scalars, which also stand in for an absent `Elevation`). NaN and, on
 * request, a no-data value are left out.
 *
 * Output 0: a vtkTable with a row per model, the best first and those at a bound last, as vtkTurningBandsTerrainSource
 * reads it. Columns: `Model` (name), `ModelId`, `Variance` [m^2], `Range` [m], `SecondRange` [m], `FractalDimension`
 * (NaN where a model has none), `Nugget` [m^2], `AnisotropyRatio`, `AnisotropyAngle` [rad], `Mean` [m], `SlopeX`,
 * `SlopeY` (the plane that was removed, with its height at the center of the grid), `TrendWidth`, `TrendHeight` [m]
 * (the rectangle over which it was removed; 0 where only the mean was), `VarianceDeviation` [m^2] (standard deviation
 * of SampleVariance between realizations of the model), `AtBound` (1 where a range is at MaximumRange or below a
 * quarter of the shortest lag, or the fractal dimension within 0.01 of 2 or 3: determined by a bound, not by the data),
 * `WeightedSSE`, `AICc`. Field data: `SampleVariance` [m^2] (of the residuals when the plane is removed),
 * `NumberOfValues`, `PeriodogramDimension` and `VariogramDimension` (fractal dimension from the slope of either, in [2,
 * 3], with its standard error; NaN where the slope determines none, as for smooth fields and noise); `GridExtent`,
 * `GridOrigin` and `GridSpacing` of the image; and its place on earth (vtkElevationReader), if it has one.
 *
 * Output 1: a vtkTable with a row per lag, ready for a line chart: `Lag` [m], `Semivariance` [m^2], `Pairs`, a column
 * per model, and a column per direction (`Semivariance_000`, `Semivariance_015`..., degrees from x) where anisotropy is
 * fitted.
 *
 * The variogram is exact, by Fourier transform, with exact numbers of pairs. Models are fitted by the
 * Levenberg-Marquardt method to logarithms of semivariances, as Setas et al. propose at the end of section 2.1.
 * Removing a plane also removes part of the variance of the field: the models are fitted to the variogram that is
 * expected after detrending, and Variance is the one for which the expected variance of the residuals is SampleVariance
 * less Nugget. AICc treats lags as independent, which they are not: use its differences for ranking, not as a test.
 *
 * An image of several layers, a property out of range or too few values are reported as one error.
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

  /// Lets no exception leave a request, as for want of memory: it becomes an error.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  ///@{
  /**
   * Maximum lag distance [m], not negative; default 0, half the shorter side of the image.
   */
  vtkSetMacro(MaximumLag, double);
  vtkGetMacro(MaximumLag, double);
  ///@}

  ///@{
  /**
   * Number of lag classes up to MaximumLag, 6 to 10000; default 40.
   */
  vtkSetMacro(NumberOfLags, int);
  vtkGetMacro(NumberOfLags, int);
  ///@}

  ///@{
  /**
   * Removal of a least-squares plane before the variogram is computed; default on. If off, the mean alone is removed.
   */
  vtkSetMacro(RemoveTrend, bool);
  vtkGetMacro(RemoveTrend, bool);
  vtkBooleanMacro(RemoveTrend, bool);
  ///@}

  ///@{
  /**
   * Estimation of a nugget, the discontinuity of the variogram at lag 0 due to measurement noise; default on. It is
   * kept, in all models, if it lowers the minimum AICc by more than 0.4 per lag class; otherwise Nugget is 0.
   */
  vtkSetMacro(FitNugget, bool);
  vtkGetMacro(FitNugget, bool);
  vtkBooleanMacro(FitNugget, bool);
  ///@}

  ///@{
  /**
   * Estimation of geometric anisotropy, an ellipse of ranges fitted to the directional variograms; default on.
   */
  vtkSetMacro(FitAnisotropy, bool);
  vtkGetMacro(FitAnisotropy, bool);
  vtkBooleanMacro(FitAnisotropy, bool);
  ///@}

  ///@{
  /**
   * Number of directional variograms over half a turn, 4 to 90; default 12. Used only with FitAnisotropy.
   */
  vtkSetMacro(NumberOfDirections, int);
  vtkGetMacro(NumberOfDirections, int);
  ///@}

  ///@{
  /**
   * Upper bound of the range of a model [m], not negative; default 0, MaximumLag. The bound of Spherical, whose range
   * ends the correlation, is twice this. A range beyond the lags cannot be distinguished from a trend.
   */
  vtkSetMacro(MaximumRange, double);
  vtkGetMacro(MaximumRange, double);
  ///@}

  ///@{
  /**
   * Longest wavelength of the Fractal model [m], not negative; default 0, four times the longer side of the image. No
   * variogram determines it.
   */
  vtkSetMacro(FractalWavelength, double);
  vtkGetMacro(FractalWavelength, double);
  ///@}

  ///@{
  /**
   * Exclusion of values equal to NoDataValue; default off. NaN is always excluded.
   */
  vtkSetMacro(UseNoDataValue, bool);
  vtkGetMacro(UseNoDataValue, bool);
  vtkBooleanMacro(UseNoDataValue, bool);
  ///@}

  ///@{
  /**
   * Value that marks missing data; default -9999. Used only with UseNoDataValue.
   */
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
  double MaximumRange;
  double FractalWavelength;
  bool UseNoDataValue;
  double NoDataValue;

private:
  vtkCovarianceFitFilter(const vtkCovarianceFitFilter&) = delete;
  void operator=(const vtkCovarianceFitFilter&) = delete;

  struct Detrended;

  void CheckProperties();
  vtkDataArray* FindArray(vtkImageData* image, vtkInformationVector** inputVector);
  void Detrend(vtkImageData* image, vtkDataArray* array, Detrended& field);
  littoral::VariogramFitOptions MakeOptions(
    const Detrended& field, const littoral::DetrendedWindow& window, double maximumLag);
};

#endif
