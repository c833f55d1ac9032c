// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Wind/WindVeer.h"

#include "Numerics/Constants.h"

#include <cmath>
#include <cstddef>

namespace littoral
{

double VeerAngle(const WindModel& model, double height)
{
  // theta(z) = -V (z - z_r): clockwise with height
  return -Pi / 180.0 * model.Veer * (height - model.ReferenceHeight);
}

void TurnWithHeight(
  const WindModel& model, const WindGrid& grid, VeerTurn turn, float* velocities, const ParallelFor& parallel)
{
  if (model.Veer == 0.0)
  {
    return;
  }
  const double sense = turn == VeerTurn::FromLocal ? 1.0 : -1.0;
  const std::size_t length = static_cast<std::size_t>(grid.Count[0]);
  parallel(grid.NumberOfLines(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t line = begin; line < end; ++line)
    {
      const double angle = sense * VeerAngle(model, grid.Height(static_cast<int>(line / grid.Count[1])));
      const double cosine = std::cos(angle);
      const double sine = std::sin(angle);
      float* velocity = velocities + line * length * WindComponents;
      for (std::size_t i = 0; i < length; ++i, velocity += WindComponents)
      {
        // (u, v) = (u' cos - v' sin, u' sin + v' cos)
        const double along = velocity[0];
        const double across = velocity[1];
        velocity[0] = static_cast<float>(along * cosine - across * sine);
        velocity[1] = static_cast<float>(along * sine + across * cosine);
      }
    }
  });
}

}
