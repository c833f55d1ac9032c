// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/StandAtRest.h"

#include <algorithm>

namespace littoral
{

StandAtRest::StandAtRest(const PlantPart& part, const std::vector<PlantPlace>& places, const std::vector<int>& plants)
{
  const auto take = [](const PartArray& from, OfSpecies& to) {
    for (vtkDataArray* array : from.OfSpecies)
    {
      to.emplace_back(vtkFloatArray::SafeDownCast(array));
    }
  };
  for (const PartArray& array : part.PointArrays)
  {
    if (array.Use == ArrayUse::Points)
    {
      take(array, this->Points);
    }
    else if (array.Name == NormalsName)
    {
      take(array, this->Normals);
    }
  }
  std::size_t end = 0;
  for (const int plant : plants)
  {
    const PlantPlace& place = places[static_cast<std::size_t>(plant)];
    const std::size_t points = part.Meshes[static_cast<std::size_t>(place.Species)].NumberOfPoints;
    if (points > 0)
    {
      this->Plants.push_back({ end, end + points, place });
      end += points;
    }
  }
}

void StandAtRest::Place(std::size_t begin, std::size_t end, float* points, float* normals) const
{
  auto plant = std::upper_bound(
    this->Plants.begin(), this->Plants.end(), begin, [](std::size_t own, const Plant& one) { return own < one.End; });
  for (; plant != this->Plants.end() && plant->Begin < end; ++plant)
  {
    const auto species = static_cast<std::size_t>(plant->Place.Species);
    const std::size_t first = std::max(begin, plant->Begin);
    const std::size_t count = std::min(end, plant->End) - first;
    const auto from = [&](const OfSpecies& arrays) {
      return arrays[species]->GetPointer(0) + 3 * (first - plant->Begin);
    };
    const PlantPlacement placement(plant->Place);
    placement.Points(from(this->Points), count, points + 3 * (first - begin));
    if (this->HasNormals())
    {
      placement.Directions(from(this->Normals), count, normals + 3 * (first - begin));
    }
  }
}

}
