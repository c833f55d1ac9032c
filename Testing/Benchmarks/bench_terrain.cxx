// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Speed of growing and of measuring a terrain, each against a bound measured in the same run.
#include "Terrain/TurningBands.h"
#include "Terrain/Variogram.h"
#include "Terrain/VariogramFit.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstring>
#include <memory>
#include <thread>
#include <vector>

using namespace littoral;

namespace
{

constexpr int Size = 1024;

TurningBandsParameters Exponential(int lines = 64)
{
  TurningBandsParameters parameters;
  parameters.Field.Range = 20.0;
  parameters.NumberOfLines = lines;
  return parameters;
}

GridWindow Square(int side = Size)
{
  GridWindow window;
  window.Last = { side - 1, side - 1 };
  return window;
}

/// Runs the task on [0, count) in as many equal parts as there are threads.
void OnThreads(int threads, std::size_t count, const RangeTask& task)
{
  std::vector<std::thread> others;
  for (int t = 1; t < threads; ++t)
  {
    others.emplace_back([&, t] { task(count * t / threads, count * (t + 1) / threads); });
  }
  task(0, count / threads);
  for (std::thread& other : others)
  {
    other.join();
  }
}

void Tabulate(TurningBandsField& field, int threads)
{
  OnThreads(threads, field.GetNumberOfLines(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t line = begin; line < end; ++line)
    {
      field.TabulateLine(line);
    }
  });
}

void Fill(const TurningBandsField& field, int threads, std::vector<float>& values, int side = Size)
{
  OnThreads(threads, side, [&](std::size_t begin, std::size_t end) {
    field.FillRows(static_cast<int>(begin), static_cast<int>(end) - 1, 1.0, 0.0, values.data() + begin * side);
  });
}

/// The whole: 1024 x 1024 points, exponential model, 64 lines or (0) as many as are enough.
void GrowTerrain(benchmark::State& state)
{
  const int threads = static_cast<int>(state.range(0));
  const int lines = static_cast<int>(state.range(1));
  std::vector<float> values(Size * Size);
  for (auto _ : state)
  {
    const int enough = lines > 0 ? lines : EnoughLines(Exponential(), PlaneGrid{}, Square());
    TurningBandsField field(Exponential(enough), PlaneGrid{}, Square());
    state.counters["lines"] = enough;
    Tabulate(field, threads);
    Fill(field, threads, values);
    benchmark::DoNotOptimize(values.data());
  }
}
BENCHMARK(GrowTerrain)
  ->Args({ 1, 0 })
  ->Args({ 2, 0 })
  ->Args({ 1, 64 })
  ->Args({ 2, 64 })
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();

void TabulateLines(benchmark::State& state)
{
  TurningBandsField field(Exponential(), PlaneGrid{}, Square());
  for (auto _ : state)
  {
    Tabulate(field, static_cast<int>(state.range(0)));
  }
}
BENCHMARK(TabulateLines)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

/// The bound of FillPoints: one addition into the grid for each line and point, all operands in the cache.
void AddSameBytes(benchmark::State& state)
{
  std::vector<float> row(Size, 1.0f);
  std::vector<float> sums(Size);
  for (auto _ : state)
  {
    for (int n = 0; n < 64 * Size; ++n)
    {
      for (int i = 0; i < Size; ++i)
      {
        sums[i] += row[i];
      }
      benchmark::DoNotOptimize(sums.data());
      benchmark::ClobberMemory();
    }
  }
  state.SetBytesProcessed(state.iterations() * 64ll * Size * Size * sizeof(float));
}
BENCHMARK(AddSameBytes)->Unit(benchmark::kMillisecond)->UseRealTime();

/// A plain copy of as many bytes as the lines add: 64 grids of 4 MiB.
void CopySameBytes(benchmark::State& state)
{
  std::vector<float> from(Size * Size, 1.0f);
  std::vector<float> to(Size * Size);
  for (auto _ : state)
  {
    for (int line = 0; line < 64; ++line)
    {
      std::memcpy(to.data(), from.data(), to.size() * sizeof(float));
      benchmark::DoNotOptimize(to.data());
      benchmark::ClobberMemory();
    }
  }
  state.SetBytesProcessed(state.iterations() * 64ll * Size * Size * sizeof(float));
}
BENCHMARK(CopySameBytes)->Unit(benchmark::kMillisecond)->UseRealTime();

void FillPoints(benchmark::State& state)
{
  const int side = static_cast<int>(std::lround(std::sqrt(state.range(1))));
  TurningBandsField field(Exponential(), PlaneGrid{}, Square(side));
  Tabulate(field, 1);
  std::vector<float> values(static_cast<std::size_t>(side) * side);
  for (auto _ : state)
  {
    Fill(field, static_cast<int>(state.range(0)), values, side);
    benchmark::DoNotOptimize(values.data());
  }
  state.SetBytesProcessed(state.iterations() * 64ll * side * side * sizeof(float));
}
BENCHMARK(FillPoints)
  ->ArgNames({ "threads", "size" })
  ->ArgsProduct({ { 1, 2 }, { 256 * 256, 512 * 512, Size* Size } })
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();

GridSamples Terrain(int side = Size)
{
  TurningBandsField field(Exponential(), PlaneGrid{}, Square(side));
  Tabulate(field, 1);
  std::vector<float> values(static_cast<std::size_t>(side) * side);
  Fill(field, 1, values, side);
  GridSamples samples;
  samples.Width = samples.Height = side;
  samples.Values.assign(values.begin(), values.end());
  return samples;
}

void MeasureVariogram(benchmark::State& state)
{
  const int threads = static_cast<int>(state.range(0));
  const int side = static_cast<int>(std::lround(std::sqrt(state.range(1))));
  const GridSamples samples = Terrain(side);
  for (auto _ : state)
  {
    const VariogramMap map = ComputeVariogramMap(
      samples, 0.5 * side, [=](std::size_t count, const RangeTask& task) { OnThreads(threads, count, task); });
    benchmark::DoNotOptimize(BinVariogram(map, 0.5 * side, 40, 12));
  }
}
BENCHMARK(MeasureVariogram)
  ->ArgNames({ "threads", "size" })
  ->ArgsProduct({ { 1, 2 }, { 256 * 256, 512 * 512, Size* Size, 4 * Size* Size } })
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();

void FitSevenModels(benchmark::State& state)
{
  const VariogramMap map = ComputeVariogramMap(Terrain(), 0.5 * Size);
  VariogramFitOptions options;
  options.MaximumRange = 0.25 * Size;
  options.FractalRange = 4.0 * Size;
  options.Anisotropy = state.range(0) != 0;
  const std::vector<LagBin> bins = BinVariogram(map, 0.5 * Size, 40, options.Anisotropy ? 12 : 1);
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(FitAllModels(bins, options));
  }
}
BENCHMARK(FitSevenModels)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->UseRealTime();

}

BENCHMARK_MAIN();
