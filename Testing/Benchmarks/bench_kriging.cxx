// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Speed of estimates from all data and from neighbourhoods, by the number of data.
#include "Kriging/Kriging.h"
#include "Numerics/RandomStream.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <thread>
#include <vector>

using namespace littoral;

namespace
{

/// Data at random places of a square kilometre, with heights that mean nothing.
KrigingData Survey(std::size_t count)
{
  const RandomStream random(3, RandomPurpose::QuadratPositions);
  KrigingData data;
  for (std::size_t n = 0; n < count; ++n)
  {
    const auto place = random.UniformPair(n, 0);
    data.Places.push_back({ 1000.0 * place[0], 1000.0 * place[1], 0.0 });
    data.Values.push_back(random.NormalPair(n, 1)[0]);
  }
  return data;
}

KrigingModel Exponential()
{
  KrigingModel model;
  model.Field.Range = 200.0;
  return model;
}

KrigingOptions Square(std::size_t neighbors)
{
  KrigingOptions options;
  options.Neighbors = neighbors;
  options.High = { 1000.0, 1000.0, 0.0 };
  return options;
}

/// Places all over the square.
std::vector<KrigingPlace> Places(std::size_t count)
{
  std::vector<KrigingPlace> places;
  for (std::size_t n = 0; n < count; ++n)
  {
    places.push_back({ static_cast<double>(n % 1000), static_cast<double>(37 * n % 1000), 0.0 });
  }
  return places;
}

void Factor(benchmark::State& state)
{
  const KrigingData data = Survey(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state)
  {
    const Kriging kriging(Exponential(), data, Square(0));
    benchmark::DoNotOptimize(kriging.GetNeighbors());
  }
}

void EstimateFromAll(benchmark::State& state)
{
  const Kriging kriging(Exponential(), Survey(static_cast<std::size_t>(state.range(0))), Square(0));
  const std::vector<KrigingPlace> places = Places(1000);
  std::vector<double> estimates(places.size());
  for (auto _ : state)
  {
    kriging.Estimate(places.data(), places.size(), estimates.data());
    benchmark::DoNotOptimize(estimates.data());
  }
}

void VariancesFromAll(benchmark::State& state)
{
  const Kriging kriging(Exponential(), Survey(static_cast<std::size_t>(state.range(0))), Square(0));
  const std::vector<KrigingPlace> places = Places(256);
  std::vector<double> estimates(places.size());
  std::vector<double> variances(places.size());
  for (auto _ : state)
  {
    kriging.Estimate(places.data(), places.size(), estimates.data(), variances.data());
    benchmark::DoNotOptimize(variances.data());
  }
}

void EstimateFromFifty(benchmark::State& state)
{
  const Kriging kriging(Exponential(), Survey(static_cast<std::size_t>(state.range(0))), Square(50));
  const std::vector<KrigingPlace> places = Places(1000);
  std::vector<double> estimates(places.size());
  for (auto _ : state)
  {
    kriging.Estimate(places.data(), places.size(), estimates.data());
    benchmark::DoNotOptimize(estimates.data());
  }
}

/// A whole field on two threads: nodes of a square, all data or neighbourhoods.
void Nodes(benchmark::State& state)
{
  const auto neighbors = static_cast<std::size_t>(state.range(1));
  const Kriging kriging(Exponential(), Survey(static_cast<std::size_t>(state.range(2))), Square(neighbors));
  const std::vector<KrigingPlace> places = Places(static_cast<std::size_t>(state.range(0)));
  std::vector<double> estimates(places.size());
  const auto estimate = [&](std::size_t begin, std::size_t end) {
    kriging.Estimate(&places[begin], end - begin, &estimates[begin]);
  };
  for (auto _ : state)
  {
    std::thread other([&] { estimate(places.size() / 2, places.size()); });
    estimate(0, places.size() / 2);
    other.join();
  }
}

}

BENCHMARK(Nodes)
  ->ArgNames({ "size", "neighbors", "data" })
  ->ArgsProduct({ { 10000, 100000, 1000000 }, { 0 }, { 1000 } })
  ->ArgsProduct({ { 10000, 100000, 1000000 }, { 50 }, { 100000 } })
  ->Iterations(1)
  ->UseRealTime()
  ->MeasureProcessCPUTime()
  ->Unit(benchmark::kSecond);
BENCHMARK(Factor)->ArgName("size")->Arg(250)->Arg(500)->Arg(1000)->Arg(2000)->Unit(benchmark::kMillisecond);
BENCHMARK(EstimateFromAll)->ArgName("size")->Arg(250)->Arg(1000)->Arg(4000)->Unit(benchmark::kMillisecond);
BENCHMARK(VariancesFromAll)->ArgName("size")->Arg(250)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(EstimateFromFifty)->ArgName("size")->Arg(1000)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond);
