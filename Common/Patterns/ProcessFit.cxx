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
/// Distances that are tried for a Strauss process.
constexpr int DistancesTried = 64;

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
/// points or more than all.
bool IsFound(const PointProcessParameters& process, double largest, double points)
{
  if (process.Process == PointProcess::LogGaussianCox)
  {
    return process.Variance > 1e-3 && process.Variance < 10.0 && process.Range < 10.0 * largest &&
      process.Range > 1e-4 * largest;
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
  ProcessFit best;
  best.LogPseudoLikelihood = NaN;
  best.Contrast = std::numeric_limits<double>::infinity();
  // Several starts: the contrast has valleys of small and of wide clusters.
  for (const double first :
    process == PointProcess::LogGaussianCox ? std::array<double, 2>{ 0.3, 2.0 } : std::array<double, 2>{ 0.1, 0.7 })
  {
    for (const double length : { 0.05, 0.15, 0.4 })
    {
      Eigen::VectorXd unknowns(2);
      unknowns << std::log(process == PointProcess::LogGaussianCox ? first : first * intensity),
        std::log(length * largest);
      Eigen::NumericalDiff<Contrast> functor(contrast);
      Eigen::LevenbergMarquardt<Eigen::NumericalDiff<Contrast>> search(functor);
      search.parameters.factor = 1.0;
      search.parameters.maxfev = 400;
      search.parameters.ftol = search.parameters.xtol = 1e-12;
      search.minimize(unknowns);
      const PointProcessParameters found = contrast.Unpack(unknowns);
      const double value = search.fnorm * search.fnorm * largest / static_cast<double>(distances.size());
      if (value < best.Contrast * (1.0 - 1e-9))
      {
        best.Contrast = value;
        best.Process = found;
      }
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

/// Numbers of places, and of points, that have t neighbours within the distance, t = 0, 1, 2...
struct NeighbourCounts
{
  std::vector<double> Points;
  std::vector<double> Places; ///< as areas [m2]
};

/// The other points near a place, by a sort along x.
class Neighbours
{
public:
  explicit Neighbours(std::vector<PlanePosition> points)
    : Sorted(std::move(points))
  {
    std::sort(this->Sorted.begin(), this->Sorted.end());
  }

  const std::vector<PlanePosition>& GetPoints() const { return this->Sorted; }

  std::size_t CountAbout(const PlanePosition& place, double distance) const
  {
    std::size_t count = 0;
    auto at = std::lower_bound(this->Sorted.begin(), this->Sorted.end(), PlanePosition{ place[0] - distance, -1e300 });
    for (; at != this->Sorted.end() && (*at)[0] <= place[0] + distance; ++at)
    {
      const double dx = (*at)[0] - place[0];
      const double dy = (*at)[1] - place[1];
      count += dx * dx + dy * dy < distance * distance;
    }
    return count;
  }

private:
  std::vector<PlanePosition> Sorted;
};

void AddAt(std::vector<double>& counts, std::size_t t, double value)
{
  counts.resize(std::max(counts.size(), t + 1), 0.0);
  counts[t] += value;
}

NeighbourCounts CountNeighbours(
  const Neighbours& points, const ObservationWindow& window, double distance, double border)
{
  NeighbourCounts counts;
  for (const PlanePosition& point : points.GetPoints())
  {
    if (window.DistanceToEdge(point) >= border)
    {
      AddAt(counts.Points, points.CountAbout(point, distance) - 1, 1.0); // but itself
    }
  }
  const PlanePosition& low = window.GetLow();
  const PlanePosition& high = window.GetHigh();
  const std::array<double, 2> step = { (high[0] - low[0]) / PlacesOfSide, (high[1] - low[1]) / PlacesOfSide };
  for (int n = 0; n < PlacesOfSide * PlacesOfSide; ++n)
  {
    const PlanePosition place = { low[0] + (n % PlacesOfSide + 0.5) * step[0],
      low[1] + (n / PlacesOfSide + 0.5) * step[1] };
    if (window.Contains(place) && window.DistanceToEdge(place) >= border)
    {
      AddAt(counts.Places, points.CountAbout(place, distance), step[0] * step[1]);
    }
  }
  return counts;
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

ProcessFit FitStrauss(
  const std::vector<PlanePosition>& points, const ObservationWindow& window, double distance, double border)
{
  const NeighbourCounts counts = CountNeighbours(Neighbours(points), window, distance, border);
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
  const double intensity = static_cast<double>(points.size()) / window.GetArea();
  fit.Exists = fit.Process.Interaction < 0.999 && activity > 0.0 && activity < MaximumActivity * intensity;
  return fit;
}

namespace
{

/// Fit of the Distance with the largest pseudo-likelihood, with the same border for all.
ProcessFit FitStraussDistance(const std::vector<PlanePosition>& points, const ObservationWindow& window,
  double intensity, const ParallelFor& parallel)
{
  const double farthest = std::sqrt(1.5 / (Pi * intensity));
  std::vector<ProcessFit> fits(DistancesTried);
  ForRanges(parallel, fits.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k)
    {
      fits[k] = FitStrauss(points, window, farthest * static_cast<double>(k + 1) / DistancesTried, farthest);
    }
  });
  const auto isBetter = [](const ProcessFit& a, const ProcessFit& b) {
    const auto value = [](const ProcessFit& fit) {
      return fit.Exists ? fit.LogPseudoLikelihood : -std::numeric_limits<double>::infinity();
    };
    return value(a) < value(b);
  };
  return *std::max_element(fits.begin(), fits.end(), isBetter);
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
      return FitStraussDistance(points, window, intensity, parallel);
    default:
      return hasTrend ? FitByContrast(process, points, window, options, trend, parallel) : fit;
  }
}

}
