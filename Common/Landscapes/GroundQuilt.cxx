// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Landscapes/GroundQuilt.h"

#include "Drainage/RingSpectrum.h"
#include "Drainage/ValleySpreading.h"
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
#include <vector>

namespace littoral
{

namespace
{

constexpr double SideFactor = 3.0;
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

/// Draw of the shifts of rows and columns, by their numbers.
constexpr std::uint64_t ShiftDraw = 2;

/// Heights, and differences to the next cell along x and y, each over a scale.
constexpr int Channels = 3;
struct Relief
{
  int Width = 0;
  int Height = 0;
  std::array<std::vector<float>, Channels> Values;

  std::size_t Index(int x, int y) const { return static_cast<std::size_t>(y) * this->Width + x; }
};

/// A value that pieces are to have in a cell of a square, and where the first piece of the place has its own.
struct Sample
{
  const float* First;
  float Value;
};

/// Adds squared differences to samples to the sums of pieces side by side, of the cells from `shift` on. Four samples
/// are taken at once, as each turn reads and writes the sums.
LITTORAL_SIMD_CLONES void AddSquares(
  const std::vector<Sample>& samples, std::size_t shift, std::size_t count, float* sums)
{
  constexpr std::size_t atOnce = 4;
  const std::size_t whole = samples.size() / atOnce * atOnce;
  for (std::size_t first = 0; first < whole; first += atOnce)
  {
    const Sample* of = samples.data() + first;
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
  for (std::size_t last = whole; last < samples.size(); ++last)
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
  Quilter(const GridSamples& place, const GridSamples& guide, int side, int seed, const ParallelFor& parallel)
    : Guide(guide)
    , Side(side)
    , Overlap(3 * side / 8)
    , Margin(Overlap / 2)
    , Columns(PiecesAlong(guide.Width + Margin))
    , Rows(PiecesAlong(guide.Height + Margin))
    , Random(seed, RandomPurpose::LandscapePieces)
    , Parallel(parallel)
  {
    this->SetPlace(place);
    this->Ground.Width = this->Columns * this->Step() + this->Overlap + this->Margin;
    this->Ground.Height = this->Rows * this->Step() + this->Overlap + this->Margin;
    const std::size_t cells = static_cast<std::size_t>(this->Ground.Width) * this->Ground.Height;
    this->Ground.Values.fill(std::vector<float>(cells, 0.0F));
    this->IsLaid.assign(cells, 0);
    this->Uses.assign(static_cast<std::size_t>(this->CountX) * this->CountY, 0.0F);
    this->Costs = this->Uses;
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
    return this->Heights();
  }

private:
  int Step() const { return this->Side - this->Overlap; }

  int PiecesAlong(int count) const { return std::max(1, (count - this->Overlap + this->Step() - 1) / this->Step()); }

  void SetPlace(const GridSamples& place)
  {
    const SampleMoments moments = Moments(place);
    this->Mean = moments.Mean;
    this->Scales[0] = std::sqrt(moments.Variance);
    std::array<std::vector<double>, 2> differences;
    double squares = 0.0;
    for (int j = 0; j < place.Height; ++j)
    {
      for (int i = 0; i < place.Width; ++i)
      {
        const double height = place.At(i, j);
        differences[0].push_back(place.At(std::min(i + 1, place.Width - 1), j) - height);
        differences[1].push_back(place.At(i, std::min(j + 1, place.Height - 1)) - height);
        squares += differences[0].back() * differences[0].back() + differences[1].back() * differences[1].back();
      }
    }
    this->Scales[1] = this->Scales[2] = std::sqrt(squares / static_cast<double>(place.Values.size())) / SlopeWeight;
    this->Place.Width = place.Width;
    this->Place.Height = place.Height;
    GridSamples smooth = place;
    SmoothGrid(smooth.Values, place.Width, place.Height, GuideSmoothing(this->Side), this->Parallel);
    for (std::size_t n = 0; n < place.Values.size(); ++n)
    {
      this->Place.Values[0].push_back(this->Scaled(place.Values[n]));
      this->Place.Values[1].push_back(static_cast<float>(differences[0][n] / this->Scales[1]));
      this->Place.Values[2].push_back(static_cast<float>(differences[1][n] / this->Scales[2]));
      this->SmoothPlace.push_back(this->Scaled(smooth.Values[n]));
    }
    this->CountX = place.Width - this->Side + 1;
    this->CountY = place.Height - this->Side + 1;
  }

  float Scaled(double height) const { return static_cast<float>((height - this->Mean) / this->Scales[0]); }

  void LayOne(int row, int column)
  {
    const Corner to = this->CornerOf(row, column);
    const int number = row * this->Columns + column;
    this->TakeCosts(to, number);
    this->ForbidNeighbours(to, row, column);
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
      const double part = this->Random.UniformPair(static_cast<std::uint64_t>(line), ShiftDraw)[axis];
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
        const std::size_t cell = this->Ground.Index(to.X + x, to.Y + y);
        for (int channel = 0; channel < Channels && this->IsLaid[cell]; ++channel)
        {
          samples.push_back(
            { this->Place.Values[channel].data() + this->Place.Index(x, y), this->Ground.Values[channel][cell] });
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
            { this->SmoothPlace.data() + this->Place.Index(x, y), this->Scaled(this->Guide.At(column, row)) });
        }
      }
    }
    return samples;
  }

  /// Costs of the pieces by their corners in the place.
  void TakeCosts(const Corner& to, int number)
  {
    const std::vector<Sample> overlap = this->OverlapOf(to);
    const std::vector<Sample> guide = this->GuideOf(to);
    const auto most = static_cast<std::size_t>(this->CountY); // one row of a place that is wide and low
    const std::size_t step = std::min(most, (this->Costs.size() + MaximumPieces - 1) / MaximumPieces);
    const std::size_t first = this->Random.Words(static_cast<std::uint64_t>(number), 1)[0] % step;
    std::fill(this->Costs.begin(), this->Costs.end(), std::numeric_limits<float>::infinity());
    const std::size_t rows = (static_cast<std::size_t>(this->CountY) + step - 1 - first) / step;
    ForRanges(this->Parallel, rows, 4, [&](std::size_t begin, std::size_t end) {
      std::vector<float> sums(this->CountX);
      for (std::size_t n = begin; n < end; ++n)
      {
        const int y = static_cast<int>(first + n * step);
        float* costs = this->Costs.data() + static_cast<std::size_t>(y) * this->CountX;
        const float* uses = this->Uses.data() + static_cast<std::size_t>(y) * this->CountX;
        std::fill_n(costs, this->CountX, 0.0F);
        AddSquares(guide, this->Place.Index(0, y), sums.size(), costs);
        std::fill(sums.begin(), sums.end(), 0.0F);
        AddSquares(overlap, this->Place.Index(0, y), sums.size(), sums.data());
        const float ofGuide = GuideWeight / static_cast<float>(std::max<std::size_t>(1, guide.size()));
        const float ofOverlap =
          static_cast<float>(Channels) / static_cast<float>(std::max<std::size_t>(1, overlap.size()));
        for (int x = 0; x < this->CountX; ++x)
        {
          const float use = uses[x];
          costs[x] = (LeastCost + ofGuide * costs[x] + ofOverlap * sums[x]) * (1.0F + use + use * use);
        }
      }
    });
  }

  /// Leaves out pieces that go on where one beside the square ends, unless none is left.
  void ForbidNeighbours(const Corner& to, int row, int column)
  {
    const std::vector<float> all = this->Costs;
    constexpr std::array<Corner, 4> neighbours{ { { -1, 0 }, { 0, -1 }, { -1, -1 }, { 1, -1 } } };
    for (const Corner& next : neighbours)
    {
      if (row + next.Y < 0 || column + next.X < 0 || column + next.X >= this->Columns)
      {
        continue;
      }
      const Corner& shift = this->Shifts[static_cast<std::size_t>(row + next.Y) * this->Columns + column + next.X];
      this->EachNear({ to.X + shift.X, to.Y + shift.Y }, this->Side / 2,
        [&](std::size_t piece, int, int) { this->Costs[piece] = std::numeric_limits<float>::infinity(); });
    }
    if (std::none_of(this->Costs.begin(), this->Costs.end(), [](float cost) { return std::isfinite(cost); }))
    {
      this->Costs = all;
    }
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
    const double chance = this->Random.UniformPair(static_cast<std::uint64_t>(number), 0)[0];
    const std::size_t piece = good[static_cast<std::size_t>(chance * static_cast<double>(good.size()))];
    return { static_cast<int>(piece % this->CountX), static_cast<int>(piece / this->CountX) };
  }

  /// Squared difference of a piece to what is laid in the cell of a square; 0 where nothing is.
  float Difference(const Corner& from, const Corner& to, int x, int y) const
  {
    const std::size_t is = this->Ground.Index(to.X + x, to.Y + y);
    if (!this->IsLaid[is])
    {
      return 0.0F;
    }
    const std::size_t shall = this->Place.Index(from.X + x, from.Y + y);
    float sum = 0.0F;
    for (int channel = 0; channel < Channels; ++channel)
    {
      const float difference = this->Place.Values[channel][shall] - this->Ground.Values[channel][is];
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
        const std::size_t cell = this->Ground.Index(to.X + x, to.Y + y);
        if (!this->IsLaid[cell] || (x >= left[y] && y >= below[x]))
        {
          const std::size_t source = this->Place.Index(from.X + x, from.Y + y);
          for (int channel = 0; channel < Channels; ++channel)
          {
            this->Ground.Values[channel][cell] = this->Place.Values[channel][source];
          }
          this->IsLaid[cell] = 1;
        }
      }
    }
  }

  /// Adds the share of a piece that is not under others, over the part of it that each piece has in common with it.
  void CountUse(const Corner& from)
  {
    const float all = static_cast<float>(this->Side) * static_cast<float>(this->Side);
    const float share = static_cast<float>(this->Step() * this->Step()) / all;
    this->EachNear(from, this->Side, [&](std::size_t piece, int x, int y) {
      this->Uses[piece] += share * static_cast<float>((this->Side - x) * (this->Side - y)) / all;
    });
  }

  /// Heights z on the guide's grid with the least of sum (dz - d)^2 + l sum (z - h)^2: (L + l) z = l h - div d, of
  /// which cosines are the eigenvectors.
  GridSamples Heights() const
  {
    GridSamples heights = this->Guide;
    const int width = heights.Width;
    const int height = heights.Height;
    std::fill(heights.Values.begin(), heights.Values.end(), 0.0);
    for (int j = 0; j < height; ++j)
    {
      for (int i = 0; i < width; ++i)
      {
        const std::size_t cell = this->Ground.Index(i + this->Margin, j + this->Margin);
        const auto link = [&](int channel, bool isThere, int x, int y) {
          const double difference = isThere ? this->Scales[channel] * this->Ground.Values[channel][cell] : 0.0;
          heights.At(i, j) -= difference;
          heights.At(isThere ? x : i, isThere ? y : j) += difference;
        };
        link(1, i + 1 < width, i + 1, j);
        link(2, j + 1 < height, i, j + 1);
        heights.At(i, j) += HeightWeight * (this->Mean + this->Scales[0] * this->Ground.Values[0][cell]);
      }
    }
    CosineTransform(heights, this->Parallel);
    const auto eigenvalue = [](int n, int count) { return 2.0 - 2.0 * std::cos(Pi * n / count); };
    for (int j = 0; j < height; ++j)
    {
      for (int i = 0; i < width; ++i)
      {
        heights.At(i, j) /= HeightWeight + eigenvalue(i, width) + eigenvalue(j, height);
      }
    }
    InverseCosineTransform(heights, this->Parallel);
    return heights;
  }

  const GridSamples& Guide;
  int Side;
  int Overlap;
  int Margin; ///< of the ground about the guide, and the largest shift
  int Columns;
  int Rows;
  RandomStream Random;
  const ParallelFor& Parallel;
  Relief Place;
  std::vector<float> SmoothPlace;
  double Mean = 0.0;
  std::array<double, Channels> Scales{ 1.0, 1.0, 1.0 };
  int CountX = 0; ///< pieces of the place by the corner
  int CountY = 0;
  Relief Ground;
  std::vector<char> IsLaid;
  std::vector<float> Uses; ///< by piece
  std::vector<float> Costs;
  std::vector<Corner> Shifts; ///< corner in the place less that on the ground, of the squares so far
};

}

int PieceSideFor(const GridSamples& place)
{
  return 2 * static_cast<int>(0.5 * SideFactor * std::sqrt(std::min(place.Width, place.Height)));
}

double GuideSmoothing(int side)
{
  return 0.25 * side;
}

GridSamples QuiltGround(const GridSamples& place, const GridSamples& guide, int side, int seed,
  const ParallelFor& parallel, const CarvingProgress& progress)
{
  return Quilter(place, guide, side, seed, parallel).Quilt(progress);
}

}
