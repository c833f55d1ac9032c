// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sea/TrainSelection.h"

#include "Sea/WaveOrbits.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace littoral
{

namespace
{

constexpr int NumberOfRows = 128;
constexpr int NumberOfDistances = 128;
/// Nearest distance of the table [m]; all trains act before it.
constexpr double NearestDistance = 0.05;
constexpr double StepsAnOctave = 6.0;

double DistanceOf(int column)
{
  return NearestDistance * std::exp2(column / StepsAnOctave);
}

/// Trains up to the last one that is seen by itself.
int CountPerTrain(const std::vector<double>& tail, double pixelsAMetre, double screenError)
{
  int count = static_cast<int>(tail.size()) - 1;
  while (count > 0 && (tail[count - 1] - tail[count]) * pixelsAMetre < screenError)
  {
    --count;
  }
  return count;
}

/// The least number of trains after which all others together are not seen.
int CountByTail(const std::vector<double>& tail, double pixelsAMetre, double screenError)
{
  int count = static_cast<int>(tail.size()) - 1;
  while (count > 0 && tail[count - 1] * pixelsAMetre <= screenError)
  {
    --count;
  }
  return count;
}

}

std::vector<int> OrderAt(const SeaState& sea, double height)
{
  std::vector<double> axis;
  for (const WaveTrain& train : sea.Trains)
  {
    axis.push_back(AxesAt(train, height - sea.SeaLevel, sea.Depth).Horizontal);
  }
  std::vector<int> order(sea.Trains.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return axis[a] > axis[b]; });
  return order;
}

SeaState Ordered(const SeaState& sea, const std::vector<int>& order)
{
  SeaState ordered = sea;
  for (std::size_t n = 0; n < order.size(); ++n)
  {
    ordered.Trains[n] = sea.Trains[static_cast<std::size_t>(order[n])];
  }
  return ordered;
}

bool IsPermutation(const std::vector<int>& order)
{
  std::vector<char> seen(order.size(), 0);
  return std::all_of(order.begin(), order.end(), [&](int train) {
    return train >= 0 && static_cast<std::size_t>(train) < seen.size() && !std::exchange(seen[train], char{ 1 });
  });
}

TrainTable::TrainTable(
  const SeaState& sea, double lowest, double highest, const View& view, TrainRule rule, double screenError)
  : Trains(static_cast<int>(sea.Trains.size()))
  , Rule(rule)
  , Highest(highest)
  , Step((highest - lowest) / NumberOfRows)
{
  this->Rows.resize(this->Step > 0.0 ? NumberOfRows : 1);
  for (std::size_t index = 0; index < this->Rows.size(); ++index)
  {
    Row& row = this->Rows[index];
    row.Height = highest - static_cast<double>(index) * std::max(0.0, this->Step);
    row.Tail.assign(sea.Trains.size() + 1, 0.0);
    row.Steepness = 0.0;
    for (std::size_t train = sea.Trains.size(); train-- > 0;)
    {
      // The horizontal axis is the longer one at any depth.
      const double axis = AxesAt(sea.Trains[train], row.Height - sea.SeaLevel, sea.Depth).Horizontal;
      row.Tail[train] = row.Tail[train + 1] + axis;
      row.Steepness += sea.Trains[train].WaveNumber * axis;
    }
    this->FillCounts(row, sea, view, screenError);
  }
}

void TrainTable::FillCounts(Row& row, const SeaState& sea, const View& view, double screenError) const
{
  row.Counts.assign(NumberOfDistances, static_cast<int>(sea.Trains.size()));
  const double tangent = std::tan(0.5 * view.Angle);
  const double pixels = view.Height / (2.0 * tangent); // of a metre across the view, a metre away
  const double corner = 1.0 + tangent * tangent * (1.0 + view.AspectRatio * view.AspectRatio);
  for (int column = 0; column < NumberOfDistances && !this->IsComplete(); ++column)
  {
    const double distance = DistanceOf(column);
    if (this->Rule == TrainRule::PerTrain)
    {
      row.Counts[column] = CountPerTrain(row.Tail, pixels / distance, screenError);
      continue;
    }
    const double nearest = distance - row.Tail.front() - view.Margin;
    if (nearest > 0.0)
    {
      row.Counts[column] = CountByTail(row.Tail, pixels * corner / nearest, screenError);
    }
  }
}

int TrainTable::RowOf(double height) const
{
  if (this->Rows.size() == 1)
  {
    return 0;
  }
  // A row holds its upper end by a hair, so that rounding never puts a particle above its row.
  const double row = (this->Highest - height) / this->Step - 1e-9;
  return static_cast<int>(std::clamp(row, 0.0, static_cast<double>(this->Rows.size()) - 1.0));
}

int TrainTable::CountAt(double distance, double height) const
{
  if (this->IsComplete() || !(distance >= NearestDistance))
  {
    return this->Trains;
  }
  const double column = StepsAnOctave * std::log2(distance / NearestDistance) - 1e-9;
  return this->Rows[this->RowOf(height)].Counts[static_cast<int>(std::clamp(column, 0.0, NumberOfDistances - 1.0))];
}

double TrainTable::SlaveError(double length, double height) const
{
  const Row& row = this->Rows[this->RowOf(height)];
  return std::min(2.0 * row.Tail.front(), length * row.Steepness);
}

}
