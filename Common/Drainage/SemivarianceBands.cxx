// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drainage/SemivarianceBands.h"

#include "Numerics/Constants.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace littoral
{

namespace
{

/// Weight of the squared changes of power against the squared relative misfits of the semivariances.
constexpr double ChangeWeight = 0.02;

/// Changes of a band's power in one go.
constexpr double MinimumChange = -0.6;
constexpr double MaximumChange = 1.5;

/// Rows of a block of sums.
constexpr std::size_t RowsAtOnce = 64;

/// Sum of (f_(i+h) - f_i)^2 over the pairs of a line for f_i = sqrt(2 / N) cos(pi p (i + 1/2) / N).
double SquaredDifferences(int wave, int lag, int length)
{
  if (wave == 0 || lag >= length)
  {
    return 0.0;
  }
  // (8 / N) sin^2(pi p h / 2N) ((N - h) / 2 + sin(pi p h / N) / (2 sin(pi p / N)))
  const double turn = Pi * wave / length;
  const double half = std::sin(0.5 * turn * lag);
  return 4.0 / length * half * half * (length - lag + std::sin(turn * lag) / std::sin(turn));
}

}

SemivarianceBands::SemivarianceBands(
  const GridSamples& coefficients, double step, std::size_t rings, const PlaneTrend& plane, const ParallelFor& parallel)
  : Width(coefficients.Width)
  , Height(coefficients.Height)
  , Rings(rings)
  , Fall{ plane.Slope[0] * coefficients.Spacing[0], plane.Slope[1] * coefficients.Spacing[1] }
{
  std::vector<std::size_t> bandOf(rings, 0);
  for (std::size_t ring = 1; ring < rings; ring += std::max<std::size_t>(1, ring / 4))
  {
    this->First.push_back(ring);
  }
  for (std::size_t ring = 1, band = 0; ring < rings; ++ring)
  {
    band += band + 1 < this->First.size() && ring >= this->First[band + 1];
    bandOf[ring] = band;
  }
  const std::size_t bands = LongWaves + this->First.size();
  this->PowerOfX.assign(bands, std::vector<double>(this->Width, 0.0));
  this->PowerOfY.assign(bands, std::vector<double>(this->Height, 0.0));
  // Sums of blocks of rows, then over the blocks in order: whatever the threads.
  const auto height = static_cast<std::size_t>(this->Height);
  const auto width = static_cast<std::size_t>(this->Width);
  const std::size_t blocks = (height + RowsAtOnce - 1) / RowsAtOnce;
  std::vector<std::vector<double>> sums(blocks);
  parallel(blocks, [&](std::size_t begin, std::size_t end) {
    for (std::size_t block = begin; block < end; ++block)
    {
      sums[block].assign(bands * width, 0.0);
      for (std::size_t j = block * RowsAtOnce; j < std::min(height, (block + 1) * RowsAtOnce); ++j)
      {
        const double y = static_cast<double>(j) / (2.0 * this->Height * coefficients.Spacing[1] * step);
        for (std::size_t i = 0; i < width; ++i)
        {
          const double x = static_cast<double>(i) / (2.0 * this->Width * coefficients.Spacing[0] * step);
          const auto ring = static_cast<std::size_t>(std::sqrt(x * x + y * y) + 0.5);
          const double c = coefficients.Values[j * width + i];
          const std::size_t wave = 3 * j + i;
          const std::size_t band =
            i < 3 && j < 3 ? std::max<std::size_t>(wave, 1) - 1 : LongWaves + bandOf[std::min(ring, this->Rings - 1)];
          sums[block][band * width + i] += c * c;
          this->PowerOfY[band][j] += c * c;
        }
      }
    }
  });
  for (std::size_t block = 0; block < blocks; ++block)
  {
    for (std::size_t n = 0; n < bands * width; ++n)
    {
      this->PowerOfX[n / width][n % width] += sums[block][n];
    }
  }
}

SemivarianceBands::LagWaves SemivarianceBands::WavesOf(int lag) const
{
  LagWaves waves;
  for (int p = 0; p < this->Width; ++p)
  {
    waves.OfX.push_back(SquaredDifferences(p, lag, this->Width));
  }
  for (int q = 0; q < this->Height; ++q)
  {
    waves.OfY.push_back(SquaredDifferences(q, lag, this->Height));
  }
  return waves;
}

double SemivarianceBands::PartOf(std::size_t band, int lag, const LagWaves& waves) const
{
  const double alongX = static_cast<double>(std::max(0, this->Width - lag)) * this->Height;
  const double alongY = static_cast<double>(std::max(0, this->Height - lag)) * this->Width;
  double sum = 0.0;
  if (this->IsPlane(band))
  {
    sum = lag * lag * (this->Fall[0] * this->Fall[0] * alongX + this->Fall[1] * this->Fall[1] * alongY);
  }
  else
  {
    for (int p = 0; p < this->Width; ++p)
    {
      sum += this->PowerOfX[band][p] * waves.OfX[p];
    }
    for (int q = 0; q < this->Height; ++q)
    {
      sum += this->PowerOfY[band][q] * waves.OfY[q];
    }
  }
  const double pairs = alongX + alongY;
  return pairs > 0.0 ? 0.5 * sum / pairs : 0.0;
}

double SemivarianceBands::VarianceOf(std::size_t band) const
{
  if (this->IsPlane(band))
  {
    const auto ofLine = [](double fall, double length) { return fall * fall * (length * length - 1.0) / 12.0; };
    return ofLine(this->Fall[0], this->Width) + ofLine(this->Fall[1], this->Height);
  }
  const std::vector<double>& power = this->PowerOfY[band];
  return std::accumulate(power.begin(), power.end(), 0.0) / (static_cast<double>(this->Width) * this->Height);
}

BandGains SemivarianceBands::GainsFor(const std::vector<int>& lags, const std::vector<double>& wanted) const
{
  const auto bands = static_cast<Eigen::Index>(this->Count());
  Eigen::RowVectorXd variances(bands);
  for (Eigen::Index band = 0; band < bands; ++band)
  {
    variances(band) = this->VarianceOf(band);
  }
  variances /= variances.sum();
  Eigen::MatrixXd parts = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(lags.size()), bands);
  Eigen::VectorXd missing = Eigen::VectorXd::Zero(parts.rows());
  for (Eigen::Index n = 0; n < parts.rows(); ++n)
  {
    if (!(wanted[n] > 0.0))
    {
      continue; // the target has no such lag
    }
    const LagWaves waves = this->WavesOf(lags[n]);
    for (Eigen::Index band = 0; band < bands; ++band)
    {
      parts(n, band) = this->PartOf(band, lags[n], waves);
    }
    // What all bands gain together is taken back by the heights, whose variance stays.
    parts.row(n) = parts.row(n) / parts.row(n).sum() - variances;
    missing(n) = wanted[n] - 1.0;
  }
  // (P^T P + w I) x = P^T (wanted - 1), amplitudes times sqrt(1 + x)
  const Eigen::MatrixXd normal = parts.transpose() * parts + ChangeWeight * Eigen::MatrixXd::Identity(bands, bands);
  const Eigen::VectorXd changes = normal.ldlt().solve(parts.transpose() * missing);
  const auto gainOf = [&](std::size_t band) {
    return std::sqrt(1.0 + std::clamp(changes(static_cast<Eigen::Index>(band)), MinimumChange, MaximumChange));
  };
  BandGains gains;
  gains.Rings.assign(this->Rings, 1.0);
  for (std::size_t band = 0; band < this->First.size(); ++band)
  {
    const auto first = gains.Rings.begin() + static_cast<std::ptrdiff_t>(this->First[band]);
    std::fill(first, gains.Rings.end(), gainOf(LongWaves + band));
  }
  gains.LongWaves[0] = 1.0;
  for (std::size_t wave = 1; wave <= LongWaves; ++wave)
  {
    gains.LongWaves[wave] = gainOf(wave - 1);
  }
  gains.Plane = gainOf(this->Count() - 1);
  return gains;
}

}
