// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Landscapes/PointMesh.h"

#include "Drainage/ValleySpreading.h"
#include "Numerics/RandomStream.h"

#include <boost/polygon/voronoi.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace littoral
{

namespace
{

using Diagram = boost::polygon::voronoi_diagram<double>;

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

using IntegerPoint = boost::polygon::point_data<std::int32_t>;

std::vector<IntegerPoint> JitteredPoints(
  const PointMesh& mesh, double unit, int seed, int draw, const std::vector<HeldPoint>& held)
{
  const RandomStream random(seed, RandomPurpose::LandscapePoints);
  std::vector<IntegerPoint> points;
  const CellIndex count = mesh.Width * mesh.Height;
  for (CellIndex n = 0; n < count; ++n)
  {
    const std::array<double, 2> u = random.UniformPair(n, draw);
    const int column = n % mesh.Width;
    const int row = n / mesh.Width;
    const double jitter = mesh.IsRim(n) ? 0.0 : InnerPart;
    // x = (i + j (u - 1/2)) dx
    const double x = (column + jitter * (u[0] - 0.5)) * mesh.Spacing[0];
    const double y = (row + jitter * (u[1] - 0.5)) * mesh.Spacing[1];
    points.emplace_back(
      static_cast<std::int32_t>(std::lround(x / unit)), static_cast<std::int32_t>(std::lround(y / unit)));
  }
  for (const HeldPoint& point : held)
  {
    if (!mesh.IsRim(point.Cell))
    {
      const std::array<int, 2> cell{ point.Cell % mesh.Width, point.Cell / mesh.Width };
      const auto unitsAlong = [&](int axis) {
        const double aside =
          std::clamp(point.Place[axis] / mesh.Spacing[axis] - cell[axis], -LargestAside, LargestAside);
        return static_cast<std::int32_t>(std::lround((cell[axis] + aside) * mesh.Spacing[axis] / unit));
      };
      points[point.Cell] = IntegerPoint(unitsAlong(0), unitsAlong(1));
    }
  }
  return points;
}

double LengthOf(const Diagram::edge_type& edge)
{
  return edge.is_finite()
    ? std::hypot(edge.vertex1()->x() - edge.vertex0()->x(), edge.vertex1()->y() - edge.vertex0()->y())
    : 0.0;
}

/// Calls visit(point, neighbour, edge) for the links of all points, point by point.
template <typename Visit>
void ForEachLink(const PointMesh& mesh, const Diagram& diagram, const Visit& visit)
{
  const double longest = LongestLink * std::max(mesh.Spacing[0], mesh.Spacing[1]);
  for (const Diagram::cell_type& cell : diagram.cells())
  {
    const auto point = static_cast<CellIndex>(cell.source_index());
    const Diagram::edge_type* edge = cell.incident_edge();
    do
    {
      const auto neighbour = static_cast<CellIndex>(edge->twin()->cell()->source_index());
      const double distance = std::hypot(
        mesh.Points[neighbour][0] - mesh.Points[point][0], mesh.Points[neighbour][1] - mesh.Points[point][1]);
      if (distance <= longest)
      {
        visit(point, neighbour, distance, LengthOf(*edge));
      }
      edge = edge->next();
    }
    while (edge != cell.incident_edge());
  }
}

void AddLinks(PointMesh& mesh, const Diagram& diagram, double unit)
{
  mesh.First.assign(static_cast<std::size_t>(mesh.Count()) + 1, 0);
  ForEachLink(mesh, diagram, [&](CellIndex point, CellIndex, double, double) { ++mesh.First[point + 1]; });
  for (CellIndex n = 0; n < mesh.Count(); ++n)
  {
    mesh.First[n + 1] += mesh.First[n];
  }
  const auto links = static_cast<std::size_t>(mesh.First.back());
  mesh.Neighbour.resize(links);
  mesh.Distance.resize(links);
  mesh.EdgeRatio.resize(links);
  const double cell = mesh.Spacing[0] * mesh.Spacing[1];
  mesh.Area.assign(mesh.Count(), 0.0);
  std::vector<CellIndex> next(mesh.First.begin(), mesh.First.end() - 1);
  ForEachLink(mesh, diagram, [&](CellIndex point, CellIndex neighbour, double distance, double edge) {
    const CellIndex link = next[point]++;
    mesh.Neighbour[link] = neighbour;
    mesh.Distance[link] = distance;
    mesh.EdgeRatio[link] = std::min(edge * unit / distance, LargestRatio);
    // two triangles with the edge as base and half the distance as height: e d / 4 on this side
    mesh.Area[point] += 0.25 * mesh.EdgeRatio[link] * distance * distance;
  });
  for (double& area : mesh.Area)
  {
    area = std::max(area, LeastArea * cell);
  }
}

/// Triangles about each vertex of Voronoi's cells, a fan where more than three cells meet.
void AddTriangles(PointMesh& mesh, const Diagram& diagram)
{
  for (const Diagram::vertex_type& vertex : diagram.vertices())
  {
    const Diagram::edge_type* first = vertex.incident_edge();
    const auto pointOf = [](const Diagram::edge_type* edge) {
      return static_cast<CellIndex>(edge->cell()->source_index());
    };
    for (const Diagram::edge_type* edge = first->rot_next(); edge->rot_next() != first; edge = edge->rot_next())
    {
      mesh.Corners.push_back({ pointOf(first), pointOf(edge), pointOf(edge->rot_next()) });
    }
  }
}

/// Nodes of half a cell's spacing, over the same rectangle.
GridSamples HalfCells(const PointMesh& mesh, const std::vector<double>& heights)
{
  GridSamples fine;
  fine.Width = 2 * mesh.Width - 1;
  fine.Height = 2 * mesh.Height - 1;
  fine.Spacing = { 0.5 * mesh.Spacing[0], 0.5 * mesh.Spacing[1] };
  for (int j = 0; j < fine.Height; ++j)
  {
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

PointMesh JitteredMesh(
  int width, int height, const std::array<double, 2>& spacing, int seed, int draw, const std::vector<HeldPoint>& held)
{
  PointMesh mesh;
  mesh.Width = width;
  mesh.Height = height;
  mesh.Spacing = spacing;
  const double unit = std::min(spacing[0], spacing[1]) / UnitsACell;
  const std::vector<IntegerPoint> points = JitteredPoints(mesh, unit, seed, draw, held);
  for (const IntegerPoint& point : points)
  {
    mesh.Points.push_back({ point.x() * unit, point.y() * unit });
  }
  Diagram diagram;
  boost::polygon::construct_voronoi(points.begin(), points.end(), &diagram);
  AddLinks(mesh, diagram, unit);
  AddTriangles(mesh, diagram);
  return mesh;
}

GridSamples GridOf(const PointMesh& mesh, const std::vector<double>& heights)
{
  GridSamples fine = HalfCells(mesh, heights);
  for (const std::array<CellIndex, 3>& corners : mesh.Corners)
  {
    const auto& [a, b, c] = corners;
    FillTriangle({ mesh.Points[a], mesh.Points[b], mesh.Points[c] }, { heights[a], heights[b], heights[c] }, fine);
  }
  SmoothGrid(fine.Values, fine.Width, fine.Height, 1.0);
  GridSamples grid;
  grid.Width = mesh.Width;
  grid.Height = mesh.Height;
  grid.Spacing = mesh.Spacing;
  for (CellIndex n = 0; n < mesh.Count(); ++n)
  {
    grid.Values.push_back(fine.At(2 * (n % mesh.Width), 2 * (n / mesh.Width)));
  }
  return grid;
}

}
