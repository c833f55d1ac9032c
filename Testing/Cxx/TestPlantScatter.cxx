// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Plants over sites: blocks, ids, terrain, memory between executions, pieces, threads, bad input, a picture.
#include "CameraPicture.h"
#include "Check.h"
#include "ErrorCounter.h"
#include "PlantScene.h"
#include "vtkAonoKuniiTreeSource.h"
#include "vtkGardnerPlantSource.h"
#include "vtkPlantScatterFilter.h"
#include "vtkQuadratPointSource.h"
#include "vtkReevesTreeSource.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkImageShiftScale.h"
#include "vtkInformation.h"
#include "vtkInformationDataObjectMetaDataKey.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPassInputTypeAlgorithm.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTrivialProducer.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <initializer_list>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace
{

using Scatter = vtkPlantScatterFilter;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
const char* const Parts[] = { "High/Skeleton", "High/Skin", "High/Leaves", "Medium/Trunk", "Medium/Crown", "Low" };
constexpr int LevelOfPart[] = { 0, 0, 0, 1, 1, 2 };

/// A forest of pines and shrubs that has plants at all levels.
struct Forest
{
  vtkNew<vtkPolyData> Sites;
  vtkNew<vtkReevesTreeSource> Pine;
  vtkNew<vtkReevesTreeSource> Shrub;
  vtkNew<vtkImageData> Terrain;
  vtkNew<Scatter> Filter;

  explicit Forest(int sites = 60)
  {
    vtkNew<vtkPoints> points;
    for (int site = 0; site < sites; ++site)
    {
      points->InsertNextPoint(7.0 * (site % 8) - 24.5, 9.0 * (site / 8) + 0.5 * (site % 3), 0.1 * site);
    }
    this->Sites->SetPoints(points);
    this->Pine->SetPreset(vtkReevesTreeSource::Custom);
    this->Pine->SetCrownShapeToCone();
    this->Pine->SetNumberOfLeaves(300);
    this->Pine->SetMainBranches(8);
    this->Pine->SetTextureSize(32, 16);
    this->Shrub->SetPreset(vtkReevesTreeSource::Shrub);
    this->Shrub->SetTextureSize(64, 24);
    this->Filter->SetInputData(0, this->Sites);
    this->Filter->AddPrototypeConnection(this->Pine->GetOutputPort());
    this->Filter->AddPrototypeConnection(this->Shrub->GetOutputPort());
    this->Filter->SetViewPoint(0.0, -10.0, 5.0);
    this->Filter->SetViewAngle(60.0);
    this->Filter->SetNearDistance(25.0);
    this->Filter->SetFarDistance(50.0);
  }

  /// Hills of 2 m, from -40 to 40 m along x and from -10 to 90 m along y.
  void AddTerrain()
  {
    this->Terrain->SetOrigin(-40.0, -10.0, 0.0);
    this->Terrain->SetSpacing(4.0, 5.0, 1.0);
    this->Terrain->SetExtent(0, 20, 0, 20, 0, 0);
    vtkNew<vtkDoubleArray> heights;
    heights->SetName("Elevation");
    for (int point = 0; point < 441; ++point)
    {
      heights->InsertNextValue(2.0 * std::sin(0.8 * (point % 21)));
    }
    this->Terrain->GetPointData()->SetScalars(heights);
    this->Filter->SetInputData(2, this->Terrain);
  }

  vtkFieldData* Fields() { return this->Filter->GetOutputDataObject(0)->GetFieldData(); }
  double Counter(const char* name)
  {
    vtkDataArray* counter = this->Fields()->GetArray(name);
    return counter ? counter->GetTuple1(0) : NaN;
  }
  vtkPolyData* Part(const char* path)
  {
    return vtkPolyData::SafeDownCast(BlockAt(this->Filter->GetOutputDataObject(0), path));
  }
  vtkDataArray* Array(const char* path, const char* name) { return this->Part(path)->GetPointData()->GetArray(name); }
};

std::string BytesOf(vtkDataArray* array)
{
  return array ? std::string(static_cast<const char*>(array->GetVoidPointer(0)),
                   static_cast<std::size_t>(array->GetNumberOfValues()) * array->GetDataTypeSize())
               : std::string("none");
}

/// All bytes of the blocks and the table.
std::string BytesOf(Forest& forest)
{
  std::string bytes;
  for (const char* path : Parts)
  {
    vtkPolyData* part = forest.Part(path);
    bytes += BytesOf(part->GetPoints()->GetData());
    for (int array = 0; array < part->GetPointData()->GetNumberOfArrays(); ++array)
    {
      bytes += BytesOf(part->GetPointData()->GetArray(array));
    }
    for (vtkCellArray* cells : { part->GetPolys(), part->GetLines() })
    {
      bytes += BytesOf(cells->GetConnectivityArray()) + BytesOf(cells->GetOffsetsArray());
    }
  }
  for (int array = 0; array < forest.Fields()->GetNumberOfArrays(); ++array)
  {
    bytes += BytesOf(forest.Fields()->GetArray(array));
  }
  return bytes;
}

//----------------------------------------------------------------------------
bool Blocks()
{
  Forest forest;
  forest.Filter->Update();
  bool good = Check(forest.Counter("PlantsHigh") > 0 && forest.Counter("PlantsMedium") > 0 &&
      forest.Counter("PlantsLow") > 0 && forest.Counter("PlantsShown") < 60,
    "the view does not show all levels and leave out plants");
  good &= Check(forest.Counter("PlantsInAll") == 60 &&
      forest.Counter("PlantsShown") ==
        forest.Counter("PlantsHigh") + forest.Counter("PlantsMedium") + forest.Counter("PlantsLow"),
    "counters of plants");
  std::map<int, int> levels; // of the plants, by the table
  vtkFieldData* fields = forest.Fields();
  for (vtkIdType row = 0; row < fields->GetArray("PlantId")->GetNumberOfTuples(); ++row)
  {
    levels[static_cast<int>(fields->GetArray("PlantId")->GetTuple1(row))] =
      static_cast<int>(fields->GetArray("Level")->GetTuple1(row));
  }
  for (const char* name : { "SiteId", "Species", "Scale", "Azimuth", "Position", "Level" })
  {
    good &= Check(fields->GetArray(name)->GetNumberOfTuples() == forest.Counter("PlantsShown"), name);
  }
  double bytes = 0.0;
  for (const char* path : Parts)
  {
    bytes += 1024.0 * forest.Part(path)->GetActualMemorySize();
  }
  good &= Check(std::abs(bytes / forest.Counter("OutputBytes") - 1.0) < 0.05,
    "OutputBytes " + std::to_string(forest.Counter("OutputBytes")) + " for " + std::to_string(bytes));
  double polygons = 0.0;
  for (int part = 0; part < 6; ++part)
  {
    vtkDataArray* ids = forest.Array(Parts[part], "PlantId");
    std::set<int> found;
    for (vtkIdType point = 0; point < ids->GetNumberOfTuples(); ++point)
    {
      found.insert(static_cast<int>(ids->GetTuple1(point)));
    }
    std::set<int> wanted;
    for (const auto& [plant, level] : levels)
    {
      if (level == LevelOfPart[part])
      {
        wanted.insert(plant);
      }
    }
    good &= Check(found == wanted, std::string("plants of ") + Parts[part]);
    polygons += forest.Part(Parts[part])->GetNumberOfPolys();
    // No polygon joins two plants.
    vtkPolyData* data = forest.Part(Parts[part]);
    for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
    {
      vtkIdType size = 0;
      const vtkIdType* corners = nullptr;
      data->GetCellPoints(cell, size, corners);
      for (vtkIdType corner = 1; corner < size; ++corner)
      {
        if (ids->GetTuple1(corners[corner]) != ids->GetTuple1(corners[0]))
        {
          return Check(false, std::string("a cell of two plants in ") + Parts[part]);
        }
      }
    }
  }
  good &= Check(polygons == forest.Counter("PolygonsShown"), "PolygonsShown");
  good &= Check(polygons < forest.Counter("PolygonsInAll"), "PolygonsInAll");
  return good;
}

/// Joints are nodes of the plant's own part of the skeleton, and weights are those of the prototype.
bool Joints()
{
  Forest forest;
  forest.Filter->Update();
  vtkDataArray* ofNode = forest.Array("High/Skeleton", "PlantId");
  vtkDataArray* parents = forest.Array("High/Skeleton", "ParentId");
  bool good = true;
  for (const char* path : { "High/Skin", "High/Leaves" })
  {
    vtkDataArray* joints = forest.Array(path, "JointIds");
    vtkDataArray* plants = forest.Array(path, "PlantId");
    for (vtkIdType point = 0; good && point < joints->GetNumberOfTuples(); ++point)
    {
      for (int joint = 0; joint < 4; ++joint)
      {
        const auto node = static_cast<vtkIdType>(joints->GetComponent(point, joint));
        good = good && node >= 0 && node < ofNode->GetNumberOfTuples() &&
          ofNode->GetTuple1(node) == plants->GetTuple1(point);
      }
    }
  }
  std::set<double> rooted;
  for (vtkIdType node = 0; good && node < parents->GetNumberOfTuples(); ++node)
  {
    const auto parent = static_cast<vtkIdType>(parents->GetTuple1(node));
    good = parent < node && (parent < 0 || ofNode->GetTuple1(parent) == ofNode->GetTuple1(node));
    if (parent < 0)
    {
      rooted.insert(ofNode->GetTuple1(node));
    }
  }
  vtkDataArray* ofBranch = forest.Part("High/Skeleton")->GetCellData()->GetArray("PlantId");
  good = good && ofBranch && ofBranch->GetNumberOfTuples() == forest.Part("High/Skeleton")->GetNumberOfLines();
  return Check(good && rooted.size() == forest.Counter("PlantsHigh"), "joints, parents or roots of another plant");
}

/// The lowest point of a plant's trunk stands on the terrain, at the site.
bool Ground()
{
  Forest forest;
  forest.AddTerrain();
  forest.Filter->UseLevelsOff();
  forest.Filter->UseCullingOff();
  forest.Filter->Update();
  bool good = Check(forest.Counter("PlantsHigh") == 60, "not all plants are High without levels and cells");
  vtkDataArray* positions = forest.Fields()->GetArray("Position");
  vtkDataArray* parents = forest.Array("High/Skeleton", "ParentId");
  vtkDataArray* plants = forest.Array("High/Skeleton", "PlantId");
  for (vtkIdType node = 0; node < parents->GetNumberOfTuples(); ++node)
  {
    const auto plant = static_cast<vtkIdType>(plants->GetTuple1(node));
    double site[3];
    forest.Sites->GetPoint(plant, site);
    const double cell = (site[0] + 40.0) / 4.0;
    const double part = cell - std::floor(cell);
    const double height =
      2.0 * ((1.0 - part) * std::sin(0.8 * std::floor(cell)) + part * std::sin(0.8 * (std::floor(cell) + 1.0)));
    const double* foot = positions->GetTuple3(plant);
    good &=
      std::abs(foot[0] - site[0]) < 1e-6 && std::abs(foot[1] - site[1]) < 1e-6 && std::abs(foot[2] - height) < 1e-6;
  }
  good = Check(good, "plants do not stand on the terrain");
  forest.Filter->SetHeightRange(0.0, 1.5);
  forest.Filter->Update();
  const double within = forest.Counter("PlantsInAll");
  good &= Check(within > 0 && within < 60, "HeightRange");
  forest.Filter->SetHeightRange(-10.0, 10.0);
  forest.Filter->SetSlopeLimit(8.0);
  forest.Filter->Update();
  good &= Check(forest.Counter("PlantsInAll") > 0 && forest.Counter("PlantsInAll") < 60, "SlopeLimit");
  return good;
}

/// Arrays of the sites win over what is drawn; identity, not the index, decides what is drawn.
bool Arrays()
{
  Forest forest(10);
  vtkNew<vtkIntArray> species;
  species->SetName("Species");
  vtkNew<vtkDoubleArray> scale;
  scale->SetName("Scale");
  vtkNew<vtkDoubleArray> azimuth;
  azimuth->SetName("Azimuth");
  for (int site = 0; site < 10; ++site)
  {
    species->InsertNextValue(site % 2);
    scale->InsertNextValue(0.5 + 0.1 * site);
    azimuth->InsertNextValue(0.3 * site);
  }
  for (vtkDataArray* array : std::initializer_list<vtkDataArray*>{ species, scale, azimuth })
  {
    forest.Sites->GetPointData()->AddArray(array);
  }
  forest.Filter->UseCullingOff();
  forest.Filter->Update();
  bool good = true;
  for (int plant = 0; plant < 10; ++plant)
  {
    good &= forest.Fields()->GetArray("Species")->GetTuple1(plant) == plant % 2 &&
      forest.Fields()->GetArray("Scale")->GetTuple1(plant) == scale->GetValue(plant) &&
      forest.Fields()->GetArray("Azimuth")->GetTuple1(plant) == azimuth->GetValue(plant);
  }
  good = Check(good, "arrays of the sites");

  Forest all(10);
  Forest some(5); // the same sites as 5 to 9 of all
  vtkNew<vtkTypeInt64Array> id;
  id->SetName("SiteId");
  for (int site = 0; site < 5; ++site)
  {
    id->InsertNextValue(5 + site);
    some.Sites->GetPoints()->SetPoint(site, all.Sites->GetPoint(5 + site));
  }
  some.Sites->GetPointData()->AddArray(id);
  for (Forest* each : { &all, &some })
  {
    each->Filter->UseCullingOff();
    each->Filter->Update();
  }
  for (const char* name : { "SiteId", "Species", "Scale", "Azimuth" })
  {
    for (int site = 0; site < 5; ++site)
    {
      good &= Check(some.Fields()->GetArray(name)->GetTuple1(site) == all.Fields()->GetArray(name)->GetTuple1(5 + site),
        std::string(name) + " depends on the other sites");
    }
  }
  return good;
}

/// What is kept between executions never shows: the same bytes as from a new filter.
bool Memory()
{
  Forest old;
  old.Filter->Update();
  const std::string before = BytesOf(old);
  bool good = true;
  const auto changes = std::vector<std::pair<const char*, std::function<void(Forest&)>>>{
    { "the view", [](Forest& f) { f.Filter->SetViewPoint(3.0, -15.0, 4.0); } },
    { "Seed", [](Forest& f) { f.Filter->SetSeed(8); } },
    { "Weight", [](Forest& f) { f.Filter->SetWeight(1, 0.1); } },
    { "ScaleVariation", [](Forest& f) { f.Filter->SetScaleVariation(0.3); } },
    { "TintVariation", [](Forest& f) { f.Filter->SetTintVariation(0.2); } },
    { "HeightRange", [](Forest& f) { f.Filter->SetHeightRange(1.0, 3.0); } },
    { "PlantsPerCell", [](Forest& f) { f.Filter->SetPlantsPerCell(30.0); } },
    { "VisibleDistance", [](Forest& f) { f.Filter->SetVisibleDistance(40.0); } },
    { "a prototype", [](Forest& f) { f.Pine->SetSeed(3); } },
    { "a site",
      [](Forest& f) {
        f.Sites->GetPoints()->SetPoint(3, 1.0, 2.0, 3.0);
        f.Sites->GetPoints()->Modified();
      } },
    { "the terrain", [](Forest& f) { f.AddTerrain(); } },
  };
  for (const auto& [what, change] : changes)
  {
    Forest kept;
    kept.Filter->Update();
    change(kept);
    kept.Filter->Update();
    Forest fresh;
    change(fresh);
    fresh.Filter->Update();
    good &= Check(BytesOf(kept) == BytesOf(fresh), std::string("stale after a change of ") + what);
    good &= Check(BytesOf(kept) != before, std::string("no effect of ") + what);
  }
  return good;
}

bool Threads()
{
  Forest forest;
  vtkSMPTools::Initialize(1);
  forest.Filter->Update();
  const std::string one = BytesOf(forest);
  vtkSMPTools::Initialize(2);
  forest.Filter->Modified();
  forest.Filter->Update();
  return Check(one == BytesOf(forest), "bytes depend on the number of threads");
}

bool Pieces()
{
  Forest forest;
  forest.Filter->Update();
  std::map<std::string, double> whole;
  const char* const counters[] = { "PlantsInAll", "PlantsShown", "PlantsHigh", "PlantsMedium", "PlantsLow",
    "PolygonsShown", "PolygonsInAll", "OutputBytes" };
  for (const char* name : counters)
  {
    whole[name] = forest.Counter(name);
  }
  std::string points;
  for (const char* path : Parts)
  {
    points += BytesOf(forest.Part(path)->GetPoints()->GetData());
  }
  bool good = true;
  for (int pieces : { 2, 3, 7 })
  {
    std::map<std::string, double> sums;
    std::map<std::string, std::string> joined;
    for (int piece = 0; piece < pieces; ++piece)
    {
      forest.Filter->UpdatePiece(piece, pieces, 0);
      for (const char* name : counters)
      {
        sums[name] += forest.Counter(name);
      }
      for (const char* path : Parts)
      {
        joined[path] += BytesOf(forest.Part(path)->GetPoints()->GetData());
      }
    }
    std::string all;
    for (const char* path : Parts)
    {
      all += joined[path];
    }
    good &= Check(all == points, "pieces do not make the whole");
    for (const char* name : counters)
    {
      // Each piece has an end of its own in its arrays of offsets.
      const bool same = std::strcmp(name, "OutputBytes") == 0 || sums[name] == whole[name];
      good &= Check(same, std::string("pieces do not sum up: ") + name);
    }
  }
  return good;
}

/// The atlas is the prototypes' pictures one above the other, and leaves' coordinates point into their own.
bool Atlas()
{
  Forest forest;
  forest.Filter->UseLevelsOff();
  forest.Filter->UseCullingOff();
  forest.Filter->Update();
  auto* image = vtkImageData::SafeDownCast(forest.Filter->GetOutputDataObject(1));
  int size[3];
  image->GetDimensions(size);
  bool good = Check(size[0] == 64 + 4 && size[1] == 16 + 24 + 8 && size[2] == 1, "size of the atlas of crowns");
  auto* crown = vtkImageData::SafeDownCast(forest.Shrub->GetOutputDataObject(1));
  for (int row = 0; row < 24; ++row)
  {
    for (int column = 0; column < 64; ++column)
    {
      for (int channel = 0; channel < 4; ++channel)
      {
        good &= image->GetScalarComponentAsDouble(column + 2, 16 + 4 + 2 + row, 0, channel) ==
          crown->GetScalarComponentAsDouble(column, row, 0, channel);
      }
    }
  }
  good = Check(good, "the atlas does not hold the shrub's crown");
  vtkDataArray* species = forest.Fields()->GetArray("Species");
  vtkDataArray* plants = forest.Array("High/Leaves", "PlantId");
  vtkDataArray* coordinates = forest.Part("High/Leaves")->GetPointData()->GetTCoords();
  auto* leaves = vtkImageData::SafeDownCast(forest.Filter->GetOutputDataObject(2));
  const double middle = 0.5; // two pictures of the same height
  for (vtkIdType point = 0; good && point < coordinates->GetNumberOfTuples(); ++point)
  {
    const double v = coordinates->GetComponent(point, 1);
    good =
      v > 0.0 && v < 1.0 && (v > middle) == (species->GetTuple1(static_cast<vtkIdType>(plants->GetTuple1(point))) == 1);
  }
  good = Check(good && leaves->GetDimensions()[1] > 0, "leaves point into the picture of another species");
  vtkDataArray* texels = forest.Part("Medium/Crown")->GetFieldData()->GetArray("Texture");
  return Check(
    good && texels && texels->GetNumberOfTuples() == size[0] * size[1], "the crown does not carry the atlas");
}

/// Passes data on, and counts how often.
class CountingFilter : public vtkPassInputTypeAlgorithm
{
public:
  static CountingFilter* New();
  vtkTypeMacro(CountingFilter, vtkPassInputTypeAlgorithm);

  int Executions = 0;
  /// Whether what is announced with the data is held back.
  bool IsSilent = false;

protected:
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    if (this->IsSilent)
    {
      outputs->GetInformationObject(0)->Remove(vtkPlantSource::TEXTURE_SIZES());
    }
    return 1;
  }
  int RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    ++this->Executions;
    vtkDataObject::GetData(outputs)->ShallowCopy(vtkDataObject::GetData(inputs[0]));
    return 1;
  }
};
vtkStandardNewMacro(CountingFilter);

/// Columns and rows of an image that is announced, or that is there.
std::array<int, 2> Announced(vtkAlgorithm* algorithm, int port)
{
  int extent[6];
  algorithm->GetOutputInformation(port)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  return { extent[1] + 1, extent[3] + 1 };
}
std::array<int, 2> Columns(vtkAlgorithm* algorithm, int port)
{
  auto* image = vtkImageData::SafeDownCast(algorithm->GetOutputDataObject(port));
  return { image->GetDimensions()[0], image->GetDimensions()[1] };
}

/// Sizes of the pictures are announced right, and nothing upstream executes for that.
bool Information()
{
  Forest forest;
  vtkNew<CountingFilter> sites;
  vtkNew<CountingFilter> pine;
  sites->SetInputData(forest.Sites);
  pine->SetInputConnection(forest.Pine->GetOutputPort());
  forest.Filter->RemoveAllPrototypes();
  forest.Filter->SetInputConnection(0, sites->GetOutputPort());
  forest.Filter->AddPrototypeConnection(pine->GetOutputPort());
  forest.Filter->AddPrototypeConnection(forest.Shrub->GetOutputPort());
  int executions = 0;
  for (vtkAlgorithm* source : { forest.Pine.Get(), forest.Shrub.Get() })
  {
    vtkNew<vtkCallbackCommand> count;
    count->SetClientData(&executions);
    count->SetCallback([](vtkObject*, unsigned long, void* counter, void*) { ++*static_cast<int*>(counter); });
    source->AddObserver(vtkCommand::StartEvent, count);
  }
  forest.Filter->UpdateInformation();
  bool good = Check(
    sites->Executions == 0 && pine->Executions == 0 && executions == 0, "inputs execute when information is asked for");
  good &= Check(Announced(forest.Filter, 1) == std::array<int, 2>{ 64 + 4, 16 + 24 + 8 }, "crowns announced");
  const std::array<int, 2> leaves = Announced(forest.Filter, 2);
  forest.Filter->Update();
  good &= Check(sites->Executions == 1 && pine->Executions == 1 && executions == 2, "inputs must execute once each");
  good &= Check(Columns(forest.Filter, 1) == Announced(forest.Filter, 1), "crowns are not as announced");
  good &= Check(Columns(forest.Filter, 2) == leaves, "leaves are not as announced");
  const vtkMTimeType before = forest.Filter->GetMTime();
  forest.Pine->SetTextureSize(128, 8);
  forest.Filter->UpdateInformation();
  good &= Check(Announced(forest.Filter, 1) == std::array<int, 2>{ 128 + 4, 8 + 24 + 8 } && executions == 2,
    "another size is not announced, or its source executes");
  forest.Filter->Update();
  return good &
    Check(Columns(forest.Filter, 1) == Announced(forest.Filter, 1) && forest.Filter->GetMTime() == before,
      "another size is not as announced");
}

/// Prototypes of which nothing is announced: pictures are as announced if the data are there, else after an execution.
bool SilentPrototypes()
{
  Forest there;
  there.Pine->Update();
  there.Filter->RemoveAllPrototypes();
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(there.Pine->GetOutputDataObject(0));
  there.Filter->AddPrototypeConnection(producer->GetOutputPort());
  there.Filter->UpdateInformation();
  bool good = Check(
    Announced(there.Filter, 1) == std::array<int, 2>{ 32 + 4, 16 + 4 }, "the size of a picture that is there is wrong");

  Forest forest;
  vtkNew<CountingFilter> pine;
  pine->IsSilent = true;
  pine->SetInputConnection(forest.Pine->GetOutputPort());
  forest.Filter->RemoveAllPrototypes();
  forest.Filter->AddPrototypeConnection(pine->GetOutputPort());
  vtkNew<vtkImageShiftScale> later;
  later->SetInputConnection(forest.Filter->GetOutputPort(1));
  forest.Filter->UpdateInformation();
  good &= Check(pine->Executions == 0, "a silent prototype executes when information is asked for");
  for (const int columns : { 32, 60 })
  {
    forest.Pine->SetTextureSize(columns, 16);
    const std::array<int, 2> size{ columns + 4, 16 + 4 };
    forest.Filter->Update();
    good &= Check(Columns(forest.Filter, 1) == size && Announced(forest.Filter, 1) == size, "a picture is not whole");
    later->UpdateWholeExtent();
    good &= Check(Columns(later, 0) == size, "a filter of a picture does not see all of it");
  }
  return good & Check(pine->Executions == 2, "a silent prototype executes more than once");
}

/// What plant sources announce of their textures is what the textures are.
bool AnnouncedTextures()
{
  vtkNew<vtkReevesTreeSource> reeves;
  vtkNew<vtkAonoKuniiTreeSource> aono;
  vtkNew<vtkGardnerPlantSource> gardner;
  bool good = true;
  for (vtkPlantSource* source : std::initializer_list<vtkPlantSource*>{ reeves, aono, gardner })
  {
    source->SetTextureSize(48, 20);
    source->UpdateInformation();
    vtkDataObject* sizes = source->GetOutputInformation(0)->Get(vtkPlantSource::TEXTURE_SIZES());
    source->Update();
    for (const char* path : { "Medium/Crown", "High/Leaves" })
    {
      vtkDataArray* size = BlockAt(source->GetOutputDataObject(0), path)->GetFieldData()->GetArray("TextureSize");
      vtkDataArray* announced = sizes ? sizes->GetFieldData()->GetArray(std::strrchr(path, '/') + 1) : nullptr;
      good &= Check(size && announced && announced->GetComponent(0, 0) == size->GetVariantValue(0).ToDouble() &&
          announced->GetComponent(0, 1) == size->GetVariantValue(1).ToDouble(),
        std::string(source->GetClassName()) + ": the texture of " + path + " is not as announced");
    }
  }
  return good;
}

/// A plant of quadrics among trees of particles: each shows its own part of the common picture of leaves.
bool MixedKinds()
{
  Forest forest;
  vtkNew<vtkGardnerPlantSource> bush;
  bush->SetPreset(vtkGardnerPlantSource::Bush);
  bush->SetTextureSize(32, 16);
  forest.Filter->AddPrototypeConnection(bush->GetOutputPort());
  forest.Filter->UseLevelsOff();
  forest.Filter->UseCullingOff();
  forest.Filter->Update();
  auto* atlas = vtkImageData::SafeDownCast(forest.Filter->GetOutputDataObject(2));
  auto* own = vtkImageData::SafeDownCast(bush->GetOutputDataObject(2));
  auto* leaf = vtkImageData::SafeDownCast(forest.Pine->GetOutputDataObject(2));
  const int* size = atlas->GetDimensions();
  bool good = Check(
    size[0] == own->GetDimensions()[0] + 4 && size[1] == own->GetDimensions()[1] + 2 * leaf->GetDimensions()[1] + 12,
    "the pictures of leaves do not lie one above the other");
  int announced[6];
  forest.Filter->GetOutputInformation(2)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), announced);
  good &= Check(announced[1] == size[0] - 1 && announced[3] == size[1] - 1, "the announced picture of leaves");
  vtkDataArray* plants = forest.Array("High/Leaves", "PlantId");
  vtkDataArray* coordinates = forest.Array("High/Leaves", "TCoords");
  vtkDataArray* species = forest.Fields()->GetArray("Species");
  auto* bushLeaves = vtkPolyData::SafeDownCast(BlockAt(bush->GetOutputDataObject(0), "High/Leaves"));
  vtkDataArray* bushCoordinates = bushLeaves->GetPointData()->GetTCoords();
  // The bush is the third from the foot; each picture has a border of two texels.
  const int corner[2] = { 2, 2 * (leaf->GetDimensions()[1] + 4) + 2 };
  for (int row = 0; row < own->GetDimensions()[1]; ++row)
  {
    const auto* from = static_cast<unsigned char*>(own->GetScalarPointer(0, row, 0));
    const auto* to = static_cast<unsigned char*>(atlas->GetScalarPointer(corner[0], corner[1] + row, 0));
    if (std::memcmp(from, to, 4 * static_cast<std::size_t>(own->GetDimensions()[0])) != 0)
    {
      return Check(false, "the picture of leaves is not in the common one");
    }
  }
  std::map<int, vtkIdType> next; // vertex of the bush, by plant
  vtkIdType compared = 0;
  double farthest = 0.0; // [texels]
  for (vtkIdType point = 0; point < plants->GetNumberOfTuples(); ++point)
  {
    const int plant = static_cast<int>(plants->GetTuple1(point));
    if (species->GetTuple1(plant) != 2.0)
    {
      continue;
    }
    ++compared;
    const vtkIdType vertex = next[plant]++;
    for (int axis = 0; axis < 2; ++axis)
    {
      const double there = coordinates->GetComponent(point, axis) * size[axis];
      const double here = bushCoordinates->GetComponent(vertex, axis) * own->GetDimensions()[axis];
      farthest = std::max(farthest, std::abs(there - corner[axis] - here));
    }
  }
  const auto bushes = static_cast<vtkIdType>(next.size());
  good &= Check(bushes > 0 && bushes < 60, "the kinds are not mixed");
  good &= Check(compared == bushes * bushLeaves->GetNumberOfPoints(), "leaves of quadrics got lost");
  return good & Check(farthest < 1e-3, "quadrics show another part of the picture of leaves");
}

bool EmptySites()
{
  Forest forest(0);
  vtkNew<ErrorCounter> errors;
  errors->Watch(forest.Filter);
  forest.Filter->Update();
  bool good = Check(errors->Count == 0, "an error without sites: " + errors->Last);
  Forest full;
  full.Filter->Update();
  for (const char* path : Parts)
  {
    good &= Check(forest.Part(path) && forest.Part(path)->GetNumberOfPoints() == 0, path);
    good &= Check(
      forest.Part(path)->GetPointData()->GetNumberOfArrays() == full.Part(path)->GetPointData()->GetNumberOfArrays(),
      std::string("arrays of the empty ") + path);
  }
  return good;
}

bool Fails(const char* word, const std::function<void(Forest&)>& spoil)
{
  Forest forest;
  spoil(forest);
  vtkNew<ErrorCounter> errors;
  errors->Watch(forest.Filter);
  // Twice: nothing bad is kept.
  bool good = errors->ExpectOneNaming(word) && errors->ExpectOneNaming(word);
  return Check(good && !forest.Part("Low"), word);
}

void SetSiteArray(Forest& forest, const char* name, double bad)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (vtkIdType site = 0; site < forest.Sites->GetNumberOfPoints(); ++site)
  {
    array->InsertNextValue(site == 7 ? bad : 1.0);
  }
  forest.Sites->GetPointData()->AddArray(array);
}

/// Replaces the second prototype by one without a block.
void Drop(Forest& forest, const char* name)
{
  forest.Shrub->Update();
  vtkNew<vtkMultiBlockDataSet> spoiled;
  auto* whole = vtkMultiBlockDataSet::SafeDownCast(forest.Shrub->GetOutputDataObject(0));
  for (unsigned int index = 0; index < whole->GetNumberOfBlocks(); ++index)
  {
    const char* own = whole->GetMetaData(index)->Get(vtkCompositeDataSet::NAME());
    if (std::strcmp(own, name) != 0)
    {
      const unsigned int next = spoiled->GetNumberOfBlocks();
      spoiled->SetBlock(next, whole->GetBlock(index));
      spoiled->GetMetaData(next)->Set(vtkCompositeDataSet::NAME(), own);
    }
  }
  forest.Filter->RemoveInputConnection(1, 1);
  forest.Filter->AddInputDataObject(1, spoiled);
}

bool BadInput()
{
  return Fails("no prototypes", [](Forest& f) { f.Filter->RemoveAllInputConnections(1); }) &
    Fails("Prototype 1 cannot be scattered: its level High", [](Forest& f) { Drop(f, "High"); }) &
    Fails("Prototype 1 cannot be scattered: its level Medium", [](Forest& f) { Drop(f, "Medium"); }) &
    Fails("Prototype 1 cannot be scattered: its level Low", [](Forest& f) { Drop(f, "Low"); }) &
    Fails("site 4 lies at", [](Forest& f) { f.Sites->GetPoints()->SetPoint(4, 0.0, NaN, 0.0); }) &
    Fails("Weight 1", [](Forest& f) { f.Filter->SetWeight(1, -1.0); }) &
    Fails("Weights",
      [](Forest& f) {
        f.Filter->SetWeight(0, 0.0);
        f.Filter->SetWeight(1, 0.0);
      }) &
    Fails("Species of site 7 is 2", [](Forest& f) { SetSiteArray(f, "Species", 2.0); }) &
    Fails("Species of site 7 is 0.5", [](Forest& f) { SetSiteArray(f, "Species", 0.5); }) &
    Fails("Scale of site 7", [](Forest& f) { SetSiteArray(f, "Scale", 0.0); }) &
    Fails("Azimuth of site 7", [](Forest& f) { SetSiteArray(f, "Azimuth", NaN); }) &
    Fails("of 60 sites, 2 lie outside",
      [](Forest& f) {
        f.AddTerrain();
        f.Sites->GetPoints()->SetPoint(1, 41.0, 0.0, 0.0);
        f.Sites->GetPoints()->SetPoint(2, 0.0, 91.0, 0.0);
      }) &
    Fails("no height",
      [](Forest& f) {
        f.AddTerrain();
        f.Terrain->GetPointData()->GetScalars()->FillComponent(0, NaN);
      }) &
    Fails("Terrain",
      [](Forest& f) {
        f.AddTerrain();
        f.Terrain->GetPointData()->Initialize();
      }) &
    Fails("ScaleVariation", [](Forest& f) { f.Filter->SetScaleVariation(0.6); }) &
    Fails("TintVariation", [](Forest& f) { f.Filter->SetTintVariation(NaN); }) &
    Fails("SlopeLimit", [](Forest& f) { f.Filter->SetSlopeLimit(-1.0); }) &
    Fails("HeightRange", [](Forest& f) { f.Filter->SetHeightRange(2.0, 1.0); }) &
    Fails("PlantsPerCell", [](Forest& f) { f.Filter->SetPlantsPerCell(0.0); }) &
    Fails("VisibleDistance", [](Forest& f) { f.Filter->SetVisibleDistance(-1.0); }) &
    Fails("NearDistance", [](Forest& f) { f.Filter->SetNearDistance(300.0); }) &
    Fails("ViewAngle", [](Forest& f) { f.Filter->SetViewAngle(0.0); }) & Fails("ParallelScale", [](Forest& f) {
      f.Filter->ParallelProjectionOn();
      f.Filter->SetParallelScale(0.0);
    });
}

/// Every plant of which a vertex is on the picture, by the camera's own matrix, is shown, whatever the camera is and
/// with views that are rounded; many others are not.
bool Culling()
{
  constexpr int Plants = 80;
  Forest whole(Plants);
  whole.Filter->UseLevelsOff();
  whole.Filter->UseCullingOff();
  whole.Filter->Update();
  std::vector<std::vector<std::array<double, 3>>> vertices(Plants);
  for (const char* path : { "High/Skin", "High/Leaves" })
  {
    vtkPolyData* part = whole.Part(path);
    vtkDataArray* ids = whole.Array(path, "PlantId");
    for (vtkIdType point = 0; point < part->GetNumberOfPoints(); ++point)
    {
      std::array<double, 3> place;
      part->GetPoint(point, place.data());
      vertices[static_cast<std::size_t>(ids->GetTuple1(point))].push_back(place);
    }
  }
  Forest forest(Plants);
  forest.Filter->SetNearDistance(0.0);
  forest.Filter->SetFarDistance(0.0);
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;
  window->AddRenderer(renderer);
  forest.Filter->Follow(renderer);
  vtkCamera* camera = renderer->GetActiveCamera();
  const double middle[3] = { 0.0, 45.0, 5.0 };
  std::mt19937 random(3);
  int seen[2] = { 0, 0 };
  int lost[2] = { 0, 0 };
  int left = 0;
  for (int round = 0; round < 60; ++round)
  {
    LookFromAnywhere(camera, random, middle, 50.0);
    const int size[2] = { 100 + 40 * (round % 7), 300 - 40 * (round % 5) };
    window->SetSize(size[0], size[1]);
    forest.Filter->SetMoveTolerance(round % 3 == 0 ? 1.0 : 0.0);
    forest.Filter->SetTurnTolerance(round % 3 == 0 ? 3.0 : 0.0);
    renderer->InvokeEvent(vtkCommand::StartEvent);
    forest.Filter->Update();
    std::set<int> shown;
    vtkDataArray* plants = forest.Fields()->GetArray("PlantId");
    for (vtkIdType row = 0; row < plants->GetNumberOfTuples(); ++row)
    {
      shown.insert(static_cast<int>(plants->GetTuple1(row)));
    }
    left += Plants - static_cast<int>(shown.size());
    const CameraPicture picture(camera, size[0], size[1]);
    for (int plant = 0; plant < Plants; ++plant)
    {
      const auto& own = vertices[static_cast<std::size_t>(plant)];
      const bool isSeen =
        std::any_of(own.begin(), own.end(), [&](const auto& place) { return picture.Shows(place.data()); });
      seen[camera->GetParallelProjection()] += isSeen ? 1 : 0;
      lost[camera->GetParallelProjection()] += isSeen && shown.count(plant) == 0 ? 1 : 0;
    }
  }
  const std::string counts = std::to_string(seen[0]) + " and " + std::to_string(seen[1]) + " plants are seen, " +
    std::to_string(left) + " left out";
  return Check(seen[0] > 300 && seen[1] > 300 && left > 1200, counts) &
    Check(lost[0] == 0, std::to_string(lost[0]) + " plants are lost in perspective; " + counts) &
    Check(lost[1] == 0, std::to_string(lost[1]) + " plants are lost in parallel projection; " + counts);
}

/// In parallel projection all plants are as large as in a perspective of the same angle at one distance.
bool LevelsInParallel()
{
  Forest forest;
  vtkNew<vtkCamera> camera;
  camera->SetPosition(0.0, -500.0, 5.0);
  camera->SetFocalPoint(0.0, 0.0, 5.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->ParallelProjectionOn();
  bool good = true;
  const double angle = 2.0 * std::atan(0.5) * 180.0 / vtkMath::Pi(); // 2 m of scale a metre
  camera->SetViewAngle(angle);
  const char* const counters[] = { "PlantsHigh", "PlantsMedium", "PlantsLow" };
  const double scales[] = { 12.0, 13.0, 26.0 }; // of the distances 24, 26 and 52
  for (int level = 0; level < 3; ++level)
  {
    camera->SetParallelScale(scales[level]);
    forest.Filter->SetCamera(camera);
    forest.Filter->Update();
    good &= Check(forest.Counter("PlantsShown") > 5 && forest.Counter(counters[level]) == forest.Counter("PlantsShown"),
      std::string("not all are ") + counters[level]);
  }
  forest.Filter->SetVisibleDistance(520.0); // from the plane of the eye
  forest.Filter->Update();
  bool far = false;
  vtkDataArray* places = forest.Fields()->GetArray("Position");
  for (vtkIdType row = 0; row < places->GetNumberOfTuples(); ++row)
  {
    far |= places->GetComponent(row, 1) > 20.0;
  }
  return good & Check(places->GetNumberOfTuples() > 5 && !far, "VisibleDistance in parallel projection");
}

/// More plants in full than any memory holds: an error before any of it is asked for.
bool TooMuch()
{
  vtkNew<vtkQuadratPointSource> sites;
  sites->SetQuadrats(1000, 1000);
  Forest forest;
  vtkNew<vtkReevesTreeSource> oak;
  forest.Filter->SetInputConnection(0, sites->GetOutputPort());
  forest.Filter->SetInputConnection(1, oak->GetOutputPort());
  forest.Filter->UseLevelsOff();
  forest.Filter->UseCullingOff();
  vtkNew<ErrorCounter> errors;
  errors->Watch(forest.Filter);
  return Check(errors->ExpectOneNaming("GB are free") && errors->Last.find("1000000 plants") != std::string::npos,
    "a million trees in full");
}

}

int TestPlantScatter(int argc, char* argv[])
{
  if (!Blocks() || !Joints() || !Ground() || !Arrays() || !Memory() || !Threads() || !Pieces() || !Atlas() ||
    !Information() || !SilentPrototypes() || !AnnouncedTextures() || !MixedKinds() || !EmptySites() || !BadInput() ||
    !TooMuch() || !Culling() || !LevelsInParallel())
  {
    return EXIT_FAILURE;
  }
  // Pines and shrubs on hills, all three levels.
  PlantScene scene;
  Forest forest;
  forest.AddTerrain();
  forest.Pine->SetPreset(vtkReevesTreeSource::Pine);
  const double eye[3] = { 4.0, -52.0, 20.0 };
  const double focus[3] = { 0.0, 30.0, 5.0 };
  constexpr double Angle = 20.0;
  forest.Filter->SetViewPoint(eye);
  forest.Filter->SetViewDirection(focus[0] - eye[0], focus[1] - eye[1], focus[2] - eye[2]);
  forest.Filter->SetViewAngle(Angle);
  forest.Filter->SetAspectRatio(2.5);
  forest.Filter->SetNearDistance(70.0);
  forest.Filter->SetFarDistance(100.0);
  forest.Filter->Update();
  auto* crowns = vtkImageData::SafeDownCast(forest.Filter->GetOutputDataObject(1));
  auto* leaves = vtkImageData::SafeDownCast(forest.Filter->GetOutputDataObject(2));
  scene.Add(forest.Part("High/Skin"), 0.0);
  scene.Add(forest.Part("High/Leaves"), 0.0, leaves);
  scene.Add(forest.Part("Medium/Trunk"), 0.0);
  scene.Add(forest.Part("Medium/Crown"), 0.0, crowns, true);
  scene.Add(forest.Part("Low"), 0.0);
  return scene.Compare(argc, argv, eye, focus, Angle);
}
