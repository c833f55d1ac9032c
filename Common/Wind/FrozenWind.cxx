// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Wind/FrozenWind.h"

#include <algorithm>

namespace littoral
{

FrozenWind::FrozenWind(
  const FrozenWindGrid& grid, const WindTimes& times, const float* velocities, const ParallelFor& parallel)
  : Grid(grid)
  , Times(times)
  , Lines(velocities, grid.Size, parallel)
{
}

/// The index of a place, kept within the field across the wind and in height; whether it was there.
bool FrozenWind::Locate(const Vector3& place, std::array<double, 3>& index) const
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::array<double, 4>& row = this->Grid.ToIndex[axis];
    index[axis] = row[0] * place.x + row[1] * place.y + row[2] * place.z + row[3] - this->Grid.FirstIndex[axis];
  }
  constexpr double Slack = 1e-6;
  const double across = this->Grid.Size[1] - 1.0;
  const double up = this->Grid.Size[2] - 1.0;
  const bool inside = index[1] >= -Slack && index[1] <= across + Slack && index[2] <= up + Slack;
  index[1] = std::clamp(index[1], 0.0, across);
  index[2] = std::clamp(index[2], 0.0, up);
  return inside;
}

bool FrozenWind::Reaches(const Vector3& place) const
{
  std::array<double, 3> index;
  return this->Locate(place, index);
}

void FrozenWind::Sample(const Vector3& place, double first, std::size_t count, Vector3* velocities) const
{
  std::array<double, 3> index;
  this->Locate(place, index);
  const double bottom = this->Grid.Bottom;
  const double spacing = this->Grid.LayerSpacing;
  index[2] = LayerPlace(bottom + index[2] * spacing, bottom, spacing);
  this->Lines.Sample(index, first, count, velocities);
}

WindAtPlace FrozenWind::Over(double ground) const
{
  return [this, ground](const Vector3& place, double first, std::size_t count, Vector3* velocities) {
    this->Sample(place - Vector3(0.0, 0.0, ground), first, count, velocities);
  };
}

double FrozenWind::Arrival(const Vector3& place) const
{
  std::array<double, 3> index;
  this->Locate(place, index);
  return index[0] * this->Times.Step;
}

}
