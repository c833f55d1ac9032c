// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Speed of seaweeds that move: a step of 10 000 physical plants of ten segments, and pictures of 300 plants with skins.
#include "SeaweedMotion.h"
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
#include "vtkSmartPointer.h"

#include <benchmark/benchmark.h>

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
  const std::vector<WaterAtLink> water(motion.GetBunches().front().LanedLinks(), current);
  for (auto _ : state)
  {
    for (const SeaweedBunch& bunch : motion.GetBunches())
    {
      motion.Step(1.0 / 48.0, bunch, water.data(), states.data(), poses.data());
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<long>(states.size()));
}
BENCHMARK(StepLinks)->Unit(benchmark::kMillisecond);

/// A plant of ten segments on each of the sites, in full.
vtkSmartPointer<vtkPlantScatterFilter> BedOf(vtkPoints* sites)
{
  vtkNew<vtkPolyData> places;
  places->SetPoints(sites);
  vtkNew<vtkSeaweedSource> weed;
  weed->SetPreset(vtkSeaweedSource::Custom);
  weed->SetForm(vtkSeaweedSource::Tuft);
  weed->SetNumberOfFronds(1);
  weed->SetSegmentsPerBranch(10);
  auto scatter = vtkSmartPointer<vtkPlantScatterFilter>::New();
  scatter->SetInputData(places);
  scatter->AddInputConnection(1, weed->GetOutputPort());
  scatter->UseLevelsOff();
  scatter->UseCellsOff();
  return scatter;
}

/// The same with a sea of 30 trains, on all threads, for 10 000 plants; the time of a step and of nothing else.
void StepForest(benchmark::State& state)
{
  vtkNew<vtkPoints> sites;
  for (int plant = 0; plant < static_cast<int>(state.range(0)); ++plant)
  {
    sites->InsertNextPoint(plant % 100, plant / 100, -10.0);
  }
  const auto scatter = BedOf(sites);
  vtkNew<vtkSeaStateSource> sea;
  vtkNew<vtkSeaweedDeformationFilter> move;
  move->SetInputConnection(scatter->GetOutputPort());
  move->SetInputConnection(1, sea->GetOutputPort());
  move->SetStartTime(0.0);
  move->UpdateTimeStep(0.0);
  long step = 0;
  // Many steps a picture: the rest is small beside them.
  constexpr int Steps = 20;
  for (auto _ : state)
  {
    step += Steps;
    move->UpdateTimeStep(step / 48.0);
  }
  const double segments = move->GetOutputDataObject(0)->GetFieldData()->GetArray("SegmentsInAll")->GetTuple1(0);
  state.counters["segments"] = segments;
  state.counters["step"] =
    benchmark::Counter(static_cast<double>(step), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(StepForest)->Arg(1000)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Pictures of 300 seaweeds: 0 procedural, 1 physical with a step each.
void Pictures(benchmark::State& state)
{
  vtkNew<vtkPoints> sites;
  for (int plant = 0; plant < 300; ++plant)
  {
    sites->InsertNextPoint(0.13 * plant, plant % 10, -10.0);
  }
  const auto scatter = BedOf(sites);
  vtkNew<vtkSeaStateSource> sea;
  vtkNew<vtkSeaweedDeformationFilter> move;
  move->SetInputConnection(scatter->GetOutputPort());
  move->SetInputConnection(1, sea->GetOutputPort());
  move->SetMethod(static_cast<int>(state.range(0)));
  move->SetStartTime(0.0);
  move->UpdateTimeStep(0.0);
  long step = 0;
  for (auto _ : state)
  {
    move->UpdateTimeStep(++step / 48.0);
  }
  auto* high =
    vtkMultiBlockDataSet::SafeDownCast(vtkMultiBlockDataSet::SafeDownCast(move->GetOutputDataObject(0))->GetBlock(0));
  double points = 0.0;
  for (unsigned int block = 1; block < high->GetNumberOfBlocks(); ++block)
  {
    points += static_cast<double>(vtkPolyData::SafeDownCast(high->GetBlock(block))->GetNumberOfPoints());
  }
  state.counters["points"] = points / 300.0;
  state.counters["frames"] = benchmark::Counter(static_cast<double>(step), benchmark::Counter::kIsRate);
}
BENCHMARK(Pictures)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->UseRealTime();

}
