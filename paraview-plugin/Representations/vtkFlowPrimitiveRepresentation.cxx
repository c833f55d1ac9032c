// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFlowPrimitiveRepresentation.h"

#include "vtkFlowArrowFilter.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkFlowPrimitiveRepresentation);

//----------------------------------------------------------------------------
vtkFlowPrimitiveRepresentation::vtkFlowPrimitiveRepresentation()
{
  vtkNew<vtkFlowArrowFilter> filter;
  this->SetFilter(filter);
}

//----------------------------------------------------------------------------
vtkFlowPrimitiveRepresentation::~vtkFlowPrimitiveRepresentation() = default;

//----------------------------------------------------------------------------
void vtkFlowPrimitiveRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
