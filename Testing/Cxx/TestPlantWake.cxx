// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Wakes of seaweeds that move, through the pipeline: particles beside a plant go and come back, far ones do not move at
// all; wakes end without a jump, each around its own plant; plants do not feel them; and every bad input.
#include "Data/PlantBlocks.h"
#include "Data/SeaStateTable.h"
#include "Data/SeaweedBlocks.h"
#include "ErrorCounter.h"
#include "Geometry/ViewFrustum.h"
#include "Numerics/Constants.h"
#include "PlantChecks.h"
#include "Sea/Dispersion.h"
#include "vtkCurrentDriftFilter.h"
#include "vtkFlowPrimitiveSource.h"
#include "vtkPlantWakeFilter.h"
#include "vtkSeaweedDeformationFilter.h"
#include "vtkSeaweedSource.h"
#include "vtkTable.h"

#include "vtkAppendPolyData.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace
{

using littoral::Vector3;

constexpr double SeaLevel = 6.0;
constexpr double Period = 4.0;

std::vector<char> BytesOf(vtkPointSet* data)
{
  vtkDataArray* points = data->GetPoints()->GetData();
  const char* begin = static_cast<const char*>(points->GetVoidPointer(0));
  return { begin, begin + points->GetNumberOfValues() * points->GetDataTypeSize() };
}

vtkNew<vtkPolyData> ParticlesAt(const std::vector<Vector3>& places)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vector3& place : places)
  {
    points->InsertNextPoint(&place.x);
  }
  vtkNew<vtkPolyData> particles;
  particles->SetPoints(points);
  return particles;
}

/// A regular swell along x.
vtkNew<vtkTable> Swell()
{
  littoral::SeaState state;
  state.Depth = SeaLevel;
  state.SeaLevel = SeaLevel;
  littoral::WaveTrain train{};
  train.Amplitude = 0.35;
  train.AngularFrequency = littoral::TwoPi / Period;
  train.WaveNumber = littoral::WaveNumber(train.AngularFrequency, SeaLevel);
  state.Trains.push_back(train);
  vtkNew<vtkTable> table;
  littoral::WriteSeaState(state, table);
  return table;
}

/// Thin stems without leaves.
vtkNew<vtkMultiBlockDataSet> Stems(const std::vector<Vector3>& feet)
{
  littoral::Skeleton skeleton;
  std::vector<int> plants;
  for (const Vector3& foot : feet)
  {
    skeleton.StartBranch(-1, foot, 0.005);
    for (int node = 1; node <= 8; ++node)
    {
      skeleton.Grow(foot + Vector3(0.0, 0.0, 0.25 * node), 0.005);
    }
    plants.resize(skeleton.Nodes.size(), static_cast<int>(&foot - feet.data()));
  }
  littoral::SeaweedSegment segment;
  segment.Width = 0.01;
  segment.Thickness = 0.01;
  segment.YoungModulus = 1e7;
  segment.Density = 900.0;
  auto bones = littoral::PolyDataOf(skeleton, littoral::Color{ 90, 90, 40 });
  littoral::AddSegments(skeleton, std::vector<littoral::SeaweedSegment>(skeleton.Nodes.size(), segment), bones);
  vtkNew<vtkIntArray> ids;
  ids->SetName(littoral::plant::PlantId);
  for (int plant : plants)
  {
    ids->InsertNextValue(plant);
  }
  bones->GetPointData()->AddArray(ids);
  vtkNew<vtkMultiBlockDataSet> high;
  littoral::AddBlock(high, littoral::plant::Skeleton, bones);
  vtkNew<vtkMultiBlockDataSet> all;
  littoral::AddBlock(all, littoral::plant::High, high);
  return all;
}

/// A plant in a swell, its wake, and particles that drift in that.
struct Scene
{
  vtkNew<vtkSeaweedSource> Plant;
  vtkNew<vtkSeaweedDeformationFilter> Move;
  vtkNew<vtkPlantWakeFilter> Wake;
  vtkNew<vtkCurrentDriftFilter> Drift;

  Scene()
  {
    this->Move->SetInputConnection(this->Plant->GetOutputPort());
    this->Move->SetInputData(1, Swell());
    this->Move->GenerateMotionOn();
    this->Wake->SetInputConnection(this->Move->GetOutputPort());
    this->Drift->AddCurrentConnection(this->Wake->GetOutputPort());
    this->Drift->SetSeaLevel(SeaLevel);
    this->Drift->SetTimeStep(0.1);
  }

  /// Places of the particles at a time.
  std::vector<Vector3> At(double time)
  {
    this->Drift->UpdateTimeStep(time);
    auto* moved = vtkPointSet::SafeDownCast(this->Drift->GetOutputDataObject(0));
    std::vector<Vector3> places(static_cast<std::size_t>(moved->GetNumberOfPoints()));
    for (std::size_t id = 0; id < places.size(); ++id)
    {
      moved->GetPoint(static_cast<vtkIdType>(id), &places[id].x);
    }
    return places;
  }

  std::vector<char> PlantsAt(double time)
  {
    this->Move->UpdateTimeStep(time);
    std::vector<char> bytes = BytesOf(PartOf(this->Move, "High/Skeleton"));
    const std::vector<char> leaves = BytesOf(PartOf(this->Move, "High/Leaves"));
    bytes.insert(bytes.end(), leaves.begin(), leaves.end());
    return bytes;
  }
};

/// The box of the only plant and the middle of its wake at a time.
littoral::Box BoxAt(Scene& scene, double time, Vector3& center)
{
  scene.Wake->UpdateTimeStep(time);
  vtkPolyData* wake = scene.Wake->GetOutput();
  wake->GetPoint(0, &center.x);
  double box[6];
  wake->GetPointData()->GetArray("InfluenceBox")->GetTuple(0, box);
  return { { box[0], box[2], box[4] }, { box[1], box[3], box[5] } };
}

/// A wake that is well seen: a doublet of the volume of a plant's tissue alone moves little water.
void MakeStrong(vtkPlantWakeFilter* wake, int primitive)
{
  wake->SetPrimitive(primitive);
  wake->SetStrength(primitive == 0 ? 0.5 : 50.0);
}

/// Beside a plant in a regular swell a particle goes to and fro; a far one stays to the bit. A stem sways as regularly
/// as the swell, so that a particle beside it is back after a period.
bool TestGoAndComeBack()
{
  bool good = true;
  for (const bool isStem : { false, true })
  {
    for (int primitive : { 0, 1 })
    {
      Scene scene;
      MakeStrong(scene.Wake, primitive);
      if (isStem)
      {
        scene.Move->SetInputData(Stems({ Vector3(0.0) }));
      }
      Vector3 center;
      const littoral::Box box = BoxAt(scene, 0.0, center);
      const int count = static_cast<int>(scene.Wake->GetOutput()->GetNumberOfPoints());
      good &= Check(count == primitive + 1, "a plant makes other primitives");
      const Vector3 beyond(box.High.x + 0.2, center.y, center.z); // out of the box, within its margin
      const Vector3 far(box.High.x + 12.0, center.y, center.z);
      const std::vector<Vector3> starts{ beyond, center + Vector3(0.0, 0.2, 0.1), far };
      scene.Drift->SetInputData(ParticlesAt(starts));
      std::vector<double> way;
      for (int frame = 0; frame <= 16; ++frame)
      {
        const std::vector<Vector3> now = scene.At(2.0 * Period + frame * Period / 16.0);
        way.push_back(now[0].x);
        good &= Check(now[1] != starts[1], "a particle within the plant does not move");
        good &= Check(now[2] == far, "a far particle moves");
      }
      double forth = 0.0;
      double back = 0.0;
      for (std::size_t frame = 1; frame < way.size(); ++frame)
      {
        forth += std::max(0.0, way[frame] - way[frame - 1]);
        back += std::max(0.0, way[frame - 1] - way[frame]);
      }
      std::cout << (isStem ? "stem" : "kelp") << (primitive ? ", doublet" : ", source")
                << ": in a period a particle goes " << forth << " m forth and " << back << " m back\n";
      good &= Check(std::min(forth, back) > 1e-4, "a particle beside a plant does not go to and fro");
      // The guide's centimetre to each side; a doublet of the tissue's volume moves a fiftieth, a hundredth of the
      // strength.
      good &= Check(isStem || std::abs(forth - 0.02) < 0.003, "kelp moves particles by another length");
      good &= Check(!isStem || std::abs(forth - back) < 0.1 * forth, "a particle does not come back");
    }
  }
  return good;
}

/// Along a line out of the box: currents as those of nearest neighbours, and none from the margin on.
bool TestEnd()
{
  bool good = true;
  for (int primitive : { 0, 1 })
  {
    Scene scene;
    MakeStrong(scene.Wake, primitive);
    Vector3 center;
    const double time = 5.3;
    const littoral::Box box = BoxAt(scene, time, center);
    const double margin = scene.Wake->GetMargin();
    const double step = 1e-4;
    std::vector<Vector3> line;
    while (line.empty() || line.back().x < box.High.x + margin + 0.2)
    {
      line.push_back({ box.High.x - 0.1 + step * static_cast<double>(line.size()), center.y, center.z });
    }
    scene.Drift->SetInputData(ParticlesAt(line));
    scene.Drift->SetStartTime(time);
    scene.Drift->GenerateCurrentOn();
    scene.Drift->UpdateTimeStep(time);
    vtkDataArray* current =
      vtkPointSet::SafeDownCast(scene.Drift->GetOutputDataObject(0))->GetPointData()->GetArray("Current");
    double fastest = 0.0;
    double jump = 0.0;
    double bend = 0.0;
    Vector3 last[2] = { Vector3(0.0), Vector3(0.0) };
    for (std::size_t id = 0; id < line.size(); ++id)
    {
      Vector3 now;
      current->GetTuple(static_cast<vtkIdType>(id), &now.x);
      good &= Check(line[id].x < box.High.x + margin || now == Vector3(0.0), "there is a flow beyond the margin");
      fastest = std::max(fastest, glm::length(now));
      jump = id > 0 ? std::max(jump, glm::distance(now, last[0])) : 0.0;
      bend = id > 1 ? std::max(bend, glm::length(now - 2.0 * last[0] + last[1])) : 0.0;
      last[1] = last[0];
      last[0] = now;
    }
    // A flow that changes over a length m has slopes of some 1/m, and second differences of some 1/m2: over the margin,
    // and by itself over the distance from the core.
    const double over = std::min(margin, line.front().x - center.x);
    good &= Check(fastest > 1e-4, "there is no flow beside a plant");
    good &= Check(jump < 8.0 * fastest * step / over, "the flow jumps");
    good &= Check(bend < 40.0 * fastest * step * step / (over * over), "the slope of the flow jumps");
  }
  return good;
}

/// The bytes of the plants are the same with a wake and particles in it as without.
bool TestPlantsDoNotFeelIt()
{
  bool good = true;
  for (int primitive : { 0, 1 })
  {
    Scene alone;
    alone.Move->GenerateMotionOff();
    Scene scene;
    scene.Wake->SetPrimitive(primitive);
    scene.Wake->SetStrength(100.0);
    Vector3 center;
    BoxAt(scene, 0.0, center);
    scene.Drift->SetInputData(ParticlesAt({ center + Vector3(0.3, 0.0, 0.0) }));
    for (double time : { 1.3, 4.0, 2.2 })
    {
      good &= Check(scene.At(time)[0] != center + Vector3(0.3, 0.0, 0.0), "the wake moves nothing");
      good &= Check(scene.PlantsAt(time) == alone.PlantsAt(time), "a plant feels its own wake");
    }
  }
  return good;
}

/// What one plant does to its surroundings is the same without the other.
bool TestTwoPlants()
{
  bool good = true;
  const Vector3 feet[2] = { { 0.0, 0.0, 0.0 }, { 4.0, 1.0, 0.5 } };
  const std::vector<Vector3> starts{ feet[0] + Vector3(0.2, 0.1, 1.0), feet[1] + Vector3(-0.2, 0.1, 1.0) };
  for (int primitive : { 0, 1 })
  {
    Scene both;
    both.Move->SetInputData(Stems({ feet[0], feet[1] }));
    both.Wake->SetPrimitive(primitive);
    both.Drift->SetInputData(ParticlesAt(starts));
    const std::vector<Vector3> moved = both.At(3.0);
    both.Wake->UpdateTimeStep(3.0);
    vtkPointData* arrays = both.Wake->GetOutput()->GetPointData();
    good &= Check(both.Wake->GetOutput()->GetNumberOfPoints() == 2 * (primitive + 1), "other primitives");
    for (int plant = 0; plant < 2; ++plant)
    {
      Scene one;
      one.Move->SetInputData(Stems({ feet[plant] }));
      one.Wake->SetPrimitive(primitive);
      one.Drift->SetInputData(ParticlesAt(starts));
      const std::vector<Vector3> alone = one.At(3.0);
      good &= Check(alone[plant] == moved[plant] && alone[plant] != starts[plant], "the other plant reaches across");
      good &= Check(alone[1 - plant] == starts[1 - plant], "a plant reaches to the other");
      const int row = plant * (primitive + 1);
      good &= Check(arrays->GetArray("PlantId")->GetTuple1(row) == plant, "a wake has another plant's PlantId");
      double box[6];
      arrays->GetArray("InfluenceBox")->GetTuple(row, box);
      good &= Check(std::abs(box[0] - feet[plant].x) < 2.0 && std::abs(box[1] - feet[plant].x) < 2.0 &&
          box[4] == feet[plant].z && box[5] > box[4] + 1.0 && box[5] <= box[4] + 2.0 + 1e-6,
        "the box of a wake is not that of its plant");
    }
  }
  return good;
}

/// Wakes keep their boxes where other flow primitives are appended to them, and are whole in the first piece.
bool TestAppended()
{
  Scene scene;
  scene.Move->SetInputData(Stems({ Vector3(0.0) }));
  vtkNew<vtkFlowPrimitiveSource> vortex;
  vortex->SetFlowType(vtkFlowPrimitiveSource::Vortex);
  vortex->SetAxis(0.0, 0.0, 1.0);
  vortex->SetCenter(20.0, 0.0, 1.0);
  vortex->SetInfluenceRadius(2.0);
  scene.Wake->UpdateTimeStep(1.1);
  vtkNew<vtkPolyData> wake;
  wake->ShallowCopy(scene.Wake->GetOutput());
  vtkNew<vtkAppendPolyData> all;
  all->AddInputData(wake);
  all->AddInputConnection(vortex->GetOutputPort());
  scene.Drift->RemoveAllInputConnections(1);
  scene.Drift->AddCurrentConnection(all->GetOutputPort());
  const std::vector<Vector3> starts{ { 0.2, 0.0, 1.0 }, { 4.0, 0.0, 1.0 }, { 21.0, 0.0, 1.0 } };
  scene.Drift->SetInputData(ParticlesAt(starts));
  const std::vector<Vector3> moved = scene.At(2.0);
  bool good = Check(moved[0] != starts[0] && moved[2] != starts[2], "appended primitives do not flow");
  good &= Check(moved[1] == starts[1], "a wake has lost its box");
  scene.Wake->UpdatePiece(1, 2, 0);
  good &= Check(scene.Wake->GetOutput()->GetNumberOfPoints() == 0, "the second piece holds wakes too");
  scene.Wake->UpdatePiece(0, 2, 0);
  return good & Check(scene.Wake->GetOutput()->GetNumberOfPoints() == 1, "the first piece does not hold the wake");
}

bool TestBadInput()
{
  bool good = true;
  Scene scene;
  vtkPlantWakeFilter* wake = scene.Wake;
  vtkNew<ErrorCounter> errors;
  errors->Watch(wake);
  const auto fails = [&](const char* word, const std::function<void()>& breaks, const std::function<void()>& mends) {
    breaks();
    good &= Check(errors->ExpectOneNaming(word), word);
    good &= Check(wake->GetOutput()->GetNumberOfPoints() == 0, "there is an output in spite of an error");
    mends();
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  fails(
    "GenerateMotion", [&]() { scene.Move->GenerateMotionOff(); }, [&]() { scene.Move->GenerateMotionOn(); });
  fails(
    "Primitive", [&]() { wake->SetPrimitive(2); }, [&]() { wake->SetPrimitiveToSource(); });
  fails(
    "Strength", [&]() { wake->SetStrength(-1.0); }, [&]() { wake->SetStrength(0.5); });
  fails(
    "Margin", [&]() { wake->SetMargin(0.0); }, [&]() { wake->SetMargin(0.5); });
  fails(
    "Margin", [&]() { wake->SetMargin(nan); }, [&]() { wake->SetMargin(0.5); });
  fails(
    "CoreShare", [&]() { wake->SetCoreShare(1.5); }, [&]() { wake->SetCoreShare(0.2); });
  wake->Update();
  good &= Check(wake->GetOutput()->GetNumberOfPoints() == 1, "no wake after mending");
  vtkNew<vtkMultiBlockDataSet> none;
  wake->SetInputData(none);
  good &= Check(errors->ExpectOneNaming("High/Skeleton"), "no message about a missing skeleton");
  const auto broken = [&](const char* word, const std::function<void(vtkPolyData*)>& breaks) {
    scene.Move->UpdateTimeStep(0.0);
    vtkNew<vtkMultiBlockDataSet> plants;
    plants->DeepCopy(scene.Move->GetOutputDataObject(0));
    breaks(vtkPolyData::SafeDownCast(BlockAt(plants, "High/Skeleton")));
    wake->SetInputData(plants);
    good &= Check(errors->ExpectOneNaming(word), word);
  };
  broken("Density", [](vtkPolyData* bones) { bones->GetPointData()->RemoveArray("Density"); });
  broken(
    "not finite", [=](vtkPolyData* bones) { bones->GetPointData()->GetArray("Velocity")->SetComponent(3, 1, nan); });
  broken("no mass", [](vtkPolyData* bones) { bones->GetPointData()->GetArray("Density")->SetComponent(3, 0, -1.0); });
  return good;
}

}

int TestPlantWake(int, char*[])
{
  bool good = true;
  const struct
  {
    const char* Name;
    bool (*Run)();
  } tests[] = { { "go and come back", TestGoAndComeBack }, { "end", TestEnd },
    { "plants do not feel it", TestPlantsDoNotFeelIt }, { "two plants", TestTwoPlants }, { "appended", TestAppended },
    { "bad input", TestBadInput } };
  for (const auto& test : tests)
  {
    const bool passed = test.Run();
    std::cout << test.Name << (passed ? " passed" : " FAILED") << std::endl;
    good = passed && good;
  }
  return good ? 0 : 1;
}
