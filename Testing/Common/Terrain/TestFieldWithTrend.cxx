// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "../OnThreads.h"
#include "Terrain/FieldWithTrend.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace littoral;
using littoral::testing::OnThreads;

namespace
{

constexpr PlaneGrid Grid{ { 100.0, -40.0 }, { 2.0, 3.0 } };
constexpr GridWindow Whole{ { -3, 5 }, { 156, 304 } };

TurningBandsParameters Parameters()
{
  TurningBandsParameters parameters;
  parameters.Field.Model = CovarianceModel::SimpleExponential;
  parameters.Field.Range = 60.0;
  parameters.Field.Variance = 25.0;
  parameters.MinimumWavelength = 20.0;
  parameters.NumberOfLines = 64;
  return parameters;
}

std::vector<float> Grow(const FieldTrend& trend, const GridWindow& window, const ParallelFor& parallel = SerialFor)
{
  FieldWithTrend field(Parameters(), trend, Grid, Whole, window);
  field.Tabulate(parallel);
  const int width = window.Last[0] - window.First[0] + 1;
  const int height = window.Last[1] - window.First[1] + 1;
  std::vector<float> values(static_cast<std::size_t>(width) * height);
  field.Fill(values.data(), parallel);
  return values;
}

/// The plane that fits a whole field best.
PlaneTrend PlaneOf(const std::vector<float>& values)
{
  GridSamples samples;
  samples.Width = Whole.Last[0] - Whole.First[0] + 1;
  samples.Height = Whole.Last[1] - Whole.First[1] + 1;
  samples.Spacing = Grid.Spacing;
  samples.Values.assign(values.begin(), values.end());
  return RemovePlane(samples);
}

}

// Mean and slope are added to the field, about the middle of the whole grid.
TEST(FieldWithTrend, IsFieldPlusPlane)
{
  const std::vector<float> field = Grow({}, Whole);
  const std::vector<float> trended = Grow({ 10.0, { 0.5, -0.25 } }, Whole);
  std::size_t point = 0;
  for (int j = Whole.First[1]; j <= Whole.Last[1]; ++j)
  {
    for (int i = Whole.First[0]; i <= Whole.Last[0]; ++i, ++point)
    {
      const double plane = 10.0 + 0.5 * 2.0 * (i - 76.5) - 0.25 * 3.0 * (j - 154.5);
      ASSERT_NEAR(trended[point], field[point] + plane, 2e-4) << i << " " << j;
    }
  }
}

// With sides the given plane is all there is: the one that fits the values best.
TEST(FieldWithTrend, OwnPlaneMakesRoom)
{
  const PlaneTrend own = PlaneOf(Grow({ 10.0, { 0.01, -0.02 } }, Whole));
  EXPECT_GT(std::abs(own.Mean - 10.0), 0.05);
  const PlaneTrend given = PlaneOf(Grow({ 10.0, { 0.01, -0.02 }, { 1.0, 1.0 } }, Whole)); // widened to the grid
  EXPECT_NEAR(given.Mean, 10.0, 0.02);
  EXPECT_NEAR(given.Slope[0], 0.01, 2e-4);
  EXPECT_NEAR(given.Slope[1], -0.02, 2e-4);
}

// A rectangle beyond the grid: the plane is that of more ground than is there.
TEST(FieldWithTrend, WiderRectangleLeavesSomePlane)
{
  const FieldTrend wide{ 0.0, { 0.0, 0.0 }, { 4000.0, 9000.0 } };
  const PlaneTrend left = PlaneOf(Grow(wide, Whole));
  EXPECT_GT(std::abs(left.Mean), 0.05);
}

TEST(FieldWithTrend, WindowsAndThreadsMakeNoDifference)
{
  const FieldTrend trend{ 10.0, { 0.01, -0.02 }, { 500.0, 100.0 } };
  const std::vector<float> whole = Grow(trend, Whole);
  EXPECT_EQ(whole, Grow(trend, Whole, OnThreads(3)));
  const GridWindow part{ { 20, 100 }, { 29, 240 } };
  const std::vector<float> own = Grow(trend, part);
  std::size_t point = 0;
  for (int j = part.First[1]; j <= part.Last[1]; ++j)
  {
    for (int i = part.First[0]; i <= part.Last[0]; ++i, ++point)
    {
      const int width = Whole.Last[0] - Whole.First[0] + 1;
      ASSERT_EQ(own[point], whole[static_cast<std::size_t>(j - Whole.First[1]) * width + (i - Whole.First[0])]);
    }
  }
}
