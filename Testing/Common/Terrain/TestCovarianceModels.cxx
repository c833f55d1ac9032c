// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Terrain/CovarianceModels.h"

#include "Numerics/Constants.h"
#include "Terrain/ShortWaves.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/bessel.hpp>

#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

using namespace littoral;

namespace
{

CovarianceParameters Field(CovarianceModel model)
{
  CovarianceParameters field;
  field.Model = model;
  field.Variance = 2.5;
  field.Range = TraitsOf(model).LowestWaveNumber ? 50.0 : 3.0;
  field.SecondRange = 0.7;
  field.FractalDimension = 2.4;
  return field;
}

template <typename Function>
double Integrate(Function f, double from, double to)
{
  return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(f, from, to, 12, 1e-12);
}

class AllModels : public testing::TestWithParam<int>
{
protected:
  CovarianceParameters field = Field(static_cast<CovarianceModel>(GetParam()));
};

}

TEST_P(AllModels, SpectrumIntegratesToItsCumulativeForm)
{
  // Over octaves, so that each piece is smooth.
  double low = LowestWaveNumber(field);
  double sum = 0.0;
  for (double high = std::max(0.02, 2.0 * low); high < 3000.0; high *= 2.0)
  {
    sum += Integrate([&](double w) { return RadialSpectrum(field, w); }, low, high);
    EXPECT_NEAR(sum, CumulativeSpectrum(field, high), 1e-6) << "up to " << high;
    low = high;
  }
}

TEST_P(AllModels, SpectrumIntegratesToOne)
{
  EXPECT_EQ(CumulativeSpectrum(field, 0.0), 0.0);
  // The slowest tails fall as 1 / w (and w^-1.2 for this fractal, 1 / log for none).
  EXPECT_NEAR(CumulativeSpectrum(field, 1e9), 1.0, 1e-6);
}

// C(r) = s2 * integral of f(w) J0(w r). Integrating by parts, s2 * integral of F(w) r J1(w r), with 1 - F decaying,
// C(r) = s2 * (1 - ...) ; here the plain integral is taken between the zeros of J0 and its alternating sum averaged.
TEST_P(AllModels, HankelTransformOfTheSpectrumIsTheCovariance)
{
  for (double r : { 0.3, 1.0, 2.0, 4.0, 7.0 })
  {
    double low = LowestWaveNumber(field);
    double sum = 0.0;
    // Up to the first zero beyond the spectrum's start, over octaves to resolve its peak.
    int zero = 1;
    while (boost::math::cyl_bessel_j_zero(0.0, zero) / r <= low + 1e-12)
    {
      ++zero;
    }
    // Partial sums over zeros; repeated averaging removes the alternation (Euler).
    std::vector<double> partial;
    for (int k = 0; k < 900; ++k)
    {
      const double high = boost::math::cyl_bessel_j_zero(0.0, zero + k) / r;
      const auto integrand = [&](double w) { return RadialSpectrum(field, w) * boost::math::cyl_bessel_j(0, w * r); };
      const int pieces = k == 0 ? 64 : 1;
      for (int p = 0; p < pieces; ++p)
      {
        sum += Integrate(integrand, low + (high - low) * p / pieces, low + (high - low) * (p + 1) / pieces);
      }
      low = high;
      if (k >= 870)
      {
        partial.push_back(sum);
      }
    }
    while (partial.size() > 1)
    {
      for (std::size_t i = 0; i + 1 < partial.size(); ++i)
      {
        partial[i] = 0.5 * (partial[i] + partial[i + 1]);
      }
      partial.pop_back();
    }
    EXPECT_NEAR(field.Variance * partial[0], Covariance(field, r), 1e-6 * field.Variance) << "at " << r;
  }
}

TEST_P(AllModels, SemivarianceAndCovarianceAddUpToTheVariance)
{
  for (double r : { 0.0, 0.01, 0.5, 3.0, 20.0, 170.0, 180.0, 2000.0 })
  {
    EXPECT_NEAR(Semivariance(field, r) + Covariance(field, r), field.Variance, 1e-12) << "at " << r;
  }
  EXPECT_EQ(Semivariance(field, 0.0), 0.0);
}

// Differences of the covariance itself are the truth for the changes. Its own errors are largest where the fractal's
// two series meet, x = 22: that near cancels, and its noise grows as exp(x); that far ends after six terms.
TEST_P(AllModels, TableHoldsTheCorrelationAndItsChanges)
{
  std::vector<double> distances{ 0.0 };
  for (double r = 0.01; r < 600.0; r *= 1.13)
  {
    distances.push_back(r);
  }
  for (double second : { 0.7, 3.0, 11.0 })
  {
    field.SecondRange = second;
    const CorrelationTable table = TabulateCorrelation(field, distances);
    const auto changeOf = [&](double CovarianceParameters::*parameter, double step, double r) {
      CovarianceParameters more = field;
      CovarianceParameters less = field;
      more.*parameter += step;
      less.*parameter -= step;
      return (Semivariance(less, r) - Semivariance(more, r)) / (2.0 * step * field.Variance);
    };
    for (std::size_t n = 0; n < distances.size(); ++n)
    {
      const double r = distances[n];
      const double x = LowestWaveNumber(field) * r;
      const double noise = x < 22.0 ? 1e-18 * std::exp(x) : 2e-11 * std::pow(22.0 / x, 13);
      EXPECT_NEAR(table.Uncorrelation[n], Semivariance(field, r) / field.Variance, 2e-15 + noise) << r;
      const double h = 1e-5;
      const double close = 2e-8 + 0.2 * noise / h;
      const double byDistance =
        (Semivariance(field, r * (1.0 - h)) - Semivariance(field, r * (1.0 + h))) / (2.0 * h * field.Variance);
      EXPECT_NEAR(table.ByDistance[n], byDistance, close) << r << ", " << second;
      if (TraitsOf(field.Model).Parameters.Has("SecondRange"))
      {
        const double bySecond = second * changeOf(&CovarianceParameters::SecondRange, 1e-4 * second, r);
        EXPECT_NEAR(table.BySecondRange[n], bySecond, 2e-7) << r << ", " << second;
      }
      if (TraitsOf(field.Model).Parameters.Has("FractalDimension"))
      {
        const double byDimension = changeOf(&CovarianceParameters::FractalDimension, h, r);
        EXPECT_NEAR(table.ByDimension[n], byDimension, close) << r;
      }
    }
  }
}

TEST_P(AllModels, TailIsWhereItIsSaidToBe)
{
  for (double part : { 0.5, 0.01, 0.001 })
  {
    EXPECT_NEAR(1.0 - CumulativeSpectrum(field, WaveNumberAtTail(field, part)), part, 1e-6 * part + 1e-12);
  }
}

// The part of the variance in long waves, by parts in the code, as the integral that it is.
TEST_P(AllModels, LongWavesHoldTheIntegralOfTheirShare)
{
  const Crossover crossover = { 0.6, 1.7 };
  EXPECT_EQ(crossover.LongPart(0.6), 1.0);
  EXPECT_EQ(crossover.LongPart(1.7), 0.0);
  EXPECT_NEAR(crossover.LongPart(1.15), 0.5, 1e-12);
  double sum = CumulativeSpectrum(field, crossover.Low);
  double low = crossover.Low;
  for (double high : { 0.9, 1.3, 1.7, 2.5 })
  {
    sum += Integrate([&](double w) { return RadialSpectrum(field, w) * crossover.LongPart(w); }, low, high);
    EXPECT_NEAR(crossover.LongBelow(field, high), sum, 1e-7) << "up to " << high;
    low = high;
  }
}

TEST_P(AllModels, BadParametersAreNamed)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(WhyInvalid(field), "");
  for (double bad : { 0.0, -1.0, nan, std::numeric_limits<double>::infinity() })
  {
    CovarianceParameters broken = field;
    broken.Range = bad;
    EXPECT_NE(WhyInvalid(broken).find("Range"), std::string::npos);
  }
  CovarianceParameters broken = field;
  broken.Variance = nan;
  EXPECT_NE(WhyInvalid(broken), "");
  broken.Variance = -1.0;
  EXPECT_NE(WhyInvalid(broken), "");
}

// By Bochner's theorem this is what makes a function a covariance.
TEST_P(AllModels, SpectrumIsNowhereNegativeAndItsCumulativeFormRises)
{
  double before = 0.0;
  for (double w = 1e-4; w < 1e4; w *= 1.07)
  {
    EXPECT_GE(RadialSpectrum(field, w), 0.0) << "at " << w;
    const double below = CumulativeSpectrum(field, w);
    EXPECT_GE(below, before - 1e-12) << "at " << w;
    EXPECT_LE(below, 1.0 + 1e-12) << "at " << w;
    before = below;
  }
}

TEST_P(AllModels, CovarianceIsTheVarianceAtZeroAndFallsToAThird)
{
  EXPECT_EQ(Covariance(field, 0.0), field.Variance);
  double before = field.Variance;
  for (double r = 1e-3; before > field.Variance / 3.0; r *= 1.1)
  {
    ASSERT_LT(r, 100.0 * field.Range);
    EXPECT_LT(Covariance(field, r), before) << "at " << r;
    before = Covariance(field, r);
  }
  for (double r = 1e-3; r < 1e4; r *= 1.3)
  {
    EXPECT_LE(std::abs(Covariance(field, r)), field.Variance) << "at " << r;
  }
}

TEST_P(AllModels, EachParameterThatCountsIsCheckedAndTheOthersAreNot)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const CovarianceTraits& traits = TraitsOf(field.Model);
  for (const auto* parameter : AllCovarianceParameters())
  {
    CovarianceParameters broken = field;
    parameter->Set(broken, nan);
    const std::string reason = WhyInvalid(broken);
    EXPECT_EQ(reason.empty(), !traits.Parameters.Has(parameter->Name)) << parameter->Name;
    EXPECT_TRUE(reason.empty() || reason.find(parameter->Name) == 0) << reason;
  }
  for (const auto* parameter : traits.Parameters)
  {
    CovarianceParameters other = field;
    parameter->Set(other, 1.1 * parameter->Get(field));
    EXPECT_TRUE(Covariance(other, 1.3) != Covariance(field, 1.3)) << parameter->Name << " counts for nothing";
  }
}

TEST(Covariance, RowsHaveNamesOfTheirOwnAndNothingElseIsAModel)
{
  std::set<std::string> names;
  for (int model = 0; model < NumberOfCovarianceModels; ++model)
  {
    names.insert(CovarianceModelName(static_cast<CovarianceModel>(model)));
  }
  EXPECT_EQ(static_cast<int>(names.size()), NumberOfCovarianceModels);
  for (const int none : { -1, NumberOfCovarianceModels })
  {
    CovarianceParameters field;
    field.Model = static_cast<CovarianceModel>(none);
    EXPECT_EQ(WhyInvalid(field).find("Model"), 0u);
  }
}

INSTANTIATE_TEST_SUITE_P(Covariance, AllModels, testing::Range(0, NumberOfCovarianceModels),
  [](const auto& one) { return CovarianceModelName(static_cast<CovarianceModel>(one.param)); });

TEST(Covariance, FractalDimensionOutsideTwoToThreeIsNamed)
{
  CovarianceParameters field = Field(CovarianceModel::Fractal);
  for (double bad : { 2.0, 3.0, 1.5, 3.5, std::numeric_limits<double>::quiet_NaN() })
  {
    field.FractalDimension = bad;
    EXPECT_NE(WhyInvalid(field).find("FractalDimension"), std::string::npos) << bad;
  }
}

TEST(Covariance, TelisWithEqualScalesIsBessel1)
{
  CovarianceParameters telis = Field(CovarianceModel::Telis);
  CovarianceParameters whittle = Field(CovarianceModel::Bessel1);
  for (double nearly : { 1.0, 1.0 + 1e-4 })
  {
    telis.SecondRange = telis.Range * nearly;
    for (double x : { 0.1, 1.0, 5.0 })
    {
      EXPECT_NEAR(Covariance(telis, x), Covariance(whittle, x), 1e-3);
      EXPECT_NEAR(RadialSpectrum(telis, x), RadialSpectrum(whittle, x), 1e-3);
    }
  }
}

TEST(Covariance, FractalVariogramIsThePowerLawAtShortDistances)
{
  CovarianceParameters field = Field(CovarianceModel::Fractal);
  const double H = 3.0 - field.FractalDimension;
  const double x = TwoPi * 0.001 / field.Range;
  const double power = field.Variance * std::pow(0.5 * x, 2.0 * H) * std::tgamma(1.0 - H) / std::tgamma(1.0 + H);
  EXPECT_NEAR(Semivariance(field, 0.001) / power, 1.0, 1e-3);
  // Smooth where the series hands over to the asymptotic form, at 2 pi r / Range = 22.
  const double r = 22.0 * field.Range / TwoPi;
  EXPECT_NEAR(Semivariance(field, r * (1 - 1e-9)), Semivariance(field, r * (1 + 1e-9)), 1e-7);
}
