// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sway/BeamResponse.h"

#include "Numerics/Constants.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

/// Below this product of frequency and step the closed form loses digits, and the series has few terms.
constexpr double LargestSeriesAngle = 1.0;
constexpr int SeriesTerms = 24;

/// A 2 x 2 matrix by rows: displacement, velocity over frequency.
using Matrix = std::array<double, 4>;

Matrix Product(const Matrix& a, const Matrix& b)
{
  return { a[0] * b[0] + a[1] * b[2], a[0] * b[1] + a[1] * b[3], a[2] * b[0] + a[3] * b[2], a[2] * b[1] + a[3] * b[3] };
}

/// Factors in units of time in which the frequency is 1: of displacement and velocity, of the load before and after.
struct UnitStep
{
  Matrix Free{ 1.0, 0.0, 0.0, 1.0 };
  std::array<double, 2> Before{};
  std::array<double, 2> After{};
};

/// y_1 = exp(Z) y_0 + phi_1(Z) b p_0 + phi_2(Z) b (p_1 - p_0), with b = (0, angle) and phi_n(Z) = sum over k of
/// Z^k / (k + n)!, as power series.
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

/// The modified Bessel function of order 0, by its series.
double BesselI0(double x)
{
  double term = 1.0;
  double sum = 1.0;
  for (int k = 1; k < 24; ++k)
  {
    term *= 0.25 * x * x / (static_cast<double>(k) * k);
    sum += term;
  }
  return sum;
}

/// sin(pi x) / (pi x) under a Kaiser window that ends half of SeriesTaps away.
double WindowedSinc(double x)
{
  constexpr double beta = 6.0;
  constexpr double reach = 0.5 * SeriesTaps;
  const double window = BesselI0(beta * std::sqrt(std::max(0.0, 1.0 - x * x / (reach * reach))));
  return window * (x == 0.0 ? 1.0 : std::sin(Pi * x) / (Pi * x));
}

/// Duhamel's integral over a step with a linear load in closed form (N. C. Nigam and P. C. Jennings, Bulletin of the
/// Seismological Society of America 59 (2), 1969), with a frequency of 1 and a step of `angle`.
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

/// Free motion over a period: the matrix of displacement and velocity over frequency.
Matrix FreeOver(double angle, double damping)
{
  const double root = std::sqrt(1.0 - damping * damping);
  const double decay = std::exp(-damping * angle);
  const double s = std::sin(root * angle);
  const double c = std::cos(root * angle);
  return { decay * (c + damping * s / root), decay * s / root, -decay * s / root, decay * (c - damping * s / root) };
}

/// The change of the first state that takes away a jump [displacement, velocity] after a period: (I - A^N)^-1 jump.
OscillatorState Correction(const Matrix& free, double frequency, const OscillatorState& jump)
{
  const Matrix m{ 1.0 - free[0], -free[1], -free[2], 1.0 - free[3] };
  const double determinant = m[0] * m[3] - m[1] * m[2];
  const double velocity = jump.Velocity / frequency;
  return { (m[3] * jump.Displacement - m[1] * velocity) / determinant,
    frequency * (m[0] * velocity - m[2] * jump.Displacement) / determinant };
}

}

OscillatorStep::OscillatorStep(const Oscillator& oscillator, double step)
{
  const double w = oscillator.Frequency;
  const double angle = w * step;
  const UnitStep unit = angle < LargestSeriesAngle ? SeriesStep(angle, oscillator.DampingRatio)
                                                   : ClosedStep(angle, oscillator.DampingRatio);
  this->DisplacementFrom = { unit.Free[0], unit.Free[1] / w, unit.Before[0] / (w * w), unit.After[0] / (w * w) };
  this->VelocityFrom = { unit.Free[2] * w, unit.Free[3], unit.Before[1] / w, unit.After[1] / w };
}

std::vector<double> PeriodicResponse(const Oscillator& oscillator, double step, const std::vector<double>& load)
{
  const std::size_t count = load.size();
  const OscillatorStep advance(oscillator, step);
  const Matrix free = FreeOver(oscillator.Frequency * step * static_cast<double>(count), oscillator.DampingRatio);
  std::vector<double> places(count);
  OscillatorState first;
  // y_0 += (I - A^N)^-1 (y_N - y_0): the first run from rest finds the steady state but for rounding, the second the
  // rest.
  for (int run = 0; run < 3; ++run)
  {
    OscillatorState state = first;
    for (std::size_t k = 0; k < count; ++k)
    {
      places[k] = state.Displacement;
      state = advance.Advance(state, load[k], load[k + 1 < count ? k + 1 : 0]);
    }
    const OscillatorState change = Correction(
      free, oscillator.Frequency, { state.Displacement - first.Displacement, state.Velocity - first.Velocity });
    first = { first.Displacement + change.Displacement, first.Velocity + change.Velocity };
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

std::vector<Vector3> SharpLoad(const std::vector<Vector3>& load)
{
  // By s^2, which is minus a quarter of a second difference: 1 + s^2 / 3 + 8 s^4 / 45 + 4 s^6 / 35.
  constexpr double second = -1.0 / (4.0 * 3.0);
  constexpr double fourth = 8.0 / (16.0 * 45.0);
  constexpr double sixth = -4.0 / (64.0 * 35.0);
  std::vector<Vector3> sharp(load.size() - 2 * LoadMargin);
  for (std::size_t n = 0; n < sharp.size(); ++n)
  {
    const Vector3* at = &load[n + LoadMargin];
    const Vector3 one = at[-1] + at[1];
    const Vector3 two = at[-2] + at[2];
    const Vector3 three = at[-3] + at[3];
    sharp[n] = at[0] + second * (one - 2.0 * at[0]) + fourth * (two - 4.0 * one + 6.0 * at[0]) +
      sixth * (three - 6.0 * two + 15.0 * one - 20.0 * at[0]);
  }
  return sharp;
}

SeriesPlace::SeriesPlace(double time, double step, std::size_t count)
{
  const double n = static_cast<double>(count);
  const double samples = time / step;
  const double place = samples - n * std::floor(samples / n);
  const std::size_t at = std::min(count - 1, static_cast<std::size_t>(place));
  const double f = place - static_cast<double>(at);
  double sum = 0.0;
  for (std::size_t i = 0; i < SeriesTaps; ++i)
  {
    const long long gone = static_cast<long long>(i) - SeriesBefore;
    this->Samples[i] = (at + count * SeriesTaps + i - SeriesBefore) % count;
    this->Weights[i] = WindowedSinc(f - static_cast<double>(gone));
    sum += this->Weights[i];
  }
  for (double& weight : this->Weights) // what does not change stays
  {
    weight /= sum;
  }
}

}
