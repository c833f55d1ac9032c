// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/SoftCoreChain.h"

#include "Patterns/ClusterOffsets.h"

#include <cstdint>

namespace littoral
{

namespace
{

/// One move of a point in four takes it to any place of the torus.
constexpr int SweepsOfLeap = 4;
/// A step along each axis, in mean distances of points, at most.
constexpr double MaximumStep = 0.35;
/// Potentials above this are not tabulated: chance overcomes them once in 5e21 moves.
constexpr double HighestPotential = 50.0;
/// Nodes of the table of potentials.
constexpr std::size_t Nodes = 8192;

}

double SoftCoreReach(const PointProcessParameters& process)
{
  return process.Distance * std::pow(MinimumPotential, -0.5 * process.Softness);
}

SoftCorePotential::SoftCorePotential(const PointProcessParameters& process)
  : SquareReach(SoftCoreReach(process) * SoftCoreReach(process))
  , Nearest(process.Distance * process.Distance * std::pow(HighestPotential, -process.Softness))
  , PerStep(static_cast<double>(Nodes - 1) / (SquareReach - Nearest))
  , Values(Nodes)
{
  for (std::size_t node = 0; node < Nodes; ++node)
  {
    const double r2 = this->Nearest + static_cast<double>(node) / this->PerStep;
    this->Values[node] = std::pow(process.Distance * process.Distance / r2, 1.0 / process.Softness);
  }
}

SoftCoreChain::SoftCoreChain(const PointProcessParameters& process, const PatternArea& domain, int seed)
  : Domain(domain)
  , Potential(process)
  , Starts(seed, RandomPurpose::ProcessPoints)
  , Moves(seed, RandomPurpose::ProcessMoves)
  , Chances(seed, RandomPurpose::ProcessChances)
{
  this->SetProcess(process);
}

void SoftCoreChain::SetProcess(const PointProcessParameters& process)
{
  this->Step = MaximumStep / std::sqrt(process.Intensity);
  this->Potential = SoftCorePotential(process);
  for (int axis = 0; axis < 2; ++axis)
  {
    // Fewer than three squares along an axis would be neighbours of each other twice.
    const auto fitting = static_cast<std::size_t>(this->Domain.Size[axis] / SoftCoreReach(process));
    this->Count[axis] = fitting < 3 ? 1 : std::min<std::size_t>(fitting, 4096);
  }
  this->Squares.assign(this->Count[0] * this->Count[1], {});
  for (std::size_t n = 0; n < this->Places.size(); ++n)
  {
    this->Squares[this->SquareOf(this->Places[n])].push_back(n);
  }
}

void SoftCoreChain::Fill(std::size_t points)
{
  for (std::size_t n = 0; n < points; ++n)
  {
    const auto u = this->Starts.UniformPair(0, n);
    this->Places.push_back({ this->Domain.Size[0] * u[0], this->Domain.Size[1] * u[1] });
    this->Squares[this->SquareOf(this->Places[n])].push_back(n);
  }
}

void SoftCoreChain::Sweep(int sweep)
{
  for (std::size_t n = 0; n < this->Places.size(); ++n)
  {
    const auto u = this->Moves.UniformPair(static_cast<std::uint64_t>(sweep), n);
    double chance = this->Chances.UniformPair(static_cast<std::uint64_t>(sweep), n)[0];
    MakeLogarithms(1, &chance);
    // Metropolis: accept if ln u < U(here) - U(there).
    const PlanePosition there = this->Moved(this->Places[n], u, sweep % SweepsOfLeap == 0);
    const double most = this->PotentialAt(this->Places[n], n, HUGE_VAL) - chance;
    if (this->PotentialAt(there, n, most) < most)
    {
      this->Move(n, there);
    }
  }
}

PlanePosition SoftCoreChain::Moved(const PlanePosition& place, const std::array<double, 2>& u, bool isLeap) const
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

/// U(x) = sum over the other points of (Distance / r)^(2 / Softness); any number above `most` if it is above.
double SoftCoreChain::PotentialAt(const PlanePosition& place, std::size_t except, double most) const
{
  double sum = 0.0;
  this->ForPointsNear(place, [&](std::size_t other, double r2) {
    sum += other == except ? 0.0 : this->Potential(r2);
    return sum < most;
  });
  return sum;
}

void SoftCoreChain::Move(std::size_t n, const PlanePosition& there)
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

}
