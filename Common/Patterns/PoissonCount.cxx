// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/PoissonCount.h"

#include "Patterns/QuadratLaws.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace littoral
{

namespace
{

/// A mean whose first probability is a number of many digits, and whose search is short.
constexpr double MaximumMean = 16.0;

/// The smallest n with P(0) + ... + P(n) > u, P(n + 1) = P(n) mean / (n + 1).
int ShortCount(double mean, double u)
{
  double mass = std::exp(-mean);
  double sum = mass;
  int n = 0;
  while (sum <= u && mass > 0.0)
  {
    ++n;
    mass *= mean / n;
    sum += mass;
  }
  return n;
}

}

PoissonTable::PoissonTable(double mean)
{
  QuadratLawParameters law;
  law.Mean = mean;
  this->Cumulative = mean > 0.0 ? MassFunction(law) : std::vector<double>{ 1.0 };
  std::partial_sum(this->Cumulative.begin(), this->Cumulative.end(), this->Cumulative.begin());
  this->Cumulative.back() = std::numeric_limits<double>::infinity();
  std::size_t cells = 64;
  while (cells < 2 * this->Cumulative.size())
  {
    cells *= 2;
  }
  int n = 0;
  for (std::size_t cell = 0; cell < cells; ++cell)
  {
    while (this->Cumulative[static_cast<std::size_t>(n)] <= static_cast<double>(cell) / static_cast<double>(cells))
    {
      ++n;
    }
    this->Guide.push_back(n);
  }
}

long long PoissonCount(double mean, const RandomStream& random, std::uint64_t object, std::uint64_t draw)
{
  const double parts = std::max(1.0, std::ceil(mean / MaximumMean));
  long long count = 0;
  for (std::uint64_t part = 0; part < static_cast<std::uint64_t>(parts); ++part)
  {
    count += ShortCount(mean / parts, random.UniformPair(object, draw + part)[0]);
  }
  return count;
}

}
