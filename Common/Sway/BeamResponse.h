// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralBeamResponse_h
#define LittoralBeamResponse_h

#include "Numerics/Vector3.h"

#include <array>
#include <cstddef>
#include <vector>

namespace littoral
{

/// y'' + 2 DampingRatio w y' + w^2 y = p(t), with w = Frequency: eq. 21 of Setas et al.
struct Oscillator
{
  double Frequency = 1.0;     ///< angular, without damping [rad/s]; above 0
  double DampingRatio = 0.05; ///< from 0 (a periodic response needs more) to below 1
};

/// The state of an oscillator.
struct OscillatorState
{
  double Displacement = 0.0;
  double Velocity = 0.0;
};

/**
 * Duhamel's integral (eq. 24) over one time step in which the load is linear: exact, hence stable for any step. The new
 * state is a sum of the old one and of the loads at both ends of the step, with constant factors.
 */
class OscillatorStep
{
public:
  OscillatorStep(const Oscillator& oscillator, double step);

  OscillatorState Advance(const OscillatorState& state, double loadBefore, double loadAfter) const
  {
    return { this->DisplacementFrom[0] * state.Displacement + this->DisplacementFrom[1] * state.Velocity +
        this->DisplacementFrom[2] * loadBefore + this->DisplacementFrom[3] * loadAfter,
      this->VelocityFrom[0] * state.Displacement + this->VelocityFrom[1] * state.Velocity +
        this->VelocityFrom[2] * loadBefore + this->VelocityFrom[3] * loadAfter };
  }

  /// Factors of displacement, velocity, load before and load after in the new displacement and in the new velocity.
  std::array<double, 4> DisplacementFrom{};
  std::array<double, 4> VelocityFrom{};
};

/**
 * The steady state under a load that repeats after its last sample and is linear between samples: the displacements at
 * the samples' times. There is no transient and no jump where the period closes. The damping ratio must be positive.
 */
std::vector<double> PeriodicResponse(const Oscillator& oscillator, double step, const std::vector<double>& load);

/// The same for each component of a load in space.
std::vector<Vector3> PeriodicResponse(const Oscillator& oscillator, double step, const std::vector<Vector3>& load);

/// The state of the periodic motion, from that of an oscillator which was at rest one period [s] ago.
OscillatorState SettledState(const Oscillator& oscillator, double period, const OscillatorState& fromRest);

/// Component of a response in space that a beam along a unit vector can have: the one at a right angle to it.
inline Vector3 AcrossBeam(const Vector3& response, const Vector3& beam)
{
  return response - glm::dot(response, beam) * beam;
}

/// Samples that SharpLoad needs before the first and after the last that it gives.
inline constexpr std::size_t LoadMargin = 3;

/**
 * A load that is linear between its samples has lost a part of each wave, 1 - sinc^2(f step) at the frequency f. This
 * gives the samples back what their line through them will lose: 1 / sinc^2 = arcsin^2(s) / s^2 with s = sin(pi f
 * step), as its series of seven samples. What is left of a wave of four samples is 0.993 in place of 0.811; a load that
 * does not change stays. The result is shorter by LoadMargin at each end.
 */
std::vector<Vector3> SharpLoad(const std::vector<Vector3>& load);

/// Samples that a place between them is read from, and how many of them are before the last one that has gone by.
inline constexpr std::size_t SeriesTaps = 8;
inline constexpr long long SeriesBefore = 3;

/// A place between the samples of a periodic series.
struct SeriesPlace
{
  std::array<std::size_t, SeriesTaps> Samples{};
  std::array<double, SeriesTaps> Weights{};

  /// Place at a time [s], any finite number, of a series of `count` samples a step [s] apart: band-limited, by a sinc
  /// under a Kaiser window (beta 6). Waves of four samples and more keep their size to 0.15 %.
  SeriesPlace(double time, double step, std::size_t count);

  template <typename Value>
  Value Of(const Value* series) const
  {
    Value value = this->Weights[0] * series[this->Samples[0]];
    for (std::size_t tap = 1; tap < SeriesTaps; ++tap)
    {
      value += this->Weights[tap] * series[this->Samples[tap]];
    }
    return value;
  }
};

}

#endif
