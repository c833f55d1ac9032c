// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkReevesTreeSource.h"

#include "Numerics/InvalidInput.h"
#include "Numerics/ParameterTraits.h"
#include "Plants/PlantLevels.h"
#include "Plants/ReevesTree.h"

#include "vtkObjectFactory.h"

#include <string>

vtkStandardNewMacro(vtkReevesTreeSource);

//----------------------------------------------------------------------------
vtkReevesTreeSource::vtkReevesTreeSource()
  : vtkLeafyTreeSource(0.2, 0.3, 10000, 0.32, 0.7)
  , Preset(Oak)
  , SpeciesHeight(0.0)
  , SpeciesDiameter(0.0)
  , SpeciesCrown(0.0)
  , CrownShape(Ellipsoid)
  , Height(12.0)
  , CrownRadius(5.4)
  , CrownBase(2.2)
  , TrunkReach(0.65)
  , Orders(3)
  , MainBranches(22)
  , SideBranches(6)
  , BranchAngle(62.0)
  , Lift(0.08)
{
}

//----------------------------------------------------------------------------
vtkReevesTreeSource::~vtkReevesTreeSource() = default;

//----------------------------------------------------------------------------
littoral::PlantPrototype vtkReevesTreeSource::Grow(const littoral::PlantLevelOptions& options)
{
  const auto isZeroOr = [](double value, double low, double high) {
    return value == 0.0 || littoral::ValueInterval::From(low, high).Contains(value);
  };
  littoral::ParameterCheck check;
  check.Choice("Preset", this->Preset, littoral::NumberOfTreePresets);
  check.Require(
    isZeroOr(this->SpeciesHeight, 0.05, 150.0), "SpeciesHeight", this->SpeciesHeight, "m", "from 0.05 to 150 m, or 0");
  check.Require(isZeroOr(this->SpeciesDiameter, 0.002, 20.0), "SpeciesDiameter", this->SpeciesDiameter, "m",
    "from 0.002 to 20 m, or 0");
  check.Require(
    isZeroOr(this->SpeciesCrown, 0.02, 200.0), "SpeciesCrown", this->SpeciesCrown, "m", "from 0.02 to 200 m, or 0");
  littoral::Require(check.Reason());
  littoral::ReevesTreeParameters p = littoral::SizedParameters(
    static_cast<littoral::TreePreset>(this->Preset), this->SpeciesHeight, this->SpeciesDiameter, this->SpeciesCrown);
  if (this->Preset == Custom)
  {
    p.Shape = static_cast<littoral::CrownShape>(this->CrownShape);
    p.Form = static_cast<littoral::LeafForm>(this->LeafForm);
    p.Height = this->Height;
    p.CrownRadius = this->CrownRadius;
    p.CrownBase = this->CrownBase;
    p.TrunkRadius = this->TrunkRadius;
    p.TrunkReach = this->TrunkReach;
    p.Orders = this->Orders;
    p.MainBranches = this->MainBranches;
    p.SideBranches = this->SideBranches;
    p.BranchAngle = this->BranchAngle;
    p.Lift = this->Lift;
    p.Variation = this->Variation;
    p.NumberOfLeaves = this->NumberOfLeaves;
    p.LeafSize = this->LeafSize;
    p.LeafWidth = this->LeafWidth;
    this->TakeColors(p.Leaf, p.Bark);
  }
  p.Seed = this->Seed;
  littoral::Require(littoral::WhyInvalid(p));
  littoral::PlantPrototype prototype = littoral::LevelsOf(littoral::GrowReevesTree(p, options.OnStep), options);
  prototype.Timber = littoral::ParametersOf(
    littoral::TraitsOf(static_cast<littoral::TreePreset>(this->Preset)).Wood, 0.5 * p.Height / p.TrunkRadius);
  return prototype;
}

//----------------------------------------------------------------------------
const char* vtkReevesTreeSource::GetPresetAsString() const
{
  return littoral::NameOfRow<littoral::TreePreset>(this->Preset, littoral::NumberOfTreePresets);
}

//----------------------------------------------------------------------------
void vtkReevesTreeSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Preset: " << this->Preset << "\n";
  os << indent << "SpeciesHeight: " << this->SpeciesHeight << "\n";
  os << indent << "SpeciesDiameter: " << this->SpeciesDiameter << "\n";
  os << indent << "SpeciesCrown: " << this->SpeciesCrown << "\n";
  os << indent << "CrownShape: " << this->CrownShape << "\n";
  os << indent << "Height: " << this->Height << "\n";
  os << indent << "CrownRadius: " << this->CrownRadius << "\n";
  os << indent << "CrownBase: " << this->CrownBase << "\n";
  os << indent << "TrunkReach: " << this->TrunkReach << "\n";
  os << indent << "Orders: " << this->Orders << "\n";
  os << indent << "MainBranches: " << this->MainBranches << "\n";
  os << indent << "SideBranches: " << this->SideBranches << "\n";
  os << indent << "BranchAngle: " << this->BranchAngle << "\n";
  os << indent << "Lift: " << this->Lift << "\n";
}
