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

/// Why the arrays Reflectance and DrainageArea of a raster cannot color its ground; empty if they can, or are not
/// there.
std::string WhyUncolorable(vtkImageData* image, const std::string& owner);

/// The wetness index of a raster of one layer with the array DrainageArea [m2] (Drainage/GroundWetness.h); empty
/// without that array.
std::vector<double> SpreadWetness(vtkImageData* image, vtkDataArray* heights, const ParallelFor& parallel = SerialFor);

}

#endif
