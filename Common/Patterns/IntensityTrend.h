// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralIntensityTrend_h
#define LittoralIntensityTrend_h

#include "Patterns/IntensityRaster.h"
#include "Patterns/ObservationWindow.h"

#include <vector>

namespace littoral
{

/// Highest degree of a trend.
inline constexpr int MaximumTrendDegree = 3;

/// Log-linear intensity, ln lambda(x, y) = sum of Coefficients u^i v^j, i + j <= Degree, in the order 1, u, v, u^2, u
/// v, v^2, u^3 ..., with u and v from -1 to 1 over the bounding box of a window. Without coefficients there is no
/// trend.
struct IntensityTrend
{
  int Degree = 0;
  std::vector<double> Coefficients;

  bool Exists() const { return !this->Coefficients.empty(); }

  /// The intensity at a place of the window [1/m2].
  double At(const ObservationWindow& window, const PlanePosition& place) const;
};

/// Number of coefficients of a trend.
constexpr int TermsOfTrend(int degree)
{
  return (degree + 1) * (degree + 2) / 2;
}

/**
 * Fits the trend of the points of a window by the maximum of the Poisson likelihood, sum of ln lambda over the points -
 * integral of lambda, which is a composite likelihood of clustered points too (Schoenberg 2005; Waagepetersen 2007).
 * The integral is a sum over 128 by 128 cells of the bounding box. It has no coefficients where there is no maximum, as
 * with fewer points than coefficients.
 */
IntensityTrend FitTrend(const std::vector<PlanePosition>& points, const ObservationWindow& window, int degree);

/// Raster of a trend relative to its mean, constant on 128 by 128 cells of the bounding box; cells whose centers lie
/// outside of the window have the mean.
IntensityRaster RasterOf(const IntensityTrend& trend, const ObservationWindow& window);

}

#endif
