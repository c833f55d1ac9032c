// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// The scene of Coulais et al., section 4.5: 100 seaweeds and 2400 particles, a master and three slaves each, in waves,
// in a current and in the wakes of the seaweeds. Counts and counters, finite numbers, the same bytes in any order of
// times and for any threads, and what wakes do to particles near and far.
#include "PlantChecks.h"
#include "vtkCurrentDriftFilter.h"
#include "vtkFlowPrimitiveSource.h"
#include "vtkParticleLevelOfDetailFilter.h"
#include "vtkParticleOrbitFilter.h"
#include "vtkPlantScatterFilter.h"
#include "vtkPlantWakeFilter.h"
#include "vtkSeaStateSource.h"
#include "vtkSeaweedDeformationFilter.h"
#include "vtkSeaweedSource.h"
#include "vtkSuspendedParticleSource.h"

#include "vtkFieldData.h"
#include "vtkMath.h"
#include "vtkPoints.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkVersionMacros.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace
{

constexpr int Seaweeds = 100;
constexpr int Near = 2000; ///< particles among the seaweeds
constexpr int Far = 400;   ///< particles that no wake reaches
constexpr double Depth = 10.0;
constexpr double Latest = 2.35;

/// A bed of 12 x 8 m with seaweeds, particles above it, and some 20 m to the side.
struct Scene
{
  vtkNew<vtkPolyData> Sites;
  vtkNew<vtkSeaweedSource> Weed;
  vtkNew<vtkPlantScatterFilter> Bed;
  vtkNew<vtkSeaStateSource> Sea;
  vtkNew<vtkFlowPrimitiveSource> Current;
  vtkNew<vtkSeaweedDeformationFilter> Motion; ///< without a view, for the wakes
  vtkNew<vtkSeaweedDeformationFilter> Shown;  ///< by the view, for the picture
  vtkNew<vtkPlantWakeFilter> Wake;
  vtkNew<vtkSuspendedParticleSource> Particles;
  vtkNew<vtkCurrentDriftFilter> Drift;
  vtkNew<vtkParticleLevelOfDetailFilter> Levels;
  vtkNew<vtkParticleOrbitFilter> Orbits;

  explicit Scene(bool hasWakes = true)
  {
    vtkNew<vtkPoints> points;
    for (int site = 0; site < Seaweeds; ++site)
    {
      points->InsertNextPoint(1.2 * (site % 10) - 5.4 + 0.3 * (site % 3), 0.8 * (site / 10) - 3.6, -Depth);
    }
    this->Sites->SetPoints(points);
    this->Weed->SetPreset(vtkSeaweedSource::Custom);
    this->Weed->SetNumberOfFronds(3);
    this->Weed->SetSegmentsPerBranch(4);
    this->Bed->SetInputData(0, this->Sites);
    this->Bed->AddPrototypeConnection(this->Weed->GetOutputPort());
    this->Bed->SetUseLevels(false);
    this->Bed->SetUseCulling(false);
    this->Sea->SetWindSpeed(10.0);
    this->Sea->SetWaterDepth(Depth);
    this->Current->SetStrength(0.1);
    for (vtkSeaweedDeformationFilter* motion : { this->Motion.Get(), this->Shown.Get() })
    {
      motion->SetInputConnection(this->Bed->GetOutputPort());
      motion->SetSeaStateConnection(this->Sea->GetOutputPort());
      motion->AddCurrentConnection(this->Current->GetOutputPort());
      motion->SetStartTime(-1.0);
    }
    this->Motion->GenerateMotionOn();
    this->Shown->UseLevelsOn();
    this->Shown->SetBlendDistance(0.0); // as the paper counts
    this->Wake->SetInputConnection(this->Motion->GetOutputPort());
    const double among[12] = { -6.0, 6.0, -4.0, 4.0, -Depth, -Depth + 2.5, 1.0, 0.01, Near, 1.0, 1.0, 1.0 };
    const double away[12] = { 20.0, 26.0, -4.0, 4.0, -Depth, -Depth + 2.5, 1.0, 0.01, Far, 1.0, 1.0, 1.0 };
    this->Particles->SetPreset(vtkSuspendedParticleSource::Custom);
    this->Particles->SetAmountIs(vtkSuspendedParticleSource::Count);
    this->Particles->AddBox(among);
    this->Particles->AddBox(away);
    this->Drift->SetInputConnection(0, this->Particles->GetOutputPort());
    this->Drift->AddCurrentConnection(this->Current->GetOutputPort());
    if (hasWakes)
    {
      this->Drift->AddCurrentConnection(this->Wake->GetOutputPort());
    }
    this->Drift->SetWaterDepth(Depth);
    this->Drift->SetTimeStep(0.25);
    this->Levels->SetInputConnection(0, this->Drift->GetOutputPort());
    this->Levels->SetSeaStateConnection(this->Sea->GetOutputPort());
    this->Orbits->SetInputConnection(0, this->Levels->GetOutputPort());
    this->Orbits->SetSeaStateConnection(this->Sea->GetOutputPort());
    this->Shown->SetViewPoint(0.0, -9.0, -7.0);
    this->Shown->SetViewDirection(0.0, 1.0, -0.15);
    this->Shown->SetViewAngle(60.0);
    this->Levels->SetViewPoint(0.0, -9.0, -7.0);
    this->Levels->SetViewDirection(0.0, 1.0, -0.15);
    this->Levels->SetViewAngle(60.0);
  }

  /// Each particle in the picture, and three of four a slave.
  void ShowAll()
  {
    this->Levels->SetMiddleDistance(0.0);
    this->Levels->SetFarDistance(1000.0);
    this->Levels->SetBlendDistance(0.0);
    this->Levels->SetVisibleDistance(0.0);
    this->Levels->SetOffsetRange(0.0, 1000.0);
    this->Levels->UseCullingOff();
  }
};

void Append(std::vector<char>& bytes, vtkDataArray* array)
{
  const char* begin = static_cast<const char*>(array->GetVoidPointer(0));
  bytes.insert(bytes.end(), begin, begin + array->GetNumberOfValues() * array->GetDataTypeSize());
}

/// All that the picture shows at a time.
std::vector<char> BytesAt(Scene& scene, double time)
{
  std::vector<char> bytes;
  scene.Orbits->UpdateTimeStep(time);
  for (const char* name : { "Near", "MasterSlave", "Far" })
  {
    vtkPolyData* block = PartOf(scene.Orbits, name);
    if (block->GetNumberOfPoints() > 0)
    {
      Append(bytes, block->GetPoints()->GetData());
      Append(bytes, block->GetPointData()->GetArray("ParticleId"));
    }
  }
  scene.Shown->UpdateTimeStep(time);
  for (const char* name : { "High/Skeleton", "High/Leaves" })
  {
    Append(bytes, PartOf(scene.Shown, name)->GetPoints()->GetData());
  }
  return bytes;
}

double Counter(vtkAlgorithm* filter, const char* name)
{
  vtkDataArray* array = filter->GetOutputDataObject(0)->GetFieldData()->GetArray(name);
  return array ? array->GetTuple1(0) : std::numeric_limits<double>::quiet_NaN();
}

bool AreFinite(vtkDataArray* array)
{
  for (vtkIdType id = 0; id < array->GetNumberOfTuples(); ++id)
  {
    for (int k = 0; k < array->GetNumberOfComponents(); ++k)
    {
      if (!std::isfinite(array->GetComponent(id, k)))
      {
        return false;
      }
    }
  }
  return true;
}

/// 2400 particles, each a master or one of its three slaves; 100 seaweeds, each with a wake.
bool TestCounts()
{
  Scene scene;
  scene.ShowAll();
  bool good = true;
  for (double time : { 0.0, Latest })
  {
    scene.Orbits->UpdateTimeStep(time);
    good &= Check(Counter(scene.Levels, "ParticlesInAll") == Near + Far, "there are not 2400 particles");
    good &= Check(Counter(scene.Levels, "Masters") == (Near + Far) / 4, "there are not 600 masters");
    good &= Check(Counter(scene.Levels, "Slaves") == 3 * (Near + Far) / 4, "there are not 1800 slaves");
    vtkPolyData* moved = PartOf(scene.Orbits, "MasterSlave");
    good &= Check(moved->GetNumberOfPoints() == Near + Far, "a particle is missing or there twice");
    good &= Check(AreFinite(moved->GetPoints()->GetData()), "a particle is nowhere");
    std::vector<int> followers(static_cast<std::size_t>((Near + Far) / 4), 0);
    vtkDataArray* masters = moved->GetPointData()->GetArray("MasterId");
    for (vtkIdType id = 0; id < moved->GetNumberOfPoints(); ++id)
    {
      const int master = static_cast<int>(masters->GetTuple1(id));
      if (master >= 0 && master != id)
      {
        ++followers[static_cast<std::size_t>(master)];
      }
    }
    good &= Check(
      std::all_of(followers.begin(), followers.end(), [](int n) { return n == 3; }), "a master has not three slaves");
    scene.Wake->UpdateTimeStep(time);
    good &= Check(scene.Wake->GetOutput()->GetNumberOfPoints() == Seaweeds, "there are not 100 wakes");
    for (const char* name : { "Strength", "InfluenceBox", "CoreRadius" })
    {
      good &= Check(AreFinite(scene.Wake->GetOutput()->GetPointData()->GetArray(name)), name);
    }
    scene.Shown->UpdateTimeStep(time);
    good &= Check(Counter(scene.Shown, "PlantsInAll") == Seaweeds, "there are not 100 seaweeds");
    for (const char* name : { "High/Skeleton", "High/Leaves", "High/Skin" })
    {
      good &= Check(AreFinite(PartOf(scene.Shown, name)->GetPoints()->GetData()), name);
    }
  }
  return good;
}

/// Levels of detail save work on particles and on seaweeds.
bool TestWork()
{
  Scene scene;
  scene.Orbits->UpdateTimeStep(Latest);
  scene.Shown->UpdateTimeStep(Latest);
  const double trains = Counter(scene.Levels, "TrainSums");
  const double allTrains = Counter(scene.Levels, "TrainSumsInAll");
  const double segments = Counter(scene.Shown, "SegmentsMoved");
  const double allSegments = Counter(scene.Shown, "SegmentsInAll");
  bool good = Check(trains > 0.0 && segments > 0.0, "nothing is shown");
  good &= Check(trains < 0.5 * allTrains, "levels of particles save less than half");
  good &= Check(segments < allSegments, "levels of seaweeds save nothing");
  scene.Levels->UseLevelsOff();
  scene.Levels->UseCullingOff();
  scene.Levels->SetVisibleDistance(0.0);
  scene.Levels->SetTrainSelection(vtkParticleLevelOfDetailFilter::AllTrains);
  scene.Shown->UseLevelsOff();
  scene.Orbits->UpdateTimeStep(Latest);
  scene.Shown->UpdateTimeStep(Latest);
  good &= Check(Counter(scene.Levels, "TrainSums") == allTrains, "without levels not all orbits have all trains");
  good &= Check(Counter(scene.Shown, "SegmentsMoved") == allSegments, "without levels not all segments move");
  std::cout << "trains times particles: " << trains << " of " << allTrains << ", segments: " << segments << " of "
            << allSegments << "\n";
  return good;
}

/// Any order of times, any steps in between and any number of threads: the same bytes.
bool TestSameBytes()
{
  bool good = true;
  Scene scene;
  const std::vector<char> late = BytesAt(scene, Latest);
  const std::vector<char> early = BytesAt(scene, 0.6);
  good &= Check(early != late, "nothing moves");
  BytesAt(scene, 1.7);
  good &= Check(BytesAt(scene, Latest) == late, "the order of times matters");
  // The view chooses what is shown, and leaves no trace.
  scene.Levels->SetViewPoint(5.0, -3.0, -8.0);
  scene.Shown->SetViewPoint(5.0, -3.0, -8.0);
  good &= Check(BytesAt(scene, 1.1) != late, "another view shows the same");
  scene.Levels->SetViewPoint(0.0, -9.0, -7.0);
  scene.Shown->SetViewPoint(0.0, -9.0, -7.0);
  good &= Check(BytesAt(scene, Latest) == late, "the way of the camera matters");
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 1, 0)
  for (int threads : { 1, 2 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads }, [&]() {
      Scene other;
      good &= Check(BytesAt(other, 0.6) == early, "threads matter early");
      good &= Check(BytesAt(other, Latest) == late, "threads matter");
    });
  }
#endif
  return good;
}

/// Particles among the seaweeds feel the wakes, those far from them do not, to the bit.
bool TestWakes()
{
  Scene with;
  Scene without(false);
  with.Drift->UpdateTimeStep(Latest);
  without.Drift->UpdateTimeStep(Latest);
  auto* stirred = vtkPolyData::SafeDownCast(with.Drift->GetOutputDataObject(0));
  auto* calm = vtkPolyData::SafeDownCast(without.Drift->GetOutputDataObject(0));
  bool good = Check(stirred->GetNumberOfPoints() == Near + Far, "there are not 2400 particles");
  int moved = 0;
  int strayed = 0;
  double most = 0.0;
  for (vtkIdType id = 0; id < stirred->GetNumberOfPoints(); ++id)
  {
    double a[3];
    double b[3];
    stirred->GetPoint(id, a);
    calm->GetPoint(id, b);
    const double apart = std::sqrt(vtkMath::Distance2BetweenPoints(a, b));
    const bool isFar = stirred->GetPointData()->GetArray("BoxId")->GetTuple1(id) == 1.0;
    moved += !isFar && apart > 1e-4;
    strayed += isFar && apart > 0.0;
    most = std::max(most, apart);
  }
  std::cout << moved << " of " << Near << " particles feel the seaweeds, by up to " << most << " m\n";
  good &= Check(moved > Near / 2, "particles among the seaweeds do not feel them");
  good &= Check(most < 0.5, "the wakes throw particles about");
  return good & Check(strayed == 0, "far particles feel the seaweeds");
}

}

int TestUnderwaterScene(int, char*[])
{
  bool good = true;
  const std::pair<const char*, bool (*)()> tests[] = { { "counts", TestCounts }, { "work", TestWork },
    { "same bytes", TestSameBytes }, { "wakes", TestWakes } };
  for (const auto& test : tests)
  {
    const bool passed = test.second();
    std::cout << test.first << (passed ? " passed" : " FAILED") << std::endl;
    good = passed && good;
  }
  return good ? 0 : 1;
}
