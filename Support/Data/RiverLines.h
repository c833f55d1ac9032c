// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportRiverLines_h
#define LittoralSupportRiverLines_h

// Rivers as lines on the ground. Private: never installed, never wrapped.

#include "Drainage/StreamNetwork.h"
#include "Terrain/GridSamples.h"

#include <vector>

class vtkImageData;
class vtkPolyData;

namespace littoral
{

/**
 * Polylines at the heights of the ground. Cell arrays: StreamOrder, DrainageArea [m^2] at the lower end, Length [m],
 * Slope [m/m]. Point arrays: DrainageArea [m^2], RGB. Rivers of low order come first, so that others are drawn on them.
 */
void WriteRivers(vtkImageData* place, const GridSamples& heights, const std::vector<CellIndex>& accumulation,
  const std::vector<River>& rivers, vtkPolyData* output, const Poll& poll = NoPoll);

}

#endif
