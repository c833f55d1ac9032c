// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDrainageFilter.h"

#include "Data/ArrayReader.h"
#include "Data/Arrays.h"
#include "Data/GivenLines.h"
#include "Data/Inputs.h"
#include "Data/RiverLines.h"
#include "Data/Tables.h"
#include "Data/TerrainHeights.h"
#include "Data/TiledTerrain.h"
#include "Drainage/DepressionFilling.h"
#include "Drainage/DrainageCarving.h"
#include "Drainage/FlowRouting.h"
#include "Drainage/GroundMeasures.h"
#include "Drainage/StreamNetwork.h"
#include "Landscapes/LandscapeGrowth.h"
#include "Landscapes/LandscapeQuilting.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/Pipeline.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSignedCharArray.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <limits>
#include <memory>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkDrainageFilter);

namespace
{

/// Heights, spill elevations, routing, areas, streams and the arrays of the output; carving needs more.
constexpr double BytesACell = 100.0;
constexpr double RockBytesACell = 150.0; // values, their logarithms with margins, and factors of points
constexpr int MaximumGrowthIterations = 12;
constexpr long long MaximumStreamThreshold = 1000000000;
constexpr double MaximumChannelThreshold = 1e6;

/// Memory of a cell of a grid [bytes], with that of carving or growth for all cells.
littoral::CellMemory MemoryOf(vtkImageData* image, double (*work)(int, int), double more = 0.0)
{
  const int* size = image->GetDimensions();
  const double cells = std::max(1.0, static_cast<double>(size[0]) * size[1]);
  return { BytesACell + more + (work ? work(size[0], size[1]) / cells : 0.0), "draining it" };
}

/// Heights of the target: its array of a name, or else its active scalars.
littoral::GridSamples ReadTarget(
  vtkImageData* target, vtkInformation* array, double (*work)(int, int), const littoral::Poll& poll)
{
  const char* name = array->Get(vtkDataObject::FIELD_NAME());
  vtkDataArray* heights = name ? littoral::ArrayReader::OfPoints(target, "Target").Seek(name, 1) : nullptr;
  return littoral::ReadHeights(
    target, heights ? heights : target->GetPointData()->GetScalars(), array, "Target", MemoryOf(target, work), poll);
}

/// Cells at which the array Outlets is not 0.
littoral::OutletMask ChosenOutlets(vtkImageData* image)
{
  const littoral::ArrayReader points = littoral::ArrayReader::OfPoints(image, "Terrain");
  vtkDataArray* chosen = points.Need("Outlets", 1);
  points.NeedFinite(chosen);
  littoral::OutletMask outlets;
  for (vtkIdType cell = 0; cell < image->GetNumberOfPoints(); ++cell)
  {
    outlets.push_back(chosen->GetComponent(cell, 0) != 0.0);
  }
  return outlets;
}

/// Values by place of an array of the terrain; none if it has no such array.
std::vector<double> ValuesByPlace(vtkImageData* image, const char* name)
{
  vtkDataArray* array = littoral::ArrayReader::OfPoints(image, "Terrain").Find(name, 1);
  std::vector<double> values;
  for (vtkIdType cell = 0; array && cell < image->GetNumberOfPoints(); ++cell)
  {
    values.push_back(array->GetComponent(cell, 0));
  }
  return values;
}

/// Rock and faults of the terrain's arrays, of which it needs one at least.
littoral::GrowthRock RockOf(vtkImageData* image)
{
  littoral::GrowthRock rock{ ValuesByPlace(image, "Erodibility"), ValuesByPlace(image, "UpliftFactor"),
    ValuesByPlace(image, "FaultThrow") };
  littoral::Require(rock.Erodibility.empty() && rock.UpliftFactor.empty() && rock.FaultThrow.empty()
      ? "UseRock is on, but Terrain has none of the point arrays Erodibility, UpliftFactor and FaultThrow."
      : "");
  return rock;
}

/// Outlets by a choice of vtkDrainageFilter.
littoral::DrainageOutlets OutletsOf(
  int choice, double seaLevel, vtkImageData* image, const littoral::GridSamples& heights)
{
  using littoral::OutletChoice;
  switch (choice)
  {
    case vtkDrainageFilter::Sea:
      return { OutletChoice::SeaLevel, seaLevel, {}, {} };
    case vtkDrainageFilter::Chosen:
      return { OutletChoice::Chosen, 0.0, ChosenOutlets(image), {} };
    case vtkDrainageFilter::LowestOfBorder:
      return { OutletChoice::Chosen, 0.0, littoral::LowestRimOutlets(heights), {} };
    case vtkDrainageFilter::SeaAlone:
      return { OutletChoice::Chosen, 0.0, littoral::SeaOutletsAlone(heights, seaLevel), {} };
    default:
      return {};
  }
}

/// Progress of carving, growth or quilting, reported where it changes; an abort is heard each time.
littoral::CarvingProgress ProgressOf(vtkAlgorithm* algorithm, const littoral::Poll& poll)
{
  return [=, last = 0.0](double part) mutable {
    if (part != last)
    {
      algorithm->UpdateProgress(0.1 + 0.8 * part);
      last = part;
    }
    poll();
  };
}

/// Adds the report of a carving as field data of two components.
void AddReport(const littoral::CarvingReport& report, vtkDataObject* data)
{
  const littoral::GroundMeasures& before = report.Before;
  const littoral::GroundMeasures& after = report.After;
  littoral::AddField(data, "DepressionFraction", { before.DepressionFraction, after.DepressionFraction });
  littoral::AddField(data, "HypsometricIntegral", { before.HypsometricIntegral, after.HypsometricIntegral });
  littoral::AddField(data, "ElevationSkewness", { before.ElevationSkewness, after.ElevationSkewness });
  littoral::AddField(data, "Concavity", { before.Concavity, after.Concavity });
  littoral::AddField(data, "CurvatureSkewness", { before.CurvatureSkewness, after.CurvatureSkewness });
  littoral::AddField(data, "Iterations", { static_cast<double>(report.Iterations) });
  littoral::AddField(data, "Converged", { report.HasConverged ? 1.0 : 0.0 });
  littoral::AddText(data, "UnmetTargets", report.UnmetTargets);
}

/// Takes what the first row of a table of statistics tells of heights and channels.
void TakeStatistics(vtkTable* table, littoral::TargetStatistics& numbers)
{
  const littoral::ArrayReader rows = littoral::ArrayReader::OfRows(table, "Statistics");
  bool hasNumbers = false;
  const auto take = [&](const char* column, double& value) {
    vtkDataArray* array = table->GetNumberOfRows() > 0 ? rows.Find(column, 1) : nullptr;
    if (array && std::isfinite(array->GetComponent(0, 0)))
    {
      value = array->GetComponent(0, 0);
      hasNumbers = true;
    }
  };
  take("HypsometricIntegral", numbers.HypsometricIntegral);
  take("ElevationSkewness", numbers.ElevationSkewness);
  take("Concavity", numbers.Concavity);
  numbers.KeepsHypsometry = false;
  littoral::Require(hasNumbers
      ? ""
      : "Statistics have no number HypsometricIntegral, ElevationSkewness or Concavity; connect the "
        "first output of Ground Statistics.");
}

}

/// Terrain with its flow routing and streams.
struct vtkDrainageFilter::Ground
{
  littoral::GridSamples Heights;
  littoral::DrainageOutlets Outlets;
  littoral::CarvingReport Report;
  littoral::FlowRouting Routing;
  std::vector<littoral::CellIndex> Cells; ///< flow accumulation
  littoral::StreamNetwork Streams;
  std::vector<double> Levels; ///< spill elevations [m]
};

/// Drainage by tiles, kept from request to request.
class vtkDrainageFilter::vtkInternals
{
public:
  littoral::TiledTerrain Terrain;
  std::exception_ptr Refusal; ///< of a terrain that cannot be drained by tiles, thrown with the data
};

//----------------------------------------------------------------------------
vtkDrainageFilter::vtkDrainageFilter()
  : Outlets(Border)
  , SeaLevel(0.0)
  , StreamThreshold(100)
  , Carve(true)
  , Method(Carving)
  , UseRock(false)
  , UseLineHeights(false)
  , KeepHypsometry(false)
  , HypsometricIntegral(0.4)
  , ElevationSkewness(0.4)
  , Concavity(0.45)
  , MaximumNumberOfIterations(40)
  , ChannelThreshold(50.0)
  , ValleyWidth(3.0)
  , Seed(1)
  , TileSize(0)
  , Internals(new vtkInternals)
{
  this->SetNumberOfInputPorts(4);
  this->SetNumberOfOutputPorts(2);
  this->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

//----------------------------------------------------------------------------
vtkDrainageFilter::~vtkDrainageFilter() = default;

//----------------------------------------------------------------------------
int vtkDrainageFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port > 0);
  constexpr const char* types[] = { "vtkImageData", "vtkImageData", "vtkTable", "vtkPolyData" };
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), types[port]);
  return 1;
}

//----------------------------------------------------------------------------
int vtkDrainageFilter::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkImageData" : "vtkPolyData");
  return 1;
}

//----------------------------------------------------------------------------
int vtkDrainageFilter::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  littoral::AnnounceParts(outputs->GetInformationObject(0)); // else each rank would be asked for the whole image
  return this->Superclass::RequestInformation(request, inputs, outputs);
}

//----------------------------------------------------------------------------
int vtkDrainageFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // Flow is not local.
  littoral::RequestAll(inputVector[0]->GetInformationObject(0));
  littoral::RequestAll(inputVector[1]->GetInformationObject(0));
  littoral::RequestAll(inputVector[2]->GetInformationObject(0));
  littoral::RequestAll(inputVector[3]->GetInformationObject(0));
  if (this->TileSize != 0)
  {
    this->AskForTile(inputVector[0]->GetInformationObject(0), outputVector->GetInformationObject(0));
  }
  return 1;
}

//----------------------------------------------------------------------------
void vtkDrainageFilter::AskForTile(vtkInformation* input, vtkInformation* output)
{
  littoral::TiledTerrain& terrain = this->Internals->Terrain;
  std::array<int, 6> whole;
  input->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole.data());
  std::vector<double> key(whole.begin(), whole.end());
  key.push_back(static_cast<double>(this->GetMTime()));
  key.push_back(static_cast<double>(littoral::PipelineTime(this, 0, 0)));
  std::exception_ptr& refusal = this->Internals->Refusal;
  if (terrain.BeginsAnew(key))
  {
    refusal = nullptr;
    try
    {
      littoral::ParameterCheck check;
      check.Count("TileSize", this->TileSize, 16, 2048);
      check.Choice("Outlets", this->Outlets, { "border", "sea", "chosen", "lowest of border", "sea alone" });
      check.Finite("SeaLevel", this->SeaLevel, "m");
      check.Require(!this->Carve, "TileSize is not 0, and Carve is on; only ground as it is drains by tiles.");
      check.Require(this->Outlets == Border || this->Outlets == Sea,
        "TileSize is not 0, and Outlets is neither Border nor Sea, which alone are known tile by tile.");
      littoral::Require(check.Reason());
      constexpr double none = -std::numeric_limits<double>::infinity();
      terrain.Begin(whole, this->TileSize, this->Outlets == Sea ? this->SeaLevel : none);
    }
    catch (const littoral::InvalidInput&)
    {
      refusal = std::current_exception();
    }
  }
  if (!refusal)
  {
    const std::array<int, 6> part = littoral::RequestedExtent(output);
    const std::array<int, 6> extent = part[1] < part[0] ? part : terrain.NextExtent(part);
    input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent.data(), 6);
  }
}

//----------------------------------------------------------------------------
int vtkDrainageFilter::RequestTiles(vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  littoral::TiledTerrain& terrain = this->Internals->Terrain;
  try
  {
    if (const std::exception_ptr refusal = this->Internals->Refusal)
    {
      std::rethrow_exception(refusal);
    }
    const std::array<int, 6> part = littoral::RequestedExtent(outputVector->GetInformationObject(0));
    if (part[1] < part[0])
    {
      return 1; // a rank with nothing to do
    }
    vtkInformation* input = inputVector[0]->GetInformationObject(0);
    const auto heights = [&](vtkImageData* image) {
      return littoral::FindHeights(
        image, this->GetInputArrayToProcess(0, inputVector), this->GetInputArrayInformation(0), "Terrain");
    };
    auto* image = littoral::InputOf<vtkImageData>(inputVector[0], "Terrain");
    while (!terrain.IsKnown())
    {
      terrain.Take(image, heights(image), littoral::PollOf(this));
      this->UpdateProgress(0.9 * terrain.Share());
      input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), terrain.NextExtent(part).data(), 6);
      if (!littoral::UpdateInputs(this, 0))
      {
        this->Internals = std::make_unique<vtkInternals>();
        return littoral::IsAborted(this) ? 1 : littoral::FailedRequest(this);
      }
      image = littoral::InputOf<vtkImageData>(inputVector[0], "Terrain");
    }
    terrain.Write(image, heights(image), part, vtkImageData::GetData(outputVector, 0), littoral::PollOf(this));
    this->UpdateProgress(1.0);
    return 1;
  }
  catch (...)
  {
    this->Internals = std::make_unique<vtkInternals>();
    throw;
  }
}

//----------------------------------------------------------------------------
void vtkDrainageFilter::ReadGround(vtkInformationVector** inputVector, Ground& ground)
{
  littoral::ParameterCheck check;
  check.Choice("Outlets", this->Outlets, { "border", "sea", "chosen", "lowest of border", "sea alone" });
  check.Choice("Method", this->Method, { "carving", "growth", "quilting" });
  check.Finite("SeaLevel", this->SeaLevel, "m");
  check.Count("StreamThreshold", this->StreamThreshold, 2, MaximumStreamThreshold);
  check.Range("HypsometricIntegral", this->HypsometricIntegral, 0.0, 1.0);
  check.Range("ElevationSkewness", this->ElevationSkewness, -2.0, 2.0);
  check.Range("Concavity", this->Concavity, 0.0, 1.0);
  check.Count("MaximumNumberOfIterations", this->MaximumNumberOfIterations, 1, 100);
  check.Range("ChannelThreshold", this->ChannelThreshold, 1.0, MaximumChannelThreshold);
  check.Range("ValleyWidth", this->ValleyWidth, 0.5, 50.0, "cells");
  littoral::Require(check.Reason());
  auto* image = littoral::InputOf<vtkImageData>(inputVector[0], "Terrain");
  auto* given = littoral::OptionalInputOf<vtkPolyData>(inputVector[3], "Given");
  const bool grows = this->Carve && this->Method == Growth;
  constexpr std::array<double (*)(int, int), 3> works{ &littoral::CarvingMemory, &littoral::GrowthMemory,
    &littoral::QuiltMemory };
  const double cells = std::max(1.0, static_cast<double>(image->GetNumberOfPoints()));
  const double more = (this->UseRock ? RockBytesACell : 0.0) + (given ? littoral::MemoryOfGiven(given) / cells : 0.0);
  const littoral::Poll poll = littoral::PollOf(this);
  ground.Heights =
    littoral::ReadHeights(image, this->GetInputArrayToProcess(0, inputVector), this->GetInputArrayInformation(0),
      "Terrain", MemoryOf(image, this->Carve ? works[this->Method] : nullptr, grows ? more : 0.0), poll);
  ground.Outlets = OutletsOf(this->Outlets, this->SeaLevel, image, ground.Heights);
  poll();
  const littoral::OutletMask outlets = ground.Outlets.Of(ground.Heights);
  poll();
  littoral::Require(littoral::WhyUndrainable(ground.Heights, outlets, poll));
  poll();
  littoral::RequireRelief(ground.Heights, "Terrain");
  poll();
}

//----------------------------------------------------------------------------
void vtkDrainageFilter::CarveGround(vtkInformationVector** inputVector, Ground& ground)
{
  const littoral::Poll poll = littoral::PollOf(this);
  littoral::TargetStatistics numbers;
  numbers.KeepsHypsometry = this->KeepHypsometry;
  numbers.HypsometricIntegral = this->HypsometricIntegral;
  numbers.ElevationSkewness = this->ElevationSkewness;
  numbers.Concavity = this->Concavity;
  littoral::CarvingParameters parameters;
  parameters.Outlets = ground.Outlets;
  parameters.MaximumIterations = this->MaximumNumberOfIterations;
  parameters.ChannelThreshold = this->ChannelThreshold;
  parameters.ValleyWidth = this->ValleyWidth;
  parameters.Seed = this->Seed;
  littoral::Require(littoral::WhyInvalid(ground.Heights, parameters));
  auto* target = littoral::OptionalInputOf<vtkImageData>(inputVector[1], "Target");
  auto* statistics = littoral::OptionalInputOf<vtkTable>(inputVector[2], "Statistics");
  littoral::Require(
    target && statistics ? "Target and Statistics both tell what it shall be like; disconnect one of them." : "");
  littoral::GridSamples place;
  if (target)
  {
    place = ReadTarget(target, this->GetInputArrayInformation(0), &littoral::CarvingMemory, poll);
    littoral::InContext("The target is of no use. ", [&] { littoral::Require(littoral::WhyNoTarget(place)); });
  }
  else
  {
    if (statistics)
    {
      TakeStatistics(statistics, numbers);
    }
    littoral::Require(littoral::WhyInvalid(numbers));
  }
  const littoral::ParallelFor parallel = littoral::AbortableFor(this);
  const littoral::CarvingTarget goal = target ? littoral::TargetOf(place, {}, parallel)
                                              : littoral::TargetOf(ground.Heights, numbers, ground.Outlets, parallel);
  ground.Report = littoral::CarveAround(ground.Heights, goal, parameters, parallel, ProgressOf(this, poll));
}

//----------------------------------------------------------------------------
void vtkDrainageFilter::GrowGround(vtkInformationVector** inputVector, Ground& ground)
{
  const littoral::Poll poll = littoral::PollOf(this);
  auto* target = littoral::OptionalInputOf<vtkImageData>(inputVector[1], "Target");
  littoral::Require(target ? "" : "There is no Target; connect a measured terrain whose kind shall grow.");
  littoral::Require(
    this->Outlets == Border ? "" : "Outlets is not Border; landscapes grow with water leaving over all of it.");
  littoral::GrowthParameters parameters;
  parameters.MaximumIterations = std::min(this->MaximumNumberOfIterations, MaximumGrowthIterations);
  parameters.Seed = this->Seed;
  if (this->UseRock)
  {
    parameters.Rock = RockOf(littoral::InputOf<vtkImageData>(inputVector[0], "Terrain"));
  }
  if (auto* given = littoral::OptionalInputOf<vtkPolyData>(inputVector[3], "Given"))
  {
    parameters.Given = littoral::ReadGiven(given, littoral::InputOf<vtkImageData>(inputVector[0], "Terrain"),
      this->GetInputArrayInformation(0)->Get(vtkDataObject::FIELD_NAME()), this->UseLineHeights);
  }
  littoral::Require(littoral::WhyInvalid(ground.Heights, parameters));
  const littoral::GridSamples place =
    ReadTarget(target, this->GetInputArrayInformation(0), &littoral::GrowthMemory, poll);
  littoral::InContext("The target is of no use. ", [&] {
    littoral::Require(littoral::WhyNoTarget(place));
    littoral::Require(littoral::WhyNoPlace(place));
  });
  ground.Report =
    littoral::GrowLandscape(ground.Heights, place, parameters, littoral::AbortableFor(this), ProgressOf(this, poll));
}

//----------------------------------------------------------------------------
void vtkDrainageFilter::QuiltGround(vtkInformationVector** inputVector, Ground& ground)
{
  const littoral::Poll poll = littoral::PollOf(this);
  auto* target = littoral::OptionalInputOf<vtkImageData>(inputVector[1], "Target");
  littoral::Require(target ? "" : "There is no Target; connect a measured terrain of whose pieces it shall be.");
  littoral::Require(
    this->Outlets == Border ? "" : "Outlets is not Border; water leaves landscapes of pieces over all of it.");
  const littoral::GridSamples place =
    ReadTarget(target, this->GetInputArrayInformation(0), &littoral::QuiltMemory, poll);
  littoral::InContext("The target is of no use. ", [&] {
    littoral::Require(littoral::WhyNoTarget(place));
    littoral::Require(littoral::WhyNoPlace(place));
  });
  littoral::Require(littoral::WhyNoQuilt(ground.Heights, place));
  ground.Report =
    littoral::QuiltLandscape(ground.Heights, place, this->Seed, littoral::AbortableFor(this), ProgressOf(this, poll));
}

//----------------------------------------------------------------------------
void vtkDrainageFilter::WriteGround(vtkImageData* image, const Ground& ground, vtkImageData* output)
{
  const littoral::Poll poll = littoral::PollOf(this);
  littoral::SteppedPoll steps(poll, 1 << 16);
  const littoral::CellLattice lattice(ground.Heights);
  const vtkIdType count = lattice.Count();
  const auto elevations = littoral::NewArray<vtkDoubleArray>("Elevation", 1, count);
  const auto areas = littoral::NewArray<vtkDoubleArray>("DrainageArea", 1, count);
  const auto directions = littoral::NewArray<vtkSignedCharArray>("FlowDirection", 1, count);
  const auto orders = littoral::NewArray<vtkUnsignedCharArray>("StreamOrder", 1, count);
  const auto depths = littoral::NewArray<vtkDoubleArray>("DepressionDepth", 1, count);
  for (littoral::CellIndex cell = 0; cell < count; ++cell)
  {
    steps.Step();
    elevations->SetValue(cell, ground.Heights.Values[cell]);
    const bool isOutside = std::isnan(ground.Heights.Values[cell]);
    areas->SetValue(cell, isOutside ? ground.Heights.Values[cell] : ground.Cells[cell] * lattice.CellArea());
    directions->SetValue(cell, static_cast<signed char>(lattice.DirectionTo(cell, ground.Routing.Receiver[cell])));
    orders->SetValue(cell, static_cast<unsigned char>(ground.Streams.Orders[cell]));
    depths->SetValue(cell, ground.Levels[cell] - ground.Heights.Values[cell]);
  }
  output->ShallowCopy(image);
  vtkPointData* points = output->GetPointData();
  points->AddArray(elevations);
  points->AddArray(areas);
  points->AddArray(directions);
  points->AddArray(orders);
  points->AddArray(depths);
  points->SetActiveScalars("Elevation");
}

//----------------------------------------------------------------------------
int vtkDrainageFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  littoral::ForgetExtent(info);
  vtkImageData* output = vtkImageData::GetData(outputVector, 0);
  vtkPolyData* rivers = vtkPolyData::GetData(outputVector, 1);
  output->Initialize();
  rivers->Initialize();
  this->SetProgressText("Draining the terrain");
  if (this->TileSize != 0)
  {
    int done = 0;
    littoral::InContext("Cannot drain a terrain: ", [&] { done = this->RequestTiles(inputVector, outputVector); });
    return done;
  }
  const littoral::Poll poll = littoral::PollOf(this);
  Ground ground;
  littoral::InContext("Cannot drain a terrain: ", [&] { this->ReadGround(inputVector, ground); });
  if (this->Carve && this->Method == Growth)
  {
    littoral::InContext("Cannot grow a landscape: ", [&] { this->GrowGround(inputVector, ground); });
  }
  else if (this->Carve && this->Method == Quilting)
  {
    littoral::InContext("Cannot quilt a landscape: ", [&] { this->QuiltGround(inputVector, ground); });
  }
  else if (this->Carve)
  {
    littoral::InContext("Cannot carve a terrain: ", [&] { this->CarveGround(inputVector, ground); });
  }
  auto* image = littoral::InputOf<vtkImageData>(inputVector[0], "Terrain");
  poll();
  const littoral::OutletMask outlets = ground.Outlets.Of(ground.Heights);
  poll();
  if (!this->Carve)
  {
    ground.Report.Before = ground.Report.After =
      littoral::MeasureGround(ground.Heights, outlets, littoral::AbortableFor(this), poll);
  }
  this->UpdateProgress(0.9);
  ground.Routing =
    littoral::RouteFlow(ground.Heights, outlets, littoral::AbortableFor(this), poll, littoral::FlatWays::Shortest);
  ground.Cells = littoral::FlowAccumulation(ground.Routing, poll);
  ground.Streams = littoral::FindStreams(ground.Heights, ground.Routing, ground.Cells, this->StreamThreshold, poll);
  ground.Levels = ground.Routing.DepressionCells == 0
    ? ground.Heights.Values
    : littoral::FloodDepressions(ground.Heights, outlets, poll).SpillElevation;
  this->UpdateProgress(0.95);
  this->WriteGround(image, ground, output);
  if (!littoral::AsksForLaterPiece(request, outputVector))
  {
    littoral::WriteRivers(image, ground.Heights, ground.Cells, ground.Streams.Rivers, rivers, poll);
  }
  for (vtkDataObject* data : { static_cast<vtkDataObject*>(output), static_cast<vtkDataObject*>(rivers) })
  {
    AddReport(ground.Report, data);
  }
  std::array<int, 6> extent = littoral::RequestedExtent(info);
  output->Crop(extent.data());
  this->UpdateProgress(1.0);
  return 1;
}

//----------------------------------------------------------------------------
int vtkDrainageFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return littoral::WithoutExceptions(
    this, request, outputs, [&] { return this->Superclass::ProcessRequest(request, inputs, outputs); });
}

//----------------------------------------------------------------------------
void vtkDrainageFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Outlets: " << this->Outlets << "\n";
  os << indent << "SeaLevel: " << this->SeaLevel << "\n";
  os << indent << "StreamThreshold: " << this->StreamThreshold << "\n";
  os << indent << "Carve: " << (this->Carve ? "on" : "off") << "\n";
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "UseRock: " << (this->UseRock ? "on" : "off") << "\n";
  os << indent << "UseLineHeights: " << (this->UseLineHeights ? "on" : "off") << "\n";
  os << indent << "KeepHypsometry: " << (this->KeepHypsometry ? "on" : "off") << "\n";
  os << indent << "HypsometricIntegral: " << this->HypsometricIntegral << "\n";
  os << indent << "ElevationSkewness: " << this->ElevationSkewness << "\n";
  os << indent << "Concavity: " << this->Concavity << "\n";
  os << indent << "MaximumNumberOfIterations: " << this->MaximumNumberOfIterations << "\n";
  os << indent << "ChannelThreshold: " << this->ChannelThreshold << "\n";
  os << indent << "ValleyWidth: " << this->ValleyWidth << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "TileSize: " << this->TileSize << "\n";
}
