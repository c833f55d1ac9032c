// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralInflowImage_h
#define LittoralInflowImage_h

#include "Wind/InflowPlanes.h"

#include <array>

class vtkImageData;

namespace littoral
{

/**
 * Place of the planes of an inflow in images: the plane of the last time is the first along the wind, as the wind
 * carries the image: what is upwind comes later.
 */
struct InflowPlacing
{
  std::array<double, 2> Center{ 0.0, 0.0 };    ///< of the plane that passes at its time [m]
  std::array<double, 2> Direction{ 1.0, 0.0 }; ///< cosine and sine of the direction of the wind from x

  /// Sets the place of an image of the grid, or of the tower below it.
  void Place(const InflowGrid& grid, bool isTower, double origin[3], double spacing[3], double turn[9]) const;
};

/// Extent of the image of a grid, or of the tower below it; empty if it has none.
std::array<int, 6> ExtentOf(const InflowGrid& grid, bool isTower);

/// Wishes of a writer that its image does not tell.
struct InflowChoices
{
  double HubHeight = 0.0; ///< [m]; 0: that of the wind
  int TowerLayers = 0;    ///< lowest layers of which the middle points become those of the tower
};

/// The grid of a wind of an extent, of which a part is here. Throws InvalidInput.
InflowGrid ReadInflowGrid(vtkImageData* image, const int whole[6], const InflowChoices& choices);

/// Copies planes of `count` times from the first on from an image that holds them. Throws InvalidInput.
void CopyPlanes(
  vtkImageData* image, const int whole[6], const InflowGrid& grid, int first, int count, float* velocities);

}

#endif
