// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSpeciesDraw_h
#define LittoralSpeciesDraw_h

#include "Numerics/RandomStream.h"
#include "Patterns/ProcessPattern.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace littoral
{

/// Species of a point, by inversion of the cumulative shares.
class SpeciesDraw
{
public:
  explicit SpeciesDraw(const ProcessOptions& options)
    : Shares(options.SpeciesShares)
    , Random(options.Seed, RandomPurpose::ProcessSpecies)
  {
    std::partial_sum(this->Shares.begin(), this->Shares.end(), this->Shares.begin());
  }

  int operator()(const PointIdentity& identity) const
  {
    if (this->Shares.empty())
    {
      return 0;
    }
    const double u = this->Random.UniformPair(identity.Object, identity.Draw)[0] * this->Shares.back();
    return static_cast<int>(std::upper_bound(this->Shares.begin(), this->Shares.end(), u) - this->Shares.begin());
  }

private:
  std::vector<double> Shares; ///< cumulated
  RandomStream Random;
};

}

#endif
