// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/HeightGrid.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

/// Distance beyond the edge at which a place still counts as on it [cells], by rounding.
constexpr double EdgeTolerance = 1e-6;

/// Weight 0 leaves a value out, even if it is no number.
double Mix(double a, double b, double part)
{
  return part == 0.0 ? a : part == 1.0 ? b : a + part * (b - a);
}

}

GroundPoint HeightGrid::At(double x, double y) const
{
  GroundPoint ground;
  const double position[2] = { (x - this->Origin[0]) / this->Spacing[0], (y - this->Origin[1]) / this->Spacing[1] };
  int first[2];
  double part[2];
  for (int axis = 0; axis < 2; ++axis)
  {
    const int cells = this->Count[axis] - 1;
    if (!(position[axis] >= -EdgeTolerance && position[axis] <= cells + EdgeTolerance))
    {
      return ground;
    }
    first[axis] = std::clamp(static_cast<int>(position[axis]), 0, cells - 1);
    part[axis] = std::clamp(position[axis] - first[axis], 0.0, 1.0);
  }
  const long long corner = static_cast<long long>(first[1]) * this->Count[0] + first[0];
  const double h00 = this->HeightOf(corner);
  const double h10 = this->HeightOf(corner + 1);
  const double h01 = this->HeightOf(corner + this->Count[0]);
  const double h11 = this->HeightOf(corner + this->Count[0] + 1);
  ground.IsCovered = true;
  ground.Height = Mix(Mix(h00, h10, part[0]), Mix(h01, h11, part[0]), part[1]);
  const double alongX = Mix(h10 - h00, h11 - h01, part[1]) / this->Spacing[0];
  const double alongY = Mix(h01 - h00, h11 - h10, part[0]) / this->Spacing[1];
  ground.Gradient[0] = alongX;
  ground.Gradient[1] = alongY;
  ground.Slope = std::atan(std::hypot(alongX, alongY));
  return ground;
}

long long HeightGrid::Nearest(double x, double y) const
{
  const double place[2] = { x, y };
  long long nearest[2];
  for (int axis = 0; axis < 2; ++axis)
  {
    const long long last = this->Count[axis] - 1;
    nearest[axis] = std::clamp(std::llround((place[axis] - this->Origin[axis]) / this->Spacing[axis]), 0LL, last);
  }
  return nearest[1] * this->Count[0] + nearest[0];
}

}
