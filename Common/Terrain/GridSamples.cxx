// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Terrain/GridSamples.h"

#include "Numerics/PolledMemory.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace littoral
{

namespace
{

constexpr double Missing = std::numeric_limits<double>::quiet_NaN();

/// Calls visit(x, y, value) for each value that is there; x, y [m] from the grid's center.
template <typename Samples, typename Visit>
void ForEachValue(Samples& samples, const Poll& poll, Visit visit)
{
  for (int j = 0; j < samples.Height; ++j)
  {
    poll();
    const double y = (j - 0.5 * (samples.Height - 1)) * samples.Spacing[1];
    for (int i = 0; i < samples.Width; ++i)
    {
      auto& value = samples.Values[static_cast<std::size_t>(j) * samples.Width + i];
      if (!std::isnan(value))
      {
        visit((i - 0.5 * (samples.Width - 1)) * samples.Spacing[0], y, value);
      }
    }
  }
}
}

GridSamples CopyOf(const GridSamples& samples, const Poll& poll)
{
  return { samples.Width, samples.Height, samples.Spacing, CopyOf(samples.Values, poll) };
}

std::vector<double> PresentValues(const std::vector<double>& values)
{
  std::vector<double> present;
  present.reserve(values.size());
  std::copy_if(values.begin(), values.end(), std::back_inserter(present), [](double v) { return !std::isnan(v); });
  return present;
}

std::array<double, 2> RangeOf(const std::vector<double>& values)
{
  std::array<double, 2> range{ Missing, Missing };
  for (const double value : values)
  {
    range = { std::fmin(range[0], value), std::fmax(range[1], value) };
  }
  return range;
}

void FillHoles(GridSamples& samples, const Poll& poll)
{
  const auto isHole = [](double value) { return std::isnan(value); };
  if (std::none_of(samples.Values.begin(), samples.Values.end(), isHole) || (samples.Width == 1 && samples.Height == 1))
  {
    return;
  }
  GridSamples coarse;
  coarse.Width = (samples.Width + 1) / 2;
  coarse.Height = (samples.Height + 1) / 2;
  coarse.Values.assign(static_cast<std::size_t>(coarse.Width) * coarse.Height, 0.0);
  std::vector<double> counts(coarse.Values.size(), 0.0);
  for (int j = 0; j < samples.Height; ++j)
  {
    poll();
    for (int i = 0; i < samples.Width; ++i)
    {
      const double value = samples.At(i, j);
      coarse.At(i / 2, j / 2) += isHole(value) ? 0.0 : value;
      counts[static_cast<std::size_t>(j / 2) * coarse.Width + i / 2] += isHole(value) ? 0.0 : 1.0;
    }
  }
  for (std::size_t cell = 0; cell < counts.size(); ++cell)
  {
    coarse.Values[cell] = counts[cell] > 0.0 ? coarse.Values[cell] / counts[cell] : Missing;
  }
  FillHoles(coarse, poll);
  for (int j = 0; j < samples.Height; ++j)
  {
    poll();
    for (int i = 0; i < samples.Width; ++i)
    {
      if (isHole(samples.At(i, j)))
      {
        // bilinear: 9/16, 3/16, 3/16, 1/16 of the coarse cells about
        const int x = std::clamp(i / 2 + (i % 2 == 0 ? -1 : 1), 0, coarse.Width - 1);
        const int y = std::clamp(j / 2 + (j % 2 == 0 ? -1 : 1), 0, coarse.Height - 1);
        samples.At(i, j) =
          (9.0 * coarse.At(i / 2, j / 2) + 3.0 * (coarse.At(x, j / 2) + coarse.At(i / 2, y)) + coarse.At(x, y)) / 16.0;
      }
    }
  }
}

SampleMoments Moments(const GridSamples& samples, const Poll& poll)
{
  SampleMoments moments;
  double sum = 0.0;
  ForEachValue(samples, poll, [&](double, double, double value) {
    ++moments.Count;
    sum += value;
  });
  if (moments.Count == 0)
  {
    return moments;
  }
  moments.Mean = sum / static_cast<double>(moments.Count);
  double squares = 0.0;
  ForEachValue(
    samples, poll, [&](double, double, double value) { squares += (value - moments.Mean) * (value - moments.Mean); });
  moments.Variance = squares / static_cast<double>(moments.Count);
  return moments;
}

PlaneTrend RemoveMean(GridSamples& samples, const Poll& poll)
{
  PlaneTrend trend;
  trend.Mean = Moments(samples, poll).Mean;
  ForEachValue(samples, poll, [&](double, double, double& value) { value -= trend.Mean; });
  return trend;
}

PlaneTrend RemovePlane(GridSamples& samples, const Poll& poll)
{
  // Positions in units of the grid's size, so that the normal equations are well scaled.
  const double scaleX = samples.Width * samples.Spacing[0];
  const double scaleY = samples.Height * samples.Spacing[1];
  PlaneTrend trend = RemoveMean(samples, poll);
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (int j = 0; j < samples.Height; ++j)
  {
    poll();
    // Sums of 1, x, x^2 and of z, x z of a row, along which y is one.
    double count = 0.0;
    double x1 = 0.0;
    double x2 = 0.0;
    double z1 = 0.0;
    double xz = 0.0;
    for (int i = 0; i < samples.Width; ++i)
    {
      const double value = samples.At(i, j);
      const double there = std::isnan(value) ? 0.0 : 1.0;
      const double z = std::isnan(value) ? 0.0 : value;
      const double x = (i - 0.5 * (samples.Width - 1)) * samples.Spacing[0] / scaleX;
      count += there;
      x1 += there * x;
      x2 += there * x * x;
      z1 += z;
      xz += z * x;
    }
    const double y = (j - 0.5 * (samples.Height - 1)) * samples.Spacing[1] / scaleY;
    Eigen::Matrix3d row;
    row << count, x1, count * y, //
      x1, x2, x1 * y,            //
      count * y, x1 * y, count * y * y;
    normal += row;
    right += Eigen::Vector3d(z1, xz, z1 * y);
  }
  // Of any size: in a decomposition of fixed size GCC 16 takes Eigen 5's loads of two values for reads past the end.
  const Eigen::MatrixXd system = normal;
  const Eigen::VectorXd plane = system.completeOrthogonalDecomposition().solve(Eigen::VectorXd(right));
  trend.Mean += plane[0];
  trend.Slope = { plane[1] / scaleX, plane[2] / scaleY };
  ForEachValue(samples, poll,
    [&](double x, double y, double& value) { value -= plane[0] + trend.Slope[0] * x + trend.Slope[1] * y; });
  return trend;
}

void AddPlane(GridSamples& samples, const PlaneTrend& plane, const ParallelFor& parallel)
{
  parallel(samples.Height, [&](std::size_t begin, std::size_t end) {
    for (int j = static_cast<int>(begin); j < static_cast<int>(end); ++j)
    {
      const double y = (j - 0.5 * (samples.Height - 1)) * samples.Spacing[1];
      for (int i = 0; i < samples.Width; ++i)
      {
        const double x = (i - 0.5 * (samples.Width - 1)) * samples.Spacing[0];
        samples.At(i, j) += plane.Mean + plane.Slope[0] * x + plane.Slope[1] * y;
      }
    }
  });
}

}
