// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/PatternLaw.h"

#include "Numerics/ParameterCheck.h"
#include "Patterns/ProcessPattern.h"

#include <cstddef>
#include <numeric>

namespace littoral
{

namespace
{

ProcessOptions SimulationOf(const PatternLaw& law, int seed)
{
  ProcessOptions options;
  options.Seed = seed;
  options.Raster = law.Trend.Values.empty() ? nullptr : &law.Trend;
  return options;
}

/// Points in the quadrats of a law of counts, each count drawn.
std::vector<PlanePosition> DrawCounts(const PatternLaw& law, const ObservationWindow& window, int seed)
{
  const std::vector<int> counts = QuadratCounts(law.Counts, law.Grid.NumberOfQuadrats(), QuadratMode::Sampling, seed);
  const auto total = static_cast<std::size_t>(std::accumulate(counts.begin(), counts.end(), 0ll));
  std::vector<double> positions(3 * total);
  std::vector<long long> quadrats(total);
  PlaceQuadratPoints(law.Grid, seed, counts, 0, counts.size(), positions.data(), quadrats.data());
  std::vector<PlanePosition> points;
  points.reserve(total);
  for (std::size_t n = 0; n < total; ++n)
  {
    const PlanePosition point{ positions[3 * n], positions[3 * n + 1] };
    if (window.Contains(point))
    {
      points.push_back(point);
    }
  }
  return points;
}

}

std::string WhyInvalid(const PatternLaw& law, const ObservationWindow& window)
{
  if (law.IsProcess)
  {
    return WhyInvalid(law.Process, SimulationOf(law, 1), window);
  }
  ParameterCheck check;
  check.Require(WhyInvalid(law.Counts));
  check.Require(WhyInvalid(law.Grid));
  return check.Reason();
}

double ExpectedDraws(const PatternLaw& law, const ObservationWindow& window)
{
  return law.IsProcess ? ExpectedDraws(law.Process, SimulationOf(law, 1), window)
                       : static_cast<double>(law.Grid.NumberOfQuadrats()) * (1.0 + law.Counts.Mean);
}

std::vector<PlanePosition> DrawPattern(
  const PatternLaw& law, const ObservationWindow& window, int seed, const ParallelFor& parallel)
{
  if (!law.IsProcess)
  {
    return DrawCounts(law, window, seed);
  }
  // One range: the loop asks whether the work is still wanted.
  const Poll poll = [&parallel] { parallel(1, [](std::size_t, std::size_t) {}); };
  return SimulateProcess(law.Process, SimulationOf(law, seed), window, poll, parallel).Points;
}

}
