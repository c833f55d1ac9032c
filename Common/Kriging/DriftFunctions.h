// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralDriftFunctions_h
#define LittoralDriftFunctions_h

#include "Kriging/KrigingModel.h"

#include <array>
#include <cstddef>

namespace littoral
{

/// Drift functions f_m, whose sum with unknown coefficients is the mean of the field, m(x) = sum c_m f_m(x): 1, x, y,
/// x^2, x y, y^2, or 1 and an external drift. Coordinates and drift are scaled to about -1 ... 1, which no estimate
/// depends on.
class DriftFunctions
{
public:
  static constexpr std::size_t MaximumCount = 6;
  using Values = std::array<double, MaximumCount>;

  /// Functions scaled to the places with the `count` indices; null: all places.
  DriftFunctions(
    KrigingType type, const std::vector<KrigingPlace>& places, const std::size_t* indices, std::size_t count);

  std::size_t GetCount() const { return this->Count; }

  /// Values of the functions at a place; those beyond Count are 0.
  Values At(const KrigingPlace& place) const;

private:
  KrigingType Type;
  std::size_t Count;
  KrigingPlace Center;
  KrigingPlace Half; ///< half the extents, 1 where that is 0
};

/// Number of drift functions of a kind of kriging: 0, 1, 3, 6, 2.
std::size_t NumberOfDriftFunctions(KrigingType type);

}

#endif
