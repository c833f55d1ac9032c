// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralOceanMap_h
#define LittoralOceanMap_h

#include "Geometry/EarthGrid.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace littoral
{

/// Velocities on the map [m/s] that 1 m/s eastwards and 1 m/s northwards have at a place.
struct MapAxes
{
  std::array<double, 2> East{ 1.0, 0.0 };
  std::array<double, 2> North{ 0.0, 1.0 };
};

/// Local metres: the stereographic projection of WGS 84 about an origin, by PROJ. It keeps angles, and lengths to
/// r^2/4R^2 at a distance r from the origin.
class OceanMap
{
public:
  /// Throws InvalidInput if PROJ cannot make it.
  explicit OceanMap(const EarthPlace& origin);
  ~OceanMap();
  OceanMap(OceanMap&&) noexcept;

  /// Places on the map [m].
  std::vector<std::array<double, 2>> Places(const std::vector<EarthPlace>& places) const;

  /// Axes of velocities at places.
  std::vector<MapAxes> Axes(const std::vector<EarthPlace>& places) const;

  /// The projection as WKT.
  const std::string& System() const;

private:
  class Internals;
  std::unique_ptr<Internals> Own;
};

}

#endif
