// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSrgbCode_h
#define LittoralSrgbCode_h

#include <cmath>

namespace littoral
{

/// Linear light of a value in the code of sRGB, both 0 to 1 (IEC 61966-2-1).
inline double LinearOfSrgb(double code)
{
  return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}

}

#endif
