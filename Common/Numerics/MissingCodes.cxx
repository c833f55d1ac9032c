// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/MissingCodes.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <map>
#include <string>

namespace littoral
{

bool IsCodeLike(double number)
{
  char text[32];
  const auto [end, error] = std::to_chars(text, text + sizeof(text), std::abs(number), std::chars_format::fixed);
  if (error != std::errc())
  {
    return false;
  }
  const bool isNines = std::all_of(text, end, [](char letter) { return letter == '9' || letter == '.'; });
  const auto nines = std::count(text, end, '9');
  return (isNines && nines >= (number < 0.0 ? 1 : 3)) || std::abs(number) == 5005.0;
}

std::set<double> MissingCodes(const std::vector<double>& column, double largestLikely)
{
  std::map<double, int> others; // numbers that are not like a code, and how often each is there
  for (const double number : column)
  {
    if (std::isfinite(number) && !IsCodeLike(number))
    {
      ++others[number];
    }
  }
  const double largest = others.empty() ? 0.0 : std::max(0.0, others.rbegin()->first);
  std::set<double> codes;
  for (const double number : column)
  {
    if (std::isfinite(number) && IsCodeLike(number) && (number < 0.0 || number > 2.0 * largest))
    {
      codes.insert(number);
    }
  }
  const double next = others.size() < 2 ? largest : std::next(others.rbegin())->first;
  if (largest > 2.0 * next && largest > largestLikely && others.rbegin()->second > 1)
  {
    codes.insert(largest);
  }
  return codes;
}

}
