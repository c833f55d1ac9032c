// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralTestMappedPatterns_h
#define LittoralTestMappedPatterns_h

#include "Patterns/ObservationWindow.h"

#include <cstddef>
#include <fstream>
#include <string>
#include <vector>

namespace littoral::testing
{

/// The points of a mapped pattern of Examples/Data/patterns.
inline std::vector<PlanePosition> Mapped(const std::string& name)
{
  std::ifstream file(std::string(LITTORAL_TEST_DATA) + "/../../Examples/Data/patterns/" + name + ".csv");
  std::string line;
  std::getline(file, line);
  std::vector<PlanePosition> points;
  while (std::getline(file, line))
  {
    const std::size_t comma = line.find(',');
    points.push_back({ std::stod(line), std::stod(line.substr(comma + 1)) });
  }
  return points;
}

}

#endif
