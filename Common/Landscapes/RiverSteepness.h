// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralRiverSteepness_h
#define LittoralRiverSteepness_h

#include "Drainage/ChannelGrading.h"
#include "Numerics/Parallel.h"
#include "Terrain/GridSamples.h"

namespace littoral
{

/// Slopes of the rivers of a place by drainage area, on filled ground: the law S = k A^-theta through its bins.
class RiverSteepness
{
public:
  /// Rivers of a place without missing heights. Water leaves at its border.
  explicit RiverSteepness(const GridSamples& place, const ParallelFor& parallel = SerialFor, const Poll& poll = NoPoll);

  /// Whether the place is large enough to tell a law: 5000 cells and more flow together.
  bool IsKnown() const;

  /// The law, times a factor, of channels of 300 cells and more; without channels where none is known.
  ChannelLaw Law(double factor) const;

  /// Geometric mean over the bins of area of a ground that drains, up to the areas of the place, of its slope over the
  /// law; 1 where no law is known or the ground is too small.
  double RatioOf(const GridSamples& ground, const ParallelFor& parallel = SerialFor, const Poll& poll = NoPoll) const;

private:
  ChannelLaw OfPlace;
  double MaximumArea;
};

}

#endif
