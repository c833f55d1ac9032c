// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sway/BeamModes.h"

#include "Numerics/Constants.h"

#include <cmath>

namespace littoral
{

namespace
{

struct Mode
{
  double Root;  // a = wave number x length
  double Ratio; // sigma = (sinh a - sin a) / (cosh a + cos a)
  double Rest;  // 1 - sigma, which is tiny in the higher modes, without cancellation
};

/// Newton on cos(a) + 1 / cosh(a), whose terms stay of the same size; cos(a) cosh(a) + 1 does not.
double SolveRoot(double start)
{
  double a = start;
  for (int step = 0; step < 8; ++step)
  {
    const double sech = 1.0 / std::cosh(a);
    a += (std::cos(a) + sech) / (std::sin(a) + sech * std::tanh(a));
  }
  return a;
}

Mode MakeMode(int mode)
{
  // eq. 19, with a = eta L and D = -1 / sigma: sigma = (sinh a - sin a) / (cosh a + cos a), and 1 - sigma
  const double a = SolveRoot(mode == 1 ? 1.875 : (mode - 0.5) * Pi);
  const double below = std::cosh(a) + std::cos(a);
  return { a, (std::sinh(a) - std::sin(a)) / below, (std::exp(-a) + std::cos(a) + std::sin(a)) / below };
}

const Mode& ModeOf(int mode)
{
  static const std::array<Mode, MaximumModes> Modes = [] {
    std::array<Mode, MaximumModes> modes{};
    for (int n = 1; n <= MaximumModes; ++n)
    {
      modes[n - 1] = MakeMode(n);
    }
    return modes;
  }();
  return Modes[mode - 1];
}

ShapeMixture AllModes(double (*value)(int mode, double part), double part)
{
  ShapeMixture values;
  for (int mode = 1; mode <= MaximumModes; ++mode)
  {
    values[mode - 1] = value(mode, part);
  }
  return values;
}

}

double SecondMoment(double radius)
{
  return 0.25 * Pi * radius * radius * radius * radius;
}

double CantileverRoot(int mode)
{
  return ModeOf(mode).Root;
}

double ModeShape(int mode, double part)
{
  // cosh b - sigma sinh b = [(1 - sigma) e^b + (1 + sigma) e^-b] / 2
  const Mode& m = ModeOf(mode);
  const double b = m.Root * part;
  // eq. 18: cosh b - cos b - sigma (sinh b - sin b), b = a x/L
  const double hyperbolic = 0.5 * (m.Rest * std::exp(b) + (1.0 + m.Ratio) * std::exp(-b));
  return hyperbolic - std::cos(b) + m.Ratio * std::sin(b);
}

double ModeSlope(int mode, double part)
{
  const Mode& m = ModeOf(mode);
  const double b = m.Root * part;
  const double hyperbolic = 0.5 * (m.Rest * std::exp(b) - (1.0 + m.Ratio) * std::exp(-b));
  return m.Root * (hyperbolic + std::sin(b) + m.Ratio * std::cos(b));
}

double ModeCurvature(int mode, double part)
{
  const Mode& m = ModeOf(mode);
  const double b = m.Root * part;
  const double hyperbolic = 0.5 * (m.Rest * std::exp(b) + (1.0 + m.Ratio) * std::exp(-b));
  return m.Root * m.Root * (hyperbolic + std::cos(b) - m.Ratio * std::sin(b));
}

ShapeMixture ShapesAt(double part)
{
  return AllModes(ModeShape, part);
}

ShapeMixture SlopesAt(double part)
{
  return AllModes(ModeSlope, part);
}

ShapeMixture CurvaturesAt(double part)
{
  return AllModes(ModeCurvature, part);
}

double MeanShape(int mode)
{
  // Integral of the shape over 0 <= x/L <= 1: 2 sigma / a
  return 2.0 * ModeOf(mode).Ratio / ModeOf(mode).Root;
}

double AngularFrequency(const RoundBeam& beam, int mode)
{
  // eq. 20: w = eta^2 (E I / m)^(1/2)
  const double waveNumber = CantileverRoot(mode) / beam.Length;
  return waveNumber * waveNumber * std::sqrt(beam.YoungModulus * SecondMoment(beam.Radius) / beam.MassPerLength);
}

}
