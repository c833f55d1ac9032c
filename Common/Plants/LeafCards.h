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
/// foot at v = 0. All of a card follows the joint of the node that carries the leaf. Its normals are those of a blade
/// whose tip and edges hang down.
PlantMesh LeafCards(const Plant& plant, const Poll& poll = NoPoll);

/// Columns and rows of the picture on a leaf.
inline constexpr int LeafPictureSize = 128;

/// Picture on the kites: a leaf with veins, a tuft of needles or a twig with leaves, grey where it is, transparent
/// where it is not. Means of a spray, as of mip levels, are opaque: it has gaps for who is near.
TextureImage LeafPicture(LeafForm form);

}

#endif
