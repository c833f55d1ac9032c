// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralFieldAtData_h
#define LittoralFieldAtData_h

#include "Kriging/KrigingModel.h"
#include "Numerics/Parallel.h"
#include "Terrain/TurningBands.h"

#include <vector>

namespace littoral
{

/// Place of a point of a grid [m], rounded as everywhere, so that data on grid points are honoured there.
inline KrigingPlace PlaceOfPoint(const PlaneGrid& grid, int column, int row)
{
  return { grid.Origin[0] + column * grid.Spacing[0], grid.Origin[1] + row * grid.Spacing[1], 0.0 };
}

/// Moves places that are within a millionth of a spacing of a point of the grid onto it.
void SnapToGrid(const PlaneGrid& grid, std::vector<KrigingPlace>& places);

/**
 * Turning bands field at the data, whose lines are tabulated for a window. At a point of the grid in the window it is
 * the value there, to the byte. Elsewhere it is the long waves, and short waves by sequential Gaussian simulation,
 * given those at the points around and at data before in the list: normal with their simple kriging estimate and
 * variance. So field and data have the covariance of the model.
 *
 * Throws KrigingFailure where a place is more than 1e9 spacings from the grid's origin.
 */
std::vector<double> FieldAtData(const TurningBandsField& field, const TurningBandsParameters& parameters,
  const PlaneGrid& grid, const GridWindow& window, const std::vector<KrigingPlace>& places,
  const ParallelFor& parallel = SerialFor);

}

#endif
