// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sea/Ripples.h"

#include "Numerics/Constants.h"
#include "Numerics/FourierGrid.h"
#include "Numerics/RandomStream.h"

#include <cmath>
#include <cstddef>

namespace littoral
{
namespace
{

/// Surface tension over density of water at 15 degrees [m3/s2].
constexpr double Tension = 7.35e-5;

/// Wave number of a sample of a transform, from -n/2 to n/2 - 1.
int Folded(int index, int samples)
{
  return index < samples / 2 ? index : index - samples;
}

}

//----------------------------------------------------------------------------
Ripples::Ripples(double side, int samples, int seed)
  : Samples(samples)
  , Waves(static_cast<std::size_t>(samples) * samples)
{
  const RandomStream random(seed, RandomPurpose::RippleWaves);
  double variance = 0.0;
  for (int row = 0; row < samples; ++row)
  {
    for (int column = 0; column < samples; ++column)
    {
      const double m = Folded(column, samples);
      const double n = Folded(row, samples);
      const double turns = std::hypot(m, n); // waves along the side
      if (turns < 2.0 || turns >= 0.5 * samples)
      {
        continue;
      }
      const std::size_t index = static_cast<std::size_t>(row) * samples + column;
      Wave& wave = this->Waves[index];
      // |A|2 k dk dtheta is the same for each dk / k:  A ~ 1 / k
      const auto normal = random.NormalPair(0, index);
      wave.Amplitude = std::complex<double>(normal[0], normal[1]) / turns;
      wave.Direction = { m / turns, n / turns };
      // omega2 = g k + (T / rho) k3
      const double k = TwoPi * turns / side;
      wave.Frequency = std::sqrt(Gravity * k + Tension * k * k * k);
      variance += 0.5 * std::norm(wave.Amplitude);
    }
  }
  for (Wave& wave : this->Waves)
  {
    wave.Amplitude /= std::sqrt(variance);
  }
}

//----------------------------------------------------------------------------
std::vector<SurfaceSlope> Ripples::SlopesAt(double time, const ParallelFor& parallel) const
{
  const int count = this->Samples;
  const std::complex<double> i(0.0, 1.0);
  // a_k = A exp(-i omega t)
  std::vector<std::complex<double>> turned(this->Waves.size());
  parallel(turned.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t index = begin; index < end; ++index)
    {
      const Wave& wave = this->Waves[index];
      turned[index] = wave.Amplitude * std::polar(1.0, -std::fmod(wave.Frequency * time, TwoPi));
    }
  });
  // s_x + i s_y from one transform: of real sums Re a_k exp(i k x), half of a_k and half of its conjugate at -k
  FourierGrid grid(count, count);
  parallel(static_cast<std::size_t>(count), [&](std::size_t begin, std::size_t end) {
    for (int row = static_cast<int>(begin); row < static_cast<int>(end); ++row)
    {
      for (int column = 0; column < count; ++column)
      {
        const std::size_t here = static_cast<std::size_t>(row) * count + column;
        const std::size_t there = static_cast<std::size_t>((count - row) % count) * count + (count - column) % count;
        const SurfaceSlope& d = this->Waves[here].Direction;
        // The direction at -k is the opposite one.
        grid.At(column, row) = 0.5 * (d.X + i * d.Y) * (turned[here] - std::conj(turned[there]));
      }
    }
  });
  grid.Backward(parallel);
  std::vector<SurfaceSlope> slopes(turned.size());
  for (int row = 0; row < count; ++row)
  {
    for (int column = 0; column < count; ++column)
    {
      const std::complex<double>& both = grid.At(column, row);
      slopes[static_cast<std::size_t>(row) * count + column] = { both.real(), both.imag() };
    }
  }
  return slopes;
}

//----------------------------------------------------------------------------
std::vector<double> GatheredLight(const std::vector<SurfaceSlope>& slopes, int samples, double side, double arm)
{
  const int places = samples / 2;
  const double toPlaces = places / side;
  std::vector<double> light(static_cast<std::size_t>(places) * places, 0.0);
  const auto wrapped = [places](double place) {
    return static_cast<std::size_t>(((static_cast<long long>(place) % places) + places) % places);
  };
  for (int row = 0; row < samples; ++row)
  {
    for (int column = 0; column < samples; ++column)
    {
      // x' = x + arm s: below a crest rays meet
      const SurfaceSlope& slope = slopes[static_cast<std::size_t>(row) * samples + column];
      const double x = 0.5 * column + toPlaces * arm * slope.X;
      const double y = 0.5 * row + toPlaces * arm * slope.Y;
      const double left = std::floor(x);
      const double low = std::floor(y);
      for (int corner = 0; corner < 4; ++corner)
      {
        const double dx = corner & 1;
        const double dy = corner >> 1;
        const double share = 0.25 * (1.0 - std::abs(x - left - dx)) * (1.0 - std::abs(y - low - dy));
        light[wrapped(low + dy) * places + wrapped(left + dx)] += share;
      }
    }
  }
  return light;
}

}
