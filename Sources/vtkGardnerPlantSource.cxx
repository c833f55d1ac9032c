// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGardnerPlantSource.h"

#include "Data/PlantBlocks.h"
#include "Numerics/InvalidInput.h"
#include "Numerics/ParameterTraits.h"
#include "Plants/GardnerPlant.h"

#include "vtkObjectFactory.h"

#include <string>

vtkStandardNewMacro(vtkGardnerPlantSource);

//----------------------------------------------------------------------------
vtkGardnerPlantSource::vtkGardnerPlantSource()
  : Preset(Tree)
  , Height(11.0)
  , CrownRadius(4.6)
  , CrownBase(2.0)
  , TrunkRadius(0.3)
  , NumberOfQuadrics(24)
  , Shells(3)
  , Terms(6)
  , Frequency(6)
  , Offset(1.0)
  , CenterThreshold(0.08)
  , SilhouetteThreshold(0.4)
  , Variation(0.2)
  , LeafColor{ 0.54, 0.66, 0.33 }
  , BarkColor{ 0.41, 0.35, 0.27 }
{
}

//----------------------------------------------------------------------------
vtkGardnerPlantSource::~vtkGardnerPlantSource() = default;

//----------------------------------------------------------------------------
std::array<int, 2> vtkGardnerPlantSource::LeafTextureSize() const
{
  return { littoral::GardnerColumns, littoral::SectionRows + littoral::ShellRows };
}

//----------------------------------------------------------------------------
littoral::PlantPrototype vtkGardnerPlantSource::Grow(const littoral::PlantLevelOptions& options)
{
  littoral::Require(littoral::WhyNoRow("Preset", this->Preset, littoral::NumberOfGardnerPresets));
  littoral::GardnerPlantParameters p = littoral::PresetParameters(static_cast<littoral::GardnerPreset>(this->Preset));
  if (this->Preset == Custom)
  {
    p.Height = this->Height;
    p.CrownRadius = this->CrownRadius;
    p.CrownBase = this->CrownBase;
    p.TrunkRadius = this->TrunkRadius;
    p.NumberOfQuadrics = this->NumberOfQuadrics;
    p.Shells = this->Shells;
    p.Texture.Terms = this->Terms;
    p.Texture.Frequency = this->Frequency;
    p.Texture.Offset = this->Offset;
    p.Texture.CenterThreshold = this->CenterThreshold;
    p.Texture.SilhouetteThreshold = this->SilhouetteThreshold;
    p.Variation = this->Variation;
    littoral::ParameterCheck colors;
    colors.Color("LeafColor", this->LeafColor);
    colors.Color("BarkColor", this->BarkColor);
    littoral::Require(colors.Reason());
    p.Leaf = littoral::ColorOf(this->LeafColor);
    p.Bark = littoral::ColorOf(this->BarkColor);
  }
  p.Seed = this->Seed;
  littoral::Require(littoral::WhyInvalid(p));
  return littoral::LevelsOf(littoral::GrowGardnerPlant(p), options);
}

//----------------------------------------------------------------------------
const char* vtkGardnerPlantSource::GetPresetAsString() const
{
  return littoral::NameOfRow<littoral::GardnerPreset>(this->Preset, littoral::NumberOfGardnerPresets);
}

//----------------------------------------------------------------------------
void vtkGardnerPlantSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Preset: " << this->Preset << "\n";
  os << indent << "Height: " << this->Height << "\n";
  os << indent << "CrownRadius: " << this->CrownRadius << "\n";
  os << indent << "CrownBase: " << this->CrownBase << "\n";
  os << indent << "TrunkRadius: " << this->TrunkRadius << "\n";
  os << indent << "NumberOfQuadrics: " << this->NumberOfQuadrics << "\n";
  os << indent << "Shells: " << this->Shells << "\n";
  os << indent << "Terms: " << this->Terms << "\n";
  os << indent << "Frequency: " << this->Frequency << "\n";
  os << indent << "Offset: " << this->Offset << "\n";
  os << indent << "CenterThreshold: " << this->CenterThreshold << "\n";
  os << indent << "SilhouetteThreshold: " << this->SilhouetteThreshold << "\n";
  os << indent << "Variation: " << this->Variation << "\n";
  os << indent << "LeafColor: " << this->LeafColor[0] << " " << this->LeafColor[1] << " " << this->LeafColor[2] << "\n";
  os << indent << "BarkColor: " << this->BarkColor[0] << " " << this->BarkColor[1] << " " << this->BarkColor[2] << "\n";
}
