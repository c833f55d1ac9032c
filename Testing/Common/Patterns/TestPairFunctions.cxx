// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Functions of pairs: definitions summed pair by pair, random patterns and lattices, spatstat's values, same bytes.
#include "../OnThreads.h"
#include "Numerics/Constants.h"
#include "Patterns/CurveEnvelope.h"
#include "Patterns/PairFunctions.h"
#include "Patterns/PointCells.h"
#include "Patterns/WindowSections.h"
#include "SyntheticPatterns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>

using namespace littoral;
using namespace littoral::testing;

namespace
{

constexpr EdgeCorrection AllCorrections[] = { EdgeCorrection::None, EdgeCorrection::Border, EdgeCorrection::Isotropic,
  EdgeCorrection::Translation };

PairOptions Options(double largest, EdgeCorrection correction, int steps = 64)
{
  PairOptions options;
  options.Distances = { largest, steps };
  options.Correction = correction;
  return options;
}

/// The definitions, over all pairs one by one.
struct PairByPair
{
  std::vector<double> K;
  std::vector<double> G;

  PairByPair(const std::vector<PlanePosition>& from, const std::vector<PlanePosition>& to, bool isCross,
    const ObservationWindow& window, const PairOptions& options)
  {
    const double area = window.GetArea();
    const double pairs = static_cast<double>(from.size()) * (static_cast<double>(to.size()) - (isCross ? 0.0 : 1.0));
    const double h =
      options.HalfWidth > 0.0 ? options.HalfWidth : 0.15 * std::sqrt(area / static_cast<double>(to.size()));
    for (std::size_t k = 0; k < options.Distances.Count(); ++k)
    {
      const double r = options.Distances[static_cast<int>(k)];
      double within = 0.0;
      double kernel = 0.0;
      double centers = 0.0;
      for (std::size_t i = 0; i < from.size(); ++i)
      {
        const bool isCenter = options.Correction != EdgeCorrection::Border || window.DistanceToEdge(from[i]) >= r;
        centers += isCenter;
        for (std::size_t j = 0; j < to.size(); ++j)
        {
          const double dx = to[j][0] - from[i][0];
          const double dy = to[j][1] - from[i][1];
          const double d = std::hypot(dx, dy);
          if (!isCenter || (!isCross && i == j))
          {
            continue;
          }
          double weight = 1.0;
          weight = options.Correction == EdgeCorrection::Isotropic ? 1.0 / window.CircleInside(from[i], d) : weight;
          weight = options.Correction == EdgeCorrection::Translation ? area / window.CommonArea(dx, dy) : weight;
          weight = std::min(weight, 100.0);
          within += d <= r ? weight : 0.0;
          kernel += std::abs(d - r) < h ? weight * 0.75 / h * (1.0 - (d - r) * (d - r) / (h * h)) : 0.0;
        }
      }
      const bool isBorder = options.Correction == EdgeCorrection::Border;
      this->K.push_back(area * within / (isBorder ? centers * static_cast<double>(to.size()) : pairs));
      this->G.push_back(area * kernel / (pairs * TwoPi * r));
    }
  }
};

TEST(PairFunctions, FollowTheirDefinitions)
{
  for (const SyntheticPattern& pattern : SyntheticPatterns())
  {
    const bool isPolygon = !pattern.Window.IsRectangle();
    const double largest = 0.3 * (pattern.Window.GetHigh()[0] - pattern.Window.GetLow()[0]);
    const auto half = pattern.Points.begin() + static_cast<std::ptrdiff_t>(pattern.Points.size() / 3);
    const std::vector<PlanePosition> from(pattern.Points.begin(), half);
    const std::vector<PlanePosition> to(half, pattern.Points.end());
    for (const EdgeCorrection correction : AllCorrections)
    {
      if (isPolygon && correction == EdgeCorrection::Translation)
      {
        continue; // by a table: see AgreeWithSpatstat
      }
      const PairOptions options = Options(largest, correction, 30);
      for (const bool isCross : { false, true })
      {
        const PairFunctions found = isCross ? FindCrossFunctions(from, to, pattern.Window, options)
                                            : FindPairFunctions(pattern.Points, pattern.Window, options);
        const PairByPair wanted(
          isCross ? from : pattern.Points, isCross ? to : pattern.Points, isCross, pattern.Window, options);
        ASSERT_EQ(found.K.size(), 31u);
        EXPECT_EQ(found.PairCorrelation.size(), correction == EdgeCorrection::Border ? 0u : 31u);
        for (std::size_t k = 0; k < found.K.size(); ++k)
        {
          EXPECT_TRUE(std::isnan(wanted.K[k]) ? std::isnan(found.K[k])
                                              : std::abs(found.K[k] - wanted.K[k]) <= 1e-10 * wanted.K[k])
            << pattern.Name << " " << k << " " << found.K[k] << " " << wanted.K[k];
        }
        for (std::size_t k = 1; k < found.PairCorrelation.size(); ++k)
        {
          EXPECT_NEAR(found.PairCorrelation[k], wanted.G[k], 1e-10 * (1.0 + wanted.G[k])) << pattern.Name << " " << k;
        }
        EXPECT_TRUE(found.PairCorrelation.empty() || std::isnan(found.PairCorrelation[0]));
      }
    }
  }
}

// Sums of moments give the kernel of each pair, whether it is narrower than a step, as wide as some steps or wider than
// the range.
TEST(PairFunctions, KernelsHaveAnyWidth)
{
  const SyntheticPattern pattern = SyntheticPatterns().front();
  const double largest = 0.3 * (pattern.Window.GetHigh()[0] - pattern.Window.GetLow()[0]);
  PairOptions options = Options(largest, EdgeCorrection::Translation, 30);
  for (const double steps : { 0.04, 0.5, 0.7, 1.0, 3.0, 4.25, 47.9 })
  {
    options.HalfWidth = steps * options.Distances[1];
    const PairFunctions found = FindPairFunctions(pattern.Points, pattern.Window, options);
    const PairByPair wanted(pattern.Points, pattern.Points, false, pattern.Window, options);
    for (std::size_t k = 1; k < found.K.size(); ++k)
    {
      EXPECT_NEAR(found.PairCorrelation[k], wanted.G[k], 1e-10 * (1.0 + wanted.G[k])) << steps << " " << k;
      EXPECT_NEAR(found.K[k], wanted.K[k], 1e-10 * wanted.K[k]) << steps << " " << k;
    }
  }
}

/// What is measured of a pattern, at 512 distances.
class Measured
{
public:
  explicit Measured(const SyntheticPattern& pattern)
    : Pattern(pattern)
  {
  }
  double ValueAt(const ReferenceValue& reference)
  {
    const bool isCross = reference.Function.find("cross") == 0;
    const auto [place, isNew] = this->Functions.try_emplace({ isCross, reference.Correction });
    const PairOptions options = this->OptionsOf(reference);
    if (isNew)
    {
      place->second = this->Find(isCross, options);
    }
    const PairFunctions& found = place->second;
    const auto k = static_cast<std::size_t>(std::lround(reference.Distance / options.Distances.Maximum * 512.0));
    return reference.Function == "m"     ? found.MarkCorrelation[k]
      : reference.Function.back() == 'K' ? found.K[k]
                                         : found.PairCorrelation[k];
  }

private:
  PairOptions OptionsOf(const ReferenceValue& reference) const
  {
    const char* names[] = { "none", "border", "isotropic", "translate" };
    PairOptions options = Options(0.0, EdgeCorrection::None, 512);
    for (const EdgeCorrection correction : AllCorrections)
    {
      options.Correction =
        reference.Correction == names[static_cast<int>(correction)] ? correction : options.Correction;
    }
    const ObservationWindow& window = this->Pattern.Window;
    options.Distances.Maximum =
      0.2 * std::min(window.GetHigh()[0] - window.GetLow()[0], window.GetHigh()[1] - window.GetLow()[1]);
    return options;
  }
  PairFunctions Find(bool isCross, const PairOptions& options) const
  {
    const std::vector<PlanePosition>& points = this->Pattern.Points;
    const auto half = points.begin() + static_cast<std::ptrdiff_t>(points.size() / 2);
    return isCross ? FindCrossFunctions({ points.begin(), half }, { half, points.end() }, this->Pattern.Window, options)
                   : FindPairFunctions(points, this->Pattern.Marks, this->Pattern.Window, options);
  }

  const SyntheticPattern& Pattern;
  std::map<std::pair<bool, std::string>, PairFunctions> Functions; // by cross, correction
};

TEST(PairFunctions, AgreeWithSpatstat)
{
  const std::vector<ReferenceValue> references = ReadReference(LITTORAL_TEST_DATA "/PointPatterns/spatstat.csv");
  int compared = 0;
  for (const SyntheticPattern& pattern : SyntheticPatterns())
  {
    Measured measured(pattern);
    for (const ReferenceValue& reference : references)
    {
      if (reference.Pattern != pattern.Name || reference.Function == "G" || reference.Function == "F")
      {
        continue;
      }
      ++compared;
      EXPECT_NEAR(measured.ValueAt(reference), reference.Value, 0.01 * reference.Value)
        << pattern.Name << " " << reference.Function << " " << reference.Correction << " at " << reference.Distance;
    }
  }
  EXPECT_EQ(compared, 3 * 112);
}

// Random patterns have K = pi r^2 and g = 1, in any window, with any correction.
TEST(PairFunctions, OfRandomPatternsAreThoseOfChance)
{
  constexpr int Patterns = 100;
  for (const SyntheticPattern& shape : SyntheticPatterns())
  {
    for (const EdgeCorrection correction :
      { EdgeCorrection::Border, EdgeCorrection::Isotropic, EdgeCorrection::Translation })
    {
      const double largest = 0.2 * std::sqrt(shape.Window.GetArea());
      PairOptions options = Options(largest, correction, 8);
      options.Areas = std::make_shared<CommonAreaTable>(shape.Window, 1.2 * largest);
      // As a ratio, the estimate with a border is biased by about 1 / n.
      const double bias = correction == EdgeCorrection::Border ? 0.02 : 0.0;
      std::vector<double> k(9, 0.0), kSquare(9, 0.0), g(9, 0.0), gSquare(9, 0.0), cross(9, 0.0), crossSquare(9, 0.0);
      for (int n = 0; n < Patterns; ++n)
      {
        const std::vector<PlanePosition> points = UniformPattern(shape.Window, 150, 3, n);
        const PairFunctions found = FindPairFunctions(points, shape.Window, options);
        const PairFunctions between = FindCrossFunctions(
          { points.begin(), points.begin() + 60 }, { points.begin() + 60, points.end() }, shape.Window, options);
        for (std::size_t step = 1; step < 9; ++step)
        {
          k[step] += found.K[step] / Patterns;
          kSquare[step] += found.K[step] * found.K[step] / Patterns;
          cross[step] += between.K[step] / Patterns;
          crossSquare[step] += between.K[step] * between.K[step] / Patterns;
          if (!found.PairCorrelation.empty())
          {
            g[step] += found.PairCorrelation[step] / Patterns;
            gSquare[step] += found.PairCorrelation[step] * found.PairCorrelation[step] / Patterns;
          }
        }
      }
      const auto error = [&](double mean, double square) { return std::sqrt((square - mean * mean) / Patterns); };
      for (std::size_t step = 2; step < 9; ++step)
      {
        const double r = options.Distances[static_cast<int>(step)];
        EXPECT_NEAR(k[step], Pi * r * r, 4.0 * error(k[step], kSquare[step]) + bias * Pi * r * r)
          << shape.Name << " " << step;
        EXPECT_NEAR(cross[step], Pi * r * r, 4.0 * error(cross[step], crossSquare[step]) + bias * Pi * r * r)
          << shape.Name << " " << step;
        EXPECT_LT(error(k[step], kSquare[step]), 0.05 * Pi * r * r);
        if (correction != EdgeCorrection::Border)
        {
          EXPECT_NEAR(g[step], 1.0, 4.0 * error(g[step], gSquare[step])) << shape.Name << " " << step;
        }
      }
    }
  }
}

// Points of a square lattice have 4, 8, 12, 20 others within 1, 1.4, 2, 2.2 m.
TEST(PairFunctions, CountTheNeighborsOnALattice)
{
  std::vector<PlanePosition> points;
  for (int i = 0; i < 20; ++i)
  {
    for (int j = 0; j < 20; ++j)
    {
      points.push_back({ 0.5 + i, 0.5 + j });
    }
  }
  const ObservationWindow window = ObservationWindow::Rectangle({ 0.0, 0.0 }, { 20.0, 20.0 });
  const PairFunctions border = FindPairFunctions(points, window, Options(3.0, EdgeCorrection::Border, 30));
  const double neighbors[] = { 0, 4, 4, 8, 8, 12, 12, 20 }; // at 0.9, 1.0, 1.4, 1.5, 1.9, 2.0, 2.2, 2.3 m
  const std::size_t steps[] = { 9, 10, 14, 15, 19, 20, 22, 23 };
  for (int n = 0; n < 8; ++n)
  {
    EXPECT_NEAR(border.K[steps[n]], neighbors[n], 1e-12) << steps[n];
  }
  EXPECT_NEAR(BesagL(border.K)[10], std::sqrt(4.0 / Pi), 1e-12);
  // e = |W| / |W moved| is 20 / 19 for the next ones: 2 * 2 * 19 * 20 ordered pairs.
  const PairFunctions moved = FindPairFunctions(points, window, Options(1.2, EdgeCorrection::Translation, 12));
  EXPECT_NEAR(moved.K[11], 400.0 / (400.0 * 399.0) * 1520.0 * 20.0 / 19.0, 1e-12);
  EXPECT_EQ(moved.K[9], 0.0);
}

TEST(PairFunctions, OfMarksTellHowNeighborsAreAlike)
{
  const SyntheticPattern pattern = SyntheticPatterns().front();
  const std::size_t count = pattern.Points.size();
  const PairOptions options = Options(16.0, EdgeCorrection::Translation);
  const auto correlation = [&](const std::vector<double>& marks, const PairOptions& how) {
    return FindPairFunctions(pattern.Points, marks, pattern.Window, how).MarkCorrelation;
  };
  for (const double value : correlation(std::vector<double>(count, 7.0), options))
  {
    EXPECT_NEAR(value, 1.0, 1e-12);
  }
  // Marks that grow along x: those of near points are alike, so that products are the mean square.
  std::vector<double> marks;
  double mean = 0.0;
  double square = 0.0;
  for (const PlanePosition& point : pattern.Points)
  {
    marks.push_back(1.0 + point[0]);
    mean += marks.back() / static_cast<double>(count);
    square += marks.back() * marks.back() / static_cast<double>(count);
  }
  PairOptions narrow = options;
  narrow.MarkWidth = 0.2;
  EXPECT_NEAR(correlation(marks, narrow)[4], square / (mean * mean), 0.1);
  EXPECT_NE(correlation(marks, narrow)[4], correlation(marks, options)[4]);
  // In other units the same.
  std::vector<double> others = marks;
  std::transform(marks.begin(), marks.end(), others.begin(), [](double mark) { return 0.01 * mark; });
  for (std::size_t k = 0; k <= 64; ++k)
  {
    EXPECT_NEAR(correlation(others, options)[k], correlation(marks, options)[k], 1e-12);
  }
  EXPECT_TRUE(correlation(marks, Options(16.0, EdgeCorrection::Border)).empty());
  // A pair has no spread of distances to smooth over.
  const PairFunctions two = FindPairFunctions(
    { { 0.4, 0.5 }, { 0.6, 0.5 } }, { 1.0, 2.0 }, ObservationWindow(), Options(0.1, EdgeCorrection::None));
  EXPECT_TRUE(std::isnan(two.MarkCorrelation[3]));
}

TEST(PairFunctions, LeaveOutWhatIsNotWanted)
{
  const SyntheticPattern pattern = SyntheticPatterns().front();
  for (const EdgeCorrection correction : AllCorrections)
  {
    PairOptions options = Options(10.0, correction);
    const PairFunctions both = FindPairFunctions(pattern.Points, pattern.Window, options);
    options.WantsG = false;
    const PairFunctions onlyK = FindPairFunctions(pattern.Points, pattern.Window, options);
    EXPECT_TRUE(onlyK.PairCorrelation.empty());
    EXPECT_TRUE(onlyK.MarkCorrelation.empty());
    ASSERT_EQ(onlyK.K.size(), both.K.size());
    for (std::size_t k = 0; k < both.K.size(); ++k)
    {
      EXPECT_NEAR(onlyK.K[k], both.K[k], 1e-9 * both.K[k]); // in another order
    }
    options.WantsG = true;
    options.WantsK = false;
    const PairFunctions onlyG = FindPairFunctions(pattern.Points, pattern.Window, options);
    EXPECT_TRUE(onlyG.K.empty());
    EXPECT_TRUE(std::equal(onlyG.PairCorrelation.begin() + (onlyG.PairCorrelation.empty() ? 0 : 1),
      onlyG.PairCorrelation.end(), both.PairCorrelation.begin() + (both.PairCorrelation.empty() ? 0 : 1)));
  }
}

TEST(PairFunctions, HaveTheSameBytesOnAnyThreads)
{
  const SyntheticPattern polygon = SyntheticPatterns().back();
  const std::vector<PlanePosition> points = UniformPattern(polygon.Window, 3000, 5, 0);
  std::vector<double> marks;
  for (const PlanePosition& point : points)
  {
    marks.push_back(1.0 + std::abs(point[0]));
  }
  const auto backwards = [](std::size_t count, const RangeTask& task) {
    for (std::size_t n = count; n-- > 0;)
    {
      task(n, n + 1);
    }
  };
  const auto isSame = [](const std::vector<double>& one, const std::vector<double>& other) {
    return std::equal(one.begin(), one.end(), other.begin(), other.end(),
      [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); });
  };
  for (const EdgeCorrection correction : AllCorrections)
  {
    const PairOptions options = Options(6.0, correction);
    const PairFunctions serial = FindPairFunctions(points, marks, polygon.Window, options);
    for (const ParallelFor& parallel : { ParallelFor(backwards), OnThreads(2), OnThreads(7) })
    {
      const PairFunctions other = FindPairFunctions(points, marks, polygon.Window, options, parallel);
      EXPECT_TRUE(isSame(serial.K, other.K));
      EXPECT_TRUE(isSame(serial.PairCorrelation, other.PairCorrelation));
      EXPECT_TRUE(isSame(serial.MarkCorrelation, other.MarkCorrelation));
    }
  }
}

// Each process makes its rows alone, and the first one, with those of the others, has the bytes of one that makes them
// all.
TEST(PairFunctions, HaveTheSameBytesOnAnyProcesses)
{
  const ObservationWindow window;
  const std::vector<PlanePosition> points = UniformPattern(window, 1500, 3, 0);
  std::vector<double> marks;
  std::transform(
    points.begin(), points.end(), std::back_inserter(marks), [](const PlanePosition& p) { return 1.0 + p[0]; });
  PairOptions options = Options(0.1, EdgeCorrection::Translation);
  const PairFunctions alone = FindPairFunctions(points, marks, window, options);
  NumberRows all;
  options.Share.Ranks = 4;
  for (std::size_t rank = 0; rank < 4; ++rank)
  {
    options.Share.Rank = rank;
    options.Share.Collect = [&](NumberRows& rows) {
      all.resize(rows.size());
      for (std::size_t n = rank; n < rows.size(); n += 4)
      {
        EXPECT_TRUE(all[n].empty());
        all[n] = rows[n];
      }
    };
    FindPairFunctions(points, marks, window, options);
  }
  options.Share.Rank = 0;
  EXPECT_EQ(all.size(), 6u); // blocks of 256 points
  options.Share.Collect = [&](NumberRows& rows) { rows = all; };
  const PairFunctions shared = FindPairFunctions(points, marks, window, options);
  EXPECT_EQ(shared.K, alone.K);
  EXPECT_EQ(shared.MarkCorrelation, alone.MarkCorrelation);
  EXPECT_TRUE(std::equal(shared.PairCorrelation.begin() + 1, shared.PairCorrelation.end(),
    alone.PairCorrelation.begin() + 1, alone.PairCorrelation.end())); // g(0) is NaN
}

TEST(PairFunctions, ChooseDistancesThatCanBeTrusted)
{
  const ObservationWindow window = ObservationWindow::Rectangle({ 0.0, 0.0 }, { 200.0, 100.0 });
  EXPECT_DOUBLE_EQ(DefaultDistances(window, 100).Maximum, 25.0);
  EXPECT_DOUBLE_EQ(DefaultDistances(window, 200000).Maximum, std::sqrt(100.0 / Pi)); // 10 points a square metre
  EXPECT_EQ(DefaultDistances(window, 100).Steps, 512);
}

TEST(PairFunctions, RefuseBadOptions)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(WhyInvalid(Options(1.0, EdgeCorrection::None)), "");
  for (const double largest : { 0.0, -1.0, nan })
  {
    EXPECT_NE(WhyInvalid(Options(largest, EdgeCorrection::None)).find("largest distance"), std::string::npos);
  }
  EXPECT_NE(WhyInvalid(Options(1.0, EdgeCorrection::None, 0)).find("steps"), std::string::npos);
  EXPECT_NE(WhyInvalid(Options(1.0, static_cast<EdgeCorrection>(4))).find("edge correction"), std::string::npos);
  PairOptions options = Options(1.0, EdgeCorrection::None);
  options.HalfWidth = -1.0;
  EXPECT_NE(WhyInvalid(options).find("half width"), std::string::npos);
  options.HalfWidth = 0.0;
  options.MarkWidth = nan;
  EXPECT_NE(WhyInvalid(options).find("marks' kernel"), std::string::npos);
}

TEST(PointCells, FindAllThatAreNear)
{
  const std::vector<PlanePosition> points = UniformPattern(SyntheticPatterns().back().Window, 500, 2, 0);
  for (const double size : { 0.01, 3.0, 40.0, 1000.0 })
  {
    const PointCells cells(points, size);
    ASSERT_EQ(cells.Size(), points.size());
    for (const PlanePosition& place : { PlanePosition{ 50.0, 50.0 }, { 0.0, 0.0 }, { -30.0, 200.0 }, points[7] })
    {
      double nearest = std::numeric_limits<double>::infinity();
      std::size_t within = 0;
      for (const PlanePosition& point : points)
      {
        const double distance = std::hypot(point[0] - place[0], point[1] - place[1]);
        nearest = std::min(nearest, distance);
        within += distance <= 20.0;
      }
      EXPECT_DOUBLE_EQ(cells.NearestDistance(place[0], place[1]), nearest);
      std::vector<std::size_t> found;
      cells.ForRangesNear(place[0], place[1], 20.0, 0, [&](std::size_t begin, std::size_t end) {
        for (std::size_t n = begin; n < end; ++n)
        {
          if (std::hypot(cells.GetX()[n] - place[0], cells.GetY()[n] - place[1]) <= 20.0)
          {
            found.push_back(cells.GetOrder()[n]);
          }
        }
      });
      EXPECT_EQ(found.size(), within);
      std::sort(found.begin(), found.end());
      EXPECT_EQ(std::unique(found.begin(), found.end()), found.end());
    }
  }
  EXPECT_TRUE(std::isinf(PointCells({ { 1.0, 1.0 } }, 1.0).NearestDistance(1.0, 1.0, 0)));
}

}
