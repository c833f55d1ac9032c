// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Terrain/TerrainLevels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace littoral
{

namespace
{

/// The samples of a level along a side of a tile: every 2^level-th, and the last.
std::vector<int> Places(int first, int last, int level)
{
  std::vector<int> places;
  for (int place = first; place < last; place += 1 << level)
  {
    places.push_back(place);
  }
  places.push_back(last);
  return places;
}

/// The least single precision number that is not below.
float RoundedUp(double value)
{
  const float near = static_cast<float>(value);
  return near < value ? std::nextafter(near, std::numeric_limits<float>::infinity()) : near;
}

/// Height at shares u, v of a cell whose corners are a (0, 0), b (1, 0), c (1, 1), d (0, 1), cut from a to c.
double HeightIn(double a, double b, double c, double d, double u, double v)
{
  return u >= v ? a + u * (b - a) + v * (c - b) : a + v * (d - a) + u * (c - d);
}

/// Largest distance of the samples of a cell from its two triangles.
double ErrorOfCell(const HeightSamples& samples, int x0, int x1, int y0, int y1)
{
  const auto at = [&](int x, int y) { return static_cast<double>(samples.Values[samples.Index(x, y)]); };
  const double a = at(x0, y0);
  const double b = at(x1, y0);
  const double c = at(x1, y1);
  const double d = at(x0, y1);
  double largest = 0.0;
  for (int y = y0; y <= y1; ++y)
  {
    const double v = static_cast<double>(y - y0) / (y1 - y0);
    for (int x = x0; x <= x1; ++x)
    {
      const double u = static_cast<double>(x - x0) / (x1 - x0);
      largest = std::max(largest, std::abs(at(x, y) - HeightIn(a, b, c, d, u, v)));
    }
  }
  return largest;
}

/// Samples in a row, with their places along it.
struct Chain
{
  std::vector<std::size_t> Samples;
  std::vector<int> Places;
  std::vector<double> Heights;

  std::size_t Size() const { return this->Samples.size(); }

  bool InLine(std::size_t a, std::size_t b, std::size_t c) const
  {
    return (this->Heights[b] - this->Heights[a]) * (this->Places[c] - this->Places[a]) ==
      (this->Heights[c] - this->Heights[a]) * (this->Places[b] - this->Places[a]);
  }

  bool IsStraight(std::size_t first, std::size_t last) const
  {
    for (std::size_t i = first + 1; i < last; ++i)
    {
      if (!this->InLine(first, i, last))
      {
        return false;
      }
    }
    return true;
  }
};

/// The third vertex of the triangle on the chord from first to last. The vertices between are not all in line with it.
std::size_t Apex(const Chain& chain, std::size_t first, std::size_t last)
{
  const auto isGood = [&](std::size_t k) {
    const bool leftIsFlat = k > first + 1 && chain.IsStraight(first, k);
    const bool rightIsFlat = last > k + 1 && chain.IsStraight(k, last);
    return !chain.InLine(first, k, last) && !leftIsFlat && !rightIsFlat;
  };
  std::size_t k = first + 1;
  // One always is: the vertex after the first, the one before the last, or, if both are in line, any that is not.
  while (!isGood(k))
  {
    ++k;
  }
  return k;
}

/// Fills the polygon of a chain and its chord with triangles, none of which has three vertices in line.
void FillChain(const Chain& chain, std::size_t first, std::size_t last, int start, std::vector<int>& triangles)
{
  if (last < first + 2)
  {
    return;
  }
  const std::size_t apex = Apex(chain, first, last);
  FillChain(chain, first, apex, start, triangles);
  for (const std::size_t vertex : { first, apex, last })
  {
    triangles.push_back(start + static_cast<int>(vertex));
  }
  FillChain(chain, apex, last, start, triangles);
}

/// Builds the mesh of one tile.
class PatchBuilder
{
public:
  PatchBuilder(const TerrainPyramid& pyramid, const std::vector<int>& levels, std::size_t tile)
    : Samples(pyramid.GetSamples())
    , Tile(pyramid.GetTiles()[tile])
    , Level(levels[tile])
    , Xs(Places(this->Tile.First[0], this->Tile.Last[0], this->Level))
    , Ys(Places(this->Tile.First[1], this->Tile.Last[1], this->Level))
  {
    this->Patch.Levels = PatchLevelsOf(pyramid, levels, tile);
  }

  TerrainPatch Build()
  {
    const int columns = static_cast<int>(this->Xs.size());
    this->Patch.Surface.Samples.reserve(this->Xs.size() * this->Ys.size());
    for (const int y : this->Ys)
    {
      for (const int x : this->Xs)
      {
        this->Patch.Surface.Samples.push_back(this->Samples.Index(x, y));
      }
    }
    const int lastX = columns - 2;
    const int lastY = static_cast<int>(this->Ys.size()) - 2;
    this->Patch.Surface.Triangles.reserve(6 * (this->Xs.size() - 1) * (this->Ys.size() - 1));
    for (int j = 0; j <= lastY; ++j)
    {
      for (int i = 0; i <= lastX; ++i)
      {
        const int a = j * columns + i;
        const int b = a + 1;
        const int c = b + columns;
        const int d = a + columns;
        // Counter-clockwise along the rim, so that no two triangles run along an edge the same way.
        this->AddTriangle(a, this->Edge(j == 0, Bottom, i), b, this->Edge(i == lastX, Right, j), c);
        this->AddTriangle(c, this->Edge(j == lastY, Top, i), d, this->Edge(i == 0, Left, j), a);
      }
    }
    if (this->Tile.HasHoles)
    {
      this->RemoveMissing();
    }
    return std::move(this->Patch);
  }

private:
  enum Side
  {
    Bottom,
    Right,
    Top,
    Left
  };

  /// Vertices that a triangle takes in along an edge of a cell: none inside the tile or over a seam, which is added
  /// here.
  std::vector<int> Edge(bool isOnRim, Side side, int cell)
  {
    if (!isOnRim || this->Patch.Levels[1 + side] >= this->Level)
    {
      return {};
    }
    const Chain chain = this->ChainAlong(side, cell);
    if (chain.Size() == 2)
    {
      return {};
    }
    if (!chain.IsStraight(0, chain.Size() - 1))
    {
      TerrainMesh& seams = this->Patch.Seams;
      const int start = static_cast<int>(seams.Samples.size());
      seams.Samples.insert(seams.Samples.end(), chain.Samples.begin(), chain.Samples.end());
      FillChain(chain, 0, chain.Size() - 1, start, seams.Triangles);
      return {};
    }
    std::vector<int> vertices;
    for (std::size_t i = 1; i + 1 < chain.Size(); ++i)
    {
      vertices.push_back(static_cast<int>(this->Patch.Surface.Samples.size()));
      this->Patch.Surface.Samples.push_back(chain.Samples[i]);
    }
    return vertices;
  }

  /// The finer samples along an edge of a cell, from its first corner to its second, counter-clockwise.
  Chain ChainAlong(Side side, int cell) const
  {
    const bool alongX = side == Bottom || side == Top;
    const std::vector<int>& places = alongX ? this->Xs : this->Ys;
    Chain chain;
    chain.Places = Places(places[cell], places[cell + 1], this->Patch.Levels[1 + side]);
    if (side == Top || side == Left)
    {
      std::reverse(chain.Places.begin(), chain.Places.end());
    }
    for (const int place : chain.Places)
    {
      const int across = side == Bottom || side == Left ? this->Tile.First[alongX] : this->Tile.Last[alongX];
      chain.Samples.push_back(alongX ? this->Samples.Index(place, across) : this->Samples.Index(across, place));
      chain.Heights.push_back(this->Samples.Values[chain.Samples.back()]);
    }
    return chain;
  }

  /// A triangle a b c with vertices on its edges a b and b c, cut into a fan about c and one about the last before b.
  void AddTriangle(int a, const std::vector<int>& onAB, int b, const std::vector<int>& onBC, int c)
  {
    std::vector<int>& triangles = this->Patch.Surface.Triangles;
    const auto add = [&triangles](int first, int second, int third) {
      triangles.push_back(first);
      triangles.push_back(second);
      triangles.push_back(third);
    };
    int last = a;
    for (const int vertex : onAB)
    {
      add(last, vertex, c);
      last = vertex;
    }
    int before = b;
    for (const int vertex : onBC)
    {
      add(last, before, vertex);
      before = vertex;
    }
    add(last, before, c);
  }

  /// Leaves out triangles with a missing vertex, and the vertices that no triangle has then.
  void RemoveMissing()
  {
    TerrainMesh& mesh = this->Patch.Surface;
    TerrainMesh kept;
    std::vector<int> places(mesh.Samples.size(), -1);
    for (std::size_t first = 0; first < mesh.Triangles.size(); first += 3)
    {
      const int* corners = &mesh.Triangles[first];
      const auto isMissing = [&](int corner) { return this->Samples.IsMissing(mesh.Samples[corner]); };
      if (std::any_of(corners, corners + 3, isMissing))
      {
        continue;
      }
      for (int k = 0; k < 3; ++k)
      {
        int& place = places[corners[k]];
        if (place < 0)
        {
          place = static_cast<int>(kept.Samples.size());
          kept.Samples.push_back(mesh.Samples[corners[k]]);
        }
        kept.Triangles.push_back(place);
      }
    }
    mesh = std::move(kept);
  }

  const HeightSamples& Samples;
  const TerrainTile& Tile;
  int Level;
  std::vector<int> Xs;
  std::vector<int> Ys;
  TerrainPatch Patch;
};

}

Vector3 HeightSamples::Position(std::size_t index) const
{
  const std::size_t column = index % this->Width;
  const std::size_t row = index / this->Width;
  return { this->Origin[0] + static_cast<double>(column) * this->Spacing[0],
    this->Origin[1] + static_cast<double>(row) * this->Spacing[1], this->Values[index] };
}

int LevelsOfTiles(int tileSize, int levels)
{
  int number = 1;
  while (number < levels && (1 << number) <= tileSize)
  {
    ++number;
  }
  return number;
}

TerrainPyramid::TerrainPyramid(HeightSamples samples, int tileSize, int levels, const ParallelFor& parallelFor)
  : Samples(std::move(samples))
  , Levels(LevelsOfTiles(tileSize, levels))
{
  const std::array<int, 2> cells{ this->Samples.Width - 1, this->Samples.Height - 1 };
  for (int axis = 0; axis < 2; ++axis)
  {
    this->TilesAlong[axis] = (cells[axis] + tileSize - 1) / tileSize;
  }
  for (int y = 0; y < this->TilesAlong[1]; ++y)
  {
    for (int x = 0; x < this->TilesAlong[0]; ++x)
    {
      TerrainTile tile;
      tile.First = { x * tileSize, y * tileSize };
      tile.Last = { std::min(cells[0], tile.First[0] + tileSize), std::min(cells[1], tile.First[1] + tileSize) };
      this->Tiles.push_back(tile);
    }
  }
  parallelFor(this->Tiles.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t tile = begin; tile < end; ++tile)
    {
      this->MeasureTile(this->Tiles[tile]);
    }
  });
  this->Normals.resize(this->Samples.Values.size());
  parallelFor(static_cast<std::size_t>(this->Samples.Height), [&](std::size_t begin, std::size_t end) {
    for (std::size_t y = begin; y < end; ++y)
    {
      for (int x = 0; x < this->Samples.Width; ++x)
      {
        this->Normals[this->Samples.Index(x, static_cast<int>(y))] = this->NormalAt(x, static_cast<int>(y));
      }
    }
  });
}

void TerrainPyramid::MeasureTile(TerrainTile& tile) const
{
  const Vector3 first = this->Samples.Position(this->Samples.Index(tile.First[0], tile.First[1]));
  const Vector3 last = this->Samples.Position(this->Samples.Index(tile.Last[0], tile.Last[1]));
  for (int axis = 0; axis < 2; ++axis)
  {
    tile.Bounds.Low[axis] = std::min(first[axis], last[axis]);
    tile.Bounds.High[axis] = std::max(first[axis], last[axis]);
  }
  float low = std::numeric_limits<float>::infinity();
  float high = -low;
  for (int y = tile.First[1]; y <= tile.Last[1]; ++y)
  {
    for (int x = tile.First[0]; x <= tile.Last[0]; ++x)
    {
      const float value = this->Samples.Values[this->Samples.Index(x, y)];
      const bool isMissing = std::isnan(value);
      tile.HasHoles = tile.HasHoles || isMissing;
      low = isMissing ? low : std::min(low, value);
      high = isMissing ? high : std::max(high, value);
    }
  }
  tile.IsEmpty = low > high;
  tile.Bounds.Low.z = tile.IsEmpty ? 0.0 : low;
  tile.Bounds.High.z = tile.IsEmpty ? 0.0 : high;
  for (int level = 1; level < this->Levels && !tile.HasHoles; ++level)
  {
    const std::vector<int> xs = Places(tile.First[0], tile.Last[0], level);
    const std::vector<int> ys = Places(tile.First[1], tile.Last[1], level);
    double largest = 0.0;
    for (std::size_t j = 1; j < ys.size(); ++j)
    {
      for (std::size_t i = 1; i < xs.size(); ++i)
      {
        largest = std::max(largest, ErrorOfCell(this->Samples, xs[i - 1], xs[i], ys[j - 1], ys[j]));
      }
    }
    tile.Errors[level] = RoundedUp(largest);
  }
}

std::array<float, 3> TerrainPyramid::NormalAt(int x, int y) const
{
  const auto isThere = [&](int i, int j) {
    return i >= 0 && j >= 0 && i < this->Samples.Width && j < this->Samples.Height &&
      !this->Samples.IsMissing(this->Samples.Index(i, j));
  };
  if (!isThere(x, y))
  {
    return { 0.0f, 0.0f, 1.0f };
  }
  const int x0 = isThere(x - 1, y) ? x - 1 : x;
  const int x1 = isThere(x + 1, y) ? x + 1 : x;
  const int y0 = isThere(x, y - 1) ? y - 1 : y;
  const int y1 = isThere(x, y + 1) ? y + 1 : y;
  const auto at = [&](int i, int j) { return static_cast<double>(this->Samples.Values[this->Samples.Index(i, j)]); };
  const double slopeX = (at(x1, y) - at(x0, y)) / (std::max(1, x1 - x0) * this->Samples.Spacing[0]);
  const double slopeY = (at(x, y1) - at(x, y0)) / (std::max(1, y1 - y0) * this->Samples.Spacing[1]);
  const Vector3 normal = glm::normalize(Vector3(-slopeX, -slopeY, 1.0));
  return { static_cast<float>(normal.x), static_cast<float>(normal.y), static_cast<float>(normal.z) };
}

int LevelAtDistance(double distance, const TerrainRule& rule, int levels)
{
  if (distance <= rule.NearDistance || levels == 1)
  {
    return 0;
  }
  if (distance >= rule.FarDistance)
  {
    return levels - 1;
  }
  const double share = rule.NearDistance > 0.0
    ? std::log(distance / rule.NearDistance) / std::log(rule.FarDistance / rule.NearDistance)
    : distance / rule.FarDistance;
  return std::min(levels - 1, 1 + static_cast<int>(share * (levels - 2)));
}

namespace
{

/// Distance that sets the level of a tile [m]: from the eye, wherever within its margin it is.
double DistanceTo(const TerrainTile& tile, const ViewFrustum& view)
{
  const View& seen = view.GetView();
  return seen.IsParallel ? LevelDistance(seen, tile.Bounds.Low)
                         : std::max(0.0, Distance(tile.Bounds, seen.Point) - seen.Margin) / seen.DetailFactor;
}

}

double ScreenErrorOf(const TerrainTile& tile, int level, const ViewFrustum& view)
{
  return view.PixelsOfRise(tile.Errors[level], tile.Bounds);
}

std::vector<int> SelectLevels(const TerrainPyramid& pyramid, const ViewFrustum& view, const TerrainRule& rule)
{
  std::vector<int> levels;
  levels.reserve(pyramid.GetTiles().size());
  for (const TerrainTile& tile : pyramid.GetTiles())
  {
    int level = Culled;
    if (!tile.IsEmpty && tile.HasHoles && (!rule.UseCulling || view.MayShow(tile.Bounds)))
    {
      level = 0;
    }
    else if (!tile.IsEmpty && (!rule.UseCulling || view.MayShow(tile.Bounds)))
    {
      level = rule.ByPixelError ? pyramid.GetLevels() - 1
                                : LevelAtDistance(DistanceTo(tile, view), rule, pyramid.GetLevels());
      while (rule.ByPixelError && level > 0 && ScreenErrorOf(tile, level, view) > rule.MaximumPixels)
      {
        --level;
      }
    }
    levels.push_back(level);
  }
  return levels;
}

PatchLevels PatchLevelsOf(const TerrainPyramid& pyramid, const std::vector<int>& levels, std::size_t tile)
{
  const int along = pyramid.GetTilesAlong(0);
  const int x = static_cast<int>(tile) % along;
  const int y = static_cast<int>(tile) / along;
  const int own = levels[tile];
  const auto levelAt = [&](int i, int j) {
    const bool isTile = i >= 0 && j >= 0 && i < along && j < pyramid.GetTilesAlong(1);
    const int level = isTile ? levels[static_cast<std::size_t>(j) * along + i] : Culled;
    return level == Culled ? own : std::min(level, own); // no gap to a coarser one from here
  };
  return { own, levelAt(x, y - 1), levelAt(x + 1, y), levelAt(x, y + 1), levelAt(x - 1, y) };
}

TerrainPatch MakePatch(const TerrainPyramid& pyramid, const std::vector<int>& levels, std::size_t tile)
{
  return PatchBuilder(pyramid, levels, tile).Build();
}

}
