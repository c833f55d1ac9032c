// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "../OnThreads.h"
#include "Landscapes/VoronoiTiles.h"
#include "Numerics/RandomStream.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

using namespace littoral;
using namespace littoral::testing;

namespace
{

/// Points at random in nine tenths of their cells, those of the border in the middle.
CellPoints RandomPoints(int width, int height, const std::array<double, 2>& size, int seed)
{
  const RandomStream random(seed, RandomPurpose::ElevationLines);
  CellPoints points{ width, height, size, {} };
  for (int n = 0; n < width * height; ++n)
  {
    const int i = n % width;
    const int j = n / width;
    const bool isRim = i == 0 || j == 0 || i == width - 1 || j == height - 1;
    const std::array<double, 2> u = isRim ? std::array<double, 2>{ 0.5, 0.5 } : random.UniformPair(n, 0);
    points.Places.push_back({ static_cast<std::int32_t>(std::lround((i + 0.9 * (u[0] - 0.5)) * size[0])),
      static_cast<std::int32_t>(std::lround((j + 0.9 * (u[1] - 0.5)) * size[1])) });
  }
  return points;
}

/// Sides of the cell of each point, in their order.
std::map<CellIndex, std::vector<std::pair<CellIndex, double>>> SidesOf(const VoronoiCells& cells, int width)
{
  std::map<CellIndex, std::vector<std::pair<CellIndex, double>>> sides;
  for (const VoronoiTile& tile : cells.Tiles)
  {
    auto side = tile.Sides.begin();
    auto count = tile.SideCounts.begin();
    for (int j = tile.First[1]; j < tile.End[1]; ++j)
    {
      for (int i = tile.First[0]; i < tile.End[0]; ++i)
      {
        for (const auto end = side + *count++; side != end; ++side)
        {
          sides[j * width + i].emplace_back(side->Neighbour, side->Length);
        }
      }
    }
  }
  return sides;
}

}

TEST(VoronoiTiles, ChangeNothing)
{
  // also of points of few units, of which many lie on one circle
  for (const std::array<double, 2>& size : { std::array<double, 2>{ 1024.0, 1024.0 }, { 1900.0, 1024.0 },
         { 1024.0, 1300.0 }, { 8.0, 8.0 }, { 3.0 * 1024.0, 1024.0 } })
  {
    const CellPoints points = RandomPoints(97, 61, size, 3);
    VoronoiCells whole = VoronoiCellsOf(points, SerialFor, NoPoll, 1000);
    VoronoiCells tiled = VoronoiCellsOf(points, OnThreads(3), NoPoll, 16);
    EXPECT_EQ(whole.Tiles.size(), 1U);
    EXPECT_EQ(tiled.Tiles.size(), size[0] > 2.0 * size[1] ? 1U : 18U);
    EXPECT_EQ(SidesOf(tiled, 97), SidesOf(whole, 97));
    if (size[0] < 10.0)
    {
      // circles that end at one place have no order
      std::sort(whole.Triangles.begin(), whole.Triangles.end());
      std::sort(tiled.Triangles.begin(), tiled.Triangles.end());
    }
    EXPECT_TRUE(tiled.Triangles == whole.Triangles);
  }
}

TEST(VoronoiTiles, EachTriangleIsThereOnce)
{
  // Euler: n points of which b are on the border have 2n - 2 - b triangles
  for (int seed = 0; seed < 60; ++seed)
  {
    const VoronoiCells cells = VoronoiCellsOf(RandomPoints(21, 38, { 4096.0, 4096.0 }, seed), SerialFor, NoPoll, 9);
    EXPECT_EQ(cells.Triangles.size(), 2U * 20U * 37U) << seed;
  }
}

TEST(VoronoiTiles, TrianglesPaveTheGroundAndTheirCirclesAreEmpty)
{
  const CellPoints points = RandomPoints(30, 40, { 1024.0, 1024.0 }, 5);
  const VoronoiCells cells = VoronoiCellsOf(points, SerialFor, NoPoll, 10);
  std::int64_t twice = 0;
  for (const std::array<CellIndex, 3>& corners : cells.Triangles)
  {
    std::array<std::array<std::int64_t, 2>, 3> p{};
    for (int corner = 0; corner < 3; ++corner)
    {
      p[corner] = { points.Places[corners[corner]][0], points.Places[corners[corner]][1] };
    }
    const std::int64_t area = (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[2][0] - p[0][0]) * (p[1][1] - p[0][1]);
    EXPECT_GT(area, 0);
    twice += area;
    for (const std::array<std::int32_t, 2>& place : points.Places)
    {
      // the determinant of a circle is positive within it
      std::array<std::array<__int128, 3>, 3> m{};
      for (int corner = 0; corner < 3; ++corner)
      {
        const std::int64_t x = p[corner][0] - place[0];
        const std::int64_t y = p[corner][1] - place[1];
        m[corner] = { x, y, x * x + y * y };
      }
      const __int128 circle = m[0][0] * (m[1][1] * m[2][2] - m[2][1] * m[1][2]) -
        m[0][1] * (m[1][0] * m[2][2] - m[2][0] * m[1][2]) + m[0][2] * (m[1][0] * m[2][1] - m[2][0] * m[1][1]);
      EXPECT_LE(circle, 0);
    }
  }
  EXPECT_EQ(twice, 2LL * 29 * 39 * 1024 * 1024);
}
