// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSeaweedSource.h"

#include "Data/PlantBlocks.h"
#include "Numerics/InvalidInput.h"
#include "Numerics/ParameterTraits.h"
#include "Seaweed/SeaweedMesh.h"

#include "vtkObjectFactory.h"

#include <string>

vtkStandardNewMacro(vtkSeaweedSource);

//----------------------------------------------------------------------------
vtkSeaweedSource::vtkSeaweedSource()
  : Preset(SugarKelp)
  , SegmentsPerBranch(10)
  , Form(Tuft)
  , NumberOfFronds(7)
  , HoldfastRadius(0.07)
  , SpreadAngle(22.0)
  , StipeLength(0.3)
  , StipeRadius(0.006)
  , BladeLength(1.7)
  , BladeWidth(0.2)
  , BladeThickness(0.002)
  , Ruffle(0.3)
  , BladeSpacing(0.35)
  , FloatRadius(0.018)
  , StipeModulus(3e7)
  , BladeModulus(4e6)
  , DampingRatio(0.05)
  , StipeDensity(1020.0)
  , BladeDensity(1005.0)
  , FloatDensity(300.0)
  , Variation(0.18)
  , BladeColor{ 0.745, 0.533, 0.188 }
  , StipeColor{ 0.502, 0.353, 0.157 }
{
}

//----------------------------------------------------------------------------
vtkSeaweedSource::~vtkSeaweedSource() = default;

//----------------------------------------------------------------------------
littoral::PlantPrototype vtkSeaweedSource::Grow(const littoral::PlantLevelOptions& options)
{
  littoral::Require(littoral::WhyNoRow("Preset", this->Preset, littoral::NumberOfSeaweedPresets));
  littoral::SeaweedParameters p = littoral::PresetParameters(static_cast<littoral::SeaweedPreset>(this->Preset));
  if (this->Preset == Custom)
  {
    p.Form = static_cast<littoral::SeaweedForm>(this->Form);
    p.NumberOfFronds = this->NumberOfFronds;
    p.HoldfastRadius = this->HoldfastRadius;
    p.SpreadAngle = this->SpreadAngle;
    p.StipeLength = this->StipeLength;
    p.StipeRadius = this->StipeRadius;
    p.BladeLength = this->BladeLength;
    p.BladeWidth = this->BladeWidth;
    p.BladeThickness = this->BladeThickness;
    p.Ruffle = this->Ruffle;
    p.BladeSpacing = this->BladeSpacing;
    p.FloatRadius = this->FloatRadius;
    p.StipeModulus = this->StipeModulus;
    p.BladeModulus = this->BladeModulus;
    p.DampingRatio = this->DampingRatio;
    p.StipeDensity = this->StipeDensity;
    p.BladeDensity = this->BladeDensity;
    p.FloatDensity = this->FloatDensity;
    p.Variation = this->Variation;
    littoral::ParameterCheck colors;
    colors.Color("BladeColor", this->BladeColor);
    colors.Color("StipeColor", this->StipeColor);
    littoral::Require(colors.Reason());
    p.Blade = littoral::ColorOf(this->BladeColor);
    p.Stipe = littoral::ColorOf(this->StipeColor);
  }
  p.SegmentsPerBranch = this->SegmentsPerBranch;
  p.Seed = this->Seed;
  littoral::Require(littoral::WhyInvalid(p));
  return littoral::LevelsOf(littoral::GrowSeaweed(p), options);
}

//----------------------------------------------------------------------------
const char* vtkSeaweedSource::GetPresetAsString() const
{
  return littoral::NameOfRow<littoral::SeaweedPreset>(this->Preset, littoral::NumberOfSeaweedPresets);
}

//----------------------------------------------------------------------------
void vtkSeaweedSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Preset: " << this->Preset << "\n";
  os << indent << "SegmentsPerBranch: " << this->SegmentsPerBranch << "\n";
  os << indent << "Form: " << this->Form << "\n";
  os << indent << "NumberOfFronds: " << this->NumberOfFronds << "\n";
  os << indent << "HoldfastRadius: " << this->HoldfastRadius << "\n";
  os << indent << "SpreadAngle: " << this->SpreadAngle << "\n";
  os << indent << "StipeLength: " << this->StipeLength << "\n";
  os << indent << "StipeRadius: " << this->StipeRadius << "\n";
  os << indent << "BladeLength: " << this->BladeLength << "\n";
  os << indent << "BladeWidth: " << this->BladeWidth << "\n";
  os << indent << "BladeThickness: " << this->BladeThickness << "\n";
  os << indent << "Ruffle: " << this->Ruffle << "\n";
  os << indent << "BladeSpacing: " << this->BladeSpacing << "\n";
  os << indent << "FloatRadius: " << this->FloatRadius << "\n";
  os << indent << "StipeModulus: " << this->StipeModulus << "\n";
  os << indent << "BladeModulus: " << this->BladeModulus << "\n";
  os << indent << "DampingRatio: " << this->DampingRatio << "\n";
  os << indent << "StipeDensity: " << this->StipeDensity << "\n";
  os << indent << "BladeDensity: " << this->BladeDensity << "\n";
  os << indent << "FloatDensity: " << this->FloatDensity << "\n";
  os << indent << "Variation: " << this->Variation << "\n";
  os << indent << "BladeColor: " << this->BladeColor[0] << " " << this->BladeColor[1] << " " << this->BladeColor[2]
     << "\n";
  os << indent << "StipeColor: " << this->StipeColor[0] << " " << this->StipeColor[1] << " " << this->StipeColor[2]
     << "\n";
}
