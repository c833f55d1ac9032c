// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/Constants.h"
#include "Patterns/PointCells.h"
#include "Patterns/ProcessFit.h"

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace littoral
{

namespace
{

/// Places along each side of the bounding box at which the pseudo-likelihood is summed.
constexpr int PlacesOfSide = 128;
/// Neighbours count up to so many mean distances of points.
constexpr double Reach = 3.0;
/// Number of softnesses that are tried: from 0.05 on in steps of as much.
constexpr int SoftnessesTried = 15;
/// Distances in mean distances of points: shorter ones are no interaction, longer ones that of frozen points.
constexpr double MinimumCore = 0.02;
constexpr double MaximumCore = 1.4;
/// Minimum excess of the log-pseudo-likelihood over that of random points, in which chance makes 2 often.
constexpr double MinimumGain = 5.0;

using Powers = std::array<double, SoftnessesTried>;

double SoftnessOf(std::size_t k)
{
  return 0.05 * static_cast<double>(k + 1);
}

/// Sums of (unit / r)^(2 / Softness) over the points about a place, for all softnesses.
Powers SumsAbout(const PointCells& cells, const PlanePosition& place, double unit, std::size_t except)
{
  Powers sums{};
  cells.ForRangesNear(place[0], place[1], Reach * unit, 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      const double dx = cells.GetX()[n] - place[0];
      const double dy = cells.GetY()[n] - place[1];
      const double r2 = (dx * dx + dy * dy) / (unit * unit);
      if (cells.GetOrder()[n] == except || r2 >= Reach * Reach)
      {
        continue;
      }
      const double logarithm = -std::log(r2);
      for (std::size_t k = 0; k < sums.size(); ++k)
      {
        sums[k] += std::exp(logarithm / SoftnessOf(k));
      }
    }
  });
  return sums;
}

/// Terms of the pseudo-likelihood: sums about the points and about places, and the areas for which these stand [m2].
/// Each place is the center of a cell, and shares it with the points in it.
struct PotentialSums
{
  std::vector<Powers> OfPoints;
  std::vector<double> AreasOfPoints;
  std::vector<Powers> OfPlaces;
  std::vector<double> Areas;

  double Area() const
  {
    return std::accumulate(this->Areas.begin(), this->Areas.end(), 0.0) +
      std::accumulate(this->AreasOfPoints.begin(), this->AreasOfPoints.end(), 0.0);
  }
};

PotentialSums FindSums(const std::vector<PlanePosition>& points, const ObservationWindow& window, double unit,
  double border, const ParallelFor& parallel)
{
  const PointCells cells(points, unit);
  const PlanePosition& low = window.GetLow();
  const PlanePosition& high = window.GetHigh();
  const std::array<double, 2> step = { (high[0] - low[0]) / PlacesOfSide, (high[1] - low[1]) / PlacesOfSide };
  PotentialSums sums;
  const double area = step[0] * step[1];
  const auto cellOf = [&](const PlanePosition& point) {
    const auto index = [&](int axis) {
      return std::min(PlacesOfSide - 1, static_cast<int>((point[axis] - low[axis]) / step[axis]));
    };
    return static_cast<std::size_t>(index(1)) * PlacesOfSide + static_cast<std::size_t>(index(0));
  };
  const auto isCounted = [&](const PlanePosition& place) {
    return window.Contains(place) && window.DistanceToEdge(place) >= border;
  };
  std::vector<double> sharing(static_cast<std::size_t>(PlacesOfSide) * PlacesOfSide, 1.0);
  for (const PlanePosition& point : points)
  {
    sharing[cellOf(point)] += 1.0;
  }
  for (std::size_t n = 0; n < points.size(); ++n)
  {
    if (isCounted(points[n]))
    {
      sums.OfPoints.push_back(SumsAbout(cells, points[n], unit, n));
      sums.AreasOfPoints.push_back(area / sharing[cellOf(points[n])]);
    }
  }
  std::vector<std::vector<Powers>> rows(PlacesOfSide);
  std::vector<std::vector<double>> areas(PlacesOfSide);
  ForRanges(parallel, rows.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row)
    {
      for (int column = 0; column < PlacesOfSide; ++column)
      {
        const PlanePosition place = { low[0] + (column + 0.5) * step[0],
          low[1] + (static_cast<double>(row) + 0.5) * step[1] };
        if (isCounted(place))
        {
          rows[row].push_back(SumsAbout(cells, place, unit, points.size()));
          areas[row].push_back(area / sharing[cellOf(place)]);
        }
      }
    }
  });
  for (std::size_t row = 0; row < rows.size(); ++row)
  {
    sums.OfPlaces.insert(sums.OfPlaces.end(), rows[row].begin(), rows[row].end());
    sums.Areas.insert(sums.Areas.end(), areas[row].begin(), areas[row].end());
  }
  return sums;
}

/// ln PL = -sum over points of c S + n ln(n / integral of exp(-c S)) - n, c = core^(2 / Softness), at the best
/// activity.
double LogPseudoLikelihood(const PotentialSums& sums, std::size_t softness, double logCore)
{
  const double c = std::exp(2.0 * logCore / SoftnessOf(softness));
  // Relative to the largest term, since all of them underflow for a long core.
  double least = std::numeric_limits<double>::infinity();
  for (const std::vector<Powers>* each : { &sums.OfPoints, &sums.OfPlaces })
  {
    for (const Powers& one : *each)
    {
      least = std::min(least, c * one[softness]);
    }
  }
  double integral = 0.0;
  for (std::size_t place = 0; place < sums.OfPlaces.size(); ++place)
  {
    integral += sums.Areas[place] * std::exp(least - c * sums.OfPlaces[place][softness]);
  }
  double potential = 0.0;
  for (std::size_t point = 0; point < sums.OfPoints.size(); ++point)
  {
    potential += c * sums.OfPoints[point][softness];
    integral += sums.AreasOfPoints[point] * std::exp(least - c * sums.OfPoints[point][softness]);
  }
  const auto n = static_cast<double>(sums.OfPoints.size());
  return n * (std::log(n / integral) + least) - potential - n;
}

}

ProcessFit FitSoftCore(
  const std::vector<PlanePosition>& points, const ObservationWindow& window, double border, const ParallelFor& parallel)
{
  ProcessFit best;
  best.Contrast = std::numeric_limits<double>::quiet_NaN();
  best.LogPseudoLikelihood = -std::numeric_limits<double>::infinity();
  best.Process.Process = PointProcess::SoftCore;
  best.Process.Intensity = static_cast<double>(points.size()) / window.GetArea();
  const double unit = 1.0 / std::sqrt(best.Process.Intensity);
  const PotentialSums sums = FindSums(points, window, unit, border, parallel);
  if (sums.OfPoints.empty() || sums.OfPlaces.empty())
  {
    return best;
  }
  std::vector<std::pair<double, double>> found(SoftnessesTried);
  ForRanges(parallel, found.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k)
    {
      const auto negative = [&](double x) { return -LogPseudoLikelihood(sums, k, x); };
      found[k] = boost::math::tools::brent_find_minima(negative, std::log(MinimumCore), std::log(MaximumCore), 30);
    }
  });
  for (std::size_t k = 0; k < found.size(); ++k)
  {
    if (-found[k].second > best.LogPseudoLikelihood)
    {
      best.LogPseudoLikelihood = -found[k].second;
      best.Process.Softness = SoftnessOf(k);
      best.Process.Distance = unit * std::exp(found[k].first);
    }
  }
  const auto n = static_cast<double>(sums.OfPoints.size());
  const double ofRandom = n * std::log(n / sums.Area()) - n;
  best.Exists = best.LogPseudoLikelihood > ofRandom + MinimumGain && WhyInvalid(best.Process).empty();
  return best;
}

}
