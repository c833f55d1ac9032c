// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPlantWakeFilter.h"

#include "Data/ArrayReader.h"
#include "Data/Blocks.h"
#include "Data/FlowPrimitiveData.h"
#include "Data/PlantBlocks.h"
#include "Data/PlantForm.h"
#include "Data/SeaweedBlocks.h"
#include "Numerics/Constants.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/Pipeline.h"
#include "Seaweed/PlantWake.h"

#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <string>
#include <vector>

vtkStandardNewMacro(vtkPlantWakeFilter);

namespace
{

using littoral::ArrayReader;
using littoral::MovingPoint;

/// The nodes of a skeleton by plant, plants in the order in which they come.
void ReadPlants(vtkPolyData* bones, std::vector<std::vector<MovingPoint>>& plants, std::vector<int>& plantIds)
{
  const ArrayReader points = ArrayReader::OfPoints(bones, "High/Skeleton of the plants");
  if (!points.Has("Velocity") || !points.Has("Acceleration"))
  {
    littoral::Refuse("High/Skeleton has no point arrays Velocity[3] and Acceleration[3]; switch on GenerateMotion of "
                     "the deformation filter.");
  }
  vtkDataArray* velocity = points.Need("Velocity", 3);
  vtkDataArray* acceleration = points.Need("Acceleration", 3);
  vtkDataArray* radius = points.Need(littoral::plant::Radius, 1);
  vtkDataArray* length = points.Need(littoral::seaweed::Length, 1);
  vtkDataArray* density = points.Need(littoral::seaweed::Density, 1);
  vtkDataArray* ids = points.Find(littoral::plant::PlantId, 1);
  for (vtkDataArray* numbers : { velocity, acceleration, radius, length, density })
  {
    points.NeedFinite(numbers);
  }
  for (vtkIdType node = 0; node < bones->GetNumberOfPoints(); ++node)
  {
    int id = 0;
    if (ids)
    {
      littoral::ReadWhole("PlantId", ids->GetComponent(node, 0), VTK_INT_MIN, VTK_INT_MAX, id);
    }
    if (plants.empty() || plantIds.back() != id)
    {
      plants.emplace_back();
      plantIds.push_back(id);
    }
    MovingPoint point;
    bones->GetPoint(node, &point.Place.x);
    velocity->GetTuple(node, &point.Velocity.x);
    acceleration->GetTuple(node, &point.Acceleration.x);
    const double r = radius->GetComponent(node, 0);
    point.Volume = littoral::Pi * r * r * length->GetComponent(node, 0);
    point.Weight = density->GetComponent(node, 0) * point.Volume;
    if (!littoral::IsFinite(point.Place) || !littoral::IsFinite(point.Velocity) ||
      !littoral::IsFinite(point.Acceleration) || !(point.Weight >= 0.0))
    {
      littoral::Refuse("node ", node, " of High/Skeleton has numbers that are not finite, or no mass.");
    }
    plants.back().push_back(point);
  }
}

}

//----------------------------------------------------------------------------
vtkPlantWakeFilter::vtkPlantWakeFilter()
  : Primitive(Source)
  , Strength(0.5)
  , Margin(0.5)
  , CoreShare(0.2)
{
}

vtkPlantWakeFilter::~vtkPlantWakeFilter() = default;

//----------------------------------------------------------------------------
int vtkPlantWakeFilter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkMultiBlockDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPartitionedDataSetCollection");
  return 1;
}

//----------------------------------------------------------------------------
int vtkPlantWakeFilter::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  // A current is asked for as a whole.
  littoral::RequestAll(inputVector[0]->GetInformationObject(0));
  return 1;
}

//----------------------------------------------------------------------------
int vtkPlantWakeFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  littoral::WakeOptions options;
  options.Kind = static_cast<littoral::WakeKind>(this->Primitive);
  options.Strength = this->Strength;
  options.Margin = this->Margin;
  options.CoreShare = this->CoreShare;
  littoral::ParameterCheck check;
  check.Choice("Primitive", this->Primitive, { "source", "doublet" });
  check.Require(littoral::WhyInvalid(options));
  littoral::Require(check.Reason());
  const auto blocks = littoral::BlocksOf(vtkDataObject::GetData(inputVector[0]), "Input");
  littoral::RequireSkeleton(blocks);
  vtkPolyData* bones = littoral::PlantPartOf(blocks, littoral::plant::High, littoral::plant::Skeleton);
  std::vector<std::vector<MovingPoint>> plants;
  std::vector<int> plantIds;
  littoral::Require(bones ? "" : "the plants have no block High/Skeleton.");
  if (bones->GetNumberOfPoints() > 0)
  {
    ReadPlants(bones, plants, plantIds);
  }
  std::vector<littoral::FlowPrimitive> primitives;
  vtkNew<vtkIntArray> ids;
  ids->SetName(littoral::plant::PlantId);
  for (std::size_t plant = 0; plant < plants.size(); ++plant)
  {
    for (const littoral::FlowPrimitive& one : littoral::WakeOf(littoral::PlantOf(plants[plant]), options))
    {
      primitives.push_back(one);
      ids->InsertNextValue(plantIds[plant]);
    }
  }
  // The first piece holds all primitives; else each rank would add its own.
  if (outputVector->GetInformationObject(0)->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) > 0)
  {
    return 1;
  }
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  littoral::WriteFlowPrimitives(primitives, output);
  output->GetPointData()->AddArray(ids);
  return 1;
}

//----------------------------------------------------------------------------
int vtkPlantWakeFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return littoral::WithoutExceptions(this, request, outputs,
    "Cannot make a wake: ", [&] { return this->Superclass::ProcessRequest(request, inputs, outputs); });
}

//----------------------------------------------------------------------------
void vtkPlantWakeFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Primitive: " << this->Primitive << "\n";
  os << indent << "Strength: " << this->Strength << "\n";
  os << indent << "Margin: " << this->Margin << "\n";
  os << indent << "CoreShare: " << this->CoreShare << "\n";
}
