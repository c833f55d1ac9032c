// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/RandomStream.h"

#include "Numerics/Constants.h"
#include "Numerics/PhiloxLanes.h"
#include "Numerics/SimdClones.h"

#include <Random123/philox.h>

#include <cmath>
#include <cstring>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace littoral
{

namespace
{
/// The middle of one of 2^52 equal cells of (0, 1): never 0, never 1, exact in double precision.
double OpenUnitInterval(std::uint32_t high, std::uint32_t low)
{
  const std::uint64_t bits = (static_cast<std::uint64_t>(high) << 32 | low) >> 12;
  return (static_cast<double>(bits) + 0.5) * 0x1p-52;
}

#if defined(__SSE2__)
/// One word of the counters of two draws, each in the lower half of its lane; upper halves do not count.
using WordPair = std::uint64_t __attribute__((vector_size(16)));
/// Pairs of draws whose rounds are computed side by side.
constexpr int PairsAtOnce = 2;
constexpr int DrawsAtOnce = 2 * PairsAtOnce;

/// Products of the lower halves; the compiler would multiply whole lanes.
LITTORAL_INLINE WordPair Multiply(WordPair a, WordPair b)
{
  return reinterpret_cast<WordPair>(_mm_mul_epu32(reinterpret_cast<__m128i>(a), reinterpret_cast<__m128i>(b)));
}

/// Words of whole groups of DrawsAtOnce draws.
LITTORAL_SIMD_CLONES void FillGroups(std::uint64_t object, std::uint64_t draw, std::size_t groups, std::uint32_t key0,
  std::uint32_t key1, std::uint32_t* words)
{
  const WordPair factor0 = WordPair{} + PHILOX_M4x32_0;
  const WordPair factor1 = WordPair{} + PHILOX_M4x32_1;
  for (std::size_t group = 0; group < groups; ++group)
  {
    WordPair c[4][PairsAtOnce];
    for (int p = 0; p < PairsAtOnce; ++p)
    {
      const std::uint64_t first = draw + group * DrawsAtOnce + 2 * static_cast<std::uint64_t>(p);
      c[0][p] = WordPair{} + object;
      c[1][p] = WordPair{} + (object >> 32);
      c[2][p] = WordPair{ first, first + 1 };
      c[3][p] = c[2][p] >> 32;
    }
    for (std::uint32_t round = 0; round < 10; ++round)
    {
      const WordPair k0 = WordPair{} + (key0 + round * PHILOX_W32_0);
      const WordPair k1 = WordPair{} + (key1 + round * PHILOX_W32_1);
      for (int p = 0; p < PairsAtOnce; ++p)
      {
        // (c0, c1, c2, c3) <- (high(M1 c2) ^ c1 ^ k0, low(M1 c2), high(M0 c0) ^ c3 ^ k1, low(M0 c0))
        const WordPair product0 = Multiply(c[0][p], factor0);
        const WordPair product1 = Multiply(c[2][p], factor1);
        c[0][p] = (product1 >> 32) ^ c[1][p] ^ k0;
        c[1][p] = product1;
        c[2][p] = (product0 >> 32) ^ c[3][p] ^ k1;
        c[3][p] = product0;
      }
    }
    for (int p = 0; p < PairsAtOnce; ++p)
    {
      // In memory, the lower half of a lane comes first.
      const WordPair front = (c[0][p] & 0xffffffffu) | (c[1][p] << 32);
      const WordPair back = (c[2][p] & 0xffffffffu) | (c[3][p] << 32);
      const WordPair both[2] = { { front[0], back[0] }, { front[1], back[1] } };
      std::memcpy(words + 4 * (group * DrawsAtOnce + 2 * static_cast<std::size_t>(p)), both, sizeof(both));
    }
  }
}
#endif
}

std::array<std::uint32_t, 4> RandomStream::Words(std::uint64_t object, std::uint64_t draw) const
{
  const r123::Philox4x32::ctr_type counter = { { static_cast<std::uint32_t>(object),
    static_cast<std::uint32_t>(object >> 32), static_cast<std::uint32_t>(draw),
    static_cast<std::uint32_t>(draw >> 32) } };
  const r123::Philox4x32::key_type key = { { this->Key[0], this->Key[1] } };
  const auto words = r123::Philox4x32()(counter, key);
  return { words[0], words[1], words[2], words[3] };
}

void RandomStream::FillWords(std::uint64_t object, std::uint64_t draw, std::size_t count, std::uint32_t* words) const
{
  std::size_t n = 0;
#if defined(__SSE2__)
  n = count / DrawsAtOnce * DrawsAtOnce;
  FillGroups(object, draw, n / DrawsAtOnce, this->Key[0], this->Key[1], words);
#endif
  for (; n < count; ++n)
  {
    const auto four = this->Words(object, draw + n);
    std::memcpy(words + 4 * n, four.data(), sizeof(four));
  }
}

std::array<double, 2> RandomStream::UniformPair(std::uint64_t object, std::uint64_t draw) const
{
  const auto words = this->Words(object, draw);
  return { OpenUnitInterval(words[0], words[1]), OpenUnitInterval(words[2], words[3]) };
}

void RandomStream::UniformPairs(
  std::size_t count, const std::uint64_t* objects, const std::uint64_t* draws, double* first, double* second) const
{
  for (std::size_t n = PhiloxPairs(this->Key, count, objects, draws, first, second); n < count; ++n)
  {
    const auto pair = this->UniformPair(objects[n], draws[n]);
    first[n] = pair[0];
    second[n] = pair[1];
  }
}

std::array<double, 2> RandomStream::NormalPair(std::uint64_t object, std::uint64_t draw) const
{
  const auto uniform = this->UniformPair(object, draw);
  const double radius = std::sqrt(-2.0 * std::log(uniform[0]));
  const double angle = TwoPi * uniform[1];
  return { radius * std::cos(angle), radius * std::sin(angle) };
}

}
