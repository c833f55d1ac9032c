// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/PairHistogram.h"

#include "Numerics/Constants.h"
#include "Numerics/SimdClones.h"
#include "Patterns/PointCells.h"
#include "Patterns/WindowSections.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace littoral
{

namespace
{

/// Bins of a step of the range.
constexpr int BinsOfStep = 32;
/// Points that are looked at together.
constexpr std::size_t PointsAtOnce = 256;
/// Weights against the loss at the edge end here.
constexpr double LargestWeight = 100.0;
/// A distance that is by rounding above one of the range belongs to it.
constexpr double StepTolerance = 1e-9;

/// Distances of some points from one, and their moves.
struct Pairs
{
  std::array<double, PointsAtOnce> X;
  std::array<double, PointsAtOnce> Y;
  std::array<double, PointsAtOnce> Distance;
  std::array<double, PointsAtOnce> Weight;
};

/// Distances, and |W| / ((a - |dx|) (b - |dy|)), the translation correction of a rectangle.
LITTORAL_SIMD_CLONES
void FindPairs(const double* xs, const double* ys, std::size_t count, double x, double y, double a, double b,
  double area, Pairs& pairs)
{
  for (std::size_t n = 0; n < count; ++n)
  {
    const double dx = xs[n] - x;
    const double dy = ys[n] - y;
    pairs.X[n] = dx;
    pairs.Y[n] = dy;
    pairs.Distance[n] = std::sqrt(dx * dx + dy * dy);
    const double common = std::max(area / LargestWeight, (a - std::abs(dx)) * (b - std::abs(dy)));
    pairs.Weight[n] = area / common;
  }
}

}

PairHistogram::PairHistogram(
  const ObservationWindow& window, const DistanceRange& distances, double halfWidth, const ParallelFor& parallel)
  : Distances(distances)
  , HalfWidth(halfWidth)
  , PerBin(distances.Steps * BinsOfStep / distances.Largest)
  , Area(window.GetArea())
  , Sides{ window.GetHigh()[0] - window.GetLow()[0], window.GetHigh()[1] - window.GetLow()[1] }
  , Areas(window.IsRectangle()
        ? nullptr
        : std::make_shared<const CommonAreaTable>(window, distances.Largest + halfWidth, parallel))
{
}

/// Sums of weights of unordered pairs by their distance: bin k holds those above k and up to k + 1 bins.
std::vector<double> PairHistogram::Sum(const std::vector<PlanePosition>& points, double reach) const
{
  std::vector<double> bins(static_cast<std::size_t>(reach * this->PerBin) + 2, 0.0);
  const PointCells cells(points, reach / 4.0);
  for (std::size_t i = 0; i < cells.Size(); ++i)
  {
    const double x = cells.GetX()[i];
    const double y = cells.GetY()[i];
    // Each pair once: with the points that are sorted behind this one.
    cells.ForRangesNear(x, y, reach, cells.RowOf(y), [&](std::size_t begin, std::size_t end) {
      for (std::size_t from = std::max(begin, i + 1); from < end; from += PointsAtOnce)
      {
        this->AddRange(&cells.GetX()[from], &cells.GetY()[from], std::min(PointsAtOnce, end - from), x, y, reach, bins);
      }
    });
  }
  return bins;
}

void PairHistogram::AddRange(const double* xs, const double* ys, std::size_t count, double x, double y, double reach,
  std::vector<double>& bins) const
{
  Pairs pairs;
  FindPairs(xs, ys, count, x, y, this->Sides[0], this->Sides[1], this->Area, pairs);
  for (std::size_t n = 0; n < count; ++n)
  {
    if (pairs.Distance[n] <= reach)
    {
      const double weight =
        this->Areas ? std::min(LargestWeight, this->Area / (*this->Areas)(pairs.X[n], pairs.Y[n])) : pairs.Weight[n];
      const double bin = std::ceil(pairs.Distance[n] * this->PerBin - StepTolerance) - 1.0;
      bins[static_cast<std::size_t>(std::max(0.0, bin))] += weight;
    }
  }
}

std::vector<double> PairHistogram::RipleyK(const std::vector<PlanePosition>& points) const
{
  std::vector<double> k(this->Distances.Count(), 0.0);
  if (points.size() < 2)
  {
    return k;
  }
  // K(r) = 2 |W| / (n (n - 1)) sum over pairs of weights up to r
  const auto n = static_cast<double>(points.size());
  const double scale = 2.0 * this->Area / (n * (n - 1.0));
  const std::vector<double> bins = this->Sum(points, this->Distances.Largest);
  double sum = 0.0;
  for (std::size_t step = 1; step < k.size(); ++step)
  {
    for (std::size_t bin = (step - 1) * BinsOfStep; bin < step * BinsOfStep; ++bin)
    {
      sum += bins[bin];
    }
    k[step] = scale * sum;
  }
  return k;
}

std::vector<double> PairHistogram::PairCorrelation(const std::vector<PlanePosition>& points) const
{
  std::vector<double> g(this->Distances.Count(), 0.0);
  g.front() = std::numeric_limits<double>::quiet_NaN();
  if (points.size() < 2)
  {
    return g;
  }
  // g(r) = 2 |W| / (2 pi r n (n - 1)) sum over bins of 3 / (4 h) (1 - (r - d)^2 / h^2) weights
  const auto n = static_cast<double>(points.size());
  const double scale = this->Area / (Pi * n * (n - 1.0)) * 0.75 / this->HalfWidth;
  const std::vector<double> bins = this->Sum(points, this->Distances.Largest + this->HalfWidth);
  for (std::size_t step = 1; step < g.size(); ++step)
  {
    const double r = this->Distances[static_cast<int>(step)];
    const auto first = static_cast<std::size_t>(std::max(0.0, std::floor((r - this->HalfWidth) * this->PerBin)));
    const auto last = static_cast<std::size_t>((r + this->HalfWidth) * this->PerBin);
    double sum = 0.0;
    for (std::size_t bin = first; bin <= std::min(last, bins.size() - 1); ++bin)
    {
      const double t = (r - (static_cast<double>(bin) + 0.5) / this->PerBin) / this->HalfWidth;
      sum += bins[bin] * std::max(0.0, 1.0 - t * t);
    }
    g[step] = scale * sum / r;
  }
  return g;
}

}
