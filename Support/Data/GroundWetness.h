// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportGroundWetness_h
#define LittoralSupportGroundWetness_h

// Wetness of the ground of a raster. Private: never installed, never wrapped.

#include "Numerics/Parallel.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkImageData;

namespace littoral
{

/// Throws InvalidInput if the arrays Reflectance and DrainageArea of a raster, which may be absent, cannot color its
/// ground.
void RequireColorable(vtkImageData* image, const std::string& owner);

/// The wetness index of a raster of one layer with the array DrainageArea [m2] (Drainage/GroundWetness.h); empty
/// without that array.
std::vector<double> SpreadWetness(vtkImageData* image, vtkDataArray* heights, const ParallelFor& parallel = SerialFor);

}

#endif
