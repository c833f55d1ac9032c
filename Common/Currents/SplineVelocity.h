// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSplineVelocity_h
#define LittoralSplineVelocity_h

#include "Currents/VelocityGrid.h"
#include "Currents/VelocitySpline.h"
#include "Currents/WaterMask.h"
#include "Numerics/Parallel.h"

#include <memory>

namespace littoral
{

/// Samples of a velocity field interpolated by cubic splines (VelocitySpline). In the cells of a coast what the water
/// beside it would have is multiplied by the part of water, linear between the samples.
class SplineVelocity : public VelocityGrid
{
public:
  /// Samples for which CanBe is true.
  explicit SplineVelocity(std::shared_ptr<const SampledVelocity> samples, const ParallelFor& parallel = SerialFor);

  /// Memory that it takes at most while it is made on so many threads [bytes].
  static double BytesOf(const SampledVelocity& samples, int threads);

  /// Whether the samples are strictly ordered along each axis.
  static bool CanBe(const SampledVelocity& samples);

  GridHeights Heights() const override { return this->Samples->Heights(); }
  bool IsLevelAt(double height) const override;
  Vector3 Velocity(const Vector3& position) const override;

private:
  std::shared_ptr<const SampledVelocity> Samples;
  WaterMask Mask;
  VelocitySpline Spline;
  bool IsLevelAnywhere; ///< as in data of horizontal velocities alone
};

}

#endif
