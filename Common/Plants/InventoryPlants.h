// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralInventoryPlants_h
#define LittoralInventoryPlants_h

#include "Plants/StandInventory.h"

#include <string>
#include <vector>

namespace littoral
{

/// A plant that stands for those trees of a stand that are of one kind and about as thick: of their median sizes.
struct InventoryPlant
{
  std::string Kind;
  double Diameter = 0.0;      ///< at breast height [m]
  double Height = 0.0;        ///< [m]
  double CrownDiameter = 0.0; ///< [m]
};

/// The plants of a stand, in the order of the kinds in the table of species, thin ones first, and which one each tree
/// has.
struct InventoryPlants
{
  std::vector<InventoryPlant> Plants;
  std::vector<int> OfTree;
};

/**
 * Plants for the trees of a completed stand. The trees of a kind are divided by their diameters into classes of equally
 * many, at most so many classes, and no more than it takes for the thickest tree to be 1.3^classes times as thick as
 * the thinnest.
 */
InventoryPlants PlantsOfInventory(const StandSpeciesTable& species, const StandInventory& stand, int classes);

}

#endif
