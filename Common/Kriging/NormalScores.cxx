// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Kriging/NormalScores.h"

#include "Numerics/Constants.h"

#include <boost/math/special_functions/erf.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace littoral
{

namespace
{

/// The score below which a part of a normal distribution lies: -sqrt(2) erfc^-1(2 p).
double NormalQuantile(double part)
{
  return -std::sqrt(2.0) * boost::math::erfc_inv(2.0 * part);
}

/// y at x on the straight lines through the points, which increase; beyond them the y of the last one.
double Interpolated(const std::vector<double>& xs, const std::vector<double>& ys, double x)
{
  if (!(x > xs.front()))
  {
    return ys.front();
  }
  if (x >= xs.back())
  {
    return ys.back();
  }
  const auto upper = static_cast<std::size_t>(std::upper_bound(xs.begin(), xs.end(), x) - xs.begin());
  const double t = (x - xs[upper - 1]) / (xs[upper] - xs[upper - 1]);
  return ys[upper - 1] + t * (ys[upper] - ys[upper - 1]);
}

}

NormalScores::NormalScores(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  const auto count = static_cast<double>(values.size());
  for (std::size_t first = 0; first < values.size();)
  {
    std::size_t end = first + 1;
    while (end < values.size() && values[end] == values[first])
    {
      ++end;
    }
    // Ranks first + 1 ... end, whose mean less a half is (first + end) / 2
    this->Values.push_back(values[first]);
    this->Scores.push_back(NormalQuantile(0.5 * static_cast<double>(first + end) / count));
    first = end;
  }
}

double NormalScores::ScoreOf(double value) const
{
  return Interpolated(this->Values, this->Scores, value);
}

double NormalScores::ValueOf(double score) const
{
  return Interpolated(this->Scores, this->Values, score);
}

}
