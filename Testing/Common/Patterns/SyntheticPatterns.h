// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralTestSyntheticPatterns_h
#define LittoralTestSyntheticPatterns_h

// The patterns of spatstat_reference.R, from the same numbers, and what spatstat finds for them.

#include "Patterns/ObservationWindow.h"

#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace littoral::testing
{

struct SyntheticPattern
{
  std::string Name;
  ObservationWindow Window;
  std::vector<PlanePosition> Points;
  std::vector<double> Marks;
};

/// Parents and their offspring, uniform in squares about them; those outside the window are left out.
inline SyntheticPattern Clusters(
  const char* name, const ObservationWindow& window, unsigned seed, int parents, int offspring, double reach)
{
  SyntheticPattern pattern{ name, window, {}, {} };
  std::minstd_rand0 generator(seed);
  const auto uniform = [&] { return static_cast<double>(generator()) / 2147483647.0; };
  for (int parent = 0; parent < parents; ++parent)
  {
    const double x = window.GetLow()[0] + (window.GetHigh()[0] - window.GetLow()[0]) * uniform();
    const double y = window.GetLow()[1] + (window.GetHigh()[1] - window.GetLow()[1]) * uniform();
    for (int child = 0; child < offspring; ++child)
    {
      const double dx = reach * (2.0 * uniform() - 1.0);
      const double dy = reach * (2.0 * uniform() - 1.0);
      const double mark = 1.0 + 9.0 * uniform();
      if (window.Contains({ x + dx, y + dy }))
      {
        pattern.Points.push_back({ x + dx, y + dy });
        pattern.Marks.push_back(mark);
      }
    }
  }
  return pattern;
}

inline std::vector<SyntheticPattern> SyntheticPatterns()
{
  const auto box = ObservationWindow::Rectangle({ 0.0, -20.0 }, { 100.0, 60.0 });
  const auto polygon = ObservationWindow::Polygon(
    { { 0.0, 10.0 }, { 90.0, 0.0 }, { 100.0, 80.0 }, { 60.0, 60.0 }, { 40.0, 95.0 }, { 5.0, 70.0 } });
  return { Clusters("clusters", box, 11, 40, 6, 4.0), Clusters("scattered", ObservationWindow(), 12, 300, 1, 0.0),
    Clusters("polygon", polygon, 13, 50, 5, 6.0) };
}

/// A value of a function at a distance.
struct ReferenceValue
{
  std::string Pattern;
  std::string Function;
  std::string Correction;
  double Distance;
  double Value;
};

inline std::vector<ReferenceValue> ReadReference(const std::string& path)
{
  std::vector<ReferenceValue> values;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);)
  {
    std::istringstream words(line);
    ReferenceValue value;
    std::getline(words, value.Pattern, ',');
    std::getline(words, value.Function, ',');
    std::getline(words, value.Correction, ',');
    char comma = ' ';
    if (words >> value.Distance >> comma >> value.Value)
    {
      values.push_back(value);
    }
  }
  return values;
}

}

#endif
