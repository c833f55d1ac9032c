// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/Constants.h"
#include "Numerics/RandomStream.h"
#include "Patterns/QuadratFit.h"
#include "Patterns/QuadratLaws.h"
#include "Patterns/QuadratPattern.h"
#include "QuadratPosition.h"

#include <gtest/gtest.h>

#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/negative_binomial.hpp>
#include <boost/math/distributions/poisson.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <iterator>
#include <limits>
#include <numeric>
#include <set>
#include <string>

using namespace littoral;
using littoral::testing::QuadratPosition;

namespace
{

QuadratLawParameters Law(int id)
{
  QuadratLawParameters law;
  law.Law = static_cast<QuadratLaw>(id);
  law.Mean = 1.7;
  law.Trials = 4;
  law.ClusterShape = 1.3;
  law.ClusterMean = 1.6;
  law.ClusterSuccess = 0.4;
  return law;
}

using Complex = std::complex<double>;

/// The expectation of z^count, written from the definition of each law; in the order of the enumeration.
using Transform = Complex (*)(const QuadratLawParameters&, Complex);
const Transform GeneratingFunctions[] = {
  [](const QuadratLawParameters& law, Complex z) { return std::exp(law.Mean * (z - 1.0)); },
  [](const QuadratLawParameters& law, Complex z) {
    const double n = law.Trials;
    return std::pow(1.0 + law.Mean / n * (z - 1.0), n);
  },
  [](const QuadratLawParameters& law, Complex z) {
    return std::pow(1.0 - law.Mean / law.ClusterShape * (z - 1.0), -law.ClusterShape);
  },
  [](const QuadratLawParameters& law, Complex z) {
    return std::exp(law.Mean / law.ClusterMean * (std::exp(law.ClusterMean * (z - 1.0)) - 1.0));
  },
  [](const QuadratLawParameters& law, Complex z) {
    const double n = law.Trials;
    const double p = law.ClusterSuccess;
    return std::exp(law.Mean / (n * p) * (std::pow(1.0 + p * (z - 1.0), n) - 1.0));
  },
  [](const QuadratLawParameters& law, Complex z) {
    const double k = law.ClusterShape;
    const double t = law.ClusterMean;
    return std::exp(law.Mean / t * (std::pow(1.0 - t / k * (z - 1.0), -k) - 1.0));
  },
};

Complex GeneratingFunction(const QuadratLawParameters& law, Complex z)
{
  return GeneratingFunctions[static_cast<int>(law.Law)](law, z);
}

bool HasGeneratingFunction(int law)
{
  return law < static_cast<int>(std::size(GeneratingFunctions));
}

class AllLaws : public ::testing::TestWithParam<int>
{
};

std::vector<long long> Sampled(const QuadratLawParameters& law, int quadrats, int seed)
{
  return CountFrequencies(QuadratCounts(law, quadrats, QuadratMode::Sampling, seed));
}

}

TEST_P(AllLaws, MassFunctionIsTheTransformOfItsGeneratingFunction)
{
  if (!HasGeneratingFunction(GetParam()))
  {
    GTEST_SKIP() << "no generating function written down; moments are checked";
  }
  const QuadratLawParameters law = Law(GetParam());
  const int n = 256;
  const std::vector<double> mass = MassFunction(law, n - 1);
  for (int r = 0; r < 60; ++r)
  {
    Complex sum = 0.0;
    for (int j = 0; j < n; ++j)
    {
      sum += GeneratingFunction(law, std::polar(1.0, TwoPi * j / n)) * std::polar(1.0 / n, -TwoPi * j * r / n);
    }
    EXPECT_NEAR(mass[r], sum.real(), 1e-12) << r;
  }
}

TEST_P(AllLaws, MomentsAreRightAlsoAtAMeanOf2000)
{
  for (double mean : { 0.3, 2.5, 2000.0 })
  {
    QuadratLawParameters law = Law(GetParam());
    law.Mean = mean;
    law.Trials = law.Law == QuadratLaw::Binomial ? static_cast<int>(2.0 * mean) + 3 : law.Trials;
    law.ClusterShape = law.Law == QuadratLaw::NegativeBinomial && mean > 100.0 ? 50.0 : law.ClusterShape;
    ASSERT_EQ(WhyInvalid(law), "");
    const std::vector<double> mass = MassFunction(law);
    double total = 0.0;
    double first = 0.0;
    double second = 0.0;
    for (std::size_t r = 0; r < mass.size(); ++r)
    {
      ASSERT_TRUE(std::isfinite(mass[r]) && mass[r] >= 0.0);
      total += mass[r];
      first += static_cast<double>(r) * mass[r];
      second += std::pow(static_cast<double>(r) - mean, 2) * mass[r];
    }
    EXPECT_NEAR(total, 1.0, 1e-10);
    EXPECT_NEAR(first, mean, 1e-9 * mean);
    EXPECT_NEAR(second, CountVariance(law), 1e-8 * CountVariance(law));
  }
}

// The p-values of Pearson's test over 500 seeds are uniform (Kolmogorov and Smirnov).
TEST_P(AllLaws, SamplingFollowsTheLaw)
{
  const QuadratLawParameters law = Law(GetParam());
  const std::vector<double> mass = MassFunction(law, 200);
  const int quadrats = 2000;
  const int seeds = 500;
  std::vector<double> pValues;
  for (int seed = 0; seed < seeds; ++seed)
  {
    std::vector<long long> frequencies = Sampled(law, quadrats, seed);
    frequencies.resize(mass.size(), 0);
    double statistic = 0.0;
    int cells = 0;
    double expected = 0.0;
    double observed = 0.0;
    double rest = quadrats;
    for (std::size_t r = 0; r < mass.size(); ++r)
    {
      expected += quadrats * mass[r];
      observed += static_cast<double>(frequencies[r]);
      rest -= quadrats * mass[r];
      if ((expected >= 8.0 && rest >= 8.0) || r + 1 == mass.size())
      {
        statistic += (observed - expected) * (observed - expected) / expected;
        expected = observed = 0.0;
        ++cells;
      }
    }
    pValues.push_back(boost::math::cdf(boost::math::complement(boost::math::chi_squared(cells - 1), statistic)));
  }
  std::sort(pValues.begin(), pValues.end());
  double distance = 0.0;
  for (int i = 0; i < seeds; ++i)
  {
    distance = std::max({ distance, (i + 1.0) / seeds - pValues[i], pValues[i] - double(i) / seeds });
  }
  EXPECT_LT(distance * std::sqrt(seeds), 1.95); // chance 0.001
}

TEST_P(AllLaws, QuotaKeepsQuadratsAndPointsExactly)
{
  for (int quadrats : { 1, 7, 400, 12345 })
  {
    const std::vector<long long> frequencies = QuotaFrequencies(Law(GetParam()), quadrats);
    const QuadratMoments moments = MomentsOfCounts(frequencies);
    EXPECT_EQ(moments.Quadrats, quadrats);
    EXPECT_EQ(moments.Points, std::llround(1.7 * quadrats));
  }
}

TEST_P(AllLaws, MeasuredAndRegrownIsTheSameLawOrNotDistinguishable)
{
  const std::vector<QuadratFit> fits = FitAllQuadratLaws(Sampled(Law(GetParam()), 4000, 3));
  const std::vector<long long> again = CountFrequencies(QuadratCounts(fits[0].Law, 4000, QuadratMode::Quota, 4));
  const std::vector<QuadratFit> second = FitAllQuadratLaws(again);
  const auto same =
    std::find_if(second.begin(), second.end(), [&](const QuadratFit& fit) { return fit.Law.Law == fits[0].Law.Law; });
  EXPECT_LE(same->AIC - second[0].AIC, DistinguishableAIC + 1e-9) << QuadratLawName(second[0].Law.Law);
}

TEST_P(AllLaws, EachParameterThatCountsIsCheckedAndTheOthersAreNot)
{
  const QuadratLawParameters law = Law(GetParam());
  for (const auto* parameter : AllQuadratLawParameters())
  {
    QuadratLawParameters broken = law;
    parameter->Set(broken, -1.0);
    const std::string reason = WhyInvalid(broken);
    EXPECT_EQ(reason.empty(), !TraitsOf(law.Law).Parameters.Has(parameter->Name)) << parameter->Name;
    EXPECT_TRUE(reason.empty() || reason.find(parameter->Name) == 0) << reason;
  }
  for (const auto* parameter : TraitsOf(law.Law).Parameters)
  {
    QuadratLawParameters other = law;
    parameter->Set(other, std::string(parameter->Name) == "Trials" ? 6.0 : 1.1 * parameter->Get(law));
    EXPECT_NE(MassFunctionUpTo(other, 3), MassFunctionUpTo(law, 3)) << parameter->Name << " counts for nothing";
  }
}

TEST_P(AllLaws, ReachAsFarAsTheirLength)
{
  const QuadratLawParameters law = Law(GetParam());
  const QuadratLawLengths lengths = TraitsOf(law.Law).Lengths(law);
  double total = 0.0;
  for (const double chance : MassFunctionUpTo(law, static_cast<int>(lengths.Counts)))
  {
    total += chance;
  }
  EXPECT_NEAR(total, 1.0, 1e-12);
}

TEST(QuadratLaws, RowsHaveNamesOfTheirOwnAndNothingElseIsALaw)
{
  std::set<std::string> names;
  for (int law = 0; law < NumberOfQuadratLaws; ++law)
  {
    names.insert(QuadratLawName(static_cast<QuadratLaw>(law)));
  }
  EXPECT_EQ(static_cast<int>(names.size()), NumberOfQuadratLaws);
  EXPECT_EQ(WhyInvalid(Law(-1)).find("Law"), 0u);
  EXPECT_EQ(WhyInvalid(Law(NumberOfQuadratLaws)).find("Law"), 0u);
}

TEST_P(AllLaws, BadParametersAreNamed)
{
  EXPECT_EQ(WhyInvalid(Law(GetParam())), "");
  for (double bad : { 0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), 1e9 })
  {
    QuadratLawParameters law = Law(GetParam());
    law.Mean = bad;
    EXPECT_NE(WhyInvalid(law).find("MeanPerQuadrat"), std::string::npos);
  }
}

INSTANTIATE_TEST_SUITE_P(QuadratLaws, AllLaws, ::testing::Range(0, NumberOfQuadratLaws),
  [](const auto& one) { return QuadratLawName(static_cast<QuadratLaw>(one.param)); });

TEST(QuadratLaws, ParametersOfEachLawAreChecked)
{
  const auto reason = [](int id, auto spoil) {
    QuadratLawParameters law = Law(id);
    spoil(law);
    return WhyInvalid(law);
  };
  EXPECT_NE(reason(1, [](auto& law) { law.Mean = 4.5; }).find("Trials"), std::string::npos);
  EXPECT_NE(reason(1, [](auto& law) { law.Trials = 0; }).find("Trials"), std::string::npos);
  EXPECT_NE(reason(2, [](auto& law) { law.ClusterShape = 0.0; }).find("ClusterShape"), std::string::npos);
  EXPECT_NE(reason(3, [](auto& law) { law.ClusterMean = -1.0; }).find("ClusterMean"), std::string::npos);
  EXPECT_NE(reason(4, [](auto& law) { law.ClusterSuccess = 1.5; }).find("ClusterSuccess"), std::string::npos);
}

TEST(QuadratPattern, ThePapersQuota)
{
  QuadratLawParameters law;
  law.Mean = 1.0;
  const std::vector<long long> frequencies = QuotaFrequencies(law, 1000);
  const std::vector<long long> wanted = { 368, 368, 184, 61, 15, 3, 1 };
  for (std::size_t r = 0; r < frequencies.size(); ++r)
  {
    EXPECT_EQ(frequencies[r], r < wanted.size() ? wanted[r] : 0) << r;
  }
}

TEST(QuadratPattern, PointsAreUniformInTheirQuadratAndNoneOutside)
{
  QuadratGrid grid;
  grid.Origin = { -3.0, 10.0 };
  grid.Size = { 6.0, 2.0 };
  grid.Count = { 5, 3 };
  double mean[2] = { 0.0, 0.0 };
  double square[2] = { 0.0, 0.0 };
  double product = 0.0;
  const int points = 4000;
  for (int quadrat = 0; quadrat < 15; ++quadrat)
  {
    for (int index = 0; index < points; ++index)
    {
      const auto position = QuadratPosition(grid, quadrat, index, 1);
      ASSERT_EQ(QuadratOf(grid, position[0], position[1]), quadrat);
      const double u[2] = { (position[0] + 3.0) / 1.2 - quadrat % 5, (position[1] - 10.0) * 1.5 - quadrat / 5 };
      for (int axis = 0; axis < 2; ++axis)
      {
        mean[axis] += u[axis] / (15.0 * points);
        square[axis] += u[axis] * u[axis] / (15.0 * points);
      }
      product += (u[0] - 0.5) * (u[1] - 0.5) / (15.0 * points);
    }
  }
  for (int axis = 0; axis < 2; ++axis)
  {
    EXPECT_NEAR(mean[axis], 0.5, 0.005);
    EXPECT_NEAR(square[axis], 1.0 / 3.0, 0.005);
  }
  EXPECT_NEAR(product, 0.0, 0.0017); // one coordinate says nothing about the other: five times 1 / (12 N^(1/2))
  // All edges belong to the grid.
  EXPECT_EQ(QuadratOf(grid, -3.0, 10.5), 0);
  EXPECT_EQ(QuadratOf(grid, 0.0, 10.0), 2);
  EXPECT_EQ(QuadratOf(grid, 3.0, 11.0), 9);
  EXPECT_EQ(QuadratOf(grid, 3.0, 12.0), 14);
  EXPECT_EQ(QuadratOf(grid, 3.1, 12.0), -1);
  EXPECT_EQ(QuadratOf(grid, std::numeric_limits<double>::quiet_NaN(), 11.0), -1);
}

// Each quadrat by its own draw and a search in the sums of the law, also where these are long.
TEST_P(AllLaws, SampledCountsInvertTheLaw)
{
  for (const double mean : { 0.05, 1.7, 700.0 })
  {
    QuadratLawParameters law = Law(GetParam());
    law.Mean = mean;
    law.Trials = law.Law == QuadratLaw::Binomial ? static_cast<int>(2.0 * mean) + 3 : law.Trials;
    std::vector<double> sums = MassFunction(law);
    std::partial_sum(sums.begin(), sums.end(), sums.begin());
    const RandomStream random(9, RandomPurpose::QuadratCounts);
    const std::vector<int> counts = QuadratCounts(law, 40001, QuadratMode::Sampling, 9);
    for (std::size_t q = 0; q < counts.size(); ++q)
    {
      const double wanted = random.UniformPair(q, 0)[0] * sums.back();
      ASSERT_EQ(counts[q], std::upper_bound(sums.begin(), sums.end(), wanted) - sums.begin()) << q << " " << mean;
    }
    // Backwards, one range after the other.
    const auto backwards = [](std::size_t count, const RangeTask& task) {
      for (std::size_t n = count; n-- > 0;)
      {
        task(n, n + 1);
      }
    };
    EXPECT_EQ(QuadratCounts(law, 40001, QuadratMode::Sampling, 9, NoPoll, backwards), counts);
  }
}

// Fisher and Yates, a quadrat at a time.
TEST_P(AllLaws, QuotaIsDealtAtRandom)
{
  const RandomStream random(4, RandomPurpose::QuadratOrder);
  for (const long long quadrats : { 1, 2, 511, 512, 513, 514, 5000 })
  {
    const std::vector<long long> frequencies = QuotaFrequencies(Law(GetParam()), quadrats);
    std::vector<int> counts;
    for (std::size_t r = 0; r < frequencies.size(); ++r)
    {
      counts.insert(counts.end(), static_cast<std::size_t>(frequencies[r]), static_cast<int>(r));
    }
    for (std::size_t q = counts.size(); q > 1; --q)
    {
      const double place = random.UniformPair(q, 0)[0] * static_cast<double>(q);
      std::swap(counts[q - 1], counts[std::min(static_cast<std::size_t>(place), q - 1)]);
    }
    EXPECT_EQ(QuadratCounts(Law(GetParam()), quadrats, QuadratMode::Quota, 4), counts) << quadrats;
  }
}

TEST(QuadratPattern, QuotaPollsOnItsWay)
{
  int polls = 0;
  QuadratCounts(Law(0), 50000, QuadratMode::Quota, 1, [&] { ++polls; });
  EXPECT_EQ(polls, 50000 / 4096);
}

TEST(QuadratPattern, SitesAreSumsOfCounts)
{
  const std::vector<int> counts = { 3, 0, 2, 7, 0, 1, 4 };
  EXPECT_EQ(QuadratSites(counts, 0, 7, 3), (std::vector<long long>{ 0, 5, 13, 17 }));
  EXPECT_EQ(QuadratSites(counts, 2, 6, 2), (std::vector<long long>{ 3, 12, 13 }));
  EXPECT_EQ(QuadratSites(counts, 2, 4, 100), (std::vector<long long>{ 3, 12 }));
  EXPECT_EQ(QuadratSites(counts, 7, 7, 2), (std::vector<long long>{ 17 }));
}

// Ranges from the last to the first, of many empty quadrats, of one, and of quadrats with more points than are drawn at
// once: each point is where QuadratPosition() has it, and nothing is written beyond.
TEST(QuadratPattern, RangesInAnyOrderAreThePattern)
{
  QuadratGrid grid;
  grid.Origin = { -3.7, 1e5 };
  grid.Size = { 613.0, 29.0 };
  grid.Count = { 7, 11 };
  std::vector<int> counts(77);
  for (int q = 0; q < 77; ++q)
  {
    counts[q] = q % 13 == 0 ? 1300 + q : q % 5 == 0 ? q : q % 3;
  }
  for (const std::size_t step : { 1, 4, 10, 77 })
  {
    const std::vector<long long> sites = QuadratSites(counts, 0, 77, step);
    std::vector<double> positions(3 * static_cast<std::size_t>(sites.back()), -1.0);
    std::vector<int> quadrats(static_cast<std::size_t>(sites.back()), -1);
    for (std::size_t block = sites.size() - 1; block-- > 0;)
    {
      const std::size_t begin = block * step;
      const auto first = static_cast<std::size_t>(sites[block]);
      PlaceQuadratPoints(
        grid, 6, counts, begin, std::min<std::size_t>(77, begin + step), &positions[3 * first], &quadrats[first]);
    }
    std::size_t point = 0;
    for (int q = 0; q < 77; ++q)
    {
      for (int index = 0; index < counts[q]; ++index, ++point)
      {
        const auto place = QuadratPosition(grid, q, index, 6);
        ASSERT_EQ(quadrats[point], q);
        ASSERT_EQ(positions[3 * point], place[0]);
        ASSERT_EQ(positions[3 * point + 1], place[1]);
        ASSERT_EQ(positions[3 * point + 2], 0.0);
      }
    }
  }
}

TEST(QuadratFit, ParametersAreRecovered)
{
  QuadratLawParameters negative = Law(2);
  negative.ClusterShape = 1.5;
  negative.Mean = 3.0;
  QuadratLawParameters neyman = Law(3);
  neyman.ClusterMean = 1.0;
  neyman.Mean = 2.0;
  QuadratLawParameters binomial = Law(1);
  binomial.Trials = 5;
  binomial.Mean = 2.0;
  for (int seed = 1; seed <= 5; ++seed)
  {
    const QuadratFit a = FitQuadratLaw(QuadratLaw::NegativeBinomial, Sampled(negative, 1000, seed));
    EXPECT_NEAR(a.Law.ClusterShape, 1.5, 0.33);
    EXPECT_NEAR(a.Moments.ClusterShape, 1.5, 0.4);
    const QuadratFit b = FitQuadratLaw(QuadratLaw::PoissonPoisson, Sampled(neyman, 1000, seed));
    EXPECT_NEAR(b.Law.ClusterMean, 1.0, 0.22);
    const QuadratFit c = FitQuadratLaw(QuadratLaw::Binomial, Sampled(binomial, 1000, seed));
    EXPECT_TRUE(c.Exists);
    EXPECT_NEAR(c.Law.Trials, 5, 1);
    EXPECT_NEAR(c.Moments.Trials, 5, 1);
  }
}

TEST(QuadratFit, NegativeBinomialAndNeymanAreToldApart)
{
  QuadratLawParameters negative = Law(2);
  negative.ClusterShape = 2.0;
  negative.Mean = 2.0;
  QuadratLawParameters neyman = Law(3);
  neyman.ClusterMean = 1.0;
  neyman.Mean = 2.0;
  for (const QuadratLawParameters& truth : { negative, neyman })
  {
    int right = 0;
    for (int seed = 1; seed <= 20; ++seed)
    {
      const std::vector<long long> frequencies = Sampled(truth, 1000, seed);
      const double a = FitQuadratLaw(QuadratLaw::NegativeBinomial, frequencies).AIC;
      const double b = FitQuadratLaw(QuadratLaw::PoissonPoisson, frequencies).AIC;
      right += (a < b) == (truth.Law == QuadratLaw::NegativeBinomial);
    }
    EXPECT_GE(right, 18) << QuadratLawName(truth.Law);
  }
}

TEST(QuadratFit, RandomDataAreCalledRandom)
{
  int random = 0;
  for (int seed = 1; seed <= 200; ++seed)
  {
    random += MomentsOfCounts(Sampled(Law(0), 400, seed)).DispersionPValue > 0.05;
  }
  EXPECT_GE(random, 180);
}

namespace
{

/// A law of thousands of points a quadrat.
QuadratLawParameters LargeLaw(int id)
{
  QuadratLawParameters law;
  law.Law = static_cast<QuadratLaw>(id);
  law.Mean = 3000.0;
  law.Trials = law.Law == QuadratLaw::Binomial ? 9000 : 50;
  law.ClusterShape = law.Law == QuadratLaw::NegativeBinomial ? 25.0 : 1.5;
  law.ClusterMean = 40.0;
  law.ClusterSuccess = 0.7;
  return law;
}

class LargeLaws : public ::testing::TestWithParam<int>
{
};

/// Against a law of Boost, where it has more than 1e-30.
template <typename Distribution>
void ExpectIs(const QuadratLawParameters& law, const Distribution& exact)
{
  ASSERT_EQ(WhyInvalid(law), "");
  const std::vector<double> mass = MassFunction(law);
  double total = 0.0;
  for (std::size_t r = 0; r < mass.size(); ++r)
  {
    total += mass[r];
    const bool looks = r % 37 == 0 && static_cast<double>(r) <= boost::math::support(exact).second;
    const double wanted = looks ? boost::math::pdf(exact, static_cast<double>(r)) : 0.0;
    if (wanted > 1e-30)
    {
      ASSERT_NEAR(mass[r] / wanted, 1.0, 1e-9) << r;
    }
  }
  EXPECT_NEAR(total, 1.0, 1e-10);
}

}

TEST_P(LargeLaws, MassFunctionIsTheTransformOfItsGeneratingFunction)
{
  if (!HasGeneratingFunction(GetParam()))
  {
    GTEST_SKIP() << "no generating function written down; moments are checked";
  }
  const QuadratLawParameters law = LargeLaw(GetParam());
  const int n = 8192;
  const std::vector<double> mass = MassFunction(law, n);
  std::vector<Complex> values(n);
  for (int j = 0; j < n; ++j)
  {
    values[j] = GeneratingFunction(law, std::polar(1.0, TwoPi * j / n));
  }
  for (int r = 1500; r < 5000; r += 83)
  {
    Complex sum = 0.0;
    for (int j = 0; j < n; ++j)
    {
      sum += values[j] * std::polar(1.0 / n, -TwoPi * static_cast<double>(static_cast<long long>(j) * r % n) / n);
    }
    EXPECT_NEAR(mass[r], sum.real(), 1e-12) << r;
  }
}

// Even where each count is expected less than once: 300 quadrats, deviations of 45 to 602 points. Rounding each count
// alone keeps 83 % of the Poisson variance and 2 % of the negative binomial one.
TEST_P(LargeLaws, QuotaKeepsTheLaw)
{
  const QuadratLawParameters law = LargeLaw(GetParam());
  const QuadratMoments moments = MomentsOfCounts(QuotaFrequencies(law, 300));
  EXPECT_EQ(moments.Quadrats, 300);
  EXPECT_EQ(moments.Points, 900000);
  EXPECT_NEAR(moments.Variance / CountVariance(law), 1.0, 0.03);
}

// Means and variances of 2000 samples, and the law itself by the distance of Kolmogorov and Smirnov, chance 0.001.
TEST_P(LargeLaws, SamplingFollowsTheLaw)
{
  const QuadratLawParameters law = LargeLaw(GetParam());
  const int quadrats = 2000;
  const std::vector<long long> frequencies = Sampled(law, quadrats, 5);
  const std::vector<double> mass = MassFunction(law, static_cast<int>(frequencies.size()));
  double distance = 0.0;
  double exact = 0.0;
  double seen = 0.0;
  for (std::size_t r = 0; r < frequencies.size(); ++r)
  {
    exact += mass[r];
    seen += static_cast<double>(frequencies[r]) / quadrats;
    distance = std::max(distance, std::abs(exact - seen));
  }
  EXPECT_LT(distance * std::sqrt(quadrats), 1.95);
  const QuadratMoments moments = MomentsOfCounts(frequencies);
  EXPECT_NEAR(moments.Mean, law.Mean, 4.0 * std::sqrt(CountVariance(law) / quadrats));
  EXPECT_NEAR(moments.Variance / CountVariance(law), 1.0, 4.0 * std::sqrt(2.5 / quadrats));
}

// The likelihood of the fit is that of the truth or better, and the fitted law has its variance.
TEST_P(LargeLaws, FitsFindTheLaw)
{
  const QuadratLawParameters law = LargeLaw(GetParam());
  const std::vector<long long> frequencies = Sampled(law, 400, 7);
  const QuadratFit fit = FitQuadratLaw(law.Law, frequencies);
  EXPECT_TRUE(fit.Exists);
  EXPECT_TRUE(fit.MomentsExist || law.Law == QuadratLaw::PoissonNegativeBinomial); // which has to match a third moment
  const std::vector<double> mass = MassFunctionUpTo(law, static_cast<int>(frequencies.size()) - 1);
  double truth = 0.0;
  for (std::size_t r = 0; r < frequencies.size(); ++r)
  {
    truth += frequencies[r] > 0 ? static_cast<double>(frequencies[r]) * std::log(mass[r]) : 0.0;
  }
  EXPECT_GE(fit.LogLikelihood, truth - 1e-6);
  EXPECT_LT(fit.LogLikelihood, truth + 8.0);
  const double spread = 5.0 * std::sqrt(2.0 / 400.0);
  EXPECT_NEAR(CountVariance(fit.Law) / CountVariance(law), 1.0, spread);
  if (fit.MomentsExist)
  {
    EXPECT_NEAR(CountVariance(fit.Moments) / MomentsOfCounts(frequencies).Variance, 1.0,
      TraitsOf(law.Law).Parameters.Size() == 1 ? spread : 0.01); // the mean alone leaves the variance free
  }
  EXPECT_GT(fit.PValue, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(QuadratLaws, LargeLaws, ::testing::Range(0, NumberOfQuadratLaws),
  [](const auto& one) { return QuadratLawName(static_cast<QuadratLaw>(one.param)); });

TEST(QuadratLaws, AreThoseOfBoostUpToThousandsOfPoints)
{
  for (const double mean : { 0.7, 480.0, 3000.0, 20000.0 })
  {
    QuadratLawParameters law;
    law.Mean = mean;
    ExpectIs(law, boost::math::poisson(mean));
    law.Law = QuadratLaw::Binomial;
    law.Trials = static_cast<int>(1.5 * mean) + 3;
    ExpectIs(law, boost::math::binomial(law.Trials, mean / law.Trials));
    law.Law = QuadratLaw::NegativeBinomial;
    for (const double shape : { 0.5, 4.0, 1000.0 })
    {
      law.ClusterShape = shape;
      ExpectIs(law, boost::math::negative_binomial(shape, shape / (shape + mean)));
    }
  }
}

TEST(QuadratLaws, LawsThatAreTooLongAreRefused)
{
  QuadratLawParameters law;
  law.Mean = 9e4;
  EXPECT_EQ(WhyInvalid(law), "");
  law.Law = QuadratLaw::NegativeBinomial;
  law.ClusterShape = 1e-3;
  EXPECT_NE(WhyInvalid(law).find("too much to compute"), std::string::npos);
  law.Law = QuadratLaw::PoissonPoisson;
  law.ClusterMean = 5e4;
  EXPECT_NE(WhyInvalid(law).find("in clusters"), std::string::npos);
}

TEST(QuadratFit, NumbersOfASampleByHand)
{
  // 10 quadrats with 0, 1, 2 and 3 points, of mean 1: squares off the mean add up to 10, cubes to 6.
  const QuadratMoments moments = MomentsOfCounts({ 4, 3, 2, 1 });
  EXPECT_NEAR(moments.Mean, 1.0, 1e-14);
  EXPECT_NEAR(moments.Variance, 10.0 / 9.0, 1e-14);
  EXPECT_NEAR(moments.ThirdMoment, 0.6, 1e-14);
  // P(chi^2 > 10) of 9 degrees of freedom by the normal law (Abramowitz and Stegun 26.4.4), and as much on the far
  // side.
  double terms = 0.0;
  double term = std::sqrt(10.0);
  for (int r = 1; r <= 4; term *= 10.0 / (2 * r + 1), ++r)
  {
    terms += term;
  }
  const double above = std::erfc(std::sqrt(5.0)) + 2.0 * std::exp(-5.0) / std::sqrt(2.0 * std::acos(-1.0)) * terms;
  EXPECT_NEAR(moments.DispersionPValue, 2.0 * above, 1e-10);

  // Ten times as many: Poisson's law expects 100 / e, 100 / e, 50 / e and the rest, of which 1 + 1 tell the fit
  // nothing.
  const QuadratFit fit = FitQuadratLaw(QuadratLaw::Poisson, { 40, 30, 20, 10 });
  EXPECT_NEAR(fit.LogLikelihood, -100.0 - 20.0 * std::log(2.0) - 10.0 * std::log(6.0), 1e-9);
  EXPECT_NEAR(fit.AIC, 2.0 - 2.0 * fit.LogLikelihood, 1e-9);
  const double first = 100.0 * std::exp(-1.0);
  const double rest = 100.0 - 2.5 * first;
  EXPECT_NEAR(fit.ChiSquare,
    (std::pow(40.0 - first, 2) + std::pow(30.0 - first, 2)) / first + std::pow(20.0 - 0.5 * first, 2) / (0.5 * first) +
      std::pow(10.0 - rest, 2) / rest,
    1e-9);
  EXPECT_EQ(fit.DegreesOfFreedom, 2);
  EXPECT_NEAR(fit.PValue, std::exp(-0.5 * fit.ChiSquare), 1e-12); // of 2 degrees
}

// A sample whose frequencies are the law's own has its cumulants, and these have the law's parameters.
TEST(QuadratFit, CumulantsOfALawGiveItsParameters)
{
  for (const double shape : { 0.6, 1.3, 4.0 })
  {
    QuadratLawParameters law = Law(5);
    law.ClusterShape = shape;
    std::vector<long long> frequencies;
    for (const double part : MassFunction(law, 100))
    {
      frequencies.push_back(std::llround(1e13 * part));
    }
    const QuadratFit fit = FitQuadratLaw(QuadratLaw::PoissonNegativeBinomial, frequencies);
    ASSERT_TRUE(fit.MomentsExist) << shape;
    EXPECT_NEAR(fit.Moments.ClusterShape, shape, 1e-4 * shape);
    EXPECT_NEAR(fit.Moments.ClusterMean, law.ClusterMean, 1e-4);
  }
}

TEST(QuadratPattern, ChoosesAsManyQuadratsAsPoints)
{
  QuadratGrid grid;
  grid.Size = { 40.0, 10.0 };
  ChooseQuadrats(grid, 100.0);
  EXPECT_EQ(grid.Count[0], 20);
  EXPECT_EQ(grid.Count[1], 5);
  grid.Size = { 1000.0, 1.0 };
  ChooseQuadrats(grid, 10.0);
  EXPECT_EQ(grid.Count[0], 100);
  EXPECT_EQ(grid.Count[1], 1);
}
