// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportProcessTable_h
#define LittoralSupportProcessTable_h

// Point processes in tables of fits, and their intensities in images. Private: never installed, never wrapped.

#include "Patterns/IntensityRaster.h"
#include "Patterns/ObservationWindow.h"
#include "Patterns/PointProcess.h"

#include <string>

class vtkDataArray;
class vtkImageData;
class vtkTable;

namespace littoral
{

/// Whether the first row of a table of fits is a process.
bool FirstRowIsProcess(vtkTable* table);

/// The process of the first row of a table of fits that has one, the window of its pattern, and its trend, without
/// values if it has none; what the table does not have stays as it is. Throws InvalidInput.
void ReadProcessFit(
  vtkTable* table, PointProcessParameters& process, ObservationWindow& window, IntensityRaster& trend);

/// An array of an image as an intensity. Throws InvalidInput.
void ReadIntensity(vtkImageData* image, vtkDataArray* values, IntensityRaster& raster);

}

#endif
