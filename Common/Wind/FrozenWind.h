// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralFrozenWind_h
#define LittoralFrozenWind_h

#include "Numerics/Parallel.h"
#include "Numerics/Vector3.h"
#include "Wind/WindLines.h"
#include "Wind/WindTimes.h"

#include <array>
#include <cstddef>

namespace littoral
{

/// Regular grid of a wind field: axis 0 along the mean wind, axis 1 across it, axis 2 up.
struct FrozenWindGrid
{
  std::array<int, 3> Size{ 4, 1, 1 }; ///< samples along each axis
  /// Rows of the affine map from positions [m] to indices: three factors and a shift each.
  std::array<std::array<double, 4>, 3> ToIndex{ { { 1.0, 0.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0, 0.0 },
    { 0.0, 0.0, 1.0, 0.0 } } };
  std::array<int, 3> FirstIndex{ 0, 0, 0 }; ///< index of the first sample along each axis
  double Bottom = 0.0;                      ///< height of the lowest layer [m]
  double LayerSpacing = 1.0;                ///< height between layers [m]
};

/**
 * Frozen turbulence (Taylor's hypothesis): a wind field that the mean wind carries along axis 0 by one sample a step,
 * and that repeats along it.
 */
class FrozenWind
{
public:
  /// Velocities [m/s] of the grid's samples, three numbers each, axis 0 fastest. Steps of `times` in a period are the
  /// samples along axis 0.
  FrozenWind(const FrozenWindGrid& grid, const WindTimes& times, const float* velocities,
    const ParallelFor& parallel = SerialFor);

  const WindTimes& GetTimes() const { return this->Times; }

  /// Whether a place [m] lies within the field across the wind and below its top. Below its lowest layer is within.
  bool Reaches(const Vector3& place) const;

  /// Velocities [m/s] at a place [m]: `count` values, one a step, from the step `first` on. Beyond the field's edges
  /// those at the edge.
  void Sample(const Vector3& place, double first, std::size_t count, Vector3* velocities) const;

  /// Wind over ground of a height [m]: heights in the field are heights above ground. Valid as long as this.
  WindAtPlace Over(double ground) const;

  /// Travel time [s] of a gust from the field's first samples to a place [m]: distance along the wind over the mean
  /// speed. Negative upwind.
  double Arrival(const Vector3& place) const;

private:
  FrozenWindGrid Grid;
  WindTimes Times;
  WindLines Lines;

  bool Locate(const Vector3& place, std::array<double, 3>& index) const;
};

}

#endif
