// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSkyTables_h
#define LittoralSkyTables_h

#include "Light/Atmosphere.h"
#include "Numerics/Parallel.h"
#include "Numerics/Vector3.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace littoral
{

/// Colors in rows.
struct ColorTable
{
  int Columns = 0;
  int Rows = 0;
  std::vector<Vector3> Colors;

  Vector3& At(int column, int row) { return this->Colors[static_cast<std::size_t>(row) * this->Columns + column]; }
  /// Linear between the colors, at 0 to 1 from the first to the last.
  Vector3 Between(double x, double y) const;
};

/**
 * The sky under a sun as tables for a picture.
 *
 * Dome: luminance [kcd/m2] by the angle a from the sun's azimuth along a row, x = sqrt(a / pi), and by the elevation e
 * from nadir to zenith, densest at the horizon: 2 y - 1 = sign(e) sqrt(|e| / 90 degrees). The horizon is doubled, for
 * the sky above it and the earth below it.
 *
 * Light: light of the sky and of the earth, without the sun, on planes by their normals [klx], on the faces of an
 * octahedron unfolded to a square.
 */
struct SkyTables
{
  static constexpr int DomeColumns = 48;
  static constexpr int DomeRows = 128; ///< half of them above the horizon
  static constexpr int LightSize = 33;

  Vector3 Sun;      ///< towards it, of length 1
  Vector3 SunLight; ///< at right angles to it [klx]
  ColorTable Dome;
  ColorTable Light;

  Vector3 LuminanceAt(const Vector3& direction) const;
  Vector3 LightOn(const Vector3& normal) const;
};

SkyTables TabulateSky(const Atmosphere& air, const Vector3& sun, const ParallelFor& parallel = SerialFor);

/// Luminances in directions of one elevation [kcd/m2], as Atmosphere::SkyLuminances.
using SkyRow = std::function<std::vector<Vector3>(const std::vector<Vector3>& directions)>;

/// Tables of any sky that is the same on both sides of the sun.
SkyTables TabulateSky(
  const SkyRow& luminances, const Vector3& sun, const Vector3& sunLight, const ParallelFor& parallel = SerialFor);

}

#endif
