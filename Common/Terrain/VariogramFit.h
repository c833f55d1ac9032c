// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralVariogramFit_h
#define LittoralVariogramFit_h

#include "Numerics/Parallel.h"
#include "Terrain/CovarianceModels.h"
#include "Terrain/Variogram.h"

#include <functional>
#include <vector>

namespace littoral
{

class DetrendedWindow;

/// Options of the fit beside variance, range(s) and fractal dimension.
struct VariogramFitOptions
{
  bool Nugget = false;     ///< a jump at distance zero, as measurement noise makes it
  bool Anisotropy = false; ///< an ellipse of ranges; needs bins in several directions
  double MaximumRange =
    1e4; ///< [m], no model is given a longer one (Spherical: twice this): what is longer than the lags cannot be told
  double FractalRange = 1e4; ///< [m], largest wavelength of the fractal model, which no variogram can tell
  /**
   * The window that was measured, less its trend. With it the lags' semivariances are taken as those of the residual,
   * and the variance is no unknown: it is the one whose residual has the SampleVariance in the window. Without, the
   * lags are those of the field itself.
   */
  const DetrendedWindow* Window = nullptr;
  double SampleVariance = 1.0; ///< variance of the values less their trend [unit of the field squared]
  int Directions = 1;          ///< sectors of the lags; 1: all directions together
};

/// One model, fitted.
struct VariogramFit
{
  CovarianceParameters Field;
  double Nugget = 0.0;
  double AnisotropyRatio = 1.0; ///< longest over shortest range, >= 1; Field.Range is the longest
  double AnisotropyAngle = 0.0; ///< [rad] in [0, pi), direction of the longest range
  double WeightedSSE = 0.0;     ///< weighted sum of squared logarithms of (measured / model), mean weight 1
  double AICc = 0.0;            ///< corrected Akaike criterion of these residuals; smaller is better
  bool Converged = false;
  /// A range is at its bound or below a quarter of the shortest lag, or the fractal dimension is within 0.01 of 2 or 3:
  /// what the parameters are is decided by the bound, not by the data.
  bool AtBound = false;
};

/// Semivariance of the fitted model at a separation (x, y) [m].
double Semivariance(const VariogramFit& fit, double x, double y);

/// Covariance of the fitted model, nugget apart, at a separation (x, y) [m].
double Covariance(const VariogramFit& fit, double x, double y);

/// Mean of the model's semivariance over all directions at a distance [m].
double MeanSemivariance(const VariogramFit& fit, double distance);

/**
 * Fits one model by least squares of logarithms (Levenberg-Marquardt, several starts), which for small residuals is
 * Cressie's weighting by the model itself. Weights are pairs / lag^2: the many pairs of long lags tell little, as they
 * share the same few large structures. Bins of zero semivariance are passed over.
 */
VariogramFit FitVariogram(
  CovarianceModel model, const std::vector<LagBin>& bins, const VariogramFitOptions& options = {});

/**
 * Fits all models; best (smallest AICc) first, and those at a bound after the others. With options.Nugget all are
 * fitted without and with a nugget: the nuggets are kept where they lower the least AICc of all models by more
 * than 0.4 a lag. Each start of each fit is a task for a thread.
 */
std::vector<VariogramFit> FitAllModels(
  const std::vector<LagBin>& bins, const VariogramFitOptions& options = {}, const ParallelFor& parallelFor = SerialFor);

}

#endif
