// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "../OnThreads.h"
#include "Numerics/Constants.h"
#include "Patterns/ClusterOffsets.h"
#include "Patterns/PoissonCount.h"
#include "Patterns/ProcessPattern.h"

#include <gtest/gtest.h>

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/poisson.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

using namespace littoral;

namespace
{

ObservationWindow Box(double x0, double y0, double x1, double y1)
{
  return ObservationWindow::Rectangle({ x0, y0 }, { x1, y1 });
}

PointProcessParameters Process(int id)
{
  PointProcessParameters process;
  process.Process = static_cast<PointProcess>(id);
  process.Intensity = 100.0;
  process.ClusterSize = 4.0;
  process.ClusterScale = process.Process == PointProcess::Thomas ? 0.04 : 0.08;
  process.Variance = 0.8;
  process.Range = 0.1;
  process.Distance = 0.04;
  process.Activity = 150.0;
  process.Interaction = 0.3;
  return process;
}

class AllProcesses : public ::testing::TestWithParam<int>
{
};

double SquareDistance(const PlanePosition& a, const PlanePosition& b)
{
  return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);
}

double Shortest(const std::vector<PlanePosition>& points)
{
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t a = 0; a < points.size(); ++a)
  {
    for (std::size_t b = 0; b < a; ++b)
    {
      shortest = std::min(shortest, SquareDistance(points[a], points[b]));
    }
  }
  return std::sqrt(shortest);
}

bool AreSame(const ProcessPattern& a, const ProcessPattern& b)
{
  return a.Points.size() == b.Points.size() &&
    std::memcmp(a.Points.data(), b.Points.data(), a.Points.size() * sizeof(PlanePosition)) == 0;
}

/// Largest distance of p-values from the uniform distribution, times the root of their number.
double Kolmogorov(std::vector<double> p)
{
  std::sort(p.begin(), p.end());
  const auto n = static_cast<double>(p.size());
  double distance = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i)
  {
    distance = std::max({ distance, static_cast<double>(i + 1) / n - p[i], p[i] - static_cast<double>(i) / n });
  }
  return distance * std::sqrt(n);
}

/// Mean and its standard error.
struct Sample
{
  double Sum = 0.0;
  double Squares = 0.0;
  int Count = 0;

  void Add(double value)
  {
    this->Sum += value;
    this->Squares += value * value;
    ++this->Count;
  }
  double Mean() const { return this->Sum / this->Count; }
  double Error() const
  {
    return std::sqrt((this->Squares / this->Count - this->Mean() * this->Mean()) / (this->Count - 1));
  }
};

/// The process within the unit square, of the intensity 1 at the left and 3 at the right third.
IntensityRaster Thirds()
{
  IntensityRaster raster;
  raster.Center = { 1.0 / 6.0, 0.25 };
  raster.Spacing = { 1.0 / 3.0, 0.5 };
  raster.Count = { 3, 2 };
  raster.Values = { 1.0, 2.0, 3.0, 1.0, 2.0, 3.0 };
  return raster;
}

}

// sum over pairs closer than r of 1 / |W and W moved by their difference| has the mean intensity^2 K(r), whatever the
// process (Ohser 1983); 500 seeds, 100 where each costs much, and three standard errors.
TEST_P(AllProcesses, SimulatedPairsFollowTheClosedForm)
{
  const PointProcessParameters process = Process(GetParam());
  const std::vector<double> distances = { 0.01, 0.03, 0.05, 0.08, 0.12, 0.18, 0.25 };
  const std::vector<double> k = RipleyK(process, distances);
  if (std::isnan(k[0]))
  {
    GTEST_SKIP() << "no closed form";
  }
  std::vector<Sample> sums(distances.size());
  Sample counts;
  const int seeds = process.Process == PointProcess::LogGaussianCox ? 100 : 500;
  for (int seed = 1; seed <= seeds; ++seed)
  {
    ProcessOptions options;
    options.Seed = seed;
    const std::vector<PlanePosition> points = SimulateProcess(process, options, Box(3.0, -2.0, 4.0, -1.0)).Points;
    counts.Add(static_cast<double>(points.size()));
    std::vector<double> sum(distances.size(), 0.0);
    for (std::size_t a = 0; a < points.size(); ++a)
    {
      for (std::size_t b = 0; b < a; ++b)
      {
        const double square = SquareDistance(points[a], points[b]);
        const double common =
          (1.0 - std::abs(points[a][0] - points[b][0])) * (1.0 - std::abs(points[a][1] - points[b][1]));
        for (std::size_t n = 0; n < distances.size(); ++n)
        {
          sum[n] += square <= distances[n] * distances[n] ? 2.0 / common : 0.0;
        }
      }
    }
    for (std::size_t n = 0; n < distances.size(); ++n)
    {
      sums[n].Add(sum[n]);
    }
  }
  EXPECT_NEAR(counts.Mean(), 100.0, 3.0 * counts.Error());
  for (std::size_t n = 0; n < distances.size(); ++n)
  {
    EXPECT_NEAR(sums[n].Mean(), 1e4 * k[n], 3.0 * sums[n].Error() + 1e-9) << distances[n];
  }
}

// Over 500 seeds, each with counts in the squares of one colour of a raster, by the law of a Poisson process.
TEST(PointProcesses, RasterCountsAreUniformInTheirProbability)
{
  IntensityRaster raster;
  raster.Center = { 0.05, 0.05 };
  raster.Spacing = { 0.1, 0.1 };
  raster.Count = { 10, 10 };
  const int classes = 5;
  std::vector<double> expected(classes, 0.0);
  for (int cell = 0; cell < 100; ++cell)
  {
    raster.Values.push_back(1.0 + (cell * 7 + cell / 10) % classes);
    expected[(cell * 7 + cell / 10) % classes] += raster.Values.back();
  }
  PointProcessParameters process = Process(0);
  process.Intensity = 400.0;
  const double unit = 400.0 / 100.0 / raster.Mean();
  std::vector<double> pValues;
  for (int seed = 1; seed <= 500; ++seed)
  {
    ProcessOptions options;
    options.Seed = seed;
    options.Raster = &raster;
    std::vector<int> counts(classes, 0);
    for (const PlanePosition& point : SimulateProcess(process, options, Box(0.0, 0.0, 1.0, 1.0)).Points)
    {
      ++counts[static_cast<int>(raster.Values[static_cast<std::size_t>(raster.CellOf(point[0], point[1]))]) - 1];
    }
    double statistic = 0.0;
    for (int n = 0; n < classes; ++n)
    {
      const double mean = unit * expected[n];
      statistic += (counts[n] - mean) * (counts[n] - mean) / mean;
    }
    pValues.push_back(boost::math::cdf(boost::math::complement(boost::math::chi_squared(classes), statistic)));
  }
  EXPECT_LT(Kolmogorov(pValues), 1.36); // 5 %
}

// Means of counts are proportional to a raster for each process whose points a raster thins; the factor of the activity
// of Strauss points is felt less where they are dense.
TEST_P(AllProcesses, RasterChangesTheIntensity)
{
  const IntensityRaster raster = Thirds();
  const PointProcessParameters process = Process(GetParam());
  const bool isSlow = process.Process == PointProcess::LogGaussianCox || process.Process == PointProcess::SoftCore;
  std::vector<Sample> thirds(3);
  for (int seed = 1; seed <= (isSlow ? 50 : 200); ++seed)
  {
    ProcessOptions options;
    options.Seed = seed;
    options.Raster = &raster;
    double counts[3] = { 0.0, 0.0, 0.0 };
    for (const PlanePosition& point : SimulateProcess(process, options, Box(0.0, 0.0, 1.0, 1.0)).Points)
    {
      ++counts[static_cast<int>(3.0 * point[0])];
    }
    for (int n = 0; n < 3; ++n)
    {
      thirds[n].Add(counts[n]);
    }
  }
  if (process.Process == PointProcess::Strauss)
  {
    EXPECT_LT(thirds[2].Mean(), 3.0 * thirds[0].Mean());
    EXPECT_GT(thirds[2].Mean(), 1.8 * thirds[0].Mean());
    return;
  }
  for (int n = 0; n < 3; ++n)
  {
    EXPECT_NEAR(thirds[n].Mean(), (1.0 + n) * 100.0 / 6.0, 3.0 * thirds[n].Error()) << n;
  }
}

TEST_P(AllProcesses, SameBytesOnAnyThreads)
{
  const IntensityRaster raster = Thirds();
  for (const bool hasRaster : { false, true })
  {
    ProcessOptions options;
    options.Raster = hasRaster ? &raster : nullptr;
    PointProcessParameters process = Process(GetParam());
    process.Intensity = process.Process == PointProcess::SoftCore ? 2500.0 : 20000.0;
    process.Activity = 3000.0;
    process.Distance = 0.002;
    const ObservationWindow window = Box(0.0, 0.0, 1.0, 1.0);
    const ProcessPattern one = SimulateProcess(process, options, window);
    ASSERT_GT(one.Points.size(), 2000u);
    EXPECT_TRUE(AreSame(one, SimulateProcess(process, options, window, NoPoll, littoral::testing::OnThreads(5))));
    options.Seed = 2;
    EXPECT_FALSE(AreSame(one, SimulateProcess(process, options, window)));
  }
}

// Two windows show the same points where they overlap.
TEST_P(AllProcesses, WindowsShowPartsOfOnePattern)
{
  const PointProcessParameters process = Process(GetParam());
  if (process.Process == PointProcess::Strauss || process.Process == PointProcess::SoftCore)
  {
    GTEST_SKIP() << "these processes have their own points about each window";
  }
  const auto inBoth = [&](const ObservationWindow& window) {
    std::vector<PlanePosition> points;
    for (const PlanePosition& point : SimulateProcess(process, {}, window).Points)
    {
      const bool isInBoth = point[0] > 0.4 && point[0] < 1.3 && point[1] > 0.2 && point[1] < 0.9;
      if (isInBoth)
      {
        points.push_back(point);
      }
    }
    std::sort(points.begin(), points.end());
    return points;
  };
  const std::vector<PlanePosition> first = inBoth(Box(-0.7, -1.1, 1.3, 0.9));
  EXPECT_GT(first.size(), 20u);
  EXPECT_EQ(first, inBoth(Box(0.4, 0.2, 3.0, 2.0)));
  // A polygon keeps what lies inside.
  const ObservationWindow triangle = ObservationWindow::Polygon({ { 0.0, 0.0 }, { 2.0, 0.0 }, { 0.0, 2.0 } });
  std::vector<PlanePosition> inside;
  for (const PlanePosition& point : SimulateProcess(process, {}, Box(0.0, 0.0, 2.0, 2.0)).Points)
  {
    if (point[0] + point[1] <= 2.0)
    {
      inside.push_back(point);
    }
  }
  EXPECT_EQ(SimulateProcess(process, {}, triangle).Points, inside);
}

// So do small windows anywhere: clusters and older points reach into them over each of their sides.
TEST(PointProcesses, SmallWindowsShowPartsOfOnePatternToo)
{
  for (const int id : { 1, 2, 4 })
  {
    PointProcessParameters process = Process(id);
    if (id == 4)
    {
      process.Distance = 0.055; // as dense as it can be
    }
    const std::vector<PlanePosition> all = SimulateProcess(process, {}, Box(0.0, 0.0, 4.0, 4.0)).Points;
    for (int window = 0; window < 256; ++window)
    {
      const double x = 0.5 + 0.19 * (window % 16);
      const double y = 0.5 + 0.19 * (window / 16.0);
      std::vector<PlanePosition> inside;
      for (const PlanePosition& point : all)
      {
        if (point[0] >= x && point[0] <= x + 0.2 && point[1] >= y && point[1] <= y + 0.2)
        {
          inside.push_back(point);
        }
      }
      std::vector<PlanePosition> shown = SimulateProcess(process, {}, Box(x, y, x + 0.2, y + 0.2)).Points;
      std::sort(inside.begin(), inside.end());
      std::sort(shown.begin(), shown.end());
      ASSERT_EQ(shown, inside) << id << " " << x << " " << y;
    }
  }
}

// Perfect simulation ends at beta (1 - gamma) pi R^2 = 4, of discs and of points that only avoid each other.
TEST(PointProcesses, StraussPointsAreExactUpToALimit)
{
  PointProcessParameters process = Process(5);
  process.Distance = 0.05;
  for (const double interaction : { 0.0, 0.75 })
  {
    process.Interaction = interaction;
    const double unit = 1.0 / ((1.0 - interaction) * Pi * process.Distance * process.Distance);
    process.Activity = 2.2 * unit;
    EXPECT_TRUE(SimulateProcess(process, {}, Box(0.0, 0.0, 0.3, 0.3)).IsExact) << interaction;
    process.Activity = 4.01 * unit;
    EXPECT_FALSE(SimulateProcess(process, {}, Box(0.0, 0.0, 0.01, 0.01)).IsExact) << interaction;
  }
}

TEST(PointProcesses, InhibitedPointsKeepTheirDistanceUnderARasterToo)
{
  const IntensityRaster raster = Thirds();
  for (const int id : { 4, 5 })
  {
    PointProcessParameters process = Process(id);
    process.Interaction = 0.0;
    for (int seed = 1; seed <= 20; ++seed)
    {
      ProcessOptions options;
      options.Seed = seed;
      for (const IntensityRaster* use : { static_cast<const IntensityRaster*>(nullptr), &raster })
      {
        options.Raster = use;
        const ProcessPattern pattern = SimulateProcess(process, options, Box(0.0, 0.0, 1.0, 1.0));
        EXPECT_GT(pattern.Points.size(), 30u);
        EXPECT_GE(Shortest(pattern.Points), process.Distance);
      }
    }
  }
}

// The equation of Georgii, Nguyen and Zessin: the mean number of points with t others within Distance is Activity
// Interaction^t times the mean area of the places with t points within Distance.
TEST(PointProcesses, StraussPointsObeyTheirConditionalIntensity)
{
  for (const double interaction : { 0.0, 0.3, 0.8 })
  {
    PointProcessParameters process = Process(5);
    process.Interaction = interaction;
    process.Distance = 0.05;
    std::vector<Sample> differences(3);
    Sample all;
    for (int seed = 1; seed <= 300; ++seed)
    {
      ProcessOptions options;
      options.Seed = seed;
      const ProcessPattern pattern = SimulateProcess(process, options, Box(0.0, 0.0, 1.0, 1.0));
      ASSERT_TRUE(pattern.IsExact);
      std::vector<PlanePosition> points = pattern.Points;
      std::sort(points.begin(), points.end());
      const auto within = [&](const PlanePosition& place) { // a point itself counts too
        int count = 0;
        for (auto other = std::lower_bound(points.begin(), points.end(), PlanePosition{ place[0] - 0.05, -1.0 });
             other != points.end() && (*other)[0] < place[0] + 0.05; ++other)
        {
          count += SquareDistance(place, *other) < 0.05 * 0.05;
        }
        return count;
      };
      double difference[3] = { 0.0, 0.0, 0.0 };
      for (const PlanePosition& point : points)
      {
        if (point[0] > 0.06 && point[0] < 0.94 && point[1] > 0.06 && point[1] < 0.94)
        {
          const int t = within(point) - 1;
          difference[std::min(t, 2)] += t < 2 ? 1.0 : 0.0;
        }
      }
      const int steps = 22;
      const double area = 0.04 * 0.04;
      for (int cell = 0; cell < steps * steps; ++cell)
      {
        const int column = cell % steps;
        const int row = cell / steps;
        const int t = within({ 0.08 + 0.04 * column, 0.08 + 0.04 * row });
        difference[std::min(t, 2)] -= t < 2 ? 150.0 * std::pow(interaction, t) * area : 0.0;
      }
      for (int t = 0; t < 2; ++t)
      {
        differences[t].Add(difference[t]);
      }
      all.Add(static_cast<double>(pattern.Points.size()));
    }
    EXPECT_NEAR(differences[0].Mean(), 0.0, 3.0 * differences[0].Error()) << interaction;
    EXPECT_NEAR(differences[1].Mean(), 0.0, 3.0 * differences[1].Error() + 1e-12) << interaction;
    EXPECT_LT(differences[0].Error(), 0.03 * all.Mean()); // the test sees a few hundredths
  }
}

// Where a raster is low, Strauss points are those of a lower activity, and avoid each other as there.
TEST(PointProcesses, StraussPointsInteractUnderARasterToo)
{
  IntensityRaster halves;
  halves.Center = { 0.25, 0.5 };
  halves.Spacing = { 0.5, 1.0 };
  halves.Count = { 2, 1 };
  halves.Values = { 1.0, 3.0 };
  Sample counts[2];
  for (const bool hasRaster : { false, true })
  {
    PointProcessParameters process = Process(5);
    process.Distance = 0.05;
    process.Activity = hasRaster ? 300.0 : 150.0; // of the mean of the raster, twice its low half
    for (int seed = 1; seed <= 30; ++seed)
    {
      ProcessOptions options;
      options.Seed = seed;
      options.Raster = hasRaster ? &halves : nullptr;
      const std::vector<PlanePosition> points = SimulateProcess(process, options, Box(0.0, 0.0, 1.0, 1.0)).Points;
      counts[hasRaster].Add(static_cast<double>(
        std::count_if(points.begin(), points.end(), [](const PlanePosition& point) { return point[0] < 0.4; })));
    }
  }
  const double error = std::hypot(counts[0].Error(), counts[1].Error());
  EXPECT_LT(3.0 * error, 0.15 * counts[0].Mean());
  EXPECT_NEAR(counts[1].Mean(), counts[0].Mean(), 3.0 * error);
}

TEST(PointProcesses, StraussPointsWithoutInteractionArePoisson)
{
  PointProcessParameters process = Process(5);
  process.Interaction = 1.0;
  const boost::math::poisson law(150.0);
  Sample counts;
  for (int seed = 1; seed <= 300; ++seed)
  {
    ProcessOptions options;
    options.Seed = seed;
    counts.Add(static_cast<double>(SimulateProcess(process, options, Box(0.0, 0.0, 1.0, 1.0)).Points.size()));
  }
  EXPECT_NEAR(counts.Mean(), 150.0, 3.0 * counts.Error());
  EXPECT_NEAR(counts.Error() * std::sqrt(300.0), std::sqrt(150.0), 0.15 * std::sqrt(150.0));
}

// Where the bounds cannot meet, the pattern says so.
TEST(PointProcesses, StraussPointsThatAreTooDenseAreNotCalledExact)
{
  PointProcessParameters process = Process(5);
  process.Interaction = 0.0;
  process.Activity = 1500.0;
  process.Distance = 0.06;
  const ProcessPattern pattern = SimulateProcess(process, {}, Box(0.0, 0.0, 1.0, 1.0));
  EXPECT_FALSE(pattern.IsExact);
  EXPECT_GE(Shortest(pattern.Points), 0.06);
  EXPECT_GT(pattern.Points.size(), 100u);
}

// Where the bounds could meet in the end, but have not within 128 lifetimes, the pattern says so too: as dense as hard
// discs that are tried at all, whose upper bound always keeps some points more.
TEST(PointProcesses, StraussPointsWhoseBoundsDoNotMeetAreNotCalledExact)
{
  PointProcessParameters process = Process(5);
  process.Interaction = 0.0;
  process.Distance = 1.0;
  process.Activity = 3.9 / Pi;
  for (int seed = 1; seed <= 3; ++seed)
  {
    ProcessOptions options;
    options.Seed = seed;
    EXPECT_FALSE(SimulateProcess(process, options, Box(0.0, 0.0, 20.0, 20.0)).IsExact) << seed;
  }
  process.Activity = 1.0 / Pi;
  EXPECT_TRUE(SimulateProcess(process, {}, Box(0.0, 0.0, 20.0, 20.0)).IsExact);
}

TEST(PointProcesses, SpeciesShareClustersOrHaveTheirOwn)
{
  ProcessOptions options;
  options.SpeciesShares = { 1.0, 0.0, 3.0 };
  for (const SpeciesGrouping grouping : { SpeciesGrouping::Points, SpeciesGrouping::Clusters })
  {
    options.Grouping = grouping;
    const ProcessPattern pattern = SimulateProcess(Process(1), options, Box(0.0, 0.0, 6.0, 6.0));
    int counts[3] = { 0, 0, 0 };
    int mixed = 0;
    int siblings = 0;
    for (std::size_t n = 0; n < pattern.Points.size(); ++n)
    {
      ++counts[pattern.Species[n]];
      const bool areSiblings = n > 0 && pattern.Identities[n].Object == pattern.Identities[n - 1].Object &&
        pattern.Identities[n].Draw >> 32 == pattern.Identities[n - 1].Draw >> 32;
      siblings += areSiblings;
      mixed += areSiblings && pattern.Species[n] != pattern.Species[n - 1];
    }
    EXPECT_EQ(counts[1], 0);
    EXPECT_NEAR(counts[0] / static_cast<double>(pattern.Points.size()), 0.25, 0.05);
    const double wanted = grouping == SpeciesGrouping::Clusters ? 0.0 : 2.0 * 0.25 * 0.75;
    EXPECT_NEAR(mixed / static_cast<double>(siblings), wanted, wanted > 0.0 ? 0.04 : 0.0);
  }
}

TEST(PointProcesses, SpeciesOfStraussPointsAvoidEachOtherStrictly)
{
  ProcessOptions options;
  options.SpeciesShares = { 1.0, 1.0 };
  options.CrossInteraction = 0.0;
  PointProcessParameters process = Process(5);
  process.Interaction = 1.0;
  const ProcessPattern pattern = SimulateProcess(process, options, Box(0.0, 0.0, 1.0, 1.0));
  double same = 1.0;
  double other = 1.0;
  for (std::size_t a = 0; a < pattern.Points.size(); ++a)
  {
    for (std::size_t b = 0; b < a; ++b)
    {
      double& shortest = pattern.Species[a] == pattern.Species[b] ? same : other;
      shortest = std::min(shortest, SquareDistance(pattern.Points[a], pattern.Points[b]));
    }
  }
  EXPECT_GE(std::sqrt(other), process.Distance);
  EXPECT_LT(std::sqrt(same), 0.5 * process.Distance);
}

TEST(PointProcesses, MarksHaveTheirMomentsAndAreSharedInClusters)
{
  const ProcessPattern pattern = SimulateProcess(Process(1), {}, Box(0.0, 0.0, 20.0, 20.0));
  MarkOptions options;
  options.Mean = 20.0;
  options.Variation = 0.4;
  for (const double sharing : { 0.0, 1.0 })
  {
    options.ClusterCorrelation = sharing;
    const std::vector<double> marks = DrawMarks(pattern, options);
    Sample sample;
    int same = 0;
    for (std::size_t n = 0; n < marks.size(); ++n)
    {
      sample.Add(marks[n]);
      same += n > 0 && pattern.Identities[n].Object == pattern.Identities[n - 1].Object &&
        pattern.Identities[n].Draw >> 32 == pattern.Identities[n - 1].Draw >> 32 && marks[n] == marks[n - 1];
    }
    EXPECT_NEAR(sample.Mean(), 20.0, sharing > 0.0 ? 0.4 : 0.15);
    EXPECT_NEAR(sample.Error() * std::sqrt(sample.Count), 8.0, sharing > 0.0 ? 0.5 : 0.2);
    EXPECT_EQ(same > 20000, sharing == 1.0);
    EXPECT_EQ(same == 0, sharing == 0.0);
  }
}

// K is the integral of 2 pi r g.
TEST_P(AllProcesses, RipleyIsTheIntegralOfThePairCorrelation)
{
  const PointProcessParameters process = Process(GetParam());
  const std::vector<double> distances = { 0.0, 0.005, 0.02, 0.06, 0.11, 0.3 };
  const std::vector<double> k = RipleyK(process, distances);
  if (std::isnan(k[0]))
  {
    GTEST_SKIP() << "no closed form";
  }
  for (std::size_t n = 0; n < distances.size(); ++n)
  {
    double sum = 0.0;
    const double cuts[] = { 0.0, 0.04, 0.08, 0.16, 0.3 };
    for (int c = 0; c < 4; ++c)
    {
      const double high = std::min(distances[n], cuts[c + 1]);
      if (high > cuts[c])
      {
        sum += boost::math::quadrature::gauss_kronrod<double, 61>::integrate(
          [&](double r) { return TwoPi * r * PairCorrelation(process, r); }, cuts[c], high, 12, 1e-12);
      }
    }
    EXPECT_NEAR(k[n], sum, 1e-9) << distances[n];
  }
}

TEST(ClusterOffsets, AreThoseOfTheStandardLibrary)
{
  std::vector<double> u;
  std::vector<double> v;
  for (int n = 1; n < 4000; ++n)
  {
    u.push_back(n < 60 ? std::pow(2.0, -n) : n / 4000.0);
    v.push_back(std::fmod(n * 0.6180339887, 1.0));
  }
  std::vector<double> x = u;
  std::vector<double> y = v;
  MakeNormalOffsets(2.0, x.size(), x.data(), y.data());
  std::vector<double> logarithms = u;
  MakeLogarithms(u.size(), logarithms.data());
  std::vector<double> a = u;
  std::vector<double> b = v;
  MakeDiscOffsets(3.0, a.size(), a.data(), b.data());
  for (std::size_t n = 0; n < u.size(); ++n)
  {
    const double r = 2.0 * std::sqrt(-2.0 * std::log(std::exp(-18.0) + (1.0 - std::exp(-18.0)) * u[n]));
    EXPECT_NEAR(x[n], r * std::cos(TwoPi * v[n]), 1e-8);
    EXPECT_NEAR(y[n], r * std::sin(TwoPi * v[n]), 1e-8);
    EXPECT_NEAR(a[n], 3.0 * std::sqrt(u[n]) * std::cos(TwoPi * v[n]), 1e-8);
    EXPECT_NEAR(b[n], 3.0 * std::sqrt(u[n]) * std::sin(TwoPi * v[n]), 1e-8);
    EXPECT_NEAR(logarithms[n], std::log(u[n]), 1e-9 * std::max(1.0, -std::log(u[n])));
  }
}

TEST(PoissonCount, TableAndSumFollowTheLaw)
{
  for (const double mean : { 0.3, 4.0, 40.0, 300.0 })
  {
    const PoissonTable table(mean);
    const RandomStream random(3, RandomPurpose::ProcessCells);
    const boost::math::poisson law(mean);
    Sample sums;
    int wanted = 0;
    for (int n = 0; n < 3000; ++n)
    {
      const double u = (n + 0.5) / 3000.0;
      while (boost::math::cdf(law, wanted) <= u)
      {
        ++wanted;
      }
      ASSERT_EQ(table(u), wanted) << mean;
      sums.Add(static_cast<double>(PoissonCount(mean, random, static_cast<std::uint64_t>(n), 0)));
    }
    EXPECT_NEAR(sums.Mean(), mean, 3.5 * sums.Error());
    EXPECT_NEAR(sums.Error() * std::sqrt(3000.0), std::sqrt(mean), 0.05 * std::sqrt(mean));
  }
}

TEST_P(AllProcesses, EachParameterThatCountsIsCheckedAndTheOthersAreNot)
{
  const PointProcessParameters process = Process(GetParam());
  EXPECT_EQ(WhyInvalid(process), "");
  for (const auto* parameter : AllPointProcessParameters())
  {
    for (const double bad : { -1.0, std::numeric_limits<double>::quiet_NaN() })
    {
      PointProcessParameters broken = process;
      parameter->Set(broken, bad);
      const std::string reason = WhyInvalid(broken);
      EXPECT_EQ(reason.empty(), !TraitsOf(process.Process).Parameters.Has(parameter->Name)) << parameter->Name;
      EXPECT_TRUE(reason.empty() || reason.find(parameter->Name) == 0) << reason;
    }
  }
}

TEST(PointProcesses, WhatCannotBeIsNamed)
{
  const ObservationWindow window = Box(0.0, 0.0, 1.0, 1.0);
  const auto reason = [&](int id, auto spoil) {
    PointProcessParameters process = Process(id);
    ProcessOptions options;
    spoil(process, options);
    return WhyInvalid(process, options, window);
  };
  const auto names = [](const std::string& text, const char* word) { return text.find(word) != std::string::npos; };
  EXPECT_TRUE(names(reason(9, [](auto&, auto&) {}), "Process"));
  EXPECT_TRUE(names(reason(5, [](auto& p, auto&) { p.Interaction = 1.2; }), "Interaction is 1.2"));
  EXPECT_TRUE(names(reason(4, [](auto& p, auto&) { p.Intensity = 250.0; }), "pi Distance^2"));
  EXPECT_TRUE(names(reason(0, [](auto& p, auto&) { p.Intensity = 1e12; }), "draws"));
  EXPECT_TRUE(names(reason(5, [](auto& p, auto&) { p.Activity = 1e7; }), "draws"));
  EXPECT_TRUE(names(reason(1, [](auto& p, auto&) { p.ClusterScale = 1e6; }), "draws"));
  EXPECT_TRUE(names(reason(3, [](auto& p, auto&) { p.Range = 1e-4; }), "draws"));
  EXPECT_TRUE(names(reason(0, [](auto&, auto& o) { o.SpeciesShares = { 0.0, 0.0 }; }), "species"));
  EXPECT_TRUE(names(reason(0, [](auto&, auto& o) { o.SpeciesShares = { 1.0, -1.0 }; }), "species"));
  EXPECT_TRUE(names(reason(5, [](auto&, auto& o) { o.CrossInteraction = 2.0; }), "CrossInteraction"));
  IntensityRaster raster = Thirds();
  const auto withRaster = [&](int id) { return reason(id, [&](auto&, auto& o) { o.Raster = &raster; }); };
  EXPECT_EQ(withRaster(0), "");
  raster.Values[2] = -1.0;
  EXPECT_TRUE(names(withRaster(0), "Intensity of the image is -1"));
  raster.Values.assign(6, 0.0);
  EXPECT_TRUE(names(withRaster(0), "0 everywhere"));
  raster.Values = { 0.0, 0.0, 0.0, 0.0, 0.0, 1.0 };
  EXPECT_TRUE(names(withRaster(4), "highest"));
  const ObservationWindow far = Box(1e12, 0.0, 1e12 + 1.0, 1.0);
  EXPECT_TRUE(names(WhyInvalid(Process(0), {}, far), "origin"));
  MarkOptions marks;
  marks.ClusterCorrelation = 2.0;
  EXPECT_TRUE(names(WhyInvalid(marks), "MarkClusterCorrelation"));
}

INSTANTIATE_TEST_SUITE_P(PointProcesses, AllProcesses, ::testing::Range(0, NumberOfPointProcesses),
  [](const auto& one) { return PointProcessName(static_cast<PointProcess>(one.param)); });
