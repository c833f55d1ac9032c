// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralTreeLevels_h
#define LittoralTreeLevels_h

#include "PlantMesh.h"
#include "ReevesTree.h"

namespace littoral
{

/// The lowest level of detail of a tree: exactly four untextured polygons, two crossed rectangles for the trunk and two
/// crossed triangles (cone) or ellipses (ellipsoid) for the crown.
PlantMesh LowTree(const ReevesTreeParameters& parameters);

}

#endif
