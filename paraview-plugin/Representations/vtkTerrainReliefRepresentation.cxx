// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainReliefRepresentation.h"

#include "vtkLandscapePass.h"
#include "vtkTerrainLevelOfDetailFilter.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODActor.h"

vtkStandardNewMacro(vtkTerrainReliefRepresentation);

//----------------------------------------------------------------------------
vtkTerrainReliefRepresentation::vtkTerrainReliefRepresentation()
{
  vtkNew<vtkTerrainLevelOfDetailFilter> filter;
  filter->SetNumberOfLevels(1); // all samples, wherever the camera is
  filter->UseCullingOff();
  this->SetFilter(filter);
  vtkLandscapePass::SetMaterial(this->Actor, vtkLandscapePass::Ground);
}

//----------------------------------------------------------------------------
vtkTerrainReliefRepresentation::~vtkTerrainReliefRepresentation() = default;

//----------------------------------------------------------------------------
void vtkTerrainReliefRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
