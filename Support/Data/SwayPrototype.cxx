// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/SwayPrototype.h"

#include "Data/PlantBlocks.h"
#include "Numerics/InvalidInput.h"

#include <algorithm>

namespace littoral
{

void SwayPrototype::Read(vtkMultiBlockDataSet* plant, const SwaySettings& settings)
{
  vtkPolyData* bones = PlantPartOf(plant, plant::High, plant::Skeleton);
  WoodParameters wood = settings.Options.Wood;
  this->Species.Wood = wood;
  if (bones && bones->GetNumberOfPoints() > 0)
  {
    const Skeleton rest = ReadSkeleton(bones);
    const auto isTrunk = [&rest](const SkeletonBranch& branch) { return rest.Nodes[branch.First].Parent < 0; };
    const auto trunks = std::count_if(rest.Branches.begin(), rest.Branches.end(), isTrunk);
    if (trunks != 1)
    {
      Refuse("connect single plants: High/Skeleton has ", trunks, " trunks.");
    }
    this->Leaves = PlantPartOf(plant, plant::High, plant::Leaves);
    if (this->Leaves)
    {
      RequireSkin(this->Leaves, plant::Leaves, rest.Nodes.size());
    }
    if (settings.WoodFromPlants && ReadWood(plant, wood))
    {
      Require(WhyInvalid(wood));
    }
    this->Species = MakeSpecies(rest, wood, ReadLeaves(this->Leaves), settings);
    Require(HasModes(this->Species, settings)
        ? ""
        : "High/Skeleton of the plants has a trunk whose values of Radius are too unlike for a beam.");
  }
  this->ReadCrown(PlantPartOf(plant, plant::Medium, plant::Crown));
}

void SwayPrototype::ReadCrown(vtkPolyData* crown)
{
  vtkDataArray* places = crown ? crown->GetPointData()->GetTCoords() : nullptr;
  if (!places || crown->GetNumberOfPoints() == 0)
  {
    return;
  }
  this->Crown = crown;
  for (vtkIdType point = 0; point < crown->GetNumberOfPoints(); ++point)
  {
    this->Species.CrownTCoords.push_back({ places->GetComponent(point, 0), places->GetComponent(point, 1) });
  }
  if (!IsEnvelope(crown))
  {
    return;
  }
  double bounds[6];
  crown->GetBounds(bounds);
  CrownVolume& volume = this->Volume.emplace();
  crown->GetPoint(0, &volume.Foot.x); // on the axis
  volume.Foot.z = bounds[4];
  volume.Height = std::max(1e-6, bounds[5] - bounds[4]);
}

CrownModel SwayPrototype::MakeCrown() const
{
  CrownModel model;
  model.Volume = this->Volume;
  model.StillPicture = ReadTexture(this->Crown);
  if (!this->Species.Leaves.empty())
  {
    model.Leaves = ReadMesh(this->Leaves);
    model.LeafTexture = ReadTexture(this->Leaves);
    model.LeafSkin = ReadSkin(this->Leaves);
    model.LeafSkin.Normals = nullptr;
    model.LeafBinding = ReadBinding(this->Leaves);
  }
  return model;
}

}
