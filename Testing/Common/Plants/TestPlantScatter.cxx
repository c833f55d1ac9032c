// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "../ProcessTeam.h"
#include "Geometry/HeightGrid.h"
#include "Geometry/SceneCells.h"
#include "Geometry/TextureAtlas.h"
#include "Numerics/Constants.h"
#include "Plants/PlantScatter.h"

#include <glm/common.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace littoral;

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr PlantExtent Tree{ 5.0, 0.0, 14.0 };

struct Forest
{
  std::vector<PlantPlace> Places;
  std::vector<Vector3> Feet;
  std::vector<Box> Boxes;
};

/// Trees at random on hills, on a square about the origin.
Forest MakeForest(int trees, double size, double hills)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-0.5 * size, 0.5 * size);
  ScatterOptions options;
  options.Weights = std::vector<double>{ 1.0 };
  const PlantDraws draws(options);
  Forest forest;
  for (int site = 0; site < trees; ++site)
  {
    PlantPlace place;
    place.Site = site;
    place.Scale = draws.Scale(site);
    place.Foot = { uniform(random), uniform(random), 0.0 };
    place.Foot.z = hills * std::sin(0.02 * place.Foot.x) * std::cos(0.03 * place.Foot.y);
    forest.Places.push_back(place);
    forest.Feet.push_back(place.Foot);
    forest.Boxes.push_back(BoxOf(place, Tree));
  }
  return forest;
}

View RandomView(std::mt19937& random, double size)
{
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  View view;
  view.Point = size * Vector3(uniform(random), uniform(random), 0.3 * uniform(random));
  view.Direction = { uniform(random), uniform(random), uniform(random) };
  view.Up = { uniform(random), uniform(random), uniform(random) };
  view.Angle = 0.8 + 0.7 * uniform(random);
  view.AspectRatio = 1.3 + uniform(random);
  return view;
}

/// Polygons of the levels of a tree.
constexpr double Polygons[3] = { 25000.0, 230.0, 4.0 };

/// What is processed on the way.
struct Work
{
  double Plants = 0.0;
  double Polygons = 0.0;
};

/// A walk at eye height that turns at random and stays on the square.
std::vector<View> RandomPath(int frames, double size)
{
  std::mt19937 random(5);
  std::normal_distribution<double> turn(0.0, 0.12);
  double heading = 0.7;
  Vector3 eye{ 0.0, 0.0, 1.7 };
  std::vector<View> path;
  for (int frame = 0; frame < frames; ++frame)
  {
    heading += turn(random);
    const Vector3 ahead{ std::cos(heading), std::sin(heading), 0.0 };
    const Vector3 next = eye + 4.0 * ahead;
    if (std::max(std::abs(next.x), std::abs(next.y)) > 0.5 * size)
    {
      heading += 0.6;
    }
    else
    {
      eye = next;
    }
    View view;
    view.Point = eye;
    view.Direction = ahead;
    view.Angle = Pi / 4.0;
    view.AspectRatio = 4.0 / 3.0;
    path.push_back(view);
  }
  return path;
}

Work Walk(const Forest& forest, const SceneCells& cells, const std::vector<View>& path, bool levels, bool culls)
{
  PlantViewOptions options;
  options.UseLevels = levels;
  options.UseCulling = culls;
  Work work;
  for (const View& view : path)
  {
    const auto shown = ShownPlants(forest.Places, cells, cells.Show(ViewFrustum(view)), view, options);
    work.Plants += static_cast<double>(shown.size());
    for (const ShownPlant& plant : shown)
    {
      work.Polygons += Polygons[static_cast<int>(plant.Level)];
    }
  }
  return work;
}

}

TEST(SceneCells, ShowWhatATestOfEachCellShows)
{
  const Forest forest = MakeForest(3000, 1000.0, 40.0);
  std::mt19937 random(2);
  for (double objectsPerCell : { 0.3, 1.0, 7.0, 1e9 })
  {
    const SceneCells cells(forest.Feet, forest.Boxes, objectsPerCell);
    int kept = 0;
    int culled = 0;
    for (int n = 0; n < 200; ++n)
    {
      const ViewFrustum frustum(RandomView(random, 700.0));
      const std::vector<char> shown = cells.Show(frustum);
      ASSERT_EQ(static_cast<int>(shown.size()), cells.GetColumns() * cells.GetRows());
      for (int cell = 0; cell < static_cast<int>(shown.size()); ++cell)
      {
        const bool wanted = cells.NumberIn(cell) > 0 && frustum.MayShow(cells.BoxOf(cell));
        ASSERT_EQ(shown[cell] != 0, wanted);
        ++(wanted ? kept : culled);
      }
    }
    EXPECT_GT(kept, 20);
    EXPECT_GT(culled, 20);
  }
}

TEST(SceneCells, LoseNoPlantThatIsInTheView)
{
  const Forest forest = MakeForest(2000, 800.0, 40.0);
  const SceneCells cells(forest.Feet, forest.Boxes, 1.0);
  std::mt19937 random(3);
  int visible = 0;
  for (int n = 0; n < 200; ++n)
  {
    const ViewFrustum frustum(RandomView(random, 500.0));
    const std::vector<char> shown = cells.Show(frustum);
    for (std::size_t plant = 0; plant < forest.Boxes.size(); ++plant)
    {
      if (frustum.MayShow(forest.Boxes[plant]))
      {
        ++visible;
        ASSERT_TRUE(shown[cells.CellOf(plant)]);
      }
    }
  }
  EXPECT_GT(visible, 1000);
}

TEST(SceneCells, HoldEachFootOnTheirGroundAboutAsManyAsAskedFor)
{
  const Forest forest = MakeForest(5000, 1000.0, 0.0);
  Box all{ forest.Feet[0], forest.Feet[0] };
  for (const Vector3& foot : forest.Feet)
  {
    all.Low = glm::min(all.Low, foot);
    all.High = glm::max(all.High, foot);
  }
  for (double perCell : { 1.0, 4.0, 50.0 })
  {
    const SceneCells cells(forest.Feet, forest.Boxes, perCell);
    EXPECT_NEAR(5000.0 / (cells.GetColumns() * cells.GetRows()), perCell, 0.1 * perCell);
    for (std::size_t plant = 0; plant < forest.Feet.size(); ++plant)
    {
      const int cell = cells.CellOf(plant);
      const int index[2] = { cell % cells.GetColumns(), cell / cells.GetColumns() };
      for (int axis = 0; axis < 2; ++axis)
      {
        const double step = (all.High[axis] - all.Low[axis]) / (axis == 0 ? cells.GetColumns() : cells.GetRows());
        const double low = all.Low[axis] + index[axis] * step;
        ASSERT_GE(forest.Feet[plant][axis], low - 1e-9);
        ASSERT_LE(forest.Feet[plant][axis], low + step + 1e-9);
      }
    }
  }
}

TEST(SceneCells, AreNotMoreThanThereIsUseFor)
{
  const Forest forest = MakeForest(1000, 1000.0, 40.0);
  for (double objectsPerCell : { 1e-3, 1e-6, 1e-30 })
  {
    const SceneCells cells(forest.Feet, forest.Boxes, objectsPerCell);
    const double count = static_cast<double>(cells.GetColumns()) * cells.GetRows();
    EXPECT_NEAR(count, 64000.0, 1000.0);
    EXPECT_GT(cells.NumberOfFilled(), 980);
  }
}

TEST(SceneCells, StandLinesSinglePointsAndNothing)
{
  const ViewFrustum ahead(View{});
  EXPECT_TRUE(SceneCells({}, {}, 1.0).Show(ahead).empty());
  std::vector<Vector3> row;
  std::vector<Box> boxes;
  for (int n = 0; n < 100; ++n)
  {
    row.push_back({ 0.0, 10.0 + n, 0.0 });
    boxes.push_back({ row.back(), row.back() });
  }
  const SceneCells line(row, boxes, 1.0);
  EXPECT_EQ(line.GetColumns(), 1);
  EXPECT_EQ(line.GetRows(), 100);
  const std::vector<Vector3> same(50, Vector3(0.0, 10.0, 0.0));
  const SceneCells point(same, std::vector<Box>(50, Box{ same[0], same[0] }), 1.0);
  EXPECT_EQ(point.GetColumns() * point.GetRows(), 1);
  EXPECT_EQ(point.Show(ahead), std::vector<char>{ 1 });
}

TEST(PlantScatter, ShowsEachPlantOnceAtTheLevelOfItsDistance)
{
  const Forest forest = MakeForest(2000, 800.0, 10.0);
  const SceneCells cells(forest.Feet, forest.Boxes, 1.0);
  const View view = RandomPath(1, 800.0).front();
  const std::vector<char> marks = cells.Show(ViewFrustum(view));
  PlantViewOptions options;
  options.NearDistance = 60.0;
  options.FarDistance = 250.0;
  options.VisibleDistance = 380.0;
  const auto shown = ShownPlants(forest.Places, cells, marks, view, options);
  std::vector<int> times(2000, 0);
  std::array<int, 3> levels{ 0, 0, 0 };
  for (const ShownPlant& plant : shown)
  {
    const double distance = glm::length(forest.Feet[plant.Place] - view.Point);
    const int level = distance <= 60.0 ? 0 : distance <= 250.0 ? 1 : 2;
    EXPECT_EQ(static_cast<int>(plant.Level), level);
    ++levels[level];
    ++times[plant.Place];
  }
  for (std::size_t plant = 0; plant < times.size(); ++plant)
  {
    const bool near = glm::length(forest.Feet[plant] - view.Point) <= 380.0;
    EXPECT_EQ(times[plant], near && marks[cells.CellOf(plant)] ? 1 : 0);
  }
  EXPECT_GT(*std::min_element(levels.begin(), levels.end()), 0);
}

// Whole tiles of cells are left out by their distance: none that has a plant within the limit, across the grid either.
TEST(PlantScatter, ShowsAllWithinTheLimitOfSight)
{
  const Forest forest = MakeForest(40000, 4000.0, 10.0);
  const SceneCells cells(forest.Feet, forest.Boxes, 1.0);
  View view;
  view.Point = { 100.0, -50.0, 30.0 };
  view.Direction = { 1.0, 1.0, 0.0 };
  view.Angle = 1.5;
  const std::vector<char> marks = cells.Show(ViewFrustum(view));
  PlantViewOptions options;
  for (const double limit : { 150.0, 600.0, 1500.0 })
  {
    options.VisibleDistance = limit;
    std::vector<int> times(forest.Feet.size(), 0);
    for (const ShownPlant& plant : ShownPlants(forest.Places, cells, marks, view, options))
    {
      ++times[plant.Place];
    }
    std::size_t wrong = 0;
    for (std::size_t plant = 0; plant < times.size(); ++plant)
    {
      const bool isNear = glm::length(forest.Feet[plant] - view.Point) <= limit;
      wrong += times[plant] != (isNear && marks[cells.CellOf(plant)] ? 1 : 0);
    }
    EXPECT_EQ(wrong, 0u) << limit << " m";
  }
}

TEST(PlantScatter, LevelsReachUpToTheirDistances)
{
  const double distances[] = { 31.75, 32.0, 32.25, 255.0, 256.0, 257.0 }; // exact in binary
  std::vector<PlantPlace> places;
  std::vector<Vector3> feet;
  std::vector<Box> boxes;
  for (const double distance : distances)
  {
    PlantPlace place;
    place.Foot = { distance, 0.0, 0.0 };
    place.Site = static_cast<int>(places.size());
    places.push_back(place);
    feet.push_back(place.Foot);
    boxes.push_back({ place.Foot, place.Foot });
  }
  const SceneCells cells(feet, boxes, 1.0);
  View view;
  view.Point = { 0.0, 0.0, 0.0 };
  PlantViewOptions options;
  options.UseCulling = false;
  options.NearDistance = 32.0;
  options.FarDistance = 256.0;
  const auto shown = ShownPlants(places, cells, {}, view, options);
  ASSERT_EQ(shown.size(), 6u);
  const int wanted[] = { 0, 0, 1, 1, 1, 2 };
  for (int n = 0; n < 6; ++n)
  {
    EXPECT_EQ(static_cast<int>(shown[n].Level), wanted[n]) << distances[n] << " m";
  }
}

TEST(PlantScatter, ABoxHoldsItsPlantHoweverThatIsTurned)
{
  PlantMesh mesh;
  mesh.Points = { { 0.0, -3.0, -0.5 }, { 1.0, 1.0, 7.0 }, { -2.0, 0.5, 2.0 } };
  PlantExtent extent;
  Enclose(extent, mesh);
  PlantPlace place;
  place.Foot = { 100.0, -20.0, 5.0 };
  place.Scale = 1.5;
  const Box box = BoxOf(place, extent);
  Vector3 low = box.High;
  Vector3 high = box.Low;
  for (int turn = 0; turn < 360; ++turn)
  {
    place.Azimuth = turn * Pi / 180.0;
    for (const Vector3& point : mesh.Points)
    {
      const float from[3] = { static_cast<float>(point.x), static_cast<float>(point.y), static_cast<float>(point.z) };
      float to[3];
      PlantPlacement(place).Points(from, 1, to);
      low = glm::min(low, Vector3(to[0], to[1], to[2]));
      high = glm::max(high, Vector3(to[0], to[1], to[2]));
    }
  }
  for (int axis = 0; axis < 3; ++axis) // all turns together fill it
  {
    EXPECT_NEAR(low[axis], box.Low[axis], 1e-4) << axis;
    EXPECT_NEAR(high[axis], box.High[axis], 1e-4) << axis;
  }
}

TEST(SceneCells, PartsShowWhatTheWholeShows)
{
  const Forest forest = MakeForest(500, 400.0, 10.0);
  const View view = RandomPath(1, 400.0).front();
  Box ground{ forest.Feet.front(), forest.Feet.front() };
  for (const Vector3& foot : forest.Feet)
  {
    ground = { glm::min(ground.Low, foot), glm::max(ground.High, foot) };
  }
  const CellGrid grid(ground, 500.0, 1.5);
  const int all = grid.GetColumns() * grid.GetRows();
  std::vector<int> plantsInCells(all, 0);
  std::vector<int> cellsOfPlants;
  for (const Vector3& foot : forest.Feet)
  {
    cellsOfPlants.push_back(grid.CellAt(foot));
    ++plantsInCells[cellsOfPlants.back()];
  }
  // Indices of the plants that parts show, and the number in the largest part.
  const auto shownBy = [&](int parts) {
    std::pair<std::vector<int>, std::size_t> found;
    const std::vector<int> first = FirstCellsOfParts(cellsOfPlants, all, parts);
    for (int part = 0; part < parts; ++part)
    {
      const std::array<int, 2> own{ first[part], first[part + 1] };
      std::vector<int> indices;
      std::vector<PlantPlace> places;
      std::vector<Vector3> feet;
      std::vector<Box> boxes;
      for (int n = 0; n < 500; ++n)
      {
        const int cell = grid.CellAt(forest.Feet[n]);
        if (cell >= own[0] && cell < own[1])
        {
          indices.push_back(n);
          places.push_back(forest.Places[n]);
          feet.push_back(forest.Feet[n]);
          boxes.push_back(forest.Boxes[n]);
        }
      }
      const SceneCells cells(grid, own, feet, boxes);
      for (const ShownPlant& plant : ShownPlants(places, cells, cells.Show(ViewFrustum(view)), view, {}))
      {
        found.first.push_back(indices[plant.Place]);
      }
      found.second = std::max(found.second, indices.size());
    }
    std::sort(found.first.begin(), found.first.end());
    return found;
  };
  const auto [whole, inAll] = shownBy(1);
  EXPECT_EQ(inAll, 500u);
  EXPECT_GT(whole.size(), 20u);
  EXPECT_LT(whole.size(), 400u);
  for (const int parts : { 2, 3, 7, 1000 })
  {
    const auto [shown, largest] = shownBy(parts);
    EXPECT_EQ(shown, whole) << parts;
    // A part is a cell's plants longer than its share at most.
    EXPECT_LE(
      static_cast<int>(largest), 500 / parts + 1 + *std::max_element(plantsInCells.begin(), plantsInCells.end()));
  }
}

// By counting from the first cell on.
TEST(SceneCells, PartsBeginWithTheFirstCellThatReachesTheirShare)
{
  std::mt19937 random(4);
  for (const int cells : { 1, 2, 7, 400, 1001 })
  {
    for (const int objects : { 0, 1, 5, 900 })
    {
      std::vector<int> cellsOfObjects;
      for (int object = 0; object < objects; ++object) // crowded at the end, a third in one cell
      {
        const double place = std::uniform_real_distribution<double>(0.0, 1.0)(random);
        cellsOfObjects.push_back(object % 3 == 0 ? cells / 2 : static_cast<int>(std::sqrt(place) * cells));
      }
      for (const int parts : { 1, 2, 3, 64 })
      {
        const std::vector<int> first = FirstCellsOfParts(cellsOfObjects, cells, parts);
        ASSERT_EQ(static_cast<int>(first.size()), parts + 1);
        for (int part = 0; part < parts; ++part)
        {
          const auto before = [&](int cell) {
            return std::count_if(cellsOfObjects.begin(), cellsOfObjects.end(), [=](int own) { return own < cell; });
          };
          EXPECT_GE(before(first[part]) * parts, objects * part);
          EXPECT_TRUE(first[part] == 0 || before(first[part] - 1) * parts < objects * part)
            << cells << " cells, " << objects << " objects, part " << part << " of " << parts;
        }
        EXPECT_EQ(first.back(), cells);
      }
    }
  }
}

TEST(PlantScatter, ProcessesThatShareSitesEachGetThePlantsOfTheirCells)
{
  const Forest forest = MakeForest(500, 400.0, 10.0);
  const CellGrid grid({ { -200.0, -200.0, 0.0 }, { 200.0, 200.0, 0.0 } }, 500.0, 1.5);
  const int cells = grid.GetColumns() * grid.GetRows();
  std::vector<int> cellsOfPlants;
  for (const Vector3& foot : forest.Feet)
  {
    cellsOfPlants.push_back(grid.CellAt(foot));
  }
  for (const std::size_t ranks : { 1, 2, 3, 7 })
  {
    const std::vector<int> first = FirstCellsOfParts(cellsOfPlants, cells, static_cast<int>(ranks));
    std::vector<std::vector<PlantPlace>> dealt(ranks);
    littoral::testing::ProcessTeam(ranks).Run([&](const WorkShare& share) {
      // The first process has no site, if there are others.
      const std::size_t others = std::max<std::size_t>(1, ranks - 1);
      const std::size_t behind = std::min(share.Rank + 1, ranks) - (ranks > 1 ? 1 : 0);
      const std::size_t begin = ranks > 1 && share.Rank > 0 ? 500 * (share.Rank - 1) / others : 0;
      const std::size_t end = 500 * behind / others;
      const std::vector<int> own(cellsOfPlants.begin() + begin, cellsOfPlants.begin() + end);
      EXPECT_EQ(FirstCellsOfParts(own, cells, static_cast<int>(ranks), share), first);
      dealt[share.Rank].assign(forest.Places.begin() + begin, forest.Places.begin() + end);
      DealPlaces(grid, first, share, dealt[share.Rank]);
    });
    for (std::size_t rank = 0; rank < ranks; ++rank)
    {
      std::vector<int> wanted;
      std::vector<int> found;
      for (int plant = 0; plant < 500; ++plant)
      {
        if (cellsOfPlants[plant] >= first[rank] && cellsOfPlants[plant] < first[rank + 1])
        {
          wanted.push_back(plant);
        }
      }
      for (const PlantPlace& place : dealt[rank])
      {
        found.push_back(place.Site);
        EXPECT_EQ(place.Scale, forest.Places[place.Site].Scale);
        EXPECT_EQ(place.Foot, forest.Places[place.Site].Foot);
      }
      EXPECT_EQ(found, wanted) << "process " << rank << " of " << ranks;
    }
  }
}

TEST(PlantScatter, GainOfLevelsAndCellsOnARandomPath)
{
  const Forest forest = MakeForest(1000, 1000.0, 0.0);
  const SceneCells cells(forest.Feet, forest.Boxes, 1.0);
  const std::vector<View> path = RandomPath(720, 1000.0);
  const Work none = Walk(forest, cells, path, false, false);
  const Work levels = Walk(forest, cells, path, true, false);
  const Work culling = Walk(forest, cells, path, false, true);
  const Work both = Walk(forest, cells, path, true, true);
  EXPECT_DOUBLE_EQ(none.Plants, 720.0 * 1000.0);
  EXPECT_DOUBLE_EQ(levels.Plants, none.Plants);
  EXPECT_DOUBLE_EQ(both.Plants, culling.Plants);
  // The paper's frame rates: 13 times with both, 5.8 with cells, 4.1 with levels.
  EXPECT_GT(none.Polygons / both.Polygons, 13.0);
  EXPECT_GT(none.Polygons / culling.Polygons, 4.0);
  EXPECT_GT(none.Polygons / levels.Polygons, 4.1);
  EXPECT_GT(both.Polygons, 0.0);
}

TEST(PlantScatter, DrawsBelongToTheSiteAlone)
{
  ScatterOptions options;
  options.Weights = std::vector<double>{ 1.0, 2.0, 0.0, 5.0 };
  const PlantDraws draws(options);
  const PlantDraws again(options);
  options.Seed = 2;
  const PlantDraws others(options);
  std::array<int, 4> counts{ 0, 0, 0, 0 };
  int differences = 0;
  double sum = 0.0;
  double squares = 0.0;
  double turns = 0.0;
  constexpr int Sites = 20000;
  for (int site = 0; site < Sites; ++site)
  {
    ++counts[draws.Species(site)];
    EXPECT_EQ(draws.Species(site), again.Species(site));
    EXPECT_EQ(draws.Tint(site), again.Tint(site));
    differences += draws.Scale(site) != others.Scale(site);
    const double scale = draws.Scale(site);
    EXPECT_GE(scale, 0.7);
    EXPECT_LE(scale, 1.3);
    sum += scale;
    squares += (scale - 1.0) * (scale - 1.0);
    turns += draws.Azimuth(site);
  }
  EXPECT_EQ(counts[2], 0);
  // Five standard errors. A normal deviate that is clamped at 2 has the variance 0.9205.
  EXPECT_NEAR(counts[0], Sites / 8.0, 5.0 * std::sqrt(Sites * 0.125 * 0.875));
  EXPECT_NEAR(counts[3], Sites * 0.625, 5.0 * std::sqrt(Sites * 0.625 * 0.375));
  EXPECT_NEAR(sum / Sites, 1.0, 5.0 * 0.15 / std::sqrt(Sites));
  EXPECT_NEAR(std::sqrt(squares / Sites) / 0.15, std::sqrt(0.9205), 0.02);
  EXPECT_NEAR(turns / Sites, Pi, 5.0 * 2.0 * Pi / std::sqrt(12.0 * Sites));
  EXPECT_GT(differences, Sites - 10 - Sites / 10); // those clamped at the same end agree
}

TEST(PlantScatter, NamesBadOptions)
{
  ScatterOptions good;
  good.Weights = std::vector<double>{ 1.0, 0.0 };
  EXPECT_EQ(WhyInvalid(good), "");
  const auto names = [&](const char* word, auto spoil) {
    ScatterOptions bad = good;
    spoil(bad);
    EXPECT_NE(WhyInvalid(bad).find(word), std::string::npos) << word;
  };
  names("Weight 1", [](ScatterOptions& o) { o.Weights[1] = -1.0; });
  names("Weight 0", [](ScatterOptions& o) { o.Weights[0] = NaN; });
  names("Weights", [](ScatterOptions& o) { o.Weights[0] = 0.0; });
  names("ScaleVariation", [](ScatterOptions& o) { o.ScaleVariation = 0.5; });
  names("ScaleVariation", [](ScatterOptions& o) { o.ScaleVariation = NaN; });
  names("TintVariation", [](ScatterOptions& o) { o.TintVariation = -0.1; });
}

TEST(PlantScatter, TurnsScalesAndMovesVertices)
{
  PlantPlace place;
  place.Foot = { 100.0, 200.0, 3.0 };
  place.Scale = 2.0;
  place.Azimuth = Pi / 2.0;
  place.Tint = { 1.5f, 1.0f, 0.5f };
  const PlantPlacement placement(place);
  const float point[3] = { 1.0f, 0.5f, 4.0f };
  float moved[3];
  placement.Points(point, 1, moved);
  EXPECT_FLOAT_EQ(moved[0], 99.0f);
  EXPECT_FLOAT_EQ(moved[1], 202.0f);
  EXPECT_FLOAT_EQ(moved[2], 11.0f);
  const float normal[3] = { 0.6f, 0.0f, 0.8f };
  placement.Directions(normal, 1, moved);
  EXPECT_NEAR(moved[0], 0.0f, 1e-7f);
  EXPECT_FLOAT_EQ(moved[1], 0.6f);
  EXPECT_FLOAT_EQ(moved[2], 0.8f);
  const unsigned char green[3] = { 200, 101, 100 };
  unsigned char tinted[3];
  placement.Colors(green, 1, tinted);
  EXPECT_EQ(tinted[0], 255);
  EXPECT_EQ(tinted[1], 101);
  EXPECT_EQ(tinted[2], 50);
}

TEST(PlantScatter, PlacesSkeletonsWhereVerticesGo)
{
  PlantPlace place;
  place.Foot = { 100.0, 200.0, 3.0 };
  place.Scale = 0.7;
  place.Azimuth = 2.5;
  Skeleton prototype;
  prototype.StartBranch(-1, { 0.1, -0.2, 0.0 }, 0.3);
  prototype.Grow({ 1.0, 0.5, 4.0 }, 0.2);
  const Skeleton placed = Placed(prototype, place);
  EXPECT_EQ(WhyInvalid(placed), "");
  for (std::size_t node = 0; node < 2; ++node)
  {
    const Vector3& from = prototype.Nodes[node].Position;
    const float point[3] = { static_cast<float>(from.x), static_cast<float>(from.y), static_cast<float>(from.z) };
    float moved[3];
    PlantPlacement(place).Points(point, 1, moved);
    EXPECT_NEAR(glm::distance(placed.Nodes[node].Position, Vector3(moved[0], moved[1], moved[2])), 0.0, 1e-5);
    EXPECT_DOUBLE_EQ(placed.Nodes[node].Radius, 0.7 * prototype.Nodes[node].Radius);
  }
}

TEST(HeightGrid, IsExactOnABilinearSurface)
{
  HeightGrid grid;
  grid.Origin[0] = 10.0;
  grid.Origin[1] = -5.0;
  grid.Spacing[0] = 2.0;
  grid.Spacing[1] = 3.0;
  grid.Count[0] = 6;
  grid.Count[1] = 4;
  const auto surface = [](double x, double y) { return 3.0 + 0.5 * x - 0.25 * y + 0.125 * x * y; };
  grid.HeightOf = [&](long long point) {
    return surface(10.0 + 2.0 * static_cast<double>(point % 6), -5.0 + 3.0 * static_cast<double>(point / 6));
  };
  for (double x = 10.0; x <= 20.0; x += 0.37)
  {
    for (double y = -5.0; y <= 4.0; y += 0.41)
    {
      const GroundPoint ground = grid.At(x, y);
      ASSERT_TRUE(ground.IsCovered);
      EXPECT_NEAR(ground.Height, surface(x, y), 1e-12);
      EXPECT_NEAR(std::tan(ground.Slope), std::hypot(0.5 + 0.125 * y, -0.25 + 0.125 * x), 1e-12);
    }
  }
  EXPECT_TRUE(grid.At(20.0, 4.0).IsCovered);
  EXPECT_FALSE(grid.At(20.1, 0.0).IsCovered);
  EXPECT_FALSE(grid.At(15.0, -5.1).IsCovered);
  EXPECT_FALSE(grid.At(NaN, 0.0).IsCovered);
}

TEST(HeightGrid, SaysWhereThereIsNoHeight)
{
  HeightGrid grid;
  grid.Count[0] = grid.Count[1] = 3;
  grid.HeightOf = [](long long point) { return point == 8 ? NaN : 1.0; };
  EXPECT_TRUE(std::isnan(grid.At(1.5, 1.5).Height));
  EXPECT_EQ(grid.At(0.5, 0.5).Height, 1.0);
  EXPECT_EQ(grid.At(1.0, 1.0).Height, 1.0); // a corner of the cell with the hole
}

TEST(TextureAtlas, KeepsEachTextureInItsAreaWithARepeatedEdge)
{
  TextureImage wide(8, 3);
  TextureImage high(2, 5);
  for (int row = 0; row < 5; ++row)
  {
    for (int column = 0; column < 8; ++column)
    {
      const Texel texel{ static_cast<unsigned char>(10 * row), static_cast<unsigned char>(column), 1, 200 };
      if (row < 3)
      {
        wide.At(column, row) = texel;
      }
      if (column < 2)
      {
        high.At(column, row) = texel;
        high.At(column, row)[2] = 2;
      }
    }
  }
  const std::vector<TextureImage> textures{ wide, TextureImage{}, high };
  const TextureAtlas atlas = StackTextures(textures);
  const std::array<long long, 2> size = AtlasSize({ { 8, 3 }, { 0, 0 }, { 2, 5 } });
  EXPECT_EQ(atlas.Image.Columns, size[0]);
  EXPECT_EQ(atlas.Image.Rows, size[1]);
  const auto at = [&](int texture, double u, double v) {
    const auto mapped = atlas.Areas[texture].Map(u, v);
    return atlas.Image.At(
      static_cast<int>(mapped[0] * atlas.Image.Columns), static_cast<int>(mapped[1] * atlas.Image.Rows));
  };
  for (int texture : { 0, 2 })
  {
    const TextureImage& own = textures[texture];
    for (int row = 0; row < own.Rows; ++row)
    {
      for (int column = 0; column < own.Columns; ++column)
      {
        EXPECT_EQ(at(texture, (column + 0.5) / own.Columns, (row + 0.5) / own.Rows), own.At(column, row));
      }
    }
    // A coordinate on the very edge is interpolated with the border: the same texel again.
    const auto corner = atlas.Areas[texture].Map(0.0, 1.0);
    const int column = static_cast<int>(std::lround(corner[0] * atlas.Image.Columns));
    const int row = static_cast<int>(std::lround(corner[1] * atlas.Image.Rows));
    EXPECT_EQ(atlas.Image.At(column, row), own.At(0, own.Rows - 1));
    EXPECT_EQ(atlas.Image.At(column - 1, row), own.At(0, own.Rows - 1));
    EXPECT_EQ(atlas.Image.At(column, row - 1), own.At(0, own.Rows - 1));
  }
  EXPECT_EQ(at(1, 0.3, 0.9), (Texel{ 255, 255, 255, 255 }));
}

/// A plane that rises by a half along x, from 0 at x = 0 to 5 m at x = 10 m, with a hole at its last point.
HeightGrid Slope()
{
  HeightGrid grid;
  grid.Count[0] = 11;
  grid.Count[1] = 11;
  grid.HeightOf = [](long long point) { return point == 120 ? NaN : 0.5 * static_cast<double>(point % 11); };
  return grid;
}

std::vector<PlantPlace> PlantsAt(const std::vector<std::array<double, 2>>& feet)
{
  std::vector<PlantPlace> places;
  for (const std::array<double, 2>& foot : feet)
  {
    PlantPlace place;
    place.Site = static_cast<int>(places.size());
    place.Foot = { foot[0], foot[1], 77.0 };
    places.push_back(place);
  }
  return places;
}

TEST(PlantScatter, GroundCarriesPlants)
{
  std::vector<PlantPlace> places = PlantsAt({ { 1.0, 1.0 }, { 4.25, 3.0 }, { 8.0, 2.0 } });
  EXPECT_EQ(PutOnGround(Slope(), GroundLimits(), places), "");
  ASSERT_EQ(places.size(), 3u);
  EXPECT_DOUBLE_EQ(places[0].Foot.z, 0.5);
  EXPECT_DOUBLE_EQ(places[1].Foot.z, 2.125);
  EXPECT_DOUBLE_EQ(places[2].Foot.z, 4.0);
}

TEST(PlantScatter, LimitsOfHeightIncludeTheirEnds)
{
  GroundLimits limits;
  limits.LowestHeight = 0.5;
  limits.HighestHeight = 2.0;
  std::vector<PlantPlace> places = PlantsAt({ { 0.9, 1.0 }, { 1.0, 1.0 }, { 4.0, 3.0 }, { 4.1, 2.0 } });
  EXPECT_EQ(PutOnGround(Slope(), limits, places), "");
  ASSERT_EQ(places.size(), 2u);
  EXPECT_EQ(places[0].Site, 1);
  EXPECT_EQ(places[1].Site, 2);
  std::vector<PlantPlace> flat = PlantsAt({ { 0.0, 0.0 }, { 0.0, 0.0 }, { 0.0, 0.0 }, { 0.0, 0.0 } });
  for (PlantPlace& place : flat)
  {
    place.Foot.z = 0.25 + 0.75 * place.Site; // 0.25, 1.0, 1.75, 2.5
  }
  DropOutside(limits, flat);
  ASSERT_EQ(flat.size(), 2u);
  EXPECT_EQ(flat[0].Site, 1);
  EXPECT_EQ(flat[1].Site, 2);
}

TEST(PlantScatter, SteepGroundCarriesNone)
{
  GroundLimits limits;
  for (const double part : { 0.99, 1.01 })
  {
    limits.Slope = part * std::atan(0.5);
    std::vector<PlantPlace> places = PlantsAt({ { 1.0, 1.0 }, { 4.25, 3.0 } });
    EXPECT_EQ(PutOnGround(Slope(), limits, places), "");
    EXPECT_EQ(places.size(), part < 1.0 ? 0u : 2u);
  }
}

TEST(PlantScatter, SitesWithoutGroundAreCounted)
{
  std::vector<PlantPlace> places = PlantsAt({ { 1.0, 1.0 }, { -3.0, 1.0 }, { 9.9, 9.9 }, { 1.0, 11.0 } });
  const std::string reason = PutOnGround(Slope(), GroundLimits(), places);
  EXPECT_NE(reason.find("of 4 sites, 2 lie outside of the Terrain and 1 where it has no height"), std::string::npos)
    << reason;
  EXPECT_NE(reason.find("(-3, 1, 77)"), std::string::npos) << reason;
  const std::vector<PlantPlace> all = PlantsAt({ { 1.0, 1.0 }, { -3.0, 1.0 }, { 9.9, 9.9 }, { 1.0, 11.0 } });
  littoral::testing::ProcessTeam(3).Run([&](const WorkShare& share) {
    const std::size_t ends[] = { 0, 1, 2, 4 };
    std::vector<PlantPlace> own(all.begin() + ends[share.Rank], all.begin() + ends[share.Rank + 1]);
    EXPECT_EQ(PutOnGround(Slope(), GroundLimits(), own, share), reason) << share.Rank;
  });
}

// Drawn divided by the mean, each texture has the colors that it had.
TEST(TextureAtlas, TexturesOfSeveralMeansShareTheSmallest)
{
  TextureImage dark(2, 1);
  dark.Texels = { { 40, 80, 120, 255 }, { 60, 20, 10, 0 } };
  std::vector<TextureImage> textures{ dark, dark, {} };
  const std::array<float, 3> means[] = { { 0.5f, 0.25f, 0.5f }, { 0.25f, 0.5f, 0.5f }, { 1.0f, 1.0f, 1.0f } };
  const std::array<float, 3> common = ShareMean(textures, { means[0], means[1], means[2] });
  EXPECT_EQ(common, (std::array<float, 3>{ 0.25f, 0.25f, 0.5f }));
  EXPECT_EQ(textures[0].Texels, (std::vector<Texel>{ { 20, 80, 120, 255 }, { 30, 20, 10, 0 } }));
  EXPECT_EQ(textures[1].Texels, (std::vector<Texel>{ { 40, 40, 120, 255 }, { 60, 10, 10, 0 } }));
  for (const Texel& texel : textures[2].Texels)
  {
    EXPECT_EQ(texel, (Texel{ 64, 64, 128, 255 })) << "a block without a texture is white";
  }
  EXPECT_FALSE(textures[2].Texels.empty());
  std::vector<TextureImage> same{ dark, dark };
  EXPECT_EQ(ShareMean(same, { means[0], means[0] }), means[0]);
  EXPECT_EQ(same[1].Texels, dark.Texels) << "equal means leave texels as they are";
}
