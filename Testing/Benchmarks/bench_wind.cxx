// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Speed and memory of a wind field on one thread, beside the transforms that it cannot do without.
#include "Numerics/LineFourier.h"
#include "Wind/WindField.h"
#include "Wind/WindLines.h"

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

/// All lines of the default field at a time between its steps.
void BetweenSteps(benchmark::State& state)
{
  const WindGrid grid;
  const std::vector<float> field = WindField({}, grid, {}).Make();
  const WindCarrier carrier(grid.Count[0]);
  WindCarrier::Room room(grid.Count[0]);
  for (auto _ : state)
  {
    for (std::size_t line = 0; line < grid.NumberOfLines(); line += FourierLanes)
    {
      carrier.Carry(&field[3 * line * grid.Count[0]], FourierLanes, 0.3, room);
      benchmark::DoNotOptimize(room.Velocities.data());
    }
  }
}
BENCHMARK(BetweenSteps)->Unit(benchmark::kMillisecond);

/// What a plant asks for: the wind at a place between lines, of some samples a period.
void AtAPlace(benchmark::State& state)
{
  WindGrid grid;
  grid.Count = { static_cast<int>(state.range(0)), 4, 4 };
  const std::vector<float> field = WindField({}, grid, {}).Make();
  const WindLines lines(field.data(), grid.Count);
  std::vector<Vector3> velocities(500);
  for (auto _ : state)
  {
    lines.Sample({ 17.3, 1.6, 0.4 }, 100.0, velocities.size(), velocities.data());
    benchmark::DoNotOptimize(velocities.data());
  }
}
BENCHMARK(AtAPlace)->ArgName("size")->Arg(600)->Arg(12000)->Unit(benchmark::kMicrosecond);

}
