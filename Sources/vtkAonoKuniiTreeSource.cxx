// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAonoKuniiTreeSource.h"

#include "Numerics/InvalidInput.h"
#include "Numerics/ParameterTraits.h"
#include "Plants/AonoKuniiTree.h"
#include "Plants/PlantLevels.h"

#include "vtkObjectFactory.h"

#include <string>

vtkStandardNewMacro(vtkAonoKuniiTreeSource);

//----------------------------------------------------------------------------
vtkAonoKuniiTreeSource::vtkAonoKuniiTreeSource()
  : vtkLeafyTreeSource(0.1, 0.17, 9000, 0.25, 0.6)
  , Preset(MonopodialA)
  , Branching(Monopodial)
  , Iterations(10)
  , LengthRatio1(0.9)
  , LengthRatio2(0.6)
  , Angle1(45.0)
  , Angle2(45.0)
  , DivergenceAngle(137.5)
  , DivergenceAngle2(132.63)
  , WidthRatio(0.707)
  , Elongation(1.109)
  , Tropism{ 0.0, 0.0, -1.0 }
  , Susceptibility(0.0)
  , TrunkLength(1.75)
{
}

//----------------------------------------------------------------------------
vtkAonoKuniiTreeSource::~vtkAonoKuniiTreeSource() = default;

//----------------------------------------------------------------------------
littoral::PlantPrototype vtkAonoKuniiTreeSource::Grow(const littoral::PlantLevelOptions& options)
{
  littoral::Require(littoral::WhyNoRow("Preset", this->Preset, littoral::NumberOfForkPresets));
  littoral::AonoKuniiParameters p = littoral::PresetParameters(static_cast<littoral::ForkPreset>(this->Preset));
  if (this->Preset == Custom)
  {
    p.Form = static_cast<littoral::Branching>(this->Branching);
    p.Iterations = this->Iterations;
    p.LengthRatio1 = this->LengthRatio1;
    p.LengthRatio2 = this->LengthRatio2;
    p.Angle1 = this->Angle1;
    p.Angle2 = this->Angle2;
    p.DivergenceAngle = this->DivergenceAngle;
    p.DivergenceAngle2 = this->DivergenceAngle2;
    p.WidthRatio = this->WidthRatio;
    p.Elongation = this->Elongation;
    p.Tropism = { this->Tropism[0], this->Tropism[1], this->Tropism[2] };
    p.Susceptibility = this->Susceptibility;
    p.TrunkLength = this->TrunkLength;
    p.TrunkRadius = this->TrunkRadius;
    p.NumberOfLeaves = this->NumberOfLeaves;
    p.LeafSize = this->LeafSize;
    p.LeafWidth = this->LeafWidth;
    p.Outline = static_cast<littoral::LeafForm>(this->LeafForm);
    this->TakeColors(p.Leaf, p.Bark);
  }
  p.Variation = this->Variation;
  p.Seed = this->Seed;
  littoral::Require(littoral::WhyInvalid(p));
  return littoral::LevelsOf(littoral::GrowAonoKuniiTree(p, options.OnStep), options);
}

//----------------------------------------------------------------------------
const char* vtkAonoKuniiTreeSource::GetPresetAsString() const
{
  return littoral::NameOfRow<littoral::ForkPreset>(
    this->Preset, littoral::NumberOfForkPresets, littoral::ForkPresetName);
}

//----------------------------------------------------------------------------
void vtkAonoKuniiTreeSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Preset: " << this->Preset << "\n";
  os << indent << "Branching: " << this->Branching << "\n";
  os << indent << "Iterations: " << this->Iterations << "\n";
  os << indent << "LengthRatio1: " << this->LengthRatio1 << "\n";
  os << indent << "LengthRatio2: " << this->LengthRatio2 << "\n";
  os << indent << "Angle1: " << this->Angle1 << "\n";
  os << indent << "Angle2: " << this->Angle2 << "\n";
  os << indent << "DivergenceAngle: " << this->DivergenceAngle << "\n";
  os << indent << "DivergenceAngle2: " << this->DivergenceAngle2 << "\n";
  os << indent << "WidthRatio: " << this->WidthRatio << "\n";
  os << indent << "Elongation: " << this->Elongation << "\n";
  os << indent << "Tropism: " << this->Tropism[0] << " " << this->Tropism[1] << " " << this->Tropism[2] << "\n";
  os << indent << "Susceptibility: " << this->Susceptibility << "\n";
  os << indent << "TrunkLength: " << this->TrunkLength << "\n";
}
