// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Speed of scattering and of analysing a million points, through the pipeline.
#include "vtkQuadratAnalysisFilter.h"
#include "vtkQuadratPointSource.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

#include <benchmark/benchmark.h>

namespace
{

void ScatterMillionPoints(benchmark::State& state)
{
  vtkNew<vtkQuadratPointSource> source;
  source->SetQuadrats(1000, 1000);
  source->SetMode(static_cast<int>(state.range(0)));
  for (auto _ : state)
  {
    source->Modified();
    source->Update();
  }
  state.SetItemsProcessed(state.iterations() * source->GetOutput()->GetNumberOfPoints());
}
BENCHMARK(ScatterMillionPoints)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->UseRealTime();

void AnalyseMillionPoints(benchmark::State& state)
{
  vtkNew<vtkQuadratPointSource> source;
  source->SetQuadrats(1000, 1000);
  source->SetLaw(static_cast<int>(state.range(0)));
  vtkNew<vtkQuadratAnalysisFilter> analysis;
  analysis->SetInputConnection(source->GetOutputPort());
  analysis->Update();
  for (auto _ : state)
  {
    analysis->Modified();
    analysis->Update();
  }
}
BENCHMARK(AnalyseMillionPoints)->DenseRange(0, 5)->Unit(benchmark::kMillisecond)->UseRealTime();

}

BENCHMARK_MAIN();
