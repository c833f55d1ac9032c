// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPlantScatterFilter.h"

#include "Data/Blocks.h"
#include "Data/PlantBlocks.h"
#include "Data/PlantMerge.h"
#include "Geometry/HeightGrid.h"
#include "Geometry/SceneCells.h"
#include "Geometry/TextureAtlas.h"
#include "Numerics/Constants.h"
#include "Pipeline/Pipeline.h"
#include "Pipeline/Ranges.h"
#include "Plants/PlantScatter.h"

#include "vtkDataAssembly.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <utility>

vtkStandardNewMacro(vtkPlantScatterFilter);

namespace
{

constexpr int SitesPort = 0;
constexpr int PrototypesPort = 1;
constexpr int TerrainPort = 2;
constexpr double Degree = littoral::Pi / 180.0;
constexpr double Gigabyte = 1e9;

/// The blocks in the order of the output.
enum PartIndex
{
  SkeletonPart,
  SkinPart,
  LeavesPart,
  TrunkPart,
  CrownPart,
  LowPart,
  NumberOfParts
};

const littoral::PartKind PartKinds[NumberOfParts] = {
  { littoral::plant::High, littoral::plant::Skeleton, true, false },
  { littoral::plant::High, littoral::plant::Skin, false, false },
  { littoral::plant::High, littoral::plant::Leaves, false, true },
  { littoral::plant::Medium, littoral::plant::Trunk, false, false },
  { littoral::plant::Medium, littoral::plant::Crown, false, true },
  { littoral::plant::Low, nullptr, false, true },
};

constexpr littoral::PlantLevel LevelOfPart[NumberOfParts] = { littoral::PlantLevel::High, littoral::PlantLevel::High,
  littoral::PlantLevel::High, littoral::PlantLevel::Medium, littoral::PlantLevel::Medium, littoral::PlantLevel::Low };

/// Plants that one thread copies at a time.
constexpr std::size_t PlantsAtOnce = 64;

/// The identity of data, and of what was made of them.
using Stamp = std::pair<const void*, vtkMTimeType>;

/// When a data object or anything in it last changed.
vtkMTimeType LastChange(vtkDataObject* data)
{
  vtkMTimeType last = data->GetMTime();
  const auto add = [&](vtkDataObject* part) { last = std::max(last, part ? LastChange(part) : 0); };
  if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data))
  {
    for (unsigned int index = 0; index < blocks->GetNumberOfBlocks(); ++index)
    {
      add(blocks->GetBlock(index));
    }
  }
  else if (auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(data))
  {
    last = std::max(last, collection->GetDataAssembly() ? collection->GetDataAssembly()->GetMTime() : 0);
    for (unsigned int index = 0; index < collection->GetNumberOfPartitionedDataSets(); ++index)
    {
      add(collection->GetPartitionedDataSet(index));
    }
  }
  else if (auto* parts = vtkPartitionedDataSet::SafeDownCast(data))
  {
    for (unsigned int index = 0; index < parts->GetNumberOfPartitions(); ++index)
    {
      add(parts->GetPartitionAsDataObject(index));
    }
  }
  else
  {
    last = std::max(last, data->GetFieldData()->GetMTime());
  }
  return last;
}

Stamp StampOf(vtkDataObject* data)
{
  return { data, data ? LastChange(data) : 0 };
}

/// A block of a prototype; null if it has none.
vtkPolyData* PartOf(vtkMultiBlockDataSet* prototype, const littoral::PartKind& kind)
{
  vtkDataObject* level = littoral::FindBlock(prototype, kind.Level);
  return vtkPolyData::SafeDownCast(
    kind.Name ? littoral::FindBlock(vtkMultiBlockDataSet::SafeDownCast(level), kind.Name) : level);
}

/// Columns and rows of the picture that a block carries; 0 0 if it has none.
std::array<int, 2> TextureSizeOf(vtkPolyData* block)
{
  auto* texels =
    block ? vtkUnsignedCharArray::SafeDownCast(block->GetFieldData()->GetArray(littoral::plant::Texture)) : nullptr;
  vtkDataArray* size = block ? block->GetFieldData()->GetArray(littoral::plant::TextureSize) : nullptr;
  if (!texels || !size || texels->GetNumberOfComponents() != 4 || size->GetNumberOfValues() != 2)
  {
    return { 0, 0 };
  }
  const double columns = size->GetVariantValue(0).ToDouble();
  const double rows = size->GetVariantValue(1).ToDouble();
  return columns >= 1.0 && rows >= 1.0 && columns * rows == static_cast<double>(texels->GetNumberOfTuples())
    ? std::array<int, 2>{ static_cast<int>(columns), static_cast<int>(rows) }
    : std::array<int, 2>{ 0, 0 };
}

using Blocks = std::array<vtkPolyData*, NumberOfParts>;

/// What is wrong with the node ids of a block; empty if nothing is.
std::string WhyBadNodes(vtkPolyData* block, const char* blockName, const char* arrayName, vtkIdType nodes)
{
  vtkDataArray* ids = block ? block->GetPointData()->GetArray(arrayName) : nullptr;
  for (vtkIdType value = 0; ids && value < ids->GetNumberOfValues(); ++value)
  {
    const int components = ids->GetNumberOfComponents();
    const double id = ids->GetComponent(value / components, static_cast<int>(value % components));
    if (!(id >= -1.0 && id < static_cast<double>(nodes)))
    {
      std::ostringstream text;
      text << "its " << blockName << " has " << arrayName << " " << id << ", but Skeleton has " << nodes << " nodes";
      return text.str();
    }
  }
  return {};
}

/// What a prototype lacks; empty if nothing. A level needs a polygon, though not in each of its blocks: a bare tree has
/// no leaves.
std::string WhyInvalid(const Blocks& blocks)
{
  std::array<vtkIdType, 3> polygons{ 0, 0, 0 };
  for (int part = 0; part < NumberOfParts; ++part)
  {
    if (!blocks[part])
    {
      continue;
    }
    const bool hasLines = PartKinds[part].HasLines;
    const vtkIdType cells = hasLines ? blocks[part]->GetNumberOfLines() : blocks[part]->GetNumberOfPolys();
    if (cells != blocks[part]->GetNumberOfCells())
    {
      return std::string("its ") + (PartKinds[part].Name ? PartKinds[part].Name : PartKinds[part].Level) +
        " has cells that are not " + (hasLines ? "lines" : "polygons");
    }
    polygons[static_cast<int>(LevelOfPart[part])] += hasLines ? 0 : cells;
  }
  for (int part : { SkeletonPart, TrunkPart, LowPart })
  {
    if (polygons[static_cast<int>(LevelOfPart[part])] == 0)
    {
      return std::string("its level ") + PartKinds[part].Level + " is missing or empty";
    }
  }
  const vtkIdType nodes = blocks[SkeletonPart] ? blocks[SkeletonPart]->GetNumberOfPoints() : 0;
  std::string reason = WhyBadNodes(blocks[SkeletonPart], littoral::plant::Skeleton, littoral::plant::ParentId, nodes);
  for (int part : { SkinPart, LeavesPart })
  {
    reason =
      reason.empty() ? WhyBadNodes(blocks[part], PartKinds[part].Name, littoral::plant::JointIds, nodes) : reason;
  }
  return reason;
}

/// The cylinder that holds all levels of a prototype.
littoral::PlantExtent ExtentOf(const Blocks& blocks)
{
  littoral::PlantExtent extent;
  for (vtkPolyData* block : blocks)
  {
    for (vtkIdType point = 0; block && point < block->GetNumberOfPoints(); ++point)
    {
      double position[3];
      block->GetPoint(point, position);
      extent.Radius = std::max(extent.Radius, std::hypot(position[0], position[1]));
      extent.Low = std::min(extent.Low, position[2]);
      extent.High = std::max(extent.High, position[2]);
    }
  }
  return extent;
}

std::string TextOf(const littoral::Vector3& position)
{
  std::ostringstream text;
  text << "(" << position.x << ", " << position.y << ", " << position.z << ")";
  return text.str();
}

/// The optional arrays of the sites.
struct SiteArrays
{
  vtkDataArray* SiteId = nullptr;
  vtkDataArray* Species = nullptr;
  vtkDataArray* Scale = nullptr;
  vtkDataArray* Azimuth = nullptr;

  explicit SiteArrays(vtkPointSet* sites)
  {
    vtkPointData* arrays = sites->GetPointData();
    this->SiteId = arrays->GetArray("SiteId");
    this->Species = arrays->GetArray("Species");
    this->Scale = arrays->GetArray("Scale");
    this->Azimuth = arrays->GetArray("Azimuth");
  }
};

/// The plant at a site, on no terrain yet. False, with the reason, if a number is bad.
bool MakePlace(vtkPointSet* sites, const SiteArrays& arrays, const littoral::PlantDraws& draws, int species,
  vtkIdType site, littoral::PlantPlace& place, std::string& reason)
{
  std::ostringstream text;
  double position[3];
  sites->GetPoint(site, position);
  place.Foot = { position[0], position[1], position[2] };
  place.Site = static_cast<int>(site);
  const double drawnBy = arrays.SiteId ? arrays.SiteId->GetTuple1(site) : static_cast<double>(site);
  place.SiteId = std::isfinite(drawnBy) ? static_cast<long long>(drawnBy) : 0;
  const double kind = arrays.Species ? arrays.Species->GetTuple1(site) : draws.Species(place.SiteId);
  place.Scale = arrays.Scale ? arrays.Scale->GetTuple1(site) : draws.Scale(place.SiteId);
  place.Azimuth = arrays.Azimuth ? arrays.Azimuth->GetTuple1(site) : draws.Azimuth(place.SiteId);
  if (!littoral::IsFinite(place.Foot))
  {
    text << "site " << site << " lies at " << TextOf(place.Foot) << "; positions must be finite.";
  }
  else if (!std::isfinite(drawnBy))
  {
    text << "SiteId of site " << site << " is " << drawnBy << "; it must be finite.";
  }
  else if (!(kind >= 0.0 && kind < species && kind == std::floor(kind)))
  {
    text << "Species of site " << site << " is " << kind << "; there are prototypes 0 to " << species - 1 << ".";
  }
  else if (!(place.Scale > 0.0 && std::isfinite(place.Scale)))
  {
    text << "Scale of site " << site << " is " << place.Scale << "; it must be finite and positive.";
  }
  else if (!std::isfinite(place.Azimuth))
  {
    text << "Azimuth of site " << site << " is " << place.Azimuth << "; it must be finite.";
  }
  else
  {
    place.Species = static_cast<int>(kind);
    place.Tint = draws.Tint(place.SiteId);
    return true;
  }
  reason = text.str();
  return false;
}

/// The terrain as the numerics see it. False, with the reason, if it is none.
bool MakeGrid(vtkImageData* terrain, littoral::HeightGrid& grid, std::string& reason)
{
  vtkPointData* arrays = terrain->GetPointData();
  vtkDataArray* heights = arrays->GetArray("Elevation") ? arrays->GetArray("Elevation") : arrays->GetScalars();
  int extent[6];
  terrain->GetExtent(extent);
  if (extent[5] != extent[4] || extent[1] <= extent[0] || extent[3] <= extent[2])
  {
    reason = "the Terrain must be one layer of at least 2 x 2 points.";
    return false;
  }
  if (!heights)
  {
    reason = "the Terrain has neither a point array Elevation nor active scalars.";
    return false;
  }
  for (int axis = 0; axis < 2; ++axis)
  {
    grid.Spacing[axis] = terrain->GetSpacing()[axis];
    grid.Origin[axis] = terrain->GetOrigin()[axis] + extent[2 * axis] * grid.Spacing[axis];
    grid.Count[axis] = extent[2 * axis + 1] - extent[2 * axis] + 1;
    if (!(grid.Spacing[axis] > 0.0))
    {
      reason = "the spacing of the Terrain must be positive.";
      return false;
    }
  }
  grid.HeightOf = [heights](long long point) { return heights->GetComponent(static_cast<vtkIdType>(point), 0); };
  return true;
}

/// Sets plants on the ground and drops those that do not stand there. False, with the reason, if there is no ground.
bool PutOnGround(const littoral::HeightGrid& grid, double slopeLimit, const double heightRange[2],
  std::vector<littoral::PlantPlace>& places, std::string& reason)
{
  std::size_t kept = 0;
  std::size_t outside = 0;
  std::size_t holes = 0;
  littoral::Vector3 first{ 0.0, 0.0, 0.0 };
  for (const littoral::PlantPlace& place : places)
  {
    const littoral::GroundPoint ground = grid.At(place.Foot.x, place.Foot.y);
    const bool bad = !ground.IsCovered || !std::isfinite(ground.Height);
    if (bad)
    {
      first = outside + holes == 0 ? place.Foot : first;
      ++(ground.IsCovered ? holes : outside);
    }
    else if ((slopeLimit >= 0.5 * littoral::Pi || ground.Slope <= slopeLimit) && ground.Height >= heightRange[0] &&
      ground.Height <= heightRange[1])
    {
      const double height = ground.Height;
      places[kept] = place;
      places[kept++].Foot.z = height;
    }
  }
  if (outside + holes > 0)
  {
    std::ostringstream text;
    text << "of " << places.size() << " sites, " << outside << " lie outside of the Terrain and " << holes
         << " where it has no height; the first at " << TextOf(first) << ".";
    reason = text.str();
    return false;
  }
  places.resize(kept);
  return true;
}

/// A field array of one number a plant.
template <typename Array, typename Number>
void AddColumn(vtkFieldData* fields, const char* name, int components, std::size_t count, const Number& numberOf)
{
  const auto column = littoral::NewArray<Array>(name, components, static_cast<vtkIdType>(count));
  auto* values = column->GetPointer(0);
  for (std::size_t index = 0; index < count; ++index)
  {
    for (int component = 0; component < components; ++component)
    {
      *values++ = numberOf(index, component);
    }
  }
  fields->AddArray(column);
}

/// Bytes of the table of a plant.
constexpr double TableBytes = 60.0;

void WriteTable(
  const std::vector<littoral::PlantPlace>& places, const std::vector<littoral::ShownPlant>& shown, vtkFieldData* fields)
{
  const auto of = [&](std::size_t index) -> const littoral::PlantPlace& { return places[shown[index].Place]; };
  const std::size_t count = shown.size();
  AddColumn<vtkIntArray>(fields, littoral::plant::PlantId, 1, count, [&](auto i, int) { return of(i).Site; });
  AddColumn<vtkTypeInt64Array>(fields, "SiteId", 1, count, [&](auto i, int) { return of(i).SiteId; });
  AddColumn<vtkIntArray>(fields, "Species", 1, count, [&](auto i, int) { return of(i).Species; });
  AddColumn<vtkDoubleArray>(fields, "Scale", 1, count, [&](auto i, int) { return of(i).Scale; });
  AddColumn<vtkDoubleArray>(fields, "Azimuth", 1, count, [&](auto i, int) { return of(i).Azimuth; });
  AddColumn<vtkDoubleArray>(fields, "Position", 3, count, [&](auto i, int axis) { return of(i).Foot[axis]; });
  AddColumn<vtkIntArray>(fields, "Level", 1, count, [&](auto i, int) { return static_cast<int>(shown[i].Level); });
}

void WriteCounter(vtkFieldData* fields, const char* name, double value)
{
  AddColumn<vtkDoubleArray>(fields, name, 1, 1, [=](auto, int) { return value; });
}

}

//----------------------------------------------------------------------------
/// What does not depend on the view.
class vtkPlantScatterFilter::Memory
{
public:
  std::vector<Stamp> PrototypesStamp;
  std::vector<littoral::PlantPart> Parts;
  std::vector<littoral::PlantExtent> Extents;
  littoral::TextureImage CrownAtlas;
  littoral::TextureImage LeafAtlas;

  std::vector<Stamp> PlacesStamp;
  std::vector<double> PlacesNumbers;
  std::vector<littoral::PlantPlace> Places;
  std::unique_ptr<littoral::SceneCells> Cells;

  std::size_t NumberOfSpecies() const { return this->Extents.size(); }

  /// Polygons of a species in full.
  double HighPolygons(int species) const
  {
    return static_cast<double>(
      this->Parts[SkinPart].Meshes[species].NumberOfCells() + this->Parts[LeavesPart].Meshes[species].NumberOfCells());
  }
};

//----------------------------------------------------------------------------
/// What is asked for this time.
struct vtkPlantScatterFilter::Request
{
  std::vector<littoral::ShownPlant> Shown;
  std::vector<char> CellsShown;
  long long FirstSite = 0;
  long long EndSite = 0;
};

//----------------------------------------------------------------------------
vtkPlantScatterFilter::vtkPlantScatterFilter()
  : Seed(1)
  , ScaleVariation(0.15)
  , TintVariation(0.08)
  , SlopeLimit(90.0)
  , HeightRange{ -1e30, 1e30 }
  , UseLevels(true)
  , UseCells(true)
  , PlantsPerCell(1.0)
  , MaximumDistance(0.0)
  , Kept(std::make_unique<Memory>())
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(3);
}

//----------------------------------------------------------------------------
vtkPlantScatterFilter::~vtkPlantScatterFilter() = default;

//----------------------------------------------------------------------------
void vtkPlantScatterFilter::SetWeight(int prototype, double weight)
{
  if (prototype < 0)
  {
    vtkErrorMacro("Weight " << prototype << ": prototypes are counted from 0.");
    return;
  }
  if (this->GetWeight(prototype) != weight)
  {
    this->Weights.resize(std::max(this->Weights.size(), static_cast<std::size_t>(prototype) + 1), 1.0);
    this->Weights[prototype] = weight;
    this->Modified();
  }
}

//----------------------------------------------------------------------------
double vtkPlantScatterFilter::GetWeight(int prototype)
{
  return prototype >= 0 && prototype < static_cast<int>(this->Weights.size()) ? this->Weights[prototype] : 1.0;
}

//----------------------------------------------------------------------------
void vtkPlantScatterFilter::ClearWeights()
{
  if (!this->Weights.empty())
  {
    this->Weights.clear();
    this->Modified();
  }
}

//----------------------------------------------------------------------------
int vtkPlantScatterFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  const char* types[] = { "vtkPointSet", "vtkMultiBlockDataSet", "vtkImageData" };
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), types[port]);
  if (port == PrototypesPort)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPartitionedDataSetCollection");
    info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  }
  if (port != SitesPort)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1); // no prototypes: our own, clearer message
  }
  return 1;
}

//----------------------------------------------------------------------------
int vtkPlantScatterFilter::FillOutputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    return this->Superclass::FillOutputPortInformation(port, info);
  }
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkImageData");
  return 1;
}

//----------------------------------------------------------------------------
int vtkPlantScatterFilter::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  outputs->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  // The extents of the pictures depend on those that the prototypes carry. All of them are needed anyway.
  std::vector<std::array<int, 2>> crowns;
  std::vector<std::array<int, 2>> leaves;
  for (int index = 0; index < this->GetNumberOfInputConnections(PrototypesPort); ++index)
  {
    int port = 0;
    this->GetInputAlgorithm(PrototypesPort, index, port)->Update(port);
    std::string reason; // said when data are asked for
    const auto prototype = littoral::BlocksOf(this->GetInputDataObject(PrototypesPort, index), reason);
    crowns.push_back(TextureSizeOf(PartOf(prototype, PartKinds[CrownPart])));
    leaves.push_back(TextureSizeOf(PartOf(prototype, PartKinds[LeavesPart])));
  }
  for (int port : { 1, 2 })
  {
    const std::array<long long, 2> size = littoral::AtlasSize(port == 1 ? crowns : leaves);
    const int extent[6] = { 0, static_cast<int>(size[0]) - 1, 0, static_cast<int>(size[1]) - 1, 0, 0 };
    outputs->GetInformationObject(port)->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  }
  return 1;
}

//----------------------------------------------------------------------------
int vtkPlantScatterFilter::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
  {
    for (int index = 0; index < inputs[port]->GetNumberOfInformationObjects(); ++index)
    {
      littoral::RequestAll(inputs[port]->GetInformationObject(index));
    }
  }
  return 1;
}

//----------------------------------------------------------------------------
bool vtkPlantScatterFilter::CheckProperties()
{
  std::ostringstream text;
  if (!(this->SlopeLimit >= 0.0 && this->SlopeLimit <= 90.0))
  {
    text << "SlopeLimit is " << this->SlopeLimit << " degrees; it must be from 0 to 90.";
  }
  else if (!(this->HeightRange[0] <= this->HeightRange[1]))
  {
    text << "HeightRange is " << this->HeightRange[0] << " to " << this->HeightRange[1]
         << " m; the first must not be above the second.";
  }
  else if (!(this->PlantsPerCell > 0.0 && std::isfinite(this->PlantsPerCell)))
  {
    text << "PlantsPerCell is " << this->PlantsPerCell << "; it must be finite and positive.";
  }
  else if (!(this->MaximumDistance >= 0.0))
  {
    text << "MaximumDistance is " << this->MaximumDistance << " m; it must not be negative.";
  }
  if (!text.str().empty())
  {
    vtkErrorMacro(<< text.str());
    return false;
  }
  return true;
}

//----------------------------------------------------------------------------
bool vtkPlantScatterFilter::RememberPrototypes(vtkInformationVector* inputs)
{
  std::vector<Stamp> stamp;
  std::vector<Blocks> prototypes;
  std::vector<std::string> reasons;
  for (int index = 0; index < inputs->GetNumberOfInformationObjects(); ++index)
  {
    vtkDataObject* input = vtkDataObject::GetData(inputs, index);
    stamp.push_back(StampOf(input));
    reasons.emplace_back();
    const auto prototype = littoral::BlocksOf(input, reasons.back());
    prototypes.emplace_back();
    std::transform(std::begin(PartKinds), std::end(PartKinds), prototypes.back().begin(),
      [&](const littoral::PartKind& kind) { return PartOf(prototype, kind); });
  }
  if (!stamp.empty() && stamp == this->Kept->PrototypesStamp)
  {
    return true;
  }
  *this->Kept = Memory();
  if (prototypes.empty())
  {
    vtkErrorMacro("There are no prototypes; connect the output of at least one plant source to port 1.");
    return false;
  }
  std::vector<littoral::TextureImage> crowns;
  std::vector<littoral::TextureImage> leaves;
  for (std::size_t index = 0; index < prototypes.size(); ++index)
  {
    const std::string reason = reasons[index].empty() ? WhyInvalid(prototypes[index]) : reasons[index];
    if (!reason.empty())
    {
      vtkErrorMacro("Prototype " << index << " cannot be scattered: " << reason << ".");
      this->Kept->Extents.clear();
      return false;
    }
    this->Kept->Extents.push_back(ExtentOf(prototypes[index]));
    crowns.push_back(littoral::ReadTexture(prototypes[index][CrownPart]));
    leaves.push_back(littoral::ReadTexture(prototypes[index][LeavesPart]));
  }
  littoral::TextureAtlas crownAtlas = littoral::StackTextures(crowns);
  littoral::TextureAtlas leafAtlas = littoral::StackTextures(leaves);
  for (int part = 0; part < NumberOfParts; ++part)
  {
    std::vector<vtkPolyData*> blocks;
    for (const Blocks& prototype : prototypes)
    {
      blocks.push_back(prototype[part]);
    }
    const littoral::TextureAtlas* atlas = part == CrownPart ? &crownAtlas : part == LeavesPart ? &leafAtlas : nullptr;
    this->Kept->Parts.push_back(littoral::MakePart(PartKinds[part], blocks, atlas));
  }
  this->Kept->CrownAtlas = std::move(crownAtlas.Image);
  this->Kept->LeafAtlas = std::move(leafAtlas.Image);
  this->Kept->PrototypesStamp = stamp;
  return true;
}

//----------------------------------------------------------------------------
bool vtkPlantScatterFilter::RememberPlaces(vtkInformationVector** inputs)
{
  vtkPointSet* sites = vtkPointSet::GetData(inputs[SitesPort]);
  vtkImageData* terrain = vtkImageData::GetData(inputs[TerrainPort]);
  littoral::ScatterOptions options;
  options.Seed = this->Seed;
  options.ScaleVariation = this->ScaleVariation;
  options.TintVariation = this->TintVariation;
  const int species = static_cast<int>(this->Kept->NumberOfSpecies());
  for (int prototype = 0; prototype < species; ++prototype)
  {
    options.Weights.push_back(this->GetWeight(prototype));
  }
  const std::vector<Stamp> stamp{ StampOf(sites), StampOf(terrain) };
  std::vector<double> numbers{ static_cast<double>(this->Seed), this->ScaleVariation, this->TintVariation,
    this->SlopeLimit, this->HeightRange[0], this->HeightRange[1], this->PlantsPerCell };
  numbers.insert(numbers.end(), options.Weights.begin(), options.Weights.end());
  if (stamp == this->Kept->PlacesStamp && numbers == this->Kept->PlacesNumbers)
  {
    return true;
  }
  this->Kept->PlacesStamp.clear();
  std::string reason = littoral::WhyInvalid(options);
  const vtkIdType count = sites->GetNumberOfPoints();
  if (reason.empty() &&
    (count > std::numeric_limits<int>::max() ||
      static_cast<double>(count) * (sizeof(littoral::PlantPlace) + 2.0 * sizeof(littoral::Box)) >
        littoral::AvailableMemory()))
  {
    reason = std::to_string(count) + " sites are more than this machine has memory for.";
  }
  this->SetProgressText("Placing plants");
  std::vector<littoral::PlantPlace> places(reason.empty() ? static_cast<std::size_t>(count) : 0);
  if (reason.empty())
  {
    const SiteArrays arrays(sites);
    const littoral::PlantDraws draws(options);
    for (vtkIdType site = 0; site < count && reason.empty(); ++site)
    {
      MakePlace(sites, arrays, draws, species, site, places[site], reason);
    }
  }
  littoral::HeightGrid grid;
  if (reason.empty() && terrain && MakeGrid(terrain, grid, reason))
  {
    PutOnGround(grid, this->SlopeLimit * Degree, this->HeightRange, places, reason);
  }
  else if (reason.empty())
  {
    places.erase(std::remove_if(places.begin(), places.end(),
                   [&](const littoral::PlantPlace& place) {
                     return place.Foot.z < this->HeightRange[0] || place.Foot.z > this->HeightRange[1];
                   }),
      places.end());
  }
  if (!reason.empty())
  {
    vtkErrorMacro("Cannot scatter plants: " << reason);
    return false;
  }
  std::vector<littoral::Vector3> feet;
  std::vector<littoral::Box> boxes;
  for (const littoral::PlantPlace& place : places)
  {
    feet.push_back(place.Foot);
    boxes.push_back(littoral::BoxOf(place, this->Kept->Extents[place.Species]));
  }
  this->Kept->Places = std::move(places);
  this->Kept->Cells = std::make_unique<littoral::SceneCells>(feet, boxes, this->PlantsPerCell);
  this->Kept->PlacesStamp = stamp;
  this->Kept->PlacesNumbers = numbers;
  return true;
}

//----------------------------------------------------------------------------
int vtkPlantScatterFilter::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  littoral::View view;
  if (!this->GetView(view) || !this->CheckProperties() || !this->RememberPrototypes(inputs[PrototypesPort]) ||
    !this->RememberPlaces(inputs))
  {
    return 0;
  }
  const Memory& kept = *this->Kept;
  littoral::PlantViewOptions options;
  options.UseLevels = this->UseLevels;
  options.UseCells = this->UseCells;
  options.NearDistance = this->NearDistance;
  options.FarDistance = this->FarDistance;
  options.MaximumDistance = this->MaximumDistance;
  vtkInformation* info = outputs->GetInformationObject(0);
  const long long piece = std::max(0, info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()));
  const long long pieces = std::max(1, info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES()));
  const long long sites = vtkPointSet::GetData(inputs[SitesPort])->GetNumberOfPoints();
  Request request;
  request.FirstSite = sites * piece / pieces;
  request.EndSite = sites * (piece + 1) / pieces;
  request.CellsShown = kept.Cells->Show(littoral::ViewFrustum(view));
  request.Shown = littoral::ShownPlants(
    kept.Places, *kept.Cells, request.CellsShown, view, options, request.FirstSite, request.EndSite);
  if (!this->Merge(request, outputs))
  {
    return 0;
  }
  littoral::CopyToImage(kept.CrownAtlas, vtkImageData::GetData(outputs, 1));
  littoral::CopyToImage(kept.LeafAtlas, vtkImageData::GetData(outputs, 2));
  this->UpdateProgress(1.0);
  return 1;
}

//----------------------------------------------------------------------------
bool vtkPlantScatterFilter::Merge(const Request& request, vtkInformationVector* outputs)
{
  const Memory& kept = *this->Kept;
  std::array<std::vector<int>, 3> plants;
  for (const littoral::ShownPlant& plant : request.Shown)
  {
    plants[static_cast<int>(plant.Level)].push_back(plant.Place);
  }
  std::vector<littoral::PlantMerge> merges;
  merges.reserve(NumberOfParts);
  double bytes = TableBytes * static_cast<double>(request.Shown.size());
  for (int part = 0; part < NumberOfParts; ++part)
  {
    merges.emplace_back(kept.Parts[part], kept.Places, plants[static_cast<int>(LevelOfPart[part])]);
    bytes += merges.back().GetBytes();
  }
  const double available = littoral::AvailableMemory();
  const bool tooManyNodes = merges[SkeletonPart].GetNumberOfPoints() > std::numeric_limits<int>::max();
  if (bytes > available || tooManyNodes)
  {
    vtkErrorMacro(<< request.Shown.size() << " plants, " << plants[0].size() << " of them in full, need "
                  << bytes / Gigabyte << " GB, and " << available / Gigabyte
                  << " GB are free. Switch on UseLevels and UseCells, lower NearDistance, or set MaximumDistance.");
    return false;
  }

  this->SetProgressText("Scattering plants");
  merges[SkeletonPart].SetSkeleton(&merges[SkeletonPart]);
  merges[SkinPart].SetSkeleton(&merges[SkeletonPart]);
  merges[LeavesPart].SetSkeleton(&merges[SkeletonPart]);
  std::vector<std::pair<int, std::size_t>> jobs; // a part, and the first of some of its plants
  double polygons = 0.0;
  for (int part = 0; part < NumberOfParts; ++part)
  {
    merges[part].Allocate();
    polygons += PartKinds[part].HasLines ? 0.0 : static_cast<double>(merges[part].GetNumberOfCells());
    for (std::size_t plant = 0; plant < merges[part].GetNumberOfPlants(); plant += PlantsAtOnce)
    {
      jobs.emplace_back(part, plant);
    }
  }
  const bool done = littoral::RunWithProgress(this, jobs.size(), 0.1, 0.9, [&](std::size_t job) {
    const auto [part, plant] = jobs[job];
    merges[part].Fill(plant, std::min(plant + PlantsAtOnce, merges[part].GetNumberOfPlants()));
  });
  if (!done) // aborted
  {
    return true;
  }

  littoral::AttachTexture(merges[LeavesPart].GetOutput(), kept.LeafAtlas);
  littoral::AttachTexture(merges[CrownPart].GetOutput(), kept.CrownAtlas);
  vtkMultiBlockDataSet* output = vtkMultiBlockDataSet::GetData(outputs, 0);
  vtkNew<vtkMultiBlockDataSet> high;
  vtkNew<vtkMultiBlockDataSet> medium;
  littoral::AddBlock(output, littoral::plant::High, high);
  littoral::AddBlock(output, littoral::plant::Medium, medium);
  for (int part = 0; part < NumberOfParts; ++part)
  {
    const bool isLow = LevelOfPart[part] == littoral::PlantLevel::Low;
    vtkMultiBlockDataSet* level = isLow                 ? output
      : LevelOfPart[part] == littoral::PlantLevel::High ? high.Get()
                                                        : medium.Get();
    littoral::AddBlock(level, isLow ? PartKinds[part].Level : PartKinds[part].Name, merges[part].GetOutput());
  }

  vtkFieldData* fields = output->GetFieldData();
  WriteTable(kept.Places, request.Shown, fields);
  double plantsInAll = 0.0;
  double polygonsInAll = 0.0;
  for (const littoral::PlantPlace& place : kept.Places)
  {
    if (place.Site >= request.FirstSite && place.Site < request.EndSite)
    {
      plantsInAll += 1.0;
      polygonsInAll += kept.HighPolygons(place.Species);
    }
  }
  const auto marks = std::count(request.CellsShown.begin(), request.CellsShown.end(), 1);
  WriteCounter(fields, "PlantsInAll", plantsInAll);
  WriteCounter(fields, "PlantsShown", static_cast<double>(request.Shown.size()));
  WriteCounter(fields, "PlantsHigh", static_cast<double>(plants[0].size()));
  WriteCounter(fields, "PlantsMedium", static_cast<double>(plants[1].size()));
  WriteCounter(fields, "PlantsLow", static_cast<double>(plants[2].size()));
  WriteCounter(fields, "CellsInAll", kept.Cells->NumberOfFilled());
  WriteCounter(fields, "CellsShown", this->UseCells ? static_cast<double>(marks) : kept.Cells->NumberOfFilled());
  WriteCounter(fields, "PolygonsShown", polygons);
  WriteCounter(fields, "PolygonsInAll", polygonsInAll);
  WriteCounter(fields, "OutputBytes", bytes);
  littoral::KeepRanges(output);
  return true;
}

//----------------------------------------------------------------------------
void vtkPlantScatterFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "Weights:";
  for (double weight : this->Weights)
  {
    os << " " << weight;
  }
  os << "\n";
  os << indent << "ScaleVariation: " << this->ScaleVariation << "\n";
  os << indent << "TintVariation: " << this->TintVariation << "\n";
  os << indent << "SlopeLimit: " << this->SlopeLimit << "\n";
  os << indent << "HeightRange: " << this->HeightRange[0] << " " << this->HeightRange[1] << "\n";
  os << indent << "UseLevels: " << this->UseLevels << "\n";
  os << indent << "UseCells: " << this->UseCells << "\n";
  os << indent << "PlantsPerCell: " << this->PlantsPerCell << "\n";
  os << indent << "MaximumDistance: " << this->MaximumDistance << "\n";
}
