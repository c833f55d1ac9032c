// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportScatterTable_h
#define LittoralSupportScatterTable_h

// The table of the plants of a scattered forest as PlantTable.h reads it: its field data. Private: never installed,
// never wrapped.

#include "Plants/PlantScatter.h"

#include <vector>

class vtkFieldData;

namespace littoral
{

/// Whether a plant has other proportions than its prototype, so that tables and instances say so of all.
bool HasGirths(const std::vector<PlantPlace>& places);

/// Bytes of the table of a plant, without its girth.
inline constexpr double TableBytes = 60.0;

/// Writes a row for each plant that is shown, with its tint where who reads it makes its colors.
void WriteTable(
  const std::vector<PlantPlace>& places, const std::vector<ShownPlant>& shown, bool withTints, vtkFieldData* fields);

/// Writes one number.
void WriteCounter(vtkFieldData* fields, const char* name, double value);

}

#endif
