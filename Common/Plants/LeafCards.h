// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralLeafCards_h
#define LittoralLeafCards_h

#include "Geometry/TextureImage.h"
#include "Numerics/Parallel.h"
#include "Plants/Plant.h"

namespace littoral
{

/// A card for each leaf: a kite in the leaf's outline, with its corners at the middles of the texture's edges and its
/// foot at v = 0. All of a card follows the joint of the node that carries the leaf.
PlantMesh LeafCards(const Plant& plant, const Poll& poll = NoPoll);

/// Columns and rows of the picture on a leaf.
inline constexpr int LeafPictureSize = 64;

/// Picture on the kites: a leaf with veins or a tuft of needles, grey where it is, transparent where it is not.
TextureImage LeafPicture(LeafForm form);

}

#endif
