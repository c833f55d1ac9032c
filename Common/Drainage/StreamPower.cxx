// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drainage/StreamPower.h"

#include "Drainage/CellLattice.h"
#include "Numerics/ParameterCheck.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

/**
 * The height x above the receiver after a step, x + F x^n = start with F = K A^m dt / d^n: it grows and bends upward or
 * downward all the way, so that Newton's steps from a side end at its only root.
 */
double HeightAfter(double start, double factor, double exponent)
{
  if (start <= 0.0)
  {
    return start;
  }
  if (exponent == 1.0)
  {
    return start / (1.0 + factor);
  }
  double low = 0.0;
  double high = start;
  double x = std::min(start, std::pow(start / std::max(factor, 1e-300), 1.0 / exponent));
  for (int step = 0; step < 100 && high - low > 1e-15 * start; ++step)
  {
    const double power = factor * std::pow(x, exponent);
    const double value = x + power - start;
    (value > 0.0 ? high : low) = x;
    const double next = x - value / (1.0 + exponent * power / x);
    // a step that leaves the bracket halves it
    const double to = next > low && next < high ? next : 0.5 * (low + high);
    if (to == x)
    {
      break;
    }
    x = to;
  }
  return x;
}

}

std::string WhyInvalid(const StreamPowerLaw& law)
{
  ParameterCheck check;
  check.Positive("Erodibility", law.Erodibility);
  check.Range("AreaExponent", law.AreaExponent, 0.0, 2.0);
  check.Range("SlopeExponent", law.SlopeExponent, 0.2, 5.0);
  check.NotNegative("Uplift", law.Uplift, "m/a");
  check.NotNegative("MinimumArea", law.MinimumArea, "m^2");
  return check.Reason();
}

void StepStreamPower(GridSamples& heights, const FlowRouting& routing, const std::vector<double>& area,
  const StreamPowerLaw& law, double time)
{
  const CellLattice lattice(heights);
  for (const CellIndex cell : routing.Order)
  {
    const CellIndex receiver = routing.Receiver[cell];
    if (receiver == cell)
    {
      continue;
    }
    double& height = heights.Values[cell];
    height += law.Uplift * time;
    if (area[cell] >= law.MinimumArea)
    {
      const double distance = lattice.Distance(lattice.DirectionTo(cell, receiver));
      const double factor =
        law.Erodibility * std::pow(area[cell], law.AreaExponent) * time / std::pow(distance, law.SlopeExponent);
      const double bed = heights.Values[receiver];
      height = bed + HeightAfter(height - bed, factor, law.SlopeExponent);
    }
  }
}

}
