// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportFollowers_h
#define LittoralSupportFollowers_h

// Points that move with another one. Private: never installed, never wrapped.

#include "vtkType.h"

#include <vector>

class vtkDataArray;
class vtkPointSet;

namespace littoral
{

/// Masters and offsets of slaves; empty where there are none.
struct Slaves
{
  std::vector<vtkIdType> Master; ///< of each point; negative: it is its own
  vtkDataArray* Offset = nullptr;
  const double* Offsets = nullptr;      ///< the same as numbers, where they lie in memory as such
  const float* SingleOffsets = nullptr; ///< the same in single precision

  /// One coordinate of an offset [m].
  double OffsetAt(vtkIdType id, int axis) const;
};

/// Reads the point arrays MasterId and Offset; there may be none. Throws InvalidInput.
Slaves ReadSlaves(vtkPointSet* input);

}

#endif
