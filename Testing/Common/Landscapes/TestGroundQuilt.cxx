// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "../Drainage/RandomGround.h"
#include "../OnThreads.h"
#include "Drainage/CoarseGround.h"
#include "Drainage/DepressionFilling.h"
#include "Drainage/DrainageOutlets.h"
#include "Drainage/ValleySpreading.h"
#include "Landscapes/GroundQuilt.h"
#include "Landscapes/LandscapeQuilting.h"
#include "Landscapes/LongWaves.h"
#include "Landscapes/PlaceMatching.h"
#include "Landscapes/StandingWater.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <vector>

using namespace littoral;
using namespace littoral::testing;

namespace
{

/// Hills some ten cells wide, with a tenth of roughness from cell to cell.
GridSamples Hills(int width, int height, int seed)
{
  GridSamples hills = RandomGround(width, height, { 10.0, 10.0 }, seed);
  const GridSamples rough = hills;
  SmoothGrid(hills.Values, width, height, 5.0);
  for (std::size_t n = 0; n < hills.Values.size(); ++n)
  {
    hills.Values[n] = 100.0 * hills.Values[n] + rough.Values[n];
  }
  return hills;
}

GridSamples Smooth(GridSamples ground, double deviation)
{
  SmoothGrid(ground.Values, ground.Width, ground.Height, deviation);
  return ground;
}

/// Root mean square of the differences from cell to cell.
double Steepness(const GridSamples& ground)
{
  double sum = 0.0;
  int count = 0;
  for (int j = 1; j < ground.Height; ++j)
  {
    for (int i = 1; i < ground.Width; ++i)
    {
      sum += std::pow(ground.At(i, j) - ground.At(i - 1, j), 2) + std::pow(ground.At(i, j) - ground.At(i, j - 1), 2);
      count += 2;
    }
  }
  return std::sqrt(sum / count);
}

double Correlation(const GridSamples& one, const GridSamples& other)
{
  const SampleMoments of[] = { Moments(one), Moments(other) };
  double sum = 0.0;
  for (std::size_t n = 0; n < one.Values.size(); ++n)
  {
    sum += (one.Values[n] - of[0].Mean) * (other.Values[n] - of[1].Mean);
  }
  return sum / std::sqrt(of[0].Variance * of[1].Variance) / static_cast<double>(one.Values.size());
}

/// Corner of the square of a place whose differences from cell to cell are nearest to those of a square of a ground,
/// and the root mean square by which they differ.
struct Source
{
  int X = 0;
  int Y = 0;
  double Error = std::numeric_limits<double>::infinity();
};

Source SourceOf(const GridSamples& ground, int x, int y, int side, const GridSamples& place)
{
  Source best;
  for (int row = 0; row + side < place.Height; ++row)
  {
    for (int column = 0; column + side < place.Width; ++column)
    {
      double sum = 0.0;
      for (int j = 0; j < side; ++j)
      {
        for (int i = 0; i < side; ++i)
        {
          const double is = ground.At(x + i + 1, y + j) - ground.At(x + i, y + j);
          const double shall = place.At(column + i + 1, row + j) - place.At(column + i, row + j);
          sum += (is - shall) * (is - shall);
        }
      }
      const double error = std::sqrt(sum / (side * side));
      best = error < best.Error ? Source{ column, row, error } : best;
    }
  }
  return best;
}

constexpr int Period = 84; ///< of hills along x [cells]
constexpr int Copies = 3;  ///< of a period in each half of a place
constexpr int Draws = 20;

/// Pairs of pieces side by side, of so many draws, that are of different halves of a place: of hills, and of the same
/// ones that are rough. Some Copies / (2 Copies - 1) are where roughness tells nothing, as the next piece of the same
/// copy would go on in the place.
template <typename Hill, typename Rough>
int OtherHalves(const Hill& hill, const Rough& rough)
{
  constexpr int first = 15;
  const GridSamples place = Ground(2 * Copies * Period, 40, { 1.0, 1.0 },
    [&](double x, double) { return hill(x) + (x < Copies * Period ? 0.0 : rough(x)); });
  const GridSamples smooth = Smooth(place, GuideSmoothing(place));
  const GridSamples guide = Ground(46, 20, { 1.0, 1.0 },
    [&](double x, double y) { return smooth.At(first + static_cast<int>(x), static_cast<int>(y)); });
  int others = 0;
  for (int seed = 1; seed <= Draws; ++seed)
  {
    const GridSamples quilt = QuiltGround(place, guide, 30, seed);
    const auto isRough = [&](int begin) { // by cells that are of one piece
      return Steepness(Ground(10, 20, { 1.0, 1.0 }, [&](double x, double y) {
        return quilt.At(begin + static_cast<int>(x), static_cast<int>(y)) - hill(first + begin + x);
      })) > 0.1;
    };
    others += isRough(2) != isRough(34) ? 1 : 0;
  }
  return others;
}

}

TEST(GroundQuilt, RampIsARamp)
{
  // pieces with the guide's heights differ across the slope alone, and fit without a seam; the place has room for one
  // that none of those beside it forbids
  for (const std::array<double, 2>& slope : { std::array<double, 2>{ 0.3, 0.0 }, std::array<double, 2>{ 0.0, 0.3 } })
  {
    const auto ramp = [&](double x, double y) { return 5.0 + slope[0] * x + slope[1] * y; };
    const GridSamples place =
      Ground(160, 160, { 2.0, 3.0 }, [&](double x, double y) { return ramp(x - 80.0, y - 120.0); });
    const GridSamples guide = Ground(64, 56, { 2.0, 3.0 }, ramp);
    const GridSamples quilt = QuiltGround(place, guide, PieceSideFor(place), 3);
    ASSERT_EQ(quilt.Values.size(), guide.Values.size());
    for (std::size_t n = 0; n < guide.Values.size(); ++n)
    {
      ASSERT_NEAR(quilt.Values[n], guide.Values[n], 1e-4);
    }
  }
}

TEST(GroundQuilt, PiecesAreThePlaceInAnotherOrder)
{
  const GridSamples place = Hills(100, 100, 1);
  const int side = PieceSideFor(place);
  ASSERT_EQ(side, 30);
  const GridSamples guide = Smooth(Hills(80, 80, 2), GuideSmoothing(place));
  const GridSamples quilt = QuiltGround(place, guide, side, 1);
  EXPECT_NEAR(Steepness(quilt) / Steepness(place), 1.0, 0.05);
  // squares begin each 21 cells and up to 4 before, and are under no other from the 9th on
  constexpr int step = 21;
  constexpr int first = 9;
  constexpr int margin = 4;
  std::vector<Source> shifts;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      const int x = column * step + first;
      const int y = row * step + first;
      Source shift;
      for (int n = 0; n < (margin + 1) * (margin + 1); ++n)
      {
        const int left = x - n % (margin + 1);
        const int below = y - n / (margin + 1);
        const Source source = SourceOf(quilt, left, below, step - first - 1, place);
        shift = source.Error < shift.Error ? Source{ source.X - left, source.Y - below, source.Error } : shift;
      }
      EXPECT_LT(shift.Error, 0.2 * Steepness(place));
      shifts.push_back(shift);
      const auto differs = [&](int across, int up) {
        const Source& other = shifts[(row + up) * 3 + column + across];
        return std::max(std::abs(shifts.back().X - other.X), std::abs(shifts.back().Y - other.Y)) >= side / 2;
      };
      EXPECT_TRUE(column == 0 || differs(-1, 0));
      EXPECT_TRUE(row == 0 || differs(0, -1));
      EXPECT_TRUE(row == 0 || column == 0 || differs(-1, -1));
      EXPECT_TRUE(row == 0 || column == 2 || differs(1, -1));
    }
  }
}

TEST(GroundQuilt, DrawsAmongPiecesOfNearlyTheLeastCost)
{
  // two halves of a place are the same but for a factor, by which one costs a tenth more
  constexpr double period = 100.0;
  constexpr double factor = 1.002;
  const auto wave = [](double x, double number, double phase) {
    return std::sin(2.0 * M_PI * number * x / period + phase);
  };
  const GridSamples place = Ground(200, 60, { 1.0, 1.0 }, [&](double x, double y) {
    const double height =
      wave(x, 1.0, 0.0) + 0.6 * wave(x, 3.0, 1.0) + 0.3 * wave(x, 7.0, 0.2 * y) + std::sin(y / 17.0);
    return x < period ? height : factor * height;
  });
  constexpr int side = 30;
  const GridSamples smooth = Smooth(place, GuideSmoothing(place));
  const auto part = [](const GridSamples& ground) {
    return Ground(20, 20, { 1.0, 1.0 },
      [&](double x, double y) { return ground.At(40 + static_cast<int>(x), 20 + static_cast<int>(y)); });
  };
  int others = 0;
  constexpr int draws = 20;
  for (int seed = 1; seed <= draws; ++seed)
  {
    const double steepness = Steepness(QuiltGround(place, part(smooth), side, seed)) / Steepness(part(place));
    EXPECT_NEAR(steepness, steepness < std::sqrt(factor) ? 1.0 : factor, 1e-4);
    others += steepness < std::sqrt(factor) ? 0 : 1;
  }
  EXPECT_NEAR(others, draws / 2, 6);
}

TEST(GroundQuilt, RoughnessIsNoReasonAndWavesAre)
{
  // Softening leaves 1/27 of waves of two cells, so that either half lies beside the other, and exp(-k^2/2) = 0.58 of
  // those of six, of equal power, which fit no ground without.
  const auto hill = [](double x) { return 100.0 * std::cos(2.0 * M_PI * (x + 0.5) / Period); };
  const auto wave = [](double x, int length, double size) { return size * std::cos(2.0 * M_PI * x / length); };
  EXPECT_NEAR(OtherHalves(hill, [&](double x) { return wave(x, 2, 0.27); }), Draws * Copies / (2 * Copies - 1), 6);
  EXPECT_EQ(OtherHalves(hill, [&](double x) { return wave(x, 6, 0.27 * std::sqrt(2.0)); }), 0);
}

TEST(GroundQuilt, WaterMeetsWater)
{
  // lakes in the valleys of the first half alone: the second half's are rough
  const auto hill = [](double x) { return 100.0 * std::max(-0.4, std::cos(2.0 * M_PI * (x + 0.5) / Period)); };
  EXPECT_EQ(OtherHalves(hill, [](double x) { return 0.2 * std::cos(M_PI * x); }), 0);
}

TEST(GroundQuilt, WaterIsNotUsedUp)
{
  // a guide nearest to the sea, for many more squares than there are pieces of sea side by side
  const GridSamples rough = RandomGround(120, 60, { 1.0, 1.0 }, 1);
  const GridSamples place = Ground(120, 60, { 1.0, 1.0 }, [&](double x, double y) {
    return x < 90.0 ? 0.0 : 10.0 + 0.2 * rough.At(static_cast<int>(x), static_cast<int>(y));
  });
  const GridSamples guide = Ground(240, 240, { 1.0, 1.0 }, [](double, double) { return -1.0; });
  const GridSamples quilt = QuiltGround(place, guide, PieceSideFor(place), 1);
  const auto land = std::count_if(quilt.Values.begin(), quilt.Values.end(), [](double height) { return height > 5.0; });
  EXPECT_EQ(land, 0);
}

TEST(StandingWater, IsLevelGroundOfSoManyCells)
{
  const auto count = [](const auto& height) {
    const std::vector<std::uint8_t> water = StandingWater(Ground(30, 25, { 1.0, 2.0 }, height), 100);
    return std::accumulate(water.begin(), water.end(), 0);
  };
  const auto slope = [](double x, double y) { return 100.0 + x + 31.0 * y; };
  const auto lake = [&](double width, double height) {
    return count(
      [=](double x, double y) { return x >= 3 && x < 3 + width && y >= 4 && y < 2 * height + 4 ? 7.0 : slope(x, y); });
  };
  EXPECT_EQ(count(slope), 0);
  EXPECT_EQ(lake(9, 11), 0);
  EXPECT_EQ(lake(10, 10), 100);
  EXPECT_EQ(lake(20, 9), 180);
  // two lakes that touch at a corner, and two of other levels side by side
  EXPECT_EQ(count([&](double x, double y) {
    const bool isFirst = x < 9 && y < 20;
    const bool isSecond = x >= 9 && x < 18 && y >= 20 && y < 40;
    return isFirst || isSecond ? 7.0 : slope(x, y);
  }),
    0);
  EXPECT_EQ(count([&](double x, double y) { return y < 20 && x < 18 ? (x < 9 ? 7.0 : 8.0) : slope(x, y); }), 0);
}

TEST(GroundQuilt, FollowsItsGuide)
{
  const GridSamples place = Hills(100, 90, 1);
  const int side = PieceSideFor(place);
  const GridSamples guide = Smooth(Hills(110, 70, 2), GuideSmoothing(place));
  const GridSamples quilt = Smooth(QuiltGround(place, guide, side, 1), GuideSmoothing(place));
  EXPECT_GT(Correlation(quilt, guide), 0.8);
}

TEST(GroundQuilt, SeedsDifferAndThreadsDoNot)
{
  const GridSamples place = Hills(60, 50, 1);
  const GridSamples guide = Smooth(Hills(64, 52, 2), 5.0);
  const GridSamples one = QuiltGround(place, guide, 20, 1);
  for (const int threads : { 2, 5 })
  {
    EXPECT_EQ(QuiltGround(place, guide, 20, 1, OnThreads(threads)).Values, one.Values);
  }
  EXPECT_NE(QuiltGround(place, guide, 20, 2).Values, one.Values);
  EXPECT_NE(QuiltGround(place, guide, 20, 1, SerialFor, NoProgress, 1).Values, one.Values);
}

TEST(LandscapeQuilting, LandscapeDrainsAndIsLikeThePlace)
{
  GridSamples place = Hills(120, 100, 1);
  place.Values =
    FloodDepressions(place, BorderOutlets(120, 100)).SpillElevation; // has no depressions, so twins have none
  const PlaceMatching matching(place, TargetOf(place));
  for (const int seed : { 1, 2, 3 })
  {
    GridSamples terrain = Hills(110, 90, 1 + seed);
    const CarvingReport report = QuiltLandscape(terrain, place, seed);
    EXPECT_EQ(FloodDepressions(terrain, BorderOutlets(110, 90)).DepressionCells, 0u);
    EXPECT_NEAR(report.After.StandardDeviation / std::sqrt(Moments(place).Variance), 1.0, 0.15);
    EXPECT_NEAR(Steepness(terrain) / Steepness(place), 1.0, 0.06);
    EXPECT_LT(matching.SemivarianceError(terrain), 0.15);
    // follows the long waves of the terrain, whose ranks are those of the place
    const GridSamples waves[] = { Smooth(Hills(110, 90, 1 + seed), 8.0), Smooth(terrain, 8.0) };
    EXPECT_GT(Correlation(waves[0], waves[1]), 0.9);
  }
}

TEST(LandscapeQuilting, AboutAsManyCellsAreSunkAsInThePlace)
{
  const auto sunk = [](const GridSamples& ground) {
    const OutletMask border = BorderOutlets(ground.Width, ground.Height);
    return static_cast<double>(FloodDepressions(ground, border).DepressionCells) / (ground.Width * ground.Height);
  };
  const GridSamples pits = Smooth(RandomGround(60, 60, { 0.1, 0.1 }, 1), 1.5);
  ASSERT_GT(sunk(pits), 0.2);
  GridSamples filled = pits;
  filled.Values = FloodDepressions(pits, BorderOutlets(60, 60)).SpillElevation;
  for (const int seed : { 2, 3, 4 })
  {
    const GridSamples terrain = Smooth(RandomGround(64, 60, { 0.1, 0.1 }, seed), 1.5);
    ASSERT_GT(sunk(terrain), 0.2);
    GridSamples drained = terrain;
    QuiltLandscape(drained, filled, seed);
    EXPECT_EQ(sunk(drained), 0.0);
    GridSamples twin = terrain;
    QuiltLandscape(twin, pits, seed);
    EXPECT_LT(sunk(twin), 1.2 * sunk(pits));
    EXPECT_GT(sunk(twin), 0.5 * sunk(pits));
  }
}

TEST(LandscapeQuilting, LongWavesAreThoseOfACoarseQuilt)
{
  const GridSamples place = Hills(160, 160, 1);
  const auto waves = [](GridSamples ground) { // as long as the guide's or shorter than twice these
    RemovePlane(ground);
    GridSamples band = Smooth(ground, 7.0);
    const GridSamples longer = Smooth(ground, 14.0);
    for (std::size_t n = 0; n < band.Values.size(); ++n)
    {
      band.Values[n] -= longer.Values[n];
    }
    return band;
  };
  for (const int seed : { 2, 3 })
  {
    const GridSamples terrain = Hills(161, 160, seed);
    GridSamples coarse = CoarseGround(terrain);
    QuiltLandscape(coarse, BlockMeans(place, 2), seed);
    GridSamples twin = terrain;
    QuiltLandscape(twin, place, seed);
    const GridSamples is = waves(CoarseGround(twin));
    EXPECT_GT(Correlation(is, waves(coarse)), Correlation(is, waves(CoarseGround(terrain))) + 0.05);
  }
}

TEST(LandscapeQuilting, HolesStay)
{
  GridSamples place = Hills(60, 60, 1);
  GridSamples terrain = Hills(64, 60, 2);
  const double none = std::numeric_limits<double>::quiet_NaN();
  for (int n = 20; n < 30; ++n)
  {
    place.At(n, 12) = terrain.At(5, n) = none;
  }
  QuiltLandscape(terrain, place, 1);
  for (int j = 0; j < terrain.Height; ++j)
  {
    for (int i = 0; i < terrain.Width; ++i)
    {
      ASSERT_EQ(std::isnan(terrain.At(i, j)), i == 5 && j >= 20 && j < 30);
    }
  }
}

TEST(LandscapeQuilting, RefusesCellsOfOtherSizes)
{
  const GridSamples place = Hills(40, 40, 1);
  GridSamples terrain = Hills(40, 40, 2);
  EXPECT_EQ(WhyNoQuilt(terrain, place), "");
  terrain.Spacing[1] = 12.0;
  EXPECT_NE(WhyNoQuilt(terrain, place).find("10 x 10 m"), std::string::npos);
  EXPECT_NE(WhyNoQuilt(Hills(40, 15, 2), place), "");
  EXPECT_NE(WhyNoQuilt(place, Hills(15, 40, 2)), "");
}
