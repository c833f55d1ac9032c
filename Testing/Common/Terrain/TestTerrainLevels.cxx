// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "../PictureOf.h"
#include "Terrain/TerrainLevels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <utility>

using namespace littoral;

namespace
{

enum class Ground
{
  Rough,
  Flat,
  Slope,
  Steps ///< few heights, so that many samples are in line and many are not
};

HeightSamples MakeGround(int width, int height, Ground ground, unsigned int seed)
{
  std::mt19937 random(seed);
  HeightSamples samples;
  samples.Width = width;
  samples.Height = height;
  samples.Origin = { 1000.0, -500.0 };
  samples.Spacing = { 2.0, 3.0 };
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const double share = static_cast<double>(random() % 10000) / 100.0;
      const double steps = static_cast<double>(random() % 2);
      samples.Values.push_back(static_cast<float>(ground == Ground::Rough ? share
          : ground == Ground::Flat                                        ? 7.0
          : ground == Ground::Slope                                       ? 0.5 * x - 0.25 * y
                                                                          : steps));
    }
  }
  return samples;
}

using Edge = std::pair<std::size_t, std::size_t>;

/// Adds the directed edges of a mesh and fails on triangles that have no area or, on the ground, look down.
void AddEdges(const TerrainMesh& mesh, const HeightSamples& samples, bool isGround, std::map<Edge, int>& edges)
{
  for (std::size_t i = 0; i < mesh.Triangles.size(); i += 3)
  {
    std::array<std::size_t, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
    {
      corners[k] = mesh.Samples[static_cast<std::size_t>(mesh.Triangles[i + k])];
    }
    // In steps of the grid: no rounding, so that an area of zero is zero.
    const auto place = [&](std::size_t s) {
      return Vector3(static_cast<double>(s % samples.Width), static_cast<double>(s / samples.Width), samples.Values[s]);
    };
    const Vector3 normal = glm::cross(place(corners[1]) - place(corners[0]), place(corners[2]) - place(corners[0]));
    ASSERT_GT(glm::length(normal), 0.0);
    if (isGround)
    {
      ASSERT_GT(normal.z, 0.0);
    }
    else
    {
      ASSERT_EQ(normal.z, 0.0);
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      ++edges[{ corners[k], corners[(k + 1) % 3] }];
    }
  }
}

/// Edges that lie on the rim of the shown tiles, as pairs of neighbouring samples.
std::set<Edge> RimOf(const TerrainPyramid& pyramid, const std::vector<int>& levels)
{
  const int along = pyramid.GetTilesAlong(0);
  const auto isShown = [&](int x, int y) {
    return x >= 0 && y >= 0 && x < along && y < pyramid.GetTilesAlong(1) && levels[y * along + x] != Culled;
  };
  std::set<Edge> rim;
  const HeightSamples& samples = pyramid.GetSamples();
  for (int t = 0; t < static_cast<int>(levels.size()); ++t)
  {
    const int x = t % along;
    const int y = t / along;
    const TerrainTile& tile = pyramid.GetTiles()[t];
    if (!isShown(x, y))
    {
      continue;
    }
    for (const auto& [dx, dy] : { std::pair(-1, 0), std::pair(1, 0), std::pair(0, -1), std::pair(0, 1) })
    {
      if (isShown(x + dx, y + dy))
      {
        continue;
      }
      const int axis = dx != 0 ? 1 : 0;
      const int across = dx + dy < 0 ? tile.First[1 - axis] : tile.Last[1 - axis];
      for (int place = tile.First[axis]; place < tile.Last[axis]; ++place)
      {
        const auto at = [&](int p) { return axis == 0 ? samples.Index(p, across) : samples.Index(across, p); };
        rim.insert({ at(place), at(place + 1) });
      }
    }
  }
  return rim;
}

/// Whether all unit steps between two samples on a grid line are on the rim.
bool IsOnRim(const Edge& edge, const HeightSamples& samples, const std::set<Edge>& rim)
{
  const std::size_t low = std::min(edge.first, edge.second);
  const std::size_t high = std::max(edge.first, edge.second);
  const std::size_t width = static_cast<std::size_t>(samples.Width);
  const std::size_t step = low / width == high / width ? 1 : width;
  if ((high - low) % step != 0)
  {
    return false;
  }
  for (std::size_t s = low; s < high; s += step)
  {
    if (rim.count({ s, s + step }) == 0)
    {
      return false;
    }
  }
  return true;
}

void ExpectWatertight(const TerrainPyramid& pyramid, const std::vector<int>& levels)
{
  const HeightSamples& samples = pyramid.GetSamples();
  std::map<Edge, int> edges;
  for (std::size_t tile = 0; tile < levels.size(); ++tile)
  {
    if (levels[tile] != Culled)
    {
      const TerrainPatch patch = MakePatch(pyramid, levels, tile);
      AddEdges(patch.Surface, samples, true, edges);
      AddEdges(patch.Seams, samples, false, edges);
    }
  }
  const std::set<Edge> rim = RimOf(pyramid, levels);
  std::size_t open = 0;
  for (const auto& [edge, count] : edges)
  {
    ASSERT_EQ(count, 1);
    if (edges.count({ edge.second, edge.first }) == 0)
    {
      ++open;
      ASSERT_TRUE(IsOnRim(edge, samples, rim)) << edge.first << " " << edge.second;
    }
  }
  EXPECT_EQ(open == 0, rim.empty());
}

class Grounds : public testing::TestWithParam<Ground>
{
};

}

TEST_P(Grounds, AreWatertightWithRandomLevels)
{
  std::mt19937 random(11);
  for (unsigned int round = 0; round < 60; ++round)
  {
    const int width = 2 + static_cast<int>(random() % 60);
    const int height = 2 + static_cast<int>(random() % 60);
    const int tileSize = 1 << random() % 5;
    const TerrainPyramid pyramid(MakeGround(width, height, GetParam(), round), tileSize, 5);
    std::vector<int> levels;
    for (std::size_t tile = 0; tile < pyramid.GetTiles().size(); ++tile)
    {
      const bool isCulled = random() % 8 == 0;
      levels.push_back(isCulled ? Culled : static_cast<int>(random() % pyramid.GetLevels()));
    }
    ASSERT_NO_FATAL_FAILURE(ExpectWatertight(pyramid, levels)) << width << " x " << height << ", " << tileSize;
  }
}

TEST_P(Grounds, AreWatertightInRandomViews)
{
  std::mt19937 random(12);
  const auto share = [&]() { return static_cast<double>(random() % 100001) / 100000.0; };
  const TerrainPyramid pyramid(MakeGround(203, 118, GetParam(), 5), 16, 5);
  std::size_t mixed = 0; // views in which several levels meet
  for (int round = 0; round < 120; ++round)
  {
    View view;
    view.Point = { 1000.0 + 406.0 * share(), -500.0 + 354.0 * share(), 300.0 * share() };
    view.Direction = { share() - 0.5, share() - 0.5, -share() };
    view.Angle = 0.2 + 1.5 * share();
    TerrainRule rule;
    rule.ByPixelError = round % 2 == 1;
    rule.NearDistance = 100.0 * share();
    rule.FarDistance = rule.NearDistance + 200.0 * share();
    rule.MaximumPixels = 1.0 + 400.0 * share();
    rule.UseCulling = round % 4 < 2;
    const std::vector<int> levels = SelectLevels(pyramid, ViewFrustum(view), rule);
    std::set<int> different(levels.begin(), levels.end());
    different.erase(Culled);
    mixed += static_cast<std::size_t>(different.size() > 1);
    ASSERT_NO_FATAL_FAILURE(ExpectWatertight(pyramid, levels));
  }
  EXPECT_GE(mixed, 10u);
}

INSTANTIATE_TEST_SUITE_P(All, Grounds, testing::Values(Ground::Rough, Ground::Flat, Ground::Slope, Ground::Steps));

TEST(TerrainLevels, CoverTheWholeTerrainAtAnyLevel)
{
  const TerrainPyramid pyramid(MakeGround(75, 38, Ground::Rough, 1), 32, 8);
  EXPECT_EQ(pyramid.GetLevels(), 6); // the cells of level 5 are as large as a tile
  EXPECT_EQ(pyramid.GetTiles().size(), 6u);
  for (int level = 0; level < pyramid.GetLevels(); ++level)
  {
    const std::vector<int> levels(6, level);
    double area = 0.0;
    for (std::size_t tile = 0; tile < 6; ++tile)
    {
      const TerrainPatch patch = MakePatch(pyramid, levels, tile);
      EXPECT_TRUE(patch.Seams.Triangles.empty());
      const TerrainMesh& mesh = patch.Surface;
      for (std::size_t i = 0; i < mesh.Triangles.size(); i += 3)
      {
        const auto at = [&](std::size_t k) {
          return pyramid.GetSamples().Position(mesh.Samples[static_cast<std::size_t>(mesh.Triangles[i + k])]);
        };
        area += 0.5 * glm::cross(at(1) - at(0), at(2) - at(0)).z;
      }
    }
    EXPECT_NEAR(area, 74 * 2.0 * 37 * 3.0, 1e-6);
  }
}

TEST(TerrainLevels, SeamOfAStepOfKLevelsHasTwoToTheKMinusOneTriangles)
{
  const TerrainPyramid pyramid(MakeGround(33, 17, Ground::Rough, 2), 16, 5);
  for (int level = 1; level < 5; ++level)
  {
    const TerrainPatch patch = MakePatch(pyramid, { level, 0 }, 0);
    const std::size_t edges = 16u >> level;
    EXPECT_EQ(patch.Seams.Triangles.size() / 3, edges * ((1u << level) - 1u));
    EXPECT_TRUE(MakePatch(pyramid, { level, 0 }, 1).Seams.Triangles.empty());
  }
}

TEST(TerrainLevels, AreExactOnASlope)
{
  const TerrainPyramid slope(MakeGround(70, 45, Ground::Slope, 0), 16, 5);
  const Vector3 normal = glm::normalize(Vector3(-0.25, 0.25 / 3.0, 1.0));
  for (const TerrainTile& tile : slope.GetTiles())
  {
    for (int level = 0; level < slope.GetLevels(); ++level)
    {
      EXPECT_NEAR(tile.Errors[level], 0.0, 1e-5);
    }
  }
  for (std::size_t sample = 0; sample < slope.GetSamples().Values.size(); ++sample)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_NEAR(slope.GetNormal(sample)[axis], normal[axis], 1e-6);
    }
  }
}

TEST(TerrainLevels, ErrorIsTheHeightOfAPeakThatIsLeftOut)
{
  HeightSamples samples = MakeGround(33, 33, Ground::Flat, 0);
  samples.Values[samples.Index(6, 4)] = 12.0f; // a sample of levels 0 and 1
  const TerrainPyramid pyramid(samples, 32, 4);
  const TerrainTile& tile = pyramid.GetTiles()[0];
  EXPECT_EQ(tile.Errors[0], 0.0f);
  EXPECT_EQ(tile.Errors[1], 2.5f); // halfway to it along an edge
  EXPECT_EQ(tile.Errors[2], 5.0f);
  EXPECT_EQ(tile.Errors[3], 5.0f);
}

TEST(TerrainLevels, ErrorsAreNeverRoundedDown)
{
  // A sample between two: the error is its distance from their mean, exact in double precision.
  int inexact = 0;
  for (unsigned int seed = 1; seed <= 200; ++seed)
  {
    std::mt19937 random(seed);
    HeightSamples samples = MakeGround(3, 3, Ground::Flat, 0);
    for (float& value : samples.Values)
    {
      value = 0.0f;
    }
    const float ends[2] = { static_cast<float>(random() % 1000003) / 7.0f,
      static_cast<float>(random() % 1009) / 11.0f };
    samples.Values[samples.Index(0, 0)] = ends[0];
    samples.Values[samples.Index(2, 0)] = ends[1];
    const double mean = 0.5 * (static_cast<double>(ends[0]) + static_cast<double>(ends[1]));
    const TerrainPyramid pyramid(samples, 2, 2);
    EXPECT_GE(static_cast<double>(pyramid.GetTiles()[0].Errors[1]), mean);
    inexact += static_cast<double>(static_cast<float>(mean)) < mean;
  }
  EXPECT_GT(inexact, 30);
}

namespace
{

/// Waves of several lengths: the error of a level is some three times that of the one before.
HeightSamples MakeWaves(int width, int height)
{
  HeightSamples samples = MakeGround(width, height, Ground::Flat, 0);
  for (std::size_t sample = 0; sample < samples.Values.size(); ++sample)
  {
    const double x = static_cast<double>(sample % width);
    const double y = static_cast<double>(sample / width);
    samples.Values[sample] = static_cast<float>(30.0 * std::sin(0.09 * x + 0.04 * y) +
      8.0 * std::cos(0.21 * y - 0.11 * x) + std::sin(0.7 * x) * std::cos(0.6 * y));
  }
  return samples;
}

/// Height of a mesh's triangle over a sample of the grid, if it is there.
bool HeightOver(const HeightSamples& samples, const std::array<Vector3, 3>& corners, int x, int y, double& height)
{
  const Vector3 place = samples.Position(samples.Index(x, y));
  const auto area = [](const Vector3& a, const Vector3& b, const Vector3& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  };
  const double whole = area(corners[0], corners[1], corners[2]);
  height = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    const double share = area(place, corners[(k + 1) % 3], corners[(k + 2) % 3]) / whole;
    if (share < -1e-12)
    {
      return false;
    }
    height += share * corners[k].z;
  }
  return true;
}

/// The farthest on the picture that the surface of a tile at these levels is from the samples [pixels].
double MeasuredError(
  const TerrainPyramid& pyramid, const std::vector<int>& levels, std::size_t tile, const PictureOf& picture, int& seen)
{
  const HeightSamples& samples = pyramid.GetSamples();
  const TerrainMesh mesh = MakePatch(pyramid, levels, tile).Surface;
  double largest = 0.0;
  for (std::size_t i = 0; i < mesh.Triangles.size(); i += 3)
  {
    std::array<Vector3, 3> corners;
    std::array<int, 2> low{ samples.Width, samples.Height };
    std::array<int, 2> high{ 0, 0 };
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t sample = mesh.Samples[static_cast<std::size_t>(mesh.Triangles[i + k])];
      corners[k] = samples.Position(sample);
      const std::array<int, 2> at{ static_cast<int>(sample % samples.Width), static_cast<int>(sample / samples.Width) };
      for (int axis = 0; axis < 2; ++axis)
      {
        low[axis] = std::min(low[axis], at[axis]);
        high[axis] = std::max(high[axis], at[axis]);
      }
    }
    for (int y = low[1]; y <= high[1]; ++y)
    {
      for (int x = low[0]; x <= high[0]; ++x)
      {
        double height = 0.0;
        const Vector3 full = samples.Position(samples.Index(x, y));
        const bool inside = HeightOver(samples, corners, x, y, height);
        const Vector3 shown(full.x, full.y, height);
        if (inside && (picture.Shows(full) || picture.Shows(shown)))
        {
          largest = std::max(largest, picture.PixelsBetween(full, shown));
          ++seen;
        }
      }
    }
  }
  return largest;
}

}

// All samples against the surface of the level above or below, through a camera's matrix, all over the picture. By the
// distance from the eye alone, without the angle off the axis, the error is up to 2.26 times PixelError here.
TEST(TerrainLevels, ScreenErrorIsKeptAllOverThePicture)
{
  const TerrainPyramid pyramid(MakeWaves(133, 118), 8, 4);
  std::mt19937 random(31);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  int seen[2] = { 0, 0 };
  int kept = 0;
  int tooFine = 0;
  for (int n = 0; n < 120; ++n)
  {
    View view = AnyView(random, 300.0);
    view.Point = { 1000.0 + 264.0 * uniform(random), -500.0 + 351.0 * uniform(random), 45.0 + 250.0 * uniform(random) };
    view.Direction = { uniform(random) - 0.5, uniform(random) - 0.5, -uniform(random) };
    view.Up = { 0.2 * uniform(random), 0.0, 1.0 };
    const bool rounds = n % 3 == 0;
    const ViewFrustum frustum(rounds ? Rounded(view, 4.0, 0.02) : view);
    const PictureOf picture(view);
    TerrainRule rule;
    rule.ByPixelError = true;
    rule.MaximumPixels = 1.0 + n % 12;
    std::vector<int> levels = SelectLevels(pyramid, frustum, rule);
    for (std::size_t tile = 0; tile < levels.size(); ++tile)
    {
      int own = 0;
      const double error = levels[tile] == Culled ? 0.0 : MeasuredError(pyramid, levels, tile, picture, own);
      ASSERT_LE(error, rule.MaximumPixels) << n << (view.IsParallel ? " parallel" : " perspective");
      if (levels[tile] != Culled)
      {
        ASSERT_LE(error, ScreenErrorOf(pyramid.GetTiles()[tile], levels[tile], frustum) * (1.0 + 1e-9));
      }
      seen[view.IsParallel] += own;
      // Tiles that are wholly on the picture and might have been coarser: 19 %, with the distance alone 63 %.
      if (!rounds && own > 9 * 9 && levels[tile] + 1 < pyramid.GetLevels())
      {
        ++levels[tile];
        tooFine += MeasuredError(pyramid, levels, tile, picture, own) <= rule.MaximumPixels;
        ++kept;
        --levels[tile];
      }
    }
  }
  EXPECT_GT(seen[0], 50000);
  EXPECT_GT(seen[1], 50000);
  ASSERT_GT(kept, 500);
  EXPECT_LT(tooFine, 0.25 * kept);
}

TEST(TerrainLevels, LeaveOutMissingHeightsAtAnyLevel)
{
  HeightSamples samples = MakeGround(99, 70, Ground::Rough, 11);
  const float missing = std::numeric_limits<float>::quiet_NaN();
  std::mt19937 random(3);
  for (int k = 0; k < 30; ++k)
  {
    samples.Values[random() % samples.Values.size()] = missing;
  }
  for (int y = 0; y < 40; ++y) // more than a tile
  {
    std::fill_n(samples.Values.begin() + static_cast<std::ptrdiff_t>(samples.Index(10, y)), 45, missing);
  }
  // The ground is the halves of cells whose three corners are there.
  double wanted = 0.0;
  const auto isThere = [&](int x, int y) { return !std::isnan(samples.Values[samples.Index(x, y)]); };
  for (int y = 0; y + 1 < samples.Height; ++y)
  {
    for (int x = 0; x + 1 < samples.Width; ++x)
    {
      const bool isCut = isThere(x, y) && isThere(x + 1, y + 1);
      wanted +=
        0.5 * samples.Spacing[0] * samples.Spacing[1] * ((isCut && isThere(x + 1, y)) + (isCut && isThere(x, y + 1)));
    }
  }
  const TerrainPyramid pyramid(samples, 16, 4);
  View view;
  view.Point = { 1000.0, -500.0, 20.0 };
  for (const double far : { 1e9, 400.0, 50.0 })
  {
    TerrainRule rule;
    rule.NearDistance = far == 1e9 ? 1e8 : 20.0;
    rule.FarDistance = far;
    rule.UseCulling = false;
    const std::vector<int> levels = SelectLevels(pyramid, ViewFrustum(view), rule);
    double area = 0.0;
    std::size_t empty = 0;
    for (std::size_t tile = 0; tile < levels.size(); ++tile)
    {
      empty += levels[tile] == Culled;
      if (levels[tile] == Culled)
      {
        continue;
      }
      const TerrainMesh mesh = MakePatch(pyramid, levels, tile).Surface;
      std::set<int> used(mesh.Triangles.begin(), mesh.Triangles.end());
      EXPECT_EQ(used.size(), mesh.Samples.size());
      for (std::size_t i = 0; i < mesh.Triangles.size(); i += 3)
      {
        const auto corner = [&](std::size_t k) { return samples.Position(mesh.Samples[mesh.Triangles[i + k]]); };
        const Vector3 across = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
        area += 0.5 * across.z; // NaN with a missing height in the others, not in z
        EXPECT_TRUE(std::isfinite(across.x + across.y));
      }
    }
    EXPECT_NEAR(area, wanted, 1e-9 * wanted);
    EXPECT_EQ(empty, 4u); // tiles that lie within the large hole
  }
  const std::vector<float>& normal = { pyramid.GetNormal(samples.Index(9, 20)).begin(),
    pyramid.GetNormal(samples.Index(9, 20)).end() };
  EXPECT_TRUE(std::isfinite(normal[0] + normal[1] + normal[2])); // at the edge of the hole, from its other side
}

TEST(TerrainLevels, ByDistanceAreTheSameEverywhereInParallelProjection)
{
  const TerrainPyramid pyramid(MakeGround(203, 118, Ground::Rough, 9), 16, 5);
  View view;
  view.Point = { 1200.0, -900.0, 250.0 };
  view.Direction = { 0.0, 1.0, -0.3 };
  view.IsParallel = true;
  TerrainRule rule;
  rule.UseCulling = false;
  for (const double scale : { 10.0, 100.0, 300.0, 2000.0 })
  {
    view.ParallelScale = scale;
    const std::vector<int> levels = SelectLevels(pyramid, ViewFrustum(view), rule);
    const int wanted = LevelAtDistance(scale / std::tan(0.5 * view.Angle), rule, pyramid.GetLevels());
    EXPECT_EQ(levels, std::vector<int>(levels.size(), wanted));
  }
}

TEST(TerrainLevels, ByDistanceChangeAtEqualRatios)
{
  TerrainRule rule;
  rule.NearDistance = 100.0;
  rule.FarDistance = 800.0;
  EXPECT_EQ(LevelAtDistance(0.0, rule, 5), 0);
  EXPECT_EQ(LevelAtDistance(100.0, rule, 5), 0);
  EXPECT_EQ(LevelAtDistance(101.0, rule, 5), 1);
  EXPECT_EQ(LevelAtDistance(199.0, rule, 5), 1);
  EXPECT_EQ(LevelAtDistance(201.0, rule, 5), 2);
  EXPECT_EQ(LevelAtDistance(399.0, rule, 5), 2);
  EXPECT_EQ(LevelAtDistance(401.0, rule, 5), 3);
  EXPECT_EQ(LevelAtDistance(799.0, rule, 5), 3);
  EXPECT_EQ(LevelAtDistance(800.0, rule, 5), 4);
  EXPECT_EQ(LevelAtDistance(1e9, rule, 1), 0);
  rule.NearDistance = 0.0; // then at equal differences
  for (int third = 0; third < 3; ++third)
  {
    EXPECT_EQ(LevelAtDistance(800.0 / 3.0 * third + 1.0, rule, 5), third + 1);
    EXPECT_EQ(LevelAtDistance(800.0 / 3.0 * (third + 1) - 1.0, rule, 5), third + 1);
  }
  rule.FarDistance = 0.0;
  EXPECT_EQ(LevelAtDistance(0.0, rule, 5), 0);
  EXPECT_EQ(LevelAtDistance(1e-3, rule, 5), 4);
}
