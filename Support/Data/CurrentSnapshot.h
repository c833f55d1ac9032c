// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportCurrentSnapshot_h
#define LittoralSupportCurrentSnapshot_h

// A current at one moment, as a pipeline hands it over. Private: never installed, never wrapped.

#include "Currents/FlowPrimitives.h"
#include "Currents/WaterLayer.h"

#include "vtkDataObject.h"

#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace littoral
{

/// How velocities come about between the samples of images and rectilinear grids.
enum class VelocityInterpolation
{
  Linear,
  CubicSpline, ///< see VelocitySpline
};

/// Heights that a grid knows velocities of [m].
struct GridHeights
{
  double Low = -std::numeric_limits<double>::infinity();
  double High = std::numeric_limits<double>::infinity();
  double LowStep = 0.0;  ///< between the lowest two layers of samples; 0: there are no layers
  double HighStep = 0.0; ///< between the highest two
};

/// A field of velocities on a grid, at rest outside of it.
class VelocityGrid
{
public:
  virtual ~VelocityGrid() = default;

  virtual GridHeights Heights() const = 0;

  /// Whether it is known that nothing flows up or down at a height. False is always right.
  virtual bool IsLevelAt(double height) const = 0;

  /// Velocity at a place [m/s]. Safe to call from many threads.
  virtual Vector3 Velocity(const Vector3& place) const = 0;
};

/**
 * All that flows in a data object, or in the leaves of a composite one: flow primitives, and data sets with a point
 * array of velocities. Where values are no numbers, as ocean models have on land, the water is at rest. Arrays
 * are shared with the data set; splines have coefficients of their own, three a sample.
 *
 * In a layer of water nothing flows through the bed and the surface: see FlowField for primitives. A grid that ends
 * within its last step of a wall, as ocean models do whose samples are the middles of layers, is taken to reach it: its
 * horizontal flow goes on, and its vertical one falls evenly to 0, which keeps the layer's balance. Where a wall is
 * within a grid, the vertical velocity that the grid has there is subtracted: between two walls in proportion to the
 * height, with one at all heights. What flows in through one and out through the other is so taken away without a
 * trace; only where these differ, a column of water keeps the difference, the same at all heights.
 */
class CurrentSnapshot
{
public:
  /// Takes a data object. `array` names the velocities; empty: `Velocity`, or the only array of three components. Why
  /// it cannot be taken, in words for a user; empty when it was.
  std::string Take(vtkDataObject* data, const std::string& array, const WaterLayer& layer = {},
    VelocityInterpolation interpolation = VelocityInterpolation::Linear);

  /// Velocity at a place [m/s]. Safe to call from many threads.
  Vector3 Velocity(const Vector3& place) const { return this->Flow.Velocity(place) + this->GridVelocity(place); }

  /// The same of the grids alone.
  Vector3 GridVelocity(const Vector3& place) const
  {
    Vector3 sum(0.0);
    for (const auto& grid : this->Grids)
    {
      sum += grid->Velocity(place);
    }
    return sum;
  }

  bool HasGrids() const { return !this->Grids.empty(); }

  const std::vector<FlowPrimitive>& GetPrimitives() const { return this->Primitives; }

  /// The sum of the primitives.
  const FlowField& GetFlow() const { return this->Flow; }

  /// Whether the flow is the same everywhere.
  bool IsUniform() const { return this->Grids.empty() && this->Flow.IsUniform(); }

private:
  std::vector<FlowPrimitive> Primitives;
  FlowField Flow;
  std::vector<std::shared_ptr<const VelocityGrid>> Grids;
};

}

#endif
