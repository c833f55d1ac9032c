// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Wind/CarriedWind.h"

#include "Wind/WindLines.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace littoral
{

namespace
{

/// Parts of a time step that times are rounded to.
constexpr double PartsOfStep = 1024.0;

/// Displacement of a periodic field: whole samples, and the part of a sample beyond them.
struct Shift
{
  int Samples;
  double Part;
};

Shift ShiftAt(double time, const WindGrid& grid)
{
  const double parts = PartsOfStep * grid.Count[0];
  double gone = std::fmod(std::round(PartsOfStep * (time / grid.TimeStep)), parts);
  gone = gone < 0.0 ? gone + parts : gone;
  const double samples = std::floor(gone / PartsOfStep);
  return { static_cast<int>(samples), gone / PartsOfStep - samples };
}

/// Copies samples first ... last of a line that has been carried along by whole samples, turned by an angle of which
/// the cosine and sine are given.
void CopyLine(
  const float* line, int length, int first, int last, int shift, const std::array<double, 2>& turn, float* to)
{
  const float cosine = static_cast<float>(turn[0]);
  const float sine = static_cast<float>(turn[1]);
  for (int i = first; i <= last; ++i, to += 3)
  {
    const float* velocity = line + 3 * static_cast<std::size_t>((i - shift + length) % length);
    to[0] = cosine * velocity[0] - sine * velocity[1];
    to[1] = sine * velocity[0] + cosine * velocity[1];
    to[2] = velocity[2];
  }
}

}

void CarryWind(const WindGrid& grid, const float* velocities, double time, const std::array<double, 2>& turn,
  const WindWindow& window, float* carried, const ParallelFor& parallel)
{
  const Shift shift = ShiftAt(time, grid);
  const auto samples = [&](int axis) { return static_cast<std::size_t>(window.Last[axis]) - window.First[axis] + 1; };
  const std::size_t across = samples(1);
  const std::size_t values = 3 * samples(0);
  const std::size_t whole = 3 * static_cast<std::size_t>(grid.Count[0]);
  const WindCarrier carrier(grid.Count[0]);
  // Lines side by side in the wind are so in the window; a pack ends with the layer.
  const std::size_t packs = (across + FourierLanes - 1) / FourierLanes;
  parallel(packs * samples(2), [&](std::size_t begin, std::size_t end) {
    WindCarrier::Room room(shift.Part > 0.0 ? grid.Count[0] : 0);
    for (std::size_t pack = begin; pack < end; ++pack)
    {
      const std::size_t line = pack % packs * FourierLanes;
      const int lanes = static_cast<int>(std::min<std::size_t>(FourierLanes, across - line));
      const std::size_t layer = pack / packs;
      const float* from = velocities + whole * ((window.First[2] + layer) * grid.Count[1] + window.First[1] + line);
      if (shift.Part > 0.0)
      {
        carrier.Carry(from, lanes, shift.Part, room);
        from = room.Velocities.data();
      }
      for (int lane = 0; lane < lanes; ++lane)
      {
        CopyLine(from + lane * whole, grid.Count[0], window.First[0], window.Last[0], shift.Samples, turn,
          carried + (layer * across + line + lane) * values);
      }
    }
  });
}

}
