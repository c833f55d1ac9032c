// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSimdClones_h
#define LittoralSimdClones_h

// Sanitizers start too late for the choice between versions, and take minutes to compile what is all in one piece.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define LITTORAL_IS_SANITIZED 1
#else
#define LITTORAL_IS_SANITIZED 0
#endif

/**
 * Marks a hot function that the compiler builds twice, for any x86-64 and for AVX2; the processor chooses when the
 * library is loaded. Floating-point contraction is off in this library and no loop is allowed to reassociate, so that
 * both versions give the same bytes.
 */
#if defined(__x86_64__) && defined(__gnu_linux__) && defined(__GNUC__) && !defined(__clang__) && !LITTORAL_IS_SANITIZED
#define LITTORAL_SIMD_CLONES __attribute__((target_clones("avx2", "default")))
/// The same with a third version, for AVX-512.
#define LITTORAL_WIDE_SIMD_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
/// Marks the versions of a function that is written otherwise for AVX-512: overloads among which the processor chooses.
#define LITTORAL_HAS_SIMD_VERSIONS 1
#define LITTORAL_AVX512_VERSION __attribute__((target("avx512f")))
#define LITTORAL_AVX2_VERSION __attribute__((target("avx2")))
#define LITTORAL_ANY_VERSION __attribute__((target("default")))
#else
#define LITTORAL_SIMD_CLONES
#define LITTORAL_WIDE_SIMD_CLONES
#define LITTORAL_HAS_SIMD_VERSIONS 0
#define LITTORAL_ANY_VERSION
#endif

/// Marks a function that becomes a part of each version of those that call it. What returns a vector of four must, and be
/// no lambda, which is not marked: versions hand it back in other places.
#if defined(__GNUC__) && !LITTORAL_IS_SANITIZED
#define LITTORAL_INLINE inline __attribute__((always_inline))
#else
#define LITTORAL_INLINE inline
#endif

/// Before a loop no turn of which writes what another one reads: the compiler need not check it at each run.
#if defined(__GNUC__) && !defined(__clang__)
#define LITTORAL_INDEPENDENT _Pragma("GCC ivdep")
#else
#define LITTORAL_INDEPENDENT
#endif

#endif
