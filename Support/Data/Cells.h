// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportCells_h
#define LittoralSupportCells_h

// Cells whose points are there. Private: never installed, never wrapped.

#include <string>

class vtkDataSet;

namespace littoral
{

/// Throws InvalidInput if cells of polygonal data or of an unstructured grid cannot be read: one names a point that
/// there is not. Cells of other data have no ids.
void RequireCells(vtkDataSet* data, const std::string& owner);

}

#endif
