// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Seaweed/SeaweedSkin.h"

#include <algorithm>

namespace littoral
{

namespace
{

/// Whether none of the four joints of a vertex ever moves.
bool IsFixed(const int* joints, const SeaweedStand& stand)
{
  return std::all_of(joints, joints + 4, [&](int joint) { return stand.LinkOf(static_cast<std::size_t>(joint)) < 0; });
}

/// Adds a vertex to the last run, or to a new one where that is of another plant or does not go on.
void AddTo(std::vector<SkinRun>& runs, std::size_t vertex, std::size_t plant)
{
  if (runs.empty() || runs.back().Plant != plant || runs.back().End != vertex)
  {
    runs.push_back({ vertex, vertex, plant });
  }
  runs.back().End = vertex + 1;
}

}

SeaweedSkin::SeaweedSkin(const int* jointIds, std::size_t vertices, const SeaweedStand& stand)
{
  for (std::size_t vertex = 0; vertex < vertices; ++vertex)
  {
    const int* joints = jointIds + 4 * vertex;
    AddTo(IsFixed(joints, stand) ? this->FixedRuns : this->Runs, vertex, stand.PlantOf(joints[0]));
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
