// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/ScatterTable.h"

#include "Data/Arrays.h"
#include "Data/PlantBlocks.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>

namespace littoral
{

namespace
{

/// A field array of one number a plant.
template <typename Array, typename Number>
void AddPlantColumn(vtkFieldData* fields, const char* name, int components, std::size_t count, const Number& numberOf)
{
  const auto column = NewArray<Array>(name, components, static_cast<vtkIdType>(count));
  auto* values = column->GetPointer(0);
  for (std::size_t index = 0; index < count; ++index)
  {
    for (int component = 0; component < components; ++component)
    {
      *values++ = numberOf(index, component);
    }
  }
  fields->AddArray(column);
}

}

bool HasGirths(const std::vector<PlantPlace>& places)
{
  return std::any_of(places.begin(), places.end(), [](const PlantPlace& place) { return place.WidthScale != 1.0; });
}

void WriteTable(
  const std::vector<PlantPlace>& places, const std::vector<ShownPlant>& shown, bool withTints, vtkFieldData* fields)
{
  const auto of = [&](std::size_t index) -> const PlantPlace& { return places[shown[index].Place]; };
  const std::size_t count = shown.size();
  AddPlantColumn<vtkIntArray>(fields, plant::PlantId, 1, count, [&](auto i, int) { return of(i).Site; });
  AddPlantColumn<vtkTypeInt64Array>(fields, "SiteId", 1, count, [&](auto i, int) { return of(i).SiteId; });
  AddPlantColumn<vtkIntArray>(fields, "Species", 1, count, [&](auto i, int) { return of(i).Species; });
  AddPlantColumn<vtkDoubleArray>(fields, "Scale", 1, count, [&](auto i, int) { return of(i).Scale; });
  if (HasGirths(places))
  {
    AddPlantColumn<vtkDoubleArray>(fields, "WidthScale", 1, count, [&](auto i, int) { return of(i).WidthScale; });
  }
  AddPlantColumn<vtkDoubleArray>(fields, "Azimuth", 1, count, [&](auto i, int) { return of(i).Azimuth; });
  AddPlantColumn<vtkDoubleArray>(fields, "Position", 3, count, [&](auto i, int axis) { return of(i).Foot[axis]; });
  AddPlantColumn<vtkIntArray>(fields, "Level", 1, count, [&](auto i, int) { return static_cast<int>(shown[i].Level); });
  if (withTints)
  {
    AddPlantColumn<vtkFloatArray>(fields, "Tint", 3, count, [&](auto i, int channel) { return of(i).Tint[channel]; });
  }
}

void WriteCounter(vtkFieldData* fields, const char* name, double value)
{
  AddPlantColumn<vtkDoubleArray>(fields, name, 1, 1, [=](auto, int) { return value; });
}

}
