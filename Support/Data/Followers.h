// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportFollowers_h
#define LittoralSupportFollowers_h

// Points that move with another one. Private: never installed, never wrapped.

#include "vtkType.h"

#include <string>
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
};

/// Reads the point arrays MasterId and Offset. Why they cannot be read, in words for a user; empty when they were, or
/// when there are none.
std::string ReadSlaves(vtkPointSet* input, Slaves& slaves);

}

#endif
