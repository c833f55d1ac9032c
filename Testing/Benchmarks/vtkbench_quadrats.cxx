// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Speed of scattering and of analysing points, by quadrats and by processes, through the pipeline.
#include "vtkPointProcessSource.h"
#include "vtkQuadratAnalysisFilter.h"
#include "vtkQuadratPointSource.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

#include <benchmark/benchmark.h>

#include <cmath>

namespace
{

/// One point in each quadrat, on the average.
void ScatterPoints(benchmark::State& state)
{
  const int side = static_cast<int>(std::lround(std::sqrt(state.range(1))));
  vtkNew<vtkQuadratPointSource> source;
  source->SetQuadrats(side, side);
  source->SetMode(static_cast<int>(state.range(0)));
  source->SetLaw(static_cast<int>(state.range(2)));
  for (auto _ : state)
  {
    source->Modified();
    source->Update();
  }
  state.SetItemsProcessed(state.iterations() * source->GetOutput()->GetNumberOfPoints());
}
// Poisson's law, and two that make clusters.
BENCHMARK(ScatterPoints)
  ->ArgNames({ "mode", "size", "law" })
  ->ArgsProduct({ { 0, 1 }, { 100 * 100, 400 * 400, 1000 * 1000 }, { vtkQuadratPointSource::Poisson } })
  ->ArgsProduct({ { 0, 1 }, { 1000 * 1000, 10000000 },
    { vtkQuadratPointSource::NegativeBinomial, vtkQuadratPointSource::PoissonPoisson } })
  ->Unit(benchmark::kMillisecond)
  ->MeasureProcessCPUTime()
  ->UseRealTime();

/// A million points, on the average.
void DrawProcess(benchmark::State& state)
{
  vtkNew<vtkPointProcessSource> source;
  source->SetSize(1000.0, 1000.0);
  source->SetIntensity(1.0);
  source->SetClusterSize(5.0);
  source->SetClusterScale(0.5);
  source->SetRange(50.0);
  source->SetDistance(0.3);
  source->SetProcess(static_cast<int>(state.range(0)));
  for (auto _ : state)
  {
    source->Modified();
    source->Update();
  }
  state.SetItemsProcessed(state.iterations() * source->GetOutput()->GetNumberOfPoints());
}
BENCHMARK(DrawProcess)
  ->ArgName("process")
  ->DenseRange(vtkPointProcessSource::Poisson, vtkPointProcessSource::MaternII)
  ->Unit(benchmark::kMillisecond)
  ->MeasureProcessCPUTime()
  ->UseRealTime();

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
