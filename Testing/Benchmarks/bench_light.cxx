// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Tables of a clear sky: of its air, for all heights of the sun, and of a dome and light on planes under one sun.
#include "Light/Atmosphere.h"
#include "Light/SkyTables.h"
#include "Light/SunPosition.h"

#include <benchmark/benchmark.h>

using namespace littoral;

namespace
{

void MakeAir(benchmark::State& state)
{
  AirParameters parameters;
  parameters.Turbidity = static_cast<double>(state.range(0));
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(Atmosphere(parameters));
  }
}
BENCHMARK(MakeAir)->ArgName("turbidity")->Arg(2)->Arg(5)->Unit(benchmark::kMillisecond);

void MakeSky(benchmark::State& state)
{
  const Atmosphere air(AirParameters{});
  const Vector3 sun = DirectionOf({ static_cast<double>(state.range(0)), 180.0 });
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(TabulateSky(air, sun));
  }
}
BENCHMARK(MakeSky)->ArgName("sun")->Arg(60)->Arg(5)->Arg(-6)->Unit(benchmark::kMillisecond);

}
