// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Seaweed/SeaweedStand.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace littoral
{

SeaweedStand::SeaweedStand(Skeleton rest, const std::vector<SeaweedLink>& links, const int* plantIds)
  : Rest(std::move(rest))
{
  this->FindLinks(links);
  this->FindCarriers(links);
  this->FindPlants(plantIds);
  for (StandPlant& plant : this->Plants)
  {
    Measure(links, plant);
  }
}

void SeaweedStand::FindLinks(const std::vector<SeaweedLink>& links)
{
  this->LinkOfNode.assign(this->Rest.Nodes.size(), -1);
  for (std::size_t link = 0; link < links.size(); ++link)
  {
    this->LinkOfNode[links[link].Node] = static_cast<int>(link);
  }
  for (const SkeletonBranch& branch : this->Rest.Branches)
  {
    const int tip = branch.First + branch.Count - 1;
    this->LinkOfNode[tip] = this->LinkOfNode[tip - 1];
    for (int node = branch.First; node < tip; ++node)
    {
      if (this->LinkOfNode[node] >= 0)
      {
        const int order = node - branch.First;
        this->LastLevels.push_back(order == 0 ? 2 : (order < branch.Count / 2 ? 1 : 0));
      }
    }
  }
}

void SeaweedStand::FindCarriers(const std::vector<SeaweedLink>& links)
{
  for (std::size_t link = 0; link < links.size(); ++link)
  {
    const int parent = links[link].Parent;
    const bool isCarried = this->LastLevels[link] < 2 && parent >= 0;
    this->Carriers.push_back(isCarried ? this->Carriers[static_cast<std::size_t>(parent)] : link);
    this->AreBelowCarriers.push_back(!isCarried);
  }
  for (std::size_t link = links.size(); link-- > 0;)
  {
    if (links[link].Parent >= 0 && this->AreBelowCarriers[link])
    {
      this->AreBelowCarriers[static_cast<std::size_t>(links[link].Parent)] = 1;
    }
  }
}

void SeaweedStand::FindPlants(const int* plantIds)
{
  constexpr std::size_t None = std::numeric_limits<std::size_t>::max();
  std::size_t begun = None; // the plant of the id at hand, once it has a link
  for (std::size_t node = 0; node < this->Rest.Nodes.size(); ++node)
  {
    begun = node > 0 && plantIds && plantIds[node] != plantIds[node - 1] ? None : begun;
    const int link = this->LinkOfNode[node];
    if (link >= 0)
    {
      if (begun == None)
      {
        begun = this->Plants.size();
        this->Plants.push_back({ static_cast<std::size_t>(link), 0, Vector3(0.0), 0.0 });
      }
      this->Plants.back().EndLink = static_cast<std::size_t>(link) + 1;
    }
    // A holdfast goes with the plant that comes next; where none does, with any, for it never moves.
    this->PlantOfNode.push_back(begun != None ? begun : this->Plants.size());
  }
  for (std::size_t& plant : this->PlantOfNode)
  {
    plant = std::min(plant, this->Plants.size() - 1);
  }
}

/// Finds the middle of a plant at rest, and its reach: the longest way along links plus half of the box's diagonal.
void SeaweedStand::Measure(const std::vector<SeaweedLink>& links, StandPlant& plant)
{
  Vector3 low(1e300);
  Vector3 high(-1e300);
  double reach = 0.0;
  std::vector<double> lengths(plant.EndLink - plant.FirstLink, 0.0);
  for (std::size_t link = plant.FirstLink; link < plant.EndLink; ++link)
  {
    const SeaweedLink& own = links[link];
    const Vector3 end = own.Foot + own.Length * own.Axis;
    low = glm::min(low, glm::min(own.Foot, end));
    high = glm::max(high, glm::max(own.Foot, end));
    const double below = own.Parent < 0 ? 0.0 : lengths[own.Parent - plant.FirstLink];
    lengths[link - plant.FirstLink] = below + own.Length;
    reach = std::max(reach, below + own.Length);
  }
  plant.Middle = 0.5 * (low + high);
  plant.Reach = reach + 0.5 * glm::distance(low, high);
}

std::vector<int> SeaweedStand::CarriersOf(const std::vector<SeaweedLink>& links) const
{
  std::vector<int> carriers(this->LinkOfNode.size());
  for (std::size_t node = 0; node < carriers.size(); ++node)
  {
    const int link = this->LinkOfNode[node];
    carriers[node] = link < 0 ? static_cast<int>(node) : links[this->Carriers[static_cast<std::size_t>(link)]].Node;
  }
  return carriers;
}

}
