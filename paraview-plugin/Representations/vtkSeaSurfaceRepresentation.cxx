// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSeaSurfaceRepresentation.h"

#include "vtkSeaSurfaceFilter.h"

#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSeaSurfaceRepresentation);

//----------------------------------------------------------------------------
vtkSeaSurfaceRepresentation::vtkSeaSurfaceRepresentation()
{
  vtkNew<vtkSeaSurfaceFilter> filter;
  this->SetFilter(filter);
}

//----------------------------------------------------------------------------
vtkSeaSurfaceRepresentation::~vtkSeaSurfaceRepresentation() = default;

//----------------------------------------------------------------------------
int vtkSeaSurfaceRepresentation::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1); // clients and render servers have none
  return 1;
}

//----------------------------------------------------------------------------
void vtkSeaSurfaceRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
