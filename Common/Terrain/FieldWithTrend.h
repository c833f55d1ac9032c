// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralFieldWithTrend_h
#define LittoralFieldWithTrend_h

#include "Numerics/Parallel.h"
#include "Terrain/TurningBands.h"

#include <array>
#include <cstddef>

namespace littoral
{

/// A plane that is added to a field.
struct FieldTrend
{
  double Mean = 0.0;                       ///< at the center of the whole grid [unit of the field]
  std::array<double, 2> Slope{ 0.0, 0.0 }; ///< along x and y [unit of the field per m]
  /// [m], rectangle about the center over which mean and slope are all the trend there is, at least the whole grid: the
  /// field's own plane is taken out. 0 0: it stays.
  std::array<double, 2> Sides{ 0.0, 0.0 };
};

/**
 * A turning bands field with a trend, at the points of a window of a grid. A window holds the same bytes whether it is
 * computed by itself or as part of a larger one of the same whole grid.
 *
 * Use: construct, Tabulate, then Fill.
 */
class FieldWithTrend
{
public:
  FieldWithTrend(const TurningBandsParameters& parameters, const FieldTrend& trend, const PlaneGrid& grid,
    const GridWindow& whole, const GridWindow& window);

  /// Computes the tables of all lines, and the plane that is added.
  void Tabulate(const ParallelFor& parallel = SerialFor);

  /// Sets the values at all points of the window, x fastest.
  void Fill(float* values, const ParallelFor& parallel = SerialFor) const;

private:
  void FillRows(std::size_t begin, std::size_t end, float* values) const;

  FieldTrend Trend; ///< less the field's own plane, once tabulated
  PlaneGrid Grid;
  GridWindow Window;
  std::array<double, 2> Middle; ///< middle of the whole grid, in columns and rows
  TurningBandsField Field;
};

}

#endif
