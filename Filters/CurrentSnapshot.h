// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef CurrentSnapshot_h
#define CurrentSnapshot_h

// A current at one moment, as a pipeline hands it over. Private: never installed, never wrapped.

#include "FlowPrimitives.h"

#include "vtkDataObject.h"

#include <memory>
#include <string>
#include <vector>

namespace littoral
{

/// A field of velocities on a grid, at rest outside of it.
class VelocityGrid
{
public:
  virtual ~VelocityGrid() = default;

  /// Velocity at a place [m/s]. Safe to call from many threads.
  virtual Vector3 Velocity(const Vector3& place) const = 0;
};

/**
 * All that flows in a data object, or in the leaves of a composite one: flow primitives, and data sets with a point
 * array of velocities. Where values are no numbers, as ocean models have on land, the water is at rest. Arrays are
 * shared with the data set, not copied.
 */
class CurrentSnapshot
{
public:
  /// Takes a data object. `array` names the velocities; empty: `Velocity`, or the only array of three components. Why
  /// it cannot be taken, in words for a user; empty when it was.
  std::string Take(vtkDataObject* data, const std::string& array);

  /// Velocity at a place [m/s]. Safe to call from many threads.
  Vector3 Velocity(const Vector3& place) const { return this->Flow.Velocity(place) + this->GridVelocity(place); }

  /// The same without flow primitives.
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
