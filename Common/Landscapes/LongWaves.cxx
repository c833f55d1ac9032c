// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Landscapes/LongWaves.h"

#include "Drainage/MissingWaves.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace littoral
{

namespace
{

/// Gains to the target's spectrum, and of all corrections.
constexpr double MinimumGain = 0.3;
constexpr double MaximumGain = 3.0;
constexpr double MinimumCorrection = 0.5;
constexpr double MaximumCorrection = 2.0;
constexpr double MinimumPlaneGain = 0.8;
constexpr double MaximumPlaneGain = 1.25;

/// Rings from 1/NearRings to NearRings times a wave number have one mean.
constexpr double NearRings = 1.25;

/// Sum of squared coefficients and of those wanted, over the rings near one.
double PowerRatio(const RingSpectrum& spectrum, const RingSpectrum& wanted, std::size_t ring)
{
  const auto middle = static_cast<double>(ring);
  const auto first = static_cast<std::size_t>(std::ceil(middle / NearRings));
  const auto last = std::min(spectrum.Power.size() - 1, static_cast<std::size_t>(middle * NearRings));
  double is = 0.0;
  double shall = 0.0;
  for (std::size_t n = first; n <= last; ++n)
  {
    const auto near = static_cast<double>(n);
    is += near * spectrum.Power[n];
    shall += near * wanted.At(near * spectrum.Step);
  }
  return is > 0.0 ? shall / is : 1.0;
}

/// Sets the rings of coefficients to the wanted power.
void RestoreRings(GridSamples& coefficients, const RingSpectrum& wanted, const ParallelFor& parallel)
{
  const RingSpectrum spectrum = SpectrumOfCoefficients(coefficients, parallel);
  std::vector<double> gains(spectrum.Power.size(), 1.0);
  for (std::size_t ring = 1; ring < gains.size(); ++ring)
  {
    gains[ring] = std::clamp(std::sqrt(PowerRatio(spectrum, wanted, ring)), MinimumGain, MaximumGain);
  }
  MultiplyRings(coefficients, spectrum.Step, gains, parallel);
}

/// Plane of the target, flatter on a terrain that is longer than the place.
PlaneTrend PlaneFor(const GridSamples& terrain, const CarvingTarget& target)
{
  PlaneTrend plane = target.Plane;
  plane.Slope[0] *= std::min(1.0, target.Sides[0] / (terrain.Width * terrain.Spacing[0]));
  plane.Slope[1] *= std::min(1.0, target.Sides[1] / (terrain.Height * terrain.Spacing[1]));
  return plane;
}

/// Value of a line of `count` cells that goes on by reflection in its ends.
template <typename At>
double Reflected(int n, int count, const At& at)
{
  const int last = count - 1;
  return n < 0 ? 2.0 * at(0) - at(-n) : (n > last ? 2.0 * at(last) - at(2 * last - n) : at(n));
}

/// A grid with margins, of which the value at column i and row j of the grid is at(i, j), also outside of it.
template <typename At>
GridSamples Widened(
  const GridSamples& grid, int before, int afterX, int afterY, const At& at, const Poll& poll = NoPoll)
{
  GridSamples wide = grid;
  wide.Width = before + grid.Width + afterX;
  wide.Height = before + grid.Height + afterY;
  wide.Values.clear();
  for (int j = 0; j < wide.Height; ++j)
  {
    poll();
    for (int i = 0; i < wide.Width; ++i)
    {
      wide.Values.push_back(at(i - before, j - before));
    }
  }
  return wide;
}

}

LongWaves::LongWaves(const GridSamples& terrain, const CarvingTarget& target, double shortest, int seed,
  const ParallelFor& parallel, const Poll& poll)
  : Coefficients(terrain)
  , Shortest(shortest)
{
  GridSamples& field = this->Coefficients;
  poll();
  MapQuantiles(field.Values, target.Heights, parallel);
  AddMissingWaves(field, target.Spectrum, seed, parallel, poll);
  RemovePlane(field, poll);
  CosineTransform(field, parallel);
  RestoreRings(field, target.Spectrum, parallel);
  InverseCosineTransform(field, parallel);
  AddPlane(field, PlaneFor(terrain, target), parallel);
  MapQuantiles(field.Values, target.Heights, parallel);
  this->Plane = RemovePlane(field, poll);
  CosineTransform(field, parallel);
  const RingSpectrum spectrum = SpectrumOfCoefficients(field, parallel);
  this->Step = spectrum.Step;
  this->Gains.Rings.assign(spectrum.Power.size(), 1.0);
}

GridSamples LongWaves::Heights(const ParallelFor& parallel) const
{
  GridSamples heights = this->Coefficients;
  MultiplyRings(heights, this->Step, this->Gains.Rings, parallel);
  for (int wave = 0; wave < 9; ++wave)
  {
    heights.At(wave % 3, wave / 3) *= this->Gains.LongWaves[wave];
  }
  InverseCosineTransform(heights, parallel);
  PlaneTrend plane = this->Plane;
  plane.Slope = { this->Gains.Plane * plane.Slope[0], this->Gains.Plane * plane.Slope[1] };
  AddPlane(heights, plane, parallel);
  return heights;
}

void LongWaves::Correct(
  const GridSamples& landscape, const GroundMeasures& target, const ParallelFor& parallel, const Poll& poll)
{
  const std::vector<int> lags = SemivarianceLags(landscape.Width, landscape.Height);
  const double spacing = 0.5 * (landscape.Spacing[0] + landscape.Spacing[1]);
  std::vector<double> wanted = SemivarianceAlongAxes(landscape, lags, parallel);
  for (std::size_t n = 0; n < lags.size(); ++n)
  {
    wanted[n] = target.SemivarianceAt(spacing * lags[n]) / wanted[n];
  }
  GridSamples field = CopyOf(landscape, poll);
  const PlaneTrend plane = RemovePlane(field, poll);
  CosineTransform(field, parallel);
  const SemivarianceBands bands(field, this->Step, this->Gains.Rings.size(), plane, parallel);
  const BandGains further = bands.GainsFor(lags, wanted);
  const auto correct = [](double& gain, double by, double least, double most) {
    gain = std::clamp(gain * std::sqrt(by), least, most);
  };
  correct(this->Gains.Plane, further.Plane, MinimumPlaneGain, MaximumPlaneGain);
  for (std::size_t wave = 0; wave < further.LongWaves.size(); ++wave)
  {
    correct(this->Gains.LongWaves[wave], further.LongWaves[wave], MinimumCorrection, MaximumCorrection);
  }
  const double last = std::min(this->Shortest / this->Step, static_cast<double>(this->Gains.Rings.size() - 1));
  for (std::size_t ring = 1; ring <= static_cast<std::size_t>(last); ++ring)
  {
    correct(this->Gains.Rings[ring], further.Rings[ring], MinimumCorrection, MaximumCorrection);
  }
}

GridSamples WithMargins(const GridSamples& grid, int before, int afterX, int afterY, const Poll& poll)
{
  const auto at = [&](int i, int j) {
    return Reflected(
      j, grid.Height, [&](int y) { return Reflected(i, grid.Width, [&](int x) { return grid.At(x, y); }); });
  };
  return Widened(grid, before, afterX, afterY, at, poll);
}

GridSamples WithEdges(const GridSamples& grid, int before, int afterX, int afterY)
{
  return Widened(grid, before, afterX, afterY,
    [&](int i, int j) { return grid.At(std::clamp(i, 0, grid.Width - 1), std::clamp(j, 0, grid.Height - 1)); });
}

GridSamples PartOf(const GridSamples& grid, int x, int y, int width, int height, const Poll& poll)
{
  GridSamples part;
  part.Width = width;
  part.Height = height;
  part.Spacing = grid.Spacing;
  for (int j = y; j < y + height; ++j)
  {
    poll();
    const auto row = grid.Values.begin() + static_cast<std::ptrdiff_t>(j) * grid.Width + x;
    part.Values.insert(part.Values.end(), row, row + width);
  }
  return part;
}

GridSamples BlockMeans(const GridSamples& grid, int factor, const Poll& poll)
{
  GridSamples coarse;
  coarse.Width = grid.Width / factor;
  coarse.Height = grid.Height / factor;
  coarse.Spacing = { factor * grid.Spacing[0], factor * grid.Spacing[1] };
  coarse.Values.assign(static_cast<std::size_t>(coarse.Width) * coarse.Height, 0.0);
  for (int j = 0; j < coarse.Height * factor; ++j)
  {
    poll();
    for (int i = 0; i < coarse.Width * factor; ++i)
    {
      coarse.At(i / factor, j / factor) += grid.At(i, j) / (factor * factor);
    }
  }
  return coarse;
}

std::vector<double> Refined(const std::vector<double>& values, int width, int height)
{
  std::vector<double> fine;
  for (int j = 0; j < 2 * height; ++j)
  {
    const int y = std::clamp(j % 2 == 0 ? j / 2 - 1 : j / 2 + 1, 0, height - 1);
    for (int i = 0; i < 2 * width; ++i)
    {
      const int x = std::clamp(i % 2 == 0 ? i / 2 - 1 : i / 2 + 1, 0, width - 1);
      const auto at = [&](int column, int row) { return values[static_cast<std::size_t>(row) * width + column]; };
      fine.push_back((9.0 * at(i / 2, j / 2) + 3.0 * (at(x, j / 2) + at(i / 2, y)) + at(x, y)) / 16.0);
    }
  }
  return fine;
}

}
