// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Given rivers, ridges and heights: on grids, on meshes, and in ground that grows.
#include "../Drainage/RandomGround.h"
#include "../Drainage/RiverGround.h"
#include "../OnThreads.h"
#include "Drainage/DepressionFilling.h"
#include "Drainage/FlowRouting.h"
#include "Drainage/ValleySpreading.h"
#include "Landscapes/CourseWaves.h"
#include "Landscapes/GivenGround.h"
#include "Landscapes/GridCourses.h"
#include "Landscapes/HeightCorrection.h"
#include "Landscapes/LandscapeGrowth.h"
#include "Landscapes/MeshCourses.h"
#include "Landscapes/MeshDrainage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

using namespace littoral;
using namespace littoral::testing;

namespace
{

/// A bent river that leaves to the east, its tributary, and a ridge that stays north of both.
GivenGround Sketch()
{
  GivenGround given;
  given.Rivers.push_back({ { { 8.0, 10.0 }, { 30.0, 18.0 }, { 59.0, 12.3 } }, {} });
  given.Rivers.push_back({ { { 20.0, 3.0 }, { 30.0, 18.0 } }, {} });
  given.Ridges.push_back({ { { 6.0, 27.0 }, { 28.0, 31.0 }, { 52.0, 22.0 } }, {} });
  return given;
}

std::vector<CellIndex> CellsOf(const GivenLine& line, int width, int height)
{
  std::vector<CellIndex> cells;
  for (const LineCell& piece : CellsAlong(line, width, height, { 1.0, 1.0 }))
  {
    cells.push_back(piece.Cell);
  }
  return cells;
}

}

TEST(GivenGround, LinesAreChainsOfCellsWithTheirHeights)
{
  const GivenLine line{ { { 1.0, 2.0 }, { 21.0, 7.0 }, { 24.0, 30.0 } }, { 100.0, 80.0, 34.0 } };
  const std::vector<LineCell> pieces = CellsAlong(line, 40, 35, { 1.0, 1.0 });
  // as many as the longer sides have steps, since no corner is taken, nor the one of the bend
  ASSERT_EQ(pieces.size(), 20u + 23u);
  for (std::size_t n = 0; n < pieces.size(); ++n)
  {
    const int i = pieces[n].Cell % 40;
    const int j = pieces[n].Cell / 40;
    const std::array<double, 2>& place = pieces[n].Middle.Place;
    EXPECT_LE(std::max(std::abs(place[0] - i), std::abs(place[1] - j)), 0.5);
    // 1 m for a step along x, then 2 m for one along y
    EXPECT_NEAR(pieces[n].Middle.Height, j < 7 ? 101.0 - place[0] : 94.0 - 2.0 * place[1], j == 7 ? 1.0 : 1e-9);
    EXPECT_TRUE(n == 0 || std::abs(i - pieces[n - 1].Cell % 40) <= 1);
    EXPECT_TRUE(n == 0 || std::abs(j - pieces[n - 1].Cell / 40) <= 1);
  }
}

TEST(GivenGround, RefusesWhatCannotBe)
{
  const GridSamples terrain = RandomGround(60, 40, { 1.0, 1.0 }, 5);
  EXPECT_EQ(WhyInvalid(terrain, Sketch()), "");
  GivenGround given = Sketch();
  given.Ridges[0].Places[1] = { 29.0, 5.0 };
  EXPECT_EQ(WhyInvalid(terrain, given), "A river crosses a ridge, between 8, 10 and 30, 18 m from the first point.");
  given = Sketch();
  given.Rivers[0].Places[1][0] = 60.0;
  EXPECT_EQ(
    WhyInvalid(terrain, given), "A place that is given is outside of the terrain, at 60, 18 m from its first point.");
  given.Rivers[0].Places[1][0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(WhyInvalid(terrain, given), "A place or height that is given is not finite.");
  given = Sketch();
  given.Rivers[1].Heights = { 10.0, 10.5 };
  EXPECT_EQ(WhyInvalid(terrain, given),
    "A river runs uphill, from 10 m to 10.5 m at 30, 18 m from the first point; rivers go from their upper to their "
    "lower ends.");
  given.Rivers[1].Heights = { 10.0 };
  EXPECT_EQ(WhyInvalid(terrain, given), "A line has another number of heights than of points.");
  given = Sketch();
  given.Ridges[0].Places.resize(1);
  EXPECT_EQ(WhyInvalid(terrain, given), "A line that is given has fewer than two points.");
}

TEST(GivenGround, WaterOfAMeshFollowsRiversAndCrossesNoRidge)
{
  const GridSamples terrain = RandomGround(60, 40, { 1.0, 1.0 }, 5);
  const GivenGround given = Sketch();
  const PointMesh mesh = JitteredMesh(60, 40, { 1.0, 1.0 }, 3, 1, PointsOnLines(given, 60, 40, { 1.0, 1.0 }));
  const MeshCourses courses = CoursesOn(mesh, given);
  for (const bool isCarved : { false, true })
  {
    std::vector<double> heights = terrain.Values;
    if (isCarved)
    {
      CarveCourses(mesh, courses, 1e-6, heights);
    }
    const MeshDrainage drainage = DrainMesh(mesh, heights, SerialFor, courses);
    double out = 0.0;
    double all = 0.0;
    for (CellIndex n = 0; n < mesh.Count(); ++n)
    {
      out += mesh.IsRim(n) ? drainage.Area[n] : 0.0;
      all += mesh.Area[n];
      EXPECT_TRUE(courses.Link[n] < 0 || drainage.Link[n] == courses.Link[n]);
      EXPECT_TRUE(!courses.IsRidge[n] || drainage.Area[n] == mesh.Area[n]);
    }
    ASSERT_EQ(drainage.Order.size(), mesh.Points.size());
    EXPECT_NEAR(out, all, 1e-9 * all);
    // the tributary's water comes out of the river, at its lower end
    const CellIndex mouth = CellsOf(given.Rivers[0], 60, 40).back();
    EXPECT_GT(drainage.Area[mouth], drainage.Area[CellsOf(given.Rivers[1], 60, 40)[14]]);
  }
}

TEST(GivenGround, EnclosedWaterLeavesAndCirclesEnd)
{
  const GridSamples terrain = RandomGround(60, 40, { 1.0, 1.0 }, 5);
  GivenGround given;
  // a ridge all around, and rivers that run into each other within it
  given.Ridges.push_back({ { { 10, 10 }, { 50, 10 }, { 50, 30 }, { 10, 30 }, { 10, 10 } }, {} });
  given.Rivers.push_back({ { { 20, 15 }, { 40, 15 }, { 40, 25 } }, {} });
  given.Rivers.push_back({ { { 40, 25 }, { 20, 25 }, { 20, 15 } }, {} });
  const PointMesh mesh = JitteredMesh(60, 40, { 1.0, 1.0 }, 3, 1, PointsOnLines(given, 60, 40, { 1.0, 1.0 }));
  const MeshDrainage drainage = DrainMesh(mesh, terrain.Values, SerialFor, CoursesOn(mesh, given));
  ASSERT_EQ(drainage.Order.size(), mesh.Points.size());
  double out = 0.0;
  for (CellIndex n = 0; n < mesh.Count(); ++n)
  {
    out += mesh.IsRim(n) ? drainage.Area[n] : 0.0;
  }
  EXPECT_NEAR(out, 60.0 * 40.0, 150.0); // Voronoi's cells at the rim are open
}

TEST(GivenGround, FlowOfAGridFollowsRiversAndCrossesNoRidge)
{
  GridSamples ground = RandomGround(60, 40, { 1.0, 1.0 }, 5);
  const GivenGround given = Sketch();
  LeadGrid(ground, given, 1e-6);
  const FlowRouting routing = RouteFlow(ground, BorderOutlets(60, 40));
  const std::vector<CellIndex> area = FlowAccumulation(routing);
  const std::vector<CellIndex> main = CellsOf(given.Rivers[0], 60, 40);
  for (const GivenLine& river : given.Rivers)
  {
    const std::vector<CellIndex> cells = CellsOf(river, 60, 40);
    for (std::size_t n = 1; n < cells.size(); ++n)
    {
      // a tributary may join the river a cell before
      const CellIndex receiver = routing.Receiver[cells[n - 1]];
      EXPECT_TRUE(receiver == cells[n] || std::count(main.begin(), main.end(), receiver) > 0);
      EXPECT_LT(ground.Values[cells[n]], ground.Values[cells[n - 1]]);
    }
  }
  // a ridge has no water but from pits that fill over it
  int wet = 0;
  for (const CellIndex cell : CellsOf(given.Ridges[0], 60, 40))
  {
    wet += area[cell] > 1 ? 1 : 0;
  }
  EXPECT_LE(wet, 5);
}

TEST(HeightCorrection, MeetsDataWithoutSpikes)
{
  // a lone datum lifts all of the ground
  GridSamples ground = Ground(80, 60, { 2.0, 3.0 }, [](double x, double y) { return 0.1 * x + 0.02 * y; });
  const GridSamples before = ground;
  CorrectHeights(ground, { { { 50.0, 71.0 }, 100.0 } });
  for (std::size_t n = 0; n < ground.Values.size(); ++n)
  {
    EXPECT_NEAR(ground.Values[n] - before.Values[n], 100.0 - 5.0 - 1.42, 1e-9);
  }
  // data of another plane: met, and what is added stays between what is missing there
  std::vector<GivenHeight> data;
  for (int n = 0; n < 40; ++n)
  {
    const std::array<double, 2> place{ 4.0 * ((7 * n) % 39), 4.0 * ((11 * n) % 43) };
    data.push_back({ place, 20.0 + 0.3 * place[0] });
  }
  data.push_back({ { 10.0, 10.0 }, std::numeric_limits<double>::quiet_NaN() }); // passed over
  ground = before;
  CorrectHeights(ground, data, 1.0, OnThreads(3));
  double least = 1e9;
  double most = -1e9;
  for (std::size_t n = 0; n + 1 < data.size(); ++n)
  {
    EXPECT_NEAR(HeightAt(ground, data[n].Place), data[n].Height, 0.01);
    least = std::min(least, data[n].Height - HeightAt(before, data[n].Place));
    most = std::max(most, data[n].Height - HeightAt(before, data[n].Place));
  }
  for (std::size_t n = 0; n < ground.Values.size(); ++n)
  {
    EXPECT_GT(ground.Values[n] - before.Values[n], least - 0.1 * (most - least));
    EXPECT_LT(ground.Values[n] - before.Values[n], most + 0.1 * (most - least));
  }
}

TEST(CourseWaves, HaveValleysAndHeightsThatFadeAsGauss)
{
  // a straight river down a plane of the slope s: lower by 1.5 s d at the line, by e^(-1/2) of it at one deviation
  GridSamples waves = Ground(120, 100, { 1.0, 1.0 }, [](double x, double y) { return 0.1 * x - 0.5 * y; });
  const GridSamples before = waves;
  GivenGround given;
  given.Rivers.push_back({ { { 119.0, 50.0 }, { 0.0, 50.0 } }, {} });
  LeadWaves(waves, given, 8.0);
  const auto change = [&](int i, int j) { return waves.At(i, j) - before.At(i, j); };
  EXPECT_NEAR(change(60, 50), -12.0 * std::hypot(0.1, 0.5), 0.6);
  EXPECT_NEAR(change(60, 58) / change(60, 50), std::exp(-0.5), 0.07);
  std::swap(given.Rivers, given.Ridges);
  waves = before;
  LeadWaves(waves, given, 8.0);
  EXPECT_NEAR(change(60, 50), 12.0 * std::hypot(0.1, 0.5), 0.6);
}

TEST(GivenGround, IsInTheGroundThatGrows)
{
  GridSamples place = RandomGround(60, 50, { 1.0, 1.0 }, 2);
  StreamPowerLaw law;
  law.AreaExponent = 0.5;
  law.Erodibility = 0.01;
  GrowByStreamPower(place, BorderOutlets(60, 50), law, 400, 40);
  SmoothGrid(place.Values, 60, 50, 1.0);
  GridSamples one = RandomGround(60, 40, { 1.0, 1.0 }, 5);
  GridSamples three = one;
  GrowthParameters parameters;
  parameters.MaximumIterations = 1;
  parameters.Given = Sketch();
  for (int n = 0; n < 12; ++n)
  {
    const double x = 5.0 + 4.3 * n;
    parameters.Given.Heights.push_back({ { x, 36.0 - (n % 3) }, 5.0 + 0.1 * n });
  }
  ASSERT_EQ(WhyInvalid(one, parameters), "");
  GrowLandscape(one, place, parameters);
  GrowLandscape(three, place, parameters, OnThreads(3));
  EXPECT_EQ(one.Values, three.Values);
  EXPECT_EQ(FloodDepressions(one, BorderOutlets(60, 40)).DepressionCells, 0u);
  const FlowRouting routing = RouteFlow(one, BorderOutlets(60, 40));
  const std::vector<CellIndex> area = FlowAccumulation(routing);
  const std::vector<CellIndex> main = CellsOf(parameters.Given.Rivers[0], 60, 40);
  const std::vector<CellIndex> other = CellsOf(parameters.Given.Rivers[1], 60, 40);
  for (const GivenLine& river : parameters.Given.Rivers)
  {
    const std::vector<CellIndex> cells = CellsOf(river, 60, 40);
    for (std::size_t n = 1; n < cells.size(); ++n)
    {
      EXPECT_LT(one.Values[cells[n]], one.Values[cells[n - 1]]);
      // a tributary may join the river a cell before
      const CellIndex receiver = routing.Receiver[cells[n - 1]];
      EXPECT_TRUE(
        std::count(main.begin(), main.end(), receiver) + std::count(other.begin(), other.end(), receiver) > 0);
    }
  }
  EXPECT_GT(area[CellsOf(parameters.Given.Rivers[0], 60, 40).back()], 150);
  for (const CellIndex cell : CellsOf(parameters.Given.Ridges[0], 60, 40))
  {
    EXPECT_LE(area[cell], 4);
  }
  for (const GivenHeight& given : parameters.Given.Heights)
  {
    EXPECT_NEAR(HeightAt(one, given.Place), given.Height, 0.05);
  }
}
