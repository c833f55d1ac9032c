// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/Constants.h"
#include "Sea/Dispersion.h"
#include "Sea/SecondOrder.h"
#include "Sea/WaveOrbits.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <vector>

using namespace littoral;

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

WaveTrain Train(double amplitude, double waveNumber, double depth, double direction = 0.0, double phase = 0.0)
{
  return { amplitude, WaveFrequency(waveNumber, depth), waveNumber, direction, phase };
}

/// Flow and surface of trains to second order by the conditions of the free surface themselves: the forcing of each
/// pair is projected on sums and differences of phases that are sampled, without any kernel.
class Eulerian
{
public:
  Eulerian(const std::vector<WaveTrain>& trains, double depth)
    : Trains(trains)
    , Depth(depth)
  {
    for (std::size_t i = 0; i < trains.size(); ++i)
    {
      for (std::size_t j = i; j < trains.size(); ++j)
      {
        this->AddPair(trains[i], trains[j], i == j);
      }
    }
  }

  struct Wave
  {
    double X, Y, Frequency, Phase, Elevation, Potential;
    double K() const { return std::hypot(X, Y); }
  };

  const std::vector<Wave>& Waves() const { return this->Second; }

  /// Elevation to second order.
  double Elevation(double x, double y, double t) const
  {
    double sum = 0.0;
    for (const WaveTrain& train : this->Trains)
    {
      sum += train.Amplitude * std::cos(this->PhaseOf(train, x, y, t));
    }
    for (const Wave& wave : this->Second)
    {
      sum += wave.Elevation * std::cos(wave.X * x + wave.Y * y - wave.Frequency * t + wave.Phase);
    }
    return sum;
  }

  /// Velocity to second order.
  Vector3 Velocity(const Vector3& at, double t) const
  {
    Vector3 sum(0.0);
    for (const WaveTrain& train : this->Trains)
    {
      const double p = Gravity * train.Amplitude / train.AngularFrequency;
      this->AddFlow(sum, at.z, train.WaveNumber * std::cos(train.Direction),
        train.WaveNumber * std::sin(train.Direction), p, this->PhaseOf(train, at.x, at.y, t));
    }
    for (const Wave& wave : this->Second)
    {
      this->AddFlow(
        sum, at.z, wave.X, wave.Y, wave.Potential, wave.X * at.x + wave.Y * at.y - wave.Frequency * t + wave.Phase);
    }
    return sum;
  }

private:
  /// Phases of crests: those of a train lie at pi.
  double PhaseOf(const WaveTrain& train, double x, double y, double t) const
  {
    return train.WaveNumber * (std::cos(train.Direction) * x + std::sin(train.Direction) * y) -
      train.AngularFrequency * t + train.Phase + Pi;
  }

  void AddFlow(Vector3& sum, double z, double kx, double ky, double p, double phase) const
  {
    const double k = std::hypot(kx, ky);
    if (k == 0.0)
    {
      return;
    }
    const double deep = std::min(this->Depth, 300.0 / k);
    const double c = std::cosh(k * (z + deep)) / std::cosh(k * deep);
    const double s = std::sinh(k * (z + deep)) / std::cosh(k * deep);
    sum += Vector3(kx * p * c * std::cos(phase), ky * p * c * std::cos(phase), k * p * s * std::sin(phase));
  }

  void AddPair(const WaveTrain& a, const WaveTrain& b, bool isSelf)
  {
    constexpr int Steps = 8;
    std::complex<double> forcing[2] = {};
    std::complex<double> pressure[2] = {};
    const double g = Gravity;
    for (int m = 0; m < Steps; ++m)
    {
      for (int n = 0; n < Steps; ++n)
      {
        const double phase[2] = { TwoPi * m / Steps, TwoPi * n / Steps };
        const WaveTrain* trains[2] = { &a, &b };
        // At z = 0: eta, grad phi, their time derivatives, phi_tz, phi_ttz + g phi_zz
        double eta[2], u[2], v[2], w[2], ut[2], vt[2], wt[2], rest[2];
        for (int i = 0; i < 2; ++i)
        {
          const WaveTrain& t = *trains[i];
          const double k = t.WaveNumber;
          const double p = g * t.Amplitude / t.AngularFrequency;
          const double tanh = std::tanh(k * this->Depth);
          const double c = std::cos(phase[i]);
          const double s = std::sin(phase[i]);
          eta[i] = t.Amplitude * c;
          u[i] = k * std::cos(t.Direction) * p * c;
          v[i] = k * std::sin(t.Direction) * p * c;
          w[i] = k * tanh * p * s;
          ut[i] = t.AngularFrequency * k * std::cos(t.Direction) * p * s;
          vt[i] = t.AngularFrequency * k * std::sin(t.Direction) * p * s;
          wt[i] = -t.AngularFrequency * k * tanh * p * c;
          rest[i] = (-t.AngularFrequency * t.AngularFrequency * k * tanh + g * k * k) * p * s;
        }
        double f = 0.0;
        double q = 0.0;
        for (int i = 0; i < 2; ++i)
        {
          const int j = isSelf ? i : 1 - i; // products of both trains; of one train with itself, which counts twice
          f -= 2.0 * (u[i] * ut[j] + v[i] * vt[j] + w[i] * wt[j]) + eta[i] * rest[j];
          q += 0.5 * (u[i] * u[j] + v[i] * v[j] + w[i] * w[j]) + eta[i] * wt[j];
        }
        if (isSelf && m != n)
        {
          continue;
        }
        for (int s = 0; s < 2; ++s)
        {
          const double angle = phase[0] + (s == 0 ? 1.0 : -1.0) * phase[1];
          const double share = (isSelf ? 0.5 * Steps : 1.0) / (Steps * Steps);
          forcing[s] += share * f * std::polar(1.0, -angle);
          pressure[s] += share * q * std::polar(1.0, -angle);
        }
      }
    }
    for (int s = 0; s < 2; ++s)
    {
      const double sign = s == 0 ? 1.0 : -1.0;
      Wave wave;
      wave.X = a.WaveNumber * std::cos(a.Direction) + sign * b.WaveNumber * std::cos(b.Direction);
      wave.Y = a.WaveNumber * std::sin(a.Direction) + sign * b.WaveNumber * std::sin(b.Direction);
      wave.Frequency = a.AngularFrequency + sign * b.AngularFrequency;
      wave.Phase = a.Phase + Pi + sign * (b.Phase + Pi);
      // (g K tanh Kh - W2) P sin = f, eta = -(phi_t + q) / g
      const bool isLevel = isSelf && s == 1;
      const double own = wave.K() > 0.0 ? g * wave.K() * std::tanh(wave.K() * this->Depth) : 0.0;
      const double twice = isLevel ? 1.0 : 2.0;
      wave.Potential = isLevel ? 0.0 : -2.0 * forcing[s].imag() / (own - wave.Frequency * wave.Frequency);
      wave.Elevation = (wave.Frequency * wave.Potential - twice * pressure[s].real()) / g;
      this->Second.push_back(wave);
    }
  }

  std::vector<WaveTrain> Trains;
  double Depth;
  std::vector<Wave> Second;
};

SeaState SeaOf(std::vector<WaveTrain> trains, double depth)
{
  SeaState sea;
  sea.Trains = std::move(trains);
  sea.Depth = depth;
  sea.Order = SeaOrder::Second;
  return sea;
}

/// Trains of various directions, with amplitudes scaled.
std::vector<WaveTrain> Some(double scale, double depth)
{
  return { Train(0.5 * scale, 0.11, depth, 0.3, 0.4), Train(0.4 * scale, 0.17, depth, -0.4, 1.9),
    Train(0.3 * scale, 0.26, depth, 0.9, 4.0), Train(0.35 * scale, 0.12, depth, 0.1, 2.2) };
}

struct Moved
{
  Vector3 Displacement;
  Vector3 Velocity;
  Vector3 Acceleration;
  double Gradient[5];
};

Moved Move(const SeaState& sea, Vector3 center, double time, BoundMotion bound, double choppiness = 1.0)
{
  Moved moved;
  OrbitRequest<double> request;
  request.Centers = &center[0];
  request.Displacement = &moved.Displacement[0];
  request.Velocity = &moved.Velocity[0];
  request.Acceleration = &moved.Acceleration[0];
  request.Gradient = moved.Gradient;
  WaveOrbitOptions options;
  options.Bound.Motion = bound;
  options.Bound.SkewnessLeftOut = 0.0;
  options.Choppiness = choppiness;
  WaveOrbits(sea, options, time).Evaluate(request, 0, 1);
  return moved;
}

}

TEST(SecondOrder, OneTrainIsStokesWave)
{
  const double known[3][3] = { { 0.5, 7.05886, -0.42546 }, { 1.0, 1.36956, -0.13786 }, { 2.0, 0.57780, -0.01832 } };
  for (const auto& row : known)
  {
    const double k = 0.07;
    const double h = row[0] / k;
    const WaveTrain train = Train(1.0, k, h);
    EXPECT_NEAR(PairKernelOf(train, train, h, 1.0).Elevation / k, row[1], 2e-5);
    EXPECT_NEAR(PairKernelOf(train, train, h, -1.0).Elevation / k, row[2], 2e-5);
  }
  const WaveTrain deep = Train(1.0, 0.2, Infinity);
  EXPECT_NEAR(PairKernelOf(deep, deep, Infinity, 1.0).Elevation, 0.1, 1e-12);
  EXPECT_NEAR(PairKernelOf(deep, deep, Infinity, -1.0).Elevation, 0.0, 1e-15);
}

TEST(SecondOrder, PairsObeyTheSurfaceConditions)
{
  for (const double h : { 3.0, 8.0, 25.0, 400.0, Infinity })
  {
    for (const double angle : { 0.0, 0.4, 1.5, 2.8 })
    {
      const WaveTrain a = Train(1.0, 0.2, h, 0.3);
      const WaveTrain b = Train(1.0, 0.31, h, 0.3 + angle);
      const Eulerian truth({ a, b }, h);
      const auto sum = PairKernelOf(a, b, h, 1.0);
      const auto difference = PairKernelOf(a, b, h, -1.0);
      // Waves 2 and 3 of three pairs are the sum and the difference of both
      const double scale = std::abs(truth.Waves()[2].Elevation) + std::abs(truth.Waves()[3].Elevation);
      EXPECT_NEAR(2.0 * sum.Elevation, truth.Waves()[2].Elevation, 1e-10 * scale) << h << " " << angle;
      EXPECT_NEAR(2.0 * difference.Elevation, truth.Waves()[3].Elevation, 1e-10 * scale) << h << " " << angle;
    }
  }
}

TEST(SecondOrder, DeepDifferencesLackTheLesserWaveNumber)
{
  const SeaState sea = SeaOf({ Train(0.3, 0.1, Infinity), Train(0.2, 0.25, Infinity) }, Infinity);
  for (const BoundWave& wave : BoundWavesOf(sea, { BoundMotion::Surface, 0.0 }, 1.0))
  {
    if (wave.Sign < 0.0)
    {
      EXPECT_NEAR(wave.Up, 0.3 * 0.2 * 0.1, 1e-15);
    }
    else if (wave.Sign > 0.0)
    {
      EXPECT_NEAR(wave.Up, 0.0, 1e-15);
    }
  }
}

// Particles of the surface lie on the surface at fixed places, and all others go with the flow there: to third order,
// so that half the amplitude leaves an eighth.
TEST(SecondOrder, ParticlesAreThoseOfTheFlow)
{
  for (const double h : { 7.0, 18.0, Infinity })
  {
    for (const double choppiness : { 1.0, 0.6 })
    {
      double surface[2] = {}, particle[2] = {}, flow[2] = {};
      for (int half = 0; half < 2; ++half)
      {
        const double scale = half == 0 ? 0.1 : 0.05;
        const SeaState sea = SeaOf(Some(scale, h), h);
        const Eulerian truth(sea.Trains, h);
        for (int n = 0; n < 20; ++n)
        {
          const double time = 3.1 * n;
          const Vector3 top(7.0 * n, 3.0 * n, 0.0);
          for (const BoundMotion bound : { BoundMotion::Surface, BoundMotion::Particles })
          {
            const Vector3 moved = top + Move(sea, top, time, bound, choppiness).Displacement;
            surface[half] = std::max(surface[half], std::abs(moved.z - truth.Elevation(moved.x, moved.y, time)));
          }
          const Vector3 center(7.0 * n, 3.0 * n, -0.3 * n);
          const Moved moved = Move(sea, center, time, BoundMotion::Particles);
          const Vector3 real = truth.Velocity(center + moved.Displacement, time);
          particle[half] = std::max(particle[half], std::abs(moved.Velocity.z - real.z));
          const Vector3 passing = Move(sea, center, time, BoundMotion::Places).Velocity;
          flow[half] = std::max(flow[half], glm::length(passing - truth.Velocity(center, time)));
        }
      }
      EXPECT_NEAR(surface[0] / surface[1], 8.0, 0.8) << h;
      EXPECT_NEAR(particle[0] / particle[1], 8.0, 1.0) << h;
      EXPECT_LT(flow[0], 1e-10) << h;
    }
  }
}

// Orbits of one train are known (Longuet-Higgins 1953): twice the frequency along, k (A2 - B2) / 4 less the flow's.
TEST(SecondOrder, OneTrainHasKnownOrbits)
{
  const double h = 6.0;
  const double k = 0.15;
  const WaveTrain train = Train(0.1, k, h, 0.0, 0.0);
  SeaState sea = SeaOf({ train }, h);
  const double z = -2.0;
  for (const double time : { 0.0, 0.7, 2.3 })
  {
    const Moved second = Move(sea, { 3.0, 0.0, z }, time, BoundMotion::Particles);
    sea.Order = SeaOrder::First;
    const Moved first = Move(sea, { 3.0, 0.0, z }, time, BoundMotion::Particles);
    sea.Order = SeaOrder::Second;
    const double a = train.Amplitude;
    const double twice = 2.0 * (3.0 * k - train.AngularFrequency * time);
    const double s = std::sinh(k * h);
    const double s4 = s * s * s * s;
    const double x = -(3.0 / 8.0 * std::cosh(2.0 * k * (z + h)) / s4 - 0.25 / (s * s)) * a * a * k * std::sin(twice);
    const double up = 3.0 / 16.0 * 2.0 * std::sinh(2.0 * k * (z + h)) / s4 * a * a * k * std::cos(twice);
    const double orbit = a * a * k * std::sinh(2.0 * k * (z + h)) / (4.0 * s * s);
    const double down = -a * a * k / (2.0 * std::sinh(2.0 * k * h)) * (z + h) / h;
    EXPECT_NEAR(second.Displacement.x - first.Displacement.x, x, 1e-8);
    EXPECT_NEAR(second.Displacement.z - first.Displacement.z, up + orbit + down, 1e-8);
  }
}

// A long group of waves has a set-down of -S / (rho (g h - cg2)), S the radiation stress (Longuet-Higgins and Stewart).
TEST(SecondOrder, GroupsHaveTheSetDownOfTheirRadiationStress)
{
  for (const double h : { 4.0, 10.0, 20.0 })
  {
    const double k = 0.15;
    const double step = 1e-4 * k;
    const WaveTrain a = Train(1.0, k + step, h);
    const WaveTrain b = Train(1.0, k - step, h);
    const double group = (a.AngularFrequency - b.AngularFrequency) / (2.0 * step);
    const double n = group * k / WaveFrequency(k, h);
    // S / rho = g A2 / 2 (2 n - 1/2), A2 = 2 + 2 cos of the difference
    const double expected = -Gravity * (2.0 * n - 0.5) / (Gravity * h - group * group);
    EXPECT_NEAR(2.0 * PairKernelOf(a, b, h, -1.0).Elevation, expected, 1e-3 * std::abs(expected)) << h;
  }
}

// Motions are derivatives of each other, and points in single precision those in double.
TEST(SecondOrder, MotionsBelongTogether)
{
  for (const double h : { 5.0, 60.0, Infinity })
  {
    const SeaState sea = SeaOf(Some(1.0, h), h);
    for (const BoundMotion bound : { BoundMotion::Particles, BoundMotion::Places, BoundMotion::Surface })
    {
      const Vector3 center(31.0, -8.0, bound == BoundMotion::Surface ? 0.0 : -1.5);
      const double e = 1e-4;
      const Moved now = Move(sea, center, 4.0, bound);
      const auto at = [&](Vector3 off, double later) { return Move(sea, center + off, 4.0 + later, bound); };
      const Vector3 velocity = (at({}, e).Displacement - at({}, -e).Displacement) / (2.0 * e);
      const Vector3 acceleration = (at({}, e).Velocity - at({}, -e).Velocity) / (2.0 * e);
      const Vector3 alongX = (at({ e, 0, 0 }, 0).Displacement - at({ -e, 0, 0 }, 0).Displacement) / (2.0 * e);
      const Vector3 alongY = (at({ 0, e, 0 }, 0).Displacement - at({ 0, -e, 0 }, 0).Displacement) / (2.0 * e);
      EXPECT_LT(glm::length(now.Velocity - velocity), 1e-6);
      EXPECT_LT(glm::length(now.Acceleration - acceleration), 1e-6);
      const double gradient[5] = { alongX.x, 0.5 * (alongX.y + alongY.x), alongY.y, alongX.z, alongY.z };
      for (int n = 0; n < 5; ++n)
      {
        EXPECT_NEAR(now.Gradient[n], gradient[n], 1e-7) << n;
      }
      std::vector<float> centers;
      for (int n = 0; n < 300; ++n)
      {
        centers.insert(centers.end(), { 31.0F, -8.0F, static_cast<float>(center.z) });
      }
      std::vector<float> places(900), velocities(900), gradients(1500);
      OrbitRequest<float> request;
      request.Centers = centers.data();
      request.Displacement = places.data();
      request.Velocity = velocities.data();
      request.Gradient = gradients.data();
      WaveOrbitOptions options;
      options.Bound.Motion = bound;
      options.Bound.SkewnessLeftOut = 0.0;
      WaveOrbits(sea, options, 4.0).Evaluate(request, 0, 300);
      for (int n = 0; n < 900; ++n)
      {
        EXPECT_NEAR(places[n], now.Displacement[n % 3], 1e-5);
        EXPECT_NEAR(velocities[n], now.Velocity[n % 3], 1e-5);
      }
      for (int n = 0; n < 1500; ++n)
      {
        EXPECT_NEAR(gradients[n], now.Gradient[n % 5], 1e-5);
      }
    }
  }
}

namespace
{

/// Mean and skewness of the elevation at fixed places, in deviations, by the surface of trains along a line: a piece
/// between two places has the length of its points at rest and their stretch.
std::array<double, 2> MomentsOf(const SeaState& sea, int count, double step)
{
  std::vector<float> centers, places(3 * count), gradients(5 * count);
  for (int n = 0; n < count; ++n)
  {
    centers.insert(centers.end(), { static_cast<float>(step * n), 0.0F, 0.0F });
  }
  OrbitRequest<float> request;
  request.Centers = centers.data();
  request.Displacement = places.data();
  request.Gradient = gradients.data();
  WaveOrbitOptions options;
  options.Bound.Motion = BoundMotion::Surface;
  WaveOrbits(sea, options, 0.0).Evaluate(request, 0, count);
  double weight = 0.0;
  double sums[4] = {};
  for (int n = 0; n < count; ++n)
  {
    const double stretch = 1.0 + gradients[5 * n];
    const double z = places[3 * n + 2];
    weight += stretch;
    sums[1] += stretch * z;
    sums[2] += stretch * z * z;
    sums[3] += stretch * z * z * z;
  }
  const double mean = sums[1] / weight;
  const double variance = sums[2] / weight - mean * mean;
  const double third = sums[3] / weight - 3.0 * mean * sums[2] / weight + 2.0 * mean * mean * mean;
  return { mean / std::sqrt(variance), third / std::pow(variance, 1.5) };
}

SeaState LongCrested(double wind, int seed, SeaOrder order)
{
  SpectrumParameters spectrum;
  spectrum.WindSpeed = wind;
  TrainParameters cut;
  cut.Count = 150;
  cut.Spreading = 0.0;
  cut.Seed = seed;
  SeaState sea = SeaOf(TrainsOf(SeaSpectrum(spectrum), Infinity, cut), Infinity);
  std::sort(sea.Trains.begin(), sea.Trains.end(),
    [](const WaveTrain& a, const WaveTrain& b) { return a.WaveNumber < b.WaveNumber; });
  sea.Order = order;
  return sea;
}

/// 3 sum v_i v_j min(k_i, k_j) / m0^1.5, v = a2 / 2; of trains with given amplitudes those of i = j count by half.
double DeepSkewness(const std::vector<WaveTrain>& trains, double own)
{
  double sum = 0.0;
  double variance = 0.0;
  for (const WaveTrain& a : trains)
  {
    variance += 0.5 * a.Amplitude * a.Amplitude;
    for (const WaveTrain& b : trains)
    {
      sum +=
        (&a == &b ? own : 1.0) * 0.25 * std::pow(a.Amplitude * b.Amplitude, 2.0) * std::min(a.WaveNumber, b.WaveNumber);
    }
  }
  return 3.0 * sum / std::pow(variance, 1.5);
}

/// -1/2 sum a2 k / m0^0.5, the mean level at fixed places of orbits alone.
double LevelOfOrbits(const std::vector<WaveTrain>& trains)
{
  double sum = 0.0;
  for (const WaveTrain& train : trains)
  {
    sum -= 0.5 * train.Amplitude * train.Amplitude * train.WaveNumber;
  }
  return sum / std::sqrt(EnergyOf(trains));
}

}

TEST(SecondOrder, LongCrestedSeasHaveTheSkewnessOfNature)
{
  constexpr int Seeds = 40;
  for (const double wind : { 5.0, 10.0, 15.0 })
  {
    double mean[2] = {}, skew[2] = {};
    double firstMean = 0.0, firstSkew = 0.0, due = 0.0;
    for (int seed = 1; seed <= Seeds; ++seed)
    {
      const SeaState sea = LongCrested(wind, seed + static_cast<int>(100.0 * wind), SeaOrder::Second);
      ASSERT_TRUE(IsSortedLongCrestedDeep(sea));
      const double step = 0.31 * wind * wind;
      const auto moments = MomentsOf(sea, 6000, step);
      mean[0] += moments[0] / Seeds;
      mean[1] += moments[0] * moments[0] / Seeds;
      const double known = DeepSkewness(sea.Trains, 0.5);
      due += DeepSkewness(sea.Trains, 1.0) / Seeds;
      skew[0] += (moments[1] - known) / Seeds;
      skew[1] += std::pow(moments[1] - known, 2.0) / Seeds;
      if (seed <= 10)
      {
        const auto first =
          MomentsOf(LongCrested(wind, seed + static_cast<int>(100.0 * wind), SeaOrder::First), 6000, step);
        firstMean += (first[0] - LevelOfOrbits(sea.Trains)) / 10.0;
        firstSkew += first[1] / 10.0;
        EXPECT_NEAR(SkewnessOf(sea), known, 1e-9);
      }
    }
    const double meanError = std::sqrt((mean[1] - mean[0] * mean[0]) / (Seeds - 1.0));
    const double skewError = std::sqrt((skew[1] - skew[0] * skew[0]) / (Seeds - 1.0));
    EXPECT_NEAR(mean[0], 0.0, 3.0 * meanError);
    EXPECT_NEAR(skew[0], 0.0, 3.0 * skewError);
    EXPECT_NEAR(firstSkew, 0.0, 6.0 * skewError);
    EXPECT_NEAR(firstMean, 0.0, 0.002);
    EXPECT_NEAR(due, 0.139, 0.004);
    EXPECT_LT(skewError, 0.01);
  }
}

// Sums of trains are those of pairs.
TEST(SecondOrder, SumsAreThoseOfPairs)
{
  SeaState sea = LongCrested(9.0, 3, SeaOrder::Second);
  sea.Trains.resize(40);
  SeaState other = sea;
  other.Trains.back().Direction = 1e-12; // pairs
  ASSERT_FALSE(IsSortedLongCrestedDeep(other));
  for (const double x : { 0.0, 37.0, 911.0 })
  {
    const Moved bySums = Move(sea, { x, 5.0, 0.0 }, 12.0, BoundMotion::Surface);
    const Moved byPairs = Move(other, { x, 5.0, 0.0 }, 12.0, BoundMotion::Surface);
    EXPECT_NEAR(bySums.Displacement.z, byPairs.Displacement.z, 1e-9);
    EXPECT_NEAR(bySums.Gradient[3], byPairs.Gradient[3], 1e-9);
  }
}

// Points with fewer trains move as in a sea that has no more; parts of a request are those of the whole, to the byte.
TEST(SecondOrder, PointsMoveByTheirOwnTrains)
{
  for (const bool bySums : { false, true })
  {
    SeaState sea = bySums ? LongCrested(8.0, 2, SeaOrder::Second) : SeaOf(Some(1.0, 9.0), 9.0);
    sea.Trains.resize(4);
    WaveOrbitOptions options;
    options.Bound.Motion = bySums ? BoundMotion::Surface : BoundMotion::Particles;
    options.Bound.SkewnessLeftOut = 0.0;
    constexpr int Count = 600;
    std::vector<float> centers, places(3 * Count), parts(3 * Count), gradients(5 * Count);
    std::vector<int> counts;
    for (int n = 0; n < Count; ++n)
    {
      centers.insert(centers.end(), { 0.7F * static_cast<float>(n), 3.0F, bySums ? 0.0F : -1.0F });
      counts.push_back(n % 5);
    }
    OrbitRequest<float> request;
    request.Centers = centers.data();
    request.Displacement = places.data();
    request.Gradient = gradients.data();
    request.TrainCounts = counts.data();
    WaveOrbits(sea, options, 2.0).Evaluate(request, 0, Count);
    request.Displacement = parts.data();
    request.Gradient = nullptr;
    WaveOrbits(sea, options, 2.0).Evaluate(request, 100, Count);
    WaveOrbits(sea, options, 2.0).Evaluate(request, 0, 100);
    EXPECT_EQ(places, parts);
    for (int count = 0; count <= 4; ++count)
    {
      SeaState less = sea;
      less.Trains.resize(count);
      request.TrainCounts = nullptr;
      WaveOrbits(less, options, 2.0).Evaluate(request, 0, Count);
      for (int n = count; n < Count; n += 5)
      {
        EXPECT_NEAR(parts[3 * n + 2], places[3 * n + 2], 1e-6);
        EXPECT_NEAR(parts[3 * n], places[3 * n], 1e-6);
      }
      // Shares of 1 and 0 do the same
      request.TrainCounts = nullptr;
      std::vector<float> shares(4, 0.0F);
      std::fill_n(shares.begin(), count, 1.0F);
      request.Shares = shares.data();
      WaveOrbits(sea, options, 2.0).Evaluate(request, 0, Count);
      request.Shares = nullptr;
      for (int n = count; n < Count; n += 5)
      {
        EXPECT_NEAR(parts[3 * n + 2], places[3 * n + 2], 1e-6);
      }
    }
  }
}

// Left out are the pairs that matter least.
TEST(SecondOrder, PairsAreLeftOutByTheirSkewness)
{
  SpectrumParameters spectrum;
  TrainParameters cut;
  const SeaState sea = SeaOf(TrainsOf(SeaSpectrum(spectrum), Infinity, cut), Infinity);
  const auto all = BoundWavesOf(sea, { BoundMotion::Surface, 0.0 }, 1.0);
  const auto some = BoundWavesOf(sea, { BoundMotion::Surface, 0.001 }, 1.0);
  double full = 0.0;
  double left = 0.0;
  const auto part = [&](const BoundWave& wave) {
    return wave.Sign == 0.0 ? 0.0
                            : 1.5 * wave.Up * sea.Trains[wave.First].Amplitude * sea.Trains[wave.Second].Amplitude /
        std::pow(EnergyOf(sea.Trains), 1.5);
  };
  for (const BoundWave& wave : all)
  {
    full += part(wave);
  }
  for (const BoundWave& wave : some)
  {
    left += part(wave);
  }
  EXPECT_LT(10 * some.size(), 9 * all.size());
  EXPECT_NEAR(left, full, 0.001);
  EXPECT_NEAR(full, SkewnessOf(sea), 0.2 * full);
}

TEST(SecondOrder, ManyTrainsAreRefused)
{
  SeaState sea = SeaOf(std::vector<WaveTrain>(201, Train(0.01, 0.1, Infinity)), Infinity);
  EXPECT_NE(WhyInvalid(sea).find("at most 200"), std::string::npos);
  sea.Trains.resize(200);
  EXPECT_EQ(WhyInvalid(sea), "");
}
