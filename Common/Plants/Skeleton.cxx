// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/Skeleton.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

std::string WhyNodeInvalid(const Skeleton& skeleton, int index)
{
  const SkeletonNode& node = skeleton.Nodes[index];
  const std::string name = "node " + std::to_string(index);
  if (!IsFinite(node.Position))
  {
    return name + " has a position that is not finite.";
  }
  if (!std::isfinite(node.Radius) || node.Radius <= 0.0)
  {
    return name + " has a radius that is not positive and finite.";
  }
  if (node.Parent < -1 || node.Parent >= static_cast<int>(skeleton.Nodes.size()))
  {
    return name + " has a parent that does not exist.";
  }
  if (node.Parent >= index)
  {
    return name + " does not come after its parent, as in a cycle.";
  }
  if (node.Branch < 0 || node.Branch >= static_cast<int>(skeleton.Branches.size()))
  {
    return name + " has a branch that does not exist.";
  }
  return {};
}

std::string WhyBranchInvalid(const Skeleton& skeleton, int index, int first)
{
  const SkeletonBranch& branch = skeleton.Branches[index];
  const std::string name = "branch " + std::to_string(index);
  const int nodes = static_cast<int>(skeleton.Nodes.size());
  if (branch.First != first || branch.Count < 2 || branch.Count > nodes - branch.First)
  {
    return name + " is no run of two or more nodes after the branch before it.";
  }
  const int parent = skeleton.Nodes[first].Parent;
  const int order = parent < 0 ? 0 : skeleton.Branches[skeleton.Nodes[parent].Branch].Order + 1;
  if (branch.Order != order)
  {
    return name + " has an order that does not follow from its parent.";
  }
  for (int node = first; node < first + branch.Count; ++node)
  {
    if (skeleton.Nodes[node].Branch != index || (node > first && skeleton.Nodes[node].Parent != node - 1))
    {
      return name + " does not lead from node to node.";
    }
    if (node > first && !(glm::distance(skeleton.Nodes[node].Position, skeleton.Nodes[node - 1].Position) > 0.0))
    {
      return name + " has a segment of zero length.";
    }
  }
  return {};
}

}

int Skeleton::StartBranch(int parent, const Vector3& position, double radius)
{
  const int branch = static_cast<int>(this->Branches.size());
  const int order = parent < 0 ? 0 : this->Branches[this->Nodes[parent].Branch].Order + 1;
  this->Branches.push_back({ static_cast<int>(this->Nodes.size()), 1, order });
  this->Nodes.push_back({ parent, position, radius, branch });
  return branch;
}

int Skeleton::Grow(const Vector3& position, double radius)
{
  const int node = static_cast<int>(this->Nodes.size());
  this->Nodes.push_back({ node - 1, position, radius, static_cast<int>(this->Branches.size()) - 1 });
  ++this->Branches.back().Count;
  return node;
}

double Skeleton::BranchLength(int branch) const
{
  double length = 0.0;
  for (int node = this->Branches[branch].First; node < this->Tip(branch); ++node)
  {
    length += glm::distance(this->Nodes[node + 1].Position, this->Nodes[node].Position);
  }
  return length;
}

Vector3 Skeleton::Along(int branch, double part, int& node) const
{
  const SkeletonBranch& run = this->Branches[branch];
  const double place = std::clamp(part, 0.0, 1.0) * (run.Count - 1);
  const int step = std::clamp(static_cast<int>(place), 0, std::max(0, run.Count - 2));
  node = run.First + step;
  const Vector3& from = this->Nodes[node].Position;
  const Vector3& to = this->Nodes[std::min(node + 1, this->Tip(branch))].Position;
  return from + (place - step) * (to - from);
}

std::string WhyInvalid(const Skeleton& skeleton)
{
  if (skeleton.Nodes.empty() || skeleton.Branches.empty())
  {
    return "a skeleton needs nodes and branches.";
  }
  for (int node = 0; node < static_cast<int>(skeleton.Nodes.size()); ++node)
  {
    if (std::string why = WhyNodeInvalid(skeleton, node); !why.empty())
    {
      return why;
    }
  }
  int first = 0;
  for (int branch = 0; branch < static_cast<int>(skeleton.Branches.size()); ++branch)
  {
    if (std::string why = WhyBranchInvalid(skeleton, branch, first); !why.empty())
    {
      return why;
    }
    first += skeleton.Branches[branch].Count;
  }
  return first == static_cast<int>(skeleton.Nodes.size()) ? "" : "some nodes belong to no branch.";
}

std::vector<Skeleton> PlantsOf(const Skeleton& skeleton)
{
  std::vector<Skeleton> plants;
  for (const SkeletonBranch& branch : skeleton.Branches)
  {
    if (skeleton.Nodes[branch.First].Parent < 0)
    {
      plants.emplace_back();
    }
    Skeleton& plant = plants.back();
    const int firstNode = branch.First - static_cast<int>(plant.Nodes.size());
    plant.Branches.push_back({ branch.First - firstNode, branch.Count, branch.Order });
    for (int index = branch.First; index < branch.First + branch.Count; ++index)
    {
      SkeletonNode node = skeleton.Nodes[index];
      if (node.Parent >= 0 && node.Parent < firstNode)
      {
        return {};
      }
      node.Parent = node.Parent < 0 ? -1 : node.Parent - firstNode;
      node.Branch = static_cast<int>(plant.Branches.size()) - 1;
      plant.Nodes.push_back(node);
    }
  }
  return plants;
}

}
