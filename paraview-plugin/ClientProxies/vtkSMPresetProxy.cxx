// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMPresetProxy.h"

#include "PresetNumbers.h"

#include "vtkObjectFactory.h"
#include "vtkSMPropertyHelper.h"

#include <cstddef>

vtkStandardNewMacro(vtkSMPresetProxy);

//----------------------------------------------------------------------------
vtkSMPresetProxy::vtkSMPresetProxy() = default;

//----------------------------------------------------------------------------
vtkSMPresetProxy::~vtkSMPresetProxy() = default;

//----------------------------------------------------------------------------
void vtkSMPresetProxy::UpdateVTKObjects()
{
  this->ShowPreset();
  this->Superclass::UpdateVTKObjects();
}

//----------------------------------------------------------------------------
void vtkSMPresetProxy::ShowPreset()
{
  const auto numberOf = [this](const char* name) {
    return this->GetProperty(name) ? vtkSMPropertyHelper(this, name).GetAsDouble() : 0.0;
  };
  const char* source = this->GetVTKClassName();
  const auto numbers = littoral::PresetNumbersOf(source ? source : "", static_cast<int>(numberOf("Preset")),
    numberOf("SpeciesHeight"), numberOf("SpeciesDiameter"), numberOf("SpeciesCrown"));
  for (const littoral::PresetNumber& number : numbers)
  {
    vtkSMPropertyHelper property(this, number.Property);
    for (std::size_t index = 0; index < number.Values.size(); ++index)
    {
      property.Set(static_cast<unsigned int>(index), number.Values[index]); // whole numbers too
    }
  }
}

//----------------------------------------------------------------------------
void vtkSMPresetProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
