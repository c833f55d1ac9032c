// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Limits of the machine, beside which limits.py sets the other benchmarks: memory, its first use, sines with cosines
// and exponentials in single precision by SLEEF, each with one thread and with two.
#include "Numerics/SimdClones.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include <sys/mman.h>
#include <unistd.h>

#ifdef LITTORAL_WITH_SLEEF
#include <immintrin.h>
#endif

namespace
{

/// Words of 64 bits a thread, far more than a cache holds: 128 MiB.
constexpr std::size_t Words = 1 << 24;

/// Bytes a second of what a thread does with its memory, of which it reads or writes some times.
template <typename Work>
void Measure(benchmark::State& state, int times, const Work& work)
{
  for (auto _ : state)
  {
    work();
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(times * Words * sizeof(std::uint64_t)));
}

/// What is read and what is written both count.
void CopyMemory(benchmark::State& state)
{
  const std::vector<std::uint64_t> from(Words, 1);
  std::vector<std::uint64_t> to(Words, 2);
  Measure(state, 2, [&] { std::memcpy(to.data(), from.data(), Words * sizeof(std::uint64_t)); });
}
BENCHMARK(CopyMemory)->Threads(1)->Threads(2)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Memory that a process has not used before: 16 MiB, of which one byte a page is written.
void NewMemory(benchmark::State& state)
{
  constexpr std::size_t Bytes = 1 << 24;
  const std::size_t page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  for (auto _ : state)
  {
    void* memory = mmap(nullptr, Bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED)
    {
      state.SkipWithError("no memory");
      break;
    }
    for (std::size_t byte = 0; byte < Bytes; byte += page)
    {
      static_cast<volatile char*>(memory)[byte] = 1;
    }
    munmap(memory, Bytes);
  }
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(Bytes));
}
BENCHMARK(NewMemory)->Threads(1)->Threads(2)->Unit(benchmark::kMillisecond)->UseRealTime();

LITTORAL_WIDE_SIMD_CLONES std::uint64_t SumOf(const std::uint64_t* values)
{
  constexpr std::size_t Lanes = 32;
  std::array<std::uint64_t, Lanes> sums{};
  for (std::size_t i = 0; i < Words; i += Lanes)
  {
    for (std::size_t lane = 0; lane < Lanes; ++lane)
    {
      sums[lane] += values[i + lane];
    }
  }
  std::uint64_t sum = 0;
  for (const std::uint64_t part : sums)
  {
    sum += part;
  }
  return sum;
}

void ReadMemory(benchmark::State& state)
{
  const std::vector<std::uint64_t> values(Words, 1);
  Measure(state, 1, [&] { benchmark::DoNotOptimize(SumOf(values.data())); });
}
BENCHMARK(ReadMemory)->Threads(1)->Threads(2)->Unit(benchmark::kMillisecond)->UseRealTime();

void WriteMemory(benchmark::State& state)
{
  std::vector<std::uint64_t> values(Words, 1);
  Measure(state, 1, [&] { std::memset(values.data(), 3, Words * sizeof(std::uint64_t)); });
}
BENCHMARK(WriteMemory)->Threads(1)->Threads(2)->Unit(benchmark::kMillisecond)->UseRealTime();

#ifdef LITTORAL_WITH_SLEEF

/// Numbers that stay in the first-level cache.
constexpr int Count = 1024;

struct alignas(64) Numbers
{
  std::array<float, Count> X;
  std::array<float, Count> Sine;
  std::array<float, Count> Cosine;
};

/// The functions of one instruction set. Sines to 3.5 units in the last place, as the kernels; exponentials to 1.
struct Functions
{
  const char* Name;
  void (*SinesAndCosines)(Numbers&);
  void (*Exponentials)(Numbers&);
};

// A set by its name, its instructions, their vector and its length, the beginning of its intrinsics and the ending of
// SLEEF's functions, whose own header declares only what the whole file may use.
#define LITTORAL_FUNCTIONS(set, instructions, vector, length, intrinsic, ending)                                       \
  struct Both##set                                                                                                     \
  {                                                                                                                    \
    vector X;                                                                                                          \
    vector Y;                                                                                                          \
  };                                                                                                                   \
  extern "C" Both##set Sleef_sincosf##length##_u35##ending(vector);                                                    \
  extern "C" vector Sleef_expf##length##_u10##ending(vector);                                                          \
  __attribute__((target(instructions))) void Sines##set(Numbers& n)                                                    \
  {                                                                                                                    \
    for (int i = 0; i < Count; i += length)                                                                            \
    {                                                                                                                  \
      const Both##set both = Sleef_sincosf##length##_u35##ending(intrinsic##_load_ps(&n.X[i]));                        \
      intrinsic##_store_ps(&n.Sine[i], both.X);                                                                        \
      intrinsic##_store_ps(&n.Cosine[i], both.Y);                                                                      \
    }                                                                                                                  \
  }                                                                                                                    \
  __attribute__((target(instructions))) void Exponentials##set(Numbers& n)                                             \
  {                                                                                                                    \
    for (int i = 0; i < Count; i += length)                                                                            \
    {                                                                                                                  \
      intrinsic##_store_ps(&n.Sine[i], Sleef_expf##length##_u10##ending(intrinsic##_load_ps(&n.X[i])));                \
    }                                                                                                                  \
  }

LITTORAL_FUNCTIONS(Of512, "avx512f", __m512, 16, _mm512, avx512f)
LITTORAL_FUNCTIONS(Of256, "avx2,fma", __m256, 8, _mm256, avx2)
LITTORAL_FUNCTIONS(Of128, "sse2", __m128, 4, _mm, sse2)

/// Those of the widest instructions that the processor has, or no wider than a set that the environment names.
Functions Widest()
{
  const char* named = std::getenv("LITTORAL_INSTRUCTIONS"); // NOLINT(concurrency-mt-unsafe): nothing sets it
  const std::string most = named ? named : "AVX-512";
  if (most == "SSE2")
  {
    return { "SSE2", SinesOf128, ExponentialsOf128 };
  }
  if (most == "AVX-512" && __builtin_cpu_supports("avx512f"))
  {
    return { "AVX-512", SinesOf512, ExponentialsOf512 };
  }
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
  {
    return { "AVX2", SinesOf256, ExponentialsOf256 };
  }
  return { "SSE2", SinesOf128, ExponentialsOf128 };
}

void Evaluate(benchmark::State& state, void (*Functions::*function)(Numbers&))
{
  const Functions functions = Widest();
  Numbers numbers{};
  for (int i = 0; i < Count; ++i)
  {
    numbers.X[i] = -3.0f + 6.0f * static_cast<float>(i) / Count;
  }
  for (auto _ : state)
  {
    (functions.*function)(numbers);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * Count);
  state.SetLabel(functions.Name);
}

void SinesAndCosines(benchmark::State& state)
{
  Evaluate(state, &Functions::SinesAndCosines);
}
BENCHMARK(SinesAndCosines)->Threads(1)->Threads(2)->UseRealTime();

void Exponentials(benchmark::State& state)
{
  Evaluate(state, &Functions::Exponentials);
}
BENCHMARK(Exponentials)->Threads(1)->Threads(2)->UseRealTime();

#endif

}

BENCHMARK_MAIN();
