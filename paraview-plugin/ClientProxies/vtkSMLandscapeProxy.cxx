// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMLandscapeProxy.h"

#include "NaturalDisplay.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSMLandscapeProxy);

//----------------------------------------------------------------------------
vtkSMLandscapeProxy::vtkSMLandscapeProxy()
  : Display(new littoral::NaturalDisplay(this))
{
}

//----------------------------------------------------------------------------
vtkSMLandscapeProxy::~vtkSMLandscapeProxy() = default;

//----------------------------------------------------------------------------
void vtkSMLandscapeProxy::UpdateVTKObjects()
{
  this->Superclass::UpdateVTKObjects();
  this->Display->Watch();
}

//----------------------------------------------------------------------------
void vtkSMLandscapeProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
