// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Speed and memory of a wind field on one thread, beside the transforms that it cannot do without.
#include "LineFourier.h"
#include "WindField.h"

#include <benchmark/benchmark.h>

#include <fstream>
#include <string>

using namespace littoral;

namespace
{

WindGrid Large()
{
  WindGrid grid;
  grid.Count = { 12000, 32, 32 };
  grid.TimeStep = 0.05;
  grid.LateralSpacing = 2.0;
  grid.VerticalSpacing = 2.0;
  return grid;
}

/// The most memory that this process has had [MB].
double PeakMemory()
{
  std::ifstream status("/proc/self/status");
  std::string word;
  double kilobytes = 0.0;
  while (status >> word)
  {
    if (word == "VmHWM:")
    {
      status >> kilobytes;
    }
  }
  return kilobytes / 1000.0;
}

/// Its Fourier transforms alone: 64 + 32 lines of 64 for each frequency, 1024 real lines, for each component.
void TransformsAlone(benchmark::State& state)
{
  const LineFourier across(64);
  const RealLineFourier along(12000);
  LinePack plane(64);
  LinePack lines(6001);
  for (auto _ : state)
  {
    for (int pack = 0; pack < 3 * 6000 * 96 / FourierLanes; ++pack)
    {
      across.Backward(plane);
    }
    for (int pack = 0; pack < 3 * 1024 / FourierLanes; ++pack)
    {
      along.Backward(lines);
    }
    benchmark::DoNotOptimize(plane.Re.data());
    benchmark::DoNotOptimize(lines.Re.data());
  }
}
BENCHMARK(TransformsAlone)->Unit(benchmark::kMillisecond)->Iterations(1);

void LargeField(benchmark::State& state)
{
  for (auto _ : state)
  {
    WindField field({}, Large(), {});
    const std::vector<float> velocities = field.Make();
    benchmark::DoNotOptimize(velocities.data());
    state.counters["coherence_error"] = field.GetCoherenceError();
  }
  state.counters["peak_MB"] = PeakMemory();
}
BENCHMARK(LargeField)->Unit(benchmark::kMillisecond)->Iterations(3);

}
