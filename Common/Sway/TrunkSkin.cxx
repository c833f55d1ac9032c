// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sway/TrunkSkin.h"

#include "Sway/PlantMotion.h"

#include <algorithm>

namespace littoral
{

Skeleton TrunkAlone(const Skeleton& plant)
{
  Skeleton trunk;
  const SkeletonBranch& branch = plant.Branches.front();
  trunk.Branches.push_back(branch);
  trunk.Nodes.assign(plant.Nodes.begin() + branch.First, plant.Nodes.begin() + branch.First + branch.Count);
  return trunk;
}

TrunkSkin::TrunkSkin(const Skeleton& trunk)
  : Foot(trunk.Nodes.front().Position)
  , Axis(BranchAxis(trunk, 0))
{
  double highest = 0.0;
  for (std::size_t node = 0; node + 1 < trunk.Nodes.size(); ++node)
  {
    const Vector3 middle = 0.5 * (trunk.Nodes[node].Position + trunk.Nodes[node + 1].Position) - this->Foot;
    highest = std::max(highest, glm::dot(middle, this->Axis)); // where a trunk bends back, it stays
    this->Middles.push_back(highest);
  }
}

JointHold TrunkSkin::At(const Vector3& position) const
{
  const double along = glm::dot(position - this->Foot, this->Axis);
  const auto above = std::upper_bound(this->Middles.begin(), this->Middles.end(), along);
  const int upper = static_cast<int>(above - this->Middles.begin());
  const int last = static_cast<int>(this->Middles.size()) - 1;
  JointHold hold;
  if (upper == 0 || upper > last)
  {
    hold.Joints[0] = std::min(upper, last);
    return hold;
  }
  const double part = (along - this->Middles[upper - 1]) / (this->Middles[upper] - this->Middles[upper - 1]);
  hold.Joints = { upper - 1, upper, 0, 0 };
  hold.Weights = { static_cast<float>(1.0 - part), static_cast<float>(part), 0.0f, 0.0f };
  return hold;
}

}
