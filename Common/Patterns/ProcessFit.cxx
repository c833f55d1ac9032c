// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/ProcessFit.h"

#include "Numerics/Constants.h"
#include "Numerics/ParameterCheck.h"
#include "Numerics/ResidualForm.h"

#include <Eigen/Dense>
#include <unsupported/Eigen/NonLinearOptimization>
#include <unsupported/Eigen/NumericalDiff>

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace littoral
{

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
/// Places along each side of the bounding box at which a pseudo-likelihood is summed.
constexpr int PlacesOfSide = 256;
/// Largest activity over intensity: beyond it points are packed, and hardly a birth is accepted.
constexpr double MaximumActivity = 100.0;
/// Distances that are tried for a Strauss process, and the farthest of them [mean distances of points].
constexpr std::size_t DistancesTried = 128;
constexpr double FarthestStrauss = 2.5;

/// Shortest range of a log-Gaussian Cox process [mean distances of points]: a shorter one has thousands of squares for
/// each point, and the pattern of tight clusters.
constexpr double ShortestRange = 0.25;

/// Border of the fit of a soft core, in mean distances of points.
constexpr double BorderOfSoftCore = 0.85;

/// The differences of a measured function and that of a process, both to the power q, at all distances.
class Contrast : public ResidualForm
{
public:
  Contrast(PointProcess process, double intensity, const std::vector<double>& distances, std::vector<double> powers,
    const ContrastOptions& options)
    : Distances(distances)
    , Measured(std::move(powers))
    , Options(options)
  {
    this->Start.Process = process;
    this->Start.Intensity = intensity;
  }

  int inputs() const { return 2; }
  int values() const { return static_cast<int>(this->Distances.size()); }

  /// Unknowns are logarithms: of the parents' intensity or the variance, and of the scale or the range.
  PointProcessParameters Unpack(const Eigen::VectorXd& unknowns) const
  {
    PointProcessParameters process = this->Start;
    const double first = std::exp(std::clamp(unknowns[0], -60.0, 60.0));
    const double length = std::exp(std::clamp(unknowns[1], -60.0, 60.0));
    if (process.Process == PointProcess::LogGaussianCox)
    {
      process.Variance = first;
      process.Range = length;
    }
    else
    {
      process.ClusterSize = process.Intensity / first;
      process.ClusterScale = length;
    }
    return process;
  }

  int operator()(const Eigen::VectorXd& unknowns, Eigen::VectorXd& differences) const
  {
    const PointProcessParameters process = this->Unpack(unknowns);
    const std::vector<double> k =
      this->Options.Function == ContrastFunction::Ripley ? RipleyK(process, this->Distances) : std::vector<double>();
    for (std::size_t n = 0; n < this->Distances.size(); ++n)
    {
      const double value = k.empty() ? PairCorrelation(process, this->Distances[n]) : k[n];
      const double difference = this->Measured[n] - std::pow(value, this->Options.Power);
      differences[static_cast<Eigen::Index>(n)] = std::isfinite(difference) ? difference : 1e100;
    }
    return 0;
  }

private:
  PointProcessParameters Start;
  std::vector<double> Distances;
  std::vector<double> Measured;
  ContrastOptions Options;
};

/// Whether fitted parameters are plausible: not clusters that are wider than the distances compared, nor of almost no
/// points or more than all, nor thickets between the points.
bool IsFound(const PointProcessParameters& process, double largest, double points)
{
  if (process.Process == PointProcess::LogGaussianCox)
  {
    return process.Variance > 1e-3 && process.Variance < 10.0 && process.Range < 10.0 * largest &&
      process.Range > ShortestRange / std::sqrt(process.Intensity);
  }
  return process.ClusterSize > 1e-3 && process.ClusterSize < points && process.ClusterScale < 5.0 * largest &&
    process.ClusterScale > 1e-4 * largest;
}

/// Distances of the contrast and the measured function there, to the power q.
void Measure(const std::vector<PlanePosition>& points, const ObservationWindow& window, const ContrastOptions& options,
  const IntensityTrend& trend, const ParallelFor& parallel, std::vector<double>& distances, std::vector<double>& powers)
{
  PairOptions pairs;
  pairs.Distances = DefaultDistances(window, points.size());
  pairs.Distances.Maximum = options.MaximumDistance > 0.0 ? options.MaximumDistance : pairs.Distances.Maximum;
  pairs.Correction = options.Correction;
  pairs.WantsK = options.Function == ContrastFunction::Ripley;
  pairs.WantsG = !pairs.WantsK;
  for (std::size_t n = 0; trend.Exists() && n < points.size(); ++n)
  {
    pairs.Weights.push_back(1.0 / trend.At(window, points[n]));
  }
  const PairFunctions functions = FindPairFunctions(points, window, pairs, parallel);
  const std::vector<double>& values = pairs.WantsK ? functions.K : functions.PairCorrelation;
  const int first = pairs.WantsK ? 0 : 1; // g(0) can be infinite
  for (int k = first; k <= pairs.Distances.Steps; ++k)
  {
    distances.push_back(pairs.Distances[k]);
    powers.push_back(std::pow(values[static_cast<std::size_t>(k)], options.Power));
  }
}

/// Sum of the squared differences at the minimum about a start, which the unknowns become.
double Minimize(const Contrast& contrast, Eigen::VectorXd& unknowns)
{
  Eigen::NumericalDiff<Contrast> functor(contrast);
  Eigen::LevenbergMarquardt<Eigen::NumericalDiff<Contrast>> search(functor);
  search.parameters.factor = 1.0;
  search.parameters.maxfev = 400;
  search.parameters.ftol = search.parameters.xtol = 1e-12;
  search.minimize(unknowns);
  return search.fnorm * search.fnorm;
}

ProcessFit FitByContrast(PointProcess process, const std::vector<PlanePosition>& points,
  const ObservationWindow& window, const ContrastOptions& options, const IntensityTrend& trend,
  const ParallelFor& parallel)
{
  std::vector<double> distances;
  std::vector<double> powers;
  Measure(points, window, options, trend, parallel, distances, powers);
  const double intensity = static_cast<double>(points.size()) / window.GetArea();
  const Contrast contrast(process, intensity, distances, powers, options);
  const double largest = distances.back();
  // Several starts: the contrast has valleys of small and of wide clusters.
  const bool isCox = process == PointProcess::LogGaussianCox;
  const std::array<double, 2> firsts = { isCox ? 0.3 : 0.1 * intensity, isCox ? 2.0 : 0.7 * intensity };
  const std::array<double, 3> lengths = { 0.05, 0.15, 0.4 };
  std::array<ProcessFit, firsts.size() * lengths.size()> fits;
  ForRanges(parallel, fits.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      Eigen::VectorXd unknowns(2);
      unknowns << std::log(firsts[n / lengths.size()]), std::log(lengths[n % lengths.size()] * largest);
      fits[n].Contrast = Minimize(contrast, unknowns) * largest / static_cast<double>(distances.size());
      fits[n].Process = contrast.Unpack(unknowns);
    }
  });
  ProcessFit best;
  best.LogPseudoLikelihood = NaN;
  best.Contrast = std::numeric_limits<double>::infinity();
  for (const ProcessFit& fit : fits)
  {
    if (fit.Contrast < best.Contrast * (1.0 - 1e-9))
    {
      best.Contrast = fit.Contrast;
      best.Process = fit.Process;
    }
  }
  best.Trend = trend;
  best.Exists = IsFound(best.Process, largest, static_cast<double>(points.size())) && WhyInvalid(best.Process).empty();
  return best;
}

/// Smallest distance of two points [m].
double ShortestDistance(const std::vector<PlanePosition>& points)
{
  std::vector<PlanePosition> sorted = points;
  std::sort(sorted.begin(), sorted.end());
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t a = 0; a < sorted.size(); ++a)
  {
    for (std::size_t b = a + 1; b < sorted.size() && sorted[b][0] - sorted[a][0] < shortest; ++b)
    {
      shortest = std::min(shortest, std::hypot(sorted[b][0] - sorted[a][0], sorted[b][1] - sorted[a][1]));
    }
  }
  return shortest;
}

/// Numbers of points, and areas of places [m2], that have t neighbours within a distance, t = 0, 1, 2...
struct NeighbourCounts
{
  std::vector<double> Points;
  std::vector<double> Places;
};

/// Counts of neighbours at the distances k / n of the farthest one, k = 1 ... n.
using NeighbourProfile = std::vector<NeighbourCounts>;

/// The points near a place, by a sort along x.
class Neighbours
{
public:
  Neighbours(std::vector<PlanePosition> points, double farthest)
    : Sorted(std::move(points))
    , Farthest(farthest)
  {
    std::sort(this->Sorted.begin(), this->Sorted.end());
  }

  const std::vector<PlanePosition>& GetPoints() const { return this->Sorted; }

  /// Numbers of points nearer than each of so many distances.
  std::vector<int> CountsAbout(const PlanePosition& place, std::size_t distances) const
  {
    std::vector<int> counts(distances, 0);
    auto at =
      std::lower_bound(this->Sorted.begin(), this->Sorted.end(), PlanePosition{ place[0] - this->Farthest, -1e300 });
    for (; at != this->Sorted.end() && (*at)[0] <= place[0] + this->Farthest; ++at)
    {
      const double dx = (*at)[0] - place[0];
      const double dy = (*at)[1] - place[1];
      const double part = std::sqrt(dx * dx + dy * dy) / this->Farthest;
      if (part < 1.0)
      {
        ++counts[static_cast<std::size_t>(part * static_cast<double>(distances))];
      }
    }
    std::partial_sum(counts.begin(), counts.end(), counts.begin());
    return counts;
  }

private:
  std::vector<PlanePosition> Sorted;
  double Farthest;
};

void AddAt(std::vector<double>& counts, int t, double value)
{
  counts.resize(std::max(counts.size(), static_cast<std::size_t>(t) + 1), 0.0);
  counts[static_cast<std::size_t>(t)] += value;
}

/// Areas of the places of a row of the bounding box by their neighbours.
NeighbourProfile CountRow(
  const Neighbours& points, const ObservationWindow& window, std::size_t row, double border, std::size_t distances)
{
  const PlanePosition& low = window.GetLow();
  const PlanePosition& high = window.GetHigh();
  const std::array<double, 2> step = { (high[0] - low[0]) / PlacesOfSide, (high[1] - low[1]) / PlacesOfSide };
  NeighbourProfile profile(distances);
  for (int column = 0; column < PlacesOfSide; ++column)
  {
    const PlanePosition place = { low[0] + (column + 0.5) * step[0],
      low[1] + (static_cast<double>(row) + 0.5) * step[1] };
    if (window.Contains(place) && window.DistanceToEdge(place) >= border)
    {
      const std::vector<int> counts = points.CountsAbout(place, distances);
      for (std::size_t k = 0; k < distances; ++k)
      {
        AddAt(profile[k].Places, counts[k], step[0] * step[1]);
      }
    }
  }
  return profile;
}

/// Neighbours of points and places that are at least the border from the edge.
NeighbourProfile CountNeighbours(const std::vector<PlanePosition>& points, const ObservationWindow& window,
  double farthest, double border, std::size_t distances, const ParallelFor& parallel)
{
  const Neighbours near(points, farthest);
  std::vector<NeighbourProfile> rows(PlacesOfSide);
  ForRanges(parallel, rows.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row)
    {
      rows[row] = CountRow(near, window, row, border, distances);
    }
  });
  NeighbourProfile profile(distances);
  for (const NeighbourProfile& row : rows)
  {
    for (std::size_t k = 0; k < distances; ++k)
    {
      for (std::size_t t = 0; t < row[k].Places.size(); ++t)
      {
        AddAt(profile[k].Places, static_cast<int>(t), row[k].Places[t]);
      }
    }
  }
  for (const PlanePosition& point : near.GetPoints())
  {
    if (window.DistanceToEdge(point) >= border)
    {
      const std::vector<int> counts = near.CountsAbout(point, distances);
      for (std::size_t k = 0; k < distances; ++k)
      {
        AddAt(profile[k].Points, counts[k] - 1, 1.0); // but itself
      }
    }
  }
  return profile;
}

/// Log-pseudo-likelihood ln PL = sum over points of ln(beta gamma^t) - beta * integral of gamma^t, at its maximum over
/// beta, the number of points over the integral.
double LogPseudoLikelihood(const NeighbourCounts& counts, double interaction, double& activity)
{
  double integral = 0.0;
  double power = 1.0;
  for (const double area : counts.Places)
  {
    integral += power * area;
    power *= interaction;
  }
  double points = 0.0;
  double sum = 0.0;
  for (std::size_t t = 0; t < counts.Points.size(); ++t)
  {
    points += counts.Points[t];
    sum += t > 0 && counts.Points[t] > 0.0 ? static_cast<double>(t) * counts.Points[t] * std::log(interaction) : 0.0;
  }
  activity = points / integral;
  return points * std::log(activity) + sum - points;
}

}

std::string WhyInvalid(const ContrastOptions& options)
{
  ParameterCheck check;
  check.Choice("Contrast", static_cast<int>(options.Function), { "K", "g" });
  check.Choice("Correction", static_cast<int>(options.Correction), { "none", "border", "isotropic", "translation" });
  check.Require(options.Function == ContrastFunction::Ripley || options.Correction != EdgeCorrection::Border,
    "There is no g with the border correction; choose the isotropic or the translation correction.");
  check.NotNegative("MaximumDistance", options.MaximumDistance, "m");
  check.Within("Power", options.Power, ValueInterval::Above(0.0, 1.0));
  check.Count("TrendDegree", options.TrendDegree, 0, MaximumTrendDegree);
  check.Require(options.TrendDegree == 0 || options.Correction != EdgeCorrection::Border,
    "There is no trend with the border correction; choose the isotropic or the translation correction.");
  return check.Reason();
}

namespace
{

/// Maximum of the pseudo-likelihood at a distance; `intensity` [1/m2] is that of the points.
ProcessFit FitAtDistance(const NeighbourCounts& counts, double distance, double intensity)
{
  ProcessFit fit;
  fit.Contrast = NaN;
  fit.Process.Process = PointProcess::Strauss;
  fit.Process.Distance = distance;
  if (counts.Points.empty() || counts.Places.empty())
  {
    return fit;
  }
  // The logarithm of the interaction is searched from that of 1e-6, of which no pattern tells 0 apart, to 0.
  double activity = 0.0;
  const auto negative = [&](double x) { return -LogPseudoLikelihood(counts, std::exp(x), activity); };
  const auto [x, value] = boost::math::tools::brent_find_minima(negative, std::log(1e-6), 0.0, 40);
  const bool hasPairs = counts.Points.size() > 1;
  fit.Process.Interaction = hasPairs ? std::exp(x) : 0.0;
  fit.LogPseudoLikelihood = hasPairs ? -value : LogPseudoLikelihood(counts, 0.0, activity);
  LogPseudoLikelihood(counts, fit.Process.Interaction, activity);
  fit.Process.Activity = activity;
  fit.Exists = fit.Process.Interaction < 0.999 && activity > 0.0 && activity < MaximumActivity * intensity;
  return fit;
}

/// Fit of the distance with the largest pseudo-likelihood of all points, none of whose neighbours outside of the window
/// are known. A border would leave too few points: it must be as wide as the farthest distance for all.
ProcessFit FindStraussDistance(const std::vector<PlanePosition>& points, const ObservationWindow& window,
  double intensity, const ParallelFor& parallel)
{
  const double shorter = std::min(window.GetHigh()[0] - window.GetLow()[0], window.GetHigh()[1] - window.GetLow()[1]);
  const double farthest = std::min(0.25 * shorter, FarthestStrauss / std::sqrt(intensity));
  const NeighbourProfile profile = CountNeighbours(points, window, farthest, 0.0, DistancesTried, parallel);
  ProcessFit best;
  best.LogPseudoLikelihood = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < profile.size(); ++k)
  {
    const double distance = farthest * static_cast<double>(k + 1) / static_cast<double>(profile.size());
    const ProcessFit fit = FitAtDistance(profile[k], distance, intensity);
    best = fit.Exists && fit.LogPseudoLikelihood > best.LogPseudoLikelihood ? fit : best;
  }
  return best;
}

}

ProcessFit FitStrauss(const std::vector<PlanePosition>& points, const ObservationWindow& window, double distance,
  double border, const ParallelFor& parallel)
{
  const double intensity = static_cast<double>(points.size()) / window.GetArea();
  return FitAtDistance(CountNeighbours(points, window, distance, border, 1, parallel).front(), distance, intensity);
}

namespace
{

/// The same distance fitted with a border; points that are packed there keep the fit to all.
ProcessFit WithBorder(const ProcessFit& fit, const std::vector<PlanePosition>& points, const ObservationWindow& window,
  const ParallelFor& parallel)
{
  const ProcessFit inner = FitStrauss(points, window, fit.Process.Distance, fit.Process.Distance, parallel);
  return inner.Exists ? inner : fit;
}

}

IntensityTrend TrendOf(
  const std::vector<PlanePosition>& points, const ObservationWindow& window, const ContrastOptions& options)
{
  return options.TrendDegree > 0 ? FitTrend(points, window, options.TrendDegree) : IntensityTrend();
}

ProcessFit FitProcess(PointProcess process, const std::vector<PlanePosition>& points, const ObservationWindow& window,
  const ContrastOptions& options, const ParallelFor& parallel)
{
  return FitProcess(process, points, window, options, TrendOf(points, window, options), parallel);
}

ProcessFit FitProcess(PointProcess process, const std::vector<PlanePosition>& points, const ObservationWindow& window,
  const ContrastOptions& options, const IntensityTrend& trend, const ParallelFor& parallel)
{
  const auto n = static_cast<double>(points.size());
  const double intensity = n / window.GetArea();
  ProcessFit fit;
  fit.Contrast = fit.LogPseudoLikelihood = NaN;
  fit.Process.Process = process;
  fit.Process.Intensity = intensity;
  const bool hasTrend = options.TrendDegree == 0 || trend.Exists(); // as asked for
  switch (process)
  {
    case PointProcess::Poisson:
      fit.Trend = trend;
      fit.Exists = hasTrend;
      return fit;
    case PointProcess::MaternII:
      fit.Trend = trend;
      fit.Process.Distance = ShortestDistance(points) * n / (n + 1.0);
      fit.Exists = hasTrend && WhyInvalid(fit.Process).empty();
      return fit;
    case PointProcess::SoftCore:
      fit = FitSoftCore(points, window, BorderOfSoftCore / std::sqrt(intensity), parallel);
      return fit.Exists ? RefineSoftCore(fit, points, window, parallel) : fit;
    case PointProcess::Strauss:
      fit = FindStraussDistance(points, window, intensity, parallel);
      return fit.Exists ? WithBorder(fit, points, window, parallel) : fit;
    default:
      return hasTrend ? FitByContrast(process, points, window, options, trend, parallel) : fit;
  }
}

}
