// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Terrain/ShortWaves.h"

#include "Numerics/Constants.h"
#include "Numerics/FourierGrid.h"
#include "Numerics/SimdClones.h"

#include <boost/math/interpolators/cardinal_quintic_b_spline.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/bessel.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace littoral
{

namespace
{

/// Radius of the moving average, in mean spacings.
constexpr double AverageRadius = 7.0;
/// Beyond this distance, in mean spacings, short waves are uncorrelated.
constexpr double CorrelationRadius = 16.0;
/// The mean spacing is at most this many times the smaller one [metres in space], which bounds the average's size.
constexpr double MostStretch = 10.0;

double Length(const std::array<double, 2>& a)
{
  return std::hypot(a[0], a[1]);
}

/// Area that belongs to a point [m2].
double CellArea(const PlaneLattice& lattice)
{
  return std::abs(lattice.StepX[0] * lattice.StepY[1] - lattice.StepX[1] * lattice.StepY[0]);
}

/// Mean spacing of the points: root of the area that belongs to one [m].
double MeanSpacing(const PlaneLattice& lattice)
{
  const double area = CellArea(lattice);
  const double shorter = std::min(Length(lattice.StepX), Length(lattice.StepY));
  return std::min(std::sqrt(area), MostStretch * shorter);
}

using Gauss = boost::math::quadrature::gauss<double, 15>;

/// Places and weights of a quadrature over [low, high], panel by panel.
struct Quadrature
{
  std::vector<double> Place;
  std::vector<double> Weight;

  void AddPanel(double low, double high)
  {
    const double middle = 0.5 * (low + high);
    const double half = 0.5 * (high - low);
    for (std::size_t n = 0; n < Gauss::abscissa().size(); ++n)
    {
      for (double side : { -1.0, 1.0 })
      {
        if (Gauss::abscissa()[n] > 0.0 || side > 0.0)
        {
          this->Place.push_back(middle + side * half * Gauss::abscissa()[n]);
          this->Weight.push_back(half * Gauss::weights()[n]);
        }
      }
    }
  }
};

/// The covariance of the long waves at distance 0 less that at r, in parts of the variance.
class LongDecay
{
public:
  LongDecay(const CovarianceParameters& field, const Crossover& crossover)
  {
    const double cut = LowestWaveNumber(field);
    const double lowest = cut > 0.0 ? cut : 1e-4 * crossover.Low;
    double octave = lowest;
    while (octave < crossover.Low)
    {
      this->Waves.AddPanel(octave, std::min(2.0 * octave, crossover.Low));
      octave *= 2.0;
    }
    const double first = std::max(lowest, crossover.Low);
    for (int panel = 0; panel < 4 && first < crossover.High; ++panel)
    {
      const double width = 0.25 * (crossover.High - first);
      this->Waves.AddPanel(first + panel * width, first + (panel + 1) * width);
    }
    for (std::size_t n = 0; n < this->Waves.Place.size(); ++n)
    {
      const double w = this->Waves.Place[n];
      this->Waves.Weight[n] *= RadialSpectrum(field, w) * crossover.LongPart(w);
    }
  }

  double At(double r) const
  {
    double sum = 0.0;
    for (std::size_t n = 0; n < this->Waves.Place.size(); ++n)
    {
      // C(0) - C(r) = integral of f W (1 - J_0(w r)) dw
      sum += this->Waves.Weight[n] * (1.0 - boost::math::cyl_bessel_j(0, this->Waves.Place[n] * r));
    }
    return sum;
  }

private:
  Quadrature Waves;
};

/// Covariance of the short waves, the model's less that of the long waves, in parts of the variance.
class ShortCovariance
{
public:
  ShortCovariance(const CovarianceParameters& field, const PlaneLattice& lattice, const Crossover& crossover)
    : Unit(WithUnitVariance(field))
    , End(CorrelationRadius * MeanSpacing(lattice))
    , Decay(DecayUpTo(this->End, LongDecay(this->Unit, crossover)))
    , Variance(1.0 - crossover.LongBelow(this->Unit, crossover.High))
  {
  }

  double GetVariance() const { return this->Variance; }

  double At(double r) const
  {
    // C_short(r) = C(r) - C_long(r) = (C_long(0) - C_long(r)) - gamma(r) + C_short(0)
    return r < this->End ? this->Decay(r) - Semivariance(this->Unit, r) + this->Variance : 0.0;
  }

  /// Samples the covariance at the points of a lattice, with the indices of a discrete transform.
  void Sample(const PlaneLattice& lattice, FourierGrid& grid) const
  {
    const int width = grid.GetWidth();
    const int height = grid.GetHeight();
    const auto signedIndex = [](int index, int length) { return index > length / 2 ? index - length : index; };
    for (int j = 0; j < height; ++j)
    {
      for (int i = 0; i < width; ++i)
      {
        grid.At(i, j) = this->At(lattice.Distance(signedIndex(i, width), signedIndex(j, height)));
      }
    }
  }

private:
  using Spline = boost::math::interpolators::cardinal_quintic_b_spline<double>;

  CovarianceParameters Unit; ///< of variance 1
  double End;                ///< beyond which it is 0 [m]
  Spline Decay;              ///< C_long(0) - C_long(r)
  double Variance;           ///< C_short(0)

  static CovarianceParameters WithUnitVariance(CovarianceParameters field)
  {
    field.Variance = 1.0;
    return field;
  }

  static Spline DecayUpTo(double end, const LongDecay& decay)
  {
    constexpr int samples = 65;
    const double step = end / (samples - 1);
    std::vector<double> decays(samples);
    for (int n = 0; n < samples; ++n)
    {
      decays[n] = decay.At(n * step);
    }
    return Spline(decays, 0.0, step, { 0.0, 0.0 });
  }
};

/// Replaces a covariance by the weights of a moving average: its transform is the spectrum with all that folds back,
/// whose root is the transform of the weights.
void TakeRootOfSpectrum(FourierGrid& grid)
{
  grid.Forward();
  for (int j = 0; j < grid.GetHeight(); ++j)
  {
    for (int i = 0; i < grid.GetWidth(); ++i)
    {
      grid.At(i, j) = std::sqrt(std::max(0.0, grid.At(i, j).real()));
    }
  }
  grid.Backward();
}

// -------------------------------------------------------------------------------------------------------------------
// White noise. Four columns share a counter of Philox, the row is its object, beyond the numbers of all lines.

constexpr int PackSize = 8;
using FloatPack = float __attribute__((vector_size(PackSize * sizeof(float))));
using IntegerPack = std::int32_t __attribute__((vector_size(PackSize * sizeof(std::int32_t))));
using SmallPack = float __attribute__((vector_size(4 * sizeof(float))));
constexpr int Align = PackSize;

LITTORAL_INLINE FloatPack SquareRoot(const FloatPack& x)
{
  FloatPack root;
  for (int n = 0; n < PackSize; ++n)
  {
    root[n] = std::sqrt(x[n]);
  }
  return root;
}

/**
 * Standard normal numbers from 32 random bits each, in place: the inverse of the normal distribution by Abramowitz and
 * Stegun's rational approximation 26.2.23, whose error is below 4.5e-4, with their logarithm ln m = 2 artanh((m - 1) /
 * (m + 1)). Plain arithmetic, so that every processor gives the same bytes.
 */
LITTORAL_SIMD_CLONES void MakeNormal(float* numbers, std::size_t count)
{
  for (std::size_t n = 0; n < count; n += PackSize)
  {
    IntegerPack word;
    std::memcpy(&word, numbers + n, sizeof(word));
    // The upper bit is the sign, the others the probability p of the tail, in (0, 1/2).
    const IntegerPack tail = word & 0x7fffffff;
    const FloatPack p = (__builtin_convertvector(tail, FloatPack) + 0.5f) * 0x1p-32f;
    // ln p = exponent ln 2 + ln m, with m in [1, 2)
    IntegerPack bits;
    std::memcpy(&bits, &p, sizeof(bits));
    const FloatPack exponent = __builtin_convertvector((bits >> 23) - 127, FloatPack);
    bits = (bits & 0x007fffff) | 0x3f800000;
    FloatPack m;
    std::memcpy(&m, &bits, sizeof(m));
    const FloatPack s = (m - 1.0f) / (m + 1.0f);
    const FloatPack s2 = s * s;
    const FloatPack series = 2.0f / 11.0f * s2 + 2.0f / 9.0f;
    const FloatPack logarithm =
      s * (((series * s2 + 2.0f / 7.0f) * s2 + 2.0f / 5.0f) * s2 * s2 + (2.0f / 3.0f * s2 + 2.0f)) +
      exponent * 0.693147181f;
    // t = sqrt(-2 ln p), z = t - (c0 + c1 t + c2 t2) / (1 + d1 t + d2 t2 + d3 t3)
    const FloatPack t = SquareRoot(-2.0f * logarithm);
    const FloatPack top = (0.010328f * t + 0.802853f) * t + 2.515517f;
    const FloatPack bottom = ((0.001308f * t + 0.189269f) * t + 1.432788f) * t + 1.0f;
    const FloatPack z = t - top / bottom;
    std::memcpy(&bits, &z, sizeof(bits));
    bits ^= word & static_cast<std::int32_t>(0x80000000u);
    std::memcpy(numbers + n, &bits, sizeof(bits));
  }
}

/// Registers of sums, and columns that are averaged in one call.
constexpr int Packs = 8;
constexpr int Run = Packs * PackSize;

/// One tap of a row of sums: both of a pair of opposite points.
struct TapRows
{
  const float* One;
  const float* Other;
  float Weight;
};

/// sum = middle weight * noise + sum over taps of weight * (noise there + noise opposite), for Run columns.
template <typename Pack>
LITTORAL_INLINE void AverageRunBy(
  const TapRows* taps, std::size_t count, std::size_t column, const float* middle, float middleWeight, float* sums)
{
  constexpr std::size_t lanes = sizeof(Pack) / sizeof(float);
  for (std::size_t first = column; first < column + Run; first += Packs * lanes)
  {
    Pack sum[Packs];
    for (std::size_t p = 0; p < Packs; ++p)
    {
      Pack a;
      std::memcpy(&a, middle + first + p * lanes, sizeof(a));
      sum[p] = middleWeight * a;
    }
    for (std::size_t n = 0; n < count; ++n)
    {
      for (std::size_t p = 0; p < Packs; ++p)
      {
        Pack a;
        Pack b;
        std::memcpy(&a, taps[n].One + first + p * lanes, sizeof(a));
        std::memcpy(&b, taps[n].Other + first + p * lanes, sizeof(b));
        sum[p] += taps[n].Weight * (a + b);
      }
    }
    std::memcpy(sums + (first - column), sum, sizeof(sum));
  }
}

#if LITTORAL_HAS_SIMD_VERSIONS
LITTORAL_AVX2_VERSION void AverageRun(
  const TapRows* taps, std::size_t count, std::size_t column, const float* middle, float middleWeight, float* sums)
{
  AverageRunBy<FloatPack>(taps, count, column, middle, middleWeight, sums);
}
#endif

/// Averages with packs of four, since pairs of registers in place of packs of eight would be kept in memory.
LITTORAL_ANY_VERSION void AverageRun(
  const TapRows* taps, std::size_t count, std::size_t column, const float* middle, float middleWeight, float* sums)
{
  AverageRunBy<SmallPack>(taps, count, column, middle, middleWeight, sums);
}

int RoundUp(int value, int unit)
{
  return (value + unit - 1) / unit * unit;
}

}

double PlaneLattice::Distance(int i, int j) const
{
  return std::hypot(i * this->StepX[0] + j * this->StepY[0], i * this->StepX[1] + j * this->StepY[1]);
}

Crossover Crossover::OfLattice(const PlaneLattice& lattice)
{
  const double spacing = MeanSpacing(lattice);
  return { 0.25 * Pi / spacing, 0.5 * Pi / spacing };
}

double Crossover::LongPart(double w) const
{
  const double t = std::clamp((w - this->Low) / (this->High - this->Low), 0.0, 1.0);
  return 1.0 - t * t * t * (10.0 - t * (15.0 - 6.0 * t));
}

/// Integral of f W up to w, by parts: F W + integral of F |W'|, since F has no steps.
double Crossover::LongBelow(const CovarianceParameters& field, double w) const
{
  if (w <= this->Low)
  {
    return CumulativeSpectrum(field, w);
  }
  const double width = this->High - this->Low;
  const double end = std::min(w, this->High);
  const auto integrand = [&](double v) {
    const double t = (v - this->Low) / width;
    return CumulativeSpectrum(field, v) * 30.0 * t * t * (1.0 - t) * (1.0 - t) / width;
  };
  return CumulativeSpectrum(field, end) * this->LongPart(end) + Gauss::integrate(integrand, this->Low, end);
}

ShortWaves::ShortWaves(const CovarianceParameters& field, const PlaneLattice& lattice, const Crossover& crossover,
  const std::array<long long, 2>& origin, int seed, RandomPurpose purpose)
  : Random(seed, purpose)
  , Origin(origin)
{
  this->FindWeights(field, lattice, crossover);
}

void ShortWaves::FindWeights(const CovarianceParameters& field, const PlaneLattice& lattice, const Crossover& crossover)
{
  const double radius = AverageRadius * MeanSpacing(lattice);
  // The box of a circle in the grid's indices: with unit vectors across the other step, |i| <= radius / height.
  const double area = CellArea(lattice);
  this->Reach = { static_cast<int>(radius * Length(lattice.StepY) / area),
    static_cast<int>(radius * Length(lattice.StepX) / area) };

  const ShortCovariance covariance(field, lattice, crossover);
  this->Model = [covariance, variance = field.Variance](double distance) { return variance * covariance.At(distance); };
  FourierGrid grid(NextFastLength(5 * this->Reach[0] + 2), NextFastLength(5 * this->Reach[1] + 2));
  covariance.Sample(lattice, grid);
  TakeRootOfSpectrum(grid);
  this->CutWeights(grid, lattice, radius, field.Variance * std::max(0.0, covariance.GetVariance()));
  this->FindTaps();
}

/// Weights within a radius [m], scaled to the variance [m2].
void ShortWaves::CutWeights(FourierGrid& grid, const PlaneLattice& lattice, double radius, double variance)
{
  const int width = grid.GetWidth();
  const int height = grid.GetHeight();
  const auto within = [&](int i, int j) { return lattice.Distance(i, j) <= radius; };
  const auto weight = [&](int i, int j) { return grid.At((i + width) % width, (j + height) % height).real(); };
  // The variance of the average of white noise is the sum of the squared weights.
  double squares = 0.0;
  for (int j = -this->Reach[1]; j <= this->Reach[1]; ++j)
  {
    for (int i = -this->Reach[0]; i <= this->Reach[0]; ++i)
    {
      squares += within(i, j) ? weight(i, j) * weight(i, j) : 0.0;
    }
  }
  const double scale = squares > 0.0 ? std::sqrt(variance / squares) : 0.0;
  for (int j = -this->Reach[1]; j <= this->Reach[1]; ++j)
  {
    for (int i = -this->Reach[0]; i <= this->Reach[0]; ++i)
    {
      const float value = within(i, j) ? static_cast<float>(scale * weight(i, j)) : 0.0f;
      this->Weights.push_back(value);
    }
  }
}

/// The middle, then one of each pair of opposite points.
void ShortWaves::FindTaps()
{
  this->Taps.push_back({ 0, 0, this->Weight(0, 0) });
  for (int j = 0; j <= this->Reach[1]; ++j)
  {
    for (int i = j == 0 ? 1 : -this->Reach[0]; i <= this->Reach[0]; ++i)
    {
      if (this->Weight(i, j) != 0.0f)
      {
        this->Taps.push_back({ i, j, this->Weight(i, j) });
      }
    }
  }
}

float ShortWaves::Weight(int i, int j) const
{
  const bool inside = std::abs(i) <= this->Reach[0] && std::abs(j) <= this->Reach[1];
  return inside ? this->Weights[(j + this->Reach[1]) * (2 * this->Reach[0] + 1) + i + this->Reach[0]] : 0.0f;
}

double ShortWaves::Covariance(int i, int j) const
{
  double sum = 0.0;
  for (int row = -this->Reach[1]; row <= this->Reach[1]; ++row)
  {
    for (int column = -this->Reach[0]; column <= this->Reach[0]; ++column)
    {
      sum += this->Weight(column, row) * static_cast<double>(this->Weight(column + i, row + j));
    }
  }
  return sum;
}

void ShortWaves::Fill(int firstColumn, int firstRow, int width, int height, std::vector<float>& values) const
{
  // Noise at the points and around them, from a multiple of four columns on.
  const long long column = this->Origin[0] + firstColumn;
  const long long left = column - this->Reach[0];
  const long long firstCounter = left >> 2;
  const int margin = static_cast<int>(column - 4 * firstCounter);
  const int counters = (margin + RoundUp(width, Run) + this->Reach[0] + 3) / 4;
  const int pitch = RoundUp(4 * counters, Align);
  const int rows = height + 2 * this->Reach[1];
  std::vector<float> noise(static_cast<std::size_t>(pitch) * rows);
  std::vector<std::uint32_t> words(4 * static_cast<std::size_t>(counters));
  for (int j = 0; j < rows; ++j)
  {
    const long long row = this->Origin[1] + firstRow - this->Reach[1] + j;
    const std::uint64_t object = 1ull << 32 | static_cast<std::uint32_t>(row);
    this->Random.FillWords(object, static_cast<std::uint64_t>(firstCounter), counters, words.data());
    std::memcpy(&noise[static_cast<std::size_t>(j) * pitch], words.data(), words.size() * sizeof(words[0]));
  }
  MakeNormal(noise.data(), noise.size());

  values.resize(static_cast<std::size_t>(width) * height);
  std::vector<TapRows> taps(this->Taps.size() - 1);
  alignas(64) float sums[Run];
  for (int j = 0; j < height; ++j)
  {
    const float* middle = &noise[static_cast<std::size_t>(j + this->Reach[1]) * pitch + margin];
    for (std::size_t n = 0; n < taps.size(); ++n)
    {
      const Tap& tap = this->Taps[n + 1];
      const std::ptrdiff_t apart = static_cast<std::ptrdiff_t>(tap.Row) * pitch + tap.Column;
      taps[n] = { middle + apart, middle - apart, tap.Weight };
    }
    for (int i = 0; i < width; i += Run)
    {
      AverageRun(taps.data(), taps.size(), i, middle, this->Taps[0].Weight, sums);
      std::copy_n(sums, std::min(Run, width - i), &values[static_cast<std::size_t>(j) * width + i]);
    }
  }
}

}
