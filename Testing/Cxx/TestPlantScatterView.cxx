// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Scattered plants by the view: culling against the camera, levels in parallel projection.
#include "CameraPicture.h"
#include "Check.h"
#include "ScatteredForest.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace
{

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
  bool good = Check(seen[0] > 300 && seen[1] > 300 && left > 1200, counts);
  good &= Check(lost[0] == 0, std::to_string(lost[0]) + " plants are lost in perspective; " + counts);
  good &= Check(lost[1] == 0, std::to_string(lost[1]) + " plants are lost in parallel projection; " + counts);
  return good;
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

/// A detail factor is that of the distances of the levels; back at 1 all is as before.
bool DetailFactor()
{
  Forest factored;
  Forest nearer;
  const double near = factored.Filter->GetNearDistance();
  const double far = factored.Filter->GetFarDistance();
  factored.Filter->SetDetailFactor(0.6);
  nearer.Filter->SetNearDistance(0.6 * near);
  nearer.Filter->SetFarDistance(0.6 * far);
  bool good = true;
  for (const double factor : { 0.6, 1.0 })
  {
    factored.Filter->SetDetailFactor(factor);
    nearer.Filter->SetNearDistance(factor * near);
    nearer.Filter->SetFarDistance(factor * far);
    factored.Filter->Update();
    nearer.Filter->Update();
    for (const char* counter : { "PlantsShown", "PlantsHigh", "PlantsMedium", "PlantsLow" })
    {
      good &= Check(factored.Counter(counter) == nearer.Counter(counter), std::string(counter) + " of a detail factor");
    }
    good &= Check(factored.Counter("PlantsLow") > 0 && factored.Counter("PlantsHigh") > 0, "levels are missing");
  }
  return good;
}

/// Instances without culling are the same from any direction, so that a turn executes nothing; a step does, and so does
/// a turn where the direction counts.
bool Turns()
{
  Forest forest;
  forest.Filter->SetOutputFormToInstances();
  forest.Filter->UseCullingOff();
  const auto turnedTime = [&](double x) {
    const vtkMTimeType before = forest.Filter->GetMTime();
    forest.Filter->SetViewDirection(x, 1.0, 0.0);
    return forest.Filter->GetMTime() - before;
  };
  const auto levels = [&] {
    forest.Filter->Update();
    return std::array<double, 3>{ forest.Counter("PlantsHigh"), forest.Counter("PlantsMedium"),
      forest.Counter("PlantsLow") };
  };
  const auto before = levels();
  bool good = Check(turnedTime(0.5) == 0, "a turn counts as a change, without culling");
  forest.Filter->Modified();
  good &= Check(levels() == before, "levels of another direction differ, without culling");
  const vtkMTimeType standing = forest.Filter->GetMTime();
  forest.Filter->SetViewPoint(0.0, -30.0, 5.0);
  good &= Check(forest.Filter->GetMTime() > standing && levels() != before, "a step changes no level");
  forest.Filter->ParallelProjectionOn();
  good &= Check(turnedTime(1.0) > 0, "a turn in parallel projection counts as none");
  forest.Filter->ParallelProjectionOff();
  forest.Filter->UseCullingOn();
  good &= Check(turnedTime(1.5) > 0, "a turn counts as none, with culling");
  forest.Filter->UseCullingOff();
  forest.Filter->SetOutputFormToMerged();
  return good & Check(turnedTime(2.0) > 0, "a turn counts as none for plants that face the camera");
}

}

int TestPlantScatterView(int, char*[])
{
  return Culling() && LevelsInParallel() && DetailFactor() && Turns() ? EXIT_SUCCESS : EXIT_FAILURE;
}
