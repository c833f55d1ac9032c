// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralWindowSections_h
#define LittoralWindowSections_h

#include "Numerics/Parallel.h"
#include "Patterns/ObservationWindow.h"

#include <cstddef>
#include <vector>

namespace littoral
{

/// Section of a window along the line of an ordinate y [m]: abscissas of its begins and ends in turn, increasing [m].
std::vector<double> SectionAt(const ObservationWindow& window, double y);

/// Area of the intersection of a window and the window moved by (dx, dy) [m], |W and W + h| [m2], by a thousand
/// sections.
double CommonAreaOfRows(const ObservationWindow& window, double dx, double dy);

/**
 * The common areas of a window and of moved ones for all moves up to a distance [m]: exact for a rectangle, else
 * between the nodes of a grid, whose spacing is a 128th of the distance.
 */
class CommonAreaTable
{
public:
  CommonAreaTable(const ObservationWindow& window, double maximumDistance, const ParallelFor& parallel = SerialFor);

  double operator()(double dx, double dy) const;

  double GetMaximumDistance() const { return this->MaximumDistance; } ///< distance [m]

private:
  ObservationWindow Window;
  double MaximumDistance = 0.0;
  std::size_t Columns = 0; ///< nodes along x, from -MaximumDistance
  double Across = 0.0;     ///< spacing of the nodes along x [m]
  double Along = 0.0;      ///< spacing along y, from 0 [m]
  std::vector<double> Areas;
};

}

#endif
