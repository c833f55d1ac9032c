// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Species and marks of Thomas clusters against closed forms. A sum over ordered pairs nearer than r of
// 1 / |W and W moved by their difference| has the mean intensity_1 intensity_2 K_12(r) (Ohser 1983).
#include "Numerics/Constants.h"
#include "Patterns/ProcessPattern.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace littoral;

namespace
{

constexpr int Seeds = 500;
constexpr double Radii[] = { 0.03, 0.08, 0.15 };

PointProcessParameters Clusters()
{
  PointProcessParameters process;
  process.Process = PointProcess::Thomas;
  process.Intensity = 100.0;
  process.ClusterSize = 4.0;
  process.ClusterScale = 0.03;
  return process;
}

/// Mean of a number and three standard errors of it.
class Sample
{
public:
  void Add(double value)
  {
    this->Sum += value;
    this->Squares += value * value;
  }
  double Mean() const { return this->Sum / Seeds; }
  double Bound() const { return 3.0 * std::sqrt((this->Squares / Seeds - this->Mean() * this->Mean()) / (Seeds - 1)); }

private:
  double Sum = 0.0;
  double Squares = 0.0;
};

/// The sum over ordered pairs nearer than r of a weight, in the unit square.
template <typename Weight>
double PairSum(const std::vector<PlanePosition>& points, double r, const Weight& weight)
{
  double sum = 0.0;
  for (std::size_t a = 0; a < points.size(); ++a)
  {
    for (std::size_t b = 0; b < points.size(); ++b)
    {
      const double dx = std::abs(points[a][0] - points[b][0]);
      const double dy = std::abs(points[a][1] - points[b][1]);
      if (a != b && dx * dx + dy * dy < r * r)
      {
        sum += weight(a, b) / ((1.0 - dx) * (1.0 - dy));
      }
    }
  }
  return sum;
}

}

// Species by point share clusters: K_12 = K. Species by cluster do not see each other, K_12 = pi r^2, and each has
// clusters of its own, of parents that are as many fewer: K_11 - pi r^2 = (K - pi r^2) / share.
TEST(ProcessKinds, SpeciesAttractOrIgnoreEachOtherAsTheClosedFormsSay)
{
  const std::vector<double> radii(std::begin(Radii), std::end(Radii));
  const std::vector<double> k = RipleyK(Clusters(), radii);
  for (const SpeciesGrouping grouping : { SpeciesGrouping::Points, SpeciesGrouping::Clusters })
  {
    std::vector<Sample> cross(radii.size());
    std::vector<Sample> own(radii.size());
    for (int seed = 1; seed <= Seeds; ++seed)
    {
      ProcessOptions options;
      options.Seed = seed;
      options.SpeciesShares = { 1.0, 3.0 };
      options.Grouping = grouping;
      const ProcessPattern pattern = SimulateProcess(Clusters(), options, ObservationWindow());
      for (std::size_t n = 0; n < radii.size(); ++n)
      {
        cross[n].Add(PairSum(pattern.Points, radii[n], [&](std::size_t a, std::size_t b) {
          return pattern.Species[a] == 0 && pattern.Species[b] == 1 ? 1.0 : 0.0;
        }));
        own[n].Add(PairSum(pattern.Points, radii[n], [&](std::size_t a, std::size_t b) {
          return pattern.Species[a] == 0 && pattern.Species[b] == 0 ? 1.0 : 0.0;
        }));
      }
    }
    const bool isShared = grouping == SpeciesGrouping::Points;
    for (std::size_t n = 0; n < radii.size(); ++n)
    {
      const double random = Pi * radii[n] * radii[n];
      EXPECT_NEAR(cross[n].Mean(), 25.0 * 75.0 * (isShared ? k[n] : random), cross[n].Bound()) << radii[n];
      EXPECT_NEAR(own[n].Mean(), 25.0 * 25.0 * (isShared ? k[n] : random + (k[n] - random) / 0.25), own[n].Bound())
        << radii[n];
    }
  }
}

// Marks that share a part q of the variance s^2 of their logarithm within clusters: the mean product of the marks of a
// pair is exp(q s^2) in a cluster and 1 otherwise, so that sums of products have K + (exp(q s^2) - 1) (K - pi r^2).
TEST(ProcessKinds, MarksCorrelateAsTheClosedFormSays)
{
  const std::vector<double> radii(std::begin(Radii), std::end(Radii));
  const std::vector<double> k = RipleyK(Clusters(), radii);
  MarkOptions marking;
  marking.Variation = 0.8;
  for (const double sharing : { 0.0, 0.6 })
  {
    marking.ClusterCorrelation = sharing;
    std::vector<Sample> products(radii.size());
    for (int seed = 1; seed <= Seeds; ++seed)
    {
      ProcessOptions options;
      options.Seed = marking.Seed = seed;
      const ProcessPattern pattern = SimulateProcess(Clusters(), options, ObservationWindow());
      const std::vector<double> marks = DrawMarks(pattern, marking);
      for (std::size_t n = 0; n < radii.size(); ++n)
      {
        products[n].Add(
          PairSum(pattern.Points, radii[n], [&](std::size_t a, std::size_t b) { return marks[a] * marks[b]; }));
      }
    }
    const double common = std::exp(sharing * std::log1p(0.64)) - 1.0;
    for (std::size_t n = 0; n < radii.size(); ++n)
    {
      const double wanted = 1e4 * (k[n] + common * (k[n] - Pi * radii[n] * radii[n]));
      EXPECT_NEAR(products[n].Mean(), wanted, products[n].Bound()) << radii[n];
      EXPECT_LT(products[n].Bound(), 0.15 * wanted);
    }
  }
}
