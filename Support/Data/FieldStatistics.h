// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportFieldStatistics_h
#define LittoralSupportFieldStatistics_h

// Statistics of a random field, by properties or by a table of fits. Private: never installed, never wrapped.

#include "Terrain/CovarianceModels.h"

#include <array>
#include <string>

class vtkTable;

namespace littoral
{

/// A Gaussian random field with a trend.
struct FieldStatistics
{
  CovarianceParameters Field;
  double AnisotropyRatio = 1.0;
  double AnisotropyAngle = 0.0; ///< [rad]
  double Nugget = 0.0;          ///< [unit of the field squared]
  double Mean = 0.0;
  std::array<double, 2> Slope{ 0.0, 0.0 };      ///< of the trend [unit of the field per m]
  std::array<double, 2> TrendSides{ 0.0, 0.0 }; ///< [m], of the rectangle over which mean and slope are all the trend
  bool HasFittedVariance = false;               ///< from a table
};

/// Takes the first row of a table of fits, each statistic where it has its column. Throws InvalidInput.
void TakeFit(vtkTable* fits, FieldStatistics& statistics);

}

#endif
