// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportTerrainHeights_h
#define LittoralSupportTerrainHeights_h

// Heights of a raster for the numerics of drainage. Private: never installed, never wrapped.

#include "Drainage/DrainageOutlets.h"
#include "Terrain/GridSamples.h"

#include <string>

class vtkDataArray;
class vtkImageData;
class vtkInformation;

namespace littoral
{

/// How many bytes a cell takes at most, and what for: "measuring a terrain".
struct CellMemory
{
  double Bytes;
  const char* Task;
};

/// Why a raster is too large for the memory that is free: cells, GiB, and what to do. Empty if it is not.
std::string WhyTooLarge(vtkImageData* image, const CellMemory& memory);

/**
 * The heights [m] of an array of an image of one layer, as double numbers. Else false with the reason, unless there is
 * one already: no raster, no scalar point array, too little memory. `array` is what the filter's choice found, null if
 * nothing; `choice` tells its name; `input` is the name of the port in the panel.
 */
bool ReadHeights(vtkImageData* image, vtkDataArray* array, vtkInformation* choice, const char* input,
  const CellMemory& memory, GridSamples& heights, std::string& reason);

/// Why heights that are not all the same are needed: "The terrain is constant." Empty if they differ.
std::string WhyConstant(const GridSamples& heights, const char* input);

}

#endif
