// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportGivenLines_h
#define LittoralSupportGivenLines_h

// Rivers, ridges and heights that are given for a landscape. Private: never installed, never wrapped.

#include "Landscapes/GivenGround.h"

class vtkImageData;
class vtkPolyData;

namespace littoral
{

/**
 * Lines and points with places from the first point of an image. Lines are rivers, or ridges where the cell array Ridge
 * is there and not 0. Points that no line has are heights: the point array of the name `heights` where it is there,
 * else z; those of lines are taken only if `usesLineHeights`. Throws InvalidInput: polygons, nothing at all, cells
 * whose points are not there, arrays of another form.
 */
GivenGround ReadGiven(vtkPolyData* data, vtkImageData* image, const char* heights, bool usesLineHeights);

/// Memory that points and lines take in growth, by the copies of each place and height [bytes].
double MemoryOfGiven(vtkPolyData* data);

}

#endif
