// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSemivarianceBands_h
#define LittoralSemivarianceBands_h

#include "Numerics/Parallel.h"
#include "Terrain/GridSamples.h"

#include <array>
#include <cstddef>
#include <vector>

namespace littoral
{

/// Factors of amplitudes.
struct BandGains
{
  std::vector<double> Rings; ///< gain of each ring of the spectrum
  std::array<double, 9>
    LongWaves{}; ///< gain of coefficient (i, j), i and j below 3, at 3 j + i, beside that of its ring
  double Plane = 1.0;
};

/**
 * Contributions of bands of waves of a field, and of its plane, to its semivariances along x and y. Each of the eight
 * longest waves is a band of its own; the others have rings of the spectrum, of which each band has a fourth more than
 * the one before.
 */
class SemivarianceBands
{
public:
  /// Bands of the coefficients of a cosine transform with so many rings of a width [cycles/m], and of a plane.
  SemivarianceBands(const GridSamples& coefficients, double step, std::size_t rings, const PlaneTrend& plane,
    const ParallelFor& parallel = SerialFor);

  /// Number of bands: long waves, rings, plane.
  std::size_t Count() const { return LongWaves + this->First.size() + 1; }

  /// Contribution of a band to the semivariance of a lag [cells]: half the mean squared difference of the pairs within
  /// the grid, summed over its waves.
  double PartOf(std::size_t band, int lag) const { return this->PartOf(band, lag, this->WavesOf(lag)); }

  /// Contribution of a band to the variance of the heights.
  double VarianceOf(std::size_t band) const;

  /// Gains after which semivariances are `wanted` times what they are at lags [cells] while the variance stays, as far
  /// as small changes suffice: least squares of the relative misfits, and of the changes of power times a weight.
  BandGains GainsFor(const std::vector<int>& lags, const std::vector<double>& wanted) const;

private:
  static constexpr std::size_t LongWaves = 8;

  /// Sums of squared differences of the waves along x and y at a lag.
  struct LagWaves
  {
    std::vector<double> OfX;
    std::vector<double> OfY;
  };

  LagWaves WavesOf(int lag) const;

  double PartOf(std::size_t band, int lag, const LagWaves& waves) const;

  bool IsPlane(std::size_t band) const { return band + 1 == this->Count(); }

  int Width;
  int Height;
  std::size_t Rings;
  std::array<double, 2> Fall;                ///< fall of the plane from cell to cell along x and y [m]
  std::vector<std::size_t> First;            ///< first ring of each band of rings
  std::vector<std::vector<double>> PowerOfX; ///< sums of squared coefficients of each band, by the wave along x
  std::vector<std::vector<double>> PowerOfY;
};

}

#endif
