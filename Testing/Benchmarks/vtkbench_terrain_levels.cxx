// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Time of a new view of a terrain of 1025 x 1025 samples in levels of detail, and of the pyramid itself.
#include "vtkTerrainLevelOfDetailFilter.h"

#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <benchmark/benchmark.h>

#include <cmath>

namespace
{

constexpr int Samples = 1025;

vtkNew<vtkImageData> Hills()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(Samples, Samples, 1);
  image->SetSpacing(10.0, 10.0, 1.0);
  vtkNew<vtkFloatArray> heights;
  heights->SetName("Elevation");
  for (int i = 0; i < Samples * Samples; ++i)
  {
    const double x = i % Samples;
    const double y = i / Samples;
    heights->InsertNextValue(static_cast<float>(
      200.0 * std::sin(0.02 * x) * std::cos(0.03 * y) + 20.0 * std::sin(0.3 * x + 0.2 * y) * std::sin(0.25 * y)));
  }
  image->GetPointData()->SetScalars(heights);
  return image;
}

void NewView(benchmark::State& state)
{
  vtkNew<vtkTerrainLevelOfDetailFilter> filter;
  filter->SetInputData(Hills());
  filter->SetSelection(static_cast<int>(state.range(0)));
  filter->SetUseCulling(state.range(1) != 0);
  filter->SetViewDirection(0.0, 1.0, -0.2);
  double x = 5000.0;
  filter->SetViewPoint(x, 0.0, 600.0);
  filter->Update();
  for (auto _ : state)
  {
    x += 1.0;
    filter->SetViewPoint(x, 0.0, 600.0);
    filter->Update();
  }
  state.counters["polygons"] = filter->GetOutput()->GetFieldData()->GetArray("PolygonsShown")->GetTuple1(0);
}
BENCHMARK(NewView)->ArgsProduct({ { 0, 1 }, { 0, 1 } })->Unit(benchmark::kMillisecond)->UseRealTime();

void NewTerrain(benchmark::State& state)
{
  const auto image = Hills();
  vtkNew<vtkTerrainLevelOfDetailFilter> filter;
  filter->SetInputData(image);
  for (auto _ : state)
  {
    image->Modified();
    filter->Update();
  }
}
BENCHMARK(NewTerrain)->Unit(benchmark::kMillisecond)->UseRealTime();

}
BENCHMARK_MAIN();
