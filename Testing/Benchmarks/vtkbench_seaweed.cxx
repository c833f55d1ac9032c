// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Speed of seaweeds that move: a step of 10 000 physical plants of ten segments, and pictures of plants with skins.
#include "Data/PlantBlocks.h"
#include "Seaweed/SeaweedMotion.h"
#include "vtkPlantScatterFilter.h"
#include "vtkSeaStateSource.h"
#include "vtkSeaweedDeformationFilter.h"
#include "vtkSeaweedSource.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>
#include <vector>

namespace
{

using namespace littoral;

/// The equations of motion alone, on one thread.
void StepLinks(benchmark::State& state)
{
  Skeleton skeleton;
  for (int plant = 0; plant < 1000; ++plant)
  {
    const Vector3 foot(plant % 40, plant / 40, -10.0);
    skeleton.StartBranch(-1, foot, 0.01);
    for (int i = 1; i <= 10; ++i)
    {
      skeleton.Grow(foot + Vector3(0.0, 0.0, 0.1 * i), 0.01);
    }
  }
  const SeaweedOptions options;
  const std::vector<SeaweedSegment> segments(skeleton.Nodes.size());
  const SeaweedMotion motion(LinksOf(skeleton, segments, options), options);
  std::vector<LinkState> states = motion.AtRest();
  std::vector<LinkPose> poses(states.size());
  motion.Pose(states.data(), 0, states.size(), poses.data());
  WaterAtLink current;
  current.Velocity = { 0.3, 0.2, 0.0 };
  const std::vector<WaterAtLink> water(motion.GetBatches().front().PaddedLinks(), current);
  for (auto _ : state)
  {
    for (const LinkBatch& batch : motion.GetBatches())
    {
      motion.Step(1.0 / 48.0, batch, water.data(), states.data(), poses.data());
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<long>(states.size()));
}
BENCHMARK(StepLinks)->Unit(benchmark::kMillisecond);

/// Plants of ten segments on sites in rows of ten, in full, with the named blocks alone.
vtkSmartPointer<vtkMultiBlockDataSet> BedOf(int plants, const std::vector<std::string>& blocks)
{
  vtkNew<vtkPoints> sites;
  for (int plant = 0; plant < plants; ++plant)
  {
    sites->InsertNextPoint(0.13 * plant, plant % 10, -10.0);
  }
  vtkNew<vtkPolyData> places;
  places->SetPoints(sites);
  vtkNew<vtkSeaweedSource> weed;
  weed->SetPreset(vtkSeaweedSource::Custom);
  weed->SetForm(vtkSeaweedSource::Tuft);
  weed->SetNumberOfFronds(1);
  weed->SetSegmentsPerBranch(10);
  vtkNew<vtkPlantScatterFilter> scatter;
  scatter->SetInputData(places);
  scatter->AddPrototypeConnection(weed->GetOutputPort());
  scatter->UseLevelsOff();
  scatter->UseCullingOff();
  scatter->Update();
  auto* high = vtkMultiBlockDataSet::SafeDownCast(
    littoral::FindBlock(vtkMultiBlockDataSet::SafeDownCast(scatter->GetOutputDataObject(0)), littoral::plant::High));
  vtkNew<vtkMultiBlockDataSet> kept;
  for (const std::string& name : blocks)
  {
    littoral::AddBlock(kept, name.c_str(), littoral::FindBlock(high, name.c_str()));
  }
  auto bed = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  littoral::AddBlock(bed, littoral::plant::High, kept);
  return bed;
}

/// Plants of a bed in a swell of 30 trains.
struct Scene
{
  vtkNew<vtkSeaStateSource> Sea;
  vtkNew<vtkSeaweedDeformationFilter> Move;

  Scene(int plants, const std::vector<std::string>& blocks)
  {
    this->Move->SetInputData(BedOf(plants, blocks));
    this->Move->SetSeaStateConnection(this->Sea->GetOutputPort());
    this->Move->SetStartTime(0.0);
    this->Move->UpdateTimeStep(0.0);
  }
  double Segments() const
  {
    return this->Move->GetOutputDataObject(0)->GetFieldData()->GetArray("SegmentsInAll")->GetTuple1(0);
  }
};

/// All segments of physical plants a step further, on all threads: "step" is the time of one [s].
void StepForest(benchmark::State& state)
{
  Scene scene(static_cast<int>(state.range(0)), { littoral::plant::Skeleton });
  int step = 0;
  // Many steps a picture: the rest is small beside them.
  constexpr int Steps = 20;
  for (auto _ : state)
  {
    step += Steps;
    scene.Move->UpdateTimeStep(step / 48.0);
  }
  state.counters["segments"] = scene.Segments();
  state.counters["step"] =
    benchmark::Counter(static_cast<double>(step), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(StepForest)->ArgName("size")->Arg(300)->Arg(10000)->Unit(benchmark::kMillisecond)->UseRealTime();

/// What a step cannot go below: to read what it knows of segments, and to read and write their states and poses.
void StepMemory(benchmark::State& state)
{
  const auto links = static_cast<std::size_t>(state.range(0)) * 10;
  std::vector<double> bodies(links * sizeof(LinkBody<double>) / sizeof(double), 1.0);
  std::vector<double> moved(links * (sizeof(LinkState) + sizeof(LinkPose)) / sizeof(double), 1.0);
  const std::size_t share = bodies.size() / moved.size() + 1;
  for (auto _ : state)
  {
    vtkSMPTools::For(0, static_cast<vtkIdType>(moved.size()), [&](vtkIdType begin, vtkIdType end) {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        double sum = 0.0;
        for (std::size_t k = share * i; k < std::min(share * (i + 1), bodies.size()); ++k)
        {
          sum += bodies[k];
        }
        moved[i] += sum;
      }
    });
    benchmark::ClobberMemory();
  }
}
BENCHMARK(StepMemory)->ArgName("size")->Arg(10000)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Pictures of some seaweeds with skins: 0 procedural, 1 physical with a step each.
void Pictures(benchmark::State& state)
{
  const auto plants = static_cast<int>(state.range(1));
  Scene scene(plants, { littoral::plant::Skeleton, littoral::plant::Skin });
  scene.Move->SetMethod(static_cast<int>(state.range(0)));
  // Two frames fill the arrays that all later ones take in turn.
  scene.Move->UpdateTimeStep(0.0);
  scene.Move->UpdateTimeStep(1.0 / 48.0);
  int step = 1;
  for (auto _ : state)
  {
    scene.Move->UpdateTimeStep(++step / 48.0);
  }
  auto* high = vtkMultiBlockDataSet::SafeDownCast(
    littoral::FindBlock(vtkMultiBlockDataSet::SafeDownCast(scene.Move->GetOutputDataObject(0)), littoral::plant::High));
  auto* skin = vtkPolyData::SafeDownCast(littoral::FindBlock(high, littoral::plant::Skin));
  state.counters["points"] = static_cast<double>(skin->GetNumberOfPoints()) / plants;
  state.counters["frames"] = benchmark::Counter(static_cast<double>(step), benchmark::Counter::kIsRate);
}
BENCHMARK(Pictures)
  ->ArgNames({ "method", "size" })
  ->ArgsProduct({ { 0, 1 }, { 300, 10000 } })
  ->MeasureProcessCPUTime()
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();

}
