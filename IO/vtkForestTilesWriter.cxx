// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkForestTilesWriter.h"

#include "Data/Blocks.h"
#include "Data/Georeference.h"
#include "Data/Inputs.h"
#include "ForestTileFiles.h"
#include "GatheredPoints.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/Memory.h"
#include "Pipeline/Pipeline.h"
#include "PlainData.h"
#include "SceneBlocks.h"
#include "SceneInput.h"
#include "WriterRanks.h"

#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkForestTilesWriter);

namespace
{

constexpr int Levels = 3;
constexpr int PrototypesTag = 78160;
/// A tree in memory: as read, on earth, in the order, and in a file of places.
constexpr double BytesOfTree = 400.0;

/// Throws InvalidInput unless blocks are instances that can be written.
void RequireForest(vtkMultiBlockDataSet* blocks)
{
  vtkPolyData* points = littoral::InstancesOf(blocks);
  littoral::Require(points ? "" : "the input has no instances of plants: set OutputForm of Plant Scatter to Instances");
  littoral::Require(
    points->GetNumberOfPoints() > 0 ? "" : "the input has no trees: switch off UseCulling of Plant Scatter");
  littoral::RequireMemory(
    BytesOfTree * static_cast<double>(points->GetNumberOfPoints()), "the tiles of the trees", "take fewer");
  littoral::RequireScene({}, { { "the forest", littoral::SceneKind::Automatic, blocks } }, {});
}

/// The same blocks with other instances.
vtkSmartPointer<vtkDataObject> WithTrees(vtkMultiBlockDataSet* blocks, vtkPolyData* trees)
{
  auto copy = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  copy->ShallowCopy(blocks);
  vtkPolyData* before = littoral::InstancesOf(copy);
  for (unsigned int index = 0; index < copy->GetNumberOfBlocks(); ++index)
  {
    if (copy->GetBlock(index) == before)
    {
      copy->SetBlock(index, trees);
    }
  }
  return copy;
}

/// The instances of blocks with the prototypes of each level.
littoral::TiledForest ForestOf(vtkMultiBlockDataSet* blocks)
{
  littoral::TiledForest forest;
  vtkPolyData* points = littoral::InstancesOf(blocks);
  littoral::SceneInstances places = littoral::PlacesOf(points, [](int) { return true; });
  vtkDataArray* prototypes = points->GetPointData()->GetArray("Prototype");
  forest.Extents = littoral::ExtentsOf(blocks);
  for (vtkIdType point = 0; point < points->GetNumberOfPoints(); ++point)
  {
    double at[3];
    points->GetPoint(point, at);
    forest.Feet.emplace_back(at[0], at[1], at[2]);
    const int species = (static_cast<int>(prototypes->GetComponent(point, 0)) - 1) / Levels;
    littoral::Require(prototypes->GetComponent(point, 0) >= 1.0 && forest.Extents.count(species) > 0
        ? ""
        : "tree " + std::to_string(point) + " of the input has a Prototype that is not there");
    forest.Species.push_back(species);
  }
  forest.Rotations = std::move(places.Rotations);
  forest.Scales = std::move(places.Scales);
  for (int level = 0; level < Levels; ++level)
  {
    forest.Levels[level] = littoral::PrototypesOf(blocks, level);
  }
  return forest;
}

}

//----------------------------------------------------------------------------
vtkForestTilesWriter::vtkForestTilesWriter()
  : vtkSingleFileWriter("a forest")
{
}

//----------------------------------------------------------------------------
vtkForestTilesWriter::~vtkForestTilesWriter() = default;

//----------------------------------------------------------------------------
int vtkForestTilesWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkMultiBlockDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPartitionedDataSetCollection");
  return 1;
}

//----------------------------------------------------------------------------
/// The prototypes of the first rank that has trees, and the trees of all.
vtkSmartPointer<vtkDataObject> vtkForestTilesWriter::GatherInput(vtkDataObject* own)
{
  const littoral::WriterRanks ranks(this->GetController());
  vtkSmartPointer<vtkMultiBlockDataSet> blocks;
  ranks.Agree(littoral::WhyRefused(
    [&] { blocks = own ? littoral::BlocksOf(own, "the forest") : vtkSmartPointer<vtkMultiBlockDataSet>::New(); }));
  vtkPolyData* trees = littoral::InstancesOf(blocks);
  const vtkSmartPointer<vtkPolyData> all = littoral::GatherPoints(ranks, trees);
  const int filled = ranks.FirstWith(trees && trees->GetNumberOfPoints() > 0);
  if (filled > 0 && ranks.GetRank() == filled)
  {
    ranks.GetController()->Send(littoral::PlainData(blocks), 0, PrototypesTag);
  }
  if (!ranks.IsFirst() || filled < 0)
  {
    return blocks;
  }
  vtkNew<vtkMultiBlockDataSet> received;
  if (filled > 0)
  {
    ranks.GetController()->Receive(received, filled, PrototypesTag);
    blocks = received;
  }
  return WithTrees(blocks, littoral::InOrder(all, "PlantId")); // parts are cells of the forest, each in that order
}

//----------------------------------------------------------------------------
void vtkForestTilesWriter::WriteInput()
{
  const std::string path = this->NeedFileName();
  littoral::ForestTilingOptions options;
  options.TreesPerTile = this->TreesPerTile;
  options.NearDistance = this->NearDistance;
  options.FarDistance = this->FarDistance;
  littoral::Require(littoral::WhyInvalid(options));
  littoral::ParameterCheck check;
  check.Range("HeightOffset", this->HeightOffset, -1e4, 1e4, "m");
  check.Finite("CoordinateOffset[0]", this->CoordinateOffset[0], "m");
  check.Finite("CoordinateOffset[1]", this->CoordinateOffset[1], "m");
  littoral::Require(check.Reason());
  const vtkSmartPointer<vtkMultiBlockDataSet> blocks = littoral::BlocksOf(this->GetWholeInput(), "the forest");
  RequireForest(blocks);
  littoral::Georeference place = littoral::ReadGeoreference(littoral::InstancesOf(blocks));
  if (!this->CoordinateSystem.empty())
  {
    place.System = this->CoordinateSystem;
    place.Offset = { { this->CoordinateOffset[0], this->CoordinateOffset[1] } };
  }
  const littoral::EarthPlaces earth(place, this->HeightOffset);
  this->SetProgressText("Writing tiles");
  const littoral::TiledForest forest = ForestOf(blocks);
  this->Conclude(littoral::WriteForestTiles(path, forest, earth, options, [this](double share) {
    this->UpdateProgress(share);
    return !littoral::IsAborted(this);
  }));
}

//----------------------------------------------------------------------------
void vtkForestTilesWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CoordinateSystem: " << this->CoordinateSystem << "\n";
  os << indent << "CoordinateOffset: " << this->CoordinateOffset[0] << " " << this->CoordinateOffset[1] << "\n";
  os << indent << "HeightOffset: " << this->HeightOffset << "\n";
  os << indent << "TreesPerTile: " << this->TreesPerTile << "\n";
  os << indent << "NearDistance: " << this->NearDistance << "\n";
  os << indent << "FarDistance: " << this->FarDistance << "\n";
}
