// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMNaturalDisplayProxy.h"

#include "NaturalDisplay.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSMNaturalDisplayProxy);

//----------------------------------------------------------------------------
vtkSMNaturalDisplayProxy::vtkSMNaturalDisplayProxy()
  : Display(new littoral::NaturalDisplay(this))
{
}

//----------------------------------------------------------------------------
vtkSMNaturalDisplayProxy::~vtkSMNaturalDisplayProxy() = default;

//----------------------------------------------------------------------------
void vtkSMNaturalDisplayProxy::UpdateVTKObjects()
{
  this->Superclass::UpdateVTKObjects();
  this->Display->Watch();
}

//----------------------------------------------------------------------------
void vtkSMNaturalDisplayProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
