// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/Constants.h"
#include "Sea/Dispersion.h"
#include "Sea/SeaSpectrum.h"
#include "Sea/WaveOrbits.h"
#include "Sea/WaveTrains.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <random>

using namespace littoral;

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// The speed of a group of waves, dw/dk = w / 2 k (1 + 2 k h / sinh 2 k h) [m/s].
double GroupVelocity(double frequency, double depth)
{
  const double k = WaveNumber(frequency, depth);
  const double twice = 2.0 * k * depth;
  const double shallow = twice > 700.0 ? 0.0 : twice > 0.0 ? twice / std::sinh(twice) : 1.0;
  return 0.5 * frequency / k * (1.0 + shallow);
}

WaveTrain Train(double amplitude, double waveNumber, double depth, double direction = 0.0, double phase = 0.0)
{
  return { amplitude, WaveFrequency(waveNumber, depth), waveNumber, direction, phase };
}

SeaState Sea(double depth, int seed = 1, int trains = 30)
{
  SpectrumParameters parameters;
  TrainParameters cut;
  cut.Seed = seed;
  cut.Count = trains;
  return { TrainsOf(SeaSpectrum(parameters), depth, cut), depth, 0.0 };
}

struct Motion
{
  Vector3 Place;
  Vector3 Velocity;
  Vector3 Acceleration;
  double Gradient[5];
};

Motion MotionAt(const SeaState& sea, Vector3 center, double time, const WaveOrbitOptions& options = {})
{
  Motion motion;
  OrbitRequest<double> request;
  request.Centers = &center[0];
  request.Displacement = &motion.Place[0];
  request.Velocity = &motion.Velocity[0];
  request.Acceleration = &motion.Acceleration[0];
  request.Gradient = motion.Gradient;
  WaveOrbits(sea, options, time).Evaluate(request, 0, 1);
  return motion;
}

}

TEST(Dispersion, HoldsOverTwelveDecades)
{
  double worst = 0.0;
  for (double exponent = -8.0; exponent <= 4.0; exponent += 0.001)
  {
    const double y = std::pow(10.0, exponent);
    const double depth = 7.0;
    const double k = WaveNumber(std::sqrt(y * Gravity / depth), depth);
    worst = std::max(worst, std::abs(k * depth * std::tanh(k * depth) / y - 1.0));
  }
  std::cout << "largest relative residual of the dispersion relation: " << worst << std::endl;
  EXPECT_LT(worst, 1e-12);
}

TEST(Dispersion, HasNoNaNAtAnyDepth)
{
  for (const double depth : { 1e-300, 1e-200, 1e-12, 1e-3, 1.0, 1e6, 1e300, Infinity })
  {
    for (const double w : { 1e-150, 1e-6, 1.0, 1e4 })
    {
      const double k = WaveNumber(w, depth);
      EXPECT_TRUE(k > 0.0 && !std::isnan(GroupVelocity(w, depth))) << depth << " " << w;
    }
  }
  EXPECT_EQ(WaveNumber(0.0, 5.0), 0.0);
  EXPECT_EQ(WaveNumber(-1.0, 5.0), 0.0);
  // w^2 h / g is no normal number: all waves run at sqrt(g h).
  EXPECT_NEAR(1e-100 / WaveNumber(1e-100, 1e-110) / std::sqrt(Gravity * 1e-110), 1.0, 1e-12);
}

TEST(Dispersion, GroupVelocityIsTheSlope)
{
  for (const double depth : { 0.1, 1.0, 10.0, 1000.0 })
  {
    for (const double k : { 0.01, 0.3, 2.0 })
    {
      const double step = 1e-5 * k;
      const double slope = (WaveFrequency(k + step, depth) - WaveFrequency(k - step, depth)) / (2.0 * step);
      EXPECT_NEAR(GroupVelocity(WaveFrequency(k, depth), depth) / slope, 1.0, 1e-8);
    }
  }
  EXPECT_NEAR(GroupVelocity(1.0, Infinity), 0.5 * Gravity, 1e-12);
}

TEST(Orbits, DeepWaterDecaysExponentially)
{
  const WaveTrain train = Train(0.7, 0.3, Infinity);
  for (const double z : { 0.0, -0.5, -4.0, -30.0 })
  {
    const OrbitAxes axes = AxesAt(train, z, Infinity);
    EXPECT_NEAR(axes.Horizontal / (0.7 * std::exp(0.3 * z)), 1.0, 1e-9);
    EXPECT_NEAR(axes.Vertical / (0.7 * std::exp(0.3 * z)), 1.0, 1e-9);
  }
}

TEST(Orbits, FiniteDepthHasTheHyperbolicAxes)
{
  const double h = 5.0;
  for (const double kh : { 1e-6, 0.1, 0.1 * Pi, 1.0, Pi, 30.0, 1000.0 })
  {
    const WaveTrain train = Train(1.0, kh / h, h);
    for (const double part : { 0.0, 0.25, 0.5, 1.0 })
    {
      const OrbitAxes axes = AxesAt(train, -h * part, h);
      const long double x = static_cast<long double>(kh) * (1.0L - part);
      const long double a = std::cosh(x) / std::sinh(static_cast<long double>(kh));
      const long double b = std::sinh(x) / std::sinh(static_cast<long double>(kh));
      EXPECT_NEAR(axes.Horizontal, static_cast<double>(a), 1e-12 * static_cast<double>(a) + 1e-300);
      EXPECT_NEAR(axes.Vertical, static_cast<double>(b), 1e-12 * static_cast<double>(b) + 1e-300);
    }
  }
  // The numbers of kh = pi and pi/10: the bed in nearly deep water, and the near constant axis of shallow water.
  EXPECT_NEAR(AxesAt(Train(1.0, Pi / h, h), -h, h).Horizontal, 0.0866, 5e-5);
  const WaveTrain shallow = Train(1.0, 0.1 * Pi / h, h);
  EXPECT_NEAR(AxesAt(shallow, 0.0, h).Horizontal, 3.287, 5e-4);
  EXPECT_NEAR(AxesAt(shallow, -h, h).Horizontal, 3.131, 5e-4);
  EXPECT_NEAR(AxesAt(shallow, -0.5 * h, h).Vertical, 0.494, 5e-4);
  for (const double kh : { 1.0, 0.1 })
  {
    const WaveTrain train = Train(1.0, kh / h, h);
    for (const double z : { 0.0, -0.5 * h, -h })
    {
      const OrbitAxes axes = AxesAt(train, z, h);
      std::cout << "kh = " << kh << ", z = " << z / h << " h: a = " << axes.Horizontal << ", b = " << axes.Vertical
                << std::endl;
    }
  }
  for (const double z : { 0.0, -1e-300, -1e5, -1e300 })
  {
    EXPECT_FALSE(std::isnan(AxesAt(Train(1.0, 100.0, 1e5), z, 1e5).Vertical));
  }
}

TEST(Orbits, DoNotJumpBetweenRegimes)
{
  const double h = 10.0;
  for (const double limit : { Pi, 0.1 * Pi })
  {
    const OrbitAxes below = AxesAt(Train(1.0, (limit - 1e-9) / h, h), -4.0, h);
    const OrbitAxes above = AxesAt(Train(1.0, (limit + 1e-9) / h, h), -4.0, h);
    EXPECT_NEAR(below.Horizontal, above.Horizontal, 1e-7);
    EXPECT_NEAR(below.Vertical, above.Vertical, 1e-7);
  }
  EXPECT_EQ(RegimeOf(1.01 * Pi, 1.0), DepthRegime::Deep);
  EXPECT_EQ(RegimeOf(0.99 * Pi, 1.0), DepthRegime::Intermediate);
  EXPECT_EQ(RegimeOf(0.101 * Pi, 1.0), DepthRegime::Intermediate);
  EXPECT_EQ(RegimeOf(0.099 * Pi, 1.0), DepthRegime::Shallow);
}

TEST(Orbits, AreIncompressibleToFirstOrder)
{
  const double h = 6.0;
  for (const double k : { 0.05, 0.4, 2.0 })
  {
    const WaveTrain train = Train(1.0, k, h);
    const double step = 1e-4;
    const double slope =
      (AxesAt(train, -2.0 + step, h).Vertical - AxesAt(train, -2.0 - step, h).Vertical) / (2.0 * step);
    EXPECT_NEAR(slope, k * AxesAt(train, -2.0, h).Horizontal, 1e-7);
  }
}

TEST(Orbits, CrestsMoveForwardAtThePhaseSpeed)
{
  const double h = 4.0;
  const SeaState sea{ { Train(0.2, 0.8, h, 0.7) }, h, 0.0 };
  const Vector3 along(std::cos(0.7), std::sin(0.7), 0.0);
  const double speed = sea.Trains[0].AngularFrequency / 0.8;
  for (const double time : { 0.0, 1.3, 100.0 })
  {
    const Motion crest = MotionAt(sea, along * (Pi / 0.8 + speed * time), time);
    const double b = AxesAt(sea.Trains[0], 0.0, h).Vertical;
    EXPECT_NEAR(crest.Place.z, b, 1e-9);
    EXPECT_GT(glm::dot(crest.Velocity, along), 0.1);
    EXPECT_NEAR(crest.Velocity.z, 0.0, 1e-9);
  }
}

TEST(Orbits, VelocityAccelerationAndGradientAreDerivatives)
{
  const SeaState sea = Sea(12.0);
  const Vector3 center(3.0, -7.0, -1.5);
  const double d = 1e-4;
  const Motion now = MotionAt(sea, center, 5.0);
  const Vector3 speed = (MotionAt(sea, center, 5.0 + d).Place - MotionAt(sea, center, 5.0 - d).Place) / (2.0 * d);
  const Vector3 push = (MotionAt(sea, center, 5.0 + d).Velocity - MotionAt(sea, center, 5.0 - d).Velocity) / (2.0 * d);
  EXPECT_LT(glm::length(speed - now.Velocity), 1e-7);
  EXPECT_LT(glm::length(push - now.Acceleration), 1e-7);
  const auto along = [&](Vector3 step) {
    return (MotionAt(sea, center + step, 5.0).Place - MotionAt(sea, center - step, 5.0).Place) / (2.0 * d);
  };
  const Vector3 x = along({ d, 0.0, 0.0 });
  const Vector3 y = along({ 0.0, d, 0.0 });
  EXPECT_NEAR(x.x, now.Gradient[0], 1e-7);
  EXPECT_NEAR(x.y, now.Gradient[1], 1e-7);
  EXPECT_NEAR(y.x, now.Gradient[1], 1e-7);
  EXPECT_NEAR(y.y, now.Gradient[2], 1e-7);
  EXPECT_NEAR(x.z, now.Gradient[3], 1e-7);
  EXPECT_NEAR(y.z, now.Gradient[4], 1e-7);
  const Vector3 normal = SurfaceNormal(now.Gradient);
  EXPECT_NEAR(glm::dot(normal, x + Vector3(1.0, 0.0, 0.0)), 0.0, 1e-7);
  EXPECT_NEAR(glm::dot(normal, y + Vector3(0.0, 1.0, 0.0)), 0.0, 1e-7);
  EXPECT_GT(normal.z, 0.5);
}

TEST(Orbits, VelocityGradientIsTheDerivativeOfTheVelocity)
{
  const double d = 1e-4;
  for (const double depth : { 4.0, 12.0, Infinity }) // shallow, finite and deep forms
  {
    const SeaState sea = Sea(depth);
    const Vector3 center(3.0, -7.0, -1.5);
    double numbers[5];
    OrbitRequest<double> request;
    request.Centers = &center[0];
    request.VelocityGradient = numbers;
    WaveOrbits(sea, {}, 5.0).Evaluate(request, 0, 1);
    const float point[3] = { 3.0f, -7.0f, -1.5f };
    float singles[5];
    OrbitRequest<float> single;
    single.Centers = point;
    single.VelocityGradient = singles;
    WaveOrbits(sea, {}, 5.0).Evaluate(single, 0, 1);
    const auto along = [&](Vector3 step) {
      return (MotionAt(sea, center + step, 5.0).Velocity - MotionAt(sea, center - step, 5.0).Velocity) / (2.0 * d);
    };
    const Vector3 x = along({ d, 0.0, 0.0 });
    const Vector3 y = along({ 0.0, d, 0.0 });
    const Vector3 z = along({ 0.0, 0.0, d });
    // By symmetry, as the flow has no curl, dw/dx = du/dz and dw/dy = dv/dz; without divergence dw/dz is the rest.
    const double expected[5] = { x.x, y.x, y.y, z.x, z.y };
    for (int i = 0; i < 5; ++i)
    {
      EXPECT_NEAR(numbers[i], expected[i], 1e-7) << i << " at " << depth << " m";
      EXPECT_NEAR(singles[i], numbers[i], 1e-6) << i << " at " << depth << " m";
    }
    EXPECT_NEAR(x.y, numbers[1], 1e-7);
    EXPECT_NEAR(x.z, numbers[3], 1e-7);
    EXPECT_NEAR(y.z, numbers[4], 1e-7);
    EXPECT_NEAR(z.z, -(numbers[0] + numbers[2]), 1e-7);
    EXPECT_GT(std::abs(numbers[3]), 1e-3);
  }
}

TEST(Orbits, MeanOverWholePeriodsIsTheCenter)
{
  TrainParameters cut;
  cut.EqualSpacing = true;
  cut.Lowest = 0.5;
  cut.Highest = 3.5;
  cut.Count = 30;
  const SeaSpectrum spectrum{ SpectrumParameters{} };
  const SeaState sea{ TrainsOf(spectrum, 20.0, cut), 20.0, 0.0 };
  const double period = PeriodOf(spectrum, cut);
  const int samples = 256;
  Vector3 mean(0.0);
  for (int n = 0; n < samples; ++n)
  {
    mean += MotionAt(sea, { 1.0, 2.0, -3.0 }, period * n / samples).Place / static_cast<double>(samples);
  }
  std::cout << "distance of the mean position from the center: " << glm::length(mean) << " m" << std::endl;
  EXPECT_LT(glm::length(mean), 1e-10);
}

TEST(Orbits, MoveAlikeFarAwayAndAtAnyLevel)
{
  const double depth = 15.0;
  const SeaState here = Sea(depth);
  SeaState there = here;
  there.SeaLevel = 450.0;
  const Vector3 shift(1e6, -3e5, 450.0);
  for (WaveTrain& train : there.Trains)
  {
    train.Phase -= std::remainder(
      train.WaveNumber * (std::cos(train.Direction) * shift.x + std::sin(train.Direction) * shift.y), TwoPi);
  }
  double worst = 0.0;
  for (int n = 0; n < 200; ++n)
  {
    const Vector3 center(0.7 * n, 11.0 - 0.3 * n, -0.05 * n);
    const double time = 3.7 * n;
    worst =
      std::max(worst, glm::length(MotionAt(here, center, time).Place - MotionAt(there, center + shift, time).Place));
  }
  std::cout << "1000 km away and at sea level 450 m: within " << worst << " m" << std::endl;
  EXPECT_LT(worst, 1e-6);
}

TEST(Orbits, SinglePrecisionFollowsDoublePrecision)
{
  for (const double depth : { 0.3, 3.0, 40.0, Infinity })
  {
    const SeaState sea = Sea(depth);
    WaveOrbitOptions options;
    options.Choppiness = 0.8;
    const int count = 700;
    std::vector<float> centers(3 * count);
    std::vector<double> exactCenters(3 * count);
    std::vector<int> counts(count);
    for (int n = 0; n < count; ++n)
    {
      const auto number = static_cast<float>(n);
      centers[3 * n] = 1.5e5f + 13.7f * number;
      centers[3 * n + 1] = -3.1f * number;
      centers[3 * n + 2] = -0.002f * number * static_cast<float>(std::min(depth, 20.0));
      counts[n] = n % 33;
    }
    exactCenters.assign(centers.begin(), centers.end());
    std::vector<float> place(3 * count), speed(3 * count), push(3 * count), slope(5 * count);
    std::vector<double> place2(3 * count), speed2(3 * count), push2(3 * count), slope2(5 * count);
    const WaveOrbits orbits(sea, options, 1234.5);
    orbits.Evaluate({ centers.data(), counts.data(), place.data(), speed.data(), push.data(), slope.data() }, 0, count);
    orbits.Evaluate(
      { exactCenters.data(), counts.data(), place2.data(), speed2.data(), push2.data(), slope2.data() }, 0, count);
    double sum = 0.0;
    for (const WaveTrain& train : sea.Trains)
    {
      sum += AxesAt(train, 0.0, depth).Horizontal;
    }
    double worst = 0.0;
    for (int n = 0; n < 3 * count; ++n)
    {
      worst = std::max(worst, std::abs(place[n] - place2[n]));
      EXPECT_NEAR(speed[n], speed2[n], 1e-5 * sum);
      EXPECT_NEAR(push[n], push2[n], 2e-5 * sum);
    }
    for (int n = 0; n < 5 * count; ++n)
    {
      EXPECT_NEAR(slope[n], slope2[n], 1e-5 * sum);
    }
    std::cout << "depth " << depth << " m: single precision within " << worst / sum << " of the sum of axes, " << sum
              << " m" << std::endl;
    EXPECT_LT(worst, 1e-6 * sum);

    // In other ranges, the same bytes.
    std::vector<float> again(3 * count);
    for (const auto& range : { std::array<int, 2>{ 0, 13 }, { 13, 300 }, { 300, 700 } })
    {
      orbits.Evaluate({ centers.data(), counts.data(), again.data() }, range[0], range[1]);
    }
    EXPECT_EQ(again, place);
  }
}

TEST(Orbits, SinglePrecisionKeepsPhasesMillionsOfWavesAway)
{
  const SeaState sea{ { Train(1.0, TwoPi, Infinity, 0.0, 0.3) }, Infinity, 0.0 };
  const WaveOrbits orbits(sea, {}, 2.5);
  for (const double waves : { 0.0, 1e3, 1e6, 8e6, 1.6e7 })
  {
    for (int n = -200; n <= 200; ++n)
    {
      const float center[3] = { static_cast<float>((n < 0 ? -waves : waves) + 0.01 * n), 0.0f, 0.0f };
      const double exactCenter[3] = { center[0], 0.0, 0.0 };
      float place[3];
      double exact[3];
      OrbitRequest<float> request;
      request.Centers = center;
      request.Displacement = place;
      orbits.Evaluate(request, 0, 1);
      OrbitRequest<double> exactRequest;
      exactRequest.Centers = exactCenter;
      exactRequest.Displacement = exact;
      orbits.Evaluate(exactRequest, 0, 1);
      EXPECT_NEAR(place[0], exact[0], 4e-7) << center[0];
      EXPECT_NEAR(place[2], exact[2], 4e-7) << center[0];
    }
  }
}

TEST(Orbits, StokesDriftHasItsClosedForm)
{
  const double h = 3.0;
  const SeaState sea{ { Train(0.1, 0.9, h, 0.5) }, h, 0.0 };
  WaveOrbitOptions options;
  options.StokesDrift = true;
  const auto drift = WaveOrbits(sea, options, 0.0).StokesVelocity(-1.0, 1);
  const double sinh = std::sinh(0.9 * h);
  const double closed = sea.Trains[0].AngularFrequency * 0.9 * 0.01 * std::cosh(1.8 * (h - 1.0)) / (2.0 * sinh * sinh);
  EXPECT_NEAR(std::hypot(drift[0], drift[1]), closed, 1e-12);
  EXPECT_NEAR(std::atan2(drift[1], drift[0]), 0.5, 1e-12);
  // Alone it does not change with time; with it, displacement grows along the waves.
  EXPECT_NEAR(MotionAt(sea, { 0, 0, -1 }, 1e4, options).Place.x, drift[0] * 1e4, 0.2);
  EXPECT_LT(std::abs(MotionAt(sea, { 0, 0, -1 }, 1e4).Place.x), 0.2);

  const SeaState wind = Sea(Infinity, 1, 2000);
  double surface = 0.0;
  for (const WaveTrain& train : wind.Trains)
  {
    surface += train.AngularFrequency * train.WaveNumber * train.Amplitude * train.Amplitude;
  }
  std::cout << "Stokes drift at the surface, U = 10 m/s, up to 4 peak frequencies: " << surface << " m/s" << std::endl;
  EXPECT_NEAR(surface, 0.112, 1e-3);
}

TEST(Orbits, DopplerShiftKeepsThePeriodInACurrent)
{
  const SeaState sea{ { Train(0.3, 0.5, Infinity) }, Infinity, 0.0 };
  WaveOrbitOptions options;
  options.DopplerShift = true;
  options.Current[0] = 1.2;
  const double period = TwoPi / sea.Trains[0].AngularFrequency;
  const Motion start = MotionAt(sea, { 2.0, 0.0, -1.0 }, 3.0, options);
  const Motion later = MotionAt(sea, { 2.0 + 1.2 * period, 0.0, -1.0 }, 3.0 + period, options);
  EXPECT_LT(glm::length(start.Place - later.Place), 1e-12);
  const Motion unshifted = MotionAt(sea, { 2.0 + 1.2 * period, 0.0, -1.0 }, 3.0 + period);
  EXPECT_GT(glm::length(MotionAt(sea, { 2.0, 0.0, -1.0 }, 3.0).Place - unshifted.Place), 0.05);
}

TEST(Orbits, SharesOfTrainsAreThoseOfASmallerSea)
{
  std::mt19937 engine(3);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  for (const double depth : { Infinity, 30.0, 0.3 })
  {
    const SeaState sea = Sea(depth);
    SeaState smaller = sea;
    std::vector<float> shares;
    for (WaveTrain& train : smaller.Trains)
    {
      shares.push_back(shares.size() % 4 == 0 ? 1.0f : (shares.size() % 4 == 1 ? 0.0f : uniform(engine)));
      train.Amplitude *= shares.back();
    }
    WaveOrbitOptions options;
    options.StokesDrift = true;
    constexpr std::size_t Count = 40;
    std::vector<double> places;
    for (std::size_t i = 0; i < 3 * Count; ++i)
    {
      places.push_back((i % 3 == 2 ? -3.0 : 50.0) * uniform(engine));
    }
    const auto evaluated = [&](const SeaState& state, const float* parts, auto real) {
      using Real = decltype(real);
      const std::vector<Real> centers(places.begin(), places.end());
      std::vector<Real> numbers(14 * Count);
      OrbitRequest<Real> request;
      request.Centers = centers.data();
      request.Shares = parts;
      request.Displacement = &numbers[0];
      request.Velocity = &numbers[3 * Count];
      request.Acceleration = &numbers[6 * Count];
      request.Gradient = &numbers[9 * Count];
      WaveOrbits(state, options, 11.0).Evaluate(request, 0, Count);
      return numbers;
    };
    const auto worst = [&](auto real) {
      const auto wanted = evaluated(smaller, nullptr, real);
      const auto got = evaluated(sea, shares.data(), real);
      double error = 0.0;
      double size = 0.0;
      for (std::size_t i = 0; i < got.size(); ++i)
      {
        error = std::max(error, std::abs(static_cast<double>(got[i]) - wanted[i]));
        size = std::max(size, std::abs(static_cast<double>(wanted[i])));
      }
      return error / size;
    };
    EXPECT_LT(worst(0.0), 1e-13) << depth;
    EXPECT_LT(worst(0.0f), 1e-6) << depth;
  }
}

// Points with sets of their own are moved as by that set alone, whatever others there are.
TEST(Orbits, SharesOfAPointAreThoseOfItsSet)
{
  constexpr int Sets = 3;
  constexpr std::size_t Count = 300; // more than a block
  for (const SeaOrder order : { SeaOrder::First, SeaOrder::Second })
  {
    SeaState sea = Sea(12.0);
    sea.Trains.resize(6);
    sea.Order = order;
    const std::size_t trains = sea.Trains.size();
    std::vector<float> shares(Sets * trains, 0.0f);
    std::fill_n(shares.begin(), trains, 1.0f);
    std::fill_n(shares.begin() + static_cast<std::ptrdiff_t>(trains), 4, 0.6f);
    shares[2 * trains] = 0.25f;
    std::vector<double> places;
    std::vector<int> sets;
    for (std::size_t i = 0; i < Count; ++i)
    {
      const auto n = static_cast<double>(i);
      places.insert(places.end(), { 1.7 * n, 30.0 - n, -0.02 * n });
      sets.push_back(static_cast<int>(i * i % Sets));
    }
    WaveOrbitOptions options;
    options.StokesDrift = true;
    const WaveOrbits orbits(sea, options, 7.0);
    const auto check = [&](auto real, double tolerance) {
      using Real = decltype(real);
      const std::vector<Real> centers(places.begin(), places.end());
      std::vector<Real> all(9 * Count);
      std::vector<Real> one(9 * Count);
      std::vector<Real> alone(9 * Count);
      const auto request = [&](std::vector<Real>& numbers) {
        OrbitRequest<Real> own;
        own.Centers = centers.data();
        own.Shares = shares.data();
        own.Displacement = &numbers[0];
        own.Velocity = &numbers[3 * Count];
        own.Acceleration = &numbers[6 * Count];
        return own;
      };
      OrbitRequest<Real> together = request(all);
      together.ShareSets = sets.data();
      orbits.Evaluate(together, 0, Count);
      OrbitRequest<Real> each = request(alone);
      each.ShareSets = sets.data();
      for (std::size_t i = 0; i < Count; ++i)
      {
        orbits.Evaluate(each, i, i + 1);
        OrbitRequest<Real> single = request(one);
        single.Shares += static_cast<std::size_t>(sets[i]) * trains;
        orbits.Evaluate(single, i, i + 1);
      }
      EXPECT_EQ(all, alone);
      double size = 0.0;
      double error = 0.0;
      for (std::size_t i = 0; i < all.size(); ++i)
      {
        size = std::max(size, std::abs(static_cast<double>(one[i])));
        error = std::max(error, std::abs(static_cast<double>(all[i]) - one[i]));
      }
      EXPECT_GT(size, 0.1);
      EXPECT_LE(error, tolerance * size);
    };
    check(0.0, 0.0);
    check(0.0f, 1e-6);
  }
}

TEST(Spectrum, PiersonMoskowitzHasItsMoments)
{
  // 4 sqrt(alpha / (4 beta)) U2 / g and 2 pi (5 / (4 beta))^(1/4) U / g
  for (const auto& [wind, height, period] : { std::array<double, 3>{ 5, 0.5334, 3.652 }, { 10, 2.1337, 7.304 },
         { 15, 4.8009, 10.956 }, { 20, 8.5349, 14.609 } })
  {
    SpectrumParameters parameters;
    parameters.WindSpeed = wind;
    const SeaSpectrum spectrum(parameters);
    EXPECT_NEAR(4.0 * std::sqrt(spectrum.TotalEnergy()), height, 6e-5);
    EXPECT_NEAR(TwoPi / spectrum.PeakFrequency(), period, 6e-4);
    const double w = 1.3 * spectrum.PeakFrequency();
    const double density =
      8.1e-3 * Gravity * Gravity * std::pow(w, -5.0) * std::exp(-0.74 * std::pow(Gravity / (wind * w), 4.0));
    EXPECT_NEAR(spectrum.Density(w) / density, 1.0, 1e-12);
    EXPECT_NEAR(spectrum.Energy(w, w + 1e-5) / (1e-5 * spectrum.Density(w + 0.5e-5)), 1.0, 1e-6);
  }
}

TEST(Spectrum, TrainsKeepTheEnergyOfTheirRange)
{
  const SeaSpectrum spectrum{ SpectrumParameters{} };
  for (const int count : { 1, 2, 10, 30, 60, 1000 })
  {
    TrainParameters cut;
    cut.Count = count;
    double sum = 0.0;
    for (const WaveTrain& train : TrainsOf(spectrum, Infinity, cut))
    {
      sum += 0.5 * train.Amplitude * train.Amplitude;
    }
    std::cout << count << " trains: " << sum / spectrum.TotalEnergy() << " of the energy" << std::endl;
    EXPECT_NEAR(sum / spectrum.TotalEnergy(), 0.995129, 5e-7);
  }
}

TEST(Spectrum, HeightsOfParticlesGiveTheSignificantHeight)
{
  double variance = 0.0;
  const int seeds = 20;
  const int samples = 4000;
  for (int seed = 1; seed <= seeds; ++seed)
  {
    const SeaState sea = Sea(Infinity, seed);
    double sum = 0.0;
    double squares = 0.0;
    for (int n = 0; n < samples; ++n)
    {
      const double z = MotionAt(sea, { 5.0, 6.0, 0.0 }, 0.5 * n).Place.z;
      sum += z / samples;
      squares += z * z / samples;
    }
    variance += (squares - sum * sum) / seeds;
  }
  std::cout << "significant height of particles, U = 10 m/s: " << 4.0 * std::sqrt(variance) << " m" << std::endl;
  EXPECT_NEAR(4.0 * std::sqrt(variance), 2.133, 0.01 * 2.133);
}

TEST(Spectrum, JonswapHasItsClosedForm)
{
  SpectrumParameters parameters;
  parameters.Kind = SpectrumKind::Jonswap;
  parameters.FromWind = false;
  parameters.SignificantHeight = 3.0;
  parameters.PeakPeriod = 9.0;
  const SeaSpectrum young(parameters);
  EXPECT_NEAR(4.0 * std::sqrt(young.Energy(0.0, Infinity)), 3.0, 1e-9);
  EXPECT_NEAR(TwoPi / young.PeakFrequency(), 9.0, 1e-9);
  const double p = young.PeakFrequency();
  const auto closed = [p](double w) {
    const double sigma = w > p ? 0.09 : 0.07;
    const double x = (w - p) / (sigma * p);
    return std::pow(w, -5.0) * std::exp(-1.25 * std::pow(p / w, 4.0)) * std::pow(3.3, std::exp(-0.5 * x * x));
  };
  for (const double ratio : { 0.7, 0.95, 1.02, 1.5, 3.0 })
  {
    EXPECT_NEAR(young.Density(ratio * p) / young.Density(p), closed(ratio * p) / closed(p), 1e-12);
    EXPECT_LT(young.Density(ratio * p), young.Density(p));
  }
  parameters.PeakEnhancement = 1.0;
  const SeaSpectrum flat(parameters);
  parameters.Kind = SpectrumKind::PiersonMoskowitz;
  const SeaSpectrum developed(parameters);
  EXPECT_NEAR(flat.Density(1.1) / developed.Density(1.1), 1.0, 1e-9);
  EXPECT_NEAR(flat.Energy(0.8, 0.9) / developed.Energy(0.8, 0.9), 1.0, 1e-9);
}

TEST(Spectrum, TmaTakesEnergyFromWavesThatFeelTheBed)
{
  SpectrumParameters parameters;
  for (const SpectrumKind kind : { SpectrumKind::Tma, SpectrumKind::Jonswap, SpectrumKind::PiersonMoskowitz })
  {
    parameters.Kind = kind;
    parameters.Depth = 8.0;
    const SeaSpectrum shallow(parameters);
    parameters.Kind = kind == SpectrumKind::Tma ? SpectrumKind::Jonswap : kind;
    parameters.Depth = Infinity;
    const SeaSpectrum deep(parameters);
    for (const double w : { 0.6, 0.9, 1.4, 2.5 })
    {
      const double x = WaveNumber(w, 8.0) * 8.0;
      const double factor = std::pow(std::tanh(x), 2.0) / (1.0 + 2.0 * x / std::sinh(2.0 * x));
      EXPECT_NEAR(shallow.Density(w) / deep.Density(w), factor, 1e-9);
    }
    EXPECT_LT(shallow.TotalEnergy(), 0.8 * deep.TotalEnergy());
  }
  parameters.Kind = SpectrumKind::Tma;
  parameters.Depth = 8.0;
  parameters.FromWind = false;
  const SeaSpectrum given(parameters);
  EXPECT_NEAR(4.0 * std::sqrt(given.Energy(0.0, Infinity)), 2.0, 1e-9);
  const double p = TwoPi / 7.0;
  EXPECT_LT(given.Density(0.99 * p), given.Density(p));
  EXPECT_LT(given.Density(1.01 * p), given.Density(p));
  parameters.Depth = Infinity;
  EXPECT_NEAR(
    SeaSpectrum(parameters).Density(1.2),
    [&] {
      parameters.Kind = SpectrumKind::Jonswap;
      return SeaSpectrum(parameters).Density(1.2);
    }(),
    1e-9);
}

TEST(Spectrum, DepthHoldsTheSeaOfAWindAndBreaksHigherOnes)
{
  // Significant heights on 6 m of water, by quadrature of TMA elsewhere; without its factor 8.5 m at 20 m/s.
  SpectrumParameters parameters;
  parameters.Depth = 6.0;
  for (const auto& known : { std::array<double, 3>{ 10.0, 1.2973, 1.2113 }, { 20.0, 2.7905, 2.5632 } })
  {
    parameters.WindSpeed = known[0];
    parameters.Kind = SpectrumKind::PiersonMoskowitz;
    EXPECT_NEAR(4.0 * std::sqrt(SeaSpectrum(parameters).TotalEnergy()), known[1], 1e-3);
    EXPECT_EQ(WhyBroken(SeaSpectrum(parameters), 6.0), "");
    parameters.Kind = SpectrumKind::Tma;
    EXPECT_NEAR(4.0 * std::sqrt(SeaSpectrum(parameters).TotalEnergy()), known[2], 1e-3);
  }
  // What a storm would raise on half a metre breaks.
  parameters.Depth = 0.5;
  EXPECT_NEAR(4.0 * std::sqrt(SeaSpectrum(parameters).TotalEnergy()), 0.295, 1e-12);
  EXPECT_EQ(WhyBroken(SeaSpectrum(parameters), 0.5), "");
  parameters.Depth = 6.0;
  parameters.FromWind = false;
  for (const SpectrumKind kind : { SpectrumKind::PiersonMoskowitz, SpectrumKind::Regular })
  {
    const double highest = (kind == SpectrumKind::Regular ? 0.78 : 0.59) * 6.0;
    parameters.Kind = kind;
    parameters.SignificantHeight = 0.99 * highest;
    EXPECT_NEAR(SeaSpectrum(parameters).TotalEnergy(),
      std::pow(parameters.SignificantHeight, 2) / (kind == SpectrumKind::Regular ? 8.0 : 16.0), 1e-12);
    EXPECT_EQ(WhyBroken(SeaSpectrum(parameters), 6.0), "");
    parameters.SignificantHeight = 1.01 * highest;
    EXPECT_NE(WhyBroken(SeaSpectrum(parameters), 6.0).find("WaterDepth"), std::string::npos);
    EXPECT_EQ(WhyBroken(SeaSpectrum(parameters), Infinity), "");
  }
}

TEST(Spectrum, TableIsIntegratedExactly)
{
  SpectrumParameters parameters;
  parameters.Kind = SpectrumKind::Table;
  parameters.Frequencies = { 0.05, 0.1, 0.2, 0.5 };
  parameters.Densities = { 0.0, 4.0, 1.0, 0.0 };
  ASSERT_EQ(WhyInvalid(parameters), "");
  const SeaSpectrum spectrum(parameters);
  EXPECT_NEAR(spectrum.TotalEnergy(), 0.1 + 0.25 + 0.15, 1e-12);
  EXPECT_NEAR(spectrum.PeakFrequency(), 0.2 * Pi, 1e-12);
  EXPECT_NEAR(spectrum.Energy(0.2 * Pi, 0.3 * Pi), 0.05 * 0.5 * (4.0 + 2.5), 1e-12);
  EXPECT_EQ(spectrum.Density(0.01), 0.0);
  parameters.Densities[2] = -1.0;
  EXPECT_NE(WhyInvalid(parameters).find("Density"), std::string::npos);
  parameters.Densities[2] = 1.0;
  parameters.Frequencies[2] = 0.1;
  EXPECT_NE(WhyInvalid(parameters).find("Frequency"), std::string::npos);
}

// The data buoys' 999.00 for a band that was not measured, of which three made a sea of 18 m; densities in cm2/Hz.
TEST(Spectrum, CodesForMissingDensitiesAreNoWaves)
{
  SpectrumParameters parameters;
  parameters.Kind = SpectrumKind::Table;
  parameters.Frequencies = { 0.02, 0.0325, 0.0375, 0.1, 0.2, 0.5 };
  parameters.Densities = { 0.0, 999.0, 999.0, 4.0, 1.0, 0.0 };
  EXPECT_EQ(WhyInvalid(parameters), "leave out row 1 of the spectrum: Density 999 is a code for a missing value.");
  parameters.Densities = { 0.0, 0.0, 0.0, 40000.0, 10000.0, 0.0 };
  EXPECT_EQ(WhyInvalid(parameters),
    "Density of the spectrum makes a significant wave height of 289.828 m; it must be in m2/Hz."); // 4 m0^(1/2)
  parameters.Densities = { 0.0, 0.0, 0.0, 400.0, 100.0, 0.0 };
  EXPECT_EQ(WhyInvalid(parameters), "");
}

TEST(Spectrum, WithoutSpreadingAllTrainsGoOneWay)
{
  TrainParameters cut;
  cut.MeanDirection = 0.4;
  cut.Spreading = 0.0;
  for (const WaveTrain& train : TrainsOf(SeaSpectrum(SpectrumParameters{}), Infinity, cut))
  {
    EXPECT_EQ(train.Direction, 0.4);
  }
}

TEST(Spectrum, ARegularWaveIsAsHighAsGiven)
{
  SpectrumParameters parameters;
  parameters.Kind = SpectrumKind::Regular;
  parameters.FromWind = false;
  parameters.SignificantHeight = 3.0;
  parameters.PeakPeriod = 8.0;
  const SeaSpectrum spectrum(parameters);
  EXPECT_NEAR(spectrum.TotalEnergy(), 3.0 * 3.0 / 8.0, 1e-14); // mean square of a sine of amplitude H/2
  const std::vector<WaveTrain> trains = TrainsOf(spectrum, 50.0, {});
  ASSERT_EQ(trains.size(), 1u);
  EXPECT_NEAR(trains[0].Amplitude, 1.5, 1e-14);
  EXPECT_NEAR(trains[0].AngularFrequency, TwoPi / 8.0, 1e-14);
  EXPECT_NEAR(-trains[0].Amplitude * std::cos(trains[0].Phase), 1.5, 1e-14); // a crest at the origin at time 0
}

TEST(Spectrum, TrainsHavePhasesOfAWholeTurnAndTheHighestIsFirst)
{
  TrainParameters cut;
  cut.Count = 4000;
  const std::vector<WaveTrain> trains = TrainsOf(SeaSpectrum(SpectrumParameters{}), Infinity, cut);
  const auto count = static_cast<double>(trains.size());
  double cosine = 0.0;
  double sine = 0.0;
  for (std::size_t n = 0; n < trains.size(); ++n)
  {
    cosine += std::cos(trains[n].Phase) / count;
    sine += std::sin(trains[n].Phase) / count;
    EXPECT_TRUE(n == 0 || trains[n].Amplitude <= trains[n - 1].Amplitude);
  }
  // Means of uniform phases: 0, with a standard deviation of (2 n)^-1/2.
  EXPECT_NEAR(cosine, 0.0, 4.0 / std::sqrt(2.0 * count));
  EXPECT_NEAR(sine, 0.0, 4.0 / std::sqrt(2.0 * count));
}
