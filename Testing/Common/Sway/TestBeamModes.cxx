// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/Constants.h"
#include "Sway/BeamModes.h"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/multiprecision/cpp_dec_float.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace littoral;

namespace
{

using Exact = boost::multiprecision::cpp_dec_float_50;

/// The root by bisection in 50 digits.
Exact ExactRoot(int mode)
{
  const auto value = [](const Exact& a) { return Exact(cos(a) * cosh(a) + 1); };
  Exact low = (mode - 1) * Exact(Pi);
  Exact high = mode * Exact(Pi);
  const bool rises = value(low) < 0;
  for (int step = 0; step < 150; ++step)
  {
    const Exact middle = (low + high) / 2;
    ((value(middle) < 0) == rises ? low : high) = middle;
  }
  return low;
}

/// Eq. 18 as printed (times -1 / its factor of the even part) in 50 digits.
Exact ExactShape(int mode, double part)
{
  const Exact a = ExactRoot(mode);
  const Exact b = a * part;
  const Exact sigma = (sinh(a) - sin(a)) / (cosh(a) + cos(a));
  return cosh(b) - cos(b) - sigma * (sinh(b) - sin(b));
}

template <typename Function>
double Integral(const Function& function)
{
  double sum = 0.0;
  for (int piece = 0; piece < 16; ++piece)
  {
    sum += boost::math::quadrature::gauss_kronrod<double, 31>::integrate(function, piece / 16.0, (piece + 1) / 16.0);
  }
  return sum;
}

/// Modal mass of a beam (eq. 23) by quadrature [kg].
double ModalMass(const RoundBeam& beam, int mode)
{
  return beam.MassPerLength * beam.Length * Integral([=](double s) { return ModeShape(mode, s) * ModeShape(mode, s); });
}

/// Deflection of the tip under a uniform load at rest that the modes from 1 to the last one make up, as a part of the
/// exact one, q L^4 / (8 E I).
double StaticTipShare(int lastMode)
{
  double share = 0.0;
  for (int mode = 1; mode <= lastMode; ++mode)
  {
    share += 8.0 * ModeShape(mode, 1.0) * MeanShape(mode) / std::pow(CantileverRoot(mode), 4);
  }
  return share;
}

}

TEST(BeamModes, RootsAreExact)
{
  double worst = 0.0;
  for (int mode = 1; mode <= MaximumModes; ++mode)
  {
    worst = std::max(worst, std::abs(CantileverRoot(mode) - static_cast<double>(ExactRoot(mode))));
  }
  std::printf("largest error of the roots 1 to %d: %.3g\n", MaximumModes, worst);
  EXPECT_LT(worst, 1e-10);
  EXPECT_NEAR(CantileverRoot(1), 1.8751040687, 5e-11);
  EXPECT_NEAR(CantileverRoot(5), 14.1371683910, 5e-11);
}

TEST(BeamModes, ShapesDoNotCancel)
{
  double worst = 0.0;
  for (int mode = 1; mode <= MaximumModes; ++mode)
  {
    for (int i = 0; i <= 100; ++i)
    {
      worst = std::max(worst, std::abs(ModeShape(mode, i / 100.0) - static_cast<double>(ExactShape(mode, i / 100.0))));
    }
    EXPECT_NEAR(ModeShape(mode, 1.0), mode % 2 == 1 ? 2.0 : -2.0, 1e-9);
    EXPECT_NEAR(ModeShape(mode, 0.0), 0.0, 1e-14);
    EXPECT_NEAR(ModeSlope(mode, 0.0), 0.0, 1e-12);
  }
  std::printf("largest error of the shapes: %.3g\n", worst);
  EXPECT_LT(worst, 1e-9);
  EXPECT_NEAR(ModeSlope(1, 1.0) / ModeShape(1, 1.0), 1.37651, 5e-6);
  EXPECT_NEAR(ModeSlope(2, 1.0) / ModeShape(2, 1.0), 4.78078, 5e-6);
}

TEST(BeamModes, SlopesAreDerivatives)
{
  for (int mode = 1; mode <= MaximumModes; ++mode)
  {
    const double rise = Integral([=](double s) { return ModeSlope(mode, s); });
    EXPECT_NEAR(rise, ModeShape(mode, 1.0), 1e-9);
  }
}

TEST(BeamModes, AreOrthogonal)
{
  double worst = 0.0;
  for (int m = 1; m <= MaximumModes; ++m)
  {
    for (int n = 1; n <= m; ++n)
    {
      const double product = Integral([=](double s) { return ModeShape(m, s) * ModeShape(n, s); });
      worst = std::max(worst, std::abs(product - (m == n ? 1.0 : 0.0)));
    }
    EXPECT_NEAR(Integral([=](double s) { return ModeShape(m, s); }), MeanShape(m), 1e-9);
  }
  std::printf("largest error of the mean products of modes up to %d: %.3g\n", MaximumModes, worst);
  EXPECT_LT(worst, 1e-9);
}

TEST(BeamModes, FrequenciesOfARoundBeam)
{
  const double radius = 0.05;
  const RoundBeam beam{ 3.0, radius, 1e10, 700.0 * Pi * radius * radius };
  const double expected[] = { 5.87516, 36.8190, 103.094 };
  for (int mode = 1; mode <= 3; ++mode)
  {
    const double hertz = AngularFrequency(beam, mode) / TwoPi;
    std::printf("mode %d: %.6g Hz\n", mode, hertz);
    EXPECT_NEAR(hertz / expected[mode - 1], 1.0, 2e-6);
  }
  EXPECT_DOUBLE_EQ(SecondMoment(2.0), 4.0 * Pi);
}

TEST(BeamModes, ModalMassIsThatOfTheBeam)
{
  const RoundBeam beam{ 3.0, 0.05, 1e10, 5.5 };
  for (int mode = 1; mode <= MaximumModes; ++mode)
  {
    EXPECT_NEAR(ModalMass(beam, mode) / (beam.MassPerLength * beam.Length), 1.0, 1e-9);
  }
}

TEST(BeamModes, StaticDeflectionOfTheTip)
{
  std::printf("tip under a uniform load at rest, of q L^4 / 8 E I: one mode %.8f, five modes %.8f, ten modes %.8f\n",
    StaticTipShare(1), StaticTipShare(5), StaticTipShare(10));
  EXPECT_NEAR(StaticTipShare(1), 1.013388, 5e-7);
  EXPECT_NEAR(StaticTipShare(5), 1.0000147, 5e-8);
  EXPECT_LT(std::abs(StaticTipShare(10) - 1.0), 1e-6);
}
