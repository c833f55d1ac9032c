// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralStreamLikeness_h
#define LittoralStreamLikeness_h

#include "Drainage/GroundMeasures.h"
#include "Drainage/StreamRelief.h"
#include "Numerics/Parallel.h"
#include "Terrain/GridSamples.h"

#include <vector>

namespace littoral
{

/// Statistics that a few valleys decide on small ground, where water leaves at the border.
struct StreamMeasures
{
  GroundMeasures Heights;                ///< of the ground as it is
  GroundMeasures Filled;                 ///< of filled ground
  double Density = 0.0;                  ///< of channels on filled ground [1/m]; NaN without a break of slopes
  double Hack = 0.0;                     ///< exponent of Hack's law; NaN without a stream
  double Trunks = 0.0;                   ///< TrunkValleyLength() of filled ground
  std::vector<StreamDistanceBin> Relief; ///< heights above streams, 1 to 10 cells off them
};

/// Measures of ground without missing heights. Relief is off streams of so many cells and more.
StreamMeasures MeasureStreams(
  const GridSamples& ground, CellIndex streamCells, const ParallelFor& parallel = SerialFor, const Poll& poll = NoPoll);

/**
 * Distances of the measures of a ground from those of a place, each over its tolerance: 0.1 of concavity, 0.05 of
 * Hack's exponent, 0.03 of the hypsometric integral, 0.15 of the skewness of heights, and over those of the place 0.15
 * of steepness, 0.2 of drainage density and of relief off streams and 0.25 of trunk valleys, or 0.1; and the share of
 * sunk cells over the place's, or over 0.05. What the place does not tell is left out; what the ground lacks is
 * infinite.
 */
std::vector<double> StreamMisfits(const StreamMeasures& ground, const StreamMeasures& place);

/// Sum of m^2 / (1 + m^2): a misfit counts as one at most, so that none hopeless decides.
double SumOfMisfits(const std::vector<double>& misfits);

}

#endif
