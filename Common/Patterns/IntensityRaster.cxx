// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/IntensityRaster.h"

#include "Numerics/ParameterCheck.h"
#include "Terrain/GridSamples.h"

#include <cmath>
#include <numeric>

namespace littoral
{

long long IntensityRaster::CellOf(double x, double y) const
{
  const double i = std::floor((x - this->Center[0]) / this->Spacing[0] + 0.5);
  const double j = std::floor((y - this->Center[1]) / this->Spacing[1] + 0.5);
  const bool isInside = i >= 0.0 && i < this->Count[0] && j >= 0.0 && j < this->Count[1];
  return isInside ? static_cast<long long>(j) * this->Count[0] + static_cast<long long>(i) : -1;
}

double IntensityRaster::Mean() const
{
  const std::vector<double> present = PresentValues(this->Values);
  return std::accumulate(present.begin(), present.end(), 0.0) / static_cast<double>(present.size());
}

double IntensityRaster::Highest() const
{
  return RangeOf(this->Values)[1];
}

std::string WhyInvalid(const IntensityRaster& raster)
{
  ParameterCheck check;
  check.Choice("IntensityScale", static_cast<int>(raster.Scale), { "relative", "absolute" });
  for (int axis = 0; axis < 2; ++axis)
  {
    check.Finite("Center of the intensity", raster.Center[axis], "m");
    check.Positive("Spacing of the intensity", raster.Spacing[axis], "m");
  }
  check.Require(!raster.Values.empty() &&
      raster.Values.size() == static_cast<std::size_t>(raster.Count[0]) * static_cast<std::size_t>(raster.Count[1]),
    "The intensity has not one value for each cell.");
  for (std::size_t n = 0; n < raster.Values.size() && check.IsGood(); ++n)
  {
    check.Require(std::isnan(raster.Values[n]) || raster.Values[n] >= 0.0, "Intensity of the image", raster.Values[n],
      "", "not negative");
    check.Require(std::isnan(raster.Values[n]) || IsSensible(raster.Values[n]), "Intensity of the image",
      raster.Values[n], "", "finite");
  }
  check.Require(!check.IsGood() || raster.Highest() > 0.0, "The image of the intensity is 0 everywhere.");
  return check.Reason();
}

IntensityFactor::IntensityFactor(const IntensityRaster& raster)
  : Raster(&raster)
  , Maximum(raster.Highest() / raster.Mean())
  , OverHighest(1.0 / raster.Highest())
{
}

}
