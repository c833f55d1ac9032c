// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/ProcessPattern.h"

#include "Numerics/ParameterCheck.h"
#include "Numerics/RandomStream.h"
#include "Patterns/ClusterOffsets.h"
#include "Patterns/ProcessDraws.h"
#include "Patterns/SpeciesDraw.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace littoral
{

namespace
{

/// More points, parents or cells of a field than this are hardly meant.
constexpr double MaximumDraws = 1e9;
/// More births at one time, or points that are moved again and again, than this take minutes.
constexpr double MaximumAlive = 5e5;
/// Number in the lower half of the draw that names the cluster in place of one of its points: none has so many.
constexpr std::uint64_t WholeCluster = 0xffffffff;
/// Points drawn at a time, more or less.
constexpr double PointsOfTask = 1 << 14;
/// Points whose species or marks are drawn at a time.
constexpr std::size_t PointsOfRange = 1 << 14;

PatternArea BoxOf(const ObservationWindow& window)
{
  const PlanePosition& low = window.GetLow();
  const PlanePosition& high = window.GetHigh();
  return { low, { high[0] - low[0], high[1] - low[1] } };
}

IntensityFactor FactorOf(const ProcessOptions& options)
{
  return options.Raster ? IntensityFactor(*options.Raster) : IntensityFactor();
}

/// Process of the highest intensity of the raster, before thinning.
PointProcessParameters Highest(const PointProcessParameters& process, const ProcessOptions& options)
{
  PointProcessParameters highest = process;
  if (options.Raster)
  {
    double& intensity = process.Process == PointProcess::Strauss ? highest.Activity : highest.Intensity;
    intensity = options.Raster->Scale == IntensityScale::Absolute ? options.Raster->Mean() : intensity;
    const double factor = FactorOf(options).Highest();
    intensity *= factor;
    highest.ClusterSize *= factor;
  }
  return highest;
}

bool HasClusters(const PointProcessParameters& process)
{
  return TraitsOf(process.Process).Offsets != nullptr;
}

/// Side of the smallest squares in which anything is drawn.
double SmallestSide(const PointProcessParameters& process)
{
  if (HasClusters(process))
  {
    return DrawingSide(ParentIntensity(process));
  }
  switch (process.Process)
  {
    case PointProcess::LogGaussianCox:
      return FieldSide(process);
    case PointProcess::Strauss:
      return DrawingSide(process.Activity);
    default:
      return DrawingSide(process.Intensity);
  }
}

/// Species of each point, of a draw of its own or of its cluster.
std::vector<int> DrawSpecies(const ProcessPattern& pattern, const ProcessOptions& options, const ParallelFor& parallel)
{
  const SpeciesDraw speciesOf(options);
  const bool isOfCluster = pattern.HasClusters && options.Grouping == SpeciesGrouping::Clusters;
  const std::uint64_t whole = isOfCluster ? WholeCluster : 0;
  std::vector<int> species(pattern.Identities.size());
  ForRanges(parallel, species.size(), PointsOfRange, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      const PointIdentity& identity = pattern.Identities[n];
      species[n] = speciesOf({ identity.Object, identity.Draw | whole });
    }
  });
  return species;
}

/// Joins the numbers of one kind of all parts, and frees them.
template <typename Number>
void Join(std::vector<Number> ProcessPattern::*numbers, std::vector<ProcessPattern>& parts, ProcessPattern& pattern)
{
  std::size_t count = 0;
  for (const ProcessPattern& part : parts)
  {
    count += (part.*numbers).size();
  }
  (pattern.*numbers).reserve(count);
  for (ProcessPattern& part : parts)
  {
    const std::vector<Number> from = std::move(part.*numbers);
    (pattern.*numbers).insert((pattern.*numbers).end(), from.begin(), from.end());
  }
}

/// Drops the points that are in the box of a polygon only.
void CutToWindow(const ObservationWindow& window, ProcessPattern& pattern)
{
  std::size_t kept = 0;
  for (std::size_t n = 0; n < pattern.Points.size(); ++n)
  {
    if (window.Contains(pattern.Points[n]))
    {
      pattern.Points[kept] = pattern.Points[n];
      pattern.Identities[kept] = pattern.Identities[n];
      if (!pattern.Species.empty())
      {
        pattern.Species[kept] = pattern.Species[n];
      }
      ++kept;
    }
  }
  pattern.Points.resize(kept);
  pattern.Identities.resize(kept);
  pattern.Species.resize(pattern.Species.empty() ? 0 : kept);
}

std::string WhyInvalidSpecies(const ProcessOptions& options)
{
  ParameterCheck check;
  double sum = 0.0;
  for (const double share : options.SpeciesShares)
  {
    check.NotNegative("A share of the species", share);
    sum += share;
  }
  check.Require(options.SpeciesShares.empty() || !check.IsGood() || sum > 0.0, "All shares of the species are 0.");
  check.Choice("SpeciesGrouping", static_cast<int>(options.Grouping), { "points", "clusters" });
  check.Range("CrossInteraction", options.CrossInteraction, 0.0, 1.0);
  return check.Reason();
}

std::string WhyTooMuch(
  const PointProcessParameters& process, const ProcessOptions& options, const ObservationWindow& window)
{
  const double draws = ExpectedDraws(process, options, window);
  const bool isAlive = process.Process == PointProcess::Strauss || process.Process == PointProcess::SoftCore;
  const double most = isAlive ? MaximumAlive : MaximumDraws;
  const double side = SmallestSide(Highest(process, options));
  double farthest = 0.0;
  for (int axis = 0; axis < 2; ++axis)
  {
    farthest = std::max({ farthest, std::abs(window.GetLow()[axis]), std::abs(window.GetHigh()[axis]) });
  }
  ParameterCheck check;
  check.Require(draws <= most,
    "The process takes " + TextOf(draws) + " draws in this window, and at most " + TextOf(most) +
      " are made; take a smaller window or other parameters.");
  check.Require(farthest < 0.5 * ProcessLattice::MaximumIndex * side,
    "The window lies too far from the origin for so many points; move it nearer.");
  return check.Reason();
}

}

double DrawingSide(double intensity)
{
  return std::sqrt(4.0 / intensity);
}

ProcessPattern DrawSquares(
  const ProcessScene& scene, const CellBlock& block, double each, const std::function<SquareTask()>& makeTask)
{
  const std::size_t squares = block.Columns() * block.Rows();
  const auto atOnce = static_cast<std::size_t>(std::clamp(PointsOfTask / std::max(each, 1e-9), 1.0, PointsOfTask));
  const std::size_t tasks = (squares + atOnce - 1) / atOnce;
  std::vector<ProcessPattern> parts(tasks);
  scene.Parallel(tasks, [&](std::size_t begin, std::size_t end) {
    const SquareTask task = makeTask();
    for (std::size_t part = begin; part < end; ++part)
    {
      for (std::size_t q = part * atOnce; q < std::min(squares, (part + 1) * atOnce); ++q)
      {
        task(block.First[0] + static_cast<long long>(q % block.Columns()),
          block.First[1] + static_cast<long long>(q / block.Columns()), parts[part]);
      }
    }
  });
  return Joined(parts, scene.Parallel);
}

ProcessPattern Joined(std::vector<ProcessPattern>& parts, const ParallelFor& parallel)
{
  if (parts.size() == 1)
  {
    return std::move(parts.front());
  }
  ProcessPattern pattern;
  ForRanges(parallel, 2, 1, [&](std::size_t begin, std::size_t end) {
    if (begin == 0)
    {
      Join(&ProcessPattern::Points, parts, pattern);
    }
    if (end == 2)
    {
      Join(&ProcessPattern::Identities, parts, pattern);
    }
  });
  return pattern;
}

void KeepPoint(
  const ProcessScene& scene, const PlanePosition& point, const PointIdentity& identity, ProcessPattern& pattern)
{
  if (!scene.Box.Contains(point[0], point[1]))
  {
    return;
  }
  if (!scene.Factor.IsOne())
  {
    const RandomStream random(scene.Options.Seed, RandomPurpose::ProcessThinning);
    const double u = random.UniformPair(identity.Object, identity.Draw)[0];
    if (u >= scene.Factor.ShareAt(point[0], point[1]))
    {
      return;
    }
  }
  pattern.Points.push_back(point);
  pattern.Identities.push_back(identity);
}

double ExpectedDraws(
  const PointProcessParameters& process, const ProcessOptions& options, const ObservationWindow& window)
{
  const PointProcessParameters highest = Highest(process, options);
  const PatternArea box = BoxOf(window);
  if (HasClusters(process))
  {
    return box.Grown(ClusterReach(highest)).Measure() * (highest.Intensity + ParentIntensity(highest));
  }
  switch (process.Process)
  {
    case PointProcess::LogGaussianCox:
      return box.Grown(FieldSide(highest)).Measure() *
        (highest.Intensity + 1.0 / (FieldSide(highest) * FieldSide(highest)));
    case PointProcess::MaternII:
      return box.Grown(highest.Distance).Measure() * ProposedIntensity(highest.Intensity, highest.Distance);
    case PointProcess::Strauss:
      return box.Grown(StraussMargin(highest)).Measure() * highest.Activity;
    case PointProcess::SoftCore:
      return box.Grown(StraussMargin(highest)).Measure() * highest.Intensity;
    default:
      return box.Measure() * highest.Intensity;
  }
}

std::string WhyInvalid(
  const PointProcessParameters& process, const ProcessOptions& options, const ObservationWindow& window)
{
  ParameterCheck check;
  check.Require(window.WhyInvalid());
  check.Require(options.Raster ? WhyInvalid(*options.Raster) : std::string());
  check.Require(WhyInvalidSpecies(options));
  check.Require(WhyInvalid(process));
  if (!check.IsGood())
  {
    return check.Reason();
  }
  const PointProcessParameters highest = Highest(process, options);
  if (options.Raster)
  {
    const std::string why = WhyInvalid(highest);
    check.Require(why.empty(), "Where the image of the intensity is highest: " + why);
  }
  return check.IsGood() ? WhyTooMuch(process, options, window) : check.Reason();
}

ProcessPattern SimulateProcess(const PointProcessParameters& process, const ProcessOptions& options,
  const ObservationWindow& window, const Poll& poll, const ParallelFor& parallel)
{
  using Draw = ProcessPattern (*)(const ProcessScene&);
  // Processes in the order of the enumeration; null: of clusters.
  static constexpr Draw Draws[] = { DrawPoisson, nullptr, nullptr, DrawCox, DrawMaternII, DrawStrauss, DrawSoftCore };
  const ProcessScene scene{ Highest(process, options), options, FactorOf(options), BoxOf(window), poll, parallel };
  const bool isOfClusters = HasClusters(process);
  ProcessPattern pattern = isOfClusters ? DrawClusters(scene) : Draws[static_cast<int>(process.Process)](scene);
  pattern.HasClusters = isOfClusters;
  if (!options.SpeciesShares.empty())
  {
    pattern.Species = DrawSpecies(pattern, options, parallel);
  }
  if (!window.IsRectangle())
  {
    CutToWindow(window, pattern);
  }
  return pattern;
}

std::string WhyInvalid(const MarkOptions& options)
{
  ParameterCheck check;
  check.Positive("MarkMean", options.Mean);
  check.Range("MarkVariation", options.Variation, 0.0, 3.0);
  check.Range("MarkClusterCorrelation", options.ClusterCorrelation, 0.0, 1.0);
  return check.Reason();
}

std::vector<double> DrawMarks(const ProcessPattern& pattern, const MarkOptions& options, const ParallelFor& parallel)
{
  const RandomStream random(options.Seed, RandomPurpose::ProcessMarks);
  const double s2 = std::log1p(options.Variation * options.Variation);
  const double rho = pattern.HasClusters ? options.ClusterCorrelation : 0.0;
  const double common = std::sqrt(s2 * rho);
  const double own = std::sqrt(s2 * (1.0 - rho));
  std::vector<double> marks(pattern.Identities.size());
  ForRanges(parallel, marks.size(), PointsOfRange, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      const PointIdentity& identity = pattern.Identities[n];
      const double z = random.NormalPair(identity.Object, identity.Draw)[0];
      const double parent = random.NormalPair(identity.Object, identity.Draw | WholeCluster)[1];
      marks[n] = options.Mean * std::exp(-0.5 * s2 + own * z + common * parent);
    }
  });
  return marks;
}

}
