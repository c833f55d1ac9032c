// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Speed of scattering and of analysing points, by quadrats, by processes and by pairs, through the pipeline.
#include "vtkPatternVerdictFilter.h"
#include "vtkPointPatternStatisticsFilter.h"
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

/// Points of a process, so many on the average.
void DrawProcess(benchmark::State& state)
{
  const double side = std::sqrt(static_cast<double>(state.range(1)));
  vtkNew<vtkPointProcessSource> source;
  source->SetSize(side, side);
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
  ->ArgNames({ "process", "size" })
  ->ArgsProduct({ benchmark::CreateDenseRange(vtkPointProcessSource::Poisson, vtkPointProcessSource::MaternII, 1),
    { 256 * 256, 1024 * 1024, 2048 * 2048 } })
  ->Unit(benchmark::kMillisecond)
  ->MeasureProcessCPUTime()
  ->UseRealTime();

/// g of random points, each with a thousand others within the longest distance.
void MeasurePairs(benchmark::State& state)
{
  const double side = std::sqrt(static_cast<double>(state.range(0)));
  vtkNew<vtkPointProcessSource> source;
  source->SetProcess(vtkPointProcessSource::Poisson);
  source->SetIntensity(1.0);
  source->SetSize(side, side);
  source->Update();
  vtkNew<vtkPointPatternStatisticsFilter> statistics;
  statistics->SetInputData(source->GetOutput());
  statistics->SetSize(side, side);
  statistics->SetFunction(vtkPointPatternStatisticsFilter::PairCorrelation);
  statistics->SetNumberOfSimulations(0);
  for (auto _ : state)
  {
    statistics->Modified();
    statistics->Update();
  }
  state.SetItemsProcessed(state.iterations() * source->GetOutput()->GetNumberOfPoints());
}
BENCHMARK(MeasurePairs)
  ->ArgName("size")
  ->Arg(10000)
  ->Arg(100000)
  ->Unit(benchmark::kMillisecond)
  ->MeasureProcessCPUTime()
  ->UseRealTime();

/// The verdict on points that inhibit each other weakly, as trees of a wood do, by 99 simulations of each process and
/// law.
void JudgePattern(benchmark::State& state)
{
  const double side = std::sqrt(static_cast<double>(state.range(0)));
  vtkNew<vtkPointProcessSource> source;
  source->SetProcess(vtkPointProcessSource::Strauss);
  source->SetActivity(1.15);
  source->SetDistance(0.6);
  source->SetInteraction(0.88);
  source->SetSize(side, side);
  source->Update();
  vtkNew<vtkPatternVerdictFilter> verdict;
  verdict->SetInputData(source->GetOutput());
  verdict->SetSize(side, side);
  for (auto _ : state)
  {
    verdict->Modified();
    verdict->Update();
  }
}
BENCHMARK(JudgePattern)
  ->ArgName("size")
  ->Arg(560)
  ->Arg(2250)
  ->Iterations(1)
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
