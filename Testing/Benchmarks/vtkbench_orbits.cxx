// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Speed of a frame of particles in 30 trains, and of what the functions alone take.
#include "Sea/WaveOrbits.h"
#include "vtkSeaStateSource.h"

#include "vtkNew.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <limits>
#include <thread>
#include <vector>

using namespace littoral;

namespace
{

constexpr int Count = 1000000;

template <typename Real>
std::vector<Real> Centers(int count = Count)
{
  std::vector<Real> centers(3 * count);
  for (int n = 0; n < count; ++n)
  {
    centers[3 * n] = static_cast<Real>(std::fmod(0.731 * n, 1000.0));
    centers[3 * n + 1] = static_cast<Real>(std::fmod(1.137 * n, 1000.0));
    centers[3 * n + 2] = static_cast<Real>(-20.0 * n / count);
  }
  return centers;
}

SeaState Sea(double depth)
{
  return { TrainsOf(SeaSpectrum(SpectrumParameters{}), depth, TrainParameters{}), depth, 0.0 };
}

/// The numerics on two threads; depth 0 stands for deep water.
template <typename Real>
void MoveParticles(benchmark::State& state)
{
  const int count = static_cast<int>(state.range(1));
  const double depth =
    state.range(0) == 0 ? std::numeric_limits<double>::infinity() : static_cast<double>(state.range(0));
  const SeaState sea = Sea(depth);
  const std::vector<Real> centers = Centers<Real>(count);
  std::vector<Real> moved(3 * count);
  OrbitRequest<Real> request;
  request.Centers = centers.data();
  request.Displacement = moved.data();
  double time = 0.0;
  for (auto _ : state)
  {
    const WaveOrbits orbits(sea, {}, time += 0.04);
    std::thread other([&] { orbits.Evaluate(request, 0, count / 2); });
    orbits.Evaluate(request, count / 2, count);
    other.join();
    benchmark::DoNotOptimize(moved.data());
  }
  state.SetItemsProcessed(state.iterations() * count * static_cast<long>(sea.Trains.size()));
}
BENCHMARK(MoveParticles<float>)
  ->ArgNames({ "depth", "size" })
  ->ArgsProduct({ { 20, 0 }, { Count / 100, Count / 10, Count } })
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();
BENCHMARK(MoveParticles<double>)
  ->ArgNames({ "depth", "size" })
  ->Args({ 20, Count })
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();

/// The bound of plain code: as many sines, cosines and exponentials of the standard library, on two threads.
void FunctionsAlone(benchmark::State& state)
{
  const auto work = [](int begin, int end) {
    float sum = 0.0f;
    for (int n = begin; n < end; ++n)
    {
      for (int train = 0; train < 30; ++train)
      {
        const float x = 1e-6f * static_cast<float>(n) + 0.1f * static_cast<float>(train);
        sum += std::sin(x) + std::cos(x) + std::exp(-x) + std::exp(-2.0f * x);
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
  state.SetItemsProcessed(state.iterations() * Count * 30l);
}
BENCHMARK(FunctionsAlone)->Unit(benchmark::kMillisecond)->UseRealTime();

/// A sea of many trains: the spectrum, the number of trains.
void SeaOfManyTrains(benchmark::State& state)
{
  vtkNew<vtkSeaStateSource> sea;
  sea->SetSpectrum(static_cast<int>(state.range(0)));
  sea->SetNumberOfTrains(static_cast<int>(state.range(1)));
  sea->SetWaterDepth(10.0);
  for (auto _ : state)
  {
    sea->Modified();
    sea->Update();
  }
}
BENCHMARK(SeaOfManyTrains)
  ->ArgNames({ "spectrum", "size" })
  ->ArgsProduct({ { 0, 1, 2 }, { 30, 1000, 100000 } })
  ->Unit(benchmark::kMillisecond);

}

BENCHMARK_MAIN();
