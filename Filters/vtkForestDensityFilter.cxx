// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkForestDensityFilter.h"

#include "Data/Arrays.h"
#include "Data/Inputs.h"
#include "Data/StandFoliage.h"
#include "Data/Tables.h"
#include "Numerics/Constants.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/Pipeline.h"
#include "Pipeline/RankTeam.h"
#include "Pipeline/SharedParts.h"
#include "Plants/GapFraction.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTimeStamp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkForestDensityFilter);

namespace
{

constexpr int StandPort = 0;
constexpr int GridPort = 1;
// The inputs in the words of the panel.
constexpr const char* StandInput = "Stand";
constexpr const char* GridInput = "Grid";
constexpr double BytesOfOutput = 4.0;
constexpr double Degree = littoral::Pi / 180.0;
constexpr int SmallestAngle = 0;
constexpr int LargestAngle = 85;
constexpr int StepOfAngles = 5;
constexpr std::size_t RowsAtOnce = 64;
constexpr std::size_t CellsAtOnce = 65536;
constexpr int PortOfCrowns = 3;
constexpr double MostCellsAlong = 100000.0;

/// Leaf and plant area [m2] and leaf mass [kg] of a layer, or of all of them.
struct Layer
{
  double Height = 0.0;
  double Leaf = 0.0;
  double Plant = 0.0;
  double Mass = 0.0;
};

/// An angle to the vertical, and what is seen along it.
struct Gap
{
  double Angle = 0.0;
  double Projection = 0.0;
  double Fraction = 0.0;
  double Random = 0.0;
};

/// Adds a cell array of the cells in an extent of points.
template <typename AmountOf>
void AddDensity(vtkImageData* output, const int first[3], const littoral::CanopyGrid& grid, const std::string& name,
  const littoral::ParallelFor& parallel, const AmountOf& amountOf)
{
  auto density = littoral::NewArray<vtkFloatArray>(name.c_str(), 1, output->GetNumberOfCells());
  float* to = density->GetPointer(0);
  const int* extent = output->GetExtent();
  int begin[3];
  int end[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    // an extent of one point along an axis has the cells above it, or below it at the end
    begin[axis] = std::min(extent[2 * axis] - first[axis], grid.Count[axis] - 1);
    end[axis] = std::max(begin[axis] + 1, extent[2 * axis + 1] - first[axis]);
  }
  const double volume = grid.CellVolume();
  const std::size_t rows = static_cast<std::size_t>(end[1]) - begin[1];
  const std::size_t columns = static_cast<std::size_t>(end[0]) - begin[0];
  const std::size_t layers = static_cast<std::size_t>(end[2]) - begin[2];
  littoral::ForRanges(parallel, rows * layers, RowsAtOnce, [&](std::size_t from, std::size_t last) {
    for (std::size_t row = from; row < last; ++row)
    {
      const std::size_t cell =
        grid.IndexOf(begin[0], begin[1] + static_cast<int>(row % rows), begin[2] + static_cast<int>(row / rows));
      for (std::size_t column = 0; column < columns; ++column)
      {
        to[row * columns + column] = static_cast<float>(amountOf(cell + column) / volume);
      }
    }
  });
  output->GetCellData()->AddArray(density);
}

/// Layers of a grid, the highest first; ranks that have the same grid share them.
std::vector<Layer> LayersOf(
  const littoral::CanopyDensity& density, const littoral::ParallelFor& parallel, const littoral::WorkShare& share)
{
  const littoral::CanopyGrid& grid = density.GetGrid();
  const std::size_t cells = static_cast<std::size_t>(grid.Count[0]) * grid.Count[1];
  const auto count = static_cast<std::size_t>(grid.Count[2]);
  littoral::NumberRows sums(count);
  parallel(share.OwnOf(count), [&](std::size_t begin, std::size_t end) {
    for (std::size_t own = begin; own < end; ++own)
    {
      const std::size_t k = share.RowOf(own);
      std::vector<double>& layer = sums[k] = { 0.0, 0.0, 0.0 };
      for (std::size_t cell = k * cells; cell < (k + 1) * cells; ++cell)
      {
        const double leaf = density.LeafArea(cell);
        layer[0] += leaf;
        layer[1] += leaf + density.WoodArea(cell);
        layer[2] += density.LeafMass(cell);
      }
    }
  });
  share.Complete(sums);
  std::vector<Layer> layers;
  for (std::size_t k = count; k-- > 0;)
  {
    const double height = grid.Origin.z + (static_cast<double>(k) + 0.5) * grid.Spacing.z;
    layers.push_back({ height, sums[k][0], sums[k][1], sums[k][2] });
  }
  return layers;
}

/// Rows of the table of angles; ranks that have the same grid share the lines.
std::vector<Gap> GapsOf(const littoral::CanopyDensity& density, const littoral::LeafInclination& inclination,
  double leafArea, const littoral::ParallelFor& parallel, const littoral::WorkShare& share)
{
  const littoral::CanopyGrid& grid = density.GetGrid();
  std::vector<float> leaves(grid.NumberOfCells());
  littoral::ForRanges(parallel, leaves.size(), CellsAtOnce, [&](std::size_t begin, std::size_t end) {
    for (std::size_t cell = begin; cell < end; ++cell)
    {
      leaves[cell] = static_cast<float>(density.LeafArea(cell) / grid.CellVolume());
    }
  });
  std::vector<Gap> gaps;
  for (int angle = SmallestAngle; angle <= LargestAngle; angle += StepOfAngles)
  {
    const double zenith = angle * Degree;
    const double projection = inclination.Projection(zenith);
    // P = exp(-G LAI / cos t)
    const double random = std::exp(-projection * leafArea / grid.FootArea() / std::cos(zenith));
    const double fraction = littoral::GapFraction(grid, leaves.data(), zenith, projection, parallel, share);
    gaps.push_back({ static_cast<double>(angle), projection, fraction, random });
  }
  return gaps;
}

void WriteProfile(const littoral::CanopyGrid& grid, const std::vector<Layer>& layers, vtkTable* table)
{
  const double volume = grid.FootArea() * grid.Spacing.z;
  littoral::AddColumn(table, "Height", layers, [](const Layer& layer) { return layer.Height; });
  littoral::AddColumn(table, "LeafAreaDensity", layers, [&](const Layer& layer) { return layer.Leaf / volume; });
  littoral::AddColumn(table, "PlantAreaDensity", layers, [&](const Layer& layer) { return layer.Plant / volume; });
  double sum = 0.0;
  littoral::AddColumn(table, "CumulativeLeafArea", layers, [&](const Layer& layer) {
    sum += layer.Leaf;
    return sum / grid.FootArea();
  });
}

void WriteGaps(const std::vector<Gap>& gaps, vtkTable* table)
{
  littoral::AddColumn(table, "ZenithAngle", gaps, [](const Gap& gap) { return gap.Angle; });
  littoral::AddColumn(table, "Projection", gaps, [](const Gap& gap) { return gap.Projection; });
  littoral::AddColumn(table, "GapFraction", gaps, [](const Gap& gap) { return gap.Fraction; });
  littoral::AddColumn(table, "RandomGapFraction", gaps, [](const Gap& gap) { return gap.Random; });
  littoral::AddColumn(table, "Clumping", gaps, [](const Gap& gap) {
    return gap.Random < 1.0 && gap.Fraction > 0.0 ? std::log(gap.Fraction) / std::log(gap.Random) : 1.0;
  });
}

void WriteCrowns(const std::vector<littoral::StandCrown>& crowns, vtkPolyData* output)
{
  using Crown = littoral::StandCrown;
  const auto count = static_cast<vtkIdType>(crowns.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType n = 0; n < count; ++n)
  {
    const littoral::Vector3& foot = crowns[static_cast<std::size_t>(n)].Foot;
    points->InsertNextPoint(foot.x, foot.y, foot.z);
    vertices->InsertNextCell(1, &n);
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
  const auto add = [&](const char* name, const auto& valueOf) {
    auto array = littoral::NewArray<vtkDoubleArray>(name, 1, count);
    std::transform(crowns.begin(), crowns.end(), array->GetPointer(0), valueOf);
    output->GetPointData()->AddArray(array);
  };
  add("Height", [](const Crown& crown) { return crown.Height; });
  add("CrownDiameter", [](const Crown& crown) { return crown.Diameter; });
  add("LeafArea", [](const Crown& crown) { return crown.LeafArea; });
  add("LeafAreaIndex", [](const Crown& crown) {
    const double foot = 0.25 * littoral::Pi * crown.Diameter * crown.Diameter;
    return foot > 0.0 ? crown.LeafArea / foot : 0.0;
  });
  add("MaximumHeight", [](const Crown& crown) { return crown.MaximumHeight; });
  const auto addNumbers = [&](const char* name, int Crown::*number) {
    auto array = littoral::NewArray<vtkIntArray>(name, 1, count);
    std::transform(
      crowns.begin(), crowns.end(), array->GetPointer(0), [number](const Crown& crown) { return crown.*number; });
    output->GetPointData()->AddArray(array);
  };
  addNumbers("Species", &Crown::Kind);
  addNumbers("PlantId", &Crown::Plant);
}

int PortOf(vtkInformation* request)
{
  return std::max(0, request->Get(vtkExecutive::FROM_OUTPUT_PORT()));
}

/// The piece that is asked of an output, and their number.
std::array<int, 2> PieceOf(vtkInformation* output)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  return { output->Get(Pipeline::UPDATE_PIECE_NUMBER()), output->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) };
}

/// Whether ranks that are asked for a piece each can have a part of the plants each.
bool MayShare(vtkInformation* request, vtkInformation* stand, vtkInformationVector* outputs)
{
  return !littoral::RankTeam(request, outputs, true).IsAlone() &&
    littoral::ComesInParts(stand, littoral::PartForm::Instances);
}

/// Names of the species and their leaves.
void WriteKinds(const std::vector<littoral::StandKind>& kinds, vtkDataObject* output)
{
  vtkNew<vtkStringArray> names;
  names->SetName("SpeciesNames");
  auto masses = littoral::NewArray<vtkDoubleArray>("LeafMassPerArea", 1, static_cast<vtkIdType>(kinds.size()));
  for (std::size_t kind = 0; kind < kinds.size(); ++kind)
  {
    names->InsertNextValue(kinds[kind].Name);
    masses->SetValue(static_cast<vtkIdType>(kind), kinds[kind].Traits.MassPerArea);
  }
  output->GetFieldData()->AddArray(names);
  output->GetFieldData()->AddArray(masses);
}

}

//----------------------------------------------------------------------------
/// The cells of the output, and the index of its first point.
struct vtkForestDensityFilter::Frame
{
  littoral::CanopyGrid Grid;
  int First[3] = { 0, 0, 0 };

  std::array<int, 6> Whole() const
  {
    return { First[0], First[0] + Grid.Count[0], First[1], First[1] + Grid.Count[1], First[2],
      First[2] + Grid.Count[2] };
  }
  littoral::Vector3 Origin() const
  {
    return Grid.Origin - Grid.Spacing * littoral::Vector3(First[0], First[1], First[2]);
  }
};

//----------------------------------------------------------------------------
/// A stand in cells, and its tables. Ranks that have shared it keep it, so that one that is asked for another part
/// later needs no other.
class vtkForestDensityFilter::vtkInternals
{
public:
  Frame Cells;
  std::vector<littoral::StandKind> Kinds;
  std::unique_ptr<littoral::CanopyDensity> Density;
  std::vector<Layer> Layers;
  Layer Totals;
  std::vector<Gap> Gaps;
  vtkNew<vtkPolyData> Crowns;

  std::array<int, 2> Piece{ 0, 1 }; ///< whose plants the crowns are, and the number of pieces
  double Time = 0.0;
  vtkTimeStamp Made;
};

//----------------------------------------------------------------------------
vtkForestDensityFilter::vtkForestDensityFilter()
  : Bounds{ 0.0, 100.0, 0.0, 100.0, 0.0, 30.0 }
  , CellSize{ 2.0, 2.0, 2.0 }
  , BySpecies(false)
  , SpeciesNames(nullptr)
  , LeafMassPerArea(0.0)
  , Detail(Automatic)
  , LeafAreaIndex(0.0)
  , MaximumHeight(0.7)
  , HeightsAboveGround(false)
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(4);
}

//----------------------------------------------------------------------------
vtkForestDensityFilter::~vtkForestDensityFilter()
{
  this->SetSpeciesNames(nullptr);
}

//----------------------------------------------------------------------------
int vtkForestDensityFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  if (port == GridPort)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
    return 1;
  }
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkMultiBlockDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPartitionedDataSetCollection");
  return 1;
}

//----------------------------------------------------------------------------
int vtkForestDensityFilter::FillOutputPortInformation(int port, vtkInformation* info)
{
  const char* const types[] = { "vtkImageData", "vtkTable", "vtkTable", "vtkPolyData" };
  info->Set(vtkDataObject::DATA_TYPE_NAME(), types[port]);
  return 1;
}

//----------------------------------------------------------------------------
void vtkForestDensityFilter::CheckProperties() const
{
  littoral::ParameterCheck check;
  check.Range("LeafMassPerArea", this->LeafMassPerArea, 0.0, 1.0, "kg/m2");
  check.Choice("Detail", this->Detail, { "automatic", "leaves", "parcels" });
  check.Range("LeafAreaIndex", this->LeafAreaIndex, 0.0, 30.0);
  check.Range("MaximumHeight", this->MaximumHeight, 0.05, 0.95);
  littoral::Require(check.Reason());
}

//----------------------------------------------------------------------------
vtkForestDensityFilter::Frame vtkForestDensityFilter::FrameOf(vtkInformationVector* grids) const
{
  Frame frame;
  littoral::CanopyGrid& grid = frame.Grid;
  if (grids->GetNumberOfInformationObjects() > 0)
  {
    vtkInformation* info = grids->GetInformationObject(0);
    int whole[6] = { 0, -1, 0, -1, 0, -1 };
    double origin[3] = { 0.0, 0.0, 0.0 };
    info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
    info->Get(vtkDataObject::ORIGIN(), origin);
    info->Get(vtkDataObject::SPACING(), &grid.Spacing.x);
    for (int axis = 0; axis < 3; ++axis)
    {
      frame.First[axis] = whole[2 * axis];
      grid.Count[axis] = whole[2 * axis + 1] - whole[2 * axis];
      grid.Origin[axis] = origin[axis] + whole[2 * axis] * grid.Spacing[axis];
      littoral::Require(grid.Count[axis] > 0 ? "" : "Grid has no cells; it needs two points or more along each axis.");
    }
    littoral::Require(littoral::WhyInvalid(grid));
    return frame;
  }
  littoral::ParameterCheck check;
  const char* const axes[] = { "x", "y", "z" };
  for (int axis = 0; axis < 3; ++axis)
  {
    check.Positive("CellSize[" + std::to_string(axis) + "]", this->CellSize[axis], "m");
    check.Increasing(std::string("Bounds along ") + axes[axis], this->Bounds + 2 * axis, "m");
    littoral::Require(check.Reason());
    constexpr double rounding = 1e-9;
    const double side = this->Bounds[2 * axis + 1] - this->Bounds[2 * axis];
    const double count = std::ceil(side / this->CellSize[axis] - rounding);
    if (count > MostCellsAlong)
    {
      littoral::Refuse("CellSize along ", axes[axis], " is ", this->CellSize[axis],
        " m, too little for Bounds that are ", side, " m apart.");
    }
    grid.Origin[axis] = this->Bounds[2 * axis];
    grid.Spacing[axis] = this->CellSize[axis];
    grid.Count[axis] = std::max(1, static_cast<int>(count));
  }
  littoral::Require(littoral::WhyInvalid(grid));
  return frame;
}

//----------------------------------------------------------------------------
int vtkForestDensityFilter::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->CheckProperties();
  const Frame frame = this->FrameOf(inputs[GridPort]);
  vtkInformation* info = outputs->GetInformationObject(0);
  const std::array<int, 6> whole = frame.Whole();
  const littoral::Vector3 origin = frame.Origin();
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole.data(), 6);
  info->Set(vtkDataObject::ORIGIN(), &origin.x, 3);
  info->Set(vtkDataObject::SPACING(), &frame.Grid.Spacing.x, 3);
  info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  for (int port = 1; port < this->GetNumberOfOutputPorts(); ++port)
  {
    outputs->GetInformationObject(port)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  }
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    littoral::AnnounceTimesOf(this, inputs, outputs->GetInformationObject(port));
  }
  return 1;
}

//----------------------------------------------------------------------------
/// Whether what ranks have made together, after the last change, answers a request.
bool vtkForestDensityFilter::Keeps(vtkInformation* request, vtkInformationVector* outputs)
{
  const vtkMTimeType made = this->Shared ? this->Shared->Made.GetMTime() : 0;
  const int port = PortOf(request);
  vtkInformation* output = outputs->GetInformationObject(port);
  return made > this->GetMTime() && made > littoral::PipelineTime(this, StandPort, 0) &&
    made > littoral::PipelineTime(this, GridPort, 0) && this->Shared->Time == littoral::RequestedTime(output) &&
    (port != PortOfCrowns || this->Shared->Piece == PieceOf(output));
}

//----------------------------------------------------------------------------
int vtkForestDensityFilter::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  for (const int port : { StandPort, GridPort })
  {
    littoral::RequestAll(inputs[port]->GetInformationObject(0));
  }
  vtkInformation* stand = inputs[StandPort]->GetInformationObject(0);
  if (this->Keeps(request, outputs))
  {
    littoral::RequestNoOtherPart(stand);
  }
  else if (MayShare(request, stand, outputs))
  {
    littoral::RequestSamePart(stand, outputs->GetInformationObject(PortOf(request)));
  }
  return 1;
}

//----------------------------------------------------------------------------
/// Counts the plants of the input, and on ranks that share them those of the others.
std::unique_ptr<vtkForestDensityFilter::vtkInternals> vtkForestDensityFilter::Measure(
  vtkInformationVector** inputs, const littoral::WorkShare& share, bool hasTables)
{
  if (auto* image = littoral::OptionalInputOf<vtkImageData>(inputs[GridPort], GridInput))
  {
    littoral::RequireUpright(image, GridInput);
  }
  auto result = std::make_unique<vtkInternals>();
  vtkInternals& made = *result;
  made.Cells = this->FrameOf(inputs[GridPort]);
  const littoral::CanopyGrid& grid = made.Cells.Grid;
  const littoral::StandOptions options{ this->SpeciesNames ? this->SpeciesNames : "", this->LeafMassPerArea,
    static_cast<littoral::FoliageDetail>(this->Detail), this->LeafAreaIndex, this->MaximumHeight,
    this->HeightsAboveGround };
  this->SetProgressText("Reading leaves");
  const std::unique_ptr<littoral::StandFoliage> stand =
    littoral::ReadStand(vtkDataObject::GetData(inputs[StandPort]), StandInput, options, share);
  this->UpdateProgress(0.2);

  made.Kinds = stand->Kinds();
  std::vector<double> masses;
  for (const littoral::StandKind& kind : made.Kinds)
  {
    masses.push_back(kind.Traits.MassPerArea);
  }
  const double arrays = 4.0 + (this->BySpecies ? static_cast<double>(masses.size()) : 0.0);
  littoral::RequireMemory(littoral::CanopyDensity::BytesOf(grid, masses, this->BySpecies) +
      arrays * BytesOfOutput * static_cast<double>(grid.NumberOfCells()),
    "a density of " + littoral::TextOf(static_cast<double>(grid.NumberOfCells())) + " cells", "take a larger CellSize");
  made.Density = std::make_unique<littoral::CanopyDensity>(grid, masses, this->BySpecies);
  littoral::LeafInclination inclination;
  this->SetProgressText("Counting leaves");
  stand->AddTo(*made.Density, inclination, littoral::AbortableFor(this, 0.2, 0.8));

  const littoral::ParallelFor parallel = littoral::AbortableFor(this);
  made.Layers = LayersOf(*made.Density, parallel, share);
  for (const Layer& layer : made.Layers)
  {
    made.Totals.Leaf += layer.Leaf;
    made.Totals.Mass += layer.Mass;
  }
  littoral::Require(made.Totals.Leaf > 0.0 ? "" : "all of the stand is outside of the image; set Bounds.");
  if (hasTables)
  {
    made.Gaps = GapsOf(*made.Density, inclination, made.Totals.Leaf, parallel, share);
    WriteCrowns(stand->Crowns(), made.Crowns);
  }
  this->UpdateProgress(0.85);
  return result;
}

//----------------------------------------------------------------------------
/// The same on ranks that each have a part of the plants, or all of them where something else upstream needs them all.
std::unique_ptr<vtkForestDensityFilter::vtkInternals> vtkForestDensityFilter::MeasureShared(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  std::unique_ptr<vtkInternals> made;
  littoral::RankTeam team(request, outputs, true);
  team.Run([&] {
    const bool isPart = littoral::IsPart(inputs[StandPort]->GetInformationObject(0), littoral::PartForm::Instances);
    team.Agree(isPart ? 1 : 0);
    littoral::Require(
      isPart && !team.IsSharing() ? "not all ranks have a part of the plants; update all of them." : "");
    made = this->Measure(inputs, team.Share(), team.IsSharing() || team.IsFirst());
  });
  if (team.IsSharing())
  {
    vtkInformation* output = outputs->GetInformationObject(PortOf(request));
    made->Piece = PieceOf(output);
    made->Time = littoral::RequestedTime(output);
    made->Made.Modified();
    this->Shared = std::move(made);
  }
  return made;
}

//----------------------------------------------------------------------------
void vtkForestDensityFilter::Write(const vtkInternals& made, vtkInformationVector* outputs, bool hasTables)
{
  const littoral::CanopyDensity& density = *made.Density;
  const littoral::CanopyGrid& grid = made.Cells.Grid;
  const int* first = made.Cells.First;
  const littoral::ParallelFor parallel = littoral::AbortableFor(this);
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    // without that of the stand, which has a value a plant
    vtkDataObject::GetData(outputs->GetInformationObject(port))->GetFieldData()->Initialize();
  }
  vtkInformation* info = outputs->GetInformationObject(0);
  vtkImageData* output = vtkImageData::GetData(info);
  const std::array<int, 6> extent = littoral::RequestedExtent(info);
  output->SetExtent(extent[0], extent[1], extent[2], extent[3], extent[4], extent[5]);
  const littoral::Vector3 origin = made.Cells.Origin();
  output->SetOrigin(&origin.x);
  output->SetSpacing(&grid.Spacing.x);
  if (output->GetNumberOfPoints() > 0)
  {
    AddDensity(
      output, first, grid, "LeafAreaDensity", parallel, [&](std::size_t cell) { return density.LeafArea(cell); });
    AddDensity(output, first, grid, "PlantAreaDensity", parallel,
      [&](std::size_t cell) { return density.LeafArea(cell) + density.WoodArea(cell); });
    AddDensity(output, first, grid, "BulkDensity", parallel, [&](std::size_t cell) { return density.LeafMass(cell); });
    for (int kind = 0; this->BySpecies && kind < static_cast<int>(made.Kinds.size()); ++kind)
    {
      AddDensity(output, first, grid, "LeafAreaDensity " + made.Kinds[kind].Name, parallel,
        [&](std::size_t cell) { return density.LeafAreaOf(kind, cell); });
    }
    output->GetCellData()->SetActiveScalars("LeafAreaDensity");
  }
  if (this->HeightsAboveGround)
  {
    littoral::AddField(output, "HeightsAboveGround", { 1.0 });
  }
  littoral::AddField(output, "LeafArea", { made.Totals.Leaf });
  littoral::AddField(output, "LeafAreaOutside", { density.LeafOutside() });
  littoral::AddField(output, "LeafMass", { made.Totals.Mass });
  littoral::AddField(output, "LeafAreaIndex", { made.Totals.Leaf / grid.FootArea() });
  WriteKinds(made.Kinds, output);
  vtkInformation* crowns = outputs->GetInformationObject(PortOfCrowns);
  if (!crowns->Get(vtkDemandDrivenPipeline::DATA_NOT_GENERATED()))
  {
    vtkPolyData::GetData(crowns)->ShallowCopy(made.Crowns);
  }
  if (hasTables)
  {
    WriteProfile(grid, made.Layers, vtkTable::GetData(outputs->GetInformationObject(1)));
    WriteGaps(made.Gaps, vtkTable::GetData(outputs->GetInformationObject(2)));
  }
}

//----------------------------------------------------------------------------
int vtkForestDensityFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  littoral::ForgetExtent(info);
  vtkImageData::GetData(info)->Initialize();
  if (littoral::IsAnnouncedEmpty(info))
  {
    return littoral::FailedRequest(this);
  }
  const bool hasTables = !littoral::AsksForLaterPiece(request, outputs);
  if (this->Keeps(request, outputs))
  {
    this->Write(*this->Shared, outputs, hasTables);
    return 1;
  }
  const auto made = MayShare(request, inputs[StandPort]->GetInformationObject(0), outputs)
    ? this->MeasureShared(request, inputs, outputs)
    : this->Measure(inputs, littoral::WorkShare(), hasTables);
  this->Write(made ? *made : *this->Shared, outputs, hasTables);
  this->UpdateProgress(1.0);
  return 1;
}

//----------------------------------------------------------------------------
int vtkForestDensityFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_NOT_GENERATED()) && this->Keeps(request, outputs) &&
    this->Shared->Piece != PieceOf(outputs->GetInformationObject(PortOf(request))))
  {
    // The plants of another piece are not kept.
    outputs->GetInformationObject(PortOfCrowns)->Set(vtkDemandDrivenPipeline::DATA_NOT_GENERATED(), 1);
  }
  return littoral::WithoutExceptions(this, request, outputs,
    "Cannot measure the stand: ", [&] { return this->Superclass::ProcessRequest(request, inputs, outputs); });
}

//----------------------------------------------------------------------------
void vtkForestDensityFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Bounds:";
  for (const double bound : this->Bounds)
  {
    os << " " << bound;
  }
  os << "\n";
  os << indent << "CellSize: " << this->CellSize[0] << " " << this->CellSize[1] << " " << this->CellSize[2] << "\n";
  os << indent << "BySpecies: " << this->BySpecies << "\n";
  os << indent << "SpeciesNames: " << (this->SpeciesNames ? this->SpeciesNames : "(none)") << "\n";
  os << indent << "LeafMassPerArea: " << this->LeafMassPerArea << "\n";
  os << indent << "Detail: " << this->Detail << "\n";
  os << indent << "LeafAreaIndex: " << this->LeafAreaIndex << "\n";
  os << indent << "MaximumHeight: " << this->MaximumHeight << "\n";
  os << indent << "HeightsAboveGround: " << (this->HeightsAboveGround ? "on" : "off") << "\n";
}
