// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/PlantTable.h"

#include "Data/ArrayReader.h"
#include "Data/PlantBlocks.h"

#include <algorithm>

namespace littoral
{

int PlantTable::RowOf(int plant) const
{
  const auto found = std::lower_bound(this->Rows.begin(), this->Rows.end(), std::make_pair(plant, -1));
  return found != this->Rows.end() && found->first == plant ? found->second : -1;
}

PlantTable ReadTable(vtkDataObject* forest)
{
  PlantTable table;
  const std::string owner = "the forest";
  vtkDataArray* plants = ArrayReader::OfFields(forest, owner).Find(plant::PlantId, 1);
  if (!plants)
  {
    return table;
  }
  table.IsThere = true;
  const vtkIdType count = plants->GetNumberOfTuples();
  const ArrayReader columns = ArrayReader::OfFields(forest, owner, count);
  vtkDataArray* species = columns.Need("Species", 1);
  vtkDataArray* scales = columns.Need("Scale", 1);
  vtkDataArray* girths = columns.Find("WidthScale", 1);
  vtkDataArray* azimuths = columns.Need("Azimuth", 1);
  vtkDataArray* positions = columns.Need("Position", 3);
  vtkDataArray* levels = columns.Need("Level", 1);
  vtkDataArray* tints = columns.Find("Tint", 3);
  table.HasTints = tints != nullptr;
  for (vtkDataArray* column : { scales, girths, azimuths, positions, tints })
  {
    columns.NeedFinite(column);
  }
  table.Rows.reserve(static_cast<std::size_t>(count));
  table.Places.reserve(static_cast<std::size_t>(count));
  table.Levels.reserve(static_cast<std::size_t>(count));
  for (vtkIdType row = 0; row < count; ++row)
  {
    const std::string ofPlant = " of plant " + std::to_string(row);
    PlantPlace place;
    PlantLevel level = PlantLevel::Low;
    ReadWhole(plant::PlantId + ofPlant, plants->GetComponent(row, 0), 0, VTK_INT_MAX, place.Site);
    ReadWhole("Species" + ofPlant, species->GetComponent(row, 0), VTK_INT_MIN, VTK_INT_MAX, place.Species);
    ReadWhole("Level" + ofPlant, levels->GetComponent(row, 0), 0, 2, level);
    place.Scale = scales->GetComponent(row, 0);
    place.WidthScale = girths ? girths->GetComponent(row, 0) : 1.0;
    place.Azimuth = azimuths->GetComponent(row, 0);
    positions->GetTuple(row, &place.Foot.x);
    for (int channel = 0; tints && channel < 3; ++channel)
    {
      place.Tint[channel] = static_cast<float>(tints->GetComponent(row, channel));
    }
    table.Rows.emplace_back(place.Site, static_cast<int>(row));
    table.Places.push_back(place);
    table.Levels.push_back(level);
  }
  std::sort(table.Rows.begin(), table.Rows.end());
  return table;
}

}
