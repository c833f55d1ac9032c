// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Kriging/CovarianceTable.h"

#include "Numerics/SimdClones.h"

#include <algorithm>
#include <limits>

namespace littoral
{

namespace
{

/// Largest difference of table and model, in parts of the variance, and steps in a row that keep it where the table
/// begins.
constexpr double Tolerance = 1e-9;
constexpr std::size_t StepsInARow = 16;
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

constexpr std::size_t Places = CovarianceTable::PlacesAtOnce;

/// Distances of a datum from some places, in steps of the table.
LITTORAL_INLINE void PositionsOf(const std::array<ReducedPlace, Places>& places, const ReducedPlace& datum,
  double stepsPerMetre, double* distances, double* positions)
{
  for (std::size_t p = 0; p < Places; ++p)
  {
    const double x = places[p][0] - datum[0];
    const double y = places[p][1] - datum[1];
    distances[p] = std::sqrt(x * x + y * y);
    positions[p] = distances[p] * stepsPerMetre;
  }
}

}

CovarianceTable::CovarianceTable(const CovarianceParameters& field, double farthest, std::size_t steps)
  : Field(field)
{
  const double length = std::max(farthest, 1e-9 * field.Range) / static_cast<double>(steps);
  // Ends of the steps at even places, their middles at odd ones.
  std::vector<double> distances(2 * steps + 1);
  for (std::size_t n = 0; n < distances.size(); ++n)
  {
    distances[n] = 0.5 * length * static_cast<double>(n);
  }
  const CorrelationTable model = TabulateCorrelation(field, distances);
  const auto value = [&](std::size_t n) { return field.Variance * (1.0 - model.Uncorrelation[n]); };
  // dC/dt over a step, t from 0 to 1; where r = 0 it is of no use, since the first step is the model itself.
  const auto change = [&](std::size_t n) {
    return n > 0 ? field.Variance * model.ByDistance[n] / distances[n] * length : 0.0;
  };
  this->Cubics.resize(steps);
  std::size_t good = 0;
  std::size_t first = 0;
  for (std::size_t step = 0; step < steps; ++step)
  {
    // Hermite: c + d t + (3 D - 2 d - e) t^2 + (d + e - 2 D) t^3, D the difference over the step, d and e its slopes
    const double c = value(2 * step);
    const double d = change(2 * step);
    const double e = change(2 * step + 2);
    const double difference = value(2 * step + 2) - c;
    this->Cubics[step] = { c, d, 3.0 * difference - 2.0 * d - e, d + e - 2.0 * difference };
    const auto& cubic = this->Cubics[step];
    const double middle = cubic[0] + 0.5 * (cubic[1] + 0.5 * (cubic[2] + 0.5 * cubic[3]));
    const bool isClose = std::abs(middle - value(2 * step + 1)) <= Tolerance * field.Variance;
    this->Cubics[step][0] = isClose ? cubic[0] : NaN;
    good = isClose && step > 0 ? good + 1 : 0;
    first = first == 0 && good == StepsInARow ? step + 1 - StepsInARow : first;
  }
  this->StepsPerMetre = 1.0 / length;
  this->FirstPosition = static_cast<double>(first > 0 ? first : steps);
  this->LastPosition = static_cast<double>(steps);
}

LITTORAL_SIMD_CLONES void CovarianceTable::AddWeighted(const std::array<ReducedPlace, PlacesAtOnce>& places,
  const std::vector<ReducedPlace>& data, const double* weights, std::array<double, PlacesAtOnce>& sums) const
{
  const std::array<double, 4>* cubics = this->Cubics.data();
  double own[Places] = { sums[0], sums[1], sums[2], sums[3] };
  for (std::size_t n = 0; n < data.size(); ++n)
  {
    double distances[Places];
    double positions[Places];
    PositionsOf(places, data[n], this->StepsPerMetre, distances, positions);
    for (std::size_t p = 0; p < Places; ++p)
    {
      // the step that lies there, or any one where the table holds none
      const bool isInside = positions[p] >= this->FirstPosition && positions[p] < this->LastPosition;
      const double position = isInside ? positions[p] : 0.0;
      const auto step = static_cast<std::int32_t>(position);
      const double t = position - step;
      const std::array<double, 4>& cubic = cubics[step];
      const double value = cubic[0] + t * (cubic[1] + t * (cubic[2] + t * cubic[3]));
      const bool isTabulated = isInside && value == value;
      own[p] += weights[n] * (isTabulated ? value : this->Exact(distances[p]));
    }
  }
  std::copy_n(own, Places, sums.begin());
}

double CovarianceTable::Exact(double distance) const
{
  return Covariance(this->Field, distance);
}

}
