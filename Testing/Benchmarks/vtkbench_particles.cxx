// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Frames of a million particles with and without levels of detail, and their fog.
#include "vtkParticleFogFilter.h"
#include "vtkParticleLevelOfDetailFilter.h"
#include "vtkParticleOrbitFilter.h"
#include "vtkSeaStateSource.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <benchmark/benchmark.h>

#include <cmath>

namespace
{

constexpr int Count = 1000000;

/// 60 m x 60 m x 12 m of water; of a million, 23 particles are in each cubic metre.
vtkNew<vtkPolyData> Particles(int count = Count)
{
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(count);
  for (int n = 0; n < count; ++n)
  {
    // A sequence of low discrepancy.
    points->SetPoint(n, 60.0 * std::fmod(0.8191725134 * n, 1.0), 60.0 * std::fmod(0.6710436067 * n, 1.0),
      -12.0 * std::fmod(0.5497004779 * n, 1.0));
  }
  vtkNew<vtkPolyData> particles;
  particles->SetPoints(points);
  return particles;
}

struct Scene
{
  vtkNew<vtkPolyData> Water;
  vtkNew<vtkSeaStateSource> Sea;
  vtkNew<vtkParticleLevelOfDetailFilter> Levels;
  vtkNew<vtkParticleOrbitFilter> Orbits;

  /// The eye is some distance before the water; 0: 5 m within it.
  explicit Scene(double distance = 0.0, int count = Count)
    : Water(Particles(count))
  {
    this->Levels->SetInputData(0, this->Water);
    this->Levels->SetSeaStateConnection(this->Sea->GetOutputPort());
    this->Levels->SetViewPoint(30.0, distance > 0.0 ? -distance : 5.0, -6.0);
    this->Levels->SetViewAngle(40.0);
    this->Orbits->SetInputConnection(0, this->Levels->GetOutputPort());
    this->Orbits->SetSeaStateConnection(this->Sea->GetOutputPort());
  }

  /// A picture of a view that swings. The first ones fill the arrays that all later ones take in turn.
  void Look(vtkAlgorithm* last, int frame)
  {
    const double angle = 0.3 * std::sin(0.03 * frame);
    this->Levels->SetViewDirection(std::sin(angle), std::cos(angle), 0.0);
    last->UpdateTimeStep(0.04 * frame);
  }

  /// Pictures one after the other, the first three untimed.
  void Play(benchmark::State& state, vtkAlgorithm* last)
  {
    int frame = 0;
    while (frame < 3)
    {
      this->Look(last, ++frame);
    }
    for (auto _ : state)
    {
      this->Look(last, ++frame);
    }
  }
};

double Counter(vtkAlgorithm* algorithm, const char* name)
{
  return algorithm->GetOutputDataObject(0)->GetFieldData()->GetArray(name)->GetTuple1(0);
}

/// Groups and cells of new places, and the levels.
void NewParticles(benchmark::State& state)
{
  while (state.KeepRunning())
  {
    state.PauseTiming();
    Scene scene;
    state.ResumeTiming();
    scene.Levels->Update();
  }
}
BENCHMARK(NewParticles)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();

/// The same after a current of 0.1 m/s has carried them for a frame.
void DriftedParticles(benchmark::State& state)
{
  Scene scene;
  scene.Levels->Update();
  for (auto _ : state)
  {
    state.PauseTiming();
    vtkPoints* points = scene.Water->GetPoints();
    for (vtkIdType n = 0; n < points->GetNumberOfPoints(); ++n)
    {
      double place[3];
      points->GetPoint(n, place);
      points->SetPoint(n, place[0] + 0.004, place[1] + 0.001, place[2]);
    }
    points->Modified();
    scene.Water->Modified();
    state.ResumeTiming();
    scene.Levels->Update();
  }
}
BENCHMARK(DriftedParticles)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();

/// Levels of a new view.
void NewView(benchmark::State& state)
{
  Scene scene;
  scene.Play(state, scene.Levels);
}
BENCHMARK(NewView)->Unit(benchmark::kMillisecond)->UseRealTime();

/// A new view at a new time: levels and orbits.
void FrameWithLevels(benchmark::State& state)
{
  Scene scene(static_cast<double>(state.range(0)), static_cast<int>(state.range(1)));
  scene.Play(state, scene.Orbits);
  state.counters["work"] = Counter(scene.Levels, "TrainSums") / Counter(scene.Levels, "TrainSumsInAll");
  state.counters["shown"] = Counter(scene.Levels, "ParticlesShown");
}
BENCHMARK(FrameWithLevels)
  ->ArgNames({ "distance", "size" })
  ->ArgsProduct({ { 0, 12 }, { Count, 10 * Count } })
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();

/// All particles in all trains at a new time.
void FrameWithout(benchmark::State& state)
{
  Scene scene(0.0, static_cast<int>(state.range(0)));
  scene.Orbits->SetInputData(0, scene.Water);
  scene.Play(state, scene.Orbits);
}
BENCHMARK(FrameWithout)->ArgName("size")->Arg(Count)->Arg(10 * Count)->Unit(benchmark::kMillisecond)->UseRealTime();

/// The fog of all particles.
void FogOfAll(benchmark::State& state)
{
  const auto water = Particles(static_cast<int>(state.range(0)));
  vtkNew<vtkParticleFogFilter> fog;
  fog->SetInputData(water);
  for (auto _ : state)
  {
    fog->Modified();
    fog->Update();
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(FogOfAll)
  ->ArgName("size")
  ->Arg(Count / 100)
  ->Arg(Count / 10)
  ->Arg(Count)
  ->Unit(benchmark::kMillisecond)
  ->MeasureProcessCPUTime()
  ->UseRealTime();

}

BENCHMARK_MAIN();
