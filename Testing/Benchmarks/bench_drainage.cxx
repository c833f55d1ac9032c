// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Cost of carving valleys, of growing and quilting landscapes, and of its steps, by the number of cells: time, rounds,
// memory a cell.
#include "Drainage/DepressionBreaching.h"
#include "Drainage/DepressionFilling.h"
#include "Drainage/DrainageCarving.h"
#include "Drainage/FlowRouting.h"
#include "Drainage/TiledDrainage.h"
#include "Landscapes/LandscapeGrowth.h"
#include "Landscapes/LandscapeQuilting.h"
#include "Terrain/TurningBands.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

using namespace littoral;

namespace
{

constexpr double Spacing = 80.0;

/// A loop on two threads.
void OnTwoThreads(std::size_t count, const RangeTask& task)
{
  std::thread other([&] { task(count / 2, count); });
  task(0, count / 2);
  other.join();
}

/// A square of hills, and what is carved into it, as a twin of ridges and valleys of some tens of kilometres.
GridSamples Hills(int width, int seed)
{
  TurningBandsParameters bands;
  bands.Field.Model = CovarianceModel::Bessel1;
  bands.Field.Variance = 150.0 * 150.0;
  bands.Field.Range = 1400.0;
  bands.Seed = seed;
  const PlaneGrid grid{ { 0.0, 0.0 }, { Spacing, Spacing } };
  const GridWindow window{ { 0, 0 }, { width - 1, width - 1 } };
  bands.NumberOfLines = 1;
  bands.NumberOfLines = EnoughLines(bands, grid, window);
  TurningBandsField field(bands, grid, window);
  OnTwoThreads(field.GetNumberOfLines(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t line = begin; line < end; ++line)
    {
      field.TabulateLine(line);
    }
  });
  std::vector<float> heights(static_cast<std::size_t>(width) * width);
  OnTwoThreads(width, [&](std::size_t begin, std::size_t end) {
    field.FillRows(static_cast<int>(begin), static_cast<int>(end) - 1, 1.0, 500.0, &heights[begin * width]);
  });
  GridSamples hills;
  hills.Width = width;
  hills.Height = width;
  hills.Spacing = { Spacing, Spacing };
  hills.Values.assign(heights.begin(), heights.end());
  return hills;
}

/// The most memory that this process has had since ForgetMostMemory() [bytes]; 0 where /proc does not tell.
double MostMemory()
{
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
  {
    double kibibytes = 0.0;
    if (word == "VmHWM:" && status >> kibibytes)
    {
      return 1024.0 * kibibytes;
    }
  }
  return 0.0;
}

void ForgetMostMemory()
{
  std::ofstream("/proc/self/clear_refs") << "5";
}

int WidthOf(const benchmark::State& state)
{
  return static_cast<int>(std::lround(std::sqrt(static_cast<double>(state.range(0)))));
}

void Carve(benchmark::State& state, const GridSamples& hills, const CarvingTarget& target)
{
  CarvingReport report;
  for (auto _ : state)
  {
    GridSamples ground = hills;
    ForgetMostMemory();
    const double before = MostMemory();
    report = CarveDrainage(ground, target, {}, OnTwoThreads);
    state.counters["bytes_a_cell"] = (MostMemory() - before) / static_cast<double>(state.range(0));
  }
  state.counters["rounds"] = report.Iterations;
  state.SetLabel(report.UnmetTargets);
  state.counters["reached"] = report.HasConverged ? 1.0 : 0.0;
}

/// With the statistics of a place: those of other hills, of a quarter million cells, into which valleys were carved.
void CarveLikePlace(benchmark::State& state)
{
  GridSamples place = Hills(512, 7);
  TargetStatistics numbers;
  numbers.Concavity = 0.35;
  CarveDrainage(place, TargetOf(place, numbers, {}, OnTwoThreads), {}, OnTwoThreads);
  Carve(state, Hills(WidthOf(state), 1), TargetOf(place, {}, OnTwoThreads));
}

/// With the terrain's own statistics.
void CarveAlone(benchmark::State& state)
{
  const GridSamples hills = Hills(WidthOf(state), 1);
  Carve(state, hills, TargetOf(hills, TargetStatistics(), {}, OnTwoThreads));
}

/// Landscapes of the kind of ground into which valleys were carved.
template <typename Method>
void MakeLikePlace(benchmark::State& state, const Method& method)
{
  GridSamples place = Hills(256, 7);
  CarveDrainage(place, TargetOf(place, TargetStatistics(), {}, OnTwoThreads), {}, OnTwoThreads);
  const GridSamples hills = Hills(WidthOf(state), 1);
  CarvingReport report;
  for (auto _ : state)
  {
    GridSamples ground = hills;
    ForgetMostMemory();
    const double before = MostMemory();
    report = method(ground, place);
    state.counters["bytes_a_cell"] = (MostMemory() - before) / static_cast<double>(state.range(0));
  }
  state.counters["rounds"] = report.Iterations;
  state.SetLabel(report.UnmetTargets);
}

void GrowLikePlace(benchmark::State& state)
{
  MakeLikePlace(state,
    [](GridSamples& ground, const GridSamples& place) { return GrowLandscape(ground, place, {}, OnTwoThreads); });
}

void QuiltLikePlace(benchmark::State& state)
{
  MakeLikePlace(state,
    [](GridSamples& ground, const GridSamples& place) { return QuiltLandscape(ground, place, 1, OnTwoThreads); });
}

void Flood(benchmark::State& state)
{
  const GridSamples hills = Hills(WidthOf(state), 1);
  const OutletMask outlets = BorderOutlets(hills.Width, hills.Height);
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(FloodDepressions(hills, outlets).DepressionCells);
  }
}

void Breach(benchmark::State& state)
{
  const GridSamples hills = Hills(WidthOf(state), 1);
  const OutletMask outlets = BorderOutlets(hills.Width, hills.Height);
  const BreachPath path = state.range(1) ? BreachPath::LeastCost : BreachPath::FloodOrder;
  for (auto _ : state)
  {
    GridSamples ground = hills;
    const BreachCount count = BreachDepressions(ground, outlets, path);
    state.counters["searched_a_cell"] = static_cast<double>(count.Searched) / static_cast<double>(state.range(0));
  }
}

void Route(benchmark::State& state)
{
  const GridSamples hills = Hills(WidthOf(state), 1);
  const OutletMask outlets = BorderOutlets(hills.Width, hills.Height);
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(FlowAccumulation(RouteFlow(hills, outlets, OnTwoThreads)).data());
  }
}

/// The same by tiles of 256 cells, whose heights are cut out three times.
void RouteByTiles(benchmark::State& state)
{
  const GridSamples hills = Hills(WidthOf(state), 1);
  const auto groundOf = [&](const TileWindow& window) {
    TileGround ground{ window, { window.Width + 2, window.Height + 2, hills.Spacing, {} } };
    for (int j = window.Y - 1; j <= window.Y + window.Height; ++j)
    {
      for (int i = window.X - 1; i <= window.X + window.Width; ++i)
      {
        const bool isThere = i >= 0 && j >= 0 && i < hills.Width && j < hills.Height;
        ground.Heights.Values.push_back(isThere ? hills.At(i, j) : std::nan(""));
      }
    }
    return ground;
  };
  for (auto _ : state)
  {
    TiledDrainage drainage(hills.Width, hills.Height, 256, -1e9);
    const TileGrid& tiles = drainage.Tiles();
    for (int tile = 0; tile < tiles.Count(); ++tile)
    {
      drainage.FindSpills(groundOf(tiles.Window(tile)));
    }
    drainage.JoinSpills();
    for (int tile = 0; tile < tiles.Count(); ++tile)
    {
      drainage.Route(groundOf(tiles.Window(tile)));
    }
    drainage.JoinFlow();
    for (int tile = 0; tile < tiles.Count(); ++tile)
    {
      benchmark::DoNotOptimize(drainage.Drain(groundOf(tiles.Window(tile))).Cells.data());
    }
  }
}

/// 4096^2 cells as the last argument: minutes; leave them out with --benchmark_filter='-size:16777216'.
void Sizes(benchmark::internal::Benchmark* bench)
{
  bench->ArgName("size")->Arg(1 << 16)->Arg(1 << 18)->Arg(1 << 20)->Arg(1 << 22)->Arg(1 << 24);
  bench->Iterations(1)->UseRealTime()->MeasureProcessCPUTime()->Unit(benchmark::kSecond);
}

}

BENCHMARK(CarveLikePlace)->Apply(Sizes);
BENCHMARK(CarveAlone)->Apply(Sizes);
BENCHMARK(QuiltLikePlace)->Apply(Sizes);
BENCHMARK(GrowLikePlace)
  ->ArgName("size")
  ->Arg(1 << 16)
  ->Arg(1 << 18)
  ->Arg(1 << 20)
  ->Iterations(1)
  ->UseRealTime()
  ->MeasureProcessCPUTime()
  ->Unit(benchmark::kSecond);
BENCHMARK(RouteByTiles)
  ->ArgName("size")
  ->Arg(1 << 16)
  ->Arg(1 << 18)
  ->Arg(1 << 20)
  ->Arg(1 << 22)
  ->Iterations(3)
  ->Unit(benchmark::kMillisecond);
BENCHMARK(Flood)->ArgName("size")->Arg(1 << 16)->Arg(1 << 18)->Arg(1 << 20)->Arg(1 << 22)->Iterations(3)->Unit(
  benchmark::kMillisecond);
BENCHMARK(Breach)
  ->ArgNames({ "size", "least cost" })
  ->ArgsProduct({ { 1 << 16, 1 << 18, 1 << 20, 1 << 22 }, { 0, 1 } })
  ->Iterations(3)
  ->Unit(benchmark::kMillisecond);
BENCHMARK(Route)
  ->ArgName("size")
  ->Arg(1 << 16)
  ->Arg(1 << 18)
  ->Arg(1 << 20)
  ->Arg(1 << 22)
  ->Iterations(3)
  ->MeasureProcessCPUTime()
  ->Unit(benchmark::kMillisecond);
