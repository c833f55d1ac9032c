// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Currents/CurrentSnapshot.h"

#include "Currents/WalledVelocity.h"

#include <utility>

namespace littoral
{

CurrentSnapshot::CurrentSnapshot(std::vector<FlowPrimitive> primitives,
  std::vector<std::shared_ptr<const VelocityGrid>> grids, const WaterLayer& layer)
  : Primitives(std::move(primitives))
  , Flow(this->Primitives, layer)
  , Grids(std::move(grids))
{
  for (std::shared_ptr<const VelocityGrid>& grid : this->Grids)
  {
    if (layer.HasWalls())
    {
      grid = std::make_shared<WalledVelocity>(grid, layer);
    }
  }
}

}
