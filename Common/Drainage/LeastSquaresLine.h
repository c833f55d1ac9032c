// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralLeastSquaresLine_h
#define LittoralLeastSquaresLine_h

#include <cstddef>
#include <limits>
#include <vector>

namespace littoral
{

/// y = Intercept + Slope x.
struct LeastSquaresLine
{
  double Slope = std::numeric_limits<double>::quiet_NaN();
  double Intercept = std::numeric_limits<double>::quiet_NaN();
};

/// Line of least squares through points of equal weight; NaN with fewer than two different x.
inline LeastSquaresLine LineThrough(const std::vector<double>& x, const std::vector<double>& y)
{
  const auto count = static_cast<double>(x.size());
  double meanX = 0.0;
  double meanY = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    meanX += x[i] / count;
    meanY += y[i] / count;
  }
  double xx = 0.0;
  double xy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    xx += (x[i] - meanX) * (x[i] - meanX);
    xy += (x[i] - meanX) * (y[i] - meanY);
  }
  LeastSquaresLine line;
  if (xx > 0.0)
  {
    line.Slope = xy / xx;
    line.Intercept = meanY - line.Slope * meanX;
  }
  return line;
}

}

#endif
