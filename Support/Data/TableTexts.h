// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportTableTexts_h
#define LittoralSupportTableTexts_h

// Tables of words and numbers as words. Private: never installed, never wrapped.

#include "Plants/StandSpecies.h"

class vtkTable;

namespace littoral
{

/// All columns with a value a row as words; NaN is an empty word. Throws InvalidInput if a column has another number of
/// rows.
TextTable TextsOf(vtkTable* table);

}

#endif
