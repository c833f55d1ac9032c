// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sea/Dispersion.h"

#include "Numerics/Constants.h"

#include <cmath>

namespace littoral
{

namespace
{

/// Above this k h, the hyperbolic tangent is 1 in double precision.
constexpr double DeepRelativeDepth = 20.0;

/// x = k h from y = w^2 h / g, x tanh x = y: Beji's (2013) improvement of Eckart's formula, good to 4.4e-4, then two
/// steps of Newton.
double RelativeDepth(double y)
{
  double x = y / std::sqrt(std::tanh(y));
  x *= 1.0 + std::pow(y, 1.09) * std::exp(-(1.55 + 1.30 * y + 0.216 * y * y));
  for (int step = 0; step < 2; ++step)
  {
    // Newton's step on x tanh x - y
    const double t = std::tanh(x);
    x -= (x * t - y) / (t + x * (1.0 - t * t));
  }
  return x;
}

}

double WaveNumber(double frequency, double depth)
{
  if (!(frequency > 0.0))
  {
    return 0.0;
  }
  const double deep = frequency * frequency / Gravity;
  const double y = deep * depth;
  if (!(y < DeepRelativeDepth))
  {
    return deep;
  }
  // So shallow that y is no normal number: waves of all lengths run at sqrt(g h).
  return y < 1e-300 ? frequency / std::sqrt(Gravity * depth) : RelativeDepth(y) / depth;
}

double WaveFrequency(double waveNumber, double depth)
{
  // w^2 = g k tanh kh
  return waveNumber > 0.0 ? std::sqrt(Gravity * waveNumber * std::tanh(waveNumber * depth)) : 0.0;
}

DepthRegime RegimeOf(double waveNumber, double depth)
{
  const double wavelengths = waveNumber * depth / TwoPi;
  return wavelengths > 0.5 ? DepthRegime::Deep : wavelengths < 0.05 ? DepthRegime::Shallow : DepthRegime::Intermediate;
}

const char* RegimeName(DepthRegime regime)
{
  return regime == DepthRegime::Deep ? "deep" : regime == DepthRegime::Shallow ? "shallow" : "intermediate";
}

}
