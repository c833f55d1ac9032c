// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Plants over sites: blocks, ids, terrain, memory between executions, pieces, threads, a picture.
#include "Check.h"
#include "ErrorCounter.h"
#include "PlantScene.h"
#include "ScatteredForest.h"
#include "vtkReevesTreeSource.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkTypeInt64Array.h"

#include <cmath>
#include <cstring>
#include <functional>
#include <initializer_list>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace
{

constexpr int LevelOfPart[] = { 0, 0, 0, 1, 1, 2 };

//----------------------------------------------------------------------------
bool Blocks(const Forest& grown)
{
  Forest forest(60, &grown);
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
    good &=
      Check(static_cast<double>(fields->GetArray(name)->GetNumberOfTuples()) == forest.Counter("PlantsShown"), name);
  }
  double bytes = 0.0;
  for (const char* path : Parts)
  {
    vtkPolyData* part = forest.Part(path);
    bytes += 1024.0 * static_cast<double>(part->GetActualMemorySize() - part->GetFieldData()->GetActualMemorySize());
  }
  good &= Check(std::abs(bytes / forest.Counter("OutputBytes") - 1.0) < 0.05,
    "OutputBytes " + std::to_string(forest.Counter("OutputBytes")) + " for " + std::to_string(bytes));
  vtkIdType polygonsInParts = 0;
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
    polygonsInParts += forest.Part(Parts[part])->GetNumberOfPolys();
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
  const auto polygons = static_cast<double>(polygonsInParts);
  good &= Check(polygons == forest.Counter("PolygonsShown"), "PolygonsShown");
  good &= Check(polygons < forest.Counter("PolygonsInAll"), "PolygonsInAll");
  return good;
}

/// Joints are nodes of the plant's own part of the skeleton, and weights are those of the prototype.
bool Joints(const Forest& grown)
{
  Forest forest(60, &grown);
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
  return Check(good && static_cast<double>(rooted.size()) == forest.Counter("PlantsHigh"),
    "joints, parents or roots of another plant");
}

/// The lowest point of a plant's trunk stands on the terrain, at the site.
bool Ground(const Forest& grown)
{
  Forest forest(60, &grown);
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
bool Arrays(const Forest& grown)
{
  Forest forest(10, &grown);
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

  Forest all(10, &grown);
  Forest some(5, &grown); // the same sites as 5 to 9 of all
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
/// It changes the trees.
bool Memory(Forest& old)
{
  old.Filter->Update();
  const std::string before = BytesOf(old);
  bool good = true;
  const auto changes = std::vector<std::pair<const char*, std::function<void(Forest&)>>>{
    { "the view", [](Forest& f) { f.Filter->SetViewPoint(3.0, -15.0, 4.0); } },
    { "Seed", [](Forest& f) { f.Filter->SetSeed(8); } }, { "Weight", [](Forest& f) { f.Filter->SetWeight(1, 0.1); } },
    { "ScaleVariation", [](Forest& f) { f.Filter->SetScaleVariation(0.3); } },
    { "TintVariation", [](Forest& f) { f.Filter->SetTintVariation(0.2); } },
    { "HeightRange", [](Forest& f) { f.Filter->SetHeightRange(1.0, 3.0); } },
    { "PlantsPerCell", [](Forest& f) { f.Filter->SetPlantsPerCell(30.0); } },
    { "VisibleDistance", [](Forest& f) { f.Filter->SetVisibleDistance(40.0); } },
    { "a site",
      [](Forest& f) {
        f.Sites->GetPoints()->SetPoint(3, 1.0, 2.0, 3.0);
        f.Sites->GetPoints()->Modified();
      } },
    { "the terrain", [](Forest& f) { f.AddTerrain(); } },
    { "a prototype", [&](Forest&) { old.Pine->SetSeed(3); } }, // the last, since all forests have the trees of the old
  };
  for (const auto& [what, change] : changes)
  {
    Forest kept(60, &old);
    kept.Filter->Update();
    change(kept);
    kept.Filter->Update();
    Forest fresh(60, &old);
    change(fresh);
    fresh.Filter->Update();
    const std::string after = BytesOf(kept);
    good &= Check(after == BytesOf(fresh), std::string("stale after a change of ") + what);
    good &= Check(after != before, std::string("no effect of ") + what);
  }
  return good;
}

bool Threads(const Forest& grown)
{
  Forest forest(60, &grown);
  vtkSMPTools::Initialize(1);
  forest.Filter->Update();
  const std::string one = BytesOf(forest);
  vtkSMPTools::Initialize(2);
  forest.Filter->Modified();
  forest.Filter->Update();
  return Check(one == BytesOf(forest), "bytes depend on the number of threads");
}

bool Pieces(const Forest& grown)
{
  Forest forest(60, &grown);
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

bool EmptySites(const Forest& grown)
{
  Forest forest(0, &grown);
  vtkNew<ErrorCounter> errors;
  errors->Watch(forest.Filter);
  forest.Filter->Update();
  bool good = Check(errors->Count == 0, "an error without sites: " + errors->Last);
  Forest full(60, &grown);
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

}

int TestPlantScatter(int argc, char* argv[])
{
  Forest grown;
  if (!Blocks(grown) || !Joints(grown) || !Ground(grown) || !Arrays(grown) || !Threads(grown) || !Pieces(grown) ||
    !EmptySites(grown) || !Memory(grown))
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
  scene.Window->SetSize(320, 128);
  scene.AddAsCarried(forest.Filter->GetOutputDataObject(0));
  return scene.Compare(argc, argv, eye, focus, Angle);
}
