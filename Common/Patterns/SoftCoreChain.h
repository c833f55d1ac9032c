// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSoftCoreChain_h
#define LittoralSoftCoreChain_h

#include "Numerics/RandomStream.h"
#include "Patterns/ObservationWindow.h"
#include "Patterns/PointProcess.h"
#include "Patterns/ProcessLattice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace littoral
{

/// Smallest potential of two points that counts.
inline constexpr double MinimumPotential = 0.005;

/// Range of the interaction of a soft-core process [m], Distance MinimumPotential^(-Softness / 2).
double SoftCoreReach(const PointProcessParameters& process);

/// Pair potential p(r) = (Distance / r)^(2 / Softness), linear between nodes that are equidistant in r^2: relative
/// errors are within 1e-3 where it is below 10, and within 2 % up to 50, whence it grows as 1 / r^2, since no pair is
/// there.
class SoftCorePotential
{
public:
  explicit SoftCorePotential(const PointProcessParameters& process);

  double GetSquareReach() const { return this->SquareReach; }

  /// Potential at the square of a distance below the reach [m2].
  double operator()(double r2) const
  {
    const double place = (r2 - this->Nearest) * this->PerStep;
    if (place < 0.0)
    {
      return this->Values.front() * this->Nearest / std::max(r2, 1e-6 * this->Nearest);
    }
    const auto node = std::min(static_cast<std::size_t>(place), this->Values.size() - 2);
    const double part = place - static_cast<double>(node);
    return this->Values[node] + part * (this->Values[node + 1] - this->Values[node]);
  }

private:
  double SquareReach;
  double Nearest; ///< square of the distance at the first node [m2]
  double PerStep; ///< nodes on 1 m2
  std::vector<double> Values;
};

/**
 * Markov chain of a given number of points on a torus, moved one by one by Metropolis's rule, accept if u < exp(U(x) -
 * U(x')), with the soft-core process as its equilibrium. The process may change on the way.
 */
class SoftCoreChain
{
public:
  SoftCoreChain(const PointProcessParameters& process, const PatternArea& domain, int seed);

  /// Adds so many points at random places.
  void Fill(std::size_t points);

  /// Moves each point once; the number of a sweep chooses its random numbers.
  void Sweep(int sweep);

  /// Continues from the same places with other parameters.
  void SetProcess(const PointProcessParameters& process);

  const SoftCorePotential& GetPotential() const { return this->Potential; }

  /// Positions of the points from the corner of the domain [m].
  const std::vector<PlanePosition>& GetPlaces() const { return this->Places; }

  /// Calls found(square of the distance) for each pair of points within reach.
  template <typename Found>
  void ForPairs(const Found& found) const
  {
    for (std::size_t n = 0; n < this->Places.size(); ++n)
    {
      this->ForPointsNear(this->Places[n], [&](std::size_t other, double r2) {
        if (other < n)
        {
          found(r2);
        }
        return true;
      });
    }
  }

private:
  /// Calls found(point, square of the distance) for points within reach, until it returns false.
  template <typename Found>
  void ForPointsNear(const PlanePosition& place, const Found& found) const
  {
    const std::size_t i0 = this->IndexOf(place[0], 0);
    const std::size_t j0 = this->IndexOf(place[1], 1);
    const std::size_t columns = std::min<std::size_t>(3, this->Count[0]);
    const std::size_t rows = std::min<std::size_t>(3, this->Count[1]);
    // The square of the place comes first, whose points are the nearest.
    for (std::size_t n = 0; n < columns * rows; ++n)
    {
      const std::size_t i = this->Beside(i0, n % columns, 0);
      const std::size_t j = this->Beside(j0, n / columns, 1);
      for (const std::size_t other : this->Squares[j * this->Count[0] + i])
      {
        const double r2 = this->SquareOfGap(place, this->Places[other]);
        if (r2 < this->Potential.GetSquareReach() && !found(other, r2))
        {
          return;
        }
      }
    }
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

  PlanePosition Moved(const PlanePosition& place, const std::array<double, 2>& u, bool isLeap) const;
  double PotentialAt(const PlanePosition& place, std::size_t except, double most) const;
  void Move(std::size_t n, const PlanePosition& there);

  PatternArea Domain;
  double Step = 0.0; ///< along each axis, at most [m]
  SoftCorePotential Potential;
  RandomStream Starts;
  RandomStream Moves;
  RandomStream Chances;
  std::array<std::size_t, 2> Count{ 1, 1 };
  std::vector<std::vector<std::size_t>> Squares; ///< of the torus, with their points
  std::vector<PlanePosition> Places;
};

}

#endif
