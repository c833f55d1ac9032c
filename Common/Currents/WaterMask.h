// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralWaterMask_h
#define LittoralWaterMask_h

#include "Currents/VelocityGrid.h"
#include "Currents/VelocitySpline.h"
#include "Numerics/Vector3.h"

#include <array>
#include <cstddef>
#include <vector>

namespace littoral
{

/// Mask of the samples of a field: water or land.
class WaterMask
{
public:
  explicit WaterMask(const SampledVelocity& samples);

  /// Memory of a mask with what Continued() returns, and of what Continued() takes besides while it works [bytes]; none
  /// where all samples are water.
  static std::array<double, 2> BytesOf(const SampledVelocity& samples);

  /// Whether all samples are water.
  bool IsOpen() const { return this->Water.empty(); }

  /// Part of water at a position along the axes, 0 to 1, linear between the samples; 0 outside of those with land.
  double ShareAt(const Vector3& position) const;

  /**
   * The samples with velocities on land that continue those of the water beside it in the same layer, over so many
   * samples that splines through them know nothing of what is beyond: each is the mean of its neighbours that are
   * known.
   */
  std::vector<Vector3> Continued(const SampledVelocity& samples) const;

private:
  std::array<std::vector<double>, 3> Nodes;
  std::vector<unsigned char> Water; ///< 1 for water, 0 for land
};

}

#endif
