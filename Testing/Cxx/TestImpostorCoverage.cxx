// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// The area that an oak's crown of textured leaves covers, in full and as impostors, does not depend on the distance.
#include "ImpostorWood.h"

#include <cmath>
#include <numeric>
#include <string>

namespace
{

/// Area of the crown in a picture of about a size, in pixels of the largest one. Of small pictures, whose pixels hit
/// leaves by chance, the mean of three.
double AreaOf(Row& row, int pixels, double elevation)
{
  const int others = pixels <= 32 ? 1 : 0;
  double area = 0.0;
  for (int size = pixels - others; size <= pixels + others; ++size)
  {
    row.Resize(size);
    row.LookFrom(elevation, true);
    const std::vector<double> there = row.Covered(1);
    const double scale = row.Rows / 288.0;
    area += std::accumulate(there.begin(), there.end(), 0.0) / (scale * scale);
  }
  return area / (1 + 2 * others);
}

/// The area of the crown from near and far, in full and as impostors: that of the crown in full at its largest.
bool TestCoverage(Pair& pair)
{
  bool good = true;
  double whole = 0.0;
  for (const double scale : { 1.0, 0.5, 0.25, 0.125, 0.0625 })
  {
    double areas[2] = { 0.0, 0.0 };
    for (const double elevation : { 5.0, 45.0 })
    {
      for (Row* row : pair.Both())
      {
        row->SetShadows(false);
        areas[row == &pair.Impostors] += AreaOf(*row, static_cast<int>(256 * scale), elevation);
      }
    }
    whole = scale == 1.0 ? areas[0] : whole;
    std::cout << "Areas at a scale of " << scale << ": " << areas[0] / whole << " " << areas[1] / whole << "\n";
    good &= Check(std::abs(areas[0] / whole - 1.0) <= 0.03 && std::abs(areas[1] / whole - 1.0) <= 0.03,
      "At a scale of " + std::to_string(scale) + " the oak covers " + std::to_string(areas[0] / whole) +
        " of its area, its impostors " + std::to_string(areas[1] / whole));
  }
  return good;
}

}

int TestImpostorCoverage(int, char*[])
{
  vtkNew<vtkReevesTreeSource> oak;
  Pair pair(oak);
  return TestCoverage(pair) ? EXIT_SUCCESS : EXIT_FAILURE;
}
