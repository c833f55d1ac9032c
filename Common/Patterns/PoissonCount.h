// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPoissonCount_h
#define LittoralPoissonCount_h

#include "Numerics/RandomStream.h"

#include <array>
#include <cstdint>
#include <vector>

namespace littoral
{

/// Poisson numbers of one mean, by inversion of the cumulative distribution function: one look-up in equal cells of (0,
/// 1) and a step or two.
class PoissonTable
{
public:
  /// Mean from 0 to 1e4.
  explicit PoissonTable(double mean);

  int operator()(double u) const
  {
    int n = this->Guide[static_cast<std::size_t>(u * static_cast<double>(this->Guide.size()))];
    while (this->Cumulative[static_cast<std::size_t>(n)] <= u)
    {
      ++n;
    }
    return n;
  }

private:
  std::vector<double> Cumulative;
  std::vector<int> Guide;
};

/// Poisson number of any mean, by the draws of an object from `draw` on: the sum of numbers of a mean of at most 16.
long long PoissonCount(double mean, const RandomStream& random, std::uint64_t object, std::uint64_t draw);

}

#endif
