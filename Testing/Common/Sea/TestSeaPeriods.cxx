// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sea/SeaPeriods.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace littoral;

namespace
{

SpectrumParameters Jonswap(double gamma)
{
  SpectrumParameters given;
  given.Kind = SpectrumKind::Jonswap;
  given.FromWind = false;
  given.SignificantHeight = 3.0;
  given.PeakPeriod = 8.0;
  given.PeakEnhancement = gamma;
  return given;
}

}

TEST(SeaPeriods, JonswapHasKnownRatios)
{
  const double known[4][4] = { { 1.0, 0.85722, 0.77177, 0.71037 }, { 2.0, 0.88354, 0.80630, 0.74644 },
    { 3.3, 0.90330, 0.83433, 0.77740 }, { 7.0, 0.93123, 0.87747, 0.82850 } };
  const double energies[4] = { 1.0, 1.24562, 1.52495, 2.22517 };
  for (int n = 0; n < 4; ++n)
  {
    const SeaSpectrum spectrum(Jonswap(known[n][0]));
    const SeaPeriods periods = PeriodsOf(spectrum);
    EXPECT_NEAR(periods.Height, 3.0, 3e-4);
    EXPECT_NEAR(periods.Peak, 8.0, 1e-6);
    EXPECT_NEAR(periods.Energy / 8.0, known[n][1], 2e-4);
    EXPECT_NEAR(periods.Mean / 8.0, known[n][2], 2e-4);
    EXPECT_NEAR(periods.ZeroCrossing / 8.0, known[n][3], 2e-4);
    // Far above the peak the form is scaled by 1 / m0
    const double w = 60.0 / 8.0;
    const double ratio = SeaSpectrum(Jonswap(1.0)).Density(w) / spectrum.Density(w);
    EXPECT_NEAR(ratio, energies[n], 1e-4 * energies[n]);
  }
}

TEST(SeaPeriods, PiersonMoskowitzHasClosedForms)
{
  SpectrumParameters given = Jonswap(1.0);
  given.Kind = SpectrumKind::PiersonMoskowitz;
  const SeaPeriods periods = PeriodsOf(SeaSpectrum(given));
  // m_n = A / 4 B^(n/4 - 1) Gamma(1 - n/4), B = 5/4 wp^4
  const double b = std::pow(1.25, 0.25);
  EXPECT_NEAR(periods.Energy / 8.0, std::tgamma(1.25) / b, 1e-5);
  EXPECT_NEAR(periods.Mean / 8.0, 1.0 / (b * std::tgamma(0.75)), 1e-5);
  EXPECT_NEAR(periods.ZeroCrossing / 8.0, 1.0 / (b * std::sqrt(std::tgamma(0.5))), 1e-5);
}

TEST(SeaPeriods, TrainsHaveTheirOwn)
{
  const double w = 2.0 * std::acos(-1.0);
  const SeaPeriods periods = PeriodsOf({ { 2.0, 0.1 * w, 1.0, 0.0, 0.0 }, { 1.0, 0.3 * w, 1.0, 0.0, 0.0 } });
  EXPECT_NEAR(periods.Height, 4.0 * std::sqrt(2.5), 1e-12);
  EXPECT_NEAR(periods.Peak, 10.0, 1e-12);
  EXPECT_NEAR(periods.Energy, (2.0 / 0.1 + 0.5 / 0.3) / 2.5, 1e-12);
  EXPECT_NEAR(periods.Mean, 2.5 / (0.2 + 0.15), 1e-12);
  EXPECT_NEAR(periods.ZeroCrossing, std::sqrt(2.5 / (0.02 + 0.045)), 1e-12);
}

TEST(SeaPeriods, TablesAreLinear)
{
  SpectrumParameters given;
  given.Kind = SpectrumKind::Table;
  given.Frequencies = { 0.1, 0.2, 0.4 };
  given.Densities = { 0.0, 1.0, 0.0 };
  const SeaPeriods periods = PeriodsOf(SeaSpectrum(given));
  // m0 = 0.15, m1 = integral of f S: 1/120 + 4/150
  EXPECT_NEAR(periods.Height, 4.0 * std::sqrt(0.15), 1e-6);
  EXPECT_NEAR(periods.Peak, 5.0, 1e-12);
  EXPECT_NEAR(periods.Mean, 0.15 / (1.0 / 120.0 + 4.0 / 150.0), 1e-5);
}
