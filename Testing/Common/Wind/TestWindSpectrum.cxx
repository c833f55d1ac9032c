// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Spectra and coherences of the wind: closed forms, limits, bad parameters.
#include "Wind/WindSpectrum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

using namespace littoral;

namespace
{

double Integral(int component)
{
  // Substitution f = exp(x): the integrand falls off exponentially at both ends.
  const WindModel model;
  double sum = 0.0;
  const double step = 0.01;
  for (double x = -40.0; x < 60.0; x += step)
  {
    sum += step * std::exp(x) * SpectralDensity(model, component, std::exp(x), 20.0);
  }
  return sum / std::pow(FrictionVelocity(model), 2.0);
}

}

TEST(WindSpectrum, VariancesAreTheClosedForms)
{
  const double pi = std::acos(-1.0);
  const double wants[] = { 200.0 / 50.0 * 1.5, 15.0 / 9.5 * 1.5,
    3.36 * std::pow(10.0, -0.6) * 0.6 * pi / std::sin(0.6 * pi) };
  for (int component = 0; component < WindComponents; ++component)
  {
    const double has = Integral(component);
    std::cout << "variance / u*^2 of component " << component << ": " << has << ", closed form " << wants[component]
              << "\n";
    EXPECT_NEAR(has, wants[component], 1e-5);
  }
}

class AllSpectra : public testing::TestWithParam<int>
{
protected:
  AllSpectra() { this->Model.Spectrum = static_cast<WindSpectrumModel>(GetParam()); }
  WindModel Model;
};

class AllCoherences : public testing::TestWithParam<int>
{
protected:
  AllCoherences() { this->Model.Coherence = static_cast<WindCoherenceModel>(GetParam()); }
  WindModel Model;
};

TEST_P(AllSpectra, IntegrateToTheirVarianceAtAllHeights)
{
  for (int component = 0; component < WindComponents; ++component)
  {
    for (const double height : { 1.0, 20.0, 150.0 })
    {
      double sum = 0.0;
      for (double x = -40.0; x < 60.0; x += 0.01)
      {
        sum += 0.01 * std::exp(x) * SpectralDensity(this->Model, component, std::exp(x), height);
      }
      EXPECT_NEAR(sum / Variance(this->Model, component), 1.0, 1e-5) << component << " at " << height;
    }
  }
}

TEST_P(AllSpectra, AreFiniteAndPositiveAndEndAsThePowerOfTheInertialRange)
{
  for (int component = 0; component < WindComponents; ++component)
  {
    for (double f = 0.0; f<1e6; f = f> 0.0 ? 1.7 * f : 1e-9)
    {
      const double density = SpectralDensity(this->Model, component, f, 20.0);
      EXPECT_TRUE(std::isfinite(density) && density > 0.0) << f;
    }
    const double slope = std::log10(
      SpectralDensity(this->Model, component, 1e5, 20.0) / SpectralDensity(this->Model, component, 1e4, 20.0));
    EXPECT_NEAR(slope, -5.0 / 3.0, 1e-3);
  }
}

TEST_P(AllSpectra, EachParameterThatCountsIsChecked)
{
  EXPECT_EQ(WhyInvalid(this->Model), "");
  for (const auto* parameter : TraitsOf(this->Model.Spectrum).Parameters)
  {
    WindModel broken = this->Model;
    parameter->Set(broken, -1.0);
    EXPECT_EQ(WhyInvalid(broken).find(parameter->Name), 0u);
    WindModel other = this->Model;
    parameter->Set(other, 1.1 * parameter->Get(other));
    EXPECT_NE(SpectralDensity(other, 0, 0.1, 20.0), SpectralDensity(this->Model, 0, 0.1, 20.0)) << parameter->Name;
  }
}

TEST_P(AllCoherences, FallFromOneWithDistanceAndFrequency)
{
  for (int component = 0; component < WindComponents; ++component)
  {
    EXPECT_EQ(RootCoherence(this->Model, component, 0.3, 0.0, 0.0), 1.0);
    double before = 1.0;
    for (double distance = 0.5; distance < 40.0; distance *= 1.5)
    {
      const double near = RootCoherence(this->Model, component, 0.3, distance, 0.0);
      EXPECT_LT(near, before);
      EXPECT_GT(near, 0.0);
      EXPECT_LT(RootCoherence(this->Model, component, 0.6, distance, 0.0), near);
      EXPECT_LT(RootCoherence(this->Model, component, 0.3, distance, distance), near);
      before = near;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Wind, AllSpectra, testing::Range(0, NumberOfWindSpectra),
  [](const auto& one) { return TraitsOf(static_cast<WindSpectrumModel>(one.param)).Name; });

INSTANTIATE_TEST_SUITE_P(Wind, AllCoherences, testing::Range(0, NumberOfWindCoherences),
  [](const auto& one) { return TraitsOf(static_cast<WindCoherenceModel>(one.param)).Name; });

TEST(WindSpectrum, NothingBeyondTheRowsIsAFamily)
{
  WindModel model;
  model.Spectrum = static_cast<WindSpectrumModel>(NumberOfWindSpectra);
  EXPECT_EQ(WhyInvalid(model).find("Spectrum"), 0u);
  model = {};
  model.Coherence = static_cast<WindCoherenceModel>(NumberOfWindCoherences);
  EXPECT_EQ(WhyInvalid(model).find("Coherence"), 0u);
}

TEST(WindSpectrum, KaimalHasTheVarianceAskedFor)
{
  WindModel model;
  model.Spectrum = WindSpectrumModel::IECKaimal;
  double sum = 0.0;
  for (double x = -40.0; x < 60.0; x += 0.01)
  {
    sum += 0.01 * std::exp(x) * SpectralDensity(model, 0, std::exp(x), 20.0);
  }
  EXPECT_NEAR(std::sqrt(sum), model.TurbulenceIntensity * model.ReferenceSpeed, 1e-4);
}

TEST(WindSpectrum, IECCoherenceByHand)
{
  WindModel model;
  model.ReferenceSpeed = 12.0;
  model.Coherence = WindCoherenceModel::IEC;
  // IEC 61400-1 ed. 3, eq. B.16: hub at 90 m, Lambda_1 = 42 m and L_c = 340.2 m; at 40 m 28 m and 226.8 m.
  model.ReferenceHeight = 90.0;
  EXPECT_NEAR(RootCoherence(model, 0, 0.05, 12.0, 16.0), std::exp(-12.0 * std::hypot(1.0 / 12.0, 2.4 / 340.2)), 1e-12);
  EXPECT_NEAR(RootCoherence(model, 0, 0.0, 30.0, 0.0), std::exp(-12.0 * 3.6 / 340.2), 1e-12);
  model.ReferenceHeight = 40.0;
  EXPECT_NEAR(RootCoherence(model, 0, 0.2, 0.0, 10.0), std::exp(-12.0 * std::hypot(2.0 / 12.0, 1.2 / 226.8)), 1e-12);
  EXPECT_EQ(RootCoherence(model, 0, 1.0, 0.0, 0.0), 1.0);
  // The standard is silent about the others: their own decays, over the mean at 10 m.
  EXPECT_NEAR(RootCoherence(model, 2, 0.1, 3.0, 4.0), std::exp(-8.0 * 0.1 * 5.0 / MeanSpeed(model, 10.0)), 1e-12);
}

TEST(WindSpectrum, ComponentsDecayInTheirOwnWayAcrossAndUp)
{
  WindModel model; // 10 m/s at 10 m
  model.Decay = { { { 5.0, 10.0 }, { 6.0, 13.0 }, { 3.0, 7.0 } } };
  const double exponents[][2] = { { 0.4, 0.6 }, { 0.48, 0.78 }, { 0.24, 0.42 } }; // at 0.2 Hz, 4 m across and 3 m up
  for (int component = 0; component < WindComponents; ++component)
  {
    const double across = exponents[component][0];
    const double up = exponents[component][1];
    EXPECT_NEAR(RootCoherence(model, component, 0.2, 4.0, 0.0), std::exp(-across), 1e-12);
    EXPECT_NEAR(RootCoherence(model, component, 0.2, 0.0, 3.0), std::exp(-up), 1e-12);
    EXPECT_NEAR(RootCoherence(model, component, 0.2, 4.0, 3.0), std::exp(-std::sqrt(across * across + up * up)), 1e-12);
  }
}

TEST(WindSpectrum, MeanRisesByTheFrictionVelocityOverVonKarmansConstant)
{
  WindModel model;
  model.RoughnessLength = 0.2;
  model.ReferenceHeight = 30.0;
  EXPECT_NEAR(MeanSpeed(model, 30.0), model.ReferenceSpeed, 1e-12);
  EXPECT_NEAR(MeanSpeed(model, 0.2), 0.0, 1e-12);
  for (const double height : { 1.0, 8.0, 100.0 })
  {
    const double slope = MeanSpeed(model, std::exp(1.0) * height) - MeanSpeed(model, height); // over ln z
    EXPECT_NEAR(FrictionVelocity(model), 0.4 * slope, 1e-12);
  }
}

// IEC 61400-1 ed. 3, table B.1: deviations 1, 0.8 and 0.5 of that along the wind, lengths 8.1, 2.7 and 0.66 of
// Lambda_1, and the density 4 sigma^2 L / U at frequency 0.
TEST(WindSpectrum, KaimalHasTheDeviationsAndLengthsOfTheStandard)
{
  WindModel model;
  model.Spectrum = WindSpectrumModel::IECKaimal;
  model.ReferenceSpeed = 12.0;
  model.ReferenceHeight = 50.0; // Lambda_1 = 35 m
  model.TurbulenceIntensity = 0.1;
  const double deviations[] = { 1.2, 0.96, 0.6 };
  const double lengths[] = { 283.5, 94.5, 23.1 };
  for (int component = 0; component < WindComponents; ++component)
  {
    const double variance = deviations[component] * deviations[component];
    EXPECT_NEAR(Variance(model, component), variance, 1e-12);
    EXPECT_NEAR(SpectralDensity(model, component, 0.0, 20.0), 4.0 * variance * lengths[component] / 12.0, 1e-9);
  }
}
