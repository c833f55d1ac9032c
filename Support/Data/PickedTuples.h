// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportPickedTuples_h
#define LittoralSupportPickedTuples_h

// Some of the points of an input with all their arrays. Private: never installed, never wrapped.

#include "vtkType.h"

#include <vector>

class vtkDataSetAttributes;

namespace littoral
{

/// Fills attributes, empty until then, with the tuples of other ones at some places, in their order, on all threads.
void PickTuples(vtkDataSetAttributes* from, const std::vector<vtkIdType>& places, vtkDataSetAttributes* to);

}

#endif
