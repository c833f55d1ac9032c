// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Landscapes/PointMesh.h"

#include "Drainage/ValleySpreading.h"
#include "Landscapes/VoronoiTiles.h"
#include "Numerics/PolledMemory.h"
#include "Numerics/RandomStream.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace littoral
{

namespace
{

/// Part of a cell's sides in which its point lies.
constexpr double InnerPart = 0.9;
constexpr double LargestAside = 0.5 * InnerPart;

/// Integer units of the shorter side of a cell: Boost.Polygon is exact on integers.
constexpr double UnitsACell = 1024.0;

/// Longest link [cells], and largest EdgeRatio: the hull has both.
constexpr double LongestLink = 6.0;
constexpr double LargestRatio = 100.0;

/// Least area of a cell of Voronoi over the grid's.
constexpr double LeastArea = 0.05;

CellPoints JitteredPoints(const PointMesh& mesh, double unit, int seed, int draw, const std::vector<HeldPoint>& held,
  const ParallelFor& parallel)
{
  const auto unitsOf = [&](double metres) { return static_cast<std::int32_t>(std::lround(metres / unit)); };
  const RandomStream random(seed, RandomPurpose::LandscapePoints);
  CellPoints points{ mesh.Width, mesh.Height, { mesh.Spacing[0] / unit, mesh.Spacing[1] / unit }, {} };
  points.Places.resize(static_cast<std::size_t>(mesh.Width) * mesh.Height);
  parallel(points.Places.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t place = begin; place < end; ++place)
    {
      const auto n = static_cast<CellIndex>(place);
      const std::array<double, 2> u = random.UniformPair(n, draw);
      const double jitter = mesh.IsRim(n) ? 0.0 : InnerPart;
      // x = (i + j (u - 1/2)) dx
      const double x = (n % mesh.Width + jitter * (u[0] - 0.5)) * mesh.Spacing[0];
      const double y = (n / mesh.Width + jitter * (u[1] - 0.5)) * mesh.Spacing[1];
      points.Places[place] = { unitsOf(x), unitsOf(y) };
    }
  });
  for (const HeldPoint& point : held)
  {
    if (!mesh.IsRim(point.Cell))
    {
      const std::array<int, 2> cell{ point.Cell % mesh.Width, point.Cell / mesh.Width };
      const auto unitsAlong = [&](int axis) {
        const double aside =
          std::clamp(point.Place[axis] / mesh.Spacing[axis] - cell[axis], -LargestAside, LargestAside);
        return unitsOf((cell[axis] + aside) * mesh.Spacing[axis]);
      };
      points.Places[point.Cell] = { unitsAlong(0), unitsAlong(1) };
    }
  }
  return points;
}

/// Calls visit(point, neighbour, distance, edge) for the links of the points of a tile, point by point.
template <typename Visit>
void ForEachLink(const PointMesh& mesh, const VoronoiTile& tile, const Visit& visit)
{
  const double longest = LongestLink * std::max(mesh.Spacing[0], mesh.Spacing[1]);
  auto count = tile.SideCounts.begin();
  auto side = tile.Sides.begin();
  for (int row = tile.First[1]; row < tile.End[1]; ++row)
  {
    for (int column = tile.First[0]; column < tile.End[0]; ++column)
    {
      const CellIndex point = row * mesh.Width + column;
      for (const auto end = side + *count++; side != end; ++side)
      {
        const double distance = std::hypot(mesh.Points[side->Neighbour][0] - mesh.Points[point][0],
          mesh.Points[side->Neighbour][1] - mesh.Points[point][1]);
        if (distance <= longest)
        {
          visit(point, side->Neighbour, distance, side->Length);
        }
      }
    }
  }
}

void AddLinks(
  PointMesh& mesh, const std::vector<VoronoiTile>& tiles, double unit, const ParallelFor& parallel, const Poll& poll)
{
  const auto forLinks = [&](const auto& visit) {
    parallel(tiles.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t tile = begin; tile < end; ++tile)
      {
        ForEachLink(mesh, tiles[tile], visit);
      }
    });
  };
  Lengthen(mesh.First, static_cast<std::size_t>(mesh.Count()) + 1, poll);
  forLinks([&](CellIndex point, CellIndex, double, double) { ++mesh.First[point + 1]; });
  ForPolled(mesh.First.size() - 1, poll, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      mesh.First[n + 1] += mesh.First[n];
    }
  });
  const auto links = static_cast<std::size_t>(mesh.First.back());
  Lengthen(mesh.Neighbour, links, poll);
  Lengthen(mesh.Distance, links, poll);
  Lengthen(mesh.EdgeRatio, links, poll);
  Lengthen(mesh.Area, mesh.Points.size(), poll);
  const double cell = mesh.Spacing[0] * mesh.Spacing[1];
  std::vector<CellIndex> next = CopyOf(mesh.First, poll);
  forLinks([&](CellIndex point, CellIndex neighbour, double distance, double edge) {
    const CellIndex link = next[point]++;
    mesh.Neighbour[link] = neighbour;
    mesh.Distance[link] = distance;
    mesh.EdgeRatio[link] = std::min(edge * unit / distance, LargestRatio);
    // two triangles with the edge as base and half the distance as height: e d / 4 on this side
    mesh.Area[point] += 0.25 * mesh.EdgeRatio[link] * distance * distance;
  });
  ForPolled(mesh.Area.size(), poll, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      mesh.Area[n] = std::max(mesh.Area[n], LeastArea * cell);
    }
  });
}

/// Nodes of half a cell's spacing, over the same rectangle.
GridSamples HalfCells(const PointMesh& mesh, const std::vector<double>& heights, const Poll& poll)
{
  GridSamples fine;
  fine.Width = 2 * mesh.Width - 1;
  fine.Height = 2 * mesh.Height - 1;
  fine.Spacing = { 0.5 * mesh.Spacing[0], 0.5 * mesh.Spacing[1] };
  fine.Values.reserve(static_cast<std::size_t>(fine.Width) * fine.Height);
  for (int j = 0; j < fine.Height; ++j)
  {
    poll();
    for (int i = 0; i < fine.Width; ++i)
    {
      fine.Values.push_back(heights[static_cast<std::size_t>(j / 2) * mesh.Width + i / 2]);
    }
  }
  return fine;
}

/// Sets the nodes of a triangle to its plane, z = sum b_k z_k with barycentric coordinates b.
void FillTriangle(const std::array<std::array<double, 2>, 3>& p, const std::array<double, 3>& z, GridSamples& fine)
{
  constexpr double edge = 1e-9; // nodes on edges belong to both sides, where both planes agree
  const double twice = (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[2][0] - p[0][0]) * (p[1][1] - p[0][1]);
  const auto range = [&](int axis, int most) {
    const auto [low, high] = std::minmax({ p[0][axis], p[1][axis], p[2][axis] });
    return std::array<int, 2>{ std::max(0, static_cast<int>(std::ceil(low / fine.Spacing[axis] - edge))),
      std::min(most - 1, static_cast<int>(std::floor(high / fine.Spacing[axis] + edge))) };
  };
  const std::array<int, 2> rows = range(1, fine.Height);
  const std::array<int, 2> columns = range(0, fine.Width);
  for (int j = rows[0]; j <= rows[1] && twice != 0.0; ++j)
  {
    for (int i = columns[0]; i <= columns[1]; ++i)
    {
      const double x = i * fine.Spacing[0] - p[0][0];
      const double y = j * fine.Spacing[1] - p[0][1];
      const double b1 = (x * (p[2][1] - p[0][1]) - (p[2][0] - p[0][0]) * y) / twice;
      const double b2 = ((p[1][0] - p[0][0]) * y - x * (p[1][1] - p[0][1])) / twice;
      if (b1 >= -edge && b2 >= -edge && b1 + b2 <= 1.0 + edge)
      {
        fine.At(i, j) = z[0] + b1 * (z[1] - z[0]) + b2 * (z[2] - z[0]);
      }
    }
  }
}

}

bool PointMesh::IsRim(CellIndex point) const
{
  const int i = point % this->Width;
  const int j = point / this->Width;
  return i == 0 || j == 0 || i == this->Width - 1 || j == this->Height - 1;
}

PointMesh JitteredMesh(int width, int height, const std::array<double, 2>& spacing, int seed, int draw,
  const std::vector<HeldPoint>& held, const ParallelFor& parallel, const Poll& poll)
{
  PointMesh mesh;
  mesh.Width = width;
  mesh.Height = height;
  mesh.Spacing = spacing;
  const double unit = std::min(spacing[0], spacing[1]) / UnitsACell;
  const CellPoints points = JitteredPoints(mesh, unit, seed, draw, held, parallel);
  Lengthen(mesh.Points, points.Places.size(), poll);
  parallel(mesh.Points.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      mesh.Points[n] = { points.Places[n][0] * unit, points.Places[n][1] * unit };
    }
  });
  VoronoiCells cells = VoronoiCellsOf(points, parallel, poll);
  mesh.Corners = std::move(cells.Triangles);
  AddLinks(mesh, cells.Tiles, unit, parallel, poll);
  return mesh;
}

GridSamples GridOf(
  const PointMesh& mesh, const std::vector<double>& heights, const ParallelFor& parallel, const Poll& poll)
{
  GridSamples fine = HalfCells(mesh, heights, poll);
  ForPolled(mesh.Corners.size(), poll, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      const auto& [a, b, c] = mesh.Corners[n];
      FillTriangle({ mesh.Points[a], mesh.Points[b], mesh.Points[c] }, { heights[a], heights[b], heights[c] }, fine);
    }
  });
  SmoothGrid(fine.Values, fine.Width, fine.Height, 1.0, parallel);
  GridSamples grid;
  grid.Width = mesh.Width;
  grid.Height = mesh.Height;
  grid.Spacing = mesh.Spacing;
  grid.Values.reserve(heights.size());
  for (int row = 0; row < mesh.Height; ++row)
  {
    poll();
    for (int column = 0; column < mesh.Width; ++column)
    {
      grid.Values.push_back(fine.At(2 * column, 2 * row));
    }
  }
  return grid;
}

}
