// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPrefetch_h
#define LittoralPrefetch_h

namespace littoral
{

/// Asks for memory that will be read soon, or not at all: no number depends on it.
inline void Prefetch(const void* memory)
{
#if defined(__GNUC__)
  __builtin_prefetch(memory);
#else
  static_cast<void>(memory);
#endif
}

}

#endif
