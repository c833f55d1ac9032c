// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralEarthPlaces_h
#define LittoralEarthPlaces_h

// Places of a map around the middle of the earth, by PROJ behind GDAL. Private: never installed.

#include "Data/Georeference.h"
#include "Geometry/EarthFrame.h"

#include <cstddef>
#include <memory>
#include <string>

namespace littoral
{

/// Takes places of data [m] to the earth. Their heights are those above the ellipsoid of WGS 84 less an offset [m].
class EarthPlaces
{
public:
  /// Throws InvalidInput if the data have no projection.
  EarthPlaces(const Georeference& place, double heightOffset);
  ~EarthPlaces();

  /// Places around the middle of the earth in place of those of data. Throws InvalidInput where one is outside of the
  /// projection; it is counted from `first`.
  void Place(Vector3* places, std::size_t count, std::size_t first) const;

  /// The frame at a place of data whose x is that of the data.
  EarthFrame FrameAt(const Vector3& place) const;

private:
  class Projection;
  std::unique_ptr<Projection> Way;
  Georeference Own;
  double HeightOffset;

  EarthPlace OnEarth(const Vector3& place) const;
};

}

#endif
