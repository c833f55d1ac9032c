// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Speed of scattering plants: a new view of a large forest, and many trees in full.
#include "vtkPlantScatterFilter.h"
#include "vtkQuadratPointSource.h"
#include "vtkReevesTreeSource.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"

#include <benchmark/benchmark.h>

#include <fstream>
#include <string>

namespace
{

/// One tree on 100 m2 on the average, over a square.
struct Forest
{
  vtkNew<vtkQuadratPointSource> Sites;
  vtkNew<vtkReevesTreeSource> Tree;
  vtkNew<vtkPlantScatterFilter> Filter;

  Forest(int side, int leaves)
  {
    this->Sites->SetQuadrats(side, side);
    this->Sites->SetSize(10.0 * side, 10.0 * side);
    this->Tree->SetPreset(vtkReevesTreeSource::Custom);
    this->Tree->SetNumberOfLeaves(leaves);
    this->Filter->SetInputConnection(0, this->Sites->GetOutputPort());
    this->Filter->AddPrototypeConnection(this->Tree->GetOutputPort());
    this->Filter->SetViewPoint(5.0 * side, 2.0 * side, 2.0);
  }

  void Report(benchmark::State& state)
  {
    vtkFieldData* fields = this->Filter->GetOutputDataObject(0)->GetFieldData();
    for (const char* name : { "PlantsShown", "PlantsHigh", "PolygonsShown", "OutputBytes" })
    {
      state.counters[name] = fields->GetArray(name)->GetTuple1(0);
    }
  }
};

/// 100 000 trees of about 25 000 polygons, levels and cells, the eye a step further each time.
void NewViewOfForest(benchmark::State& state)
{
  Forest forest(316, 10000);
  forest.Filter->Update();
  double step = 0.0;
  for (auto _ : state)
  {
    step += 0.5;
    forest.Filter->SetViewPoint(1580.0 + step, 632.0 + step, 2.0);
    forest.Filter->Update();
  }
  forest.Report(state);
}
BENCHMARK(NewViewOfForest)->Unit(benchmark::kMillisecond)->UseRealTime();

/// The same from nothing: sites are placed and sorted into cells, too.
void FirstViewOfForest(benchmark::State& state)
{
  Forest forest(316, 10000);
  forest.Filter->Update();
  int seed = 1;
  for (auto _ : state)
  {
    forest.Filter->SetSeed(++seed);
    forest.Filter->Update();
  }
  forest.Report(state);
}
BENCHMARK(FirstViewOfForest)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Memory of the process [MB].
double MemoryNow()
{
  std::ifstream status("/proc/self/status");
  std::string word;
  double kilobytes = 0.0;
  while (status >> word && word != "VmRSS:")
  {
  }
  status >> kilobytes;
  return kilobytes / 1000.0;
}

/// Ten million trees as instances; from a hill, where the eye flies, or on a walk. The arguments are its height [m] and
/// how far is seen [m], 0 for all. `MBOfPlants` is what the filter takes beside the sites.
void TenMillion(benchmark::State& state)
{
  constexpr int side = 3162;
  const double height = static_cast<double>(state.range(0));
  Forest forest(side, 10000);
  forest.Sites->Update();
  forest.Tree->Update();
  const double before = MemoryNow();
  forest.Filter->SetOutputFormToInstances();
  forest.Filter->SetVisibleDistance(static_cast<double>(state.range(1)));
  forest.Filter->SetViewDirection(1.0, 0.3, height > 10.0 ? -0.1 : 0.0);
  double way = 0.0;
  const auto look = [&] {
    forest.Filter->SetViewPoint(5.0 * side + way, 5.0 * side + 0.4 * way, height);
    forest.Filter->Update();
  };
  look();
  for (auto _ : state)
  {
    way += height > 10.0 ? 50.0 : 2.0;
    look();
  }
  forest.Report(state);
  state.counters["MBOfPlants"] = MemoryNow() - before;
}
BENCHMARK(TenMillion)
  ->ArgNames({ "height", "visible" })
  ->ArgsProduct({ { 300, 2 }, { 5000, 0 } })
  ->Unit(benchmark::kMillisecond)
  ->MeasureProcessCPUTime()
  ->UseRealTime()
  ->Iterations(20);

/// Trees in full; the argument is the number of leaves of each.
void AllInFull(benchmark::State& state)
{
  Forest forest(100, static_cast<int>(state.range(0)));
  forest.Filter->UseLevelsOff();
  forest.Filter->UseCullingOff();
  for (auto _ : state)
  {
    forest.Filter->Modified();
    forest.Filter->Update();
    if (!forest.Filter->GetOutputDataObject(0)->GetFieldData()->GetArray("OutputBytes"))
    {
      state.SkipWithError("too little memory");
      return;
    }
  }
  forest.Report(state);
  state.SetBytesProcessed(
    static_cast<std::int64_t>(static_cast<double>(state.iterations()) * state.counters["OutputBytes"].value));
}
BENCHMARK(AllInFull)->Arg(100)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(3);

}

BENCHMARK_MAIN();
