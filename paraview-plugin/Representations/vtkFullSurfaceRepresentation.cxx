// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFullSurfaceRepresentation.h"

#include "vtkAlgorithm.h"
#include "vtkObjectFactory.h"
#include "vtkPVView.h"

vtkStandardNewMacro(vtkFullSurfaceRepresentation);

//----------------------------------------------------------------------------
vtkFullSurfaceRepresentation::vtkFullSurfaceRepresentation() = default;

//----------------------------------------------------------------------------
vtkFullSurfaceRepresentation::~vtkFullSurfaceRepresentation() = default;

//----------------------------------------------------------------------------
int vtkFullSurfaceRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* in, vtkInformation* out)
{
  if (request != vtkPVView::REQUEST_UPDATE_LOD())
  {
    return this->Superclass::ProcessViewRequest(request, in, out);
  }
  if (!this->GetVisibility())
  {
    return 0;
  }
  vtkPVView::SetPieceLOD(in, this, this->MultiBlockMaker->GetOutputDataObject(0));
  return 1;
}

//----------------------------------------------------------------------------
void vtkFullSurfaceRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
