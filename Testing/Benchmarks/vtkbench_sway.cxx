// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// A frame of a forest in the wind through the pipeline: 1000 trees of about 300 branches with levels of detail, the
// deformation alone, skins and leaves with it.
#include "vtkBeamTreeDeformationFilter.h"
#include "vtkPlantScatterFilter.h"
#include "vtkQuadratPointSource.h"
#include "vtkReevesTreeSource.h"
#include "vtkWindFieldSource.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>

namespace
{

struct Forest
{
  vtkNew<vtkQuadratPointSource> Sites;
  vtkNew<vtkReevesTreeSource> Tree;
  vtkNew<vtkPlantScatterFilter> Scatter;
  vtkNew<vtkWindFieldSource> Wind;
  vtkNew<vtkBeamTreeDeformationFilter> Sway;

  explicit Forest(double nearDistance)
  {
    this->Sites->SetQuadrats(40, 25);
    this->Sites->SetSize(400.0, 250.0);
    this->Tree->SetPreset(vtkReevesTreeSource::Custom);
    this->Tree->SetOrders(2);
    this->Tree->SetMainBranches(42);
    this->Tree->SetSideBranches(6);
    this->Tree->SetNumberOfLeaves(1500);
    this->Scatter->SetInputConnection(0, this->Sites->GetOutputPort());
    this->Scatter->AddPrototypeConnection(this->Tree->GetOutputPort());
    this->Scatter->SetViewPoint(200.0, 5.0, 2.0);
    this->Scatter->SetNearDistance(nearDistance);
    this->Scatter->SetFarDistance(250.0);
    this->Scatter->UseCullingOff();
    this->Wind->SetDimensions(1200, 110, 12);
    this->Wind->SetCenter(200.0, 125.0);
    this->Sway->SetInputConnection(0, this->Scatter->GetOutputPort());
    this->Sway->SetWindConnection(this->Wind->GetOutputPort());
    this->Sway->AddPrototypeConnection(this->Tree->GetOutputPort());
  }
};

void SwayForest(benchmark::State& state)
{
  const int threads = static_cast<int>(state.range(0));
  Forest forest(static_cast<double>(state.range(1)));
  vtkSMPTools::Config config(threads);
  vtkSMPTools::LocalScope(config, [&] {
    double time = 0.0;
    forest.Sway->UpdateTimeStep(time);
    double slowest = 0.0;
    for (auto _ : state)
    {
      const auto begin = std::chrono::steady_clock::now();
      forest.Sway->UpdateTimeStep(time += 1.0 / 60.0);
      const std::chrono::duration<double, std::milli> frame = std::chrono::steady_clock::now() - begin;
      slowest = std::max(slowest, frame.count());
    }
    state.counters["slowest frame, ms"] = slowest;
  });
  vtkFieldData* fields = forest.Scatter->GetOutputDataObject(0)->GetFieldData();
  for (const char* name : { "PlantsHigh", "PlantsMedium", "PlantsLow" })
  {
    state.counters[name] = fields->GetArray(name)->GetTuple1(0);
  }
  double points = 0.0;
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(forest.Scatter->GetOutputDataObject(0));
  for (unsigned int level = 0; level < 2; ++level)
  {
    auto* parts = vtkMultiBlockDataSet::SafeDownCast(blocks->GetBlock(level));
    for (unsigned int part = 0; part < parts->GetNumberOfBlocks(); ++part)
    {
      points += static_cast<double>(vtkPolyData::SafeDownCast(parts->GetBlock(part))->GetNumberOfPoints());
    }
  }
  state.counters["vertices moved"] = points;
}
BENCHMARK(SwayForest)
  ->ArgNames({ "threads", "near, m" })
  ->Args({ 1, 30 })
  ->Args({ 2, 30 })
  ->Args({ 1, 60 })
  ->Args({ 2, 60 })
  ->Unit(benchmark::kMillisecond)
  ->MeasureProcessCPUTime()
  ->UseRealTime()
  ->Iterations(200);

}

BENCHMARK_MAIN();
