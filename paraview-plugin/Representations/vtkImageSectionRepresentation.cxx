// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkImageSectionRepresentation.h"

#include "vtkImageSectionFilter.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkImageSectionRepresentation);

//----------------------------------------------------------------------------
vtkImageSectionRepresentation::vtkImageSectionRepresentation()
{
  vtkNew<vtkImageSectionFilter> filter;
  this->SetFilter(filter);
}

//----------------------------------------------------------------------------
vtkImageSectionRepresentation::~vtkImageSectionRepresentation() = default;

//----------------------------------------------------------------------------
void vtkImageSectionRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
