// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralBoxCells_h
#define LittoralBoxCells_h

#include "Geometry/ViewFrustum.h"

#include <vector>

namespace littoral
{

/**
 * Search for the boxes that may hold a place: a regular grid of cells over all of them, with a list of boxes for each
 * cell. Cells are half as wide as the mean box, at most 32 along an axis, so that a few large boxes among small ones
 * need little memory.
 */
class BoxCells
{
public:
  /// Numbers of boxes, in rising order.
  struct List
  {
    const int* Begin = nullptr;
    const int* End = nullptr;

    const int* begin() const { return this->Begin; }
    const int* end() const { return this->End; }
  };

  BoxCells() = default;
  explicit BoxCells(const std::vector<Box>& boxes);

  /// All boxes that hold a place, and maybe others; none for a place that is not finite.
  List Near(const Vector3& place) const;

private:
  int CellAlong(int axis, double position) const;

  Box Bounds;
  int Count[3] = { 0, 0, 0 };
  Vector3 CellsAMetre{ 0.0 };
  std::vector<int> First; ///< of each cell in Boxes, and the end of the last
  std::vector<int> Boxes;
};

}

#endif
