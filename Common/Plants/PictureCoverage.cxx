// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/PictureCoverage.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

constexpr int HalfOpaque = 128;
constexpr int MostSamples = 256; ///< along a side
constexpr double SamplesOfTexel = 2.0;

/// Texel at a coordinate from 0 to 1 of a row of texels that repeats itself.
int TexelAt(double place, int texels)
{
  return std::clamp(static_cast<int>((place - std::floor(place)) * texels), 0, texels - 1);
}

}

double CoverageOf(const TextureImage& picture, const PictureTriangle& triangle)
{
  if (picture.Texels.empty())
  {
    return 1.0;
  }
  double longest = 0.0;
  for (int corner = 0; corner < 3; ++corner)
  {
    const auto& from = triangle[corner];
    const auto& to = triangle[(corner + 1) % 3];
    longest =
      std::max({ longest, std::abs(to[0] - from[0]) * picture.Columns, std::abs(to[1] - from[1]) * picture.Rows });
  }
  // the middles of n^2 equal triangles
  const int n = static_cast<int>(std::clamp(std::ceil(SamplesOfTexel * longest), 1.0, 1.0 * MostSamples));
  int opaque = 0;
  for (int row = 0; row < n; ++row)
  {
    for (int column = 0; column < 2 * (n - row) - 1; ++column)
    {
      // an upright triangle, then one that stands on its tip
      const double third = column % 2 == 0 ? 1.0 / 3.0 : 2.0 / 3.0;
      const double a = (column / 2 + third) / n; // NOLINT(bugprone-integer-division): a pair is a step
      const double b = (row + third) / n;
      const double c = 1.0 - a - b;
      const double u = c * triangle[0][0] + a * triangle[1][0] + b * triangle[2][0];
      const double v = c * triangle[0][1] + a * triangle[1][1] + b * triangle[2][1];
      opaque += picture.At(TexelAt(u, picture.Columns), TexelAt(v, picture.Rows))[3] >= HalfOpaque ? 1 : 0;
    }
  }
  return static_cast<double>(opaque) / (static_cast<double>(n) * n);
}

}
