// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportCells_h
#define LittoralSupportCells_h

// Cells whose points are there. Private: never installed, never wrapped.

#include <string>

class vtkDataSet;

namespace littoral
{

/// Why cells of polygonal data or of an unstructured grid cannot be read: one names a point that there is not. Empty if
/// they can; cells of other data have no ids.
std::string WhyBadCells(vtkDataSet* data, const std::string& owner);

}

#endif
