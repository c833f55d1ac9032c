// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralWalledVelocity_h
#define LittoralWalledVelocity_h

#include "Currents/VelocityGrid.h"
#include "Currents/WaterLayer.h"

#include <memory>

namespace littoral
{

/**
 * A velocity grid in a layer of water: nothing flows through the bed and the surface.
 *
 * A grid that ends within its last step of a wall, as ocean models do whose samples are the middles of layers, is taken
 * to reach it: its horizontal flow goes on, and its vertical one falls evenly to 0, which keeps the layer's balance.
 * Where a wall is within a grid, the vertical velocity that the grid has there is subtracted: between two walls in
 * proportion to the height, with one at all heights. What flows in through one and out through the other is so taken
 * away without a trace; only where these differ, a column of water keeps the difference, the same at all heights.
 */
class WalledVelocity : public VelocityGrid
{
public:
  WalledVelocity(std::shared_ptr<const VelocityGrid> grid, const WaterLayer& layer);

  GridHeights Heights() const override { return this->Range; }
  bool IsLevelAt(double height) const override { return this->Grid->IsLevelAt(height); }
  Vector3 Velocity(const Vector3& position) const override;

private:
  double WallVelocity(const Vector3& position) const;

  std::shared_ptr<const VelocityGrid> Grid;
  WaterLayer Layer;
  GridHeights Range;
  bool ReachesBed;
  bool ReachesSurface;
  bool CrossesBed;
  bool CrossesSurface;
};

}

#endif
