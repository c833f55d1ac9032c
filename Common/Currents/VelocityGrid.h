// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralVelocityGrid_h
#define LittoralVelocityGrid_h

#include "Numerics/Vector3.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace littoral
{

/// Range of heights in which a grid has velocities [m].
struct GridHeights
{
  double Low = -std::numeric_limits<double>::infinity();
  double High = std::numeric_limits<double>::infinity();
  double LowStep = 0.0;  ///< between the lowest two layers of samples; 0: there are no layers
  double HighStep = 0.0; ///< between the highest two
};

/// A velocity field on a grid of any kind, at rest outside of it.
class VelocityGrid
{
public:
  virtual ~VelocityGrid() = default;

  virtual GridHeights Heights() const = 0;

  /// Whether it is known that the vertical velocity is 0 at a height. False is always right.
  virtual bool IsLevelAt(double height) const = 0;

  /// Velocity at a position [m/s]. Safe to call from many threads.
  virtual Vector3 Velocity(const Vector3& position) const = 0;
};

/// A velocity field by its samples along three axes.
class SampledVelocity : public VelocityGrid
{
public:
  /// Coordinates of the samples along an axis.
  virtual std::vector<double> Nodes(int axis) const = 0;

  /// Coordinates of a position along the axes.
  virtual Vector3 PositionOf(const Vector3& position) const = 0;

  /// The sample with the number i + Nodes(0).size() (j + Nodes(1).size() k).
  virtual Vector3 Sample(std::size_t id) const = 0;

  /// Whether the sample of a number is water; at rest where it is not.
  virtual bool IsWater(std::size_t id) const = 0;

  /// Whether samples are in single precision.
  virtual bool IsSingle() const = 0;
};

}

#endif
