// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sway/SwaySpecies.h"

#include "Numerics/Constants.h"
#include "Plants/PlantScatter.h"
#include "Sway/TrunkSkin.h"

#include <algorithm>

namespace littoral
{

SwayOptions SwaySettings::With(const WoodParameters& wood) const
{
  SwayOptions options = this->Options;
  options.Wood = wood;
  return options;
}

SwaySpecies MakeSpecies(const Skeleton& rest, const WoodParameters& wood, const std::vector<LeafCorners>& leaves,
  const SwaySettings& settings)
{
  SwaySpecies species;
  species.Rest = rest;
  species.Wood = wood;
  species.Leaves = leaves;
  species.LeafAreas.assign(rest.Nodes.size(), 0.0);
  for (const LeafCorners& leaf : leaves)
  {
    species.LeafAreas[leaf.Node] += leaf.Area;
  }
  species.Trunk = MeasureTrunk(rest, FedLeafAreas(rest, species.LeafAreas, settings.Options.LeafAreaRatio));
  species.TrunkRest = TrunkAlone(rest);
  const BranchBeam trunk = TrunkBeam(species.Trunk, 1.0, 0.0, settings.With(wood));
  species.SwingFrequency = trunk.Modes.front().Frequency / TwoPi;
  return species;
}

TrunkMeasures WideTrunk(const SwaySpecies& species, double girth, const SwaySettings& settings)
{
  PlantPlace wide;
  wide.WidthScale = girth;
  std::vector<double> areas = species.LeafAreas;
  std::for_each(areas.begin(), areas.end(), [girth](double& area) { area *= girth; });
  const Skeleton rest = Placed(species.Rest, wide);
  return MeasureTrunk(rest, FedLeafAreas(rest, areas, settings.Options.LeafAreaRatio));
}

bool HasModes(const SwaySpecies& species, const SwaySettings& settings)
{
  const BranchBeam trunk = TrunkBeam(species.Trunk, 1.0, 0.0, settings.With(species.Wood));
  constexpr double least = 1e-5; // its square is far above rounding, and far below what a trunk has
  return trunk.Modes.front().Frequency > least * trunk.Modes.back().Frequency;
}

}
