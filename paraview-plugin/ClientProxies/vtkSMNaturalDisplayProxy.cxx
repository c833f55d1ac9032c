// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMNaturalDisplayProxy.h"

#include "NaturalDisplay.h"
#include "Scene.h"

#include "vtkObjectFactory.h"
#include "vtkPVXMLElement.h"
#include "vtkSMProperty.h"
#include "vtkSmartPointer.h"

#include <cstring>
#include <map>
#include <string>

vtkStandardNewMacro(vtkSMNaturalDisplayProxy);

namespace
{

bool IsCalled(vtkPVXMLElement* element, const char* name)
{
  return element->GetName() && std::strcmp(element->GetName(), name) == 0;
}

/// The places of the properties of a proxy's groups, from 1.
std::map<std::string, int> PlacesOf(vtkPVXMLElement* proxy)
{
  std::map<std::string, int> places;
  for (unsigned int k = 0; k < proxy->GetNumberOfNestedElements(); ++k)
  {
    vtkPVXMLElement* group = proxy->GetNestedElement(k);
    for (unsigned int n = 0; IsCalled(group, "PropertyGroup") && n < group->GetNumberOfNestedElements(); ++n)
    {
      const char* name = group->GetNestedElement(n)->GetAttribute("name");
      places.emplace(name ? name : "", static_cast<int>(places.size()) + 1);
    }
  }
  return places;
}

/// The defaults that a scene has for its source, by the name of the property.
std::map<std::string, std::string> DefaultsOf(vtkPVXMLElement* scene)
{
  std::map<std::string, std::string> defaults;
  for (unsigned int k = 0; scene && k < scene->GetNumberOfNestedElements(); ++k)
  {
    vtkPVXMLElement* one = scene->GetNestedElement(k);
    if (IsCalled(one, "Set"))
    {
      defaults[one->GetAttribute("property")] = one->GetAttribute("values");
    }
  }
  return defaults;
}

/// A definition with other default values.
vtkSmartPointer<vtkPVXMLElement> WithDefault(vtkPVXMLElement* property, const std::string& values)
{
  auto copy = vtkSmartPointer<vtkPVXMLElement>::New();
  copy->SetName(property->GetName());
  property->CopyAttributesTo(copy);
  copy->SetAttribute("default_values", values.c_str());
  for (unsigned int k = 0; k < property->GetNumberOfNestedElements(); ++k)
  {
    copy->AddNestedElement(property->GetNestedElement(k), 0); // which stays the child of its parent
  }
  return copy;
}

/// A definition with what has no group first, then the properties in the order of their groups, then the groups; a
/// scene has defaults of its own.
vtkSmartPointer<vtkPVXMLElement> InOrderOfGroups(vtkPVXMLElement* proxy)
{
  const std::map<std::string, int> places = PlacesOf(proxy);
  std::multimap<int, vtkPVXMLElement*> ordered; // equal keys stay in order
  for (unsigned int k = 0; k < proxy->GetNumberOfNestedElements(); ++k)
  {
    vtkPVXMLElement* one = proxy->GetNestedElement(k);
    const char* name = one->GetAttribute("name");
    const auto place = places.find(name ? name : "");
    const int last = static_cast<int>(places.size()) + 1;
    ordered.emplace(IsCalled(one, "PropertyGroup") ? last : place == places.end() ? 0 : place->second, one);
  }
  const std::map<std::string, std::string> defaults = DefaultsOf(proxy->FindNestedElementByName("Scene"));
  auto copy = vtkSmartPointer<vtkPVXMLElement>::New();
  copy->SetName(proxy->GetName());
  proxy->CopyAttributesTo(copy);
  for (const auto& [place, one] : ordered)
  {
    const char* name = one->GetAttribute("name");
    const auto own = defaults.find(name ? name : "");
    copy->AddNestedElement(own == defaults.end() ? one : WithDefault(one, own->second).Get(), 0);
  }
  return copy;
}

}

//----------------------------------------------------------------------------
vtkSMNaturalDisplayProxy::vtkSMNaturalDisplayProxy()
  : Display(new littoral::NaturalDisplay(this))
{
}

//----------------------------------------------------------------------------
vtkSMNaturalDisplayProxy::~vtkSMNaturalDisplayProxy() = default;

//----------------------------------------------------------------------------
int vtkSMNaturalDisplayProxy::CreateSubProxiesAndProperties(vtkSMSessionProxyManager* manager, vtkPVXMLElement* element)
{
  const int done =
    this->Superclass::CreateSubProxiesAndProperties(manager, element ? InOrderOfGroups(element).Get() : nullptr);
  if (vtkPVXMLElement* scene = element ? element->FindNestedElementByName("Scene") : nullptr)
  {
    this->Scene = scene;
    this->Display->SetScene(scene);
  }
  return done;
}

//----------------------------------------------------------------------------
void vtkSMNaturalDisplayProxy::CreateVTKObjects()
{
  this->Superclass::CreateVTKObjects();
  // Defaults are taken as known to the server.
  for (unsigned int k = 0; this->Scene && this->ObjectsCreated && k < this->Scene->GetNumberOfNestedElements(); ++k)
  {
    const char* name = this->Scene->GetNestedElement(k)->GetAttribute("property");
    if (vtkSMProperty* property = name ? this->GetProperty(name) : nullptr)
    {
      property->Modified();
    }
  }
}

//----------------------------------------------------------------------------
void vtkSMNaturalDisplayProxy::UpdateVTKObjects()
{
  this->Superclass::UpdateVTKObjects();
  this->Display->Watch();
}

//----------------------------------------------------------------------------
void vtkSMNaturalDisplayProxy::LoadState(const vtkSMMessage* message, vtkSMProxyLocator* locator)
{
  this->Superclass::LoadState(message, locator);
  this->Display->TakeBack();
}

//----------------------------------------------------------------------------
void vtkSMNaturalDisplayProxy::SetLook(vtkPVXMLElement* look)
{
  this->Display->SetLook(look);
}

//----------------------------------------------------------------------------
void vtkSMNaturalDisplayProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
