// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Seaweed/SeaweedSkin.h"

#include <algorithm>

namespace littoral
{

SeaweedSkin::SeaweedSkin(const int* jointIds, std::size_t vertices, const SeaweedStand& stand)
{
  for (std::size_t vertex = 0; vertex < vertices; ++vertex)
  {
    const std::size_t plant = stand.PlantOf(jointIds[4 * vertex]);
    if (this->Runs.empty() || this->Runs.back().Plant != plant)
    {
      this->Runs.push_back({ vertex, vertex, plant });
    }
    this->Runs.back().End = vertex + 1;
  }
  std::stable_sort(
    this->Runs.begin(), this->Runs.end(), [](const SkinRun& a, const SkinRun& b) { return a.Plant < b.Plant; });
  for (std::size_t plant = 0; plant <= stand.GetPlants().size(); ++plant)
  {
    const auto first = std::lower_bound(
      this->Runs.begin(), this->Runs.end(), plant, [](const SkinRun& run, std::size_t own) { return run.Plant < own; });
    this->FirstRun.push_back(static_cast<std::size_t>(first - this->Runs.begin()));
  }
}

}
