// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Integrals and quantiles of functions whose integrals are known.
#include "Numerics/CompositeQuadrature.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace littoral;

TEST(CompositeQuadrature, IntegralsOfAPeakBetweenAnyPlaces)
{
  // A Lorentz peak needs many panels; its integral is an arc tangent.
  const double width = 1e-3;
  const auto peak = [=](double x) { return width / (width * width + (x - 0.7) * (x - 0.7)); };
  const auto below = [=](double x) { return std::atan((x - 0.7) / width) + std::atan(0.7 / width); };
  const CompositeQuadrature quadrature(peak, { 0.0, 0.5, 2.0 }, 1e-12);
  for (const double low : { 0.0, 0.1, 0.5, 0.6999, 0.7, 1.3 })
  {
    for (const double high : { 0.05, 0.5, 0.7, 0.7001, 0.75, 1.9, 2.0 })
    {
      const double wanted = high > low ? below(high) - below(low) : 0.0;
      EXPECT_NEAR(quadrature.Integral(peak, low, high), wanted, 1e-11) << low << " to " << high;
    }
  }
  EXPECT_NEAR(quadrature.Integral(peak, -5.0, 5.0), below(2.0), 1e-11); // nothing beyond the cuts
  EXPECT_EQ(CompositeQuadrature().Integral(peak, 0.0, 1.0), 0.0);
}

TEST(CompositeQuadrature, QuantilesOfPowersAreRoots)
{
  for (const double power : { 0.0, 1.0, 4.0 })
  {
    const auto function = [=](double x) { return std::pow(x, power); };
    const CompositeQuadrature quadrature(function, { 0.0, 0.25, 1.0, 3.0 }, 1e-12);
    for (const double part : { 0.0, 1e-6, 0.1, 0.25, 0.5, 0.9, 0.999, 1.0 })
    {
      EXPECT_NEAR(quadrature.Quantile(function, part), 3.0 * std::pow(part, 1.0 / (power + 1.0)), 1e-9)
        << "part " << part << " of x^" << power;
    }
  }
}
