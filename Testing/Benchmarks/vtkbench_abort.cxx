// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Time from an abort, asked for by another thread, to the return of the update: its mean, and the longest of five
// moments within a request that takes long [s]. Of twins and zooms of terrains, the longest time of the
// calling thread from a look for an abort to the next within the whole request [s].
#include "vtkBeamTreeDeformationFilter.h"
#include "vtkCovarianceFitFilter.h"
#include "vtkCurrentDriftFilter.h"
#include "vtkDrainageFilter.h"
#include "vtkFlowPrimitiveSource.h"
#include "vtkGardnerPlantSource.h"
#include "vtkParticleFogFilter.h"
#include "vtkParticleOrbitFilter.h"
#include "vtkPlantScatterFilter.h"
#include "vtkQuadratPointSource.h"
#include "vtkReevesTreeSource.h"
#include "vtkSeaStateSource.h"
#include "vtkSeaSurfaceFilter.h"
#include "vtkSeaweedDeformationFilter.h"
#include "vtkSeaweedSource.h"
#include "vtkSuspendedParticleSource.h"
#include "vtkTerrainZoomFilter.h"
#include "vtkTurningBandsTerrainSource.h"
#include "vtkWindFieldSource.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <thread>

namespace
{

using Clock = std::chrono::steady_clock;

double SecondsSince(Clock::time_point begin)
{
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Update an algorithm at a time [s], from the beginning.
void Request(vtkAlgorithm* algorithm, double time)
{
  algorithm->Modified();
  algorithm->UpdateTimeStep(time);
}

void Abort(benchmark::State& state, vtkAlgorithm* algorithm, double time = 0.0)
{
  for (int port = 0; port < algorithm->GetNumberOfInputPorts(); ++port)
  {
    if (vtkAlgorithm* source = algorithm->GetInputAlgorithm(port, 0))
    {
      source->UpdateTimeStep(time);
    }
  }
  Clock::time_point begin = Clock::now();
  Request(algorithm, time);
  const double whole = SecondsSince(begin);
  double longest = 0.0;
  int inTime = 0;
  int moment = 0;
  for (auto _ : state)
  {
    Clock::time_point asked;
    const double delay = whole * (0.1 + 0.2 * (moment++ % 5));
    std::thread other([&] {
      std::this_thread::sleep_for(std::chrono::duration<double>(delay));
      asked = Clock::now();
      algorithm->SetAbortExecute(1);
    });
    begin = Clock::now();
    Request(algorithm, time);
    const Clock::time_point end = Clock::now();
    other.join();
    algorithm->SetAbortExecute(0);
    const double seconds = std::max(0.0, std::chrono::duration<double>(end - asked).count());
    inTime += end > asked;
    longest = std::max(longest, seconds);
    state.SetIterationTime(std::max(1e-9, seconds));
  }
  state.counters["longest"] = longest;
  state.counters["whole"] = whole;
  state.counters["aborted"] = inTime;
}

void AbortTerrain(benchmark::State& state)
{
  vtkNew<vtkTurningBandsTerrainSource> terrain;
  terrain->SetWholeExtent(0, 3000, 0, 3000, 0, 0);
  Abort(state, terrain);
}

void AbortQuadratPoints(benchmark::State& state)
{
  vtkNew<vtkQuadratPointSource> points;
  points->SetQuadrats(3000, 3000);
  Abort(state, points);
}

void AbortReevesTree(benchmark::State& state)
{
  vtkNew<vtkReevesTreeSource> tree;
  tree->SetPreset(vtkReevesTreeSource::Custom);
  tree->SetNumberOfLeaves(100000);
  Abort(state, tree);
}

void AbortGardnerPlant(benchmark::State& state)
{
  vtkNew<vtkGardnerPlantSource> plant;
  plant->SetTextureSize(2048, 2048);
  Abort(state, plant);
}

void AbortWind(benchmark::State& state)
{
  vtkNew<vtkWindFieldSource> wind;
  wind->SetDimensions(8192, 32, 16);
  Abort(state, wind);
}

void AbortParticles(benchmark::State& state)
{
  vtkNew<vtkSuspendedParticleSource> particles;
  particles->SetDensity(500.0);
  Abort(state, particles);
}

void AbortCovarianceFit(benchmark::State& state)
{
  vtkNew<vtkTurningBandsTerrainSource> terrain;
  terrain->SetWholeExtent(0, 1000, 0, 1000, 0, 0);
  vtkNew<vtkCovarianceFitFilter> fit;
  fit->SetInputConnection(terrain->GetOutputPort());
  Abort(state, fit);
}

void AbortScatter(benchmark::State& state)
{
  vtkNew<vtkQuadratPointSource> sites;
  sites->SetQuadrats(50, 50);
  vtkNew<vtkReevesTreeSource> tree;
  vtkNew<vtkPlantScatterFilter> scatter;
  scatter->SetInputConnection(0, sites->GetOutputPort());
  scatter->SetInputConnection(1, tree->GetOutputPort());
  scatter->SetUseLevels(false);
  scatter->SetUseCulling(false);
  Abort(state, scatter);
}

void AbortSway(benchmark::State& state)
{
  vtkNew<vtkReevesTreeSource> tree;
  tree->SetPreset(vtkReevesTreeSource::Custom);
  tree->SetOrders(4);
  vtkNew<vtkWindFieldSource> wind;
  vtkNew<vtkBeamTreeDeformationFilter> sway;
  sway->SetInputConnection(0, tree->GetOutputPort());
  sway->SetInputConnection(1, wind->GetOutputPort());
  Abort(state, sway);
}

void AbortOrbits(benchmark::State& state)
{
  vtkNew<vtkSuspendedParticleSource> particles;
  particles->SetDensity(300.0);
  vtkNew<vtkSeaStateSource> sea;
  sea->SetNumberOfTrains(100);
  vtkNew<vtkParticleOrbitFilter> orbits;
  orbits->SetInputConnection(0, particles->GetOutputPort());
  orbits->SetInputConnection(1, sea->GetOutputPort());
  Abort(state, orbits, 1.0);
}

void AbortFog(benchmark::State& state)
{
  vtkNew<vtkSuspendedParticleSource> particles;
  particles->SetDensity(300.0);
  vtkNew<vtkParticleFogFilter> fog;
  fog->SetInputConnection(particles->GetOutputPort());
  fog->SetDimensions(512, 512, 128);
  Abort(state, fog);
}

void AbortSeaSurface(benchmark::State& state)
{
  vtkNew<vtkSeaStateSource> sea;
  sea->SetNumberOfTrains(200);
  vtkNew<vtkSeaSurfaceFilter> surface;
  surface->SetInputConnection(sea->GetOutputPort());
  surface->SetSpacing(0.1);
  surface->SetSectors(2880);
  Abort(state, surface, 1.0);
}

void AbortDrift(benchmark::State& state)
{
  vtkNew<vtkSuspendedParticleSource> particles;
  particles->SetDensity(50.0);
  vtkNew<vtkFlowPrimitiveSource> flow;
  vtkNew<vtkCurrentDriftFilter> drift;
  drift->SetInputConnection(0, particles->GetOutputPort());
  drift->SetInputConnection(1, flow->GetOutputPort());
  Abort(state, drift, 60.0);
}

void AbortSeaweed(benchmark::State& state)
{
  vtkNew<vtkSeaweedSource> kelp;
  vtkNew<vtkSeaStateSource> sea;
  sea->SetSeaLevel(6.0);
  sea->SetNumberOfTrains(200);
  vtkNew<vtkSeaweedDeformationFilter> bent;
  bent->SetInputConnection(0, kelp->GetOutputPort());
  bent->SetInputConnection(1, sea->GetOutputPort());
  Abort(state, bent, 60.0);
}

double SecondsOfThread()
{
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// A report is made where an abort is looked for.
struct Reports
{
  double Last = SecondsOfThread();
  double Longest = 0.0;

  void Hear()
  {
    const double now = SecondsOfThread();
    this->Longest = std::max(this->Longest, now - this->Last);
    this->Last = now;
  }
};

/// The longest time without a report of an algorithm.
void Hear(benchmark::State& state, vtkAlgorithm* algorithm)
{
  Reports reports;
  vtkNew<vtkCallbackCommand> hear;
  hear->SetClientData(&reports);
  hear->SetCallback([](vtkObject*, unsigned long, void* heard, void*) { static_cast<Reports*>(heard)->Hear(); });
  algorithm->AddObserver(vtkCommand::ProgressEvent, hear);
  for (auto _ : state)
  {
    reports = Reports();
    algorithm->Modified();
    algorithm->Update();
    reports.Hear();
  }
  state.counters["longest"] = reports.Longest;
}

vtkSmartPointer<vtkTurningBandsTerrainSource> Hills(int width, int seed)
{
  auto terrain = vtkSmartPointer<vtkTurningBandsTerrainSource>::New();
  terrain->SetWholeExtent(0, width - 1, 0, width - 1, 0, 0);
  terrain->SetSeed(seed);
  terrain->Update();
  return terrain;
}

/// A quilted twin of hills of 256 x 256 cells.
void HearTwin(benchmark::State& state)
{
  const auto terrain = Hills(static_cast<int>(state.range(0)), 1);
  const auto place = Hills(256, 2);
  vtkNew<vtkDrainageFilter> twin;
  twin->SetInputConnection(0, terrain->GetOutputPort());
  twin->SetInputConnection(1, place->GetOutputPort());
  twin->SetMethodToQuilting();
  Hear(state, twin);
}

/// Hills of cells of a quarter of the side.
void HearZoom(benchmark::State& state)
{
  const auto terrain = Hills(static_cast<int>(state.range(0)) / 4, 1);
  vtkNew<vtkTerrainZoomFilter> zoom;
  zoom->SetInputConnection(terrain->GetOutputPort());
  zoom->SetFactor(4);
  Hear(state, zoom);
}

BENCHMARK(AbortTerrain)->Iterations(5)->UseManualTime();
BENCHMARK(AbortQuadratPoints)->Iterations(5)->UseManualTime();
BENCHMARK(AbortReevesTree)->Iterations(5)->UseManualTime();
BENCHMARK(AbortGardnerPlant)->Iterations(5)->UseManualTime();
BENCHMARK(AbortWind)->Iterations(5)->UseManualTime();
BENCHMARK(AbortParticles)->Iterations(5)->UseManualTime();
BENCHMARK(AbortCovarianceFit)->Iterations(5)->UseManualTime();
BENCHMARK(AbortScatter)->Iterations(5)->UseManualTime();
BENCHMARK(AbortSway)->Iterations(5)->UseManualTime();
BENCHMARK(AbortOrbits)->Iterations(5)->UseManualTime();
BENCHMARK(AbortFog)->Iterations(5)->UseManualTime();
BENCHMARK(AbortSeaSurface)->Iterations(5)->UseManualTime();
BENCHMARK(AbortDrift)->Iterations(5)->UseManualTime();
BENCHMARK(AbortSeaweed)->Iterations(5)->UseManualTime();
BENCHMARK(HearTwin)->Arg(1024)->Arg(4096)->Iterations(1)->MeasureProcessCPUTime()->Unit(benchmark::kSecond);
BENCHMARK(HearZoom)->Arg(1024)->Arg(4096)->Iterations(1)->MeasureProcessCPUTime()->Unit(benchmark::kSecond);

}

BENCHMARK_MAIN();
