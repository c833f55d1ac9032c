// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "../Drainage/RandomGround.h"
#include "../OnThreads.h"
#include "Drainage/DepressionFilling.h"
#include "Drainage/FlowRouting.h"
#include "Landscapes/BlockInterpolation.h"
#include "Landscapes/LandscapeMeasures.h"
#include "Landscapes/LongWaves.h"
#include "Landscapes/TerrainZoom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace littoral;
using namespace littoral::testing;

namespace
{

/// Hills and winding valleys that fall to the south, in cells of `spacing` [m]: known at every scale.
GridSamples Valleys(int width, int height, double spacing)
{
  return Ground(width, height, { spacing, spacing }, [](double x, double y) {
    const double side = std::sin(x / 170.0 + 0.8 * std::sin(y / 400.0));
    const double along = std::sin(y / 110.0 + 0.7 * std::sin(x / 300.0));
    return 0.1 * y + 60.0 * std::abs(side) + 25.0 * std::abs(along);
  });
}

/// Cells through which `least` others drain.
std::vector<std::size_t> ChannelsOf(const GridSamples& ground, CellIndex least)
{
  const FlowRouting routing = RouteFlow(ground, BorderOutlets(ground.Width, ground.Height));
  const std::vector<CellIndex> cells = FlowAccumulation(routing);
  std::vector<std::size_t> channels;
  for (std::size_t n = 0; n < cells.size(); ++n)
  {
    if (cells[n] >= least)
    {
      channels.push_back(n);
    }
  }
  return channels;
}

/// Root mean square of the distances of channels to the nearest ones of another ground [cells].
double OffsetOf(const GridSamples& ground, const GridSamples& truth, CellIndex least)
{
  const std::vector<std::size_t> there = ChannelsOf(truth, least);
  const std::vector<std::size_t> here = ChannelsOf(ground, least);
  const auto side = [&](std::size_t n, std::size_t m) {
    const std::size_t width = static_cast<std::size_t>(truth.Width);
    return std::pow(static_cast<double>(n % width) - static_cast<double>(m % width), 2) +
      std::pow(static_cast<double>(n / width) - static_cast<double>(m / width), 2);
  };
  double sum = 0.0;
  for (const std::size_t n : here)
  {
    double nearest = std::numeric_limits<double>::infinity();
    for (const std::size_t m : there)
    {
      nearest = std::min(nearest, side(n, m));
    }
    sum += nearest;
  }
  return std::sqrt(sum / static_cast<double>(here.size()));
}

std::size_t SunkCells(const GridSamples& ground)
{
  return FloodDepressions(ground, BorderOutlets(ground.Width, ground.Height)).DepressionCells;
}

}

TEST(BlockInterpolation, QuadraticSurfacesStay)
{
  const auto bowl = [](double x, double y) { return 3.0 + x - 2.0 * y + 0.5 * x * x - 0.25 * x * y + y * y; };
  const GridSamples coarse = Ground(9, 8, { 5.0, 10.0 }, bowl);
  const GridSamples fine = CubicRefinement(coarse, 5, OnThreads(3));
  ASSERT_EQ(fine.Width, 45);
  ASSERT_EQ(fine.Height, 40);
  EXPECT_EQ(fine.Spacing[1], 2.0);
  for (int j = 10; j < 30; ++j)
  {
    for (int i = 10; i < 35; ++i)
    {
      EXPECT_NEAR(fine.At(i, j), bowl(i - 2.0, 2.0 * (j - 2.0)), 1e-9);
    }
  }
  // planes stay at the edges, too
  const GridSamples plane = Ground(3, 4, { 3.0, 3.0 }, [](double x, double y) { return 2.0 * x + y; });
  EXPECT_NEAR(CubicRefinement(plane, 3).At(0, 11), -2.0 + 10.0, 1e-12);
}

TEST(BlockInterpolation, MeansOfBlocksAreHeld)
{
  GridSamples coarse = Ground(11, 11, { 1.0, 1.0 }, [](double, double) { return 0.0; });
  coarse.At(5, 5) = 1.0;
  GridSamples fine = CubicRefinement(coarse, 3);
  const double missing = 1.0 - BlockMeans(fine, 3).At(5, 5);
  EXPECT_GT(missing, 0.05);
  HoldBlockMeans(fine, coarse, 3, 8);
  const GridSamples means = BlockMeans(fine, 3);
  for (std::size_t n = 0; n < means.Values.size(); ++n)
  {
    EXPECT_NEAR(means.Values[n], coarse.Values[n], missing / 300.0);
  }
}

TEST(BlockInterpolation, ShiftsEndAtTheirLimits)
{
  const GridSamples coarse = Ground(4, 3, { 1.0, 1.0 }, [](double x, double) { return x; });
  GridSamples fine = CubicRefinement(coarse, 2);
  fine.At(2, 2) += 40.0;
  fine.At(5, 5) -= 4.0;
  LimitBlockShifts(fine, coarse, 2, std::vector<double>(12, 1.5));
  const GridSamples means = BlockMeans(fine, 2);
  EXPECT_NEAR(means.At(1, 1), 1.0 + 1.5, 1e-12);
  EXPECT_NEAR(means.At(2, 2), 2.0 - 1.0, 1e-12);
  EXPECT_NEAR(fine.At(2, 2) - fine.At(3, 3), 40.0 - 0.5, 1e-12);
}

TEST(TerrainZoom, LawIsThatOfTheCoarseGround)
{
  const GridSamples coarse = Ground(9, 8, { 50.0, 20.0 }, [](double x, double) { return x; });
  LandscapeMeasures measures;
  measures.MeanSlope = 0.2;
  measures.Slopes.assign(2001, 0.5);
  measures.Slopes.back() = 9.0; // a single cliff
  measures.CurvatureDeviation = 1e-3;
  measures.Concavity = 0.5;
  measures.ChannelSlope = 0.01;
  const LandscapeLaw law = LawForZoom(coarse, measures);
  // a river of 500 cells of 1000 m^2 is at rest at 0.01, K A^m S = U = 1
  EXPECT_NEAR(law.Erodibility * std::sqrt(500e3) * 0.01, 1.0, 1e-12);
  EXPECT_NEAR(law.Diffusivity, 1000.0 / 90.0, 1e-9);
  EXPECT_NEAR(law.ThresholdSlope, 1.5, 1e-12);
  EXPECT_NEAR(law.MinimumSlope, 4e-4, 1e-12);
  measures.Concavity = std::numeric_limits<double>::quiet_NaN();
  const LandscapeLaw usual = LawForZoom(coarse, measures);
  EXPECT_NEAR(usual.Erodibility * std::pow(500e3, 0.45) * 0.06, 1.0, 1e-12);
}

TEST(TerrainZoom, GivesBackValleysAndSlopesThatBlocksHaveLost)
{
  const GridSamples truth = Valleys(120, 99, 30.0);
  const GridSamples coarse = BlockMeans(truth, 3);
  const GridSamples cubic = CubicRefinement(coarse, 3);
  const ZoomedTerrain zoomed = ZoomTerrain(coarse, {});
  EXPECT_GT(SunkCells(cubic), 0u);
  EXPECT_EQ(SunkCells(zoomed.Heights), 0u);
  const double offset = OffsetOf(zoomed.Heights, truth, 300);
  EXPECT_LT(offset, OffsetOf(cubic, truth, 300));
  EXPECT_LT(offset, 0.65); // a cell has its middle 0.41 cells from its points
  const LandscapeMeasures is = MeasureLandscape(zoomed.Heights);
  const LandscapeMeasures shall = MeasureLandscape(truth);
  EXPECT_NEAR(is.MeanSlope / shall.MeanSlope, 1.0, 0.05);
  const LandscapeMeasures lost = MeasureLandscape(cubic);
  EXPECT_LT(KolmogorovDistance(is.Slopes, shall.Slopes), 0.5 * KolmogorovDistance(lost.Slopes, shall.Slopes));
}

TEST(TerrainZoom, NoCoarseHeightMovesFurtherThanItsShareOfTheRelief)
{
  const GridSamples coarse = RandomGround(16, 14, { 90.0, 90.0 }, 5);
  const std::vector<double> relief = ReliefAround(coarse);
  for (const double share : { 0.0, 0.02, 1.0 })
  {
    ZoomParameters parameters;
    parameters.Factor = 4;
    parameters.MaximumShift = share;
    const ZoomedTerrain zoomed = ZoomTerrain(coarse, parameters);
    const GridSamples means = BlockMeans(zoomed.Heights, 4);
    double most = 0.0;
    for (std::size_t n = 0; n < relief.size(); ++n)
    {
      most = std::max(most, std::abs(means.Values[n] - coarse.Values[n]) / relief[n]);
    }
    EXPECT_LE(most, share + 1e-9);
    EXPECT_NEAR(zoomed.LargestShare, most, 1e-9);
    EXPECT_EQ(SunkCells(zoomed.Heights) == 0, share == 1.0);
  }
  EXPECT_EQ(ReliefAround(Ground(4, 4, { 1.0, 1.0 }, [](double x, double y) { return x + 10.0 * y; }))[5], 22.0);
}

TEST(TerrainZoom, PlanesStayWithoutGrowth)
{
  const GridSamples coarse = Ground(5, 4, { 60.0, 60.0 }, [](double x, double y) { return 0.2 * x - 0.1 * y; });
  ZoomParameters parameters;
  parameters.Factor = 6;
  parameters.Growth = 0.0;
  const GridSamples fine = ZoomTerrain(coarse, parameters).Heights;
  for (int j = 0; j < fine.Height; ++j)
  {
    for (int i = 0; i < fine.Width; ++i)
    {
      EXPECT_NEAR(fine.At(i, j), 0.2 * (10.0 * i - 25.0) - 0.1 * (10.0 * j - 25.0), 1e-9);
    }
  }
}

TEST(TerrainZoom, NothingGrowsWithoutSlopes)
{
  const auto stripes = [](double x, double) { return 5.0 * std::fmod(std::round(x / 10.0), 2.0); };
  const auto pit = [](double x, double y) { return x == 10.0 && y == 10.0 ? -100.0 : 5.0; };
  for (const GridSamples& coarse : { Ground(7, 6, { 10.0, 10.0 }, stripes), Ground(3, 3, { 10.0, 10.0 }, pit) })
  {
    ZoomParameters parameters;
    const GridSamples grown = ZoomTerrain(coarse, parameters).Heights;
    parameters.Growth = 0.0;
    EXPECT_EQ(grown.Values, ZoomTerrain(coarse, parameters).Heights.Values);
  }
}

TEST(TerrainZoom, SameBytesOnAnyThreadsAndHolesStay)
{
  GridSamples coarse = BlockMeans(Valleys(60, 48, 30.0), 3);
  const auto isHole = [](int i, int j) { return (i - 8) * (i - 8) + (j - 8) * (j - 8) < 10; };
  for (int n = 0; n < 20 * 16; ++n)
  {
    coarse.Values[n] = isHole(n % 20, n / 20) ? std::numeric_limits<double>::quiet_NaN() : coarse.Values[n];
  }
  ZoomParameters parameters;
  parameters.Factor = 2;
  const GridSamples one = ZoomTerrain(coarse, parameters).Heights;
  const GridSamples three = ZoomTerrain(coarse, parameters, OnThreads(3)).Heights;
  parameters.Seed = 2;
  const GridSamples other = ZoomTerrain(coarse, parameters).Heights;
  EXPECT_NE(one.At(35, 28), other.At(35, 28));
  for (int j = 0; j < one.Height; ++j)
  {
    for (int i = 0; i < one.Width; ++i)
    {
      EXPECT_EQ(std::isnan(one.At(i, j)), isHole(i / 2, j / 2));
      EXPECT_TRUE(std::isnan(one.At(i, j)) || one.At(i, j) == three.At(i, j));
    }
  }
}

TEST(TerrainZoom, RefusesWhatHasNoFinerGround)
{
  GridSamples ground = RandomGround(6, 5, { 50.0, 50.0 }, 5);
  EXPECT_EQ(WhyInvalid(ground, ZoomParameters{}), "");
  ZoomParameters parameters;
  parameters.Factor = 1;
  EXPECT_EQ(WhyInvalid(ground, parameters), "Factor is 1; it must be from 2 to 16.");
  EXPECT_EQ(WhyInvalid(RandomGround(2, 2, { 50.0, 50.0 }, 5), ZoomParameters{}),
    "The terrain has fewer than 3 rows or columns; no slope can be measured there.");
  ground.Values.assign(30, 7.0);
  EXPECT_EQ(WhyInvalid(ground, ZoomParameters{}), "The terrain is constant; water has no way to run there.");
  ground.Values.assign(30, std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(WhyInvalid(ground, ZoomParameters{}), "The terrain has no heights.");
}
