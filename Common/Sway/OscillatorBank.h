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
 * Many oscillators of ascending frequencies under one load in space. Places are in units of the load over the square of
 * the frequency, so that a load that does not change gives itself.
 */
class OscillatorBank
{
public:
  /// Frequencies ascend [rad/s]; a step of time [s].
  OscillatorBank(const std::vector<double>& frequencies, double damping, double step);

  std::size_t Size() const { return this->Columns; }

  /// Takes oscillators [0, active) over one step in which the load is linear.
  void Advance(std::size_t active, const Vector3& before, const Vector3& after);

  /// All at rest.
  void Reset();

  /// The state of the periodic motion, of an oscillator that was at rest one period ago: `samples` steps.
  void Settle(std::size_t column, std::size_t samples);

  /// Places along an axis, one an oscillator.
  const double* Places(int axis) const { return &this->State[(2 * axis) * this->Columns]; }

private:
  std::size_t Columns;
  double Step;
  double Damping;
  std::vector<double> Frequencies;
  std::vector<double> Factors; // eight rows: of place, speed, load before and after in the place; the same in the speed
  std::vector<double> State;   // six rows: place and speed along x, y, z
};

/// How many steps an oscillator remembers: after them a state has lost all that single precision could tell.
std::size_t StepsRemembered(const Oscillator& oscillator, double step);

}

#endif
