// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Kriging/FieldAtData.h"

#include "Kriging/Kriging.h"
#include "Kriging/PlaceTree.h"

#include <Eigen/Cholesky>
#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

namespace littoral
{

namespace
{

/// Parts of a spacing within which a place is a point of the grid.
constexpr double SnapDistance = 1e-6;
/// Spacings from the origin beyond which the indices of points are no numbers any more.
constexpr double FarthestIndex = 1e9;
/// Radius of the neighbourhood of a datum for its short waves [mean spacings].
constexpr double DrawRadius = 3.0;
/// Data before in the list that take part, at most, and data that are searched for them.
constexpr std::size_t MaximumDataBefore = 16;
constexpr std::size_t DataLookedAt = 33;
/// Nugget as a part of the variance that keeps a system solvable where data are at one place.
constexpr double Jitter = 1e-9;

/// A place in columns and rows of a grid.
struct GridPosition
{
  double Column;
  double Row;

  GridPosition(const PlaneGrid& grid, const KrigingPlace& place)
    : Column((place.X - grid.Origin[0]) / grid.Spacing[0])
    , Row((place.Y - grid.Origin[1]) / grid.Spacing[1])
  {
  }

  bool IsPoint() const
  {
    return std::abs(this->Column - std::round(this->Column)) <= SnapDistance &&
      std::abs(this->Row - std::round(this->Row)) <= SnapDistance;
  }

  bool IsWithin(const GridWindow& window) const
  {
    return this->Column >= window.First[0] && this->Column <= window.Last[0] && this->Row >= window.First[1] &&
      this->Row <= window.Last[1];
  }

  /// Reduced coordinates, in which the field is isotropic [m].
  ReducedPlace Reduced(const PlaneLattice& lattice) const
  {
    return { this->Column * lattice.StepX[0] + this->Row * lattice.StepY[0],
      this->Column * lattice.StepX[1] + this->Row * lattice.StepY[1] };
  }
};

/// Simple kriging of the short waves at a datum.
struct ShortDraw
{
  double FromPoints = 0.0;       ///< sum over the points of the grid
  std::vector<std::size_t> Data; ///< data before it in the list
  std::vector<double> Weights;   ///< kriging weights of their short waves
  double Deviation = 0.0;        ///< kriging standard deviation
};

/// Draws the short waves at data, given those at the points of a grid.
class ShortDraws
{
public:
  ShortDraws(const ShortWaves& waves, const PlaneLattice& lattice, const std::vector<GridPosition>& positions,
    const std::vector<char>& isOff)
    : Waves(waves)
    , Lattice(lattice)
    , Positions(positions)
    , IsOff(isOff)
    , Reduced(ReduceAll(lattice, positions))
    , Tree(Reduced)
  {
    const double area = std::abs(lattice.StepX[0] * lattice.StepY[1] - lattice.StepX[1] * lattice.StepY[0]);
    this->Radius = DrawRadius * std::sqrt(area);
    // The box of a circle in the grid's indices, as that of the moving average
    this->Reach = { std::min(MaximumReach, this->Radius * std::hypot(lattice.StepY[0], lattice.StepY[1]) / area),
      std::min(MaximumReach, this->Radius * std::hypot(lattice.StepX[0], lattice.StepX[1]) / area) };
  }

  ShortDraw Prepare(std::size_t datum) const
  {
    std::vector<ReducedPlace> places;
    std::vector<double> values;
    this->AddPoints(datum, places, values);
    ShortDraw draw;
    std::vector<std::size_t> near;
    this->Tree.Nearest(this->Reduced[datum], std::min(DataLookedAt, this->Reduced.size()), near);
    for (const std::size_t other : near)
    {
      const bool tells = other < datum && this->IsOff[other] && draw.Data.size() < MaximumDataBefore &&
        Distance(this->Reduced[datum], this->Reduced[other]) <= this->Radius;
      if (tells)
      {
        draw.Data.push_back(other);
        places.push_back(this->Reduced[other]);
      }
    }
    const auto count = static_cast<Eigen::Index>(places.size());
    const double variance = this->Waves.CovarianceAt(0.0);
    Eigen::MatrixXd covariances(count, count);
    Eigen::VectorXd right(count);
    for (Eigen::Index j = 0; j < count; ++j)
    {
      covariances(j, j) = variance * (1.0 + Jitter);
      for (Eigen::Index i = j + 1; i < count; ++i)
      {
        covariances(i, j) = this->Waves.CovarianceAt(Distance(places[i], places[j]));
      }
      right(j) = this->Waves.CovarianceAt(Distance(places[j], this->Reduced[datum]));
    }
    // Simple kriging: K l = k, variance C(0) - l'k
    const Eigen::LDLT<Eigen::MatrixXd> factor(covariances);
    const Eigen::VectorXd weights = factor.solve(right);
    for (std::size_t n = 0; n < values.size(); ++n)
    {
      draw.FromPoints += weights(static_cast<Eigen::Index>(n)) * values[n];
    }
    for (std::size_t n = values.size(); n < places.size(); ++n)
    {
      draw.Weights.push_back(weights(static_cast<Eigen::Index>(n)));
    }
    draw.Deviation = std::sqrt(std::max(0.0, variance - weights.dot(right)));
    return draw;
  }

private:
  /// Columns and rows on either side, at most: on a grid of very unequal spacings.
  static constexpr double MaximumReach = 30.0;

  static std::vector<ReducedPlace> ReduceAll(const PlaneLattice& lattice, const std::vector<GridPosition>& positions)
  {
    std::vector<ReducedPlace> reduced;
    for (const GridPosition& position : positions)
    {
      reduced.push_back(position.Reduced(lattice));
    }
    return reduced;
  }

  static double Distance(const ReducedPlace& a, const ReducedPlace& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

  /// The points of the grid around a datum, and the short waves there.
  void AddPoints(std::size_t datum, std::vector<ReducedPlace>& places, std::vector<double>& values) const
  {
    const GridPosition& position = this->Positions[datum];
    const int first[2] = { static_cast<int>(std::ceil(position.Column - this->Reach[0])),
      static_cast<int>(std::ceil(position.Row - this->Reach[1])) };
    const int last[2] = { static_cast<int>(std::floor(position.Column + this->Reach[0])),
      static_cast<int>(std::floor(position.Row + this->Reach[1])) };
    const int width = last[0] - first[0] + 1;
    const int height = last[1] - first[1] + 1;
    if (width <= 0 || height <= 0)
    {
      return;
    }
    std::vector<float> patch;
    this->Waves.Fill(first[0], first[1], width, height, patch);
    for (int j = 0; j < height; ++j)
    {
      for (int i = 0; i < width; ++i)
      {
        GridPosition point = position;
        point.Column = first[0] + i;
        point.Row = first[1] + j;
        const ReducedPlace place = point.Reduced(this->Lattice);
        if (Distance(place, this->Reduced[datum]) <= this->Radius)
        {
          places.push_back(place);
          values.push_back(patch[static_cast<std::size_t>(j) * width + i]);
        }
      }
    }
  }

  const ShortWaves& Waves;
  const PlaneLattice& Lattice;
  const std::vector<GridPosition>& Positions;
  const std::vector<char>& IsOff;
  std::vector<ReducedPlace> Reduced;
  PlaceTree Tree;
  double Radius;
  std::array<double, 2> Reach;
};

}

void SnapToGrid(const PlaneGrid& grid, std::vector<KrigingPlace>& places)
{
  for (KrigingPlace& place : places)
  {
    const GridPosition position(grid, place);
    const bool isNear = std::abs(position.Column) < FarthestIndex && std::abs(position.Row) < FarthestIndex;
    if (isNear && position.IsPoint())
    {
      const KrigingPlace point =
        PlaceOfPoint(grid, static_cast<int>(std::round(position.Column)), static_cast<int>(std::round(position.Row)));
      place.X = point.X;
      place.Y = point.Y;
    }
  }
}

std::vector<double> FieldAtData(const TurningBandsField& field, const TurningBandsParameters& parameters,
  const PlaneGrid& grid, const GridWindow& window, const std::vector<KrigingPlace>& places, const ParallelFor& parallel)
{
  std::vector<GridPosition> positions;
  std::vector<char> isOff;
  for (const KrigingPlace& place : places)
  {
    positions.emplace_back(grid, place);
    const GridPosition& position = positions.back();
    if (!(std::abs(position.Column) < FarthestIndex && std::abs(position.Row) < FarthestIndex))
    {
      throw KrigingFailure("Datum " + std::to_string(positions.size() - 1) +
        " is more than 1e9 spacings from the grid; data and grid must be in the same coordinates.");
    }
    isOff.push_back(position.IsWithin(window) && position.IsPoint() ? 0 : 1);
  }
  std::vector<double> values(places.size());
  parallel(places.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      const GridPosition& position = positions[n];
      if (!isOff[n])
      {
        values[n] =
          field.ValueAtPoint(static_cast<int>(std::round(position.Column)), static_cast<int>(std::round(position.Row)));
      }
      else if (position.IsWithin(window))
      {
        values[n] = field.LongWavesAt(position.Column, position.Row);
      }
      else
      {
        values[n] = field.ValueAt(places[n].X, places[n].Y);
      }
    }
  });
  const ShortWaves* waves = field.GetShortWaves();
  if (!waves || std::none_of(isOff.begin(), isOff.end(), [](char off) { return off != 0; }))
  {
    return values;
  }
  const ShortDraws draws(*waves, field.GetLattice(), positions, isOff);
  std::vector<ShortDraw> prepared(places.size());
  parallel(places.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      prepared[n] = isOff[n] ? draws.Prepare(n) : ShortDraw();
    }
  });
  const RandomStream random(parameters.Seed, RandomPurpose::DatumShortWaves);
  std::vector<double> shortWaves(places.size(), 0.0);
  for (std::size_t n = 0; n < places.size(); ++n)
  {
    const ShortDraw& draw = prepared[n];
    double sum = draw.FromPoints + draw.Deviation * random.NormalPair(n, 0)[0];
    for (std::size_t m = 0; m < draw.Data.size(); ++m)
    {
      sum += draw.Weights[m] * shortWaves[draw.Data[m]];
    }
    shortWaves[n] = isOff[n] ? sum : 0.0;
    values[n] += shortWaves[n];
  }
  return values;
}

}
