// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportTerrainHeights_h
#define LittoralSupportTerrainHeights_h

// Heights of a raster for the numerics of drainage. Private: never installed, never wrapped.

#include "Drainage/DrainageOutlets.h"
#include "Terrain/GridSamples.h"

class vtkDataArray;
class vtkImageData;
class vtkInformation;

namespace littoral
{

/// Memory of a cell at most [bytes], and the work for which it is taken: "measuring a terrain".
struct CellMemory
{
  double Bytes;
  const char* Task;
};

/**
 * The heights [m] of an array of an image of one layer, as double numbers; NaN where there is none. Throws
 * InvalidInput: no raster, no scalar point array, too little memory. `array` is what the filter's choice found, null if
 * nothing; `choice` tells its name; `input` is the name of the port in the panel.
 */
GridSamples ReadHeights(vtkImageData* image, vtkDataArray* array, vtkInformation* choice, const char* input,
  const CellMemory& memory, const Poll& poll = NoPoll);

/// The array of heights of an image, or of a part of one, that ReadHeights() would read: the chosen one, or the active
/// scalars for an absent Elevation.
vtkDataArray* FindHeights(vtkImageData* image, vtkDataArray* array, vtkInformation* choice, const char* input);

/// Throws InvalidInput if heights are all the same: "The terrain is constant."
void RequireRelief(const GridSamples& heights, const char* input);

}

#endif
