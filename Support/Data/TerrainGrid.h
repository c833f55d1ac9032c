// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportTerrainGrid_h
#define LittoralSupportTerrainGrid_h

// A terrain as the numerics see it. Private: never installed, never wrapped.

#include "Geometry/HeightGrid.h"

class vtkImageData;

namespace littoral
{

/// The heights of an image: point array Elevation or the active scalars [m]. The grid refers to the image. Throws
/// InvalidInput if it is no terrain.
HeightGrid MakeGrid(vtkImageData* terrain);

}

#endif
