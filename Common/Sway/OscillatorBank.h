// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralOscillatorBank_h
#define LittoralOscillatorBank_h

#include "Sway/BeamResponse.h"

#include <array>
#include <cstddef>
#include <vector>

namespace littoral
{

/**
 * Many oscillators of ascending frequencies under one load in space. Displacements are in units of the load over the
 * square of the frequency, so that a load that does not change gives itself.
 */
class OscillatorBank
{
public:
  /// Frequencies ascend [rad/s]; a step of time [s].
  OscillatorBank(const std::vector<double>& frequencies, double damping, double step);

  std::size_t Size() const { return this->Columns; }

  /// Takes oscillators [0, active) over one step in which the load is linear.
  void Advance(std::size_t active, const Vector3& before, const Vector3& after);

  /// The state of the periodic motion, of an oscillator that was at rest one period ago: `samples` steps.
  void Settle(std::size_t column, std::size_t samples);

  /// Displacements along an axis, one an oscillator.
  const double* Displacements(std::size_t axis) const { return &this->State[(2 * axis) * this->Columns]; }

private:
  std::size_t Columns;
  double Step;
  double Damping;
  std::vector<double> Frequencies;
  std::vector<double>
    Factors; // eight rows: of displacement, velocity, load before and after in the displacement; in the velocity
  std::vector<double> State; // six rows: displacement and velocity along x, y, z
};

/// Steps in which a free motion decays to e^-24 = 4e-11, below the resolution of single precision.
std::size_t SettlingSteps(const Oscillator& oscillator, double step);

}

#endif
