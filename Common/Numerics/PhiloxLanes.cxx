// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/PhiloxLanes.h"

#include <cstring>

#if defined(__x86_64__) && defined(__GNUC__)
#define LITTORAL_HAS_PHILOX_LANES 1
#ifndef __clang__ // GCC 12 warns of its own header
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <immintrin.h>
#ifndef __clang__
#pragma GCC diagnostic pop
#endif
#else
#define LITTORAL_HAS_PHILOX_LANES 0
#endif

namespace littoral
{

#if LITTORAL_HAS_PHILOX_LANES

namespace
{

/// A counter a lane of 64 bits, of which each of the four words takes the lower half.
template <std::size_t Lanes>
struct Vectors
{
  typedef std::uint64_t Words __attribute__((vector_size(8 * Lanes)));
};

}

// The product of the lower halves of lanes is one instruction, which the compiler finds in no loop: hence a function
// for each width of vectors, which may not share inline functions, as these would be compiled for any x86-64.
// 1. Counter (c0, c1, c2, c3) = object and draw, lower words first.
// 2. Ten rounds: c0' = high(M1 c2) ^ c1 ^ k0, c1' = low(M1 c2), c2' = high(M0 c0) ^ c3 ^ k1, c3' = low(M0 c0); the key
//    (k0, k1) grows by Weyl's constants. What is left above a low word is never read.
// 3. Bits c0 2^32 + c1 and c2 2^32 + c3.
#define LITTORAL_PHILOX(lanes, instructions, Product)                                                                  \
  __attribute__((target(instructions))) static void PhiloxOf##lanes(const std::array<std::uint32_t, 2>& key,           \
    std::size_t count, const std::uint64_t* objects, const std::uint64_t* draws, std::uint64_t* first,                 \
    std::uint64_t* second)                                                                                             \
  {                                                                                                                    \
    using Words = Vectors<lanes>::Words;                                                                               \
    const Words m0 = Words{} + std::uint64_t{ 0xD2511F53 };                                                            \
    const Words m1 = Words{} + std::uint64_t{ 0xCD9E8D57 };                                                            \
    for (std::size_t n = 0; n < count; n += (lanes))                                                                   \
    {                                                                                                                  \
      Words c0;                                                                                                        \
      Words c2;                                                                                                        \
      std::memcpy(&c0, objects + n, sizeof(c0));                                                                       \
      std::memcpy(&c2, draws + n, sizeof(c2));                                                                         \
      Words c1 = c0 >> 32;                                                                                             \
      Words c3 = c2 >> 32;                                                                                             \
      std::uint32_t k0 = key[0];                                                                                       \
      std::uint32_t k1 = key[1];                                                                                       \
      for (int round = 0; round < 10; ++round)                                                                         \
      {                                                                                                                \
        const Words p0 = Product(c0, m0);                                                                              \
        const Words p1 = Product(c2, m1);                                                                              \
        c0 = (p1 >> 32) ^ c1 ^ std::uint64_t{ k0 };                                                                    \
        c1 = p1;                                                                                                       \
        c2 = (p0 >> 32) ^ c3 ^ std::uint64_t{ k1 };                                                                    \
        c3 = p0;                                                                                                       \
        k0 += 0x9E3779B9u;                                                                                             \
        k1 += 0xBB67AE85u;                                                                                             \
      }                                                                                                                \
      const Words low = Words{} + std::uint64_t{ 0xFFFFFFFF };                                                         \
      const Words b0 = (c0 << 32) | (c1 & low);                                                                        \
      const Words b1 = (c2 << 32) | (c3 & low);                                                                        \
      std::memcpy(first + n, &b0, sizeof(b0));                                                                         \
      std::memcpy(second + n, &b1, sizeof(b1));                                                                        \
    }                                                                                                                  \
  }

#define LITTORAL_PRODUCT_OF_2(a, b) (Words)(_mm_mul_epu32((__m128i)(a), (__m128i)(b)))
#define LITTORAL_PRODUCT_OF_4(a, b) (Words)(_mm256_mul_epu32((__m256i)(a), (__m256i)(b)))
#define LITTORAL_PRODUCT_OF_8(a, b) (Words)(_mm512_mul_epu32((__m512i)(a), (__m512i)(b)))
LITTORAL_PHILOX(2, "sse2", LITTORAL_PRODUCT_OF_2)
LITTORAL_PHILOX(4, "avx2", LITTORAL_PRODUCT_OF_4)
LITTORAL_PHILOX(8, "avx512f", LITTORAL_PRODUCT_OF_8)

std::array<std::size_t, 3> PhiloxWidths()
{
  if (__builtin_cpu_supports("avx512f"))
  {
    return { 8, 4, 2 };
  }
  if (__builtin_cpu_supports("avx2"))
  {
    return { 4, 2, 0 };
  }
  return { 2, 0, 0 };
}

std::size_t PhiloxBitsOfWidth(std::size_t lanes, const std::array<std::uint32_t, 2>& key, std::size_t count,
  const std::uint64_t* objects, const std::uint64_t* draws, std::uint64_t* first, std::uint64_t* second)
{
  const std::size_t whole = count / lanes * lanes;
  const auto pairs = lanes == 8 ? PhiloxOf8 : lanes == 4 ? PhiloxOf4 : PhiloxOf2;
  pairs(key, whole, objects, draws, first, second);
  return whole;
}

std::size_t PhiloxBits(const std::array<std::uint32_t, 2>& key, std::size_t count, const std::uint64_t* objects,
  const std::uint64_t* draws, std::uint64_t* first, std::uint64_t* second)
{
  return PhiloxBitsOfWidth(PhiloxWidths()[0], key, count, objects, draws, first, second);
}

#else

std::array<std::size_t, 3> PhiloxWidths()
{
  return { 0, 0, 0 };
}

std::size_t PhiloxBitsOfWidth(std::size_t, const std::array<std::uint32_t, 2>&, std::size_t, const std::uint64_t*,
  const std::uint64_t*, std::uint64_t*, std::uint64_t*)
{
  return 0;
}

std::size_t PhiloxBits(const std::array<std::uint32_t, 2>&, std::size_t, const std::uint64_t*, const std::uint64_t*,
  std::uint64_t*, std::uint64_t*)
{
  return 0;
}

#endif

}
