// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralLeastSquaresLine_h
#define LittoralLeastSquaresLine_h

#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace littoral
{

/// y = Intercept + Slope x.
struct LeastSquaresLine
{
  double Slope = std::numeric_limits<double>::quiet_NaN();
  double Intercept = std::numeric_limits<double>::quiet_NaN();
};

/// Line of least squares through points with weights; NaN with fewer than two different x.
inline LeastSquaresLine LineThrough(
  const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& weights)
{
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  double meanX = 0.0;
  double meanY = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    meanX += weights[i] * x[i] / sum;
    meanY += weights[i] * y[i] / sum;
  }
  double xx = 0.0;
  double xy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    xx += weights[i] * (x[i] - meanX) * (x[i] - meanX);
    xy += weights[i] * (x[i] - meanX) * (y[i] - meanY);
  }
  LeastSquaresLine line;
  if (xx > 0.0)
  {
    line.Slope = xy / xx;
    line.Intercept = meanY - line.Slope * meanX;
  }
  return line;
}

/// The same through points of equal weight.
inline LeastSquaresLine LineThrough(const std::vector<double>& x, const std::vector<double>& y)
{
  return LineThrough(x, y, std::vector<double>(x.size(), 1.0));
}

}

#endif
