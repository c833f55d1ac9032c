// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sway/OscillatorBank.h"

#include "Numerics/SimdClones.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

/// A free motion has then fallen to e^-24, 4e-11, of what it was.
constexpr double Memory = 24.0;

/// Places and speeds of some oscillators, which do not overlap with their factors.
LITTORAL_SIMD_CLONES
void AdvanceColumns(std::size_t active, std::size_t columns, const double* __restrict__ factors, double before,
  double after, double* __restrict__ places, double* __restrict__ speeds)
{
  const double* f = factors;
  for (std::size_t i = 0; i < active; ++i)
  {
    const double place = places[i];
    const double speed = speeds[i];
    places[i] = f[i] * place + f[columns + i] * speed + f[2 * columns + i] * before + f[3 * columns + i] * after;
    speeds[i] = f[4 * columns + i] * place + f[5 * columns + i] * speed + f[6 * columns + i] * before +
      f[7 * columns + i] * after;
  }
}

}

OscillatorBank::OscillatorBank(const std::vector<double>& frequencies, double damping, double step)
  : Columns(frequencies.size())
  , Step(step)
  , Damping(damping)
  , Frequencies(frequencies)
  , Factors(8 * frequencies.size())
  , State(6 * frequencies.size(), 0.0)
{
  for (std::size_t column = 0; column < this->Columns; ++column)
  {
    const double square = frequencies[column] * frequencies[column];
    const OscillatorStep one({ frequencies[column], damping }, step);
    for (std::size_t i = 0; i < 4; ++i)
    {
      const double unit = i < 2 ? 1.0 : square;
      this->Factors[i * this->Columns + column] = unit * one.PlaceFrom[i];
      this->Factors[(4 + i) * this->Columns + column] = unit * one.SpeedFrom[i];
    }
  }
}

void OscillatorBank::Advance(std::size_t active, const Vector3& before, const Vector3& after)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    double* places = &this->State[(2 * axis) * this->Columns];
    AdvanceColumns(
      active, this->Columns, this->Factors.data(), before[axis], after[axis], places, places + this->Columns);
  }
}

void OscillatorBank::Reset()
{
  std::fill(this->State.begin(), this->State.end(), 0.0);
}

void OscillatorBank::Settle(std::size_t column, std::size_t samples)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    double& place = this->State[2 * axis * this->Columns + column];
    double& speed = this->State[(2 * axis + 1) * this->Columns + column];
    const OscillatorState settled = SettledState(
      { this->Frequencies[column], this->Damping }, this->Step * static_cast<double>(samples), { place, speed });
    place = settled.Place;
    speed = settled.Speed;
  }
}

std::size_t StepsRemembered(const Oscillator& oscillator, double step)
{
  return static_cast<std::size_t>(std::ceil(Memory / (oscillator.DampingRatio * oscillator.Frequency * step)));
}

}
