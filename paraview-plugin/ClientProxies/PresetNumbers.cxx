// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PresetNumbers.h"

#include "Plants/AonoKuniiTree.h"
#include "Plants/GardnerPlant.h"
#include "Plants/ReevesTree.h"
#include "Seaweed/SeaweedGrowth.h"

namespace littoral
{

namespace
{

std::vector<double> ValuesOf(const Color& color)
{
  return { color[0] / 255.0, color[1] / 255.0, color[2] / 255.0 };
}

template <typename Enumeration>
double NumberOf(Enumeration value)
{
  return static_cast<double>(static_cast<int>(value));
}

std::vector<PresetNumber> NumbersOf(const ReevesTreeParameters& p)
{
  return { { "CrownShape", { NumberOf(p.Shape) } }, { "Height", { p.Height } }, { "CrownRadius", { p.CrownRadius } },
    { "CrownBase", { p.CrownBase } }, { "TrunkRadius", { p.TrunkRadius } }, { "TrunkReach", { p.TrunkReach } },
    { "Orders", { NumberOf(p.Orders) } }, { "MainBranches", { NumberOf(p.MainBranches) } },
    { "SideBranches", { NumberOf(p.SideBranches) } }, { "BranchAngle", { p.BranchAngle } }, { "Lift", { p.Lift } },
    { "Variation", { p.Variation } }, { "NumberOfLeaves", { NumberOf(p.NumberOfLeaves) } },
    { "LeafSize", { p.LeafSize } }, { "LeafWidth", { p.LeafWidth } }, { "LeafForm", { NumberOf(p.Form) } },
    { "LeafColor", ValuesOf(p.Leaf) }, { "BarkColor", ValuesOf(p.Bark) } };
}

std::vector<PresetNumber> NumbersOf(const AonoKuniiParameters& p)
{
  return { { "Branching", { NumberOf(p.Form) } }, { "Iterations", { NumberOf(p.Iterations) } },
    { "LengthRatio1", { p.LengthRatio1 } }, { "LengthRatio2", { p.LengthRatio2 } }, { "Angle1", { p.Angle1 } },
    { "Angle2", { p.Angle2 } }, { "DivergenceAngle", { p.DivergenceAngle } },
    { "DivergenceAngle2", { p.DivergenceAngle2 } }, { "WidthRatio", { p.WidthRatio } },
    { "Elongation", { p.Elongation } }, { "Tropism", { p.Tropism.x, p.Tropism.y, p.Tropism.z } },
    { "Susceptibility", { p.Susceptibility } }, { "TrunkLength", { p.TrunkLength } },
    { "TrunkRadius", { p.TrunkRadius } }, { "NumberOfLeaves", { NumberOf(p.NumberOfLeaves) } },
    { "LeafSize", { p.LeafSize } }, { "LeafWidth", { p.LeafWidth } }, { "LeafForm", { NumberOf(p.Outline) } },
    { "LeafColor", ValuesOf(p.Leaf) }, { "BarkColor", ValuesOf(p.Bark) } };
}

std::vector<PresetNumber> NumbersOf(const GardnerPlantParameters& p)
{
  return { { "Height", { p.Height } }, { "CrownRadius", { p.CrownRadius } }, { "CrownBase", { p.CrownBase } },
    { "TrunkRadius", { p.TrunkRadius } }, { "NumberOfQuadrics", { NumberOf(p.NumberOfQuadrics) } },
    { "Variation", { p.Variation } }, { "Shells", { NumberOf(p.Shells) } }, { "Terms", { NumberOf(p.Texture.Terms) } },
    { "Frequency", { NumberOf(p.Texture.Frequency) } }, { "Offset", { p.Texture.Offset } },
    { "CenterThreshold", { p.Texture.CenterThreshold } }, { "SilhouetteThreshold", { p.Texture.SilhouetteThreshold } },
    { "LeafColor", ValuesOf(p.Leaf) }, { "BarkColor", ValuesOf(p.Bark) } };
}

std::vector<PresetNumber> NumbersOf(const SeaweedParameters& p)
{
  return { { "Form", { NumberOf(p.Form) } }, { "NumberOfFronds", { NumberOf(p.NumberOfFronds) } },
    { "HoldfastRadius", { p.HoldfastRadius } }, { "SpreadAngle", { p.SpreadAngle } },
    { "StipeLength", { p.StipeLength } }, { "StipeRadius", { p.StipeRadius } }, { "BladeLength", { p.BladeLength } },
    { "BladeWidth", { p.BladeWidth } }, { "BladeThickness", { p.BladeThickness } }, { "Ruffle", { p.Ruffle } },
    { "BladeSpacing", { p.BladeSpacing } }, { "FloatRadius", { p.FloatRadius } },
    { "StipeModulus", { p.StipeModulus } }, { "BladeModulus", { p.BladeModulus } },
    { "DampingRatio", { p.DampingRatio } }, { "StipeDensity", { p.StipeDensity } },
    { "BladeDensity", { p.BladeDensity } }, { "FloatDensity", { p.FloatDensity } }, { "Variation", { p.Variation } },
    { "BladeColor", ValuesOf(p.Blade) }, { "StipeColor", ValuesOf(p.Stipe) } };
}

}

std::vector<PresetNumber> PresetNumbersOf(
  const std::string& source, int preset, double height, double diameter, double crown)
{
  const auto isBelow = [preset](int count) { return preset > 0 && preset < count; };
  if (source == "vtkReevesTreeSource" && isBelow(NumberOfTreePresets))
  {
    return NumbersOf(SizedParameters(static_cast<TreePreset>(preset), height, diameter, crown));
  }
  if (source == "vtkAonoKuniiTreeSource" && isBelow(NumberOfForkPresets))
  {
    return NumbersOf(PresetParameters(static_cast<ForkPreset>(preset)));
  }
  if (source == "vtkGardnerPlantSource" && isBelow(NumberOfGardnerPresets))
  {
    return NumbersOf(PresetParameters(static_cast<GardnerPreset>(preset)));
  }
  if (source == "vtkSeaweedSource" && isBelow(NumberOfSeaweedPresets))
  {
    return NumbersOf(PresetParameters(static_cast<SeaweedPreset>(preset)));
  }
  return {};
}

}
