// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPlantScatterFilter.h"

#include "Data/ArrayReader.h"
#include "Data/Blocks.h"
#include "Data/Georeference.h"
#include "Data/Inputs.h"
#include "Data/PlantForm.h"
#include "Data/ScatterInstances.h"
#include "Data/ScatterMerge.h"
#include "Data/ScatterPrototypes.h"
#include "Data/ScatterSites.h"
#include "Data/ScatterTable.h"
#include "Geometry/SceneCells.h"
#include "Geometry/TextureAtlas.h"
#include "Numerics/Constants.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/DataStamp.h"
#include "Pipeline/Pipeline.h"
#include "Pipeline/Ranges.h"
#include "Pipeline/RankTeam.h"
#include "Pipeline/SharedParts.h"
#include "Plants/PlantScatter.h"
#include "vtkPlantSource.h"

#include "vtkCompositeDataSet.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationDataObjectMetaDataKey.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkPlantScatterFilter);

namespace
{

constexpr int SitesPort = 0;
constexpr int PrototypesPort = 1;
constexpr int TerrainPort = 2;
// The inputs in the words of the panel.
constexpr const char* SitesInput = "Sites";
constexpr const char* PrototypesInput = "Prototypes";
constexpr const char* TerrainInput = "Terrain";
constexpr const char* InstancesBlock = "Instances";
constexpr const char* CannotScatter = "Cannot scatter plants: ";
constexpr double Degree = littoral::Pi / 180.0;
/// More prototypes than this have no weight of their own.
constexpr int MostWeights = 1000000;

/// Sizes of the textures of crown and leaves.
struct PrototypeTextures
{
  std::array<int, 2> Crown;
  std::array<int, 2> Leaves;
};

/// The sizes that a prototype will have when its source has executed: of its data if they are up to date, else those
/// that the source announces; where none are announced, of the data as they are.
PrototypeTextures ExpectedTextures(vtkInformation* input, vtkMTimeType lastUpstreamChange)
{
  vtkDataObject* data = vtkDataObject::GetData(input);
  vtkDataObject* announced = input->Get(vtkPlantSource::TEXTURE_SIZES());
  if (announced && !(data && data->GetUpdateTime() > lastUpstreamChange))
  {
    littoral::ArrayReader sizes = littoral::ArrayReader::OfFields(announced, "the plant", 1);
    return { littoral::ReadTextureSize(sizes.Seek(littoral::plant::Crown, 2)),
      littoral::ReadTextureSize(sizes.Seek(littoral::plant::Leaves, 2)) };
  }
  vtkSmartPointer<vtkMultiBlockDataSet> prototype;
  littoral::WhyRefused([&] { prototype = littoral::BlocksOf(data, PrototypesInput); }); // said when data are asked for
  return { littoral::ReadTextureSize(littoral::PartOf(prototype, littoral::PartKinds[littoral::CrownPart])),
    littoral::ReadTextureSize(littoral::PartOf(prototype, littoral::PartKinds[littoral::LeavesPart])) };
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

/// Whether ranks that are asked for plants, each for its piece, can have a part of the sites each.
bool MayShareSites(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return request->Get(vtkExecutive::FROM_OUTPUT_PORT()) <= 0 && !littoral::RankTeam(request, outputs).IsAlone() &&
    littoral::ComesInParts(inputs[SitesPort]->GetInformationObject(0), littoral::PartForm::Runs);
}

/// The prototypes, and the data that they are of.
struct Prototypes : littoral::ScatterPrototypes
{
  std::vector<littoral::DataStamp> Stamps;
  bool HasJoints = true;
  bool HasSurfaces = true;
  /// As instances refer to them, behind the empty block of the instances.
  vtkSmartPointer<vtkMultiBlockDataSet> Levels = vtkSmartPointer<vtkMultiBlockDataSet>::New();
};

/// All plants at their sites.
struct Plants
{
  std::vector<littoral::DataStamp> Stamps;
  std::vector<double> Numbers; ///< properties that they depend on
  std::vector<std::string> Names;
  std::vector<littoral::PlantPlace> Places;
  std::vector<littoral::PlantPlace> MediumPlaces; ///< where sites have dimensions
  std::unique_ptr<littoral::SceneCells> Cells;
  littoral::MergedBlocks Merged; ///< as last shown
  double PolygonsInAll = 0.0;    ///< of all plants in full
  bool HaveGirths = false;

  /// Notes what a view needs of all plants.
  void AddUp(const Prototypes& species)
  {
    this->HaveGirths = littoral::HasGirths(this->Places);
    for (const littoral::PlantPlace& place : this->Places)
    {
      this->PolygonsInAll += species.HighPolygons(place.Species);
    }
  }

  /// Feet and boxes, of both fits where there are two; they stay here, as the extents of the prototypes do.
  littoral::SceneObjects Objects(const std::vector<littoral::PlantExtent>& extents) const
  {
    const auto foot = [this](std::size_t plant) { return this->Places[plant].Foot; };
    const auto box = [this, &extents](std::size_t plant) {
      const littoral::PlantPlace& place = this->Places[plant];
      const littoral::Box high = littoral::BoxOf(place, extents[place.Species]);
      if (this->MediumPlaces.empty())
      {
        return high;
      }
      const littoral::Box medium = littoral::BoxOf(this->MediumPlaces[plant], extents[place.Species]);
      return littoral::Box{ glm::min(high.Low, medium.Low), glm::max(high.High, medium.High) };
    };
    return { this->Places.size(), foot, box };
  }
};

}

//----------------------------------------------------------------------------
/// State that does not depend on the view.
class vtkPlantScatterFilter::vtkInternals
{
public:
  Prototypes Species;
  Plants Scene;
};

//----------------------------------------------------------------------------
/// Properties and inputs of one request.
struct vtkPlantScatterFilter::Request
{
  littoral::View Seen;
  std::vector<littoral::ShownPlant> Shown;
  std::vector<littoral::PlantPlace> Places; ///< each in the level in which it is shown; none if levels are alike
  std::vector<char> CellsShown;
  vtkDataObject* Ground = nullptr; ///< what tells the place on earth: the terrain, or the sites

  std::size_t NumberOf(littoral::PlantLevel level) const
  {
    return std::count_if(this->Shown.begin(), this->Shown.end(),
      [level](const littoral::ShownPlant& plant) { return plant.Level == level; });
  }
};

//----------------------------------------------------------------------------
vtkPlantScatterFilter::vtkPlantScatterFilter()
  : Seed(1)
  , ScaleVariation(0.15)
  , UseDimensions(true)
  , HeightArray(nullptr)
  , DiameterArray(nullptr)
  , TintVariation(0.08)
  , SlopeLimit(90.0)
  , HeightRange{ -1e30, 1e30 }
  , UseLevels(true)
  , UseCulling(true)
  , FaceCamera(true)
  , OutputForm(Merged)
  , PassJoints(true)
  , PassSurfaces(true)
  , PlantsPerCell(1.0)
  , VisibleDistance(0.0)
  , Internals(std::make_unique<vtkInternals>())
{
  this->SetHeightArray("Height");
  this->SetDiameterArray("DBH");
  this->NearDistance = 30.0;
  this->FarDistance = 130.0;
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(3);
}

//----------------------------------------------------------------------------
vtkPlantScatterFilter::~vtkPlantScatterFilter()
{
  this->SetHeightArray(nullptr);
  this->SetDiameterArray(nullptr);
}

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
  if (port != PrototypesPort)
  {
    // Whole, not a block at a time: a plant is no set of sites and no terrain, which is then said once.
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
  vtkInformation* plants = outputs->GetInformationObject(0);
  plants->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  littoral::ForgetPartForm(plants);
  if (this->OutputForm == Instances)
  {
    littoral::AnnouncePartForm(plants, littoral::PartForm::Instances);
  }
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    littoral::AnnounceTimesOf(this, inputs, outputs->GetInformationObject(port));
  }
  std::vector<std::array<int, 2>> crowns;
  std::vector<std::array<int, 2>> leaves;
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
int vtkPlantScatterFilter::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
  {
    for (int index = 0; index < inputs[port]->GetNumberOfInformationObjects(); ++index)
    {
      littoral::RequestAll(inputs[port]->GetInformationObject(index));
    }
  }
  if (MayShareSites(request, inputs, outputs))
  {
    littoral::RequestSamePart(inputs[SitesPort]->GetInformationObject(0), outputs->GetInformationObject(0));
    littoral::RequestTogether(inputs[PrototypesPort]);
  }
  return 1;
}

//----------------------------------------------------------------------------
void vtkPlantScatterFilter::CheckProperties()
{
  littoral::ParameterCheck check;
  check.Range("SlopeLimit", this->SlopeLimit, 0.0, 90.0, "degrees");
  check.Require(this->HeightRange[0] <= this->HeightRange[1],
    "HeightRange is " + littoral::TextOf(this->HeightRange[0]) + " to " + littoral::TextOf(this->HeightRange[1]) +
      " m; the first must not be above the second.");
  check.Positive("PlantsPerCell", this->PlantsPerCell);
  check.Choice("OutputForm", this->OutputForm, { "merged", "instances" });
  check.NotNegative("VisibleDistance", this->VisibleDistance, "m"); // 0 for none
  littoral::Require(check.Reason());
}

//----------------------------------------------------------------------------
void vtkPlantScatterFilter::CheckSites(vtkInformationVector* inputs)
{
  littoral::Require(vtkCompositeDataSet::SafeDownCast(vtkDataObject::GetData(inputs))
      ? "The sites are blocks, such as a plant; connect points to Sites and plants to Prototypes."
      : "");
  littoral::InContext(CannotScatter, [inputs] { littoral::InputOf<vtkPointSet>(inputs, SitesInput); });
}

//----------------------------------------------------------------------------
void vtkPlantScatterFilter::RememberPrototypes(vtkInformationVector* inputs)
{
  std::vector<littoral::DataStamp> stamps;
  for (int index = 0; index < inputs->GetNumberOfInformationObjects(); ++index)
  {
    stamps.push_back(littoral::StampOf(vtkDataObject::GetData(inputs, index)));
  }
  const Prototypes& last = this->Internals->Species;
  if (!stamps.empty() && stamps == last.Stamps && last.HasJoints == this->PassJoints &&
    last.HasSurfaces == this->PassSurfaces)
  {
    return;
  }
  *this->Internals = vtkInternals();
  littoral::Require(stamps.empty() ? "There are no prototypes: connect a plant or more to Prototypes." : "");
  std::vector<vtkSmartPointer<vtkMultiBlockDataSet>> prototypes;
  std::vector<littoral::PrototypeBlocks> blocks;
  for (int index = 0; index < inputs->GetNumberOfInformationObjects(); ++index)
  {
    littoral::InContext("Prototype " + std::to_string(index) + " cannot be scattered: ", [&] {
      prototypes.push_back(littoral::BlocksOf(vtkDataObject::GetData(inputs, index), PrototypesInput));
      littoral::RequirePlants(prototypes.back());
      blocks.push_back(littoral::PartsOf(prototypes.back()));
      littoral::RequirePrototype(blocks.back());
    });
  }
  littoral::TakeParts(blocks, this->PassJoints, this->Internals->Species);
  this->Internals->Species.HasJoints = this->PassJoints;
  this->Internals->Species.HasSurfaces = this->PassSurfaces;
  vtkNew<vtkPolyData> instances;
  littoral::AddBlock(this->Internals->Species.Levels, InstancesBlock, instances);
  for (const littoral::PrototypeBlocks& parts : blocks)
  {
    littoral::AddLevels(parts, this->Internals->Species.Levels);
  }
  this->Internals->Species.Stamps = stamps;
}

//----------------------------------------------------------------------------
void vtkPlantScatterFilter::RememberPlaces(
  vtkInformationVector** inputs, vtkInformation* output, const littoral::WorkShare& share)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  const int piece = std::max(0, output->Get(Pipeline::UPDATE_PIECE_NUMBER())); // VTK asks for -1 where it knows of none
  const int pieces = std::max(1, output->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()));
  auto* sites = littoral::InputOf<vtkPointSet>(inputs[SitesPort], SitesInput);
  auto* terrain = littoral::OptionalInputOf<vtkImageData>(inputs[TerrainPort], TerrainInput);
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
  littoral::DimensionArrays dimensions;
  if (this->UseDimensions)
  {
    dimensions.Height = this->HeightArray ? this->HeightArray : "";
    dimensions.Diameter = this->DiameterArray ? this->DiameterArray : "";
  }
  const std::vector<littoral::DataStamp> stamps{ littoral::StampOf(sites), littoral::StampOf(terrain) };
  std::vector<double> numbers{ static_cast<double>(this->Seed), this->ScaleVariation, this->TintVariation,
    this->SlopeLimit, this->HeightRange[0], this->HeightRange[1], this->PlantsPerCell, static_cast<double>(piece),
    static_cast<double>(pieces) };
  numbers.insert(numbers.end(), options.Weights.begin(), options.Weights.end());
  const std::vector<std::string> names{ dimensions.Height, dimensions.Diameter };
  const bool isOld = stamps == scene.Stamps && numbers == scene.Numbers && names == scene.Names;
  std::vector<double> ranksToPlace{ isOld ? 0.0 : 1.0 };
  share.AddUp(ranksToPlace);
  if (ranksToPlace.front() == 0.0)
  {
    return;
  }
  scene = Plants();
  this->SetProgressText("Placing plants");
  const littoral::GroundLimits limits{ this->SlopeLimit * Degree, this->HeightRange[0], this->HeightRange[1] };
  littoral::Require(littoral::WhyInvalid(options));
  const littoral::SitePart part = share.Ranks > 1 ? littoral::ShareSites(sites, this->PlantsPerCell, share)
                                                  : littoral::MakeSitePart(sites, this->PlantsPerCell, piece, pieces);
  scene.Places =
    littoral::PlacePlants(sites, part, terrain, options, limits, dimensions, this->Internals->Species.Stems, share);
  scene.MediumPlaces =
    littoral::PlacesInLevel(sites, part, dimensions, this->Internals->Species.MediumStems, scene.Places);
  littoral::DealPlaces(part.Grid, part.FirstCells, share, scene.Places);
  littoral::DealPlaces(part.Grid, part.FirstCells, share, scene.MediumPlaces);
  scene.AddUp(this->Internals->Species);
  scene.Cells = std::make_unique<littoral::SceneCells>(part.Grid, part.Cells, scene.Objects(extents));
  scene.Stamps = stamps;
  scene.Numbers = numbers;
  scene.Names = names;
}

//----------------------------------------------------------------------------
/// The same on ranks that each have a part of the sites, or all of them where something else upstream needs them all.
void vtkPlantScatterFilter::RememberShared(
  vtkInformationVector** inputs, vtkInformation* output, littoral::RankTeam& team)
{
  const bool isPart = littoral::IsPart(inputs[SitesPort]->GetInformationObject(0), littoral::PartForm::Runs);
  team.Agree(isPart ? 1 : 0);
  littoral::Require(isPart && !team.IsSharing() ? "Not all ranks have a part of the sites; update all of them." : "");
  this->RememberPrototypes(inputs[PrototypesPort]);
  const std::string why = littoral::WhyRefused([&] { this->RememberPlaces(inputs, output, team.Share()); });
  const bool isOfAnother = why.rfind(CannotScatter, 0) == 0;
  littoral::Require(why.empty() || isOfAnother ? why : CannotScatter + why);
}

//----------------------------------------------------------------------------
int vtkPlantScatterFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const littoral::View view = this->GetView();
  this->CheckProperties();
  this->CheckSites(inputs[SitesPort]);
  if (MayShareSites(request, inputs, outputs))
  {
    littoral::RankTeam team(request, outputs);
    team.Run([&] { this->RememberShared(inputs, outputs->GetInformationObject(0), team); });
  }
  else
  {
    this->RememberPrototypes(inputs[PrototypesPort]);
    littoral::InContext(
      CannotScatter, [&] { this->RememberPlaces(inputs, outputs->GetInformationObject(0), littoral::WorkShare()); });
  }
  const Plants& scene = this->Internals->Scene;
  littoral::PlantViewOptions options;
  options.UseLevels = this->UseLevels;
  options.UseCulling = this->UseCulling;
  options.NearDistance = this->NearDistance;
  options.FarDistance = this->FarDistance;
  options.VisibleDistance = this->VisibleDistance;
  Request shown;
  shown.Seen = view;
  vtkDataObject* terrain = vtkDataObject::GetData(inputs[TerrainPort]);
  shown.Ground = terrain ? terrain : vtkDataObject::GetData(inputs[SitesPort]);
  shown.CellsShown = scene.Cells->Show(littoral::ViewFrustum(view));
  shown.Shown = littoral::ShownPlants(scene.Places, *scene.Cells, shown.CellsShown, view, options);
  if (!scene.MediumPlaces.empty())
  {
    shown.Places = scene.Places;
    for (const littoral::ShownPlant& plant : shown.Shown)
    {
      const bool isMedium = plant.Level == littoral::PlantLevel::Medium;
      shown.Places[plant.Place] = isMedium ? scene.MediumPlaces[plant.Place] : scene.Places[plant.Place];
    }
  }
  vtkMultiBlockDataSet* output = vtkMultiBlockDataSet::GetData(outputs, 0);
  this->OutputForm == Instances ? this->AddInstances(shown, output) : this->Merge(shown, output);
  WriteTexture(this->Internals->Species.CrownAtlas, outputs->GetInformationObject(1));
  WriteTexture(this->Internals->Species.LeafAtlas, outputs->GetInformationObject(2));
  this->UpdateProgress(1.0);
  return 1;
}

//----------------------------------------------------------------------------
/// Levels go by the distance from the eye.
bool vtkPlantScatterFilter::DependsOnDirection() const
{
  return this->UseCulling || this->ParallelProjection || (this->OutputForm == Merged && this->FaceCamera);
}

//----------------------------------------------------------------------------
void vtkPlantScatterFilter::Merge(const Request& request, vtkMultiBlockDataSet* output)
{
  const std::vector<littoral::PlantPlace>& places =
    request.Places.empty() ? this->Internals->Scene.Places : request.Places;
  littoral::ScatterMerge merge(this->Internals->Species, places, request.Shown,
    this->FaceCamera ? &request.Seen : nullptr, this->PassSurfaces, this->Internals->Scene.Merged);
  const std::string plants = "A forest of " + std::to_string(request.Shown.size()) + " plants, " +
    std::to_string(merge.GetNumberOfPlants(littoral::PlantLevel::High)) + " of them in full,";
  const char* remedy = "switch on UseLevels and UseCulling, lower NearDistance, or set VisibleDistance";
  littoral::RequireMemory(merge.GetBytes(), plants, remedy);
  littoral::Require(
    merge.HasTooManyNodes() ? plants + " has too many nodes for one mesh: " + remedy + "." : std::string());
  this->SetProgressText("Scattering plants");
  const std::size_t jobs = merge.Begin();
  if (!littoral::RunWithProgress(this, jobs, 0.1, 0.9, [&](std::size_t job) { merge.Do(job); }))
  {
    return; // aborted
  }
  merge.AddTo(output);
  littoral::WriteTable(places, request.Shown, !this->PassSurfaces, output->GetFieldData());
  this->WriteCounters(request, merge.GetNumberOfPolygons(), merge.GetBytes(), output->GetFieldData());
  this->Internals->Scene.Merged = merge.TakeBlocks();
  littoral::KeepRanges(output, littoral::PollOf(this));
}

//----------------------------------------------------------------------------
void vtkPlantScatterFilter::AddInstances(const Request& request, vtkMultiBlockDataSet* output)
{
  const std::vector<littoral::PlantPlace>& places =
    request.Places.empty() ? this->Internals->Scene.Places : request.Places;
  const bool haveGirths =
    request.Places.empty() ? this->Internals->Scene.HaveGirths : littoral::HasGirths(request.Places);
  const double bytes = littoral::InstanceBytes(request.Shown.size(), haveGirths);
  littoral::RequireMemory(bytes, "A forest of " + std::to_string(request.Shown.size()) + " instances of plants",
    "switch on UseCulling, or set VisibleDistance");
  output->ShallowCopy(this->Internals->Species.Levels);
  const auto instances = littoral::InstancesOf(places, request.Shown, haveGirths);
  if (this->UseLevels)
  {
    littoral::WriteCounter(instances->GetFieldData(), "FarDistance", this->FarDistance);
  }
  littoral::PassGeoreference(request.Ground, instances);
  littoral::ReplaceBlock(output, InstancesBlock, instances);
  const double polygons = littoral::PolygonsOf(this->Internals->Species.Levels, places, request.Shown);
  this->WriteCounters(request, polygons, bytes, output->GetFieldData());
  littoral::KeepRanges(output, littoral::PollOf(this));
}

//----------------------------------------------------------------------------
void vtkPlantScatterFilter::WriteCounters(
  const Request& request, double polygons, double bytes, vtkFieldData* fields) const
{
  const Plants& scene = this->Internals->Scene;
  const auto write = [fields](const char* name, double value) { littoral::WriteCounter(fields, name, value); };
  const auto marks = std::count(request.CellsShown.begin(), request.CellsShown.end(), 1);
  write("PlantsInAll", static_cast<double>(scene.Places.size()));
  write("PlantsShown", static_cast<double>(request.Shown.size()));
  write("PlantsHigh", static_cast<double>(request.NumberOf(littoral::PlantLevel::High)));
  write("PlantsMedium", static_cast<double>(request.NumberOf(littoral::PlantLevel::Medium)));
  write("PlantsLow", static_cast<double>(request.NumberOf(littoral::PlantLevel::Low)));
  write("CellsInAll", scene.Cells->NumberOfFilled());
  write("CellsShown", this->UseCulling ? static_cast<double>(marks) : scene.Cells->NumberOfFilled());
  write("PolygonsShown", polygons);
  write("PolygonsInAll", scene.PolygonsInAll);
  write("OutputBytes", bytes);
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
  os << indent << "UseDimensions: " << this->UseDimensions << "\n";
  os << indent << "HeightArray: " << (this->HeightArray ? this->HeightArray : "(none)") << "\n";
  os << indent << "DiameterArray: " << (this->DiameterArray ? this->DiameterArray : "(none)") << "\n";
  os << indent << "TintVariation: " << this->TintVariation << "\n";
  os << indent << "SlopeLimit: " << this->SlopeLimit << "\n";
  os << indent << "HeightRange: " << this->HeightRange[0] << " " << this->HeightRange[1] << "\n";
  os << indent << "UseLevels: " << this->UseLevels << "\n";
  os << indent << "UseCulling: " << this->UseCulling << "\n";
  os << indent << "FaceCamera: " << this->FaceCamera << "\n";
  os << indent << "OutputForm: " << this->OutputForm << "\n";
  os << indent << "PassJoints: " << (this->PassJoints ? "on" : "off") << "\n";
  os << indent << "PassSurfaces: " << (this->PassSurfaces ? "on" : "off") << "\n";
  os << indent << "PlantsPerCell: " << this->PlantsPerCell << "\n";
  os << indent << "VisibleDistance: " << this->VisibleDistance << "\n";
}
