// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Landscapes/GroundQuilt.h"

#include "Drainage/RingSpectrum.h"
#include "Drainage/ValleySpreading.h"
#include "Landscapes/StandingWater.h"
#include "Numerics/Constants.h"
#include "Numerics/RandomStream.h"
#include "Numerics/SimdClones.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <vector>

namespace littoral
{

namespace
{

constexpr double SideFactor = 3.0;

/// Deviation of the guide's smoothing over the side of a piece, and the largest one over the place's shorter side:
/// longer waves alone do not correct the semivariances of a small place.
constexpr double SmoothingFactor = 0.35;
constexpr double LargestSmoothing = 1.0 / 9.0;

constexpr double SlopeWeight = 0.5;
constexpr float GuideWeight = 3.0F;
constexpr float CostTolerance = 1.3F;
constexpr float LeastCost = 1e-4F; ///< added, so that a perfect piece is no reason to use it again and again
constexpr double HeightWeight = 1e-4;

/// Cells of an overlap and of the guide at which a cost is taken: each second one, of sides of more than 80 cells
/// fewer, and eight along a side.
constexpr int LeastStep = 2;
constexpr int OverlapSteps = 27;
constexpr int GuideSteps = 8;

/// Pieces of a place that are looked at for one square; of larger places each nth row, another first one each time.
constexpr std::size_t MaximumPieces = std::size_t{ 1 } << 18;

/// Pieces side by side that are given up together, and the samples of the overlap after which they may be.
constexpr std::size_t PiecesOfBlock = 32;
constexpr std::size_t SamplesOfPart = 64;

/// Draw of the shifts of rows and columns, by their numbers.
constexpr std::uint64_t ShiftDraw = 2;

/// Standard deviation of the Gauss function by which these heights are soft [cells]. The roughness of no piece is that
/// of another: it would hide how valleys and slopes fit.
constexpr double SoftDeviation = 1.0;

/// Values by which pieces are compared before that of standing water.
constexpr std::size_t WaterChannel = 3;

/// Source of a cell that is not laid.
constexpr std::int64_t NoSource = -1;

/// Differences to the next cell along x and y; 0 at the far edges.
std::array<double, 2> Rises(const GridSamples& ground, int i, int j)
{
  const double height = ground.At(i, j);
  return { ground.At(std::min(i + 1, ground.Width - 1), j) - height,
    ground.At(i, std::min(j + 1, ground.Height - 1)) - height };
}

/// A value that pieces are to have in a cell of a square, and where the first piece of the place has its own.
struct Sample
{
  const float* First;
  float Value;
};

constexpr std::size_t SamplesAtOnce = 4;

/// Adds squared differences to samples to the sums of pieces side by side, of the cells from `shift` on. Four samples
/// are taken at once, as each turn reads and writes the sums.
LITTORAL_SIMD_CLONES void AddSquares(
  const Sample* samples, std::size_t sampleCount, std::size_t shift, std::size_t count, float* sums)
{
  const std::size_t whole = sampleCount / SamplesAtOnce * SamplesAtOnce;
  for (std::size_t first = 0; first < whole; first += SamplesAtOnce)
  {
    const Sample* of = samples + first;
    const float a = of[0].Value;
    const float b = of[1].Value;
    const float c = of[2].Value;
    const float d = of[3].Value;
    LITTORAL_INDEPENDENT
    for (std::size_t n = shift; n < shift + count; ++n)
    {
      const float p = of[0].First[n] - a;
      const float q = of[1].First[n] - b;
      const float r = of[2].First[n] - c;
      const float s = of[3].First[n] - d;
      sums[n - shift] += (p * p + q * q) + (r * r + s * s);
    }
  }
  for (std::size_t last = whole; last < sampleCount; ++last)
  {
    const Sample of = samples[last];
    LITTORAL_INDEPENDENT
    for (std::size_t n = 0; n < count; ++n)
    {
      const float difference = of.First[shift + n] - of.Value;
      sums[n] += difference * difference;
    }
  }
}

struct Corner
{
  int X;
  int Y;
};

/// Costs of the pieces for one square: of their differences to the guide and to what is laid.
struct SquareCosts
{
  std::vector<Sample> Guide;
  std::vector<Sample> Overlap;
  std::vector<std::uint8_t> IsAllowed; ///< by the piece
  float OfGuide = 0.0F;
  float OfOverlap = 0.0F;

  float Of(float guide, float overlap, float use) const
  {
    return (LeastCost + this->OfGuide * guide + this->OfOverlap * overlap) * (1.0F + use + use * use);
  }
};

/// Column of the least path from the first row to the last through values, each step at most one aside.
std::vector<int> LeastPath(std::vector<float> values, int width, int height)
{
  const auto at = [&](int i, int j) -> float& { return values[static_cast<std::size_t>(j) * width + i]; };
  const auto least = [&](int i, int j) { // of the columns beside i
    int best = std::max(0, i - 1);
    for (int n = best + 1; n <= std::min(width - 1, i + 1); ++n)
    {
      best = at(n, j) < at(best, j) ? n : best;
    }
    return best;
  };
  for (int j = 1; j < height; ++j)
  {
    for (int i = 0; i < width; ++i)
    {
      at(i, j) += at(least(i, j - 1), j - 1);
    }
  }
  std::vector<int> path(height);
  const auto last = values.begin() + static_cast<std::ptrdiff_t>(height - 1) * width;
  path[height - 1] = static_cast<int>(std::min_element(last, last + width) - last);
  for (int j = height - 2; j >= 0; --j)
  {
    path[j] = least(path[j + 1], j);
  }
  return path;
}

/// The steps of QuiltGround().
class Quilter
{
public:
  Quilter(const GridSamples& place, const GridSamples& guide, int side, int seed, int draw, const ParallelFor& parallel)
    : Place(place)
    , Guide(guide)
    , Side(side)
    , Overlap(3 * side / 10)
    , Margin(Overlap / 2)
    , Columns(PiecesAlong(guide.Width + Margin))
    , Rows(PiecesAlong(guide.Height + Margin))
    , Width(Columns * Step() + Overlap + Margin)
    , Random(seed, RandomPurpose::LandscapePieces)
    , FirstObject(static_cast<std::uint64_t>(draw) << 32U)
    , Parallel(parallel)
  {
    this->SetPlace();
    const int height = this->Rows * this->Step() + this->Overlap + this->Margin;
    this->Sources.assign(static_cast<std::size_t>(this->Width) * height, NoSource);
    this->Uses.assign(static_cast<std::size_t>(this->CountX) * this->CountY, 0.0F);
    this->Costs = this->Uses;
    this->OfGuide = this->Uses;
    this->OfOverlap = this->Uses;
  }

  GridSamples Quilt(const CarvingProgress& progress)
  {
    for (int row = 0; row < this->Rows; ++row)
    {
      for (int column = 0; column < this->Columns; ++column)
      {
        progress(static_cast<double>(this->Shifts.size()) / (this->Rows * this->Columns));
        this->LayOne(row, column);
      }
    }
    return this->Heights([&] { progress(1.0); });
  }

private:
  int Step() const { return this->Side - this->Overlap; }

  int PiecesAlong(int count) const { return std::max(1, (count - this->Overlap + this->Step() - 1) / this->Step()); }

  void SetPlace()
  {
    const SampleMoments moments = Moments(this->Place);
    this->Mean = moments.Mean;
    this->Deviation = std::sqrt(moments.Variance);
    const GridSamples soft = this->Smooth(SoftDeviation);
    std::array<std::vector<double>, 2> rises;
    double squares = 0.0;
    for (int j = 0; j < soft.Height; ++j)
    {
      for (int i = 0; i < soft.Width; ++i)
      {
        const std::array<double, 2> rise = Rises(soft, i, j);
        rises[0].push_back(rise[0]);
        rises[1].push_back(rise[1]);
        squares += rise[0] * rise[0] + rise[1] * rise[1];
      }
    }
    const double scale = std::sqrt(squares / static_cast<double>(soft.Values.size())) / SlopeWeight;
    const GridSamples smooth = this->Smooth(GuideSmoothing(this->Place));
    for (std::size_t n = 0; n < smooth.Values.size(); ++n)
    {
      this->Values[0].push_back(this->Scaled(this->Place.Values[n]));
      this->Values[1].push_back(static_cast<float>(rises[0][n] / scale));
      this->Values[2].push_back(static_cast<float>(rises[1][n] / scale));
      this->SmoothPlace.push_back(this->Scaled(smooth.Values[n]));
    }
    const std::vector<std::uint8_t> water =
      StandingWater(this->Place, static_cast<std::size_t>(this->Side * this->Side / 2));
    if (std::find(water.begin(), water.end(), std::uint8_t{ 1 }) != water.end())
    {
      this->Values.emplace_back(water.begin(), water.end());
    }
    this->CountX = this->Place.Width - this->Side + 1;
    this->CountY = this->Place.Height - this->Side + 1;
  }

  GridSamples Smooth(double deviation) const
  {
    GridSamples smooth = this->Place;
    SmoothGrid(smooth.Values, smooth.Width, smooth.Height, deviation, this->Parallel);
    return smooth;
  }

  std::size_t InPlace(int x, int y) const { return static_cast<std::size_t>(y) * this->Place.Width + x; }

  std::size_t OnGround(int x, int y) const { return static_cast<std::size_t>(y) * this->Width + x; }

  float Scaled(double height) const { return static_cast<float>((height - this->Mean) / this->Deviation); }

  void LayOne(int row, int column)
  {
    const Corner to = this->CornerOf(row, column);
    const int number = row * this->Columns + column;
    this->TakeCosts(to, row, column);
    const Corner from = this->Chosen(number);
    this->Shifts.push_back({ from.X - to.X, from.Y - to.Y });
    this->Lay(from, to, row, column);
    this->CountUse(from);
  }

  /// Corner of a square on the ground. Rows are shifted along and columns up by chance, so that no seam goes on
  /// straight from one square to the next.
  Corner CornerOf(int row, int column) const
  {
    const auto shift = [&](int line, std::size_t axis) {
      const double part = this->Random.UniformPair(this->FirstObject + line, ShiftDraw)[axis];
      return static_cast<int>(part * (this->Margin + 1));
    };
    return { column * this->Step() + shift(row, 0), row * this->Step() + shift(column, 1) };
  }

  /// Values of the cells of the square that are laid already.
  std::vector<Sample> OverlapOf(const Corner& to) const
  {
    std::vector<Sample> samples;
    const int step = std::max(LeastStep, this->Side / OverlapSteps);
    for (int y = 0; y < this->Side; y += step)
    {
      for (int x = 0; x < this->Side; x += step)
      {
        const std::int64_t source = this->Sources[this->OnGround(to.X + x, to.Y + y)];
        for (std::size_t channel = 0; channel < this->Values.size() && source != NoSource; ++channel)
        {
          const std::vector<float>& values = this->Values[channel];
          samples.push_back({ values.data() + this->InPlace(x, y), values[source] });
        }
      }
    }
    return samples;
  }

  /// Smooth heights that the square is to have.
  std::vector<Sample> GuideOf(const Corner& to) const
  {
    std::vector<Sample> samples;
    for (int j = 0; j < GuideSteps; ++j)
    {
      for (int i = 0; i < GuideSteps; ++i)
      {
        const int x = (2 * i + 1) * this->Side / (2 * GuideSteps);
        const int y = (2 * j + 1) * this->Side / (2 * GuideSteps);
        const int column = to.X + x - this->Margin;
        const int row = to.Y + y - this->Margin;
        if (column >= 0 && column < this->Guide.Width && row >= 0 && row < this->Guide.Height)
        {
          samples.push_back(
            { this->SmoothPlace.data() + this->InPlace(x, y), this->Scaled(this->Guide.At(column, row)) });
        }
      }
    }
    return samples;
  }

  /// Costs of the pieces by their corners in the place; infinite of those that cannot be near the least one. Sums of
  /// squares only grow, so that a piece is given up once a part of its sum is too much. The rows' most promising pieces
  /// come first.
  void TakeCosts(const Corner& to, int row, int column)
  {
    const auto most = static_cast<std::size_t>(this->CountY); // one row of a place that is wide and low
    const std::size_t step = std::min(most, (this->Costs.size() + MaximumPieces - 1) / MaximumPieces);
    const auto number = static_cast<std::uint64_t>(row * this->Columns + column);
    const std::size_t first = this->Random.Words(this->FirstObject + number, 1)[0] % step;
    const std::size_t rows = (most + step - 1 - first) / step;
    SquareCosts square{ this->GuideOf(to), this->OverlapOf(to), this->AllowedPieces(to, row, column, first, step) };
    square.OfGuide = GuideWeight / static_cast<float>(std::max<std::size_t>(1, square.Guide.size()));
    square.OfOverlap =
      static_cast<float>(this->Values.size()) / static_cast<float>(std::max<std::size_t>(1, square.Overlap.size()));
    std::fill(this->Costs.begin(), this->Costs.end(), std::numeric_limits<float>::infinity());
    std::vector<float> least(rows, std::numeric_limits<float>::infinity());
    const std::size_t blocks = (static_cast<std::size_t>(this->CountX) + PiecesOfBlock - 1) / PiecesOfBlock;
    std::vector<float> starts(rows * blocks);
    const auto forRows = [&](const auto& visit) {
      ForRanges(this->Parallel, rows, 4, [&](std::size_t begin, std::size_t end) {
        for (std::size_t n = begin; n < end; ++n)
        {
          visit(static_cast<int>(first + n * step), &starts[n * blocks], least[n]);
        }
      });
    };
    forRows([&](int y, float* start, float& leastOfRow) {
      this->BeginRow(square, y, start);
      float* best = std::min_element(start, start + blocks);
      leastOfRow = this->FinishBlock(square, y, best - start, std::numeric_limits<float>::infinity());
      *best = std::numeric_limits<float>::infinity();
    });
    const float limit = CostTolerance * *std::min_element(least.begin(), least.end());
    forRows([&](int y, float* start, float&) {
      for (std::size_t block = 0; block < blocks; ++block)
      {
        if (start[block] <= limit)
        {
          this->FinishBlock(square, y, block, limit);
        }
      }
    });
  }

  std::size_t BlockLength(std::size_t block) const
  {
    return std::min(PiecesOfBlock, static_cast<std::size_t>(this->CountX) - block * PiecesOfBlock);
  }

  /// Sums of a row over the guide and the first part of the overlap, and the least cost of each block by these.
  void BeginRow(const SquareCosts& square, int y, float* starts)
  {
    const auto count = static_cast<std::size_t>(this->CountX);
    const std::size_t first = static_cast<std::size_t>(y) * count;
    std::fill_n(&this->OfGuide[first], count, 0.0F);
    std::fill_n(&this->OfOverlap[first], count, 0.0F);
    const std::size_t shift = this->InPlace(0, y);
    AddSquares(square.Guide.data(), square.Guide.size(), shift, count, &this->OfGuide[first]);
    const std::size_t part = std::min(SamplesOfPart, square.Overlap.size());
    AddSquares(square.Overlap.data(), part, shift, count, &this->OfOverlap[first]);
    for (std::size_t block = 0; block * PiecesOfBlock < count; ++block)
    {
      starts[block] = this->LeastOfBlock(square, first + block * PiecesOfBlock, this->BlockLength(block));
    }
  }

  /// Sets the costs of a block of a row by its whole sums, unless they are all above a limit; the least one.
  float FinishBlock(const SquareCosts& square, int y, std::size_t block, float limit)
  {
    const std::size_t x = block * PiecesOfBlock;
    const std::size_t first = static_cast<std::size_t>(y) * this->CountX + x;
    const std::size_t count = this->BlockLength(block);
    const std::size_t all = square.Overlap.size();
    float least = 0.0F;
    for (std::size_t done = SamplesOfPart; done < all; done += SamplesOfPart)
    {
      AddSquares(square.Overlap.data() + done, std::min(SamplesOfPart, all - done),
        this->InPlace(static_cast<int>(x), y), count, &this->OfOverlap[first]);
      least = this->LeastOfBlock(square, first, count);
      if (least > limit)
      {
        return least;
      }
    }
    for (std::size_t piece = first; piece < first + count; ++piece)
    {
      if (square.IsAllowed[piece])
      {
        this->Costs[piece] = square.Of(this->OfGuide[piece], this->OfOverlap[piece], this->Uses[piece]);
      }
    }
    return this->LeastOfBlock(square, first, count);
  }

  /// Least cost of the pieces of a block that are allowed, by the sums so far.
  float LeastOfBlock(const SquareCosts& square, std::size_t first, std::size_t count) const
  {
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t piece = first; piece < first + count; ++piece)
    {
      const float cost = square.Of(this->OfGuide[piece], this->OfOverlap[piece], this->Uses[piece]);
      least = square.IsAllowed[piece] && cost < least ? cost : least;
    }
    return least;
  }

  /// Pieces of the rows that are looked at, but those that go on where one beside the square ends, unless none is left.
  std::vector<std::uint8_t> AllowedPieces(
    const Corner& to, int row, int column, std::size_t first, std::size_t step) const
  {
    std::vector<std::uint8_t> all(this->Costs.size(), 0);
    for (std::size_t y = first; y < static_cast<std::size_t>(this->CountY); y += step)
    {
      std::fill_n(all.begin() + static_cast<std::ptrdiff_t>(y * this->CountX), this->CountX, std::uint8_t{ 1 });
    }
    std::vector<std::uint8_t> allowed = all;
    constexpr std::array<Corner, 4> neighbours{ { { -1, 0 }, { 0, -1 }, { -1, -1 }, { 1, -1 } } };
    for (const Corner& next : neighbours)
    {
      if (row + next.Y < 0 || column + next.X < 0 || column + next.X >= this->Columns)
      {
        continue;
      }
      const Corner& shift = this->Shifts[static_cast<std::size_t>(row + next.Y) * this->Columns + column + next.X];
      this->EachNear(
        { to.X + shift.X, to.Y + shift.Y }, this->Side / 2, [&](std::size_t piece, int, int) { allowed[piece] = 0; });
    }
    const bool isAny = std::find(allowed.begin(), allowed.end(), std::uint8_t{ 1 }) != allowed.end();
    return isAny ? allowed : all;
  }

  /// Calls a function with the pieces that are less than a distance along x and y from a corner, and these distances.
  template <typename Function>
  void EachNear(const Corner& corner, int distance, const Function& function) const
  {
    for (int y = std::max(0, corner.Y - distance + 1); y < std::min(this->CountY, corner.Y + distance); ++y)
    {
      for (int x = std::max(0, corner.X - distance + 1); x < std::min(this->CountX, corner.X + distance); ++x)
      {
        function(static_cast<std::size_t>(y) * this->CountX + x, std::abs(x - corner.X), std::abs(y - corner.Y));
      }
    }
  }

  /// One of the pieces whose costs are near the least.
  Corner Chosen(int number) const
  {
    const float most = CostTolerance * *std::min_element(this->Costs.begin(), this->Costs.end());
    std::vector<std::size_t> good;
    for (std::size_t piece = 0; piece < this->Costs.size(); ++piece)
    {
      if (this->Costs[piece] <= most)
      {
        good.push_back(piece);
      }
    }
    const double chance = this->Random.UniformPair(this->FirstObject + number, 0)[0];
    const std::size_t piece = good[static_cast<std::size_t>(chance * static_cast<double>(good.size()))];
    return { static_cast<int>(piece % this->CountX), static_cast<int>(piece / this->CountX) };
  }

  /// Squared difference of a piece to what is laid in the cell of a square; 0 where nothing is.
  float Difference(const Corner& from, const Corner& to, int x, int y) const
  {
    const std::int64_t is = this->Sources[this->OnGround(to.X + x, to.Y + y)];
    if (is == NoSource)
    {
      return 0.0F;
    }
    const std::size_t shall = this->InPlace(from.X + x, from.Y + y);
    float sum = 0.0F;
    for (const std::vector<float>& values : this->Values)
    {
      const float difference = values[shall] - values[is];
      sum += difference * difference;
    }
    return sum;
  }

  /// Lays a piece beyond the cuts through its overlaps with the squares to the left and below.
  void Lay(const Corner& from, const Corner& to, int row, int column)
  {
    const auto cut = [&](bool isThere, const auto& difference) {
      std::vector<float> values;
      for (int along = 0; along < this->Side && isThere; ++along)
      {
        for (int across = 0; across < this->Overlap; ++across)
        {
          values.push_back(difference(across, along));
        }
      }
      return isThere ? LeastPath(values, this->Overlap, this->Side) : std::vector<int>(this->Side, 0);
    };
    const std::vector<int> left =
      cut(column > 0, [&](int across, int along) { return this->Difference(from, to, across, along); });
    const std::vector<int> below =
      cut(row > 0, [&](int across, int along) { return this->Difference(from, to, along, across); });
    for (int y = 0; y < this->Side; ++y)
    {
      for (int x = 0; x < this->Side; ++x)
      {
        std::int64_t& source = this->Sources[this->OnGround(to.X + x, to.Y + y)];
        if (source == NoSource || (x >= left[y] && y >= below[x]))
        {
          source = static_cast<std::int64_t>(this->InPlace(from.X + x, from.Y + y));
        }
      }
    }
  }

  /// Share of a piece that is land.
  float LandShare(const Corner& from) const
  {
    if (this->Values.size() == WaterChannel)
    {
      return 1.0F;
    }
    float water = 0.0F;
    for (int y = 0; y < this->Side; ++y)
    {
      const auto row =
        this->Values[WaterChannel].begin() + static_cast<std::ptrdiff_t>(this->InPlace(from.X, from.Y + y));
      water = std::accumulate(row, row + this->Side, water);
    }
    return 1.0F - water / static_cast<float>(this->Side * this->Side);
  }

  /// Adds the share of a piece that is not under others, over the part of it that each piece has in common with it.
  /// Water is alike everywhere, and not used up.
  void CountUse(const Corner& from)
  {
    const float all = static_cast<float>(this->Side) * static_cast<float>(this->Side);
    const float share = this->LandShare(from) * static_cast<float>(this->Step() * this->Step()) / all;
    this->EachNear(from, this->Side, [&](std::size_t piece, int x, int y) {
      this->Uses[piece] += share * static_cast<float>((this->Side - x) * (this->Side - y)) / all;
    });
  }

  /// Heights z on the guide's grid with the least of sum (dz - d)^2 + l sum (z - h)^2: (L + l) z = l h - div d, of
  /// which cosines are the eigenvectors.
  GridSamples Heights(const Poll& poll) const
  {
    GridSamples heights = this->Guide;
    const int width = heights.Width;
    const int height = heights.Height;
    std::fill(heights.Values.begin(), heights.Values.end(), 0.0);
    for (int j = 0; j < height; ++j)
    {
      poll();
      for (int i = 0; i < width; ++i)
      {
        const std::int64_t source = this->Sources[this->OnGround(i + this->Margin, j + this->Margin)];
        const std::array<double, 2> rises = Rises(
          this->Place, static_cast<int>(source % this->Place.Width), static_cast<int>(source / this->Place.Width));
        const auto link = [&](double rise, bool isThere, int x, int y) {
          const double difference = isThere ? rise : 0.0;
          heights.At(i, j) -= difference;
          heights.At(isThere ? x : i, isThere ? y : j) += difference;
        };
        link(rises[0], i + 1 < width, i + 1, j);
        link(rises[1], j + 1 < height, i, j + 1);
        heights.At(i, j) += HeightWeight * this->Place.Values[source];
      }
    }
    CosineTransform(heights, this->Parallel);
    const auto eigenvalue = [](int n, int count) { return 2.0 - 2.0 * std::cos(Pi * n / count); };
    for (int j = 0; j < height; ++j)
    {
      poll();
      for (int i = 0; i < width; ++i)
      {
        heights.At(i, j) /= HeightWeight + eigenvalue(i, width) + eigenvalue(j, height);
      }
    }
    InverseCosineTransform(heights, this->Parallel);
    return heights;
  }

  const GridSamples& Place;
  const GridSamples& Guide;
  int Side;
  int Overlap;
  int Margin; ///< of the ground about the guide, and the largest shift
  int Columns;
  int Rows;
  int Width; ///< of the ground with its margin
  RandomStream Random;
  std::uint64_t FirstObject; ///< of a draw
  const ParallelFor& Parallel;
  /// Values of the place by which pieces are compared: heights, and differences of soft ones to the next cell along x
  /// and y, each over a scale; and, in a place with standing water, 1 there and 0 on land.
  std::vector<std::vector<float>> Values{ WaterChannel };
  std::vector<float> SmoothPlace;
  double Mean = 0.0;
  double Deviation = 1.0;
  int CountX = 0; ///< pieces of the place by the corner
  int CountY = 0;
  std::vector<std::int64_t> Sources; ///< cell of the place that a cell of the ground has its differences of
  std::vector<float> Uses;           ///< by piece
  std::vector<float> OfGuide;        ///< sums of squares by the piece
  std::vector<float> OfOverlap;      ///< the same, as far as they are taken
  std::vector<float> Costs;
  std::vector<Corner> Shifts; ///< corner in the place less that on the ground, of the squares so far
};

}

int PieceSideFor(const GridSamples& place)
{
  return 2 * static_cast<int>(0.5 * SideFactor * std::sqrt(std::min(place.Width, place.Height)));
}

double GuideSmoothing(const GridSamples& place)
{
  return std::min(SmoothingFactor * PieceSideFor(place), LargestSmoothing * std::min(place.Width, place.Height));
}

GridSamples QuiltGround(const GridSamples& place, const GridSamples& guide, int side, int seed,
  const ParallelFor& parallel, const CarvingProgress& progress, int draw)
{
  return Quilter(place, guide, side, seed, draw, parallel).Quilt(progress);
}

}
