// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLeafyTreeSource.h"

#include "Data/PlantBlocks.h"
#include "Numerics/InvalidInput.h"

#include "Numerics/ParameterCheck.h"

//----------------------------------------------------------------------------
vtkLeafyTreeSource::vtkLeafyTreeSource(
  double variation, double trunkRadius, int leaves, double leafSize, double leafWidth)
  : Variation(variation)
  , TrunkRadius(trunkRadius)
  , BarkColor{ 0.41, 0.35, 0.27 }
  , NumberOfLeaves(leaves)
  , LeafSize(leafSize)
  , LeafWidth(leafWidth)
  , LeafForm(Spray)
  , LeafColor{ 0.44, 0.57, 0.24 }
{
}

//----------------------------------------------------------------------------
vtkLeafyTreeSource::~vtkLeafyTreeSource() = default;

//----------------------------------------------------------------------------
void vtkLeafyTreeSource::TakeColors(std::array<unsigned char, 3>& leaf, std::array<unsigned char, 3>& bark)
{
  littoral::ParameterCheck check;
  check.Color("LeafColor", this->LeafColor);
  check.Color("BarkColor", this->BarkColor);
  littoral::Require(check.Reason());
  leaf = littoral::ColorOf(this->LeafColor);
  bark = littoral::ColorOf(this->BarkColor);
}

//----------------------------------------------------------------------------
void vtkLeafyTreeSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Variation: " << this->Variation << "\n";
  os << indent << "TrunkRadius: " << this->TrunkRadius << "\n";
  os << indent << "BarkColor: " << this->BarkColor[0] << " " << this->BarkColor[1] << " " << this->BarkColor[2] << "\n";
  os << indent << "NumberOfLeaves: " << this->NumberOfLeaves << "\n";
  os << indent << "LeafSize: " << this->LeafSize << "\n";
  os << indent << "LeafWidth: " << this->LeafWidth << "\n";
  os << indent << "LeafForm: " << this->LeafForm << "\n";
  os << indent << "LeafColor: " << this->LeafColor[0] << " " << this->LeafColor[1] << " " << this->LeafColor[2] << "\n";
}
