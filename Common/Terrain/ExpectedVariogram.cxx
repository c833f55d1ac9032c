// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Terrain/ExpectedVariogram.h"

#include "Numerics/SimdClones.h"
#include "Terrain/DetrendedWindow.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace littoral
{

namespace
{

/// Bins that are summed side by side: as many as registers hold the sums of.
constexpr std::size_t BlockSize = 32;

/// Adds to a block of sums the multiples of rows, one by one.
LITTORAL_WIDE_SIMD_CLONES void AddMultiples(
  const double* __restrict rows, const double* __restrict factors, std::size_t count, double* __restrict sums)
{
  double block[BlockSize];
  std::copy_n(sums, BlockSize, block);
  for (std::size_t row = 0; row < count; ++row)
  {
    for (std::size_t n = 0; n < BlockSize; ++n)
    {
      block[n] += factors[row] * rows[row * BlockSize + n];
    }
  }
  std::copy_n(block, BlockSize, sums);
}

std::size_t NumberOfBlocks(std::size_t bins)
{
  return (bins + BlockSize - 1) / BlockSize;
}

}

ExpectedVariogram::ExpectedVariogram(const std::vector<LagBin>& bins, const DetrendedWindow* window, int directions)
  : Window(window)
  , NumberOfBins(bins.size())
{
  std::transform(
    bins.begin(), bins.end(), std::back_inserter(this->Separations), [](const LagBin& bin) { return bin.Separation; });
  if (!window)
  {
    return;
  }
  const std::vector<std::array<double, 2>> inWindow = window->Separations();
  this->Separations.insert(this->Separations.end(), inWindow.begin(), inWindow.end());
  const std::vector<std::vector<double>> change = window->SemivarianceChange(bins, directions);
  const std::size_t lags = window->NumberOfLags();
  this->Change.resize(NumberOfBlocks(bins.size()) * BlockSize * lags);
  for (std::size_t bin = 0; bin < bins.size(); ++bin)
  {
    for (std::size_t lag = 0; lag < lags; ++lag)
    {
      this->Change[(bin / BlockSize * lags + lag) * BlockSize + bin % BlockSize] = change[bin][lag];
    }
  }
}

std::vector<ExpectedVariogram::View> ExpectedVariogram::Of(const std::vector<Field>& fields) const
{
  std::vector<View> views;
  std::vector<std::vector<double>> cellMeans;
  for (const Field& field : fields)
  {
    View view;
    view.Variance = field.Variance + field.Nugget;
    view.Semivariances.resize(NumberOfBlocks(this->NumberOfBins) * BlockSize);
    const auto inWindow = field.Semivariances.begin() + static_cast<std::ptrdiff_t>(this->NumberOfBins);
    std::transform(field.Semivariances.begin(), inWindow, view.Semivariances.begin(),
      [&](double semivariance) { return field.Nugget + semivariance; });
    if (this->Window)
    {
      std::vector<double> covariances;
      std::transform(inWindow, field.Semivariances.end(), std::back_inserter(covariances),
        [&](double semivariance) { return field.Variance - semivariance; });
      cellMeans.push_back(this->Window->CellMeans(covariances));
      view.Variance -= this->Window->LostVariance(cellMeans.back());
    }
    views.push_back(std::move(view));
  }
  this->AddChange(cellMeans, views);
  return views;
}

/// gamma(h) + sum over the lags of cells of w(h) C; block by block, so that weights are read from memory once.
void ExpectedVariogram::AddChange(const std::vector<std::vector<double>>& cellMeans, std::vector<View>& views) const
{
  for (std::size_t first = 0; first < this->NumberOfBins; first += BlockSize)
  {
    for (std::size_t n = 0; n < cellMeans.size(); ++n)
    {
      const std::vector<double>& means = cellMeans[n];
      if (std::all_of(means.begin(), means.end(), [](double mean) { return mean == 0.0; }))
      {
        continue; // a nugget
      }
      AddMultiples(&this->Change[first * means.size()], means.data(), means.size(), &views[n].Semivariances[first]);
    }
  }
}

}
