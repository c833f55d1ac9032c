// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/SiteGround.h"

#include "Numerics/Constants.h"

#include <cmath>
#include <utility>

namespace littoral
{

namespace
{

constexpr double Degrees = 180.0 / Pi;

}

SiteGround::SiteGround(HeightGrid grid, WetnessAt wetness)
  : Grid(std::move(grid))
  , Wetness(std::move(wetness))
{
  const long long count = static_cast<long long>(this->Grid.Count[0]) * this->Grid.Count[1];
  for (long long point = 0; point < count; ++point)
  {
    const double height = this->Grid.HeightOf(point);
    this->Low = height < this->Low ? height : this->Low;
    this->High = height > this->High ? height : this->High;
  }
}

bool SiteGround::IsHole(double x, double y) const
{
  const GroundPoint point = this->Grid.At(x, y);
  return point.IsCovered && !std::isfinite(point.Height);
}

std::optional<GroundFactors> SiteGround::At(double x, double y) const
{
  const GroundPoint point = this->Grid.At(x, y);
  if (!point.IsCovered || !std::isfinite(point.Height))
  {
    return {};
  }
  const double range = this->High - this->Low;
  const double wetness = this->HasWetness() ? this->Wetness(this->Grid.Nearest(x, y), point.Slope)
                                            : std::numeric_limits<double>::quiet_NaN();
  if (this->HasWetness() && !std::isfinite(wetness))
  {
    return {};
  }
  return GroundFactors{ point.Height, range > 0.0 ? (point.Height - this->Low) / range : 0.5, Degrees * point.Slope,
    AspectOf(point), wetness };
}

}
