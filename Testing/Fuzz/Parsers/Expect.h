// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralFuzzExpect_h
#define LittoralFuzzExpect_h

#include "Numerics/InvalidInput.h"

#include <cstdio>
#include <cstdlib>
#include <string>

/// Ends the program, so that libFuzzer keeps the bytes that led here.
inline void Expect(bool isGood, const std::string& otherwise)
{
  if (!isGood)
  {
    std::fprintf(stderr, "%s\n", otherwise.c_str());
    std::abort();
  }
}

/// Whether a reader reads; else it must refuse by one sentence.
template <typename Reader>
bool ReadsOrRefuses(const Reader& reader)
{
  const std::string why = littoral::WhyRefused(reader);
  Expect(why.empty() || why.back() == '.', "Not a sentence: " + why);
  return why.empty();
}

#endif
