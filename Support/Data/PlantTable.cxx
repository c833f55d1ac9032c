// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/PlantTable.h"

#include "Data/Arrays.h"
#include "Data/PlantBlocks.h"

#include <algorithm>

namespace littoral
{

int PlantTable::RowOf(int plant) const
{
  const auto found = std::lower_bound(this->Rows.begin(), this->Rows.end(), std::make_pair(plant, -1));
  return found != this->Rows.end() && found->first == plant ? found->second : -1;
}

bool ReadTable(vtkDataObject* forest, PlantTable& table)
{
  vtkDataArray* plants = FieldArray(forest, plant::PlantId, 1, -1);
  const vtkIdType count = plants ? plants->GetNumberOfTuples() : 0;
  vtkDataArray* species = FieldArray(forest, "Species", 1, count);
  vtkDataArray* scales = FieldArray(forest, "Scale", 1, count);
  vtkDataArray* azimuths = FieldArray(forest, "Azimuth", 1, count);
  vtkDataArray* positions = FieldArray(forest, "Position", 3, count);
  vtkDataArray* levels = FieldArray(forest, "Level", 1, count);
  if (!plants || !species || !scales || !azimuths || !positions || !levels)
  {
    return false;
  }
  for (vtkIdType row = 0; row < count; ++row)
  {
    PlantPlace place;
    place.Site = static_cast<int>(plants->GetTuple1(row));
    place.Species = static_cast<int>(species->GetTuple1(row));
    place.Scale = scales->GetTuple1(row);
    place.Azimuth = azimuths->GetTuple1(row);
    positions->GetTuple(row, &place.Foot.x);
    table.Rows.emplace_back(place.Site, static_cast<int>(row));
    table.Places.push_back(place);
    table.Levels.push_back(static_cast<PlantLevel>(static_cast<int>(levels->GetTuple1(row))));
  }
  std::sort(table.Rows.begin(), table.Rows.end());
  return true;
}

}
