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
#include "Numerics/ParameterCheck.h"
#include "Pipeline/LastChange.h"
#include "Pipeline/Mistakes.h"
#include "Pipeline/Pipeline.h"
#include "Pipeline/Ranges.h"
#include "Plants/PlantScatter.h"
#include "vtkPlantSource.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationDataObjectMetaDataKey.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkPlantScatterFilter);

namespace
{

constexpr int SitesPort = 0;
constexpr int PrototypesPort = 1;
constexpr int TerrainPort = 2;
constexpr double Degree = littoral::Pi / 180.0;
constexpr double Gigabyte = 1e9;
/// More prototypes than this have no weight of their own.
constexpr int MostWeights = 1000000;

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

/// A block of a prototype; null if it has none.
vtkPolyData* PartOf(vtkMultiBlockDataSet* prototype, const littoral::PartKind& kind)
{
  vtkDataObject* level = littoral::FindBlock(prototype, kind.Level);
  return vtkPolyData::SafeDownCast(
    kind.Name ? littoral::FindBlock(vtkMultiBlockDataSet::SafeDownCast(level), kind.Name) : level);
}

using TextureSize = std::array<int, 2>;

/// Columns and rows in an array of two numbers; 0 0 if it has others.
TextureSize TextureSizeOf(vtkDataArray* size)
{
  if (!size || size->GetNumberOfValues() != 2)
  {
    return { 0, 0 };
  }
  const double columns = size->GetVariantValue(0).ToDouble();
  const double rows = size->GetVariantValue(1).ToDouble();
  return columns >= 1.0 && rows >= 1.0 && columns * rows <= std::numeric_limits<int>::max()
    ? TextureSize{ static_cast<int>(columns), static_cast<int>(rows) }
    : TextureSize{ 0, 0 };
}

/// Columns and rows of the texture that a block carries; 0 0 if it has none.
TextureSize TextureSizeOf(vtkPolyData* block)
{
  auto* texels =
    block ? vtkUnsignedCharArray::SafeDownCast(block->GetFieldData()->GetArray(littoral::plant::Texture)) : nullptr;
  if (!texels || texels->GetNumberOfComponents() != 4)
  {
    return { 0, 0 };
  }
  const TextureSize size = TextureSizeOf(block->GetFieldData()->GetArray(littoral::plant::TextureSize));
  const double values = static_cast<double>(size[0]) * size[1];
  return values == static_cast<double>(texels->GetNumberOfTuples()) ? size : TextureSize{ 0, 0 };
}

/// Sizes of the textures of crown and leaves.
struct PrototypeTextures
{
  TextureSize Crown;
  TextureSize Leaves;
};

/// The sizes that a prototype will have when its source has executed: of its data if they are up to date, else those
/// that the source announces; where none are announced, of the data as they are.
PrototypeTextures ExpectedTextures(vtkInformation* input, vtkMTimeType lastUpstreamChange)
{
  vtkDataObject* data = vtkDataObject::GetData(input);
  vtkDataObject* announced = input->Get(vtkPlantSource::TEXTURE_SIZES());
  if (announced && !(data && data->GetUpdateTime() > lastUpstreamChange))
  {
    vtkFieldData* sizes = announced->GetFieldData();
    return { TextureSizeOf(sizes->GetArray(littoral::plant::Crown)),
      TextureSizeOf(sizes->GetArray(littoral::plant::Leaves)) };
  }
  std::string reason; // said when data are asked for
  const auto prototype = littoral::BlocksOf(data, reason);
  return { TextureSizeOf(PartOf(prototype, PartKinds[CrownPart])),
    TextureSizeOf(PartOf(prototype, PartKinds[LeavesPart])) };
}

/// Announces the size of an image.
void SetWholeExtent(vtkInformation* output, const std::array<long long, 2>& size)
{
  const int extent[6] = { 0, static_cast<int>(size[0]) - 1, 0, static_cast<int>(size[1]) - 1, 0, 0 };
  output->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
}

/// Writes a texture, and corrects the size that was announced if the prototypes turned out to have others.
void WriteTexture(const littoral::TextureImage& texture, vtkInformation* output)
{
  littoral::CopyToImage(texture, vtkImageData::GetData(output));
  SetWholeExtent(output, { texture.Columns, texture.Rows });
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

/// What is wrong with the cells of a block; empty if nothing is.
std::string WhyBadCells(vtkPolyData* block, const littoral::PartKind& kind)
{
  const vtkIdType cells = kind.HasLines ? block->GetNumberOfLines() : block->GetNumberOfPolys();
  return cells == block->GetNumberOfCells() ? std::string()
                                            : std::string("its ") + (kind.Name ? kind.Name : kind.Level) +
      " has cells that are not " + (kind.HasLines ? "lines" : "polygons");
}

/// What a prototype lacks; empty if nothing. A level needs a polygon, though not in each of its blocks: a bare tree has
/// no leaves.
std::string WhyInvalid(const Blocks& blocks)
{
  std::array<vtkIdType, 3> polygons{ 0, 0, 0 };
  std::string reason;
  for (int part = 0; part < NumberOfParts && reason.empty(); ++part)
  {
    if (blocks[part])
    {
      reason = WhyBadCells(blocks[part], PartKinds[part]);
      polygons[static_cast<int>(LevelOfPart[part])] += blocks[part]->GetNumberOfPolys();
    }
  }
  for (int part : { SkeletonPart, TrunkPart, LowPart })
  {
    if (reason.empty() && polygons[static_cast<int>(LevelOfPart[part])] == 0)
    {
      reason = std::string("its level ") + PartKinds[part].Level + " is missing or empty";
    }
  }
  const vtkIdType nodes = blocks[SkeletonPart] ? blocks[SkeletonPart]->GetNumberOfPoints() : 0;
  reason = reason.empty()
    ? WhyBadNodes(blocks[SkeletonPart], littoral::plant::Skeleton, littoral::plant::ParentId, nodes)
    : reason;
  for (int part : { SkinPart, LeavesPart })
  {
    reason =
      reason.empty() ? WhyBadNodes(blocks[part], PartKinds[part].Name, littoral::plant::JointIds, nodes) : reason;
  }
  return reason;
}

/// The cylinder that holds all levels of a prototype. Cards have transparent corners beyond it.
littoral::PlantExtent ExtentOf(const Blocks& blocks)
{
  littoral::PlantExtent extent;
  for (vtkPolyData* block : blocks)
  {
    const bool isCards =
      block && block == blocks[LowPart] && block->GetFieldData()->HasArray(littoral::plant::ImpostorExtent);
    for (vtkIdType point = 0; block && !isCards && point < block->GetNumberOfPoints(); ++point)
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

/// Why a site holds no plant, in words for a user.
std::string WhyBadSite(const littoral::PlantPlace& place, double siteId, double kind, int species)
{
  const std::string ofSite = " of site " + std::to_string(place.Site);
  littoral::ParameterCheck check;
  if (!littoral::IsFinite(place.Foot))
  {
    std::ostringstream text;
    text << "site " << place.Site << " lies at (" << place.Foot.x << ", " << place.Foot.y << ", " << place.Foot.z
         << "); positions must be finite.";
    check.Require(text.str());
  }
  check.Finite("SiteId" + ofSite, siteId);
  check.Require(kind >= 0.0 && kind < species && kind == std::floor(kind), "Species" + ofSite, kind, "",
    "a whole number from 0 to " + std::to_string(species - 1));
  check.Positive("Scale" + ofSite, place.Scale);
  check.Finite("Azimuth" + ofSite, place.Azimuth);
  return check.Reason();
}

/// The plant at a site, on no terrain yet. False, with the reason, if a number is bad.
bool MakePlace(vtkPointSet* sites, const SiteArrays& arrays, const littoral::PlantDraws& draws, int species,
  vtkIdType site, littoral::PlantPlace& place, std::string& reason)
{
  double position[3];
  sites->GetPoint(site, position);
  place.Foot = { position[0], position[1], position[2] };
  place.Site = static_cast<int>(site);
  const double drawnBy = arrays.SiteId ? arrays.SiteId->GetTuple1(site) : static_cast<double>(site);
  place.SiteId = std::isfinite(drawnBy) ? static_cast<long long>(drawnBy) : 0;
  const double kind = arrays.Species ? arrays.Species->GetTuple1(site) : draws.Species(place.SiteId);
  place.Scale = arrays.Scale ? arrays.Scale->GetTuple1(site) : draws.Scale(place.SiteId);
  place.Azimuth = arrays.Azimuth ? arrays.Azimuth->GetTuple1(site) : draws.Azimuth(place.SiteId);
  const bool isSpecies = kind >= 0.0 && kind < species && kind == std::floor(kind);
  if (!littoral::IsFinite(place.Foot) || !std::isfinite(drawnBy) || !isSpecies ||
    !littoral::ValueInterval::Positive().Contains(place.Scale) || !std::isfinite(place.Azimuth))
  {
    reason = WhyBadSite(place, drawnBy, kind, species);
    return false;
  }
  place.Species = static_cast<int>(kind);
  place.Tint = draws.Tint(place.SiteId);
  return true;
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

/// The prototypes of all species.
struct Prototypes
{
  std::vector<littoral::DataStamp> Stamps;
  std::vector<littoral::PlantPart> Parts;
  std::vector<littoral::PlantExtent> Extents;
  littoral::TextureImage CrownAtlas;
  littoral::TextureImage LeafAtlas;
  littoral::PlantPart FacingLow; ///< one card a plant, not placed yet; plants without an impostor as in Low
  std::vector<std::optional<littoral::ImpostorShape>> Shapes;
  std::vector<littoral::AtlasArea> LowAreas;
  /// Textures as field data, the same arrays at each execution; null where there is none.
  std::array<vtkSmartPointer<vtkFieldData>, NumberOfParts> Textures;

  std::size_t NumberOfSpecies() const { return this->Extents.size(); }

  /// Polygons of a species in full.
  double HighPolygons(int species) const
  {
    return static_cast<double>(
      this->Parts[SkinPart].Meshes[species].NumberOfCells() + this->Parts[LeavesPart].Meshes[species].NumberOfCells());
  }
};

/// All plants at their sites.
struct Plants
{
  std::vector<littoral::DataStamp> Stamps;
  std::vector<double> Numbers; ///< properties that they depend on
  std::vector<littoral::PlantPlace> Places;
  std::unique_ptr<littoral::SceneCells> Cells;
};

/// A block that is one card, to be placed.
vtkSmartPointer<vtkPolyData> CardBlock(const littoral::PlantImpostor& impostor)
{
  littoral::PlantMesh mesh;
  mesh.Points.resize(4);
  mesh.Normals.resize(4);
  mesh.TCoords.resize(4);
  mesh.Colors.assign(4, impostor.Mean);
  mesh.AddPolygon(std::array<int, 4>{ 0, 1, 2, 3 });
  return littoral::PolyDataOf(mesh);
}

/// Joins the textures of a part, which become its field data.
littoral::TextureAtlas JoinTextures(const std::vector<Blocks>& blocks, PartIndex part, Prototypes& prototypes)
{
  std::vector<littoral::TextureImage> textures;
  std::vector<littoral::ColorSum> means;
  for (const Blocks& each : blocks)
  {
    textures.push_back(littoral::ReadTexture(each[part]));
    means.push_back(littoral::ReadTextureMean(each[part]));
  }
  const littoral::ColorSum mean = littoral::ShareMean(textures, means);
  littoral::TextureAtlas atlas = littoral::StackTextures(textures);
  vtkNew<vtkPolyData> carrier;
  littoral::AttachTexture(carrier, atlas.Image);
  if (mean != littoral::ColorSum{ 1.0f, 1.0f, 1.0f })
  {
    littoral::AttachTextureMean(carrier, mean);
  }
  prototypes.Textures[part] = carrier->GetFieldData();
  return atlas;
}

/// Joins the normals of impostors; flat where there are none.
void JoinNormals(const std::vector<littoral::PlantImpostor>& impostors, Prototypes& prototypes)
{
  std::vector<littoral::TextureImage> textures;
  for (const littoral::PlantImpostor& impostor : impostors)
  {
    littoral::TextureImage& normals = textures.emplace_back(impostor.Pictures.Columns, impostor.Pictures.Rows);
    std::transform(
      impostor.Normals.begin(), impostor.Normals.end(), normals.Texels.begin(), [](const littoral::Color& n) {
        return littoral::Texel{ n[0], n[1], n[2], 255 };
      });
  }
  const littoral::TextureImage atlas = littoral::StackTextures(textures).Image;
  std::vector<littoral::Color> normals;
  normals.reserve(atlas.Texels.size());
  for (const littoral::Texel& texel : atlas.Texels)
  {
    normals.push_back({ texel[0], texel[1], texel[2] });
  }
  vtkNew<vtkPolyData> carrier;
  littoral::AttachNormalTexture(carrier, normals);
  prototypes.Textures[LowPart]->AddArray(carrier->GetFieldData()->GetArray(littoral::plant::NormalTexture));
}

/// Takes the lowest level, both as it is and as cards.
void TakeLow(const std::vector<Blocks>& blocks, Prototypes& prototypes)
{
  std::vector<littoral::PlantImpostor> impostors;
  std::vector<vtkPolyData*> own;
  std::vector<vtkPolyData*> facing;
  std::vector<vtkSmartPointer<vtkPolyData>> cards;
  bool hasPictures = false;
  for (const Blocks& each : blocks)
  {
    const littoral::PlantImpostor& impostor = impostors.emplace_back(littoral::ReadImpostor(each[LowPart]));
    const bool isCard = !impostor.Pictures.Texels.empty();
    hasPictures |= isCard;
    prototypes.Shapes.push_back(isCard ? std::optional(impostor.Shape) : std::nullopt);
    cards.push_back(isCard ? CardBlock(impostor) : nullptr);
    own.push_back(each[LowPart]);
    facing.push_back(isCard ? cards.back().Get() : each[LowPart]);
  }
  littoral::TextureAtlas atlas;
  if (hasPictures)
  {
    atlas = JoinTextures(blocks, LowPart, prototypes);
    JoinNormals(impostors, prototypes);
  }
  prototypes.Parts.push_back(littoral::MakePart(PartKinds[LowPart], own, hasPictures ? &atlas : nullptr));
  prototypes.FacingLow = littoral::MakePart(PartKinds[LowPart], facing, hasPictures ? &atlas : nullptr);
  prototypes.LowAreas = std::move(atlas.Areas);
}

/// Takes all blocks from the prototypes, and joins their textures.
void TakeParts(const std::vector<Blocks>& blocks, Prototypes& prototypes)
{
  for (const Blocks& each : blocks)
  {
    prototypes.Extents.push_back(ExtentOf(each));
  }
  littoral::TextureAtlas crownAtlas = JoinTextures(blocks, CrownPart, prototypes);
  littoral::TextureAtlas leafAtlas = JoinTextures(blocks, LeavesPart, prototypes);
  for (int part = 0; part < LowPart; ++part)
  {
    std::vector<vtkPolyData*> own;
    for (const Blocks& each : blocks)
    {
      own.push_back(each[part]);
    }
    const littoral::TextureAtlas* atlas = part == CrownPart ? &crownAtlas : part == LeavesPart ? &leafAtlas : nullptr;
    prototypes.Parts.push_back(littoral::MakePart(PartKinds[part], own, atlas));
  }
  TakeLow(blocks, prototypes);
  prototypes.CrownAtlas = std::move(crownAtlas.Image);
  prototypes.LeafAtlas = std::move(leafAtlas.Image);
}

/// The plants at all sites, on the ground if there is a terrain. Why they cannot stand there, or nothing.
std::string PlacePlants(vtkPointSet* sites, vtkImageData* terrain, const littoral::ScatterOptions& options,
  const littoral::GroundLimits& limits, std::vector<littoral::PlantPlace>& places)
{
  const vtkIdType count = sites->GetNumberOfPoints();
  const double bytes = sizeof(littoral::PlantPlace) + 2.0 * sizeof(littoral::Box);
  if (count > std::numeric_limits<int>::max() || static_cast<double>(count) * bytes > littoral::AvailableMemory())
  {
    return std::to_string(count) + " sites are more than this machine has memory for.";
  }
  places.resize(static_cast<std::size_t>(count));
  std::string reason;
  const SiteArrays arrays(sites);
  const littoral::PlantDraws draws(options);
  const int species = static_cast<int>(options.Weights.size());
  for (vtkIdType site = 0; site < count && reason.empty(); ++site)
  {
    MakePlace(sites, arrays, draws, species, site, places[site], reason);
  }
  littoral::HeightGrid grid;
  if (reason.empty() && terrain && MakeGrid(terrain, grid, reason))
  {
    reason = littoral::PutOnGround(grid, limits, places);
  }
  else if (reason.empty())
  {
    littoral::DropOutside(limits, places);
  }
  return reason;
}

/// All blocks of the shown plants.
class BlockMerge
{
public:
  /// With a view, far plants face its eye.
  BlockMerge(const Prototypes& prototypes, const std::vector<littoral::PlantPlace>& places,
    const std::vector<littoral::ShownPlant>& shown, const littoral::View* facing)
    : Species(prototypes)
    , Places(places)
    , Facing(facing)
  {
    for (const littoral::ShownPlant& plant : shown)
    {
      this->Shown[static_cast<int>(plant.Level)].push_back(plant.Place);
    }
    this->Merges.reserve(NumberOfParts);
    this->Bytes = TableBytes * static_cast<double>(shown.size());
    for (int part = 0; part < NumberOfParts; ++part)
    {
      const bool isCards = part == LowPart && facing;
      this->Merges.emplace_back(isCards ? prototypes.FacingLow : prototypes.Parts[part], places,
        this->Shown[static_cast<int>(LevelOfPart[part])]);
      this->Bytes += this->Merges.back().GetBytes();
    }
    for (int part : { SkeletonPart, SkinPart, LeavesPart })
    {
      this->Merges[part].SetSkeleton(&this->Merges[SkeletonPart]);
    }
  }
  BlockMerge(const BlockMerge&) = delete;
  BlockMerge& operator=(const BlockMerge&) = delete;

  double GetBytes() const { return this->Bytes; }
  std::size_t GetNumberOfPlants(littoral::PlantLevel level) const
  {
    return this->Shown[static_cast<int>(level)].size();
  }
  bool HasTooManyNodes() const
  {
    return this->Merges[SkeletonPart].GetNumberOfPoints() > std::numeric_limits<int>::max();
  }
  double GetNumberOfPolygons() const
  {
    double polygons = 0.0;
    for (int part = 0; part < NumberOfParts; ++part)
    {
      polygons += PartKinds[part].HasLines ? 0.0 : static_cast<double>(this->Merges[part].GetNumberOfCells());
    }
    return polygons;
  }

  /// Takes memory, and shares the work out in jobs.
  std::size_t Begin()
  {
    for (int part = 0; part < NumberOfParts; ++part)
    {
      this->Merges[part].Allocate();
      for (std::size_t plant = 0; plant < this->Merges[part].GetNumberOfPlants(); plant += PlantsAtOnce)
      {
        this->Jobs.emplace_back(part, plant);
      }
    }
    return this->Jobs.size();
  }

  /// Does a job, in any order on any threads.
  void Do(std::size_t job)
  {
    const auto [part, plant] = this->Jobs[job];
    littoral::PlantMerge& merge = this->Merges[part];
    const std::size_t end = std::min(plant + PlantsAtOnce, merge.GetNumberOfPlants());
    merge.Fill(plant, end);
    for (std::size_t index = plant; part == LowPart && this->Facing && index < end; ++index)
    {
      this->PlaceCard(index);
    }
  }

  void AddTo(vtkMultiBlockDataSet* output) const
  {
    vtkNew<vtkMultiBlockDataSet> high;
    vtkNew<vtkMultiBlockDataSet> medium;
    littoral::AddBlock(output, littoral::plant::High, high);
    littoral::AddBlock(output, littoral::plant::Medium, medium);
    vtkMultiBlockDataSet* const levels[] = { high, medium, output };
    for (int part = 0; part < NumberOfParts; ++part)
    {
      const char* name = PartKinds[part].Name ? PartKinds[part].Name : PartKinds[part].Level;
      vtkPolyData* block = this->Merges[part].GetOutput();
      if (this->Species.Textures[part])
      {
        block->GetFieldData()->ShallowCopy(this->Species.Textures[part]);
      }
      littoral::AddBlock(levels[static_cast<int>(LevelOfPart[part])], name, block);
    }
  }

private:
  const Prototypes& Species;
  const std::vector<littoral::PlantPlace>& Places;
  const littoral::View* Facing;
  std::array<std::vector<int>, 3> Shown; ///< places, of each level
  std::vector<littoral::PlantMerge> Merges;
  std::vector<std::pair<int, std::size_t>> Jobs; ///< a part, and the first of some of its plants
  double Bytes = 0.0;

  /// Points, normals and texture coordinates of the card of a far plant.
  void PlaceCard(std::size_t plant)
  {
    const littoral::PlantMerge& merge = this->Merges[LowPart];
    const littoral::PlantPlace& place = this->Places[this->Shown[static_cast<int>(littoral::PlantLevel::Low)][plant]];
    if (!this->Species.Shapes[place.Species])
    {
      return;
    }
    const littoral::ImpostorCard card =
      littoral::FacingCard(*this->Species.Shapes[place.Species], place, *this->Facing);
    const auto ofPicture = littoral::CardTCoords(card.View);
    vtkPointData* arrays = merge.GetOutput()->GetPointData();
    auto* points = vtkFloatArray::FastDownCast(merge.GetOutput()->GetPoints()->GetData());
    auto* normals = vtkFloatArray::FastDownCast(arrays->GetNormals());
    auto* tcoords = vtkFloatArray::FastDownCast(arrays->GetTCoords());
    for (int corner = 0; corner < 4; ++corner)
    {
      const auto at = static_cast<vtkIdType>(merge.GetFirstPoint(plant)) + corner;
      const auto inAtlas = this->Species.LowAreas[place.Species].Map(ofPicture[corner][0], ofPicture[corner][1]);
      for (int axis = 0; axis < 3; ++axis)
      {
        points->SetTypedComponent(at, axis, static_cast<float>(card.Corners[corner][axis]));
        normals->SetTypedComponent(at, axis, static_cast<float>(card.Normals[corner][axis]));
        if (axis < 2)
        {
          tcoords->SetTypedComponent(at, axis, static_cast<float>(inAtlas[axis]));
        }
      }
    }
  }
};

}

//----------------------------------------------------------------------------
/// What does not depend on the view.
class vtkPlantScatterFilter::vtkInternals
{
public:
  Prototypes Species;
  Plants Scene;
};

//----------------------------------------------------------------------------
/// What is asked for this time.
struct vtkPlantScatterFilter::Request
{
  littoral::View Seen;
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
  , UseCulling(true)
  , FaceCamera(true)
  , PlantsPerCell(1.0)
  , VisibleDistance(0.0)
  , Internals(std::make_unique<vtkInternals>())
{
  this->NearDistance = 30.0;
  this->FarDistance = 130.0;
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(3);
}

//----------------------------------------------------------------------------
vtkPlantScatterFilter::~vtkPlantScatterFilter() = default;

//----------------------------------------------------------------------------
void vtkPlantScatterFilter::SetWeight(int prototype, double weight)
{
  if (prototype < 0 || prototype >= MostWeights)
  {
    vtkErrorMacro(
      "Weight " << prototype << ": prototypes are counted from 0, and there are at most " << MostWeights << ".");
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
  if (port == SitesPort)
  {
    // Whole, not a block at a time: a plant is no set of sites, which is then said once.
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  }
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
int vtkPlantScatterFilter::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  outputs->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  std::vector<TextureSize> crowns;
  std::vector<TextureSize> leaves;
  for (int index = 0; index < this->GetNumberOfInputConnections(PrototypesPort); ++index)
  {
    const PrototypeTextures textures = ExpectedTextures(
      inputs[PrototypesPort]->GetInformationObject(index), littoral::PipelineTime(this, PrototypesPort, index));
    crowns.push_back(textures.Crown);
    leaves.push_back(textures.Leaves);
  }
  SetWholeExtent(outputs->GetInformationObject(1), littoral::AtlasSize(crowns));
  SetWholeExtent(outputs->GetInformationObject(2), littoral::AtlasSize(leaves));
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
  littoral::ParameterCheck check;
  check.Range("SlopeLimit", this->SlopeLimit, 0.0, 90.0, "degrees");
  check.Require(this->HeightRange[0] <= this->HeightRange[1],
    "HeightRange is " + littoral::TextOf(this->HeightRange[0]) + " to " + littoral::TextOf(this->HeightRange[1]) +
      " m; the first must not be above the second.");
  check.Positive("PlantsPerCell", this->PlantsPerCell);
  check.Require(this->VisibleDistance >= 0.0, "VisibleDistance", this->VisibleDistance, "m", "0 or more");
  if (!check.IsGood())
  {
    littoralErrorMacro(<< check.Reason());
  }
  return check.IsGood();
}

//----------------------------------------------------------------------------
bool vtkPlantScatterFilter::CheckSites(vtkInformationVector* inputs)
{
  const bool isGood = vtkPointSet::GetData(inputs) != nullptr;
  if (!isGood)
  {
    littoralErrorMacro("The sites are blocks, such as a plant; connect points to Sites and plants to Prototypes.");
  }
  return isGood;
}

//----------------------------------------------------------------------------
bool vtkPlantScatterFilter::RememberPrototypes(vtkInformationVector* inputs)
{
  std::vector<littoral::DataStamp> stamps;
  std::vector<Blocks> prototypes;
  std::vector<std::string> reasons;
  for (int index = 0; index < inputs->GetNumberOfInformationObjects(); ++index)
  {
    vtkDataObject* input = vtkDataObject::GetData(inputs, index);
    stamps.push_back(littoral::StampOf(input));
    reasons.emplace_back();
    const auto prototype = littoral::BlocksOf(input, reasons.back());
    prototypes.emplace_back();
    std::transform(std::begin(PartKinds), std::end(PartKinds), prototypes.back().begin(),
      [&](const littoral::PartKind& kind) { return PartOf(prototype, kind); });
  }
  if (!stamps.empty() && stamps == this->Internals->Species.Stamps)
  {
    return true;
  }
  *this->Internals = vtkInternals();
  if (prototypes.empty())
  {
    littoralErrorMacro("There are no prototypes: connect a plant or more to Prototypes.");
    return false;
  }
  for (std::size_t index = 0; index < prototypes.size(); ++index)
  {
    const std::string reason = reasons[index].empty() ? WhyInvalid(prototypes[index]) : reasons[index];
    if (!reason.empty())
    {
      littoralErrorMacro("Prototype " << index << " cannot be scattered: " << reason << ".");
      return false;
    }
  }
  TakeParts(prototypes, this->Internals->Species);
  this->Internals->Species.Stamps = stamps;
  return true;
}

//----------------------------------------------------------------------------
bool vtkPlantScatterFilter::RememberPlaces(vtkInformationVector** inputs)
{
  vtkPointSet* sites = vtkPointSet::GetData(inputs[SitesPort]);
  vtkImageData* terrain = vtkImageData::GetData(inputs[TerrainPort]);
  const std::vector<littoral::PlantExtent>& extents = this->Internals->Species.Extents;
  Plants& scene = this->Internals->Scene;
  littoral::ScatterOptions options;
  options.Seed = this->Seed;
  options.ScaleVariation = this->ScaleVariation;
  options.TintVariation = this->TintVariation;
  for (int prototype = 0; prototype < static_cast<int>(extents.size()); ++prototype)
  {
    options.Weights.push_back(this->GetWeight(prototype));
  }
  const std::vector<littoral::DataStamp> stamps{ littoral::StampOf(sites), littoral::StampOf(terrain) };
  std::vector<double> numbers{ static_cast<double>(this->Seed), this->ScaleVariation, this->TintVariation,
    this->SlopeLimit, this->HeightRange[0], this->HeightRange[1], this->PlantsPerCell };
  numbers.insert(numbers.end(), options.Weights.begin(), options.Weights.end());
  if (stamps == scene.Stamps && numbers == scene.Numbers)
  {
    return true;
  }
  scene = Plants();
  this->SetProgressText("Placing plants");
  const littoral::GroundLimits limits{ this->SlopeLimit * Degree, this->HeightRange[0], this->HeightRange[1] };
  std::string reason = littoral::WhyInvalid(options);
  reason = reason.empty() ? PlacePlants(sites, terrain, options, limits, scene.Places) : reason;
  if (!reason.empty())
  {
    littoralErrorMacro("Cannot scatter plants: " << reason);
    return false;
  }
  std::vector<littoral::Vector3> feet;
  std::vector<littoral::Box> boxes;
  for (const littoral::PlantPlace& place : scene.Places)
  {
    feet.push_back(place.Foot);
    boxes.push_back(littoral::BoxOf(place, extents[place.Species]));
  }
  scene.Cells = std::make_unique<littoral::SceneCells>(feet, boxes, this->PlantsPerCell);
  scene.Stamps = stamps;
  scene.Numbers = numbers;
  return true;
}

//----------------------------------------------------------------------------
int vtkPlantScatterFilter::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  littoral::View view;
  if (!this->GetView(view) || !this->CheckProperties() || !this->CheckSites(inputs[SitesPort]) ||
    !this->RememberPrototypes(inputs[PrototypesPort]) || !this->RememberPlaces(inputs))
  {
    return littoral::FailedRequest(this);
  }
  const Plants& scene = this->Internals->Scene;
  littoral::PlantViewOptions options;
  options.UseLevels = this->UseLevels;
  options.UseCulling = this->UseCulling;
  options.NearDistance = this->NearDistance;
  options.FarDistance = this->FarDistance;
  options.VisibleDistance = this->VisibleDistance;
  vtkInformation* info = outputs->GetInformationObject(0);
  const long long piece = std::max(0, info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()));
  const long long pieces = std::max(1, info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES()));
  const long long sites = vtkPointSet::GetData(inputs[SitesPort])->GetNumberOfPoints();
  Request request;
  request.Seen = view;
  request.FirstSite = sites * piece / pieces;
  request.EndSite = sites * (piece + 1) / pieces;
  request.CellsShown = scene.Cells->Show(littoral::ViewFrustum(view));
  request.Shown = littoral::ShownPlants(
    scene.Places, *scene.Cells, request.CellsShown, view, options, request.FirstSite, request.EndSite);
  if (!this->Merge(request, vtkMultiBlockDataSet::GetData(outputs, 0)))
  {
    return littoral::FailedRequest(this);
  }
  WriteTexture(this->Internals->Species.CrownAtlas, outputs->GetInformationObject(1));
  WriteTexture(this->Internals->Species.LeafAtlas, outputs->GetInformationObject(2));
  this->UpdateProgress(1.0);
  return 1;
}

//----------------------------------------------------------------------------
bool vtkPlantScatterFilter::Merge(const Request& request, vtkMultiBlockDataSet* output)
{
  const Prototypes& species = this->Internals->Species;
  const Plants& scene = this->Internals->Scene;
  BlockMerge merge(species, scene.Places, request.Shown, this->FaceCamera ? &request.Seen : nullptr);
  const double available = littoral::AvailableMemory();
  if (merge.GetBytes() > available || merge.HasTooManyNodes())
  {
    littoralErrorMacro(<< request.Shown.size() << " plants, " << merge.GetNumberOfPlants(littoral::PlantLevel::High)
                       << " of them in full, need " << merge.GetBytes() / Gigabyte << " GB, and "
                       << available /
        Gigabyte << " GB are free. Switch on UseLevels and UseCulling, lower NearDistance, or set VisibleDistance.");
    return false;
  }
  this->SetProgressText("Scattering plants");
  const std::size_t jobs = merge.Begin();
  if (!littoral::RunWithProgress(this, jobs, 0.1, 0.9, [&](std::size_t job) { merge.Do(job); }))
  {
    return true; // aborted
  }
  merge.AddTo(output);

  vtkFieldData* fields = output->GetFieldData();
  WriteTable(scene.Places, request.Shown, fields);
  const auto write = [fields](const char* name, double value) { WriteCounter(fields, name, value); };
  double plantsInAll = 0.0;
  double polygonsInAll = 0.0;
  for (const littoral::PlantPlace& place : scene.Places)
  {
    if (place.Site >= request.FirstSite && place.Site < request.EndSite)
    {
      plantsInAll += 1.0;
      polygonsInAll += species.HighPolygons(place.Species);
    }
  }
  const auto marks = std::count(request.CellsShown.begin(), request.CellsShown.end(), 1);
  write("PlantsInAll", plantsInAll);
  write("PlantsShown", static_cast<double>(request.Shown.size()));
  write("PlantsHigh", static_cast<double>(merge.GetNumberOfPlants(littoral::PlantLevel::High)));
  write("PlantsMedium", static_cast<double>(merge.GetNumberOfPlants(littoral::PlantLevel::Medium)));
  write("PlantsLow", static_cast<double>(merge.GetNumberOfPlants(littoral::PlantLevel::Low)));
  write("CellsInAll", scene.Cells->NumberOfFilled());
  write("CellsShown", this->UseCulling ? static_cast<double>(marks) : scene.Cells->NumberOfFilled());
  write("PolygonsShown", merge.GetNumberOfPolygons());
  write("PolygonsInAll", polygonsInAll);
  write("OutputBytes", merge.GetBytes());
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
  os << indent << "UseCulling: " << this->UseCulling << "\n";
  os << indent << "FaceCamera: " << this->FaceCamera << "\n";
  os << indent << "PlantsPerCell: " << this->PlantsPerCell << "\n";
  os << indent << "VisibleDistance: " << this->VisibleDistance << "\n";
}
