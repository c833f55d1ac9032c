// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/ParameterCheck.h"

#include <cmath>
#include <cstdio>

namespace littoral
{

namespace
{

/// "TimeStep is 2 s; it must be ..."
std::string Sentence(const std::string& name, const std::string& value, const char* unit, const std::string& wanted)
{
  return name + " is " + value + (*unit ? std::string(" ") + unit : std::string()) + "; it must be " + wanted + ".";
}

std::string WithUnit(double value, const char* unit)
{
  return TextOf(value) + (*unit ? std::string(" ") + unit : std::string());
}

}

std::string TextOf(double value)
{
  char text[32];
  for (int digits = 6; digits <= 17; ++digits)
  {
    std::snprintf(text, sizeof(text), "%.*g", digits, value);
    if (!std::isfinite(value) || std::stod(text) == value)
    {
      break;
    }
  }
  return text;
}

void ParameterCheck::Require(bool isGood, const std::string& otherwise)
{
  if (this->IsGood() && !isGood)
  {
    this->First = otherwise;
  }
}

void ParameterCheck::Require(
  bool isGood, const std::string& name, const std::string& value, const char* unit, const std::string& wanted)
{
  this->Require(isGood, isGood ? std::string() : Sentence(name, value, unit, wanted));
}

void ParameterCheck::Range(const std::string& name, double value, double low, double high, const char* unit)
{
  if (!(value >= low && value <= high))
  {
    this->Require(false, Sentence(name, TextOf(value), unit, "from " + TextOf(low) + " to " + WithUnit(high, unit)));
  }
}

void ParameterCheck::Positive(const std::string& name, double value, const char* unit, double high)
{
  if (!(std::isfinite(value) && value > 0.0 && value <= high))
  {
    this->Require(false,
      Sentence(name, TextOf(value), unit,
        "positive and " + (std::isfinite(high) ? "at most " + WithUnit(high, unit) : "finite")));
  }
}

void ParameterCheck::NotNegative(const std::string& name, double value, const char* unit, double high)
{
  if (!(std::isfinite(value) && value >= 0.0 && value <= high))
  {
    this->Require(false,
      std::isfinite(high) ? Sentence(name, TextOf(value), unit, "from 0 to " + WithUnit(high, unit))
                          : Sentence(name, TextOf(value), unit, "finite and not negative"));
  }
}

void ParameterCheck::Finite(const std::string& name, double value, const char* unit)
{
  if (!std::isfinite(value))
  {
    this->Require(false, Sentence(name, TextOf(value), unit, "finite"));
  }
}

void ParameterCheck::Choice(const std::string& name, int value, int count)
{
  if (value < 0 || value >= count)
  {
    const std::string last = std::to_string(count - 1);
    this->Require(
      false, Sentence(name, std::to_string(value), "", count == 2 ? std::string("0 or 1") : "from 0 to " + last));
  }
}

void ParameterCheck::Count(const std::string& name, long long value, long long low, long long high)
{
  if (value < low || value > high)
  {
    this->Require(
      false, Sentence(name, std::to_string(value), "", "from " + std::to_string(low) + " to " + std::to_string(high)));
  }
}

}
