// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Landscapes/VoronoiTiles.h"

#include <boost/polygon/voronoi.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace littoral
{

namespace
{

using Diagram = boost::polygon::voronoi_diagram<double>;

/// Margin of a tile [diagonals of a cell].
constexpr double MarginDiagonals = 4.0;

/// Longest side of cells over the shorter one in tiles.
constexpr double LongestCell = 2.0;

/// Triangle whose circle a line from left to right leaves at a place [units].
struct SweptTriangle
{
  double Left;
  std::array<CellIndex, 3> Corners;
};

double LengthOf(const Diagram::edge_type& edge)
{
  return edge.is_finite()
    ? std::hypot(edge.vertex1()->x() - edge.vertex0()->x(), edge.vertex1()->y() - edge.vertex0()->y())
    : 0.0;
}

/// Limits of a tile's triangles along an axis [units]; all at the ends belong to the first and the last.
std::array<double, 2> LimitsOf(const VoronoiTile& tile, int axis, int count, double size)
{
  constexpr double infinite = std::numeric_limits<double>::infinity();
  return { tile.First[axis] == 0 ? -infinite : (tile.First[axis] - 0.5) * size,
    tile.End[axis] == count ? infinite : (tile.End[axis] - 0.5) * size };
}

bool IsWithin(double value, const std::array<double, 2>& limits)
{
  return value >= limits[0] && value < limits[1];
}

/// Diagram of the points of a tile and of its margin.
class TileDiagram
{
public:
  TileDiagram(const CellPoints& points, const VoronoiTile& tile)
    : All(points)
    , Tile(tile)
  {
    const std::array<int, 2> size{ points.Width, points.Height };
    const double diagonal = std::hypot(points.CellSize[0], points.CellSize[1]);
    for (int axis = 0; axis < 2; ++axis)
    {
      const int margin = static_cast<int>(std::ceil(MarginDiagonals * diagonal / points.CellSize[axis]));
      this->First[axis] = std::max(0, tile.First[axis] - margin);
      this->End[axis] = std::min(size[axis], tile.End[axis] + margin);
    }
    std::vector<boost::polygon::point_data<std::int32_t>> places;
    for (int row = this->First[1]; row < this->End[1]; ++row)
    {
      for (int column = this->First[0]; column < this->End[0]; ++column)
      {
        const std::array<std::int32_t, 2>& place = points.Places[row * points.Width + column];
        places.emplace_back(place[0], place[1]);
      }
    }
    boost::polygon::construct_voronoi(places.begin(), places.end(), &this->Cells);
  }

  void AddSides(VoronoiTile& tile) const
  {
    const int width = this->End[0] - this->First[0];
    std::vector<const Diagram::cell_type*> cells(this->Cells.num_cells());
    for (const Diagram::cell_type& cell : this->Cells.cells())
    {
      cells[cell.source_index()] = &cell;
    }
    for (int row = tile.First[1]; row < tile.End[1]; ++row)
    {
      for (int column = tile.First[0]; column < tile.End[0]; ++column)
      {
        const std::size_t before = tile.Sides.size();
        const Diagram::edge_type* first =
          cells[(row - this->First[1]) * width + column - this->First[0]]->incident_edge();
        const Diagram::edge_type* edge = first;
        do
        {
          tile.Sides.push_back({ this->PointOf(*edge->twin()->cell()), LengthOf(*edge) });
          edge = edge->next();
        }
        while (edge != first);
        tile.SideCounts.push_back(static_cast<int>(tile.Sides.size() - before));
      }
    }
  }

  /// Triangles about each vertex of Voronoi's cells, a fan where more than three cells meet.
  std::vector<SweptTriangle> Triangles() const
  {
    const std::array<double, 2> columns = LimitsOf(this->Tile, 0, this->All.Width, this->All.CellSize[0]);
    const std::array<double, 2> rows = LimitsOf(this->Tile, 1, this->All.Height, this->All.CellSize[1]);
    // larger circles at the margin's border have points beyond it
    const bool isWhole = this->Cells.num_cells() == this->All.Places.size();
    const double largest = isWhole ? std::numeric_limits<double>::infinity()
                                   : 0.5 * MarginDiagonals * std::hypot(this->All.CellSize[0], this->All.CellSize[1]);
    std::vector<SweptTriangle> triangles;
    for (const Diagram::vertex_type& vertex : this->Cells.vertices())
    {
      const Diagram::edge_type* first = vertex.incident_edge();
      const CellIndex corner = this->PointOf(*first->cell());
      const std::array<std::int32_t, 2>& place = this->All.Places[corner];
      const double radius = std::hypot(vertex.x() - place[0], vertex.y() - place[1]);
      const double left = vertex.x() + radius;
      if (radius > largest || !IsWithin(left, columns) || !IsWithin(vertex.y(), rows))
      {
        continue;
      }
      for (const Diagram::edge_type* edge = first->rot_next(); edge->rot_next() != first; edge = edge->rot_next())
      {
        triangles.push_back(
          { left, { corner, this->PointOf(*edge->cell()), this->PointOf(*edge->rot_next()->cell()) } });
      }
    }
    return triangles;
  }

private:
  CellIndex PointOf(const Diagram::cell_type& cell) const
  {
    const auto place = static_cast<int>(cell.source_index());
    const int width = this->End[0] - this->First[0];
    return (this->First[1] + place / width) * this->All.Width + this->First[0] + place % width;
  }

  const CellPoints& All;
  const VoronoiTile& Tile;
  std::array<int, 2> First;
  std::array<int, 2> End;
  Diagram Cells;
};

/// Ends of parts of a side whose length is about one.
std::vector<int> EndsOf(int count, int side)
{
  const int parts = std::max(1, count / side);
  std::vector<int> ends;
  for (int part = 0; part <= parts; ++part)
  {
    ends.push_back(static_cast<int>(static_cast<std::int64_t>(count) * part / parts));
  }
  return ends;
}

}

bool AreTiled(const std::array<double, 2>& cellSize)
{
  const auto [shorter, longer] = std::minmax(cellSize[0], cellSize[1]);
  return longer <= LongestCell * shorter;
}

VoronoiCells VoronoiCellsOf(const CellPoints& points, const ParallelFor& parallel, const Poll& poll, int side)
{
  const int most = AreTiled(points.CellSize) ? side : std::max(points.Width, points.Height);
  const std::vector<int> columns = EndsOf(points.Width, most);
  const std::vector<int> rows = EndsOf(points.Height, most);
  VoronoiCells cells;
  cells.Triangles.reserve(2 * points.Places.size());
  for (std::size_t column = 0; column + 1 < columns.size(); ++column)
  {
    std::vector<VoronoiTile> tiles(rows.size() - 1);
    std::vector<std::vector<SweptTriangle>> triangles(tiles.size());
    parallel(tiles.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t row = begin; row < end; ++row)
      {
        VoronoiTile& tile = tiles[row];
        tile.First = { columns[column], rows[row] };
        tile.End = { columns[column + 1], rows[row + 1] };
        const TileDiagram diagram(points, tile);
        diagram.AddSides(tile);
        triangles[row] = diagram.Triangles();
      }
    });
    std::vector<SweptTriangle> swept;
    for (std::vector<SweptTriangle>& some : triangles)
    {
      swept.insert(swept.end(), some.begin(), some.end());
      some = {};
    }
    poll();
    // a tile alone has them in the order of Boost's sweep, in which equal ones are told apart
    if (tiles.size() > 1)
    {
      std::stable_sort(
        swept.begin(), swept.end(), [](const SweptTriangle& a, const SweptTriangle& b) { return a.Left < b.Left; });
    }
    poll();
    for (const SweptTriangle& triangle : swept)
    {
      cells.Triangles.push_back(triangle.Corners);
    }
    std::move(tiles.begin(), tiles.end(), std::back_inserter(cells.Tiles));
  }
  return cells;
}

}
