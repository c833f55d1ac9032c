// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Landscapes/RiverSteepness.h"

#include "Drainage/DepressionFilling.h"
#include "Drainage/DrainageOutlets.h"
#include "Drainage/GroundMeasures.h"
#include "Drainage/LeastSquaresLine.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace littoral
{

namespace
{

/// Least drainage area of rivers [cells], that of the first bin.
constexpr double LeastCells = 100.0;

/// Least drainage area of rivers that are cut to the law [cells]. Small ones are the place's own.
constexpr double LeastCellsToCut = 300.0;

/// Largest area of the bins over the least one from which on they tell a law, and not a few valleys.
constexpr double LeastSpan = 50.0;

}

RiverSteepness::RiverSteepness(const GridSamples& place, const ParallelFor& parallel, const Poll& poll)
{
  const OutletMask border = BorderOutlets(place.Width, place.Height);
  GridSamples filled = place;
  filled.Values = FloodDepressions(place, border, poll).SpillElevation;
  const GroundMeasures measures = MeasureGround(filled, border, parallel, poll);
  std::vector<double> areas;
  std::vector<double> slopes;
  for (const SlopeAreaBin& bin : measures.SlopeArea)
  {
    areas.push_back(std::log(bin.Cells / LeastCells));
    slopes.push_back(std::log(bin.Slope));
  }
  const double span = measures.MaximumArea / (LeastCells * place.Spacing[0] * place.Spacing[1]);
  const bool isKnown = span >= LeastSpan && !std::isnan(measures.Concavity);
  this->MaximumArea = measures.MaximumArea;
  this->OfPlace.ReferenceCells = LeastCells;
  this->OfPlace.ChannelThreshold = isKnown ? LeastCells : std::numeric_limits<double>::infinity();
  this->OfPlace.Concavity = isKnown ? measures.Concavity : 0.0;
  this->OfPlace.Steepness = isKnown ? std::exp(LineThrough(areas, slopes).Intercept) : 0.0;
}

bool RiverSteepness::IsKnown() const
{
  return std::isfinite(this->OfPlace.ChannelThreshold);
}

ChannelLaw RiverSteepness::Law(double factor) const
{
  ChannelLaw law = this->OfPlace;
  law.Steepness *= factor;
  law.ChannelThreshold = std::max(law.ChannelThreshold, LeastCellsToCut);
  return law;
}

double RiverSteepness::RatioOf(const GridSamples& ground, const ParallelFor& parallel, const Poll& poll) const
{
  if (!this->IsKnown())
  {
    return 1.0;
  }
  const OutletMask border = BorderOutlets(ground.Width, ground.Height);
  const std::vector<SlopeAreaBin> bins = SlopeAreaOf(ground, border, parallel, this->MaximumArea, poll);
  double sum = 0.0;
  for (const SlopeAreaBin& bin : bins)
  {
    sum += std::log(bin.Slope / this->OfPlace.SlopeAt(bin.Cells));
  }
  return bins.empty() ? 1.0 : std::exp(sum / static_cast<double>(bins.size()));
}

}
