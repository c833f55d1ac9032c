// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/InventoryPlants.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>

namespace littoral
{

namespace
{

/// The thickest tree of a class over the thinnest, at least, unless there is one class only.
constexpr double SpanOfClass = 1.3;

double Median(std::vector<double> numbers)
{
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}

/// The trees of each kind by their numbers, thin ones first; kinds in the order of the table.
std::vector<std::pair<std::string, std::vector<std::size_t>>> TreesOfKinds(
  const StandSpeciesTable& species, const StandInventory& stand)
{
  std::map<std::string, std::vector<std::size_t>> trees;
  for (std::size_t tree = 0; tree < stand.Trees.size(); ++tree)
  {
    trees[species.GetSpecies()[static_cast<std::size_t>(stand.Trees[tree].Species)].Kind].push_back(tree);
  }
  std::vector<std::pair<std::string, std::vector<std::size_t>>> kinds;
  for (const StandSpecies& row : species.GetSpecies())
  {
    const auto found = trees.find(row.Kind);
    if (found != trees.end())
    {
      std::stable_sort(found->second.begin(), found->second.end(),
        [&](std::size_t a, std::size_t b) { return stand.Trees[a].Diameter < stand.Trees[b].Diameter; });
      kinds.emplace_back(row.Kind, std::move(found->second));
      trees.erase(found);
    }
  }
  return kinds;
}

}

InventoryPlants PlantsOfInventory(const StandSpeciesTable& species, const StandInventory& stand, int classes)
{
  InventoryPlants plants;
  plants.OfTree.resize(stand.Trees.size());
  for (const auto& [kind, trees] : TreesOfKinds(species, stand))
  {
    const double span = stand.Trees[trees.back()].Diameter / stand.Trees[trees.front()].Diameter;
    const auto most = static_cast<std::size_t>(1.0 + std::log(span) / std::log(SpanOfClass));
    const std::size_t count = std::min({ static_cast<std::size_t>(classes), most, trees.size() });
    for (std::size_t size = 0; size < count; ++size)
    {
      std::vector<double> diameters;
      std::vector<double> heights;
      std::vector<double> crowns;
      for (std::size_t n = trees.size() * size / count; n < trees.size() * (size + 1) / count; ++n)
      {
        const StandTree& tree = stand.Trees[trees[n]];
        plants.OfTree[trees[n]] = static_cast<int>(plants.Plants.size());
        diameters.push_back(tree.Diameter);
        heights.push_back(tree.Height);
        crowns.push_back(CrownDiameterOf(tree.Diameter, tree.Height));
      }
      plants.Plants.push_back({ kind, Median(diameters), Median(heights), Median(crowns) });
    }
  }
  return plants;
}

}
