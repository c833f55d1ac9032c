// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMChartDisplayProxy.h"

#include "ChartDisplay.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSMChartDisplayProxy);

//----------------------------------------------------------------------------
vtkSMChartDisplayProxy::vtkSMChartDisplayProxy()
  : Display(new littoral::ChartDisplay(this))
{
}

//----------------------------------------------------------------------------
vtkSMChartDisplayProxy::~vtkSMChartDisplayProxy() = default;

//----------------------------------------------------------------------------
void vtkSMChartDisplayProxy::UpdateVTKObjects()
{
  this->Superclass::UpdateVTKObjects();
  this->Display->Watch();
}

//----------------------------------------------------------------------------
void vtkSMChartDisplayProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
