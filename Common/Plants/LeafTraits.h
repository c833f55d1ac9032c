// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralLeafTraits_h
#define LittoralLeafTraits_h

#include <string>

namespace littoral
{

/**
 * Leaves of a kind of trees.
 *
 * Leaf mass per area: pine 1 / 6.2 (Palmroth and Hari 2001), spruce 1 / 4.95 (Stenberg et al. 1999) and birch 1 / 13.55
 * (Lintunen et al. 2011), all three as in Majasalmi et al. (2013); larch 1 / 11.7 (Dirnberger et al. 2016); oak 0.080,
 * of the lowest leaves of sessile oaks (Meir et al. 2002); all others 0.0686, the mean of 85 woody species of Estonia
 * in medium light (Niinemets and Kull 1994). Wood over leaves: as in Majasalmi et al. (2013), after Stenberg et al.
 * (2003) and Jonckheere et al. (2005). Foliage: Jenkins et al. (2003), For. Sci. 49, tables 4 and 6, dry mass above
 * ground exp(b0 + b1 ln D) and the foliage's share of it exp(c0 + c1 / D), D being the diameter at breast height [cm].
 */
struct LeafTraits
{
  const char* Names;      ///< of the kind, separated by semicolons
  double MassPerArea;     ///< dry, over one side [kg/m2]
  double WoodPerLeaf;     ///< half the surface of wood over one side of the leaves
  double Biomass[2];      ///< b0, b1
  double FoliageRatio[2]; ///< c0, c1
};

/// The row of a name, in any case: of the whole name, else of its first or last word; null if there is none.
const LeafTraits* FindLeafTraits(const std::string& name);

/// The row of trees that are not listed.
const LeafTraits& HardwoodTraits();

/// Dry mass of the leaves [kg] of a tree of a diameter at breast height [m].
double FoliageMassOf(const LeafTraits& traits, double diameter);

}

#endif
