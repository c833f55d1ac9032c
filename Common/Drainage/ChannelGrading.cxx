// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drainage/ChannelGrading.h"

#include "Numerics/PolledMemory.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

double ChannelLaw::SlopeAt(double cells) const
{
  const double area = std::max(cells, this->ChannelThreshold);
  const double slope = this->Steepness * std::pow(area / this->ReferenceCells, -this->Concavity);
  const double known = slope * std::min(1.0, this->MaximumCells / area);
  return cells < this->ChannelThreshold ? this->HillslopeFraction * known : known;
}

ChannelLaw EvenLaw(double slope)
{
  ChannelLaw law;
  law.Steepness = slope;
  law.Concavity = 0.0;
  law.HillslopeFraction = 1.0;
  return law;
}

std::vector<double> FallsAlong(const GridSamples& heights, const FlowRouting& routing,
  const std::vector<CellIndex>& accumulation, const ChannelLaw& law, const ParallelFor& parallel)
{
  const CellLattice lattice(heights);
  std::vector<double> falls(heights.Values.size());
  parallel(falls.size(), [&](std::size_t begin, std::size_t end) {
    const double onHillslopes = law.SlopeAt(1.0);
    for (std::size_t n = begin; n < end; ++n)
    {
      const auto cell = static_cast<CellIndex>(n);
      const int direction = lattice.DirectionTo(cell, routing.Receiver[cell]);
      const double cells = accumulation[cell];
      const double slope = cells < law.ChannelThreshold ? onHillslopes : law.SlopeAt(cells);
      falls[n] = direction < 0 ? 0.0 : slope * lattice.Distance(direction);
    }
  });
  return falls;
}

std::vector<double> GradeAlong(const GridSamples& heights, const FlowRouting& routing,
  const std::vector<CellIndex>& accumulation, const ChannelLaw& law, double cut, const ParallelFor& parallel,
  const Poll& poll)
{
  return GradeBy(FallsAlong(heights, routing, accumulation, law, parallel), heights, routing, cut, parallel, poll);
}

std::vector<double> GradeBy(const std::vector<double>& falls, const GridSamples& heights, const FlowRouting& routing,
  double cut, const ParallelFor& parallel, const Poll& poll)
{
  SteppedPoll stepped(poll);
  std::vector<double> lowered = CopyOf(heights.Values, poll);
  std::vector<double> graded = CopyOf(heights.Values, poll);
  // Both ways side by side: neither waits for the memory of the other.
  for (std::size_t n = 0; n < routing.Order.size(); ++n)
  {
    stepped.Step();
    // z_r = min(z_r, z - S d), from the divides downstream
    const CellIndex down = routing.Order[routing.Order.size() - 1 - n];
    const CellIndex below = routing.Receiver[down];
    if (below != down)
    {
      lowered[below] = std::min(lowered[below], lowered[down] - falls[down]);
    }
    // z = max(z, z_r + S d), from the outlets upstream
    const CellIndex up = routing.Order[n];
    const CellIndex receiver = routing.Receiver[up];
    if (receiver != up)
    {
      graded[up] = std::max(graded[up], graded[receiver] + falls[up]);
    }
  }
  parallel(graded.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      graded[n] += cut * (lowered[n] - graded[n]);
    }
  });
  return graded;
}

std::vector<double> LimitAlong(const GridSamples& heights, const FlowRouting& routing,
  const std::vector<CellIndex>& accumulation, const ChannelLaw& law, double leastSlope, const Poll& poll)
{
  SteppedPoll stepped(poll);
  const CellLattice lattice(heights);
  std::vector<double> limited = CopyOf(heights.Values, poll);
  for (const CellIndex cell : routing.Order)
  {
    stepped.Step();
    const CellIndex receiver = routing.Receiver[cell];
    const double cells = accumulation[cell];
    if (receiver != cell && cells >= law.ChannelThreshold)
    {
      const double most = std::max(law.SlopeAt(cells), leastSlope);
      const double distance = lattice.Distance(lattice.DirectionTo(cell, receiver));
      limited[cell] = std::min(limited[cell], limited[receiver] + most * distance);
    }
  }
  return limited;
}

}
