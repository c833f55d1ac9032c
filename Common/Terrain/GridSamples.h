// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralGridSamples_h
#define LittoralGridSamples_h

#include "Numerics/Parallel.h"

#include <array>
#include <cstddef>
#include <vector>

namespace littoral
{

/// Values measured on a regular grid of the plane, x fastest. NaN marks a missing value.
struct GridSamples
{
  int Width = 0;
  int Height = 0;
  std::array<double, 2> Spacing{ 1.0, 1.0 }; ///< [m]
  std::vector<double> Values;

  double& At(int i, int j) { return this->Values[static_cast<std::size_t>(j) * this->Width + i]; }
  double At(int i, int j) const { return this->Values[static_cast<std::size_t>(j) * this->Width + i]; }
};

/// A copy, which polls: memory that is used for the first time takes long.
GridSamples CopyOf(const GridSamples& samples, const Poll& poll);

/// The values that are not missing, in their order.
std::vector<double> PresentValues(const std::vector<double>& values);

/// Least and greatest of the values that are not missing; NaN without any.
std::array<double, 2> RangeOf(const std::vector<double>& values);

/// Fills missing values smoothly: cells of 2 x 2, 4 x 4, ... have the mean of what is there, and a missing value is
/// taken from between those of the finest cells that have one. Without any value nothing is filled.
void FillHoles(GridSamples& samples, const Poll& poll = NoPoll);

/// Count, mean and variance of the values that are not missing.
struct SampleMoments
{
  std::size_t Count = 0;
  double Mean = 0.0;
  double Variance = 0.0;
};
SampleMoments Moments(const GridSamples& samples, const Poll& poll = NoPoll);

/// A plane through the middle of the grid.
struct PlaneTrend
{
  double Mean = 0.0;                       ///< height at the grid's center
  std::array<double, 2> Slope{ 0.0, 0.0 }; ///< change per metre along x and y
};

/// Fits a plane by least squares to the values that are there, and subtracts it. A direction along which fewer than
/// two distinct positions have values gets no slope.
PlaneTrend RemovePlane(GridSamples& samples, const Poll& poll = NoPoll);

/// Subtracts the mean alone.
PlaneTrend RemoveMean(GridSamples& samples, const Poll& poll = NoPoll);

/// Adds a plane.
void AddPlane(GridSamples& samples, const PlaneTrend& plane, const ParallelFor& parallel = SerialFor);

}

#endif
