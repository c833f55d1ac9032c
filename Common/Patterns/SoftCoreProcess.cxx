// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/RandomStream.h"
#include "Patterns/ClusterOffsets.h"
#include "Patterns/ProcessDraws.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace littoral
{

namespace
{

/// One move of a point in four takes it to any place of the torus.
constexpr int SweepsOfLeap = 4;
/// A step along each axis, in mean distances of points, at most.
constexpr double LongestStep = 0.35;
/// A potential above this is that of a pair that cannot be; it keeps sums finite.
constexpr double HighestPotential = 1e6;

/// The points of a soft-core process on a torus, moved by the rule of Metropolis.
class SoftCoreTorus
{
public:
  SoftCoreTorus(const ProcessScene& scene, const PatternArea& domain)
    : Domain(domain)
    , Step(LongestStep / std::sqrt(scene.Process.Intensity))
    , SquareDistance(scene.Process.Distance * scene.Process.Distance)
    , Power(1.0 / scene.Process.Softness)
    , SquareReach(SoftCoreReach(scene.Process) * SoftCoreReach(scene.Process))
    , Moves(scene.Options.Seed, RandomPurpose::ProcessMoves)
    , Chances(scene.Options.Seed, RandomPurpose::ProcessChances)
  {
    for (int axis = 0; axis < 2; ++axis)
    {
      // Fewer than three squares along an axis would be neighbours of each other twice.
      const auto fitting = static_cast<std::size_t>(domain.Size[axis] / SoftCoreReach(scene.Process));
      this->Count[axis] = fitting < 3 ? 1 : std::min<std::size_t>(fitting, 4096);
    }
    this->Squares.resize(this->Count[0] * this->Count[1]);
  }

  /// Points at random places.
  void Fill(const ProcessScene& scene)
  {
    const RandomStream places(scene.Options.Seed, RandomPurpose::ProcessPoints);
    // The number of points has the intensity as its mean: a fraction is one with its probability.
    const RandomStream counts(scene.Options.Seed, RandomPurpose::ProcessCells);
    const double mean = scene.Process.Intensity * this->Domain.Measure();
    const auto points = static_cast<std::size_t>(mean + counts.UniformPair(0, 0)[0]);
    for (std::size_t n = 0; n < points; ++n)
    {
      const auto u = places.UniformPair(0, n);
      this->Places.push_back({ this->Domain.Size[0] * u[0], this->Domain.Size[1] * u[1] });
      this->Squares[this->SquareOf(this->Places[n])].push_back(n);
    }
  }

  /// Moves each point once.
  void Sweep(int sweep)
  {
    for (std::size_t n = 0; n < this->Places.size(); ++n)
    {
      const auto u = this->Moves.UniformPair(static_cast<std::uint64_t>(sweep), n);
      double chance = this->Chances.UniformPair(static_cast<std::uint64_t>(sweep), n)[0];
      MakeLogarithms(1, &chance);
      // A move is made if ln u < U(here) - U(there).
      const PlanePosition there = this->Moved(this->Places[n], u, sweep % SweepsOfLeap == 0);
      const double most = this->PotentialAt(this->Places[n], n, HUGE_VAL) - chance;
      if (this->PotentialAt(there, n, most) < most)
      {
        this->Move(n, there);
      }
    }
  }

  const std::vector<PlanePosition>& GetPlaces() const { return this->Places; }

private:
  PlanePosition Moved(const PlanePosition& place, const std::array<double, 2>& u, bool isLeap) const
  {
    PlanePosition there;
    for (int axis = 0; axis < 2; ++axis)
    {
      const double size = this->Domain.Size[axis];
      const double step = std::min(this->Step, 0.5 * size);
      const double x = isLeap ? size * u[axis] : place[axis] + step * (2.0 * u[axis] - 1.0);
      there[axis] = x < 0.0 ? x + size : x >= size ? x - size : x;
    }
    return there;
  }

  std::size_t IndexOf(double x, int axis) const
  {
    return std::min(this->Count[axis] - 1,
      static_cast<std::size_t>(x / this->Domain.Size[axis] * static_cast<double>(this->Count[axis])));
  }

  std::size_t SquareOf(const PlanePosition& place) const
  {
    return this->IndexOf(place[1], 1) * this->Count[0] + this->IndexOf(place[0], 0);
  }

  /// The square itself, the next or the one before along an axis of the torus: which is 0, 1 or 2.
  std::size_t Beside(std::size_t index, std::size_t which, int axis) const
  {
    return (index + (which == 2 ? this->Count[axis] - 1 : which)) % this->Count[axis];
  }

  double SquareOfGap(const PlanePosition& a, const PlanePosition& b) const
  {
    double sum = 0.0;
    for (int axis = 0; axis < 2; ++axis)
    {
      const double gap = std::abs(a[axis] - b[axis]);
      const double shorter = std::min(gap, this->Domain.Size[axis] - gap);
      sum += shorter * shorter;
    }
    return sum;
  }

  /// U = sum over the other points of (Distance / r)^(2 / Softness), or anything above `most` once it is above.
  double PotentialAt(const PlanePosition& place, std::size_t except, double most) const
  {
    double sum = 0.0;
    const std::size_t i0 = this->IndexOf(place[0], 0);
    const std::size_t j0 = this->IndexOf(place[1], 1);
    const std::size_t columns = std::min<std::size_t>(3, this->Count[0]);
    const std::size_t rows = std::min<std::size_t>(3, this->Count[1]);
    // The square of the place comes first, whose points are the nearest.
    for (std::size_t n = 0; n < columns * rows && sum < most; ++n)
    {
      const std::size_t i = this->Beside(i0, n % columns, 0);
      const std::size_t j = this->Beside(j0, n / columns, 1);
      for (const std::size_t other : this->Squares[j * this->Count[0] + i])
      {
        const double r2 = other == except ? HUGE_VAL : this->SquareOfGap(place, this->Places[other]);
        if (r2 < this->SquareReach)
        {
          sum += std::min(HighestPotential, std::pow(this->SquareDistance / r2, this->Power));
        }
      }
    }
    return sum;
  }

  void Move(std::size_t n, const PlanePosition& there)
  {
    const std::size_t from = this->SquareOf(this->Places[n]);
    const std::size_t to = this->SquareOf(there);
    this->Places[n] = there;
    if (from != to)
    {
      std::vector<std::size_t>& square = this->Squares[from];
      square.erase(std::find(square.begin(), square.end(), n));
      this->Squares[to].push_back(n);
    }
  }

  PatternArea Domain;
  double Step;
  double SquareDistance;
  double Power;
  double SquareReach;
  RandomStream Moves;
  RandomStream Chances;
  std::array<std::size_t, 2> Count{ 1, 1 };
  std::vector<std::vector<std::size_t>> Squares; ///< of the torus, with their points
  std::vector<PlanePosition> Places;             ///< from the corner of the domain
};

}

int SoftCoreSweeps(const PointProcessParameters& process)
{
  const double crowding = process.Intensity * process.Distance * process.Distance;
  return static_cast<int>(std::min(200.0, std::round(20.0 + 400.0 * crowding)));
}

double SoftCoreReach(const PointProcessParameters& process)
{
  return process.Distance * std::pow(LeastPotential, -0.5 * process.Softness);
}

ProcessPattern DrawSoftCore(const ProcessScene& scene)
{
  const PatternArea domain = scene.Box.Grown(StraussMargin(scene.Process));
  SoftCoreTorus torus(scene, domain);
  torus.Fill(scene);
  for (int sweep = 0; sweep < SoftCoreSweeps(scene.Process); ++sweep)
  {
    torus.Sweep(sweep);
    scene.Called();
  }
  ProcessPattern pattern;
  for (std::size_t n = 0; n < torus.GetPlaces().size(); ++n)
  {
    const PlanePosition& place = torus.GetPlaces()[n];
    KeepPoint(scene, { domain.Origin[0] + place[0], domain.Origin[1] + place[1] }, { 0, n }, pattern);
  }
  pattern.IsExact = false;
  return pattern;
}

}
