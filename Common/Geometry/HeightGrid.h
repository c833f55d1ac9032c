// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralHeightGrid_h
#define LittoralHeightGrid_h

#include <functional>

namespace littoral
{

/// A place on a terrain.
struct GroundPoint
{
  bool IsCovered = false;            ///< the grid reaches there
  double Height = 0.0;               ///< [m]
  double Slope = 0.0;                ///< steepest [radians]
  double Gradient[2] = { 0.0, 0.0 }; ///< of the height along x and y
};

/// Heights at the points of a regular grid, bilinear between them.
struct HeightGrid
{
  double Origin[2] = { 0.0, 0.0 };
  double Spacing[2] = { 1.0, 1.0 };          ///< positive
  int Count[2] = { 0, 0 };                   ///< points along x and y, at least 2 each
  std::function<double(long long)> HeightOf; ///< of a point, counted along x first

  GroundPoint At(double x, double y) const;

  /// The point of the grid that is nearest to a place, which must be covered.
  long long Nearest(double x, double y) const;
};

}

#endif
