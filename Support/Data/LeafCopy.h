// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportLeafCopy_h
#define LittoralSupportLeafCopy_h

// Copies of the leaves of an input, to which a filter gives other points. Private: never installed, never wrapped.

#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

#include <array>
#include <utility>

class vtkPolyData;

namespace littoral
{

/**
 * The shallow copy of a leaf, from frame to frame. One that nobody else holds any more, of a leaf with the same cells,
 * fields and names of arrays, takes over what has changed: of few points, a copy made anew takes longer than to move
 * them. It has the arrays of the leaf alone, whatever was added to it.
 */
class LeafCopy
{
public:
  /// The copy of a leaf of this frame, which is held here: VTK looks for cycles whenever a reference to data is given
  /// up.
  vtkDataObject* Of(vtkDataObject* leaf);

private:
  bool Follows(vtkPolyData* leaf);

  using Stamps = std::array<std::pair<const void*, vtkMTimeType>, 4>;

  static Stamps CellsOf(vtkPolyData* leaf);

  vtkSmartPointer<vtkDataObject> Copy;
  Stamps Cells{}; ///< of the leaf that it was made of: vertices, lines, polygons, strips
};

}

#endif
