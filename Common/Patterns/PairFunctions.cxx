// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/PairFunctions.h"

#include "Numerics/Constants.h"
#include "Numerics/ParameterCheck.h"
#include "Numerics/SimdClones.h"
#include "Patterns/PointCells.h"
#include "Patterns/WindowSections.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

namespace littoral
{

namespace
{

/// Weights against the loss at the edge end here.
constexpr double MaximumWeight = 100.0;
/// Points whose pairs are summed one after the other, at least, and so many sums at most, whatever the threads.
constexpr std::size_t PointsOfBlock = 256;
constexpr std::size_t MaximumBlocks = 256;
/// Parts of bins of all sums, at most.
constexpr std::size_t MaximumParts = 1u << 22u;
/// Points of a block whose pairs are summed at a time.
constexpr std::size_t PointsAtOnce = 32;
/// Pairs that are looked at together.
constexpr std::size_t PairsAtOnce = 256;
/// Parts of a step of the range, between which no kernel of g begins or ends.
constexpr std::size_t PartsOfStep = 3;
/// Bins of the distances that the mark correlation is smoothed from, a step of the range.
constexpr int BinsOfStep = 8;
/// A distance that is by rounding above one of the range belongs to it.
constexpr double StepTolerance = 1e-9;

/// Sums over pairs by distance. Bin 0 has those at the distance 0, bin k those above r(k - 1) and up to r(k); u is the
/// distance above r(k - 1), in steps.
struct PairSums
{
  std::vector<std::array<double, 3>> Moments; ///< sums of weight, weight u and weight u^2, by bin and part
  std::vector<double> Counts;                 ///< pairs near the middle of each bin of marks, by linear shares
  std::vector<double> Weights;                ///< their weights
  std::vector<double> Products;               ///< their weights * products of marks

  void Add(const PairSums& other)
  {
    for (std::size_t part = 0; part < this->Moments.size(); ++part)
    {
      for (std::size_t power = 0; power < 3; ++power)
      {
        this->Moments[part][power] += other.Moments[part][power];
      }
    }
    const auto add = [](std::vector<double>& sums, const std::vector<double>& more) {
      std::transform(sums.begin(), sums.end(), more.begin(), sums.begin(), std::plus<>());
    };
    add(this->Counts, other.Counts);
    add(this->Weights, other.Weights);
    add(this->Products, other.Products);
  }

  /// All sums, one after the other.
  std::vector<double> Row() const
  {
    std::vector<double> row;
    for (const std::array<double, 3>& moments : this->Moments)
    {
      row.insert(row.end(), moments.begin(), moments.end());
    }
    for (const std::vector<double>* sums : { &this->Counts, &this->Weights, &this->Products })
    {
      row.insert(row.end(), sums->begin(), sums->end());
    }
    return row;
  }

  /// Takes the sums of a row of the same sizes.
  void Take(const std::vector<double>& row)
  {
    const double* next = row.data();
    for (std::array<double, 3>& moments : this->Moments)
    {
      std::copy_n(next, 3, moments.begin());
      next += 3;
    }
    for (std::vector<double>* sums : { &this->Counts, &this->Weights, &this->Products })
    {
      std::copy_n(next, sums->size(), sums->begin());
      next += sums->size();
    }
  }
};

/// Some pairs of one point.
struct PairBatch
{
  std::size_t Size = 0;
  std::array<double, PairsAtOnce> X; ///< moves from the point to the others [m]
  std::array<double, PairsAtOnce> Y;
  std::array<double, PairsAtOnce> Distance; ///< [m]
  std::array<double, PairsAtOnce> Weight;
  std::array<double, PairsAtOnce> First;  ///< weight u
  std::array<double, PairsAtOnce> Second; ///< weight u^2
  std::array<int, PairsAtOnce> Part;      ///< of all bins
};

/// Moves and distances from a point to `batch.Size` others.
LITTORAL_SIMD_CLONES
void FindMoves(const double* xs, const double* ys, double x, double y, PairBatch& batch)
{
  for (std::size_t n = 0; n < batch.Size; ++n)
  {
    const double dx = xs[n] - x;
    const double dy = ys[n] - y;
    batch.X[n] = dx;
    batch.Y[n] = dy;
    batch.Distance[n] = std::sqrt(dx * dx + dy * dy);
  }
}

/// |W| / ((a - |dx|) (b - |dy|)), the translation correction of a rectangle of sides a and b, some times.
LITTORAL_SIMD_CLONES
void MoveRectangle(double a, double b, double times, PairBatch& batch)
{
  const double area = a * b;
  for (std::size_t n = 0; n < batch.Size; ++n)
  {
    const double common = (a - std::abs(batch.X[n])) * (b - std::abs(batch.Y[n]));
    batch.Weight[n] = times * area / std::max(area / MaximumWeight, common);
  }
}

/// The part of each pair and its moments; distances beyond `most` steps are all in the bin of that number.
LITTORAL_SIMD_CLONES
void FindParts(double stepsOfMetre, double most, double firstCut, double secondCut, PairBatch& batch)
{
  for (std::size_t n = 0; n < batch.Size; ++n)
  {
    const double next = std::min(most, batch.Distance[n] * stepsOfMetre) + 1.0;
    const int bin = static_cast<int>(next - StepTolerance);
    const double u = next - bin;
    batch.First[n] = batch.Weight[n] * u;
    batch.Second[n] = batch.First[n] * u;
    batch.Part[n] = static_cast<int>(PartsOfStep) * bin + (u > firstCut ? 1 : 0) + (u > secondCut ? 1 : 0);
  }
}

/// Common areas for the translation correction, those of the options if they reach far enough.
std::shared_ptr<const CommonAreaTable> AreasOf(
  const ObservationWindow& window, const PairOptions& options, double reach, const ParallelFor& parallel)
{
  if (options.Correction != EdgeCorrection::Translation ||
    (options.Areas && options.Areas->GetMaximumDistance() >= reach))
  {
    return options.Areas;
  }
  return std::make_shared<const CommonAreaTable>(window, reach, parallel);
}

/// The pairs of one pattern, or those from one to another.
class PairSummation
{
public:
  PairSummation(const std::vector<PlanePosition>& from, const std::vector<PlanePosition>& to, bool isCross,
    const std::vector<double>& marks, const ObservationWindow& window, const PairOptions& options,
    const ParallelFor& parallel)
    : Window(window)
    , Options(options)
    , IsCross(isCross)
    , Step(options.Distances.Maximum / options.Distances.Steps)
    , HalfWidth(options.HalfWidth > 0.0 ? options.HalfWidth
                                        : 0.15 / std::sqrt(static_cast<double>(to.size()) / window.GetArea()))
    , WantsG(options.WantsG && options.Correction != EdgeCorrection::Border)
    , WantsMarks(!marks.empty() && options.Correction != EdgeCorrection::Border)
    , Cuts(WantsG ? CutsOf(HalfWidth / Step) : std::array<double, PartsOfStep + 1>{ 0.0, 1.0, 1.0, 1.0 })
    , Reach(options.Distances.Maximum + (WantsG ? HalfWidth : 0.0))
    , Bins(static_cast<std::size_t>(Reach / Step) + 3)
    , To(to, Reach / 4.0)
    , OwnFrom(isCross ? PointCells(from, Reach / 4.0) : PointCells({}, 1.0))
    , From(isCross ? OwnFrom : To)
    , Areas(AreasOf(window, options, Reach, parallel))
  {
    for (std::size_t n = 0; n < this->From.Size(); ++n)
    {
      this->EdgeDistances.push_back(this->NeedsEdge() ? window.DistanceToEdge(this->FromAt(n)) : 0.0);
    }
    for (std::size_t n = 0; this->WantsMarks && n < this->From.Size(); ++n)
    {
      this->Marks.push_back(marks[this->From.GetOrder()[n]]);
    }
    for (std::size_t n = 0; n < options.Weights.size(); ++n)
    {
      this->Weights.push_back(options.Weights[this->From.GetOrder()[n]]);
    }
  }

  /// Sums of blocks of points, added in their order.
  PairSums Sum(const ParallelFor& parallel) const
  {
    const std::size_t points = this->From.Size();
    const std::size_t most = std::clamp<std::size_t>(MaximumParts / (PartsOfStep * this->Bins), 1, MaximumBlocks);
    const std::size_t length = std::max(PointsOfBlock, points / most + 1);
    std::vector<PairSums> blocks((points + length - 1) / length, this->NoSums());
    const WorkShare& share = this->Options.Share;
    // A part of each block after the other, in the order of its points: a loop can be ended between its ranges.
    for (std::size_t part = 0; part < length; part += PointsAtOnce)
    {
      ForRanges(parallel, share.OwnOf(blocks.size()), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t own = begin; own < end; ++own)
        {
          const std::size_t block = share.RowOf(own);
          const std::size_t last = std::min(points, (block + 1) * length);
          const std::size_t first = std::min(last, block * length + part);
          this->AddPairs(first, std::min(last, first + std::min(PointsAtOnce, length - part)), blocks[block]);
        }
      });
    }
    this->CompleteBlocks(blocks);
    PairSums sums = this->NoSums();
    for (const PairSums& block : blocks)
    {
      sums.Add(block);
    }
    return sums;
  }

  /// Points of the first pattern that are at least r(k) from the edge.
  std::vector<double> CentersBeyond() const
  {
    std::vector<double> centers(this->Options.Distances.Count(), 0.0);
    for (const double distance : this->EdgeDistances)
    {
      ++centers[std::min(centers.size() - 1, this->StepsUpTo(distance))];
    }
    for (std::size_t k = centers.size() - 1; k > 0; --k)
    {
      centers[k - 1] += centers[k];
    }
    return centers;
  }

  /// The weights of pairs by distance: with a distance up to r(k), and not up to r(k - 1).
  std::vector<double> WithinSteps(const PairSums& sums) const
  {
    std::vector<double> within(this->Options.Distances.Count(), 0.0);
    for (std::size_t k = 0; k < within.size(); ++k)
    {
      for (std::size_t part = 0; part < PartsOfStep; ++part)
      {
        within[k] += sums.Moments[PartsOfStep * k + part][0];
      }
    }
    return within;
  }

  /// sum of weight (1 - (r(k) - d)^2 / h^2) over the pairs with d nearer than h to r(k), whose parts of bins are wholly
  /// within that.
  double KernelAt(const PairSums& sums, std::size_t k) const
  {
    const double width = this->HalfWidth / this->Step;
    const double place = static_cast<double>(k);
    const auto first = static_cast<std::size_t>(std::max(0.0, std::floor(place - width)));
    const auto last = std::min(this->Bins - 2, static_cast<std::size_t>(std::ceil(place + width)));
    double sum = 0.0;
    for (std::size_t bin = first; bin <= last; ++bin)
    {
      const double off = place - static_cast<double>(bin) + 1.0; // of r from where u is 0
      for (std::size_t part = 0; part < PartsOfStep; ++part)
      {
        if (std::abs(off - 0.5 * (this->Cuts[part] + this->Cuts[part + 1])) < width)
        {
          const auto& [weight, once, twice] = sums.Moments[PartsOfStep * bin + part];
          sum += weight - (off * off * weight - 2.0 * off * once + twice) / (width * width);
        }
      }
    }
    return sum;
  }

  double GetHalfWidth() const { return this->HalfWidth; }
  bool HasG() const { return this->WantsG; }
  bool HasMarks() const { return this->WantsMarks; }

private:
  /// Brings the blocks of other processes in, on the first one.
  void CompleteBlocks(std::vector<PairSums>& blocks) const
  {
    if (this->Options.Share.Ranks < 2)
    {
      return;
    }
    NumberRows rows(blocks.size());
    std::transform(blocks.begin(), blocks.end(), rows.begin(), [](const PairSums& block) { return block.Row(); });
    this->Options.Share.CompleteFirst(rows);
    for (std::size_t block = 0; this->Options.Share.IsFirst() && block < blocks.size(); ++block)
    {
      blocks[block].Take(rows[block]);
    }
  }

  /// Ends within a step of kernels that are so many steps wide on each side.
  static std::array<double, PartsOfStep + 1> CutsOf(double width)
  {
    const double rest = width - std::floor(width);
    return { 0.0, std::min(rest, 1.0 - rest), std::max(rest, 1.0 - rest), 1.0 };
  }

  bool NeedsEdge() const
  {
    return this->Options.Correction == EdgeCorrection::Border || this->Options.Correction == EdgeCorrection::Isotropic;
  }

  PlanePosition FromAt(std::size_t n) const { return { this->From.GetX()[n], this->From.GetY()[n] }; }

  PairSums NoSums() const
  {
    const std::size_t bins =
      this->WantsMarks ? static_cast<std::size_t>(this->Options.Distances.Steps) * BinsOfStep + 2 : 0;
    PairSums sums;
    sums.Moments.assign(PartsOfStep * this->Bins, {});
    sums.Counts.assign(bins, 0.0);
    sums.Weights.assign(bins, 0.0);
    sums.Products.assign(bins, 0.0);
    return sums;
  }

  /// The first k with r(k) >= d, at most one beyond the range.
  std::size_t StepOf(double distance) const
  {
    const double k = std::ceil(distance / this->Step - StepTolerance);
    return std::min(this->Options.Distances.Count(), static_cast<std::size_t>(std::max(0.0, k)));
  }

  /// The last k with r(k) <= d.
  std::size_t StepsUpTo(double distance) const
  {
    const double k = std::floor(distance / this->Step + StepTolerance);
    return static_cast<std::size_t>(std::min(k, static_cast<double>(this->Options.Distances.Steps)));
  }

  /// The weight of a center of the first pattern for a distance.
  double CircleWeight(std::size_t n, double distance) const
  {
    if (distance <= this->EdgeDistances[n])
    {
      return 1.0;
    }
    return std::min(MaximumWeight, 1.0 / this->Window.CircleInside(this->FromAt(n), distance));
  }

  /// The weights of both pairs of point i and each point from `first` on, or of one to each point of another pattern.
  void FindWeights(std::size_t i, std::size_t first, PairBatch& batch) const
  {
    const double both = this->IsCross ? 1.0 : 2.0;
    if (this->Options.Correction == EdgeCorrection::Translation)
    {
      this->FindTranslationWeights(both, batch);
      return;
    }
    std::fill_n(batch.Weight.begin(), batch.Size, both);
    // Where the point is twice as far from the edge as it reaches, all circles are within the window.
    if (this->Options.Correction == EdgeCorrection::Isotropic && this->EdgeDistances[i] < 2.0 * this->Reach)
    {
      for (std::size_t n = 0; n < batch.Size; ++n)
      {
        const double distance = batch.Distance[n];
        if (distance <= this->Reach)
        {
          batch.Weight[n] =
            this->CircleWeight(i, distance) + (this->IsCross ? 0.0 : this->CircleWeight(first + n, distance));
        }
      }
    }
  }

  void FindTranslationWeights(double both, PairBatch& batch) const
  {
    const PlanePosition& low = this->Window.GetLow();
    const PlanePosition& high = this->Window.GetHigh();
    if (this->Window.IsRectangle())
    {
      MoveRectangle(high[0] - low[0], high[1] - low[1], both, batch);
      return;
    }
    const double area = this->Window.GetArea();
    for (std::size_t n = 0; n < batch.Size; ++n)
    {
      const double common = batch.Distance[n] <= this->Reach ? (*this->Areas)(batch.X[n], batch.Y[n]) : area;
      batch.Weight[n] = both * std::min(MaximumWeight, area / common);
    }
  }

  /// A pair counts for r from its distance up to the center's distance to the edge.
  void AddBorder(std::size_t center, double distance, PairSums& sums) const
  {
    const std::size_t first = this->StepOf(distance);
    const std::size_t end = this->StepsUpTo(this->EdgeDistances[center]) + 1;
    if (first < end && this->Options.WantsK)
    {
      sums.Moments[PartsOfStep * first][0] += 1.0;
      sums.Moments[PartsOfStep * end][0] -= 1.0;
    }
  }

  void AddMarks(std::size_t i, std::size_t j, double distance, double weight, PairSums& sums) const
  {
    const double place = distance / this->Step * BinsOfStep;
    const std::size_t bin = static_cast<std::size_t>(place);
    const double product = weight * this->Marks[i] * this->Marks[j];
    for (const std::size_t next : { 0, 1 })
    {
      const double off = place - static_cast<double>(bin);
      const double share = next == 0 ? 1.0 - off : off;
      sums.Counts[bin + next] += 2.0 * share;
      sums.Weights[bin + next] += weight * share;
      sums.Products[bin + next] += product * share;
    }
  }

  /// Pairs of which only those count whose center is far from the edge.
  void AddBorders(std::size_t i, std::size_t first, const PairBatch& batch, PairSums& sums) const
  {
    for (std::size_t n = 0; n < batch.Size; ++n)
    {
      if (batch.Distance[n] <= this->Reach)
      {
        this->AddBorder(i, batch.Distance[n], sums);
        if (!this->IsCross)
        {
          this->AddBorder(first + n, batch.Distance[n], sums);
        }
      }
    }
  }

  /// The pairs of point i and of points from `first` on.
  void AddBatch(std::size_t i, std::size_t first, PairBatch& batch, PairSums& sums) const
  {
    FindMoves(&this->To.GetX()[first], &this->To.GetY()[first], this->From.GetX()[i], this->From.GetY()[i], batch);
    if (this->Options.Correction == EdgeCorrection::Border)
    {
      this->AddBorders(i, first, batch, sums);
      return;
    }
    this->FindWeights(i, first, batch);
    for (std::size_t n = 0; !this->Weights.empty() && n < batch.Size; ++n)
    {
      batch.Weight[n] *= this->Weights[i] * this->Weights[first + n];
    }
    FindParts(1.0 / this->Step, static_cast<double>(this->Bins - 1), this->Cuts[1], this->Cuts[2], batch);
    for (std::size_t n = 0; n < batch.Size; ++n)
    {
      std::array<double, 3>& moments = sums.Moments[static_cast<std::size_t>(batch.Part[n])];
      moments[0] += batch.Weight[n];
      moments[1] += batch.First[n];
      moments[2] += batch.Second[n];
    }
    for (std::size_t n = 0; this->WantsMarks && n < batch.Size; ++n)
    {
      if (batch.Distance[n] <= this->Options.Distances.Maximum)
      {
        this->AddMarks(i, first + n, batch.Distance[n], batch.Weight[n], sums);
      }
    }
  }

  void AddPairs(std::size_t begin, std::size_t end, PairSums& sums) const
  {
    PairBatch batch;
    for (std::size_t i = begin; i < end; ++i)
    {
      const double x = this->From.GetX()[i];
      const double y = this->From.GetY()[i];
      const auto add = [&](std::size_t first, std::size_t last) {
        // Within one pattern each pair once: with the points that are sorted behind this one.
        for (std::size_t from = this->IsCross ? first : std::max(first, i + 1); from < last; from += PairsAtOnce)
        {
          batch.Size = std::min(PairsAtOnce, last - from);
          this->AddBatch(i, from, batch, sums);
        }
      };
      this->To.ForRangesNear(x, y, this->Reach, this->IsCross ? 0 : this->To.RowOf(y), add);
    }
  }

  const ObservationWindow& Window;
  const PairOptions& Options;
  bool IsCross;
  double Step;
  double HalfWidth;
  bool WantsG;
  bool WantsMarks;
  std::array<double, PartsOfStep + 1> Cuts; ///< where the parts of a step end
  double Reach;                             ///< farthest pairs that count [m]
  std::size_t Bins;                         ///< of which the last one is of pairs that do not count
  PointCells To;
  PointCells OwnFrom;
  const PointCells& From;
  std::shared_ptr<const CommonAreaTable> Areas;
  std::vector<double> EdgeDistances;
  std::vector<double> Marks;
  std::vector<double> Weights;
};

/// K from the sums; `pairs` is the number of ordered pairs, `target` the number of points that are counted.
std::vector<double> KOf(const PairSummation& summation, const PairSums& sums, const PairOptions& options, double area,
  double pairs, double target)
{
  std::vector<double> k = summation.WithinSteps(sums);
  std::partial_sum(k.begin(), k.end(), k.begin());
  if (options.Correction == EdgeCorrection::Border)
  {
    const std::vector<double> centers = summation.CentersBeyond();
    for (std::size_t n = 0; n < k.size(); ++n)
    {
      k[n] = centers[n] > 0.0 ? k[n] * area / (target * centers[n]) : std::numeric_limits<double>::quiet_NaN();
    }
    return k;
  }
  for (double& value : k)
  {
    value *= area / pairs;
  }
  return k;
}

/// g(r) = |W| / (pairs 2 pi r) sum of 3 / (4 h) (1 - (r - d)^2 / h^2) e.
std::vector<double> PairCorrelationOf(
  const PairSummation& summation, const PairSums& sums, const PairOptions& options, double area, double pairs)
{
  std::vector<double> g(options.Distances.Count(), std::numeric_limits<double>::quiet_NaN());
  const double scale = area / (pairs * 2.0 * Pi) * 3.0 / (4.0 * summation.GetHalfWidth());
  for (std::size_t k = 1; k < g.size(); ++k)
  {
    g[k] = scale * summation.KernelAt(sums, k) / options.Distances[static_cast<int>(k)];
  }
  return g;
}

/// The distance [m] below which lies a part of the pairs.
double Quantile(const std::vector<double>& counts, double total, double part, double binWidth)
{
  // A bin's pairs lie about its middle, which is bin * width.
  double below = 0.0;
  for (std::size_t bin = 0; bin < counts.size(); ++bin)
  {
    if (below + counts[bin] >= part * total)
    {
      return binWidth * (static_cast<double>(bin) - 0.5 + (part * total - below) / counts[bin]);
    }
    below += counts[bin];
  }
  return binWidth * static_cast<double>(counts.size());
}

/// Silverman's rule: 0.9 min(standard deviation, interquartile range / 1.34) N^(-1/5) of N distances [m].
double SilvermanWidth(const std::vector<double>& counts, double binWidth)
{
  double total = 0.0;
  double mean = 0.0;
  double square = 0.0;
  for (std::size_t bin = 0; bin < counts.size(); ++bin)
  {
    total += counts[bin];
    mean += counts[bin] * static_cast<double>(bin);
    square += counts[bin] * static_cast<double>(bin) * static_cast<double>(bin);
  }
  if (total < 2.0)
  {
    return 0.0;
  }
  mean /= total;
  const double deviation = binWidth * std::sqrt(std::max(0.0, (square - total * mean * mean) / (total - 1.0)));
  const double quartiles = Quantile(counts, total, 0.75, binWidth) - Quantile(counts, total, 0.25, binWidth);
  const double spread = quartiles > 0.0 ? std::min(deviation, quartiles / 1.34) : deviation;
  return 0.9 * spread * std::pow(total, -0.2);
}

/// k_mm(r), both sums smoothed by the same Gaussian kernel.
std::vector<double> MarkCorrelationOf(const PairSums& sums, const PairOptions& options, double meanMark)
{
  std::vector<double> correlation(options.Distances.Count(), std::numeric_limits<double>::quiet_NaN());
  const double binWidth = options.Distances.Maximum / options.Distances.Steps / BinsOfStep;
  const double width = options.MarkWidth > 0.0 ? options.MarkWidth : SilvermanWidth(sums.Counts, binWidth);
  if (!(width > 0.0))
  {
    return correlation;
  }
  // exp(-z^2 / 2) up to z = 6, where it is 1e-8.
  const int bins = static_cast<int>(sums.Counts.size());
  const int reach = static_cast<int>(std::min(6.0 * width / binWidth, static_cast<double>(bins)));
  std::vector<double> kernel(static_cast<std::size_t>(reach) + 1);
  for (int n = 0; n <= reach; ++n)
  {
    const double z = n * binWidth / width;
    kernel[static_cast<std::size_t>(n)] = std::exp(-0.5 * z * z);
  }
  for (std::size_t k = 0; k < correlation.size(); ++k)
  {
    const int at = static_cast<int>(k) * BinsOfStep;
    double product = 0.0;
    double weight = 0.0;
    for (int bin = std::max(0, at - reach); bin <= std::min(bins - 1, at + reach); ++bin)
    {
      const double share = kernel[static_cast<std::size_t>(std::abs(bin - at))];
      product += share * sums.Products[static_cast<std::size_t>(bin)];
      weight += share * sums.Weights[static_cast<std::size_t>(bin)];
    }
    correlation[k] = weight > 0.0 ? product / (weight * meanMark * meanMark) : correlation[k];
  }
  return correlation;
}

/// The number of ordered pairs of one pattern, or what weights make of it: (sum of w)^2 - sum of w^2.
double PairsOf(std::size_t points, const std::vector<double>& weights)
{
  double sum = static_cast<double>(points);
  double squares = sum;
  if (!weights.empty())
  {
    sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    squares = std::inner_product(weights.begin(), weights.end(), weights.begin(), 0.0);
  }
  return sum * sum - squares;
}

PairFunctions FunctionsOf(const std::vector<PlanePosition>& from, const std::vector<PlanePosition>& to, bool isCross,
  const std::vector<double>& marks, const ObservationWindow& window, const PairOptions& options,
  const ParallelFor& parallel)
{
  const PairSummation summation(from, to, isCross, marks, window, options, parallel);
  const PairSums sums = summation.Sum(parallel);
  const double area = window.GetArea();
  const double target = static_cast<double>(to.size());
  const double pairs = isCross ? static_cast<double>(from.size()) * target : PairsOf(from.size(), options.Weights);
  PairFunctions functions;
  if (options.WantsK)
  {
    functions.K = KOf(summation, sums, options, area, pairs, target);
  }
  if (summation.HasG())
  {
    functions.PairCorrelation = PairCorrelationOf(summation, sums, options, area, pairs);
  }
  if (summation.HasMarks())
  {
    const double mean = std::accumulate(marks.begin(), marks.end(), 0.0) / static_cast<double>(marks.size());
    functions.MarkCorrelation = MarkCorrelationOf(sums, options, mean);
  }
  return functions;
}

}

DistanceRange DefaultDistances(const ObservationWindow& window, std::size_t points, int steps)
{
  const double width = window.GetHigh()[0] - window.GetLow()[0];
  const double height = window.GetHigh()[1] - window.GetLow()[1];
  const double intensity = static_cast<double>(points) / window.GetArea();
  return { std::min(0.25 * std::min(width, height), std::sqrt(1000.0 / (Pi * intensity))), steps };
}

std::string WhyInvalid(const PairOptions& options)
{
  ParameterCheck check;
  check.Positive("The largest distance", options.Distances.Maximum, "m");
  check.Count("The number of steps", options.Distances.Steps, 1, 100000);
  check.NotNegative("The half width of the kernel", options.HalfWidth, "m");
  check.NotNegative("The width of the marks' kernel", options.MarkWidth, "m");
  check.Choice("The edge correction", static_cast<int>(options.Correction), 4);
  return check.Reason();
}

PairFunctions FindPairFunctions(const std::vector<PlanePosition>& points, const ObservationWindow& window,
  const PairOptions& options, const ParallelFor& parallel)
{
  return FunctionsOf(points, points, false, {}, window, options, parallel);
}

PairFunctions FindPairFunctions(const std::vector<PlanePosition>& points, const std::vector<double>& marks,
  const ObservationWindow& window, const PairOptions& options, const ParallelFor& parallel)
{
  return FunctionsOf(points, points, false, marks, window, options, parallel);
}

PairFunctions FindCrossFunctions(const std::vector<PlanePosition>& from, const std::vector<PlanePosition>& to,
  const ObservationWindow& window, const PairOptions& options, const ParallelFor& parallel)
{
  return FunctionsOf(from, to, true, {}, window, options, parallel);
}

std::vector<double> BesagL(const std::vector<double>& k)
{
  std::vector<double> l(k.size());
  std::transform(k.begin(), k.end(), l.begin(), [](double value) { return std::sqrt(value / Pi); });
  return l;
}

std::vector<double> CenteredL(const std::vector<double>& l, const std::vector<double>& distances)
{
  std::vector<double> centered(l.size());
  std::transform(l.begin(), l.end(), distances.begin(), centered.begin(), std::minus<>());
  return centered;
}

}
