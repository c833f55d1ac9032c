// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Speed of the drift of 100 000 particles, also in the wakes of 300 plants, and of what its roots, divisions and
// exponentials alone take.
#include "vtkCurrentDriftFilter.h"
#include "vtkFlowPrimitiveSource.h"
#include "vtkSuspendedParticleSource.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <thread>
#include <vector>

namespace
{

constexpr int Count = 100000;

void AddFlow(vtkCurrentDriftFilter* drift, int type, double strength, double x)
{
  vtkNew<vtkFlowPrimitiveSource> flow;
  flow->SetFlowType(type);
  flow->SetStrength(strength);
  flow->SetCenter(x, 0.5 * x, -5.0);
  flow->SetAxis(0.1, 0.2, 1.0);
  drift->AddCurrentConnection(flow->GetOutputPort());
}

void AddParticles(vtkCurrentDriftFilter* drift)
{
  vtkNew<vtkSuspendedParticleSource> particles;
  const double box[12] = { -10.0, 10.0, -10.0, 10.0, -10.0, 0.0, 1.0, 0.01, Count, 1.0, 1.0, 1.0 };
  particles->SetPreset(vtkSuspendedParticleSource::Custom);
  particles->SetAmountIs(vtkSuspendedParticleSource::Count);
  particles->AddBox(box);
  drift->SetInputConnection(0, particles->GetOutputPort());
  drift->SetWaterDepth(10.0);
}

/// Steps of a current without an end; each time asked for is one step later.
void TakeSteps(benchmark::State& state, vtkCurrentDriftFilter* drift)
{
  int step = 0;
  drift->UpdateTimeStep(0.0);
  for (auto _ : state)
  {
    drift->UpdateTimeStep(0.1 * ++step);
  }
  state.SetItemsProcessed(state.iterations() * Count);
}

/// A source, a tilted vortex, a uniform flow and a weak sink, of which each step asks four times: without walls, under
/// a surface, and between a bed and a surface, with their images.
void StepInPrimitives(benchmark::State& state)
{
  vtkNew<vtkCurrentDriftFilter> drift;
  AddParticles(drift);
  AddFlow(drift, vtkFlowPrimitiveSource::Uniform, 0.01, 0.0);
  AddFlow(drift, vtkFlowPrimitiveSource::Vortex, 1.0, 2.0);
  AddFlow(drift, vtkFlowPrimitiveSource::Source, 1.0, -4.0);
  AddFlow(drift, vtkFlowPrimitiveSource::Sink, 1e-3, 5.0);
  drift->SetKeepInWater(state.range(0) > 0);
  drift->SetWaterDepth(state.range(0) > 1 ? 10.0 : 0.0);
  TakeSteps(state, drift);
}
BENCHMARK(StepInPrimitives)->ArgName("walls")->Arg(0)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Sources of the size of kelp, each in a box with a margin, on the bed below the particles and among them.
void StepInWakes(benchmark::State& state)
{
  vtkNew<vtkCurrentDriftFilter> drift;
  AddParticles(drift);
  constexpr int Plants = 300;
  vtkNew<vtkPoints> feet;
  vtkNew<vtkPolyData> wakes;
  const auto add = [&](const char* name, const std::vector<double>& values) {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(static_cast<int>(values.size()));
    for (int plant = 0; plant < Plants; ++plant)
    {
      array->InsertNextTuple(values.data());
    }
    wakes->GetPointData()->AddArray(array);
    return array;
  };
  add("FlowType", { 1.0 });
  add("Strength", { 0.05 });
  add("Axis", { 0.0, 0.0, 1.0 });
  add("CoreRadius", { 0.3 });
  add("InfluenceRadius", { 0.0 });
  add("InfluenceMargin", { 0.5 });
  vtkNew<vtkDoubleArray> boxes = add("InfluenceBox", std::vector<double>(6, 0.0));
  for (int plant = 0; plant < Plants; ++plant)
  {
    // A low-discrepancy sequence over the bed.
    const double x = 20.0 * std::fmod(0.5 + 0.7548776662466927 * plant, 1.0) - 10.0;
    const double y = 20.0 * std::fmod(0.5 + 0.5698402909980532 * plant, 1.0) - 10.0;
    feet->InsertNextPoint(x, y, -9.0);
    boxes->SetTuple6(plant, x - 0.8, x + 0.8, y - 0.8, y + 0.8, -10.0, -8.0);
  }
  wakes->SetPoints(feet);
  drift->AddInputDataObject(1, wakes);
  TakeSteps(state, drift);
}
BENCHMARK(StepInWakes)->Unit(benchmark::kMillisecond)->UseRealTime();

/// An ocean model's output, by straight lines or by splines.
void StepInImage(benchmark::State& state)
{
  vtkNew<vtkCurrentDriftFilter> drift;
  AddParticles(drift);
  vtkNew<vtkImageData> image;
  image->SetDimensions(64, 64, 16);
  image->SetOrigin(-16.0, -16.0, -12.0);
  image->SetSpacing(0.5, 0.5, 0.8);
  vtkNew<vtkDoubleArray> velocity;
  velocity->SetName("Velocity");
  velocity->SetNumberOfComponents(3);
  for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
  {
    const double* p = image->GetPoint(id);
    velocity->InsertNextTuple3(-0.2 * p[1], 0.2 * p[0], 0.0);
  }
  image->GetPointData()->AddArray(velocity);
  drift->SetInputData(1, image);
  drift->SetVelocityInterpolation(static_cast<int>(state.range(0)));
  TakeSteps(state, drift);
}
BENCHMARK(StepInImage)
  ->ArgName("spline")
  ->Arg(vtkCurrentDriftFilter::Linear)
  ->Arg(vtkCurrentDriftFilter::CubicSpline)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();

/// The bound: the same number of roots, divisions and exponentials as StepInPrimitives, on two threads.
void FunctionsAlone(benchmark::State& state)
{
  const auto work = [](int begin, int end) {
    double sum = 0.0;
    for (int n = begin; n < end; ++n)
    {
      for (int stage = 0; stage < 4; ++stage)
      {
        const double x = 1e-4 * n + 0.1 * stage + 0.01;
        sum += std::expm1(-x) / x;
        sum += 1.0 / (x * std::sqrt(x)) + 1.0 / ((x + 1.0) * std::sqrt(x + 1.0));
      }
    }
    benchmark::DoNotOptimize(sum);
  };
  for (auto _ : state)
  {
    std::thread other([&] { work(0, Count / 2); });
    work(Count / 2, Count);
    other.join();
  }
  state.SetItemsProcessed(state.iterations() * Count);
}
BENCHMARK(FunctionsAlone)->Unit(benchmark::kMillisecond)->UseRealTime();

}

BENCHMARK_MAIN();
