// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/ScatteredJoints.h"

#include "Data/ArrayReader.h"
#include "Data/PlantBlocks.h"
#include "Numerics/InvalidInput.h"

#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>

namespace littoral
{

namespace
{

/// A part of a prototype.
struct BoundPart
{
  vtkIdType Points = 0;
  int Nodes = 0;
  std::shared_ptr<const SkinBinding> Binding;
};

BoundPart PartOfPrototype(vtkMultiBlockDataSet* prototype, const char* name)
{
  vtkPolyData* bones = PlantPartOf(prototype, plant::High, plant::Skeleton);
  vtkPolyData* block = PlantPartOf(prototype, plant::High, name);
  BoundPart part;
  if (bones && block && block->GetNumberOfPoints() > 0)
  {
    part.Nodes = static_cast<int>(bones->GetNumberOfPoints());
    part.Points = block->GetNumberOfPoints();
    InContext("Of Prototypes: ", [&] { RequireSkin(block, name, static_cast<std::size_t>(part.Nodes)); });
    part.Binding = std::make_shared<const SkinBinding>(ReadBinding(block));
  }
  return part;
}

/// The end of the points of a plant that begin at a point.
vtkIdType EndOfPlant(vtkIntArray* plantIds, vtkIdType begin)
{
  const int* all = plantIds->GetPointer(0);
  const int plant = all[begin];
  return std::find_if(all + begin, all + plantIds->GetNumberOfTuples(), [plant](int id) { return id != plant; }) - all;
}

}

std::vector<PlantNodes> NodesByRow(
  const PlantTable& table, const std::vector<Skeleton>& skeletons, vtkIntArray* plantIds)
{
  std::vector<PlantNodes> nodes(table.Places.size());
  int first = 0;
  for (const Skeleton& one : skeletons)
  {
    const int row = plantIds ? table.RowOf(plantIds->GetValue(first)) : -1;
    const int count = static_cast<int>(one.Nodes.size());
    if (row >= 0)
    {
      nodes[static_cast<std::size_t>(row)] = { first, count };
    }
    first += count;
  }
  return nodes;
}

bool TellsJoints(vtkPolyData* block)
{
  return ArrayReader::OfPoints(block, "a skin").Any(plant::JointIds) != nullptr;
}

StandBinding BindingOfPrototypes(vtkPolyData* block, const char* name, const PlantTable& table,
  const std::vector<PlantNodes>& nodes, const std::vector<vtkMultiBlockDataSet*>& prototypes)
{
  const std::string owner = std::string("High/") + name + " of the plants";
  std::vector<BoundPart> parts;
  for (vtkMultiBlockDataSet* prototype : prototypes)
  {
    parts.push_back(PartOfPrototype(prototype, name));
  }
  vtkIntArray* plantIds = FindPlantIds(block);
  Require(plantIds ? "" : owner + " has neither JointIds nor PlantId.");
  const vtkIdType points = block->GetNumberOfPoints();
  StandBinding binding;
  for (vtkIdType begin = 0, end = 0; begin < points; begin = end)
  {
    end = EndOfPlant(plantIds, begin);
    const int row = table.RowOf(plantIds->GetValue(begin));
    const int species = row < 0 ? -1 : table.Places[static_cast<std::size_t>(row)].Species;
    const bool isKnown = species >= 0 && species < static_cast<int>(parts.size());
    const BoundPart part = isKnown ? parts[static_cast<std::size_t>(species)] : BoundPart();
    const PlantNodes own = row < 0 ? PlantNodes() : nodes[static_cast<std::size_t>(row)];
    if (part.Points != end - begin || part.Nodes != own.Count)
    {
      Refuse(
        "connect the Prototypes that the plants were made from, or switch on PassJoints where they are scattered: ",
        owner, " has no JointIds, and plants are not like their prototypes.");
    }
    binding.Add(part.Binding, own.First);
  }
  return binding;
}

}
