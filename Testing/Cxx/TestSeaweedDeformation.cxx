// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Seaweeds that move, through the pipeline: rest, time in any order, threads, frame rates, skins against VTK's own
// filter, levels of detail and their counters, and every bad input.
#include "Check.h"
#include "Data/PlantBlocks.h"
#include "Data/SeaweedBlocks.h"
#include "ErrorCounter.h"
#include "PlantChecks.h"
#include "Plants/Skinning.h"
#include "vtkFlowPrimitiveSource.h"
#include "vtkSeaStateSource.h"
#include "vtkSeaweedDeformationFilter.h"
#include "vtkSeaweedSource.h"
#include "vtkWindFieldSource.h"

#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkPointSet.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"
#include "vtkTransform.h"
#include "vtkTrivialProducer.h"
#include "vtkUnsignedShortArray.h"
#include "vtkVersionMacros.h"
#include "vtkWeightedTransformFilter.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace
{

using Filter = vtkSeaweedDeformationFilter;
using littoral::Vector3;

std::vector<char> BytesOf(vtkDataArray* array)
{
  const char* begin = static_cast<const char*>(array->GetVoidPointer(0));
  return { begin, begin + array->GetNumberOfValues() * array->GetDataTypeSize() };
}

std::vector<char> BytesAt(Filter* filter, double time)
{
  filter->UpdateTimeStep(time);
  std::vector<char> all;
  for (const char* name : { "Skeleton", "Leaves", "Skin" })
  {
    vtkPolyData* part = Part(filter->GetOutputDataObject(0), name);
    if (part && part->GetNumberOfPoints() > 0)
    {
      const std::vector<char> bytes = BytesOf(part->GetPoints()->GetData());
      all.insert(all.end(), bytes.begin(), bytes.end());
    }
  }
  return all;
}

double Farthest(vtkPolyData* a, vtkPolyData* b)
{
  double most = a->GetNumberOfPoints() == b->GetNumberOfPoints() ? 0.0 : 1e9;
  for (vtkIdType id = 0; most < 1e9 && id < a->GetNumberOfPoints(); ++id)
  {
    Vector3 p;
    Vector3 q;
    a->GetPoint(id, &p.x);
    b->GetPoint(id, &q.x);
    most = std::max(most, glm::distance(p, q));
  }
  return most;
}

/// The largest angle between segments of two skeletons [rad].
double LargestTurn(vtkPolyData* a, vtkPolyData* b)
{
  double most = 0.0;
  for (vtkIdType id = 1; id < a->GetNumberOfPoints(); ++id)
  {
    Vector3 p[2];
    Vector3 q[2];
    for (int end = 0; end < 2; ++end)
    {
      a->GetPoint(id - 1 + end, &p[end].x);
      b->GetPoint(id - 1 + end, &q[end].x);
    }
    if (glm::distance(p[0], p[1]) > 0.02)
    {
      const Vector3 u = glm::normalize(p[1] - p[0]);
      const Vector3 v = glm::normalize(q[1] - q[0]);
      most = std::max(most, glm::length(glm::cross(u, v)));
    }
  }
  return most;
}

long long Counter(vtkAlgorithm* filter, const char* name)
{
  vtkDataArray* array = filter->GetOutputDataObject(0)->GetFieldData()->GetArray(name);
  return array ? static_cast<long long>(array->GetTuple1(0)) : -1;
}

/// Simple plants: stems of some segments at places, with one side branch each, as a scattered forest has them.
vtkNew<vtkMultiBlockDataSet> Stems(const std::vector<Vector3>& places, int segments, double height = 1.0,
  littoral::SeaweedTissue kind = littoral::SeaweedTissue::Stipe)
{
  littoral::Skeleton skeleton;
  std::vector<int> plants;
  for (const Vector3& place : places)
  {
    skeleton.StartBranch(-1, place, 0.01);
    for (int i = 1; i <= segments; ++i)
    {
      skeleton.Grow(place + Vector3(0.0, 0.0, height * i / segments), 0.01);
    }
    plants.resize(skeleton.Nodes.size(), static_cast<int>(&place - places.data()));
  }
  littoral::SeaweedSegment segment;
  segment.Tissue = kind;
  segment.Width = 0.02;
  segment.Thickness = 0.02;
  segment.YoungModulus = 1e7;
  segment.Density = 900.0;
  const std::vector<littoral::SeaweedSegment> tissue(skeleton.Nodes.size(), segment);
  auto bones = littoral::PolyDataOf(skeleton, littoral::Color{ 90, 90, 40 });
  littoral::AddSegments(skeleton, tissue, bones);
  vtkNew<vtkIntArray> ids;
  ids->SetName("PlantId");
  for (int plant : plants)
  {
    ids->InsertNextValue(plant);
  }
  bones->GetPointData()->AddArray(ids);
  vtkNew<vtkMultiBlockDataSet> high;
  littoral::AddBlock(high, "Skeleton", bones);
  vtkNew<vtkMultiBlockDataSet> all;
  littoral::AddBlock(all, "High", high);
  return all;
}

/// A seaweed in a swell with a current.
struct Scene
{
  vtkNew<vtkSeaweedSource> Plant;
  vtkNew<vtkSeaStateSource> Sea;
  vtkNew<vtkFlowPrimitiveSource> Current;
  vtkNew<Filter> Move;

  Scene()
  {
    this->Sea->SetSeaLevel(12.0);
    this->Current->SetFlowType(vtkFlowPrimitiveSource::Uniform);
    this->Current->SetStrength(0.15);
    this->Move->SetInputConnection(this->Plant->GetOutputPort());
    this->Move->SetSeaStateConnection(this->Sea->GetOutputPort());
    this->Move->AddCurrentConnection(this->Current->GetOutputPort());
    this->Move->SetStartTime(-2.0);
  }
};

bool TestMoves()
{
  Scene scene;
  bool good = true;
  for (int method : { 0, 1 })
  {
    for (int joint : { 0, 1 })
    {
      for (int load : { 0, 1 })
      {
        scene.Move->SetMethod(method);
        scene.Move->SetJoint(joint);
        scene.Move->SetLoad(load);
        scene.Move->UpdateTimeStep(3.7);
        vtkPolyData* rest = Part(scene.Plant->GetOutputDataObject(0), "Skeleton");
        vtkPolyData* moved = Part(scene.Move->GetOutputDataObject(0), "Skeleton");
        const double most = Farthest(rest, moved);
        good = Check(most > 0.001 && most < 6.0,
                 "Method " + std::to_string(method) + " Joint " + std::to_string(joint) + " Load " +
                   std::to_string(load) + " moves by " + std::to_string(most)) &&
          good;
        Vector3 a;
        Vector3 b;
        rest->GetPoint(0, &a.x);
        moved->GetPoint(0, &b.x);
        good = Check(a == b, "the holdfast moves") && good;
        for (vtkIdType cell = 0; cell < rest->GetNumberOfLines(); ++cell)
        {
          vtkNew<vtkIdList> line;
          rest->GetLines()->GetCellAtId(cell, line);
          for (vtkIdType i = 1; i < line->GetNumberOfIds(); ++i)
          {
            Vector3 p[4];
            rest->GetPoint(line->GetId(i - 1), &p[0].x);
            rest->GetPoint(line->GetId(i), &p[1].x);
            moved->GetPoint(line->GetId(i - 1), &p[2].x);
            moved->GetPoint(line->GetId(i), &p[3].x);
            const double change = glm::distance(p[0], p[1]) - glm::distance(p[2], p[3]);
            good = good && Check(std::abs(change) < 1e-6, "a segment changes by " + std::to_string(change));
          }
        }
      }
    }
  }
  return good;
}

/// Before StartTime, and where nothing pushes, all stays to the bit.
bool TestRest()
{
  Scene scene;
  scene.Move->UpdateTimeStep(-3.0);
  bool good = true;
  for (const char* name : { "Skeleton", "Leaves", "Skin" })
  {
    vtkPolyData* rest = Part(scene.Plant->GetOutputDataObject(0), name);
    vtkPolyData* moved = Part(scene.Move->GetOutputDataObject(0), name);
    good = Check(BytesOf(rest->GetPoints()->GetData()) == BytesOf(moved->GetPoints()->GetData()),
             std::string(name) + " is not at rest before StartTime") &&
      good;
  }
  return good;
}

bool TestTimes()
{
  bool good = true;
  for (int method : { 0, 1 })
  {
    Scene scene;
    scene.Move->SetMethod(method);
    const std::vector<char> late = BytesAt(scene.Move, 6.13);
    const std::vector<char> early = BytesAt(scene.Move, 1.02);
    good = Check(early != late, "nothing moves") && good;
    good = Check(BytesAt(scene.Move, 6.13) == late, "another order of times gives other plants") && good;
    BytesAt(scene.Move, 6.12);
    good = Check(BytesAt(scene.Move, 6.13) == late, "small steps give other plants") && good;
    good = Check(BytesAt(scene.Move, 1.02) == early, "going back gives other plants") && good;
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 1, 0)
    for (int threads : { 1, 2 })
    {
      vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads }, [&]() {
        Scene other;
        other.Move->SetMethod(method);
        good = Check(BytesAt(other.Move, 6.13) == late, "threads matter") && good;
      });
    }
#endif
  }
  return good;
}

/// A current that changes is asked for step by step; no order of times matters.
bool TestChangingCurrent()
{
  bool good = true;
  for (int method : { 0, 1 })
  {
    Scene steady;
    Scene scene;
    vtkNew<vtkWindFieldSource> tide;
    tide->SetDimensions(60, 16, 8);
    tide->SetTimeStep(0.5);
    scene.Move->AddCurrentConnection(tide->GetOutputPort());
    for (Filter* filter : { scene.Move.Get(), steady.Move.Get() })
    {
      filter->SetMethod(method);
      filter->SetDragCoefficient(0.02);
      filter->SetStartTime(0.0);
    }
    const std::vector<char> late = BytesAt(scene.Move, 3.11);
    good = Check(late != BytesAt(steady.Move, 3.11), "a changing current has no effect") && good;
    BytesAt(scene.Move, 0.51);
    good = Check(BytesAt(scene.Move, 3.11) == late, "the order of times matters in a changing current") && good;
    BytesAt(scene.Move, 3.0);
    good = Check(BytesAt(scene.Move, 3.11) == late, "going on matters in a changing current") && good;
  }
  return good;
}

/// What was played at 10 and at 60 frames a second is the same.
bool TestFrameRates()
{
  Scene slow;
  Scene fast;
  for (int frame = 0; frame <= 50; ++frame)
  {
    slow.Move->UpdateTimeStep(frame / 10.0);
  }
  for (int frame = 0; frame <= 300; ++frame)
  {
    fast.Move->UpdateTimeStep(frame / 60.0);
  }
  const double turn = LargestTurn(
    Part(slow.Move->GetOutputDataObject(0), "Skeleton"), Part(fast.Move->GetOutputDataObject(0), "Skeleton"));
  return Check(turn < 1e-3, "frame rates differ by " + std::to_string(turn) + " rad");
}

/// Blades against vtkWeightedTransformFilter, with the transforms that the moved skeleton tells.
bool TestSkin()
{
  vtkNew<vtkMultiBlockDataSet> plants = Stems({ { 0.0, 0.0, 0.0 } }, 6);
  auto* high = vtkMultiBlockDataSet::SafeDownCast(littoral::FindBlock(plants, "High"));
  littoral::PlantMesh mesh;
  for (int i = 0; i < 60; ++i)
  {
    const double z = i / 60.0;
    mesh.Points.push_back({ 0.05 * std::cos(i), 0.05 * std::sin(i), z });
    mesh.Normals.push_back({ std::cos(i), std::sin(i), 0.0 });
    mesh.Colors.push_back({ 90, 90, 40 });
    const int node = std::min(5, static_cast<int>(6 * z));
    mesh.JointIds.push_back({ node, std::max(0, node - 1), 0, 0 });
    mesh.JointWeights.push_back({ 0.75, 0.25, 0.0, 0.0 });
  }
  for (int i = 0; i + 2 < 60; ++i)
  {
    mesh.AddPolygon(std::vector<int>{ i, i + 1, i + 2 });
  }
  auto leaves = littoral::PolyDataOf(mesh);
  littoral::AddBlock(high, "Leaves", leaves);
  Scene scene;
  scene.Current->SetStrength(0.5);
  scene.Move->SetInputData(plants);
  scene.Move->UpdateTimeStep(4.0);
  vtkPolyData* before = Part(plants, "Skeleton");
  vtkPolyData* after = Part(scene.Move->GetOutputDataObject(0), "Skeleton");
  bool good = Check(Farthest(before, after) > 0.1, "the plant hardly moves");
  vtkNew<vtkPolyData> indexed;
  indexed->ShallowCopy(leaves);
  vtkNew<vtkUnsignedShortArray> ids;
  ids->SetName("Ids");
  ids->SetNumberOfComponents(4);
  for (const auto& joints : mesh.JointIds)
  {
    ids->InsertNextTuple4(joints[0], joints[1], joints[2], joints[3]);
  }
  indexed->GetPointData()->AddArray(ids);
  vtkNew<vtkWeightedTransformFilter> oracle;
  oracle->SetInputData(indexed);
  oracle->SetTransformIndexArray("Ids");
  oracle->SetWeightArray("JointWeights");
  oracle->SetNumberOfTransforms(6);
  Vector3 last(0.0, 0.0, 1.0);
  glm::dquat turn{ 1.0, 0.0, 0.0, 0.0 };
  for (int node = 0; node < 6; ++node)
  {
    Vector3 foot;
    Vector3 end;
    Vector3 rest;
    before->GetPoint(node, &rest.x);
    after->GetPoint(node, &foot.x);
    after->GetPoint(node + 1, &end.x);
    const Vector3 along = glm::normalize(end - foot);
    turn = littoral::RotationBetween(last, along) * turn;
    last = along;
    vtkNew<vtkTransform> transform;
    transform->Translate(foot.x, foot.y, foot.z);
    const double angle = 2.0 * std::atan2(glm::length(Vector3(turn.x, turn.y, turn.z)), turn.w);
    if (angle > 0.0)
    {
      transform->RotateWXYZ(angle * 180.0 / 3.14159265358979323846, turn.x, turn.y, turn.z);
    }
    transform->Translate(-rest.x, -rest.y, -rest.z);
    transform->Update();
    oracle->SetTransform(transform, node);
  }
  oracle->Update();
  const double error = Farthest(
    vtkPolyData::SafeDownCast(oracle->GetOutputDataObject(0)), Part(scene.Move->GetOutputDataObject(0), "Leaves"));
  return Check(error < 1e-6, "skins differ by " + std::to_string(error)) && good;
}

/// Table 2 of the paper: seaweeds on 40 x 10 m seen lengthwise, by what is counted.
bool TestTable()
{
  bool good = true;
  double ratio = 0.0;
  long long before[2] = { 0, 0 };
  double slope = 0.0;
  double first = 0.0;
  for (int count : { 25, 50, 100, 200, 300 })
  {
    std::vector<Vector3> places;
    for (int plant = 0; plant < count; ++plant)
    {
      // A low-discrepancy sequence: any run of it is spread alike.
      const double x = std::fmod(0.5 + 0.7548776662466927 * plant, 1.0);
      const double y = std::fmod(0.5 + 0.5698402909980532 * plant, 1.0);
      places.push_back({ 40.0 * x, 10.0 * y - 5.0, -10.0 });
    }
    vtkNew<vtkMultiBlockDataSet> plants = Stems(places, 6);
    vtkNew<vtkFlowPrimitiveSource> current;
    current->SetFlowType(vtkFlowPrimitiveSource::Uniform);
    vtkNew<Filter> filter;
    filter->SetInputData(plants);
    filter->AddCurrentConnection(current->GetOutputPort());
    filter->SetMethodToProcedural();
    filter->SetNearDistance(5.0);
    filter->SetFarDistance(20.0);
    filter->SetBlendDistance(0.0);
    filter->SetViewPoint(0.0, 0.0, -9.5);
    filter->SetViewDirection(1.0, 0.0, 0.0);
    filter->SetViewAngle(170.0);
    filter->UpdateTimeStep(1.0);
    const long long all = Counter(filter, "SegmentsMoved");
    good = Check(all == 6 * count, "not all segments move without levels") && good;
    filter->SetUseLevels(true);
    filter->UpdateTimeStep(1.0);
    const long long some = Counter(filter, "SegmentsMoved");
    good = Check(Counter(filter, "PlantsShown") > 0, "no plant is in view") && good;
    ratio = static_cast<double>(all) / static_cast<double>(some);
    if (before[0] > 0)
    {
      slope = static_cast<double>(all - before[0]) / static_cast<double>(some - before[1]);
    }
    before[0] = all;
    before[1] = some;
    first = first > 0.0 ? first : ratio;
    std::cout << count << " seaweeds: " << all << " segments moved, with levels " << some << ", ratio " << ratio
              << "\n";
    good = Check(ratio >= 1.89, "the ratio is " + std::to_string(ratio)) && good;
  }
  good = Check(ratio > first, "the ratio does not grow with the number") && good;
  return Check(slope >= 1.89, "the slope ratio is " + std::to_string(slope)) && good;
}

/// The camera changes what is shown, never the state; and what it shows changes by less than a pixel a centimetre.
bool TestCamera()
{
  bool good = true;
  Scene scene;
  const std::vector<char> full = BytesAt(scene.Move, 2.5);
  scene.Move->SetUseLevels(true);
  scene.Move->SetViewPoint(0.0, -60.0, 1.0);
  scene.Move->SetViewDirection(0.0, 1.0, 0.0);
  const std::vector<char> far = BytesAt(scene.Move, 2.0);
  scene.Move->SetViewDirection(0.0, -1.0, 0.0);
  scene.Move->UpdateTimeStep(2.2);
  good = Check(Counter(scene.Move, "PlantsShown") == 0, "a plant behind the camera is shown") && good;
  scene.Move->SetUseLevels(false);
  good = Check(BytesAt(scene.Move, 2.5) == full, "the camera changes the state") && good;
  good = Check(far != full, "far plants are as near ones") && good;

  Scene still;
  still.Move->SetUseLevels(true);
  still.Move->SetViewDirection(0.0, 1.0, 0.0);
  vtkNew<vtkPolyData> last;
  double worst = 0.0;
  for (double distance = 4.5; distance < 27.0; distance += 0.01)
  {
    still.Move->SetViewPoint(0.0, -distance, 1.0);
    still.Move->UpdateTimeStep(2.5);
    vtkPolyData* now = Part(still.Move->GetOutputDataObject(0), "Leaves");
    if (last->GetNumberOfPoints() > 0)
    {
      const double pixel = 2.0 * distance * std::tan(15.0 * 3.14159265358979323846 / 180.0) / 1080.0;
      worst = std::max(worst, Farthest(last, now) / pixel);
    }
    last->DeepCopy(now);
  }
  std::cout << "a step of 1 cm moves a blade by at most " << worst << " pixels\n";
  return Check(worst > 0.0 && worst < 1.0, "levels jump by " + std::to_string(worst) + " pixels") && good;
}

/// The farther a procedural plant is, the fewer wave trains move it; what is left out is less than a pixel. PixelError
/// is that of the water: limp plants swing by more.
bool TestTrains()
{
  Scene scene;
  Filter* move = scene.Move;
  scene.Plant->SetPreset(vtkSeaweedSource::Eelgrass);
  move->SetMethodToProcedural();
  move->SetUseLevels(true);
  move->SetNearDistance(1e4); // nothing else changes with the distance
  move->SetFarDistance(1e4);
  move->SetViewDirection(0.0, 1.0, 0.0);
  bool good = true;
  long long before = std::numeric_limits<long long>::max();
  for (const double distance : { 5.0, 50.0, 500.0, 3000.0 })
  {
    move->SetViewPoint(0.0, -distance, 1.0);
    move->SetPixelError(0.0);
    move->UpdateTimeStep(2.5);
    const long long all = Counter(move, "TrainEvaluations");
    good = Check(all == 30 * Counter(move, "SegmentsMoved"), "without PixelError not all trains count") && good;
    vtkNew<vtkPolyData> exact;
    exact->DeepCopy(Part(move->GetOutputDataObject(0), "Skeleton"));
    move->SetPixelError(0.5);
    move->UpdateTimeStep(2.5);
    const long long some = Counter(move, "TrainEvaluations");
    const double pixel = 2.0 * distance * std::tan(15.0 * 3.14159265358979323846 / 180.0) / 1080.0;
    const double error = Farthest(exact, Part(move->GetOutputDataObject(0), "Skeleton")) / pixel;
    std::cout << "at " << distance << " m " << some << " of " << all << " trains and segments, " << error
              << " pixels off\n";
    good = Check(some <= before && some <= all, "more trains far away") && good;
    good = Check(error < 1.0, "trains are missed by " + std::to_string(error) + " pixels") && good;
    before = some;
  }
  return Check(before < 30 * Counter(move, "SegmentsMoved") / 2, "far away most trains count") && good;
}

/// A plant far away stays as it is for some steps of 1/48 s: it is where one with steps too short for that was within
/// these, and so less than two pixels from it. Limp plants swing by more than PixelError.
bool TestHeld()
{
  Scene held;
  Scene moving;
  for (Scene* scene : { &held, &moving })
  {
    scene->Plant->SetPreset(vtkSeaweedSource::Eelgrass);
    scene->Move->SetMethodToProcedural();
    scene->Move->SetUseLevels(true);
    scene->Move->SetViewDirection(0.0, 1.0, 0.0);
  }
  moving.Move->SetTimeStep(1e-5);
  bool good = true;
  for (const double distance : { 50.0, 500.0, 3000.0 })
  {
    const double pixel = 2.0 * distance * std::tan(15.0 * 3.14159265358979323846 / 180.0) / 1080.0;
    double error = 0.0;
    int still = 0;
    std::vector<char> last;
    for (int frame = 0; frame < 48; ++frame)
    {
      const double time = 1.0 + frame / 24.0;
      held.Move->SetViewPoint(0.0, -distance, 1.0);
      moving.Move->SetViewPoint(0.0, -distance, 1.0);
      const std::vector<char> now = BytesAt(held.Move, time);
      moving.Move->UpdateTimeStep(time);
      error = std::max(error,
        Farthest(
          Part(moving.Move->GetOutputDataObject(0), "Leaves"), Part(held.Move->GetOutputDataObject(0), "Leaves")));
      still += now == last ? 1 : 0;
      last = now;
    }
    std::cout << "at " << distance << " m " << still << " of 47 pictures are the one before, " << error / pixel
              << " pixels off\n";
    const bool isNear = distance < 100.0;
    good = Check(isNear ? still == 0 : still > 20, "a plant is held for too long or too short") && good;
    good =
      Check(isNear ? error < 0.1 * pixel : error < 2.0 * pixel, "a plant is held too far from where it is") && good;
  }
  return good;
}

/// A view that moves at its speed takes BlendTime, at least, through a change of levels.
bool TestBlendTime()
{
  Scene scene;
  Filter* move = scene.Move;
  move->SetUseLevels(true);
  move->SetViewDirection(0.0, 1.0, 0.0);
  move->SetBlendDistance(0.0);
  constexpr double FramesASecond = 24.0;
  const double speed = 2.0;
  move->SetViewSpeed(speed);
  const auto bladesAt = [&](double distance) {
    move->SetViewPoint(0.0, -distance, 1.0);
    move->UpdateTimeStep(2.5);
    vtkNew<vtkPolyData> blades;
    blades->DeepCopy(Part(move->GetOutputDataObject(0), "Leaves"));
    return vtkSmartPointer<vtkPolyData>(blades);
  };
  struct Change
  {
    double Largest = 0.0; ///< way of a blade from frame to frame [m]
    double All = 0.0;     ///< sum of these ways [m]
    int Frames = 0;       ///< in which blades move
  };
  const auto changeWith = [&](double time) {
    move->SetBlendTime(time);
    Change change;
    auto last = bladesAt(4.0);
    for (double way = 0.0; way < 1.0 + speed * (time + 0.5); way += speed / FramesASecond)
    {
      const auto now = bladesAt(4.0 + way);
      const double step = Farthest(last, now);
      change.Largest = std::max(change.Largest, step);
      change.All += step;
      change.Frames += step > 0.0 ? 1 : 0;
      last = now;
    }
    return change;
  };
  const Change atOnce = changeWith(0.0);
  const Change blended = changeWith(4.0);
  std::cout << "blades move by at most " << atOnce.Largest << " m in " << atOnce.Frames << " frames without, "
            << blended.Largest << " m in " << blended.Frames << " frames with BlendTime 4\n";
  bool good = Check(atOnce.Frames == 1 && atOnce.Largest > 0.05, "levels do not change at once");
  good = Check(blended.Frames >= 4.0 * FramesASecond - 2.0, "BlendTime does not last") && good;
  // The steepest part of the change is one and a half times its mean.
  good = Check(blended.Largest < 1.6 * blended.All / blended.Frames, "levels change with a jerk") && good;
  return good;
}

/// Where a current is no number there is none: plants move as if that part of the field were still.
bool TestHolesInCurrent()
{
  std::vector<char> moved[2];
  for (int isHole : { 0, 1 })
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(9, 9, 9);
    image->SetOrigin(-4.0, -4.0, -1.0);
    vtkNew<vtkFloatArray> velocity;
    velocity->SetName("Velocity");
    velocity->SetNumberOfComponents(3);
    for (vtkIdType id = 0; id < 9 * 9 * 9; ++id)
    {
      const bool isBad = id % 2 == 0;
      velocity->InsertNextTuple3(isBad ? (isHole ? std::nan("") : 0.0) : 0.4, 0.0, 0.0);
    }
    image->GetPointData()->AddArray(velocity);
    vtkNew<vtkMultiBlockDataSet> plants = Stems({ { 0.2, 0.1, 0.0 } }, 6, 2.0);
    Scene scene;
    scene.Move->SetInputData(plants);
    scene.Move->RemoveAllCurrents();
    scene.Move->AddInputDataObject(2, image);
    moved[isHole] = BytesAt(scene.Move, 1.0);
    vtkPolyData* bones = Part(scene.Move->GetOutputDataObject(0), "Skeleton");
    if (!Check(bones && Farthest(bones, Part(plants, "Skeleton")) < 4.0, "a hole in a current breaks the plants"))
    {
      return false;
    }
  }
  return Check(moved[0] == moved[1], "a hole in a current is not still water");
}

/// Explicit Euler says once what TimeStep is too long for it, and is silent below.
bool TestWarning()
{
  bool good = true;
  Scene scene;
  vtkNew<vtkMultiBlockDataSet> plants = Stems({ { 0.0, 0.0, 0.0 } }, 4);
  scene.Move->SetInputData(plants);
  scene.Move->SetStartTime(0.0);
  vtkNew<ErrorCounter> messages;
  messages->Watch(scene.Move);
  messages->WatchWarnings();
  const auto warnings = [&](int method, int integrator, double step, double time) {
    messages->Warnings = 0;
    scene.Move->SetMethod(method);
    scene.Move->SetIntegrator(integrator);
    scene.Move->SetTimeStep(step);
    scene.Move->UpdateTimeStep(time);
    return messages->Warnings;
  };
  good = Check(warnings(1, 1, 0.02, 0.1) == 1, "no warning, or more than one, of too long a TimeStep") && good;
  const std::string text = messages->LastWarning;
  const std::size_t place = text.find("above ");
  const double limit = place == std::string::npos ? 0.0 : std::atof(text.c_str() + place + 6);
  good = Check(text.find("TimeStep is 0.02") != std::string::npos && limit > 1e-5 && limit < 0.02,
           "the warning is: " + text) &&
    good;
  good = Check(warnings(1, 1, 0.02, 0.2) == 0, "the next frame warns again") && good;
  good = Check(warnings(1, 1, 1.01 * limit, 0.002) == 1, "no warning just beyond the limit") && good;
  good = Check(warnings(1, 1, 0.99 * limit, 0.002) == 0, "a warning just below the limit") && good;
  good = Check(warnings(1, 0, 0.02, 0.1) == 0, "the implicit integrator warns") && good;
  good = Check(warnings(0, 1, 0.02, 0.1) == 0, "procedural plants warn") && good;
  // Blades of ten equal segments: (0.52 / 0.1)^3.
  vtkNew<vtkMultiBlockDataSet> blades = Stems({ { 0.0, 0.0, 0.0 } }, 10, 1.0, littoral::SeaweedTissue::Blade);
  scene.Move->SetInputData(blades);
  good = Check(warnings(1, 0, 0.02, 0.1) == 1, "no warning, or more than one, of equal segments") && good;
  good = Check(messages->LastWarning.find("Cauchy number of 140.6") != std::string::npos,
           "the warning is: " + messages->LastWarning) &&
    good;
  good = Check(warnings(1, 0, 0.02, 0.2) == 0, "the next frame warns again of equal segments") && good;
  good = Check(warnings(0, 0, 0.02, 0.1) == 0, "procedural blades warn") && good;
  return Check(messages->Count == 0, "a warning is an error") && good;
}

/// One message about each skeleton that cannot be, and no output.
bool RefusesPlants(Scene& scene, ErrorCounter* errors)
{
  bool good = true;
  const auto broken = [&](const char* word, const std::function<void(vtkPolyData*)>& breaks) {
    vtkNew<vtkMultiBlockDataSet> plants = Stems({ { 0.0, 0.0, 0.0 }, { 2.0, 0.0, 0.0 } }, 4);
    breaks(Part(plants, "Skeleton"));
    scene.Move->SetInputData(plants);
    good = Check(errors->ExpectOneNaming(word), std::string("no message about ") + word) && good;
    auto* output = vtkMultiBlockDataSet::SafeDownCast(scene.Move->GetOutputDataObject(0));
    good = Check(output->GetNumberOfBlocks() == 0, "there is an output in spite of an error") && good;
  };
  const auto change = [&](const char* name, int node, double value) {
    return
      [name, node, value](vtkPolyData* bones) { bones->GetPointData()->GetArray(name)->SetComponent(node, 0, value); };
  };
  broken("cycle", change("ParentId", 2, 3));
  broken("does not exist", change("ParentId", 2, 77));
  broken("Density", change("Density", 1, 0.0));
  broken("YoungModulus", change("YoungModulus", 1, -1.0));
  broken("Width", change("Width", 1, std::numeric_limits<double>::quiet_NaN()));
  broken("radius", change("Radius", 1, std::numeric_limits<double>::quiet_NaN()));
  for (const char* name : { "ParentId", "Density", "YoungModulus", "Across" })
  {
    broken(name, [name](vtkPolyData* bones) { bones->GetPointData()->RemoveArray(name); });
  }
  broken("finite", [](vtkPolyData* bones) { bones->GetPoints()->SetPoint(1, 0.0, std::nan(""), 0.0); });
  broken("above the sea", [](vtkPolyData* bones) { bones->GetPoints()->SetPoint(9, 2.0, 0.0, 50.0); });
  vtkNew<vtkMultiBlockDataSet> none;
  scene.Move->SetInputData(none);
  good = Check(errors->ExpectOneNaming("High/Skeleton"), "no message about a missing skeleton") && good;
  return good;
}

/// One message about each number that a sea state lacks, or that is none.
bool RefusesSeas(Scene& scene, ErrorCounter* errors)
{
  bool good = true;
  scene.Sea->Update();
  for (const char* column : { "Amplitude", "AngularFrequency", "WaveNumber", "Direction", "Phase" })
  {
    vtkNew<vtkTable> sea;
    sea->DeepCopy(scene.Sea->GetOutputDataObject(0));
    vtkDataArray::SafeDownCast(sea->GetColumnByName(column))->SetComponent(1, 0, std::nan(""));
    scene.Move->SetInputData(1, sea);
    good = Check(errors->ExpectOneNaming(column), std::string("no message about NaN in ") + column) && good;
    sea->RemoveColumnByName(column);
    sea->Modified();
    good = Check(errors->ExpectOneNaming(column), std::string("no message about a missing ") + column) && good;
  }
  for (const char* field : { "WaterDepth", "SeaLevel" })
  {
    vtkNew<vtkTable> sea;
    sea->DeepCopy(scene.Sea->GetOutputDataObject(0));
    sea->GetFieldData()->GetArray(field)->SetComponent(0, 0, std::nan(""));
    scene.Move->SetInputData(1, sea);
    good = Check(errors->ExpectOneNaming(field), std::string("no message about NaN in ") + field) && good;
  }
  vtkNew<vtkTable> calm;
  scene.Move->SetInputData(1, calm);
  good = Check(errors->ExpectOneNaming("no wave trains"), "no message about an empty sea state") && good;
  return good;
}

/// One message about each number of a current that is none.
bool RefusesCurrents(Scene& scene, ErrorCounter* errors)
{
  bool good = true;
  scene.Current->SetFlowType(vtkFlowPrimitiveSource::Vortex);
  scene.Current->Update();
  for (const char* name : { "Strength", "Axis", "CoreRadius", "InfluenceRadius" })
  {
    vtkNew<vtkPolyData> current;
    current->DeepCopy(scene.Current->GetOutputDataObject(0));
    current->GetPointData()->GetArray(name)->SetComponent(0, 0, std::nan(""));
    scene.Move->RemoveAllCurrents();
    scene.Move->AddInputDataObject(2, current);
    good = Check(errors->ExpectOneNaming(name), std::string("no message about NaN in ") + name) && good;
  }
  scene.Move->RemoveAllCurrents();
  return good;
}

/// One message about each property that cannot be.
bool RefusesProperties(Filter* move, ErrorCounter* errors)
{
  bool good = true;
  const auto property = [&](const char* word, const std::function<void()>& breaks, const std::function<void()>& mends) {
    breaks();
    good = Check(errors->ExpectOneNaming(word), std::string("no message about ") + word) && good;
    mends();
  };
  property(
    "TimeStep", [move]() { move->SetTimeStep(0.0); }, [move]() { move->SetTimeStep(0.02); });
  property(
    "Method", [move]() { move->SetMethod(2); }, [move]() { move->SetMethodToPhysical(); });
  property(
    "Joint", [move]() { move->SetJoint(-1); }, [move]() { move->SetJointToBending(); });
  property(
    "Load", [move]() { move->SetLoad(5); }, [move]() { move->SetLoadToMorison(); });
  property(
    "Integrator", [move]() { move->SetIntegrator(5); }, [move]() { move->SetIntegratorToImplicit(); });
  property(
    "DragCoefficient", [move]() { move->SetDragCoefficient(-1.0); }, [move]() { move->SetDragCoefficient(1.95); });
  property(
    "TimeRange", [move]() { move->SetTimeRange(1.0, 1.0); }, [move]() { move->SetTimeRange(0.0, 60.0); });
  property(
    "StartTime", [move]() { move->SetStartTime(std::nan("")); }, [move]() { move->SetStartTime(-2.0); });
  return good;
}

bool TestBadInput()
{
  bool good = true;
  Scene scene;
  vtkNew<ErrorCounter> errors;
  errors->Watch(scene.Move);
  good &= RefusesPlants(scene, errors);
  scene.Move->SetInputConnection(scene.Plant->GetOutputPort());
  scene.Move->RemoveAllCurrents();
  scene.Move->RemoveSeaState();
  good = Check(errors->ExpectOneNaming("no sea state"), "no message about a missing sea") && good;
  good &= RefusesSeas(scene, errors);
  scene.Move->SetSeaStateConnection(scene.Sea->GetOutputPort());
  good &= RefusesCurrents(scene, errors);
  for (double time : { std::nan(""), std::numeric_limits<double>::infinity() })
  {
    scene.Move->GetOutputInformation(0)->Set(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP(), time);
    good = Check(errors->ExpectOneNaming("time"), "no message about a time that is no number") && good;
  }
  scene.Move->GetOutputInformation(0)->Set(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP(), 0.0);
  good &= RefusesProperties(scene.Move, errors);
  scene.Move->UpdateTimeStep(0.0);
  good = Check(Part(scene.Move->GetOutputDataObject(0), "Skeleton") != nullptr, "no plants after mending") && good;
  return good;
}

}

int TestSeaweedDeformation(int, char*[])
{
  bool good = true;
  const struct
  {
    const char* Name;
    bool (*Run)();
  } tests[] = { { "moves", TestMoves }, { "rest", TestRest }, { "times", TestTimes },
    { "changing current", TestChangingCurrent }, { "rates", TestFrameRates }, { "skin", TestSkin },
    { "table", TestTable }, { "camera", TestCamera }, { "trains", TestTrains }, { "held", TestHeld },
    { "blend time", TestBlendTime }, { "holes", TestHolesInCurrent }, { "warning", TestWarning },
    { "bad input", TestBadInput } };
  for (const auto& test : tests)
  {
    const bool passed = test.Run();
    std::cout << test.Name << (passed ? " passed" : " FAILED") << std::endl;
    good = passed && good;
  }
  return good ? 0 : 1;
}
