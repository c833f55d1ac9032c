// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportPlantTable_h
#define LittoralSupportPlantTable_h

// The table of a scattered forest, which is its field data. Private: never installed, never wrapped.

#include "Plants/PlantScatter.h"

#include <string>
#include <utility>
#include <vector>

class vtkDataObject;

namespace littoral
{

/// The table of a scattered forest: its plants with their levels.
struct PlantTable
{
  bool IsThere = false;  ///< whether plants are scattered
  bool HasTints = false; ///< whether they have their tints, as those whose surfaces are not passed
  std::vector<PlantPlace> Places;
  std::vector<PlantLevel> Levels;

  /// The row of a plant by its PlantId; -1 if there is none.
  int RowOf(int plant) const;

private:
  friend PlantTable ReadTable(vtkDataObject* forest);
  std::vector<std::pair<int, int>> Rows; // by PlantId
};

/// Reads the table, an empty one where plants are not scattered. Throws InvalidInput.
PlantTable ReadTable(vtkDataObject* forest);

}

#endif
