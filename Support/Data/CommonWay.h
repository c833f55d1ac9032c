// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportCommonWay_h
#define LittoralSupportCommonWay_h

// Points that all have gone the same way, known without a look at them. Private: never installed, never wrapped.

#include "Numerics/Vector3.h"

#include <optional>

class vtkDataArray;
class vtkDataObject;

namespace littoral
{

/// Keeps with places that they are those of another array, moved by a way as ShiftTriples() does it [m].
void KeepCommonWay(vtkDataArray* places, vtkDataArray* start, const Vector3& way);

/// Throws InvalidInput where points have a way that they have yet to go, as those of vtkCurrentDriftFilter with
/// WayAsField.
void RequireInPlace(vtkDataObject* points);

/// The way of places from those of another array, where it was kept with them and neither has been modified since [m].
std::optional<Vector3> CommonWayOf(vtkDataArray* places, vtkDataArray* start);

}

#endif
