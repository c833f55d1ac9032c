// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralStandPlausibility_h
#define LittoralStandPlausibility_h

#include "Plants/StandInventory.h"

#include <vector>

namespace littoral
{

/// Largest diameter [m] that a tree of a stand may have beside the others: 3 m, or four times the upper decile of all,
/// which trees of redwood groves have, and at most 12 m, near the thickest tree on record.
double LargestLikelyDiameter(std::vector<double> diameters);

/// Whether a tree can have a diameter at breast height and a height [m], of which each may be NaN: it is higher than
/// thick, and at most three times as high as a trunk that buckles under its own weight: H - 1.37 m < 3 x 95 m^(1/3)
/// D^(2/3) (McMahon 1973).
bool CanStand(double diameter, double height);

/**
 * Refuses measures that no stand has, with the units in which it would be one, and trees that cannot be among the
 * others, with their row. The whole: medians of diameters (5 mm to 2.5 m), of heights (0.3 to 90 m) and of height over
 * diameter (8 to 400), and a basal area of at most 600 m2 a hectare. A tree: at most 12 m thick, and 130 m high,
 * LargestLikelyDiameter() and CanStand(). With AllowImplausible only the largest size counts.
 */
void RequirePlausible(
  const StandInventory& stand, LengthUnit diameters, LengthUnit heights, const InventoryOptions& options);

/// Refuses a tree, or one in fifty, that stands from the others farther than 100 m and twice their extent along x or y.
void RequireNear(const StandInventory& stand);

}

#endif
