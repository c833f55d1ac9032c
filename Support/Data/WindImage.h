// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportWindImage_h
#define LittoralSupportWindImage_h

// Wind fields between VTK and the numerics. Private: never installed, never wrapped.

#include "Wind/FrozenWind.h"

#include <memory>
#include <string>

class vtkImageData;

namespace littoral
{

/// Reads a frozen wind: point array Velocity, field data ConvectionSpeed and, if there is one, Period. Why it cannot be
/// read, in words for a user; empty when it was.
std::string ReadWind(vtkImageData* image, std::shared_ptr<const FrozenWind>& wind);

/// A place at a height [m], halfway between the sides of a wind field.
Vector3 MiddleOfWind(vtkImageData* image, double height);

}

#endif
