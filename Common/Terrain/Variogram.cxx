// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Terrain/Variogram.h"

#include "Numerics/Constants.h"
#include "Numerics/FourierGrid.h"
#include "Numerics/RealGridFourier.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

/// A number of each of the grid's values; 0 where one is missing.
template <typename Function>
std::vector<double> Masked(const GridSamples& samples, const ParallelFor& parallel, Function function)
{
  std::vector<double> masked(samples.Values.size());
  parallel(samples.Height, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin * samples.Width; n < end * samples.Width; ++n)
    {
      const double value = samples.Values[n];
      masked[n] = std::isnan(value) ? 0.0 : function(value);
    }
  });
  return masked;
}

/**
 * The sums over all pairs, by lag, on the way back from their spectrum: transformed along x, not yet along y. The real
 * part becomes the sum of squared differences, the imaginary part the number of pairs. With m the mask of present
 * values and z = 0 elsewhere, the squared differences are corr(m z^2, m) + corr(m, m z^2) - 2 corr(z, z), and
 * corr(m, m) counts them.
 */
class PairSpectrum
{
public:
  PairSpectrum(
    const GridSamples& samples, std::array<int, 2> lags, std::array<int, 2> padded, const ParallelFor& parallel)
    : Padded(padded)
    , Stride(static_cast<std::size_t>(lags[0]) / FourierLanes * FourierLanes + FourierLanes)
  {
    const double mean = Moments(samples).Mean;
    const auto transform = [&](auto function) {
      return RealGridFourier(Masked(samples, parallel, function), { samples.Width, samples.Height }, padded, parallel);
    };
    const RealGridFourier mask = transform([](double) { return 1.0; });
    const RealGridFourier values = transform([=](double value) { return value - mean; });
    const RealGridFourier squares = transform([=](double value) { return (value - mean) * (value - mean); });
    const std::size_t size = this->Stride * mask.NumberOfRows();
    for (Half* half : { &this->Right, &this->Left })
    {
      half->Re.resize(size);
      half->Im.resize(size);
    }
    parallel(mask.NumberOfPacks(), [&](std::size_t begin, std::size_t end) {
      const DoubleLineFourier along(padded[0]);
      DoubleLinePack sums(padded[0]);
      DoubleLinePack other(padded[0]);
      for (int pack = static_cast<int>(begin); pack < static_cast<int>(end); ++pack)
      {
        mask.TransformRows(pack, sums);
        squares.TransformRows(pack, other);
        MultiplyMask(other, sums);
        values.TransformRows(pack, other);
        SubtractPower(other, sums);
        along.Backward(sums);
        this->Store(sums, pack, mask.NumberOfRows(), lags[0]);
      }
    });
  }

  /// The sums at the lags x = FourierLanes * pack + lane >= 0 and all y, those below 0 at y + padded height.
  void TransformColumns(const DoubleLineFourier& across, std::size_t pack, DoubleLinePack& columns) const
  {
    // The spectrum is real and the same at the opposite wave number: at (x, -ky) stands what is at (-x, ky).
    const auto height = static_cast<std::size_t>(this->Padded[1]);
    const auto copy = [&](const std::vector<double>& from, std::size_t row, std::vector<double>& to, std::size_t k) {
      std::copy_n(&from[row * this->Stride + pack * FourierLanes], FourierLanes, &to[k * FourierLanes]);
    };
    for (std::size_t k = 0; k < height; ++k)
    {
      const Half& half = 2 * k <= height ? this->Right : this->Left;
      const std::size_t row = 2 * k <= height ? k : height - k;
      copy(half.Re, row, columns.Re, k);
      copy(half.Im, row, columns.Im, k);
    }
    across.Backward(columns);
  }

private:
  /// Lags x of one sign, row by row of ky.
  struct Half
  {
    std::vector<double> Re;
    std::vector<double> Im;
  };

  /// Replaces the spectrum M of the mask by 2 Re(Q M*) + i |M|^2, with the spectrum Q of the squares.
  static void MultiplyMask(const DoubleLinePack& squares, DoubleLinePack& mask)
  {
    for (std::size_t n = 0; n < mask.Re.size(); ++n)
    {
      const double re = mask.Re[n];
      const double im = mask.Im[n];
      mask.Re[n] = 2.0 * (squares.Re[n] * re + squares.Im[n] * im);
      mask.Im[n] = re * re + im * im;
    }
  }

  /// Less 2 |Z|^2.
  static void SubtractPower(const DoubleLinePack& values, DoubleLinePack& sums)
  {
    for (std::size_t n = 0; n < sums.Re.size(); ++n)
    {
      sums.Re[n] -= 2.0 * (values.Re[n] * values.Re[n] + values.Im[n] * values.Im[n]);
    }
  }

  void Store(const DoubleLinePack& sums, int pack, int rows, int lags)
  {
    for (int lane = 0; lane < std::min(FourierLanes, rows - pack * FourierLanes); ++lane)
    {
      const std::size_t start = (static_cast<std::size_t>(pack) * FourierLanes + lane) * this->Stride;
      for (int x = 0; x <= lags; ++x)
      {
        const std::size_t right = static_cast<std::size_t>(x) * FourierLanes + lane;
        const std::size_t left = static_cast<std::size_t>(x == 0 ? 0 : this->Padded[0] - x) * FourierLanes + lane;
        this->Right.Re[start + x] = sums.Re[right];
        this->Right.Im[start + x] = sums.Im[right];
        this->Left.Re[start + x] = sums.Re[left];
        this->Left.Im[start + x] = sums.Im[left];
      }
    }
  }

  std::array<int, 2> Padded;
  std::size_t Stride; ///< lags, rounded up to whole packs
  Half Right;
  Half Left;
};

}

VariogramMap ComputeVariogramMap(const GridSamples& samples, double maximumLag, const ParallelFor& parallel)
{
  VariogramMap map;
  map.Spacing = samples.Spacing;
  const auto lagsAlong = [&](int axis, int size) {
    return std::min(size - 1, static_cast<int>(std::min(maximumLag / samples.Spacing[axis], 1e9)));
  };
  map.LagWidth = lagsAlong(0, samples.Width);
  map.LagHeight = lagsAlong(1, samples.Height);
  const int width = NextFastLength(samples.Width + map.LagWidth);
  const int height = NextFastLength(samples.Height + map.LagHeight);
  const PairSpectrum spectrum(samples, { map.LagWidth, map.LagHeight }, { width, height }, parallel);

  map.Semivariance.resize(static_cast<std::size_t>(2 * map.LagWidth + 1) * (map.LagHeight + 1));
  map.Pairs.resize(map.Semivariance.size());
  const double scale = 1.0 / (static_cast<double>(width) * height);
  const auto set = [&](int i, int j, double difference, double pairs) {
    const std::size_t index = map.Index(i, j);
    // Matheron's estimate: gamma(h) = D(h) / (2 N(h))
    map.Pairs[index] = std::round(scale * pairs);
    map.Semivariance[index] =
      map.Pairs[index] > 0.0 ? std::max(0.0, 0.5 * (scale * difference) / map.Pairs[index]) : 0.0;
  };
  const DoubleLineFourier across(height);
  parallel(map.LagWidth / FourierLanes + 1, [&](std::size_t begin, std::size_t end) {
    DoubleLinePack sums(height);
    for (std::size_t pack = begin; pack < end; ++pack)
    {
      spectrum.TransformColumns(across, pack, sums);
      const int first = static_cast<int>(pack) * FourierLanes;
      for (int j = 0; j <= map.LagHeight; ++j)
      {
        const std::size_t up = static_cast<std::size_t>(j) * FourierLanes;
        const std::size_t down = static_cast<std::size_t>(j == 0 ? 0 : height - j) * FourierLanes;
        for (int lane = 0; lane < std::min(FourierLanes, map.LagWidth + 1 - first); ++lane)
        {
          set(first + lane, j, sums.Re[up + lane], sums.Im[up + lane]);
          set(-first - lane, j, sums.Re[down + lane], sums.Im[down + lane]); // the same pairs as (x, -y)
        }
      }
    }
  });
  return map;
}

namespace
{

/// Adds a row of the map to the bins.
void AddRow(const VariogramMap& map, int j, double maximumLag, int rings, int directions, std::vector<LagBin>& bins)
{
  // Of row 0 only one half: the other holds the same pairs.
  const int reach = static_cast<int>(std::min(maximumLag / map.Spacing[0] + 1.0, double(map.LagWidth)));
  for (int i = j == 0 ? 1 : -reach; i <= reach; ++i)
  {
    const double x = i * map.Spacing[0];
    const double y = j * map.Spacing[1];
    const double lag = std::sqrt(x * x + y * y);
    const std::size_t index = map.Index(i, j);
    const double pairs = map.Pairs[index];
    if (lag > maximumLag || pairs == 0.0)
    {
      continue;
    }
    const int ring = std::min(rings - 1, static_cast<int>(std::sqrt(lag / maximumLag) * rings));
    const double turn = directions > 1 ? std::atan2(y, x) / Pi : 0.0; // in [0, 1]
    const int sector = static_cast<int>(std::floor(turn * directions + 0.5)) % directions;
    LagBin& bin = bins[static_cast<std::size_t>(sector) * rings + ring];
    // Sector 0 lies about the x axis: its far half is met with the opposite sign.
    const double sign = sector == 0 && x < 0.0 && directions > 1 ? -1.0 : 1.0;
    bin.Lag += pairs * lag;
    bin.Separation[0] += pairs * sign * x;
    bin.Separation[1] += pairs * sign * y;
    bin.Semivariance += pairs * map.Semivariance[index];
    bin.Pairs += pairs;
  }
}

}

std::vector<LagBin> BinVariogram(
  const VariogramMap& map, double maximumLag, int rings, int directions, const ParallelFor& parallel)
{
  // Blocks of rows, of one size for any threads, and their sums in order.
  constexpr int rowsAtOnce = 16;
  const int reach = static_cast<int>(std::min(maximumLag / map.Spacing[1] + 1.0, double(map.LagHeight)));
  std::vector<std::vector<LagBin>> blocks(reach / rowsAtOnce + 1);
  parallel(blocks.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t block = begin; block < end; ++block)
    {
      blocks[block].resize(static_cast<std::size_t>(rings) * directions);
      const int first = static_cast<int>(block) * rowsAtOnce;
      for (int j = first; j <= std::min(reach, first + rowsAtOnce - 1); ++j)
      {
        AddRow(map, j, maximumLag, rings, directions, blocks[block]);
      }
    }
  });
  std::vector<LagBin> bins(static_cast<std::size_t>(rings) * directions);
  for (const std::vector<LagBin>& block : blocks)
  {
    for (std::size_t n = 0; n < bins.size(); ++n)
    {
      const LagBin& part = block[n];
      LagBin& bin = bins[n];
      bin.Lag += part.Lag;
      bin.Separation[0] += part.Separation[0];
      bin.Separation[1] += part.Separation[1];
      bin.Semivariance += part.Semivariance;
      bin.Pairs += part.Pairs;
      bin.Ring = static_cast<int>(n) % rings;
      bin.Direction = static_cast<int>(n) / rings;
    }
  }
  bins.erase(std::remove_if(bins.begin(), bins.end(), [](const LagBin& bin) { return bin.Pairs == 0.0; }), bins.end());
  for (LagBin& bin : bins)
  {
    bin.Lag /= bin.Pairs;
    bin.Semivariance /= bin.Pairs;
    const double length = std::hypot(bin.Separation[0], bin.Separation[1]);
    const double scale = length > 0.0 ? bin.Lag / length : 0.0;
    bin.Separation = { scale * bin.Separation[0], scale * bin.Separation[1] };
  }
  return bins;
}

}
