// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSiteGround_h
#define LittoralSiteGround_h

#include "Geometry/HeightGrid.h"
#include "Plants/SitePreference.h"

#include <functional>
#include <limits>
#include <optional>

namespace littoral
{

/// Ground of a terrain by its factors.
class SiteGround
{
public:
  /// Topographic wetness index at a point of the grid for a slope [rad].
  using WetnessAt = std::function<double(long long point, double slope)>;

  /// Ground with the heights of a grid; without a function its wetness is not known.
  explicit SiteGround(HeightGrid grid, WetnessAt wetness = {});

  bool HasWetness() const { return static_cast<bool>(this->Wetness); }

  /// Whether the grid reaches a place, but has no height there.
  bool IsHole(double x, double y) const;

  /// Factors at a place, the wetness of the nearest point; none where there is no height or no finite wetness.
  std::optional<GroundFactors> At(double x, double y) const;

private:
  HeightGrid Grid;
  WetnessAt Wetness;
  double Low = std::numeric_limits<double>::infinity();
  double High = -std::numeric_limits<double>::infinity();
};

}

#endif
