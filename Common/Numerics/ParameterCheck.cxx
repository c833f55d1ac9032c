// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/ParameterCheck.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace littoral
{

namespace
{

/// An element of a property as the panel has it: "Size[0]" is "Size, x".
std::string PanelName(std::string_view name)
{
  std::string text(name);
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::string index = "[" + std::to_string(axis) + "]";
    const std::size_t at = text.find(index);
    if (at != std::string::npos)
    {
      text.replace(at, index.size(), std::string(", ") + "xyz"[axis]);
    }
  }
  return text;
}

/// "TimeStep is 2 s; it must be ..."
std::string Sentence(std::string_view name, const std::string& value, const char* unit, std::string_view wanted)
{
  return PanelName(name) + " is " + value + (*unit ? " " : "") + unit + "; it must be " + std::string(wanted) + ".";
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
    static_cast<void>(std::snprintf(text, sizeof(text), "%.*g", digits, value));
    if (!std::isfinite(value) || std::strtod(text, nullptr) == value) // std::stod() refuses denormal numbers
    {
      break;
    }
  }
  return text;
}

bool IsSensible(double value)
{
  const double magnitude = std::abs(value);
  return value == 0.0 || (magnitude >= MinimumMagnitude && magnitude <= MaximumMagnitude);
}

bool ValueInterval::Contains(double value) const
{
  return std::isfinite(value) && (this->IncludesLow ? value >= this->Low : value > this->Low) &&
    (this->IncludesHigh ? value <= this->High : value < this->High);
}

std::string ValueInterval::Words(const char* unit) const
{
  const bool isOpen = std::isinf(this->High);
  const std::string high = WithUnit(this->High, unit);
  if (std::isinf(this->Low) && isOpen)
  {
    return "finite";
  }
  if (isOpen && this->Low == 0.0)
  {
    return this->IncludesLow ? "finite and not negative" : "positive and finite";
  }
  if (isOpen)
  {
    return "finite and " + std::string(this->IncludesLow ? "at least " : "above ") + WithUnit(this->Low, unit);
  }
  const std::string low = TextOf(this->Low);
  if (this->IncludesHigh)
  {
    return this->IncludesLow ? "from " + low + " to " + high
                             : (this->Low == 0.0 ? "positive" : "above " + low) + " and at most " + high;
  }
  return (this->IncludesLow ? "at least " : "above ") + low + " and below " + high;
}

void ParameterCheck::Require(bool isGood, std::string_view otherwise)
{
  if (this->IsGood() && !isGood)
  {
    this->First = otherwise;
  }
}

void ParameterCheck::Require(
  bool isGood, std::string_view name, double value, const char* unit, std::string_view wanted)
{
  if (!isGood)
  {
    this->Require(false, Sentence(name, TextOf(value), unit, wanted));
  }
}

void ParameterCheck::Within(std::string_view name, double value, const ValueInterval& allowed, const char* unit)
{
  if (!allowed.Contains(value))
  {
    this->Require(false, Sentence(name, TextOf(value), unit, allowed.Words(unit)));
  }
  else if (!IsSensible(value)) // words cost more than the check
  {
    this->Require(false, name, value, unit,
      "of a magnitude from " + TextOf(MinimumMagnitude) + " to " + WithUnit(MaximumMagnitude, unit));
  }
}

void ParameterCheck::Range(std::string_view name, double value, double low, double high, const char* unit)
{
  this->Within(name, value, ValueInterval::From(low, high), unit);
}

void ParameterCheck::Positive(std::string_view name, double value, const char* unit, double high)
{
  this->Within(name, value, ValueInterval::Above(0.0, high), unit);
}

void ParameterCheck::NotNegative(std::string_view name, double value, const char* unit, double high)
{
  this->Within(name, value, ValueInterval::From(0.0, high), unit);
}

void ParameterCheck::Finite(std::string_view name, double value, const char* unit)
{
  this->Within(name, value, {}, unit);
}

void ParameterCheck::Choice(std::string_view name, int value, int count)
{
  if (value < 0 || value >= count)
  {
    const std::string last = std::to_string(count - 1);
    this->Require(
      false, Sentence(name, std::to_string(value), "", count == 2 ? std::string("0 or 1") : "from 0 to " + last));
  }
}

void ParameterCheck::Choice(std::string_view name, int value, std::initializer_list<const char*> names)
{
  const int count = static_cast<int>(names.size());
  if (value < 0 || value >= count)
  {
    std::string wanted;
    for (int choice = 0; choice < count; ++choice)
    {
      wanted += choice == 0 ? "" : choice + 1 < count ? ", " : " or ";
      wanted += std::to_string(choice) + " (" + names.begin()[choice] + ")";
    }
    this->Require(false, Sentence(name, std::to_string(value), "", wanted));
  }
}

void ParameterCheck::Count(std::string_view name, long long value, long long low, long long high)
{
  if (value < low || value > high)
  {
    this->Require(
      false, Sentence(name, std::to_string(value), "", "from " + std::to_string(low) + " to " + std::to_string(high)));
  }
}

void ParameterCheck::PositiveCount(std::string_view name, long long value)
{
  if (value < 1)
  {
    this->Require(false, Sentence(name, std::to_string(value), "", "positive"));
  }
}

void ParameterCheck::Increasing(std::string_view name, const double* ends, const char* unit)
{
  this->Finite(std::string(name) + "[0]", ends[0], unit);
  this->Finite(std::string(name) + "[1]", ends[1], unit);
  if (!(ends[0] < ends[1]))
  {
    this->Require(false,
      std::string(name) + " is " + TextOf(ends[0]) + " to " + WithUnit(ends[1], unit) +
        "; the first must be below the second.");
  }
}

void ParameterCheck::Color(std::string_view name, const double* color)
{
  const auto isPart = [](double part) { return part >= 0.0 && part <= 1.0 && IsSensible(part); };
  if (!std::all_of(color, color + 3, isPart))
  {
    const std::string value = TextOf(color[0]) + ", " + TextOf(color[1]) + ", " + TextOf(color[2]);
    this->Require(false, Sentence(name, value, "", "from 0 to 1 in each part"));
  }
}

}
