// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportQuadratTable_h
#define LittoralSupportQuadratTable_h

// Tables of quadrat fits. Private: never installed, never wrapped.

#include "Patterns/QuadratLaws.h"
#include "Patterns/QuadratPattern.h"

#include <string>

class vtkTable;

namespace littoral
{

/// The law of the first row of a table of fits, and the grid of its analysis; what the table does not have stays as it
/// is. Throws InvalidInput.
void ReadQuadratFit(vtkTable* table, QuadratLawParameters& law, QuadratGrid& grid);

}

#endif
