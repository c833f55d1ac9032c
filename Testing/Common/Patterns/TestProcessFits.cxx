// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "../OnThreads.h"
#include "MappedPatterns.h"
#include "Numerics/Constants.h"
#include "Patterns/CurveEnvelope.h"
#include "Patterns/ProcessFit.h"
#include "Patterns/ProcessPattern.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace littoral;
using littoral::testing::Mapped;

namespace
{

ObservationWindow RedwoodWindow()
{
  return ObservationWindow::Rectangle({ 0.0, -1.0 }, { 1.0, 0.0 });
}

void ExpectWithin(double value, double wanted, double part)
{
  EXPECT_NEAR(value, wanted, part * wanted);
}

}

// The same functions, distances and powers as kppm of spatstat 3.0-3: kappa, scale and mu of the clusters, variance and
// range of the Cox process.
TEST(ProcessFits, RedwoodIsThatOfSpatstat)
{
  const std::vector<PlanePosition> points = Mapped("redwood");
  ASSERT_EQ(points.size(), 62u);
  struct Known
  {
    PointProcess Process;
    ContrastFunction Function;
    double First;
    double Length;
    double Tolerance = 0.02;
  };
  // Near 0 the estimate of g hangs on its kernel, and a Cox process is the only one with a peak there.
  const Known known[] = {
    { PointProcess::Thomas, ContrastFunction::Ripley, 23.5485685, 0.0470515 },
    { PointProcess::Thomas, ContrastFunction::PairCorrelation, 24.2512030, 0.0400641 },
    { PointProcess::MaternCluster, ContrastFunction::Ripley, 24.5586513, 0.0865358 },
    { PointProcess::MaternCluster, ContrastFunction::PairCorrelation, 23.3638243, 0.0793948 },
    { PointProcess::LogGaussianCox, ContrastFunction::Ripley, 1.048252, 0.099821 },
    { PointProcess::LogGaussianCox, ContrastFunction::PairCorrelation, 1.3156293, 0.0724714, 0.03 },
  };
  for (const Known& each : known)
  {
    ContrastOptions options;
    options.Function = each.Function;
    const ProcessFit fit = FitProcess(each.Process, points, RedwoodWindow(), options);
    ASSERT_TRUE(fit.Exists);
    SCOPED_TRACE(
      std::string(PointProcessName(each.Process)) + (each.Function == ContrastFunction::Ripley ? " K" : " g"));
    const bool isCox = each.Process == PointProcess::LogGaussianCox;
    ExpectWithin(isCox ? fit.Process.Variance : ParentIntensity(fit.Process), each.First, each.Tolerance);
    ExpectWithin(isCox ? fit.Process.Range : fit.Process.ClusterScale, each.Length, each.Tolerance);
    EXPECT_DOUBLE_EQ(fit.Process.Intensity, 62.0);
    if (!isCox)
    {
      ExpectWithin(fit.Process.ClusterSize, 62.0 / each.First, each.Tolerance);
    }
  }
}

// The contrast is the integral of a squared difference of powers q of K: of a length to 4 q + 1, here 2.
TEST(ProcessFits, ContrastsAreOfTheirUnit)
{
  std::vector<PlanePosition> points = Mapped("redwood");
  const ProcessFit own = FitProcess(PointProcess::Thomas, points, RedwoodWindow(), {});
  for (PlanePosition& point : points)
  {
    point = { 10.0 * point[0], 10.0 * point[1] };
  }
  const auto window = ObservationWindow::Rectangle({ 0.0, -10.0 }, { 10.0, 0.0 });
  const ProcessFit wide = FitProcess(PointProcess::Thomas, points, window, {});
  EXPECT_NEAR(wide.Contrast / own.Contrast, 100.0, 0.01);
  EXPECT_NEAR(wide.Process.ClusterScale / own.Process.ClusterScale, 10.0, 1e-3);
}

// Strauss process of cells with the distance 0.1 and border 0.1: ppm of spatstat 3.2 (nd = 256) gives the activity 2380
// and the interaction 0.00242; its sums differ by their dummy points.
TEST(ProcessFits, CellsAreThoseOfSpatstat)
{
  const std::vector<PlanePosition> points = Mapped("cells");
  const ProcessFit fit = FitStrauss(points, ObservationWindow(), 0.1, 0.1);
  ASSERT_TRUE(fit.Exists);
  ExpectWithin(fit.Process.Activity, 2380.0, 0.1);
  ExpectWithin(fit.Process.Interaction, 0.00242, 0.1);
  const ProcessFit best = FitProcess(PointProcess::Strauss, points, ObservationWindow(), {});
  EXPECT_GT(best.LogPseudoLikelihood, FitStrauss(points, ObservationWindow(), 0.06, 0.1066).LogPseudoLikelihood);
  EXPECT_NEAR(best.Process.Distance, 0.105, 0.01); // profilepl, in steps of 0.005
  const ProcessFit inhibited = FitProcess(PointProcess::MaternII, points, ObservationWindow(), {});
  EXPECT_NEAR(inhibited.Process.Distance, 0.0836 * 42.0 / 43.0, 0.001);
}

// Distances beyond the mean distance to the nearest point are found: of 71 points in 96 x 100 that of 9, within 5 % in
// 8 of 10 patterns, with parameters that are right in the middle.
TEST(ProcessFits, LongStraussDistancesAreFound)
{
  PointProcessParameters process;
  process.Process = PointProcess::Strauss;
  process.Distance = 9.0;
  process.Interaction = 0.26445;
  process.Activity = 0.054583;
  const ObservationWindow window = ObservationWindow::Rectangle({ 0.0, 0.0 }, { 96.0, 100.0 });
  int found = 0;
  std::vector<double> activities;
  std::vector<double> interactions;
  for (int seed = 1; seed <= 10; ++seed)
  {
    ProcessOptions options;
    options.Seed = seed;
    const std::vector<PlanePosition> points = SimulateProcess(process, options, window).Points;
    const ProcessFit fit = FitProcess(PointProcess::Strauss, points, window, {});
    ASSERT_TRUE(fit.Exists);
    const double own = fit.Process.Distance;
    EXPECT_EQ(fit.Process.Activity, FitStrauss(points, window, own, own).Process.Activity);
    found += std::abs(fit.Process.Distance - process.Distance) < 0.05 * process.Distance;
    activities.push_back(fit.Process.Activity);
    interactions.push_back(fit.Process.Interaction);
  }
  EXPECT_GE(found, 8);
  const auto middle = [](std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return 0.5 * (values[4] + values[5]);
  };
  ExpectWithin(middle(activities), process.Activity, 0.2);
  ExpectWithin(middle(interactions), process.Interaction, 0.2);
}

// A Cox process finds no thickets between the points: neither in random ones nor in regular ones.
TEST(ProcessFits, RangesAreBoundedBySpacing)
{
  const ObservationWindow window = ObservationWindow::Rectangle({ 0.0, 0.0 }, { 96.0, 100.0 });
  ContrastOptions options;
  for (const ContrastFunction function : { ContrastFunction::Ripley, ContrastFunction::PairCorrelation })
  {
    options.Function = function;
    for (int seed = 1; seed <= 8; ++seed)
    {
      const std::vector<PlanePosition> points = UniformPattern(window, 40, seed, 0);
      const ProcessFit fit = FitProcess(PointProcess::LogGaussianCox, points, window, options);
      EXPECT_TRUE(!fit.Exists || fit.Process.Range > 0.25 * std::sqrt(9600.0 / 40.0)) << fit.Process.Range;
    }
  }
}

// What was simulated is found again: means of 20 fits within 15 %.
TEST(ProcessFits, SimulatedProcessesAreFoundAgain)
{
  PointProcessParameters process;
  process.Intensity = 400.0;
  process.ClusterSize = 6.0;
  process.ClusterScale = 0.03;
  process.Variance = 1.0;
  process.Range = 0.05;
  process.Distance = 0.03;
  process.Activity = 400.0;
  process.Interaction = 0.3;
  for (const PointProcess id :
    { PointProcess::Thomas, PointProcess::MaternCluster, PointProcess::LogGaussianCox, PointProcess::Strauss })
  {
    process.Process = id;
    double first = 0.0;
    double length = 0.0;
    const int seeds = 20;
    for (int seed = 1; seed <= seeds; ++seed)
    {
      ProcessOptions options;
      options.Seed = seed;
      const std::vector<PlanePosition> points = SimulateProcess(process, options, ObservationWindow()).Points;
      const ProcessFit fit = id == PointProcess::Strauss ? FitStrauss(points, ObservationWindow(), 0.03, 0.03)
                                                         : FitProcess(id, points, ObservationWindow(), {});
      ASSERT_TRUE(fit.Exists) << seed;
      first += std::log(id == PointProcess::LogGaussianCox ? fit.Process.Variance
                   : id == PointProcess::Strauss           ? fit.Process.Activity
                                                           : fit.Process.ClusterSize) /
        seeds;
      length += std::log(id == PointProcess::LogGaussianCox ? fit.Process.Range
                    : id == PointProcess::Strauss           ? fit.Process.Interaction
                                                            : fit.Process.ClusterScale) /
        seeds;
    }
    SCOPED_TRACE(PointProcessName(id));
    const double wanted = id == PointProcess::LogGaussianCox ? 1.0 : id == PointProcess::Strauss ? 400.0 : 6.0;
    const double wantedLength = id == PointProcess::LogGaussianCox ? 0.05 : id == PointProcess::Strauss ? 0.3 : 0.03;
    EXPECT_NEAR(first, std::log(wanted), 0.15);
    EXPECT_NEAR(length, std::log(wantedLength), 0.15);
  }
}

TEST(ProcessFits, RegularPointsHaveNoClustersAndClustersNoInhibition)
{
  const std::vector<PlanePosition> cells = Mapped("cells");
  EXPECT_FALSE(FitProcess(PointProcess::Thomas, cells, ObservationWindow(), {}).Exists);
  EXPECT_FALSE(FitProcess(PointProcess::LogGaussianCox, cells, ObservationWindow(), {}).Exists);
  EXPECT_FALSE(FitStrauss(Mapped("redwood"), RedwoodWindow(), 0.06, 0.06).Exists);
}

TEST(ProcessFits, SameBytesOnAnyThreads)
{
  const std::vector<PlanePosition> points = Mapped("redwood");
  for (int id = 0; id < NumberOfPointProcesses; ++id)
  {
    const auto process = static_cast<PointProcess>(id);
    const ProcessFit one = FitProcess(process, points, RedwoodWindow(), {});
    const ProcessFit two = FitProcess(process, points, RedwoodWindow(), {}, littoral::testing::OnThreads(3));
    for (const auto* parameter : AllPointProcessParameters())
    {
      EXPECT_EQ(parameter->Get(one.Process), parameter->Get(two.Process)) << parameter->Name;
    }
  }
}

TEST(ProcessFits, OptionsThatCannotBeAreNamed)
{
  ContrastOptions options;
  EXPECT_EQ(WhyInvalid(options), "");
  options.Power = 0.0;
  EXPECT_NE(WhyInvalid(options).find("Power"), std::string::npos);
  options = {};
  options.MaximumDistance = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(WhyInvalid(options).find("MaximumDistance"), std::string::npos);
  options = {};
  options.Function = ContrastFunction::PairCorrelation;
  options.Correction = EdgeCorrection::Border;
  EXPECT_NE(WhyInvalid(options).find("border"), std::string::npos);
}
