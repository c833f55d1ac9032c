// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/PointCells.h"
#include "Patterns/ProcessDraws.h"
#include "Patterns/ProcessFit.h"
#include "Patterns/SoftCoreChain.h"
#include "Patterns/WindowSections.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace littoral
{

namespace
{

/// Iterations of stochastic approximation, and those after which steps become shorter.
constexpr int Rounds = 24;
constexpr int FreeRounds = 8;
/// Sweeps of an iteration; every second one is measured.
constexpr int SweepsOfRound = 40;
/// Steps of ln Distance and of Softness, at most.
constexpr std::array<double, 2> MaximumSteps = { 0.15, 0.1 };
/// Softnesses.
constexpr double Hardest = 0.05;
constexpr double Softest = 0.8;
/// Distances in mean distances of points.
constexpr double MinimumCore = 0.02;
constexpr double MaximumCore = 1.4;
/// Seed of the simulations, which are those of no user's seed that is likely.
constexpr int SeedOfFit = 1984110513;

/// Derivatives by ln Distance and by Softness.
using Slopes = std::array<double, 2>;

/// Derivatives of the potential p = (Distance / r)^(2 / Softness): 2 p / Softness, and -p ln p / Softness.
Slopes SlopesOf(double potential, double softness)
{
  return { 2.0 * potential / softness, -potential * std::log(potential) / softness };
}

/// Means, variances and covariance of the slopes of patterns.
struct SlopeMoments
{
  std::vector<Slopes> Samples;

  Slopes Mean() const
  {
    Slopes mean{ 0.0, 0.0 };
    for (const Slopes& each : this->Samples)
    {
      mean[0] += each[0] / static_cast<double>(this->Samples.size());
      mean[1] += each[1] / static_cast<double>(this->Samples.size());
    }
    return mean;
  }

  /// 00, 01, 11
  std::array<double, 3> Covariance() const
  {
    const Slopes mean = this->Mean();
    std::array<double, 3> sums{ 0.0, 0.0, 0.0 };
    for (const Slopes& each : this->Samples)
    {
      const double d0 = each[0] - mean[0];
      const double d1 = each[1] - mean[1];
      sums[0] += d0 * d0;
      sums[1] += d0 * d1;
      sums[2] += d1 * d1;
    }
    for (double& sum : sums)
    {
      sum /= static_cast<double>(this->Samples.size() - 1);
    }
    return sums;
  }
};

/// Sums over the pairs of the measured pattern.
class MeasuredPairs
{
public:
  MeasuredPairs(const std::vector<PlanePosition>& points, const ObservationWindow& window, double unit)
    : Cells(points, unit)
    , Farthest(0.5 * std::min(window.GetHigh()[0] - window.GetLow()[0], window.GetHigh()[1] - window.GetLow()[1]))
    , Areas(window, Farthest)
    , Scale(2.0 * window.GetArea() * window.GetArea() /
        (static_cast<double>(points.size()) * (static_cast<double>(points.size()) - 1.0)))
  {
  }

  /// Maximum distance of the pairs, at which moved windows still share half of each side [m].
  double GetFarthest() const { return this->Farthest; }

  /// Integral of g times the slopes: 2 |W|^2 / (n (n - 1)) sum over pairs of slope / |W and W moved|.
  Slopes Find(const PointProcessParameters& process) const
  {
    const SoftCorePotential potential(process);
    const double reach = std::min(this->Farthest, std::sqrt(potential.GetSquareReach()));
    Slopes sums{ 0.0, 0.0 };
    for (std::size_t n = 0; n < this->Cells.Size(); ++n)
    {
      const double x = this->Cells.GetX()[n];
      const double y = this->Cells.GetY()[n];
      this->Cells.ForRangesNear(x, y, reach, 0, [&](std::size_t begin, std::size_t end) {
        for (std::size_t other = begin; other < std::min(n, end); ++other)
        {
          const double dx = this->Cells.GetX()[other] - x;
          const double dy = this->Cells.GetY()[other] - y;
          const double r2 = dx * dx + dy * dy;
          if (r2 < reach * reach)
          {
            const Slopes slopes = SlopesOf(potential(r2), process.Softness);
            const double weight = this->Scale / this->Areas(dx, dy);
            sums[0] += weight * slopes[0];
            sums[1] += weight * slopes[1];
          }
        }
      });
    }
    return sums;
  }

private:
  PointCells Cells;
  double Farthest;
  CommonAreaTable Areas;
  double Scale;
};

/// Sums of the slopes over the pairs of a simulated pattern up to a distance.
Slopes SumOfPairs(const SoftCoreChain& chain, double softness, double farthest)
{
  Slopes sums{ 0.0, 0.0 };
  chain.ForPairs([&](double r2) {
    if (r2 < farthest * farthest)
    {
      const Slopes slopes = SlopesOf(chain.GetPotential()(r2), softness);
      sums[0] += slopes[0];
      sums[1] += slopes[1];
    }
  });
  return sums;
}

/// The step of Newton's method for differences d and their derivatives C by the parameters; within bounds.
Slopes StepOf(const Slopes& d, const std::array<double, 3>& c, double softness)
{
  const double determinant = c[0] * c[2] - c[1] * c[1];
  const auto shortened = [](double step, int which) {
    return std::isfinite(step) ? std::clamp(step, -MaximumSteps[which], MaximumSteps[which]) : 0.0;
  };
  const double own = shortened((c[0] * d[1] - c[1] * d[0]) / determinant, 1);
  // Where the softness ends, the distance goes on alone.
  const double next = std::clamp(softness + own, Hardest, Softest);
  const double step = next - softness;
  return { shortened((d[0] - c[1] * step) / c[0], 0), step };
}

}

ProcessFit RefineSoftCore(const ProcessFit& start, const std::vector<PlanePosition>& points,
  const ObservationWindow& window, const ParallelFor& parallel)
{
  ProcessFit fit = start;
  PointProcessParameters& process = fit.Process;
  const double unit = 1.0 / std::sqrt(process.Intensity);
  const MeasuredPairs measured(points, window, unit);
  const PlanePosition& low = window.GetLow();
  const PlanePosition& high = window.GetHigh();
  const PatternArea box = { low, { high[0] - low[0], high[1] - low[1] } };
  const PatternArea domain = box.Grown(StraussMargin(process));
  const double simulated = std::max(2.0, std::round(process.Intensity * domain.Measure()));
  const double scale = 2.0 * domain.Measure() / (simulated * (simulated - 1.0));
  SoftCoreChain chain(process, domain, SeedOfFit);
  chain.Fill(static_cast<std::size_t>(simulated));
  int sweep = 0;
  const auto sweepUntil = [&](int end, const std::function<void()>& measure) {
    // One range: it asks whether the work is still wanted.
    parallel(1, [&](std::size_t, std::size_t) {
      for (; sweep < end; ++sweep)
      {
        chain.Sweep(sweep);
        if (sweep % 2 == 1)
        {
          measure();
        }
      }
    });
  };
  sweepUntil(SoftCoreSweeps(process), [] {});
  std::array<double, 3> derivatives{ 0.0, 0.0, 0.0 };
  for (int round = 0; round < Rounds; ++round)
  {
    chain.SetProcess(process);
    SlopeMoments moments;
    sweepUntil(sweep + SweepsOfRound,
      [&] { moments.Samples.push_back(SumOfPairs(chain, process.Softness, measured.GetFarthest())); });
    // Score: expectation of the model minus the measured sums; its derivatives are minus the covariances.
    const Slopes mean = moments.Mean();
    const Slopes wanted = measured.Find(process);
    const Slopes differences = { scale * mean[0] - wanted[0], scale * mean[1] - wanted[1] };
    const std::array<double, 3> covariance = moments.Covariance();
    for (std::size_t k = 0; k < derivatives.size(); ++k)
    {
      derivatives[k] += (scale * covariance[k] - derivatives[k]) / (round + 1.0);
    }
    const Slopes step = StepOf(differences, derivatives, process.Softness);
    // Robbins and Monro: later steps are shorter, so that their mean is what remains.
    const double gain = 1.0 / std::max(1, round - FreeRounds + 2);
    const double longest = MaximumCore * unit;
    process.Distance = std::clamp(process.Distance * std::exp(gain * step[0]), MinimumCore * unit, longest);
    process.Softness += gain * step[1];
  }
  return fit;
}

}
