// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralOceanLevels_h
#define LittoralOceanLevels_h

// Vertical coordinates of ocean models, which follow the bed: CF conventions, appendix D; ROMS's vertical transforms.

#include <vector>

namespace littoral
{

enum class LevelKind
{
  Heights,      ///< the same heights everywhere [m]
  Sigma,        ///< shares of the water's depth, -1 at the bed, 0 at the surface
  SCoordinate1, ///< ocean_s_coordinate_g1, ROMS's Vtransform 1
  SCoordinate2, ///< ocean_s_coordinate_g2, ROMS's Vtransform 2
  SOfHaidvogel, ///< ocean_s_coordinate of Song and Haidvogel, which bends with the surface otherwise
};

/// The levels of a model.
struct OceanLevels
{
  LevelKind Kind = LevelKind::Heights;
  std::vector<double> S;          ///< of each level: its height [m], sigma or s
  std::vector<double> Stretching; ///< C(s) of each level, for s coordinates
  double CriticalDepth = 0.0;     ///< h_c [m], for s coordinates

  /// Height of a level [m] where the still water is so deep and the surface so high [m].
  double HeightOf(int level, double depth, double surface) const;
};

/// Parameters of the stretching functions C(s) of ROMS, by their numbers (Vstretching).
struct LevelStretching
{
  int Function = 4; ///< 1 Song and Haidvogel 1994, 2 Shchepetkin 2005, 3 Geyer, 4 Shchepetkin 2010, 5 Souza et al. 2015
  double Surface = 0.0; ///< theta_s
  double Bottom = 0.0;  ///< theta_b

  /// C(s) from -1 at the bed to 0 at the surface. Throws InvalidInput for a function that is unknown.
  double At(double s) const;
};

}

#endif
