// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralInventoryPlants_h
#define LittoralInventoryPlants_h

#include "Plants/StandInventory.h"

#include <string>
#include <vector>

namespace littoral
{

/// Plant of the median dimensions of a diameter class of one kind.
struct InventoryPlant
{
  std::string Kind;
  double Diameter = 0.0;      ///< at breast height [m]
  double Height = 0.0;        ///< [m]
  double CrownDiameter = 0.0; ///< [m]
};

/// Plants of a stand, by the kinds in the order of the table of species, thin ones first.
struct InventoryPlants
{
  std::vector<InventoryPlant> Plants;
  std::vector<int> OfTree; ///< index of the plant of each tree
};

/**
 * Makes plants for the trees of a completed stand. The trees of a kind are divided into at most `classes` diameter
 * classes of equally many trees, and no more than it takes for the thickest tree to be 1.3^classes times as thick as
 * the thinnest.
 */
InventoryPlants PlantsOfInventory(const StandSpeciesTable& species, const StandInventory& stand, int classes);

}

#endif
