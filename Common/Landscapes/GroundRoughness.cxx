// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Landscapes/GroundRoughness.h"

#include "Drainage/ChannelGrading.h"
#include "Drainage/DrainageOutlets.h"
#include "Drainage/FlowRouting.h"
#include "Drainage/LeastSquaresLine.h"
#include "Drainage/ValleySpreading.h"
#include "Landscapes/LongWaves.h"
#include "Numerics/Constants.h"
#include "Numerics/RandomStream.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace littoral
{

namespace
{

/// Wavelengths from which and from which on roughness is added [cells].
constexpr double LongestCells = 10.0;
constexpr double FullCells = 5.0;

/// Gauss filters that leave the slopes without roughness, and the means about a cell [cells].
constexpr double SlopeCells = 2.0;
constexpr double MeanCells = 3.0;
constexpr int MarginCells = 8;

/// Drainage area at which water has halved the power of roughness [cells].
constexpr double BedCells = 50.0;

/// Growth of the power of roughness towards longer waves, and the range about the shortest wave that tells it.
constexpr double FloorExponent = 2.5;
constexpr double NearShortest = 1.15;

/// Classes of slope, and bound of the exponent.
constexpr std::size_t Classes = 10;
constexpr double GreatestExponent = 1.5;

/// Draw of the random numbers: the roughness that growth begins with has draw 0.
constexpr int RoughnessDraw = 1;

double LongerSpacing(const GridSamples& grid)
{
  return std::max(grid.Spacing[0], grid.Spacing[1]);
}

/// Squared slope of smoothed ground, by differences that are one-sided at the border, smoothed.
std::vector<double> SlopePower(const GridSamples& smooth, const ParallelFor& parallel, const Poll& poll = NoPoll)
{
  std::vector<double> power(smooth.Values.size());
  for (int j = 0; j < smooth.Height; ++j)
  {
    poll();
    const int south = std::max(j - 1, 0);
    const int north = std::min(j + 1, smooth.Height - 1);
    for (int i = 0; i < smooth.Width; ++i)
    {
      const int west = std::max(i - 1, 0);
      const int east = std::min(i + 1, smooth.Width - 1);
      const double x = (smooth.At(east, j) - smooth.At(west, j)) / ((east - west) * smooth.Spacing[0]);
      const double y = (smooth.At(i, north) - smooth.At(i, south)) / ((north - south) * smooth.Spacing[1]);
      power[static_cast<std::size_t>(j) * smooth.Width + i] = x * x + y * y;
    }
  }
  SmoothGrid(power, smooth.Width, smooth.Height, MeanCells, parallel);
  return power;
}

/// Smoothed ground, which goes on by reflection in the points of its edge, so that slopes have no kink there.
GridSamples Smoothed(const GridSamples& ground, const ParallelFor& parallel, const Poll& poll = NoPoll)
{
  const int margin = std::min({ MarginCells, ground.Width - 1, ground.Height - 1 });
  GridSamples wide = WithMargins(ground, margin, margin, margin, poll);
  SmoothGrid(wide.Values, wide.Width, wide.Height, SlopeCells, parallel);
  return PartOf(wide, margin, margin, ground.Width, ground.Height, poll);
}

/// Exponent p of V ~ q^p, by the means of both in classes of as many cells by the rank of q; 0 where q has no range.
double PowerExponent(const std::vector<double>& slopes, const std::vector<double>& rough)
{
  std::vector<std::pair<double, double>> cells;
  for (std::size_t n = 0; n < slopes.size(); ++n)
  {
    cells.emplace_back(slopes[n], rough[n]);
  }
  std::sort(cells.begin(), cells.end());
  std::vector<double> logSlopes;
  std::vector<double> logRough;
  for (std::size_t k = 0; k < Classes; ++k)
  {
    double slope = 0.0;
    double power = 0.0;
    for (std::size_t n = k * cells.size() / Classes; n < (k + 1) * cells.size() / Classes; ++n)
    {
      slope += cells[n].first;
      power += cells[n].second;
    }
    if (slope > 0.0 && power > 0.0)
    {
      logSlopes.push_back(std::log(slope));
      logRough.push_back(std::log(power));
    }
  }
  const bool hasRange = logSlopes.size() > 1 && logSlopes.back() > logSlopes.front();
  return hasRange ? std::clamp(LineThrough(logSlopes, logRough).Slope, 0.0, GreatestExponent) : 0.0;
}

/// Share of roughness in the variance of curvature after a Gauss filter of two cells, if its power grows from that at
/// two cells' wavelength by the exponent of a rough surface, up to what the place has.
double CurvatureShare(const RingSpectrum& spectrum, double spacing)
{
  const double shortest = 0.5 / spacing;
  double power = 0.0;
  double count = 0.0;
  for (std::size_t ring = 1; ring < spectrum.Power.size(); ++ring)
  {
    const double part = static_cast<double>(ring) * spectrum.Step / shortest;
    const double isNear = part > 1.0 / NearShortest && part < NearShortest ? 1.0 : 0.0;
    power += isNear * spectrum.Power[ring];
    count += isNear;
  }
  double rough = 0.0;
  double all = 0.0;
  for (std::size_t ring = 1; ring < spectrum.Power.size(); ++ring)
  {
    const double waveNumber = static_cast<double>(ring) * spectrum.Step;
    const double filtered = 2.0 * Pi * waveNumber * SlopeCells * spacing;
    // dV = k^5 e^(-(2 pi k s)^2) P dk,  P_r = min(P, P_N (k_N / k)^e)
    const double weight = std::pow(waveNumber * spacing, 5.0) * std::exp(-filtered * filtered);
    const double floor = power / std::max(count, 1.0) * std::pow(shortest / waveNumber, FloorExponent);
    all += weight * spectrum.Power[ring];
    rough += waveNumber * spacing * LongestCells < 1.0 ? 0.0 : weight * std::min(floor, spectrum.Power[ring]);
  }
  return all > 0.0 ? rough / all : 0.0;
}

/// Standard deviations of the coefficients that each ring lacks.
std::vector<double> MissingSizes(const RingSpectrum& is, const GroundRoughness& roughness, const GridSamples& ground)
{
  const double cells = LongerSpacing(ground);
  const double cellArea = ground.Spacing[0] * ground.Spacing[1];
  std::vector<double> sizes(is.Power.size(), 0.0);
  for (std::size_t ring = 1; ring < sizes.size(); ++ring)
  {
    const double waveNumber = static_cast<double>(ring) * is.Step;
    // w = t^2 (3 - 2t),  t = (k - k_0) / (k_1 - k_0)
    const double part = (waveNumber * cells - 1.0 / LongestCells) / (1.0 / FullCells - 1.0 / LongestCells);
    const double t = std::clamp(part, 0.0, 1.0);
    const double missing = roughness.Spectrum.At(waveNumber) - is.Power[ring];
    const bool isTold = waveNumber * roughness.ShortWave <= 1.0;
    sizes[ring] = isTold && missing > 0.0 ? t * std::sqrt((3.0 - 2.0 * t) * missing / cellArea) : 0.0;
  }
  return sizes;
}

}

GroundRoughness RoughnessOf(const GridSamples& place, const ParallelFor& parallel)
{
  GroundRoughness roughness;
  const GridSamples smooth = Smoothed(place, parallel);
  std::vector<double> slopes = SlopePower(smooth, parallel);
  std::vector<double> rough = place.Values;
  for (std::size_t n = 0; n < rough.size(); ++n)
  {
    const double rest = rough[n] - smooth.Values[n];
    rough[n] = rest * rest;
  }
  SmoothGrid(rough, place.Width, place.Height, MeanCells, parallel);
  roughness.SlopeExponent = PowerExponent(slopes, rough);
  GridSamples field = place;
  RemovePlane(field);
  CosineTransform(field, parallel);
  roughness.Spectrum = SpectrumOfCoefficients(field, parallel);
  roughness.CurvaturePart = CurvatureShare(roughness.Spectrum, LongerSpacing(place));
  roughness.ShortWave = std::sqrt(2.0) * LongerSpacing(place);
  return roughness;
}

void AddRoughness(GridSamples& ground, const GroundRoughness& roughness, double minimumSlope, int seed,
  const ParallelFor& parallel, const Poll& poll)
{
  GridSamples field = ground;
  RemovePlane(field, poll);
  CosineTransform(field, parallel);
  const RingSpectrum is = SpectrumOfCoefficients(field, parallel);
  const std::vector<double> sizes = MissingSizes(is, roughness, ground);
  const RandomStream random(seed, RandomPurpose::LandscapeRoughness);
  parallel(field.Values.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      field.Values[n] = random.NormalPair(n, RoughnessDraw)[0];
    }
  });
  MultiplyRings(field, is.Step, sizes, parallel);
  InverseCosineTransform(field, parallel);
  std::vector<double> weights = SlopePower(Smoothed(ground, parallel, poll), parallel, poll);
  const FlowRouting routing = RouteFlow(ground, BorderOutlets(ground.Width, ground.Height), parallel, poll);
  const std::vector<CellIndex> areas = FlowAccumulation(routing, poll);
  double sum = 0.0;
  SteppedPoll stepped(poll);
  for (std::size_t n = 0; n < weights.size(); ++n)
  {
    stepped.Step();
    // w = q^p / (1 + (A / A_r)^2)
    const double bed = static_cast<double>(areas[n]) / BedCells;
    weights[n] = std::pow(weights[n], roughness.SlopeExponent) / (1.0 + bed * bed);
    sum += weights[n];
  }
  const double mean = sum / static_cast<double>(weights.size());
  parallel(field.Values.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      // z' = z + n sqrt(w / w_mean)
      ground.Values[n] += mean > 0.0 ? field.Values[n] * std::sqrt(weights[n] / mean) : 0.0;
    }
  });
  ground.Values = GradeAlong(ground, routing, areas, EvenLaw(minimumSlope), 0.5, parallel, poll);
}

}
