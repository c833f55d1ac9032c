// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralFuzzExpect_h
#define LittoralFuzzExpect_h

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

/// A reason why data cannot be read is empty or one sentence.
inline void ExpectSentence(const std::string& reason)
{
  Expect(reason.empty() || reason.back() == '.', "Not a sentence: " + reason);
}

#endif
