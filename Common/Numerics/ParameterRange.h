// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralParameterRange_h
#define LittoralParameterRange_h

#include <cmath>
#include <string>

namespace littoral
{

/// Why a parameter's value is bad, in words; empty when it is finite and within the range.
inline std::string OutOfRange(const char* name, double value, double low, double high)
{
  if (std::isfinite(value) && value >= low && value <= high)
  {
    return {};
  }
  return std::string(name) + " is " + std::to_string(value) + "; it must be from " + std::to_string(low) + " to " +
    std::to_string(high) + ".";
}

}

#endif
