// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/PairFunctions.h"

#include "Numerics/Constants.h"
#include "Numerics/ParameterCheck.h"
#include "Numerics/SimdClones.h"
#include "Patterns/PointCells.h"
#include "Patterns/WindowSections.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

namespace littoral
{

namespace
{

/// Weights against the loss at the edge end here.
constexpr double LargestWeight = 100.0;
/// Points whose pairs are summed one after the other, at least, and so many sums at most, whatever the threads.
constexpr std::size_t PointsOfBlock = 256;
constexpr std::size_t MostBlocks = 256;
/// Distances that are looked at together.
constexpr std::size_t DistancesAtOnce = 1024;
/// Bins of the distances that the mark correlation is smoothed from, a step of the range.
constexpr int BinsOfStep = 8;
/// A distance that is by rounding above one of the range belongs to it.
constexpr double StepTolerance = 1e-9;

/// Sums over pairs by distance.
struct PairSums
{
  std::vector<double> Within;   ///< weights of pairs with a distance up to r(k), and not up to r(k - 1)
  std::vector<double> Kernel;   ///< sums of weight * (1 - (r - d)^2 / h^2), from `Margin` steps before 0
  std::vector<double> Counts;   ///< pairs near each bin's middle, by linear shares
  std::vector<double> Weights;  ///< their weights
  std::vector<double> Products; ///< their weights * products of marks

  void Add(const PairSums& other)
  {
    const auto add = [](std::vector<double>& sums, const std::vector<double>& more) {
      std::transform(sums.begin(), sums.end(), more.begin(), sums.begin(), std::plus<>());
    };
    add(this->Within, other.Within);
    add(this->Kernel, other.Kernel);
    add(this->Counts, other.Counts);
    add(this->Weights, other.Weights);
    add(this->Products, other.Products);
  }
};

/// Some points within reach of one, gathered for a loop.
struct NearPoints
{
  std::array<std::size_t, DistancesAtOnce> Index;
  std::array<double, DistancesAtOnce> Square;
  std::size_t Size = 0;
};

/// Those of a range of at most DistancesAtOnce points whose squared distance is at most `square`.
LITTORAL_SIMD_CLONES
void Gather(const double* xs, const double* ys, std::size_t begin, std::size_t end, double x, double y, double square,
  NearPoints& near)
{
  std::array<double, DistancesAtOnce> squares;
  const std::size_t count = end - begin;
  for (std::size_t n = 0; n < count; ++n)
  {
    const double dx = xs[begin + n] - x;
    const double dy = ys[begin + n] - y;
    squares[n] = dx * dx + dy * dy;
  }
  std::size_t size = 0;
  for (std::size_t n = 0; n < count; ++n)
  {
    near.Index[size] = begin + n;
    near.Square[size] = squares[n];
    size += squares[n] <= square;
  }
  near.Size = size;
}

/// Adds weight * max(0, 1 - (r / h)^2) to `count` sums, r from the first distance [m] on in steps [m].
LITTORAL_SIMD_CLONES
void AddKernel(double* sums, int count, double first, double step, double weight, double perWidth)
{
  for (int k = 0; k < count; ++k)
  {
    const double t = (first + k * step) * perWidth;
    sums[k] += weight * std::max(0.0, 1.0 - t * t);
  }
}

/// Common areas for the translation correction, those of the options if they reach far enough.
std::shared_ptr<const CommonAreaTable> AreasOf(
  const ObservationWindow& window, const PairOptions& options, double reach, const ParallelFor& parallel)
{
  if (options.Correction != EdgeCorrection::Translation || (options.Areas && options.Areas->GetLargest() >= reach))
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
    , Step(options.Distances.Largest / options.Distances.Steps)
    , HalfWidth(options.HalfWidth > 0.0 ? options.HalfWidth
                                        : 0.15 / std::sqrt(static_cast<double>(to.size()) / window.GetArea()))
    , WantsG(options.WantsG && options.Correction != EdgeCorrection::Border)
    , WantsMarks(!marks.empty() && options.Correction != EdgeCorrection::Border)
    , Margin(WantsG ? static_cast<int>(2.0 * HalfWidth / Step) + 3 : 0)
    , Reach(options.Distances.Largest + (WantsG ? HalfWidth : 0.0))
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
    const std::size_t length = std::max(PointsOfBlock, points / MostBlocks + 1);
    std::vector<PairSums> blocks((points + length - 1) / length);
    const auto sum = [&](std::size_t begin, std::size_t end) {
      for (std::size_t block = begin; block < end; ++block)
      {
        blocks[block] = this->SumOf(block * length, std::min(points, (block + 1) * length));
      }
    };
    ForRanges(parallel, blocks.size(), 1, sum);
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

  int GetMargin() const { return this->Margin; }
  double GetHalfWidth() const { return this->HalfWidth; }
  bool HasG() const { return this->WantsG; }
  bool HasMarks() const { return this->WantsMarks; }

private:
  bool NeedsEdge() const
  {
    return this->Options.Correction == EdgeCorrection::Border || this->Options.Correction == EdgeCorrection::Isotropic;
  }

  PlanePosition FromAt(std::size_t n) const { return { this->From.GetX()[n], this->From.GetY()[n] }; }

  PairSums NoSums() const
  {
    const std::size_t count = this->Options.Distances.Count();
    const std::size_t bins =
      this->WantsMarks ? static_cast<std::size_t>(this->Options.Distances.Steps) * BinsOfStep + 2 : 0;
    PairSums sums;
    sums.Within.assign(this->Options.WantsK ? count + 1 : 0, 0.0);
    sums.Kernel.assign(this->WantsG ? count + 2 * static_cast<std::size_t>(this->Margin) : 0, 0.0);
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

  /// The weight of a center [of the first pattern] for a distance.
  double CircleWeight(std::size_t n, double distance) const
  {
    if (distance <= this->EdgeDistances[n])
    {
      return 1.0;
    }
    return std::min(LargestWeight, 1.0 / this->Window.CircleInside(this->FromAt(n), distance));
  }

  /// The weights of the pair i, j and, within one pattern, of the pair j, i.
  double WeightOf(std::size_t i, std::size_t j, double distance) const
  {
    const double both = this->IsCross ? 1.0 : 2.0;
    switch (this->Options.Correction)
    {
      case EdgeCorrection::Isotropic:
        return this->CircleWeight(i, distance) + (this->IsCross ? 0.0 : this->CircleWeight(j, distance));
      case EdgeCorrection::Translation:
        return both *
          std::min(LargestWeight,
            this->Window.GetArea() /
              (*this->Areas)(this->To.GetX()[j] - this->From.GetX()[i], this->To.GetY()[j] - this->From.GetY()[i]));
      default:
        return both;
    }
  }

  /// A pair counts for r from its distance up to the center's distance to the edge.
  void AddBorder(std::size_t center, double distance, PairSums& sums) const
  {
    const std::size_t first = this->StepOf(distance);
    const std::size_t end = this->StepsUpTo(this->EdgeDistances[center]) + 1;
    if (first < end && this->Options.WantsK)
    {
      sums.Within[first] += 1.0;
      sums.Within[end] -= 1.0;
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

  void AddPair(std::size_t i, std::size_t j, double distance, PairSums& sums) const
  {
    if (this->Options.Correction == EdgeCorrection::Border)
    {
      this->AddBorder(i, distance, sums);
      if (!this->IsCross)
      {
        this->AddBorder(j, distance, sums);
      }
      return;
    }
    const double own = this->Weights.empty() ? 1.0 : this->Weights[i] * this->Weights[j];
    const double weight = own * this->WeightOf(i, j, distance);
    if (this->Options.WantsK)
    {
      sums.Within[this->StepOf(distance)] += weight;
    }
    if (this->WantsG)
    {
      const int first = static_cast<int>(std::floor((distance - this->HalfWidth) / this->Step));
      AddKernel(&sums.Kernel[static_cast<std::size_t>(this->Margin + first)], this->Margin,
        first * this->Step - distance, this->Step, weight, 1.0 / this->HalfWidth);
    }
    if (this->WantsMarks && distance <= this->Options.Distances.Largest)
    {
      this->AddMarks(i, j, distance, weight, sums);
    }
  }

  PairSums SumOf(std::size_t first, std::size_t last) const
  {
    PairSums sums = this->NoSums();
    NearPoints near;
    for (std::size_t i = first; i < last; ++i)
    {
      const double x = this->From.GetX()[i];
      const double y = this->From.GetY()[i];
      const auto add = [&](std::size_t begin, std::size_t end) {
        // Within one pattern each pair once: with the points that are sorted behind this one.
        for (std::size_t from = this->IsCross ? begin : std::max(begin, i + 1); from < end; from += DistancesAtOnce)
        {
          Gather(this->To.GetX().data(), this->To.GetY().data(), from, std::min(end, from + DistancesAtOnce), x, y,
            this->Reach * this->Reach, near);
          for (std::size_t n = 0; n < near.Size; ++n)
          {
            this->AddPair(i, near.Index[n], std::sqrt(near.Square[n]), sums);
          }
        }
      };
      this->To.ForRangesNear(x, y, this->Reach, this->IsCross ? 0 : this->To.RowOf(y), add);
    }
    return sums;
  }

  const ObservationWindow& Window;
  const PairOptions& Options;
  bool IsCross;
  double Step;
  double HalfWidth;
  bool WantsG;
  bool WantsMarks;
  int Margin; ///< steps of the kernel's width, and some
  double Reach;
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
  std::vector<double> k(options.Distances.Count());
  std::partial_sum(sums.Within.begin(), sums.Within.end() - 1, k.begin());
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
    g[k] =
      scale * sums.Kernel[k + static_cast<std::size_t>(summation.GetMargin())] / options.Distances[static_cast<int>(k)];
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
  const double binWidth = options.Distances.Largest / options.Distances.Steps / BinsOfStep;
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
  check.Positive("The largest distance", options.Distances.Largest, "m");
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

}
