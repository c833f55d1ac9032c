// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralCurrentSnapshot_h
#define LittoralCurrentSnapshot_h

#include "Currents/FlowPrimitives.h"
#include "Currents/VelocityGrid.h"
#include "Currents/WaterLayer.h"

#include <memory>
#include <vector>

namespace littoral
{

/// A current at one moment: the sum of flow primitives (FlowField) and of velocity grids (in a layer of water,
/// WalledVelocity).
class CurrentSnapshot
{
public:
  CurrentSnapshot() = default;
  CurrentSnapshot(std::vector<FlowPrimitive> primitives, std::vector<std::shared_ptr<const VelocityGrid>> grids,
    const WaterLayer& layer = {});

  /// Velocity at a position [m/s]. Safe to call from many threads.
  Vector3 Velocity(const Vector3& position) const
  {
    return this->Flow.Velocity(position) + this->GridVelocity(position);
  }

  /// Velocity of the grids alone [m/s].
  Vector3 GridVelocity(const Vector3& position) const
  {
    Vector3 sum(0.0);
    for (const auto& grid : this->Grids)
    {
      sum += grid->Velocity(position);
    }
    return sum;
  }

  bool HasGrids() const { return !this->Grids.empty(); }

  const std::vector<FlowPrimitive>& GetPrimitives() const { return this->Primitives; }

  /// The sum of the primitives.
  const FlowField& GetFlow() const { return this->Flow; }

  /// Whether the velocity is the same everywhere.
  bool IsUniform() const { return this->Grids.empty() && this->Flow.IsUniform(); }

private:
  std::vector<FlowPrimitive> Primitives;
  FlowField Flow;
  std::vector<std::shared_ptr<const VelocityGrid>> Grids;
};

}

#endif
