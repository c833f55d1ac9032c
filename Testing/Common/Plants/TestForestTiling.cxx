// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Tiles of forests: each tree once in each level, quarters of equal numbers, errors that fall.
#include "Plants/ForestTiling.h"

#include "Numerics/Constants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

using namespace littoral;

namespace
{

std::vector<std::array<double, 2>> Feet(int trees, double width, double depth)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<std::array<double, 2>> feet(trees);
  for (std::array<double, 2>& foot : feet)
  {
    foot = { { width * uniform(random) * uniform(random), depth * uniform(random) } };
  }
  return feet;
}

}

TEST(ForestTiling, EachTreeIsOnceInFullInTilesThatPartTheirParent)
{
  ForestTilingOptions options;
  options.TreesPerTile = 10;
  for (const int trees : { 1, 2, 10, 11, 40, 41, 5000 })
  {
    const auto feet = Feet(trees, 1000.0, 200.0);
    const ForestTiling tiling(feet, options);
    std::vector<int> order = tiling.GetOrder();
    std::sort(order.begin(), order.end());
    std::vector<int> all(trees);
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(order, all);
    const std::vector<ForestTile>& tiles = tiling.GetTiles();
    std::size_t inFull = 0;
    for (const ForestTile& tile : tiles)
    {
      inFull += tile.Level == PlantLevel::High ? tile.End - tile.First : 0;
      EXPECT_EQ(tile.Children.empty(), tile.Level == PlantLevel::High);
      std::size_t at = tile.First;
      for (const int child : tile.Children)
      {
        EXPECT_EQ(tiles[child].First, at);
        at = tiles[child].End;
        EXPECT_LT(tiles[child].Error, tile.Error);
        EXPECT_TRUE(tiles[child].Places == child || tiles[child].Places == tile.Places);
        EXPECT_TRUE(tile.Stride == 4 * tiles[child].Stride || (tile.Stride == 1 && tiles[child].Stride == 1));
      }
      EXPECT_TRUE(tile.Children.empty() || at == tile.End);
      EXPECT_TRUE(tile.Level != PlantLevel::High || tile.End - tile.First <= 10);
    }
    EXPECT_EQ(inFull, static_cast<std::size_t>(trees));
  }
  EXPECT_TRUE(ForestTiling({}, options).GetTiles().empty());
}

TEST(ForestTiling, QuartersAreCompactAndAsLargeAsEachOther)
{
  ForestTilingOptions options;
  options.TreesPerTile = 64;
  const auto feet = Feet(4096, 4000.0, 100.0);
  const ForestTiling tiling(feet, options);
  for (const ForestTile& tile : tiling.GetTiles())
  {
    const std::size_t trees = tile.End - tile.First;
    EXPECT_EQ(4096 % trees, 0u);
    double low = 1e9;
    double high = -1e9;
    for (std::size_t place = tile.First; place < tile.End; ++place)
    {
      low = std::min(low, feet[tiling.GetOrder()[place]][0]);
      high = std::max(high, feet[tiling.GetOrder()[place]][0]);
    }
    // A strip is cut across, not along: its trees, denser at one end, have up to a fourth of it.
    EXPECT_TRUE(trees > 1024 || high - low < 2500.0);
  }
}

TEST(ForestTiling, ErrorsAreThoseOfAViewerAtTheDistances)
{
  // A length e fills 16 of 1080 pixels of a view of 60 degrees where e / (2 d tan 30) = 16 / 1080.
  EXPECT_NEAR(ErrorAt(100.0) / (2.0 * 100.0 * std::tan(Pi / 6.0)), 16.0 / 1080.0, 1e-15);
  ForestTilingOptions options;
  options.TreesPerTile = 4;
  options.NearDistance = 20.0;
  options.FarDistance = 50.0;
  const auto feet = Feet(1024, 320.0, 320.0);
  const ForestTiling tiling(feet, options);
  for (const ForestTile& tile : tiling.GetTiles())
  {
    const double wanted = tile.Level == PlantLevel::High ? 0.0
      : tile.Level == PlantLevel::Medium                 ? ErrorAt(20.0)
                                                         : ErrorAt(50.0);
    EXPECT_TRUE(tile.Stride > 1 ? tile.Error >= wanted : tile.Error == wanted);
  }
  // 1024 = 4 4^4: in full four cuts below the root, Low from two cuts below it.
  EXPECT_EQ(tiling.GetTiles()[0].Stride, 16u);
}

TEST(ForestTiling, RefusesWhatMakesNoTiles)
{
  ForestTilingOptions options;
  options.TreesPerTile = 0;
  EXPECT_NE(WhyInvalid(options).find("TreesPerTile"), std::string::npos);
  options = {};
  options.NearDistance = 0.0;
  EXPECT_NE(WhyInvalid(options).find("NearDistance"), std::string::npos);
  options = {};
  options.FarDistance = 10.0;
  EXPECT_NE(WhyInvalid(options).find("FarDistance"), std::string::npos);
  EXPECT_EQ(WhyInvalid(ForestTilingOptions()), "");
}
