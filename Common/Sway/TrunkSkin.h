// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralTrunkSkin_h
#define LittoralTrunkSkin_h

#include "Plants/Skeleton.h"

#include <array>
#include <vector>

namespace littoral
{

/// The first branch of a skeleton, alone.
Skeleton TrunkAlone(const Skeleton& plant);

/// Joint that moves a vertex, and its weight.
struct JointHold
{
  std::array<int, 4> Joints{ 0, 0, 0, 0 };
  std::array<float, 4> Weights{ 1.0f, 0.0f, 0.0f, 0.0f };
};

/**
 * Makes anything follow a trunk as if it were its skin: the envelope of a crown sways as the trunk does (Setas et al.,
 * section 4.2). A vertex goes with the two segments whose middles are next to its height on the trunk; above the
 * highest one and below the lowest, with that one alone.
 */
class TrunkSkin
{
public:
  /// A skeleton of one branch.
  explicit TrunkSkin(const Skeleton& trunk);

  JointHold At(const Vector3& position) const;

private:
  Vector3 Foot;
  Vector3 Axis;
  std::vector<double> Middles; // of segments, along the axis [m]
};

}

#endif
