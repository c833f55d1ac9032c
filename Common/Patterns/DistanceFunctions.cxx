// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/DistanceFunctions.h"

#include "Numerics/Constants.h"
#include "Patterns/PointCells.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace littoral
{

namespace
{

/// Searches that are worth a task of a thread.
constexpr std::size_t SearchesOfTask = 1024;
/// A distance that is by rounding above one of the range belongs to it.
constexpr double RangeTolerance = 1e-12;

/// Distances that are closer than this part of the range are the same to the Kaplan-Meier estimate.
constexpr double SameDistance = 1e-5;

/// Distances of a place to the nearest point and to the edge [m].
struct NearestDistance
{
  double Point;
  double Edge;
};

/// The part of the places whose nearest point is at most at r.
std::vector<double> Uncorrected(const std::vector<NearestDistance>& places, const DistanceRange& distances)
{
  std::vector<double> nearest;
  for (const NearestDistance& place : places)
  {
    nearest.push_back(place.Point);
  }
  std::sort(nearest.begin(), nearest.end());
  std::vector<double> part(distances.Count());
  for (std::size_t k = 0; k < part.size(); ++k)
  {
    const double r = distances[static_cast<int>(k)] * (1.0 + RangeTolerance);
    const auto within = std::upper_bound(nearest.begin(), nearest.end(), r) - nearest.begin();
    part[k] = static_cast<double>(within) / static_cast<double>(places.size());
  }
  return part;
}

/// The same of those places that are at least r from the edge; NaN beyond all of them.
std::vector<double> BorderCorrected(const std::vector<NearestDistance>& places, const DistanceRange& distances)
{
  // A place counts up to its distance to the edge, and as a near one from its distance to the point on.
  std::vector<double> near(distances.Count() + 1, 0.0);
  std::vector<double> all(distances.Count() + 1, 0.0);
  const double step = distances.Maximum / distances.Steps;
  for (const NearestDistance& place : places)
  {
    const double slack = RangeTolerance * distances.Steps;
    const double last = std::min(std::floor(place.Edge / step + slack), static_cast<double>(distances.Steps));
    const double first = std::ceil(std::max(0.0, place.Point / step - slack));
    all[0] += 1.0;
    all[static_cast<std::size_t>(last) + 1] -= 1.0;
    if (first <= last)
    {
      near[static_cast<std::size_t>(first)] += 1.0;
      near[static_cast<std::size_t>(last) + 1] -= 1.0;
    }
  }
  std::vector<double> part(distances.Count());
  double nearOnes = 0.0;
  double ones = 0.0;
  for (std::size_t k = 0; k < part.size(); ++k)
  {
    nearOnes += near[k];
    ones += all[k];
    part[k] = ones > 0.0 ? nearOnes / ones : std::numeric_limits<double>::quiet_NaN();
  }
  return part;
}

/// 1 - product over distances d <= r of 1 - (places with d) / (places with min(d, b) >= d), those with d <= b being
/// observed and the others censored at b.
std::vector<double> KaplanMeier(const std::vector<NearestDistance>& places, const DistanceRange& distances)
{
  // Distances that differ by rounding are the same: coordinates of maps have few digits.
  const double unit = SameDistance * distances.Maximum;
  struct Event
  {
    double Distance;
    bool IsObserved;
  };
  std::vector<Event> events;
  for (const NearestDistance& place : places)
  {
    const double point = std::round(place.Point / unit);
    const double edge = std::round(place.Edge / unit);
    events.push_back({ unit * std::min(point, edge), point <= edge });
  }
  std::sort(events.begin(), events.end(), [](const Event& one, const Event& other) {
    return one.Distance < other.Distance || (one.Distance == other.Distance && one.IsObserved > other.IsObserved);
  });
  std::vector<double> part(distances.Count());
  double beyond = 1.0;
  std::size_t event = 0;
  for (std::size_t k = 0; k < part.size(); ++k)
  {
    const double r = distances[static_cast<int>(k)] * (1.0 + RangeTolerance);
    for (; event < events.size() && events[event].Distance <= r; ++event)
    {
      const double atRisk = static_cast<double>(events.size() - event);
      beyond *= events[event].IsObserved ? 1.0 - 1.0 / atRisk : 1.0;
    }
    part[k] = 1.0 - beyond;
  }
  return part;
}

std::vector<double> Distribution(
  const std::vector<NearestDistance>& places, const DistanceRange& distances, DistanceCorrection correction)
{
  switch (correction)
  {
    case DistanceCorrection::Border:
      return BorderCorrected(places, distances);
    case DistanceCorrection::KaplanMeier:
      return KaplanMeier(places, distances);
    default:
      return Uncorrected(places, distances);
  }
}

/// The middles of equal cells of the bounding box that lie in the window.
std::vector<PlanePosition> PlacesIn(const ObservationWindow& window, int places)
{
  const double width = window.GetHigh()[0] - window.GetLow()[0];
  const double height = window.GetHigh()[1] - window.GetLow()[1];
  std::vector<PlanePosition> middles;
  for (int row = 0; row < places; ++row)
  {
    for (int column = 0; column < places; ++column)
    {
      const PlanePosition middle{ window.GetLow()[0] + width * (column + 0.5) / places,
        window.GetLow()[1] + height * (row + 0.5) / places };
      if (window.Contains(middle))
      {
        middles.push_back(middle);
      }
    }
  }
  return middles;
}

}

DistanceRange DefaultNearestDistances(const ObservationWindow& window, std::size_t points, int steps)
{
  const double diagonal =
    std::hypot(window.GetHigh()[0] - window.GetLow()[0], window.GetHigh()[1] - window.GetLow()[1]);
  const double intensity = static_cast<double>(points) / window.GetArea();
  return { std::min(0.5 * diagonal, std::sqrt(std::log(1e5) / (Pi * intensity))), steps };
}

DistanceFunctions FindDistanceFunctions(const std::vector<PlanePosition>& points, const ObservationWindow& window,
  const DistanceRange& distances, DistanceCorrection correction, int places, const ParallelFor& parallel)
{
  const double spacing = std::sqrt(window.GetArea() / static_cast<double>(points.size()));
  const PointCells cells(points, spacing);
  std::vector<NearestDistance> fromPoints(points.size());
  ForRanges(parallel, points.size(), SearchesOfTask, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      const double x = cells.GetX()[n];
      const double y = cells.GetY()[n];
      fromPoints[n] = { cells.NearestDistance(x, y, n), window.DistanceToEdge({ x, y }) };
    }
  });
  const std::vector<PlanePosition> middles = PlacesIn(window, places);
  std::vector<NearestDistance> fromPlaces(middles.size());
  ForRanges(parallel, middles.size(), SearchesOfTask, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      fromPlaces[n] = { cells.NearestDistance(middles[n][0], middles[n][1]), window.DistanceToEdge(middles[n]) };
    }
  });
  DistanceFunctions functions;
  functions.G = Distribution(fromPoints, distances, correction);
  functions.F = Distribution(fromPlaces, distances, correction);
  functions.J.resize(distances.Count());
  for (std::size_t k = 0; k < functions.J.size(); ++k)
  {
    const double empty = 1.0 - functions.F[k];
    functions.J[k] = empty > 0.0 ? (1.0 - functions.G[k]) / empty : std::numeric_limits<double>::quiet_NaN();
  }
  return functions;
}

}
