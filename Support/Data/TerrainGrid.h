// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportTerrainGrid_h
#define LittoralSupportTerrainGrid_h

// A terrain as the numerics see it. Private: never installed, never wrapped.

#include "Geometry/HeightGrid.h"

#include <string>

class vtkImageData;

namespace littoral
{

/// The heights of an image: point array Elevation or the active scalars [m]. The grid refers to the image. False, with
/// the reason, if it is no terrain.
bool MakeGrid(vtkImageData* terrain, HeightGrid& grid, std::string& reason);

}

#endif
