// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sway/OscillatorBank.h"

#include "Numerics/SimdClones.h"

#include <cmath>

namespace littoral
{

namespace
{

/// Decay of a free motion within SettlingSteps: e^-24 = 4e-11.
constexpr double SettlingExponent = 24.0;

/// Displacements and velocities after a step; these arrays do not overlap with the factors.
LITTORAL_SIMD_CLONES
void AdvanceColumns(std::size_t active, std::size_t columns, const double* __restrict__ factors, double before,
  double after, double* __restrict__ displacements, double* __restrict__ velocities)
{
  const double* f = factors;
  for (std::size_t i = 0; i < active; ++i)
  {
    const double displacement = displacements[i];
    const double velocity = velocities[i];
    // eq. 24 over a step with a linear load: y_1 = A y_0 + B y_0' + C p_0 + D p_1, and y_1' likewise
    displacements[i] =
      f[i] * displacement + f[columns + i] * velocity + f[2 * columns + i] * before + f[3 * columns + i] * after;
    velocities[i] = f[4 * columns + i] * displacement + f[5 * columns + i] * velocity + f[6 * columns + i] * before +
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
      this->Factors[i * this->Columns + column] = unit * one.DisplacementFrom[i];
      this->Factors[(4 + i) * this->Columns + column] = unit * one.VelocityFrom[i];
    }
  }
}

void OscillatorBank::Advance(std::size_t active, const Vector3& before, const Vector3& after)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    double* displacements = &this->State[(2 * axis) * this->Columns];
    AdvanceColumns(active, this->Columns, this->Factors.data(), before[axis], after[axis], displacements,
      displacements + this->Columns);
  }
}

void OscillatorBank::Settle(std::size_t column, std::size_t samples)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    double& displacement = this->State[2 * axis * this->Columns + column];
    double& velocity = this->State[(2 * axis + 1) * this->Columns + column];
    const OscillatorState settled = SettledState({ this->Frequencies[column], this->Damping },
      this->Step * static_cast<double>(samples), { displacement, velocity });
    displacement = settled.Displacement;
    velocity = settled.Velocity;
  }
}

std::size_t SettlingSteps(const Oscillator& oscillator, double step)
{
  return static_cast<std::size_t>(
    std::ceil(SettlingExponent / (oscillator.DampingRatio * oscillator.Frequency * step)));
}

}
