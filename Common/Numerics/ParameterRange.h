// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralParameterRange_h
#define LittoralParameterRange_h

#include "Numerics/ParameterCheck.h"

#include <string>

namespace littoral
{

/// Why a parameter's value is bad, in words; empty when it is finite and within the range.
inline std::string OutOfRange(const char* name, double value, double low, double high)
{
  ParameterCheck check;
  check.Range(name, value, low, high);
  return check.Reason();
}

}

#endif
