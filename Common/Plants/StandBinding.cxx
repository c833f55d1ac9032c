// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/StandBinding.h"

#include <algorithm>
#include <utility>

namespace littoral
{

StandBinding::StandBinding(SkinBinding all)
{
  this->Add(std::make_shared<const SkinBinding>(std::move(all)), 0);
}

void StandBinding::Add(std::shared_ptr<const SkinBinding> binding, int firstJoint)
{
  const std::size_t begin = this->GetNumberOfVertices();
  const std::size_t end = begin + binding->GetNumberOfVertices();
  SkinBinding::RequireRoom(end);
  this->Plants.push_back({ begin, end, firstJoint, std::move(binding) });
}

const StandBinding::Plant* StandBinding::PlantOf(std::size_t vertex) const
{
  const auto plant = std::upper_bound(
    this->Plants.begin(), this->Plants.end(), vertex, [](std::size_t own, const Plant& one) { return own < one.End; });
  return this->Plants.data() + (plant - this->Plants.begin());
}

int StandBinding::JointOf(std::size_t vertex) const
{
  const Plant* plant = this->PlantOf(vertex);
  return plant->FirstJoint + plant->Binding->RunOf(vertex - plant->Begin)->Joints[0];
}

void StandBinding::Move(const RestSkin& rest, const JointChange* joints, std::size_t begin, std::size_t end,
  float* points, float* normals) const
{
  const auto at = [](auto* tuples, std::size_t vertex) { return tuples ? tuples + 3 * vertex : nullptr; };
  const Plant* last = this->Plants.data() + this->Plants.size();
  for (const Plant* plant = this->PlantOf(begin); plant != last && plant->Begin < end; ++plant)
  {
    const std::size_t first = plant->Begin;
    const std::size_t own = std::max(begin, first);
    const RestSkin ofPlant{ at(rest.Points, own - rest.First), at(rest.Normals, own - rest.First), own - first };
    MoveSkin(ofPlant, *plant->Binding, joints + plant->FirstJoint, own - first, std::min(end, plant->End) - first,
      at(points, first), at(normals, first));
  }
}

void StandBinding::Write(int* jointIds, float* jointWeights) const
{
  for (const Plant& plant : this->Plants)
  {
    plant.Binding->Write(jointIds + 4 * plant.Begin, jointWeights + 4 * plant.Begin);
    std::transform(jointIds + 4 * plant.Begin, jointIds + 4 * plant.End, jointIds + 4 * plant.Begin,
      [first = plant.FirstJoint](int id) { return id + first; });
  }
}

}
