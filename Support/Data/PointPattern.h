// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportPointPattern_h
#define LittoralSupportPointPattern_h

// Mapped points, their window, and what kinds they are of. Private: never installed, never wrapped.

#include "Patterns/ObservationWindow.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkPointSet;
class vtkPolyData;

namespace littoral
{

/// x and y of all points.
std::vector<PlanePosition> PlanePositionsOf(vtkPointSet* points);

/// A number other than 0 that tells patterns and what is asked of them apart, by the bytes of points and properties.
std::uint64_t KeyOf(const std::vector<PlanePosition>& points, const std::vector<double>& properties);

// Each of these throws InvalidInput.

/// A rectangle by its lower left corner and its size [m]; 0 0 is the bounding box of the points.
ObservationWindow ReadWindow(vtkPointSet* points, const double origin[2], const double size[2]);

/// The one polygon or closed line of polygonal data, or its points in their order if it has no cell.
ObservationWindow ReadWindow(vtkPolyData* polygon);

/// Numbers of a point array, each above 0.
std::vector<double> ReadMarks(vtkPointSet* points, const std::string& name);

/// Values of a point array of texts or numbers, as texts.
std::vector<std::string> ReadSpecies(vtkPointSet* points, const std::string& name);

}

#endif
