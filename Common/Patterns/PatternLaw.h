// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPatternLaw_h
#define LittoralPatternLaw_h

#include "Numerics/Parallel.h"
#include "Patterns/IntensityRaster.h"
#include "Patterns/ObservationWindow.h"
#include "Patterns/PointProcess.h"
#include "Patterns/QuadratLaws.h"
#include "Patterns/QuadratPattern.h"

#include <string>
#include <vector>

namespace littoral
{

/// A law that patterns are drawn from: a point process, or a law of counts in quadrats.
struct PatternLaw
{
  bool IsProcess = true;
  PointProcessParameters Process;
  IntensityRaster Trend;       ///< trend of the process; without values: none
  QuadratLawParameters Counts; ///< law of counts
  QuadratGrid Grid;            ///< quadrats of that law
};

/// Why no pattern of the law can be drawn in the window, in words for a user; empty when one can.
std::string WhyInvalid(const PatternLaw& law, const ObservationWindow& window);

/// Mean number of draws of a pattern, for a check of memory.
double ExpectedDraws(const PatternLaw& law, const ObservationWindow& window);

/// The points of a pattern of the law that lie in the window; counts in quadrats are sampled.
std::vector<PlanePosition> DrawPattern(
  const PatternLaw& law, const ObservationWindow& window, int seed, const ParallelFor& parallel = SerialFor);

}

#endif
