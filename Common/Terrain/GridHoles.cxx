// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Terrain/GridHoles.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

void TakeHoles(const GridSamples& from, GridSamples& samples, const Poll& poll)
{
  ForPolled(samples.Values.size(), poll, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      samples.Values[n] = std::isnan(from.Values[n]) ? from.Values[n] : samples.Values[n];
    }
  });
}

std::string WhyTooSmall(const GridSamples& samples, const std::string& name)
{
  constexpr int least = 16;
  return std::min(samples.Width, samples.Height) >= least
    ? ""
    : name + " has fewer than 16 rows or columns; no landscape can be made of it.";
}

}
