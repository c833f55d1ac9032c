// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/Constants.h"
#include "Numerics/RandomStream.h"
#include "Sway/BeamResponse.h"

#include <boost/numeric/odeint.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <cstring>

using namespace littoral;

namespace
{

std::vector<double> RandomLoad(int count, int seed)
{
  const RandomStream random(seed, RandomPurpose::QuadratCounts);
  std::vector<double> load(count);
  for (int k = 0; k < count; ++k)
  {
    load[k] = 1.0 + random.NormalPair(0, k)[0];
  }
  return load;
}

std::vector<Vector3> RandomLoads(int count)
{
  std::vector<Vector3> loads(count);
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::vector<double> load = RandomLoad(count, 7 + axis);
    for (int k = 0; k < count; ++k)
    {
      loads[k][axis] = load[k];
    }
  }
  return loads;
}

/// Response of a beam along a unit vector from those of beams along x, y and z: eq. 25 of Setas et al. with the factor
/// 1/2 that it lacks. Each of the three has two of the three components, so that their sum has each twice.
Vector3 InterpolatedResponse(const Vector3& x, const Vector3& y, const Vector3& z, const Vector3& beam)
{
  return AcrossBeam(0.5 * (x + y + z), beam);
}

/// A Runge-Kutta-Fehlberg solution of order 8 of one step, in 256 smaller ones.
OscillatorState Integrated(const Oscillator& of, OscillatorState from, double step, double before, double after)
{
  using State = std::array<double, 2>;
  State state{ from.Displacement, from.Velocity };
  const auto derivative = [&](const State& y, State& change, double t) {
    const double load = before + (after - before) * t / step;
    change = { y[1], load - 2.0 * of.DampingRatio * of.Frequency * y[1] - of.Frequency * of.Frequency * y[0] };
  };
  boost::numeric::odeint::runge_kutta_fehlberg78<State> stepper;
  for (int i = 0; i < 256; ++i)
  {
    stepper.do_step(derivative, state, i * step / 256.0, step / 256.0);
  }
  return { state[0], state[1] };
}

double Largest(const std::vector<double>& values)
{
  double largest = 0.0;
  for (const double value : values)
  {
    largest = std::max(largest, std::abs(value));
  }
  return largest;
}

constexpr double Step = 0.05; // [s]

}

TEST(BeamResponse, RecurrenceIsExact)
{
  const std::vector<double> load = RandomLoad(200, 3);
  for (const Oscillator& oscillator :
    { Oscillator{ 0.05, 0.02 }, Oscillator{ 3.0, 0.05 }, Oscillator{ 40.0, 0.3 }, Oscillator{ 300.0, 0.05 } })
  {
    const OscillatorStep advance(oscillator, Step);
    OscillatorState recurrence;
    OscillatorState reference;
    double error = 0.0;
    double scale = 0.0;
    for (int k = 0; k + 1 < 200; ++k)
    {
      recurrence = advance.Advance(recurrence, load[k], load[k + 1]);
      reference = Integrated(oscillator, reference, Step, load[k], load[k + 1]);
      error = std::max(error, std::abs(recurrence.Displacement - reference.Displacement));
      error = std::max(error, std::abs(recurrence.Velocity - reference.Velocity) / oscillator.Frequency);
      scale = std::max(scale, std::abs(reference.Displacement));
    }
    std::printf("frequency %g rad/s, damping %g: difference from the ODE solution %.3g of the largest place\n",
      oscillator.Frequency, oscillator.DampingRatio, error / scale);
    EXPECT_LT(error / scale, 1e-9);
  }
}

TEST(BeamResponse, BothFormsMeet)
{
  // the series below and the closed form above a product of frequency and step of 1
  const OscillatorStep below({ 1.0 - 1e-13, 0.1 }, 1.0);
  const OscillatorStep above({ 1.0 + 1e-13, 0.1 }, 1.0);
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_NEAR(below.DisplacementFrom[i], above.DisplacementFrom[i], 2e-12);
    EXPECT_NEAR(below.VelocityFrom[i], above.VelocityFrom[i], 2e-12);
  }
}

TEST(BeamResponse, ConstantLoadIsStatic)
{
  for (const double frequency : { 1e-3, 0.3, 5.0, 400.0 })
  {
    const std::vector<double> places = PeriodicResponse({ frequency, 0.05 }, Step, std::vector<double>(100, 2.0));
    for (const double place : places)
    {
      EXPECT_NEAR(place * frequency * frequency / 2.0, 1.0, 1e-9);
    }
  }
}

TEST(BeamResponse, PeriodCloses)
{
  const int count = 4000;
  const std::vector<double> load = RandomLoad(count, 11);
  for (const Oscillator& oscillator : { Oscillator{ 0.3, 0.01 }, Oscillator{ 2.0, 0.05 }, Oscillator{ 60.0, 0.08 } })
  {
    const std::vector<double> places = PeriodicResponse(oscillator, Step, load);
    // The next place after the last two, without the speed: the recurrence of second order that both share.
    const OscillatorStep a(oscillator, Step);
    const auto next = [&](int k) {
      const int one = (k + 1) % count;
      const int two = (k + 2) % count;
      const double speed = (places[one] - a.DisplacementFrom[0] * places[k] - a.DisplacementFrom[2] * load[k] -
                             a.DisplacementFrom[3] * load[one]) /
        a.DisplacementFrom[1];
      const OscillatorState at = a.Advance({ places[k], speed }, load[k], load[one]);
      return a.Advance(at, load[one], load[two]).Displacement;
    };
    double jump = 0.0;
    for (int k = count - 3; k < count + 3; ++k)
    {
      jump = std::max(jump, std::abs(next(k % count) - places[(k + 2) % count]));
    }
    std::printf(
      "frequency %g rad/s: jump at the wrap %.3g of the largest place\n", oscillator.Frequency, jump / Largest(places));
    EXPECT_LT(jump / Largest(places), 1e-12);
  }
}

TEST(BeamResponse, SteadyStateFromASpectrum)
{
  // One harmonic through the transfer function of the recurrence, e1^T (z I - A)^-1 (B0 + z B1).
  const int count = 256;
  const Oscillator oscillator{ 6.0, 0.03 };
  const OscillatorStep step(oscillator, Step);
  using Complex = std::complex<double>;
  for (const int harmonic : { 1, 12, 40, 100 })
  {
    std::vector<double> load(count);
    for (int k = 0; k < count; ++k)
    {
      load[k] = std::cos(TwoPi * harmonic * k / count);
    }
    const Complex z = std::polar(1.0, TwoPi * harmonic / count);
    const Complex a = z - step.DisplacementFrom[0];
    const Complex d = z - step.VelocityFrom[1];
    const Complex displacement = step.DisplacementFrom[2] + z * step.DisplacementFrom[3];
    const Complex velocity = step.VelocityFrom[2] + z * step.VelocityFrom[3];
    const Complex gain = (d * displacement + step.DisplacementFrom[1] * velocity) /
      (a * d - step.DisplacementFrom[1] * step.VelocityFrom[0]);
    const std::vector<double> places = PeriodicResponse(oscillator, Step, load);
    double error = 0.0;
    for (int k = 0; k < count; ++k)
    {
      const double expected = std::real(gain * std::polar(1.0, TwoPi * harmonic * k / count));
      error = std::max(error, std::abs(places[k] - expected) / std::abs(gain));
    }
    std::printf("harmonic %d: difference from the spectrum %.3g\n", harmonic, error);
    EXPECT_LT(error, 1e-11);
  }
}

TEST(BeamResponse, InterpolatedEqualsDirect)
{
  const std::vector<Vector3> load = RandomLoads(1000);
  const Oscillator oscillator{ 4.0, 0.05 };
  const auto ofBeam = [&](const Vector3& beam) {
    std::vector<Vector3> own;
    for (const Vector3& sample : load)
    {
      own.push_back(AcrossBeam(sample, beam));
    }
    return PeriodicResponse(oscillator, Step, own);
  };
  const auto x = ofBeam({ 1.0, 0.0, 0.0 });
  const auto y = ofBeam({ 0.0, 1.0, 0.0 });
  const auto z = ofBeam({ 0.0, 0.0, 1.0 });
  double error = 0.0;
  double largest = 0.0;
  double unhalved = 0.0;
  for (int i = 0; i < 50; ++i)
  {
    const RandomStream random(i, RandomPurpose::QuadratOrder);
    const auto angles = random.UniformPair(0, 0);
    const double height = 2.0 * angles[0] - 1.0;
    const double flat = std::sqrt(1.0 - height * height);
    const Vector3 beam{ flat * std::cos(TwoPi * angles[1]), flat * std::sin(TwoPi * angles[1]), height };
    const auto direct = ofBeam(beam);
    for (std::size_t k = 0; k < load.size(); ++k)
    {
      const Vector3 interpolated = InterpolatedResponse(x[k], y[k], z[k], beam);
      error = std::max(error, glm::distance(interpolated, direct[k]));
      unhalved = std::max(unhalved, glm::distance(2.0 * interpolated, direct[k]));
      largest = std::max(largest, glm::length(direct[k]));
    }
  }
  std::printf("interpolated against direct: %.3g of the largest response (as printed, without the half: %.3g)\n",
    error / largest, unhalved / largest);
  EXPECT_LT(error / largest, 1e-6);
  EXPECT_GT(unhalved / largest, 0.5);
}

TEST(BeamResponse, TimesBetweenSamples)
{
  const std::vector<double> series = PeriodicResponse({ 5.0, 0.05 }, Step, RandomLoad(300, 5));
  for (int k = 0; k < 300; ++k)
  {
    EXPECT_NEAR(SeriesPlace(k * Step, Step, 300).Of(series.data()), series[k], 1e-9);
  }
  const double period = 300 * Step;
  for (const double time : { 0.013, 3.333, 14.99, -2.71 })
  {
    const double once = SeriesPlace(time, Step, 300).Of(series.data());
    EXPECT_NEAR(SeriesPlace(time + period, Step, 300).Of(series.data()), once, 1e-9);
    EXPECT_NEAR(SeriesPlace(time - 7.0 * period, Step, 300).Of(series.data()), once, 1e-9);
    const double slope = (SeriesPlace(time + 1e-6, Step, 300).Of(series.data()) - once) / 1e-6;
    EXPECT_LT(std::abs(slope), 20.0);
  }
  for (const double time : { 1.0, -1e9, 1e12, 0.0, period })
  {
    const SeriesPlace place(time, Step, 300);
    double sum = 0.0;
    for (std::size_t i = 0; i < SeriesTaps; ++i)
    {
      EXPECT_LT(place.Samples[i], 300u);
      sum += place.Weights[i];
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
  }
}

TEST(BeamResponse, WavesKeepTheirSizeBetweenSamples)
{
  // Of four samples and more to a wave; a cubic through the samples (Catmull-Rom) leaves 0.78 of the power of the
  // first.
  constexpr int Count = 240;
  for (const int waves : { 1, 7, 23, 60 })
  {
    std::vector<double> series(Count);
    for (int n = 0; n < Count; ++n)
    {
      series[n] = std::sin(TwoPi * waves * n / Count + 0.3);
    }
    double worst = 0.0;
    for (int part = 0; part < 16; ++part)
    {
      double power = 0.0;
      for (int n = 0; n < Count; ++n)
      {
        const double place = n + part / 16.0;
        const double has = SeriesPlace(place * Step, Step, Count).Of(series.data());
        power += 2.0 * has * has / Count;
        worst = std::max(worst, std::abs(has - std::sin(TwoPi * waves * place / Count + 0.3)));
      }
      EXPECT_NEAR(power, 1.0, 0.003) << waves << " waves, part " << part;
    }
    std::printf("%d samples to a wave: within %.2g of it between them\n", Count / waves, worst);
    EXPECT_LT(worst, 0.0015);
  }
}

TEST(BeamResponse, SharpLoadGivesBackWhatLinesLose)
{
  // A beam in resonance with a load of n samples to a wave has the amplitude 1 / (2 xi w^2). Under straight lines
  // between the samples it has sinc^2 of it: 0.81 for four.
  for (const int samples : { 4, 6, 10, 40 })
  {
    const double frequency = TwoPi / (samples * Step);
    const std::size_t count = 60 * samples;
    std::vector<Vector3> load(count + 2 * LoadMargin);
    for (std::size_t n = 0; n < load.size(); ++n)
    {
      load[n] = { std::cos(frequency * Step * static_cast<double>(n)), 0.0, 3.0 };
    }
    const std::vector<Vector3> sharp = SharpLoad(load);
    ASSERT_EQ(sharp.size(), count);
    double power = 0.0;
    for (const Vector3& place : PeriodicResponse({ frequency, 0.01 }, Step, sharp))
    {
      power += 2.0 * place.x * place.x / static_cast<double>(count);
      EXPECT_NEAR(place.z * frequency * frequency, 3.0, 1e-9);
    }
    const double part = std::sqrt(power) * 2.0 * 0.01 * frequency * frequency;
    std::printf("resonance at %d samples to a wave: %.4f of the closed form\n", samples, part);
    EXPECT_NEAR(part, 1.0, samples == 4 ? 0.008 : 0.001);
  }
}
