// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BeamResponse.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

/// Below this product of frequency and step the closed form loses digits, and the series has few terms.
constexpr double LargestSeriesAngle = 1.0;
constexpr int SeriesTerms = 24;

/// A 2 x 2 matrix by rows: place and speed over frequency.
using Matrix = std::array<double, 4>;

Matrix Product(const Matrix& a, const Matrix& b)
{
  return { a[0] * b[0] + a[1] * b[2], a[0] * b[1] + a[1] * b[3], a[2] * b[0] + a[3] * b[2], a[2] * b[1] + a[3] * b[3] };
}

/// Factors in units of time in which the frequency is 1: of place and speed, of the load before and after.
struct UnitStep
{
  Matrix Free{ 1.0, 0.0, 0.0, 1.0 };
  std::array<double, 2> Before{};
  std::array<double, 2> After{};
};

/// Sums of powers of the system's matrix: exp(Z) for the state, and its first two shifted relatives for the load.
UnitStep SeriesStep(double angle, double damping)
{
  const Matrix z{ 0.0, angle, -angle, -2.0 * damping * angle };
  Matrix power{ 1.0, 0.0, 0.0, 1.0 };
  double factorial = 1.0;
  UnitStep step;
  std::array<double, 2> constant{ 0.0, 0.0 };
  std::array<double, 2> rising{ 0.0, 0.0 };
  for (int k = 0; k < SeriesTerms; ++k)
  {
    for (int i = 0; i < 4; ++i)
    {
      step.Free[i] = k == 0 ? power[i] : step.Free[i] + power[i] / factorial;
    }
    for (int i = 0; i < 2; ++i)
    {
      constant[i] += angle * power[2 * i + 1] / (factorial * (k + 1));
      rising[i] += angle * power[2 * i + 1] / (factorial * (k + 1) * (k + 2));
    }
    power = Product(power, z);
    factorial *= k + 1;
  }
  step.Before = { constant[0] - rising[0], constant[1] - rising[1] };
  step.After = rising;
  return step;
}

/// The table of the specification with a frequency of 1 and a step of `angle`.
UnitStep ClosedStep(double angle, double damping)
{
  const double root = std::sqrt(1.0 - damping * damping);
  const double decay = std::exp(-damping * angle);
  const double s = std::sin(root * angle);
  const double c = std::cos(root * angle);
  const double falling = c - damping * s / root;
  const double swing = root * s + damping * c;
  const double t = (2.0 * damping * damping - 1.0) / angle;
  const double q = 2.0 * damping / angle;
  UnitStep step;
  step.Free = { decay * (c + damping * s / root), decay * s / root, -decay * s / root, decay * falling };
  step.Before = { -(decay * ((t + damping) * s / root + (q + 1.0) * c) - q),
    -(decay * ((t + damping) * falling - (q + 1.0) * swing) + 1.0 / angle) };
  step.After = { decay * (t * s / root + q * c) + 1.0 - q, decay * (t * falling - q * swing) + 1.0 / angle };
  return step;
}

/// The free motion over a whole period.
Matrix FreeOver(double angle, double damping)
{
  const double root = std::sqrt(1.0 - damping * damping);
  const double decay = std::exp(-damping * angle);
  const double s = std::sin(root * angle);
  const double c = std::cos(root * angle);
  return { decay * (c + damping * s / root), decay * s / root, -decay * s / root, decay * (c - damping * s / root) };
}

/// The change of the first state that takes away a jump [place, speed] after a period: (I - A^N)^-1 jump.
OscillatorState Correction(const Matrix& free, double frequency, const OscillatorState& jump)
{
  const Matrix m{ 1.0 - free[0], -free[1], -free[2], 1.0 - free[3] };
  const double determinant = m[0] * m[3] - m[1] * m[2];
  const double speed = jump.Speed / frequency;
  return { (m[3] * jump.Place - m[1] * speed) / determinant,
    frequency * (m[0] * speed - m[2] * jump.Place) / determinant };
}

}

OscillatorStep::OscillatorStep(const Oscillator& oscillator, double step)
{
  const double w = oscillator.Frequency;
  const double angle = w * step;
  const UnitStep unit = angle < LargestSeriesAngle ? SeriesStep(angle, oscillator.DampingRatio)
                                                   : ClosedStep(angle, oscillator.DampingRatio);
  this->PlaceFrom = { unit.Free[0], unit.Free[1] / w, unit.Before[0] / (w * w), unit.After[0] / (w * w) };
  this->SpeedFrom = { unit.Free[2] * w, unit.Free[3], unit.Before[1] / w, unit.After[1] / w };
}

std::vector<double> PeriodicResponse(const Oscillator& oscillator, double step, const std::vector<double>& load)
{
  const std::size_t count = load.size();
  const OscillatorStep advance(oscillator, step);
  const Matrix free = FreeOver(oscillator.Frequency * step * count, oscillator.DampingRatio);
  std::vector<double> places(count);
  OscillatorState first;
  // The first run starts from rest and tells the steady state but for rounding; the second takes that away.
  for (int run = 0; run < 3; ++run)
  {
    OscillatorState state = first;
    for (std::size_t k = 0; k < count; ++k)
    {
      places[k] = state.Place;
      state = advance.Advance(state, load[k], load[k + 1 < count ? k + 1 : 0]);
    }
    const OscillatorState change =
      Correction(free, oscillator.Frequency, { state.Place - first.Place, state.Speed - first.Speed });
    first = { first.Place + change.Place, first.Speed + change.Speed };
  }
  return places;
}

std::vector<Vector3> PeriodicResponse(const Oscillator& oscillator, double step, const std::vector<Vector3>& load)
{
  std::vector<Vector3> response(load.size());
  std::vector<double> one(load.size());
  for (int axis = 0; axis < 3; ++axis)
  {
    for (std::size_t k = 0; k < load.size(); ++k)
    {
      one[k] = load[k][axis];
    }
    one = PeriodicResponse(oscillator, step, one);
    for (std::size_t k = 0; k < load.size(); ++k)
    {
      response[k][axis] = one[k];
    }
  }
  return response;
}

OscillatorState SettledState(const Oscillator& oscillator, double period, const OscillatorState& fromRest)
{
  const Matrix free = FreeOver(oscillator.Frequency * period, oscillator.DampingRatio);
  return Correction(free, oscillator.Frequency, fromRest);
}

SeriesPlace::SeriesPlace(double time, double step, std::size_t count)
{
  const double n = static_cast<double>(count);
  const double samples = time / step;
  const double place = samples - n * std::floor(samples / n);
  const std::size_t at = std::min(count - 1, static_cast<std::size_t>(place));
  const double f = place - static_cast<double>(at);
  for (std::size_t i = 0; i < 4; ++i)
  {
    this->Samples[i] = (at + count + i - 1) % count;
  }
  this->Weights = { 0.5 * f * (-1.0 + f * (2.0 - f)), 1.0 + 0.5 * f * f * (-5.0 + 3.0 * f),
    0.5 * f * (1.0 + f * (4.0 - 3.0 * f)), 0.5 * f * f * (f - 1.0) };
}

}
