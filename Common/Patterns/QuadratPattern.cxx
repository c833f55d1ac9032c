// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/QuadratPattern.h"

#include "Numerics/ParameterCheck.h"
#include "Numerics/RandomStream.h"
#include "Numerics/SimdClones.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace littoral
{

namespace
{

/// Random numbers that are drawn at once: what a kernel keeps of them stays in the innermost cache.
constexpr std::size_t DrawsAtOnce = 512;
/// Quadrats or points that are worth a task of a thread.
constexpr std::size_t QuadratsOfTask = 1 << 14;

/// The first draws of some objects.
struct FirstDraws
{
  std::array<std::uint64_t, DrawsAtOnce> Objects;
  std::array<std::uint64_t, DrawsAtOnce> Draws{};
  std::array<double, DrawsAtOnce> Uniform;
  std::array<double, DrawsAtOnce> Unused;

  void Draw(const RandomStream& random, std::size_t count)
  {
    random.UniformPairs(count, this->Objects.data(), this->Draws.data(), this->Uniform.data(), this->Unused.data());
  }
};

/// The inverse of a law's cumulated probabilities.
class CountSampler
{
public:
  explicit CountSampler(const QuadratLawParameters& law)
    : Cumulative(MassFunction(law))
  {
    std::partial_sum(this->Cumulative.begin(), this->Cumulative.end(), this->Cumulative.begin());
    this->MakeGuide();
  }

  /// The smallest r whose F(r) > u F(last), of u in (0, 1).
  int operator()(double u) const
  {
    const double wanted = u * this->Cumulative.back();
    int r = this->Guide[static_cast<std::size_t>(u * static_cast<double>(this->Guide.size()))];
    while (this->Cumulative[static_cast<std::size_t>(r)] <= wanted)
    {
      ++r;
    }
    return r;
  }

private:
  /// The same for the lower ends of equal cells of (0, 1), a power of 2 so that they are exact, and twice as many as
  /// there are probabilities, so that a step or two lead from there to any u.
  void MakeGuide()
  {
    std::size_t cells = 1024;
    while (cells < 2 * this->Cumulative.size())
    {
      cells *= 2;
    }
    this->Guide.resize(cells);
    std::size_t r = 0;
    for (std::size_t cell = 0; cell < cells; ++cell)
    {
      const double wanted = static_cast<double>(cell) / static_cast<double>(cells) * this->Cumulative.back();
      while (this->Cumulative[r] <= wanted)
      {
        ++r;
      }
      this->Guide[cell] = static_cast<int>(r);
    }
  }

  std::vector<double> Cumulative;
  std::vector<int> Guide;
};

/// Counts of the quadrats [begin, end), each of its own draw.
void SampleRange(
  const CountSampler& sampler, const RandomStream& random, std::size_t begin, std::size_t end, int* counts)
{
  FirstDraws draws;
  for (std::size_t q = begin; q < end; q += DrawsAtOnce)
  {
    const std::size_t count = std::min(DrawsAtOnce, end - q);
    std::iota(draws.Objects.begin(), draws.Objects.end(), std::uint64_t{ q });
    draws.Draw(random, count);
    for (std::size_t n = 0; n < count; ++n)
    {
      counts[q + n] = sampler(draws.Uniform[n]);
    }
  }
}

std::vector<int> SampledCounts(
  const QuadratLawParameters& law, long long quadrats, int seed, const ParallelFor& parallel)
{
  const CountSampler sampler(law);
  const RandomStream random(seed, RandomPurpose::QuadratCounts);
  std::vector<int> counts(static_cast<std::size_t>(quadrats));
  ForRanges(parallel, counts.size(), QuadratsOfTask,
    [&](std::size_t begin, std::size_t end) { SampleRange(sampler, random, begin, end, counts.data()); });
  return counts;
}

/// Puts counts in a random order (Fisher and Yates): swaps the last of q with one of all q, for q = end ... 2.
void Shuffle(std::vector<int>& counts, int seed, const Poll& poll)
{
  const RandomStream random(seed, RandomPurpose::QuadratOrder);
  FirstDraws draws;
  std::array<std::size_t, DrawsAtOnce> others;
  for (std::size_t last = counts.size(), block = 1; last > 1; ++block)
  {
    const std::size_t count = std::min(DrawsAtOnce, last - 1);
    for (std::size_t n = 0; n < count; ++n)
    {
      draws.Objects[n] = last - n;
    }
    draws.Draw(random, count);
    for (std::size_t n = 0; n < count; ++n)
    {
      const std::size_t q = last - n;
      others[n] = std::min(static_cast<std::size_t>(draws.Uniform[n] * static_cast<double>(q)), q - 1);
    }
    for (std::size_t n = 0; n < count; ++n)
    {
      std::swap(counts[last - n - 1], counts[others[n]]);
    }
    last -= count;
    if (block % 8 == 0)
    {
      poll();
    }
  }
}

/// The law's own frequencies, dealt at random.
std::vector<int> QuotaCounts(const QuadratLawParameters& law, long long quadrats, int seed, const Poll& poll)
{
  const std::vector<long long> frequency = QuotaFrequencies(law, quadrats);
  std::vector<int> counts;
  counts.reserve(static_cast<std::size_t>(quadrats));
  for (std::size_t r = 0; r < frequency.size(); ++r)
  {
    counts.insert(counts.end(), static_cast<std::size_t>(frequency[r]), static_cast<int>(r));
  }
  Shuffle(counts, seed, poll);
  return counts;
}

/// Points that are placed at once: of each its quadrat, its index in it, and the column and row of the quadrat.
struct PointRun
{
  /// So many of a quadrat are written at once; those too many are overwritten by the next quadrat's.
  static constexpr std::size_t Stride = 4;

  std::array<std::uint64_t, DrawsAtOnce + Stride> Quadrats;
  std::array<std::uint64_t, DrawsAtOnce + Stride> Indices;
  std::array<double, DrawsAtOnce + Stride> Columns;
  std::array<double, DrawsAtOnce + Stride> Rows;
  std::array<double, DrawsAtOnce> Across;
  std::array<double, DrawsAtOnce> Along;
  std::size_t Size = 0;
};

/// The next point to be placed.
struct PointCursor
{
  std::size_t Quadrat;
  std::size_t Index;
  std::size_t Column;
  std::size_t Row;
};

/// Fills a run from the cursor on, as far as there is room or the range goes.
LITTORAL_SIMD_CLONES
void FillRun(PointRun& run, PointCursor& next, const int* counts, std::size_t end, std::size_t columns)
{
  PointCursor at = next;
  std::size_t size = 0;
  while (at.Quadrat < end && size < DrawsAtOnce)
  {
    const std::size_t left = static_cast<std::size_t>(counts[at.Quadrat]) - at.Index;
    const std::size_t count = std::min(left, DrawsAtOnce - size);
    for (std::size_t n = 0; n < count || n == 0; n += PointRun::Stride)
    {
      for (std::size_t m = n; m < n + PointRun::Stride; ++m)
      {
        run.Quadrats[size + m] = at.Quadrat;
        run.Indices[size + m] = at.Index + m;
        run.Columns[size + m] = static_cast<double>(at.Column);
        run.Rows[size + m] = static_cast<double>(at.Row);
      }
    }
    size += count;
    at.Index += count;
    if (count == left)
    {
      ++at.Quadrat;
      at.Index = 0;
      const bool isNewRow = ++at.Column == columns;
      at.Column = isNewRow ? 0 : at.Column;
      at.Row += isNewRow;
    }
  }
  run.Size = size;
  next = at;
}

/// Positions of a run: x = x0 + Lx (i + u) / nx, y = y0 + Ly (j + v) / ny.
template <typename Id>
LITTORAL_INLINE void PlaceInline(const QuadratGrid& grid, const PointRun& run, double* positions, Id* quadrats)
{
  const double columns = grid.Count[0];
  const double rows = grid.Count[1];
  for (std::size_t n = 0; n < run.Size; ++n)
  {
    positions[3 * n] = grid.Origin[0] + grid.Size[0] * (run.Columns[n] + run.Across[n]) / columns;
    positions[3 * n + 1] = grid.Origin[1] + grid.Size[1] * (run.Rows[n] + run.Along[n]) / rows;
    positions[3 * n + 2] = 0.0;
    quadrats[n] = static_cast<Id>(run.Quadrats[n]);
  }
}

LITTORAL_SIMD_CLONES
void PlaceRun(const QuadratGrid& grid, const PointRun& run, double* positions, int* quadrats)
{
  PlaceInline(grid, run, positions, quadrats);
}

LITTORAL_SIMD_CLONES
void PlaceRun(const QuadratGrid& grid, const PointRun& run, double* positions, long long* quadrats)
{
  PlaceInline(grid, run, positions, quadrats);
}

}

std::string WhyInvalid(const QuadratGrid& grid)
{
  ParameterCheck check;
  for (int axis = 0; axis < 2; ++axis)
  {
    const std::string component = "[" + std::to_string(axis) + "]";
    check.Finite("Origin" + component, grid.Origin[axis]);
    check.Positive("Size" + component, grid.Size[axis]);
    check.Count("Quadrats" + component, grid.Count[axis], 1, std::numeric_limits<int>::max());
  }
  return check.Reason();
}

void ChooseQuadrats(QuadratGrid& grid, double points)
{
  const double side = std::sqrt(grid.Size[0] * grid.Size[1] / points);
  for (int axis = 0; axis < 2; ++axis)
  {
    grid.Count[axis] = std::max(1, static_cast<int>(std::lround(grid.Size[axis] / side)));
  }
}

std::vector<long long> QuotaFrequencies(const QuadratLawParameters& law, long long quadrats)
{
  std::vector<double> share = MassFunction(law);
  std::partial_sum(share.begin(), share.end(), share.begin());
  // Quadrats with at most r points, rounded down: all points are the sum over r of those with more.
  const double all = static_cast<double>(quadrats);
  std::vector<long long> below(share.size(), quadrats);
  std::vector<double> rest(share.size() - 1);
  long long points = 0;
  for (std::size_t r = 0; r < rest.size(); ++r)
  {
    const double exact = all * std::min(1.0, share[r] / share.back());
    below[r] = static_cast<long long>(exact);
    rest[r] = exact - static_cast<double>(below[r]);
    points += quadrats - below[r];
  }
  // As many as make points too many are rounded up: those with the largest remainders, of equal ones the last, so that
  // they still rise with r.
  std::vector<std::size_t> order(rest.size());
  std::iota(order.rbegin(), order.rend(), std::size_t{ 0 });
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return rest[a] > rest[b]; });
  const long long excess = points - std::llround(all * law.Mean);
  for (long long n = 0; n < std::min<long long>(excess, static_cast<long long>(order.size())); ++n)
  {
    ++below[order[static_cast<std::size_t>(n)]];
  }
  std::adjacent_difference(below.begin(), below.end(), below.begin());
  return below;
}

std::vector<int> QuadratCounts(const QuadratLawParameters& law, long long quadrats, QuadratMode mode, int seed,
  const Poll& poll, const ParallelFor& parallel)
{
  return mode == QuadratMode::Quota ? QuotaCounts(law, quadrats, seed, poll)
                                    : SampledCounts(law, quadrats, seed, parallel);
}

std::vector<long long> QuadratSites(
  const std::vector<int>& counts, std::size_t begin, std::size_t end, std::size_t quadratsAtOnce)
{
  const auto at = [&](std::size_t quadrat) { return counts.begin() + static_cast<std::ptrdiff_t>(quadrat); };
  std::vector<long long> sites{ std::accumulate(at(0), at(begin), 0ll) };
  for (std::size_t quadrat = begin; quadrat < end; quadrat += quadratsAtOnce)
  {
    const std::size_t next = quadrat + std::min(quadratsAtOnce, end - quadrat);
    sites.push_back(std::accumulate(at(quadrat), at(next), sites.back()));
  }
  return sites;
}

template <typename Id>
void PlaceQuadratPoints(const QuadratGrid& grid, int seed, const std::vector<int>& counts, std::size_t begin,
  std::size_t end, double* positions, Id* quadrats)
{
  const RandomStream random(seed, RandomPurpose::QuadratPositions);
  const auto columns = static_cast<std::size_t>(grid.Count[0]);
  PointCursor next{ begin, 0, begin % columns, begin / columns };
  PointRun run;
  while (next.Quadrat < end)
  {
    FillRun(run, next, counts.data(), end, columns);
    random.UniformPairs(run.Size, run.Quadrats.data(), run.Indices.data(), run.Across.data(), run.Along.data());
    PlaceRun(grid, run, positions, quadrats);
    positions += 3 * run.Size;
    quadrats += run.Size;
  }
}

template void PlaceQuadratPoints(
  const QuadratGrid&, int, const std::vector<int>&, std::size_t, std::size_t, double*, int*);
template void PlaceQuadratPoints(
  const QuadratGrid&, int, const std::vector<int>&, std::size_t, std::size_t, double*, long long*);

long long QuadratOf(const QuadratGrid& grid, double x, double y)
{
  const double u = (x - grid.Origin[0]) / grid.Size[0];
  const double v = (y - grid.Origin[1]) / grid.Size[1];
  if (!(u >= 0.0 && u <= 1.0 && v >= 0.0 && v <= 1.0))
  {
    return -1;
  }
  const int i = std::min(grid.Count[0] - 1, static_cast<int>(u * grid.Count[0]));
  const int j = std::min(grid.Count[1] - 1, static_cast<int>(v * grid.Count[1]));
  return static_cast<long long>(j) * grid.Count[0] + i;
}

}
