// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene.h"

#include "Daylight.h"
#include "vtkSMNaturalDisplayProxy.h"

#include "vtkNew.h"
#include "vtkPVXMLElement.h"
#include "vtkSMParaViewPipelineControllerWithRendering.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxySelectionModel.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSettings.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMViewProxy.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace littoral
{
namespace
{

constexpr int FramesPerSecond = 24; // of a film

using Parts = std::map<std::string, vtkSMSourceProxy*>;

std::string Attribute(vtkPVXMLElement* element, const char* name)
{
  const char* text = element->GetAttribute(name);
  return text ? text : "";
}

bool IsCalled(vtkPVXMLElement* element, const char* name)
{
  return std::strcmp(element->GetName(), name) == 0;
}

/// The inputs of a part, in their order.
void SetInputs(vtkSMProxy* part, vtkPVXMLElement* description, const Parts& parts)
{
  for (unsigned int k = 0; k < description->GetNumberOfNestedElements(); ++k)
  {
    vtkPVXMLElement* one = description->GetNestedElement(k);
    if (IsCalled(one, "Connect"))
    {
      int port = 0;
      one->GetScalarAttribute("port", &port);
      vtkSMPropertyHelper(part, Attribute(one, "property").c_str())
        .Add(parts.at(Attribute(one, "to")), static_cast<unsigned int>(port));
    }
  }
}

/// Scales the values that are of a depth.
void ScaleDepthsOf(vtkSMProxy* part, vtkPVXMLElement* description, double ratio)
{
  for (unsigned int k = 0; k < description->GetNumberOfNestedElements(); ++k)
  {
    vtkPVXMLElement* one = description->GetNestedElement(k);
    int component = 0;
    if (one->GetScalarAttribute("of-depth", &component) != 0)
    {
      vtkSMPropertyHelper property(part, Attribute(one, "property").c_str());
      property.Set(component, ratio * property.GetAsDouble(component));
    }
  }
  part->UpdateVTKObjects();
}

/// Makes the input of a part that chooses one of its arrays, so that its panel names it.
void UpdateElevations(vtkSMSourceProxy* part)
{
  for (unsigned int k = 0; part->GetProperty("SelectInputScalars") && k < part->GetNumberOfProducers(); ++k)
  {
    vtkSMSourceProxy::SafeDownCast(part->GetProducerProxy(k))->UpdatePipeline();
  }
}

/// A registered part; null if its type is not known.
vtkSMSourceProxy* Make(vtkSMSessionProxyManager* manager, vtkPVXMLElement* description, const Parts& parts)
{
  const char* group = IsCalled(description, "Source") ? "sources" : "filters";
  const auto proxy =
    vtkSmartPointer<vtkSMProxy>::Take(manager->NewProxy(group, Attribute(description, "type").c_str()));
  auto* part = vtkSMSourceProxy::SafeDownCast(proxy);
  if (!part)
  {
    return nullptr; // of which the manager has told
  }
  vtkNew<vtkSMParaViewPipelineController> controller;
  controller->PreInitializeProxy(part);
  SetValues(part, description);
  SetInputs(part, description, parts);
  UpdateElevations(part);
  controller->PostInitializeProxy(part);
  const std::string name = manager->GetUniqueProxyName("sources", Attribute(description, "name").c_str(), false);
  controller->RegisterPipelineProxy(part, name.c_str());
  return part;
}

/// Shows the output `port` of a part, or the first one.
void Show(vtkSMSourceProxy* part, vtkPVXMLElement* look, vtkSMViewProxy* view)
{
  int port = 0;
  look->GetScalarAttribute("port", &port);
  if (auto* natural = vtkSMNaturalDisplayProxy::SafeDownCast(part))
  {
    natural->SetLook(look);
  }
  vtkNew<vtkSMParaViewPipelineControllerWithRendering> controller;
  controller->Show(part, port, view);
}

/// Shows a part whose display has values of its own.
void ShowWithValues(vtkSMSourceProxy* part, vtkPVXMLElement* values, vtkSMViewProxy* view)
{
  vtkNew<vtkSMParaViewPipelineControllerWithRendering> controller;
  if (vtkSMProxy* display = controller->Show(part, 0, view))
  {
    SetValues(display, values);
    display->UpdateVTKObjects();
  }
}

/// Frames a second of a new film, 1 by default of ParaView, unless the user has others.
void SetFrameRate(double rate)
{
  static int films = 0;
  const double priority = -1.0 / ++films; // below the user's, above the last one's: the first of equals prevails
  vtkSMSettings::GetInstance()->AddCollectionFromString(
    R"({"misc": {"SaveAnimation": {"FrameRate": )" + std::to_string(std::max(1l, std::lround(rate))) + "}}}", priority);
}

/// The numbers of a property; none if there is no such property.
std::vector<double> NumbersOf(vtkSMProxy* proxy, const char* property)
{
  return proxy->GetProperty(property) ? vtkSMPropertyHelper(proxy, property).GetDoubleArray() : std::vector<double>();
}

double LengthOf(const std::vector<double>& times)
{
  return times.empty() ? 0.0 : times.back() - times.front();
}

/// Gives a range of times without time steps the frames of a film, unless someone has chosen their number, and a film
/// of all that is open the length of its times.
void SetFrames(vtkSMSourceProxy* part)
{
  vtkNew<vtkSMParaViewPipelineController> controller;
  vtkSMProxy* animation = controller->FindAnimationScene(part->GetSession());
  vtkSMProxy* timeKeeper = controller->FindTimeKeeper(part->GetSession());
  const double range = LengthOf(NumbersOf(part, "TimeRange"));
  if (!animation || !timeKeeper || !animation->GetProperty("NumberOfFrames") ||
    !(range > 0.0 || LengthOf(NumbersOf(part, "TimestepValues")) > 0.0))
  {
    return;
  }
  vtkSMPropertyHelper frames(animation, "NumberOfFrames");
  if (range > 0.0 && animation->GetProperty("NumberOfFrames")->IsValueDefault())
  {
    frames.Set(static_cast<int>(std::lround(FramesPerSecond * range)) + 1);
    animation->UpdateVTKObjects();
  }
  // An animation of time steps has a frame at each.
  const std::vector<double> steps = NumbersOf(timeKeeper, "TimestepValues");
  const bool hasSteps = steps.size() > 1;
  const double length = LengthOf(hasSteps ? steps : NumbersOf(timeKeeper, "TimeRange"));
  if (length > 0.0)
  {
    SetFrameRate(((hasSteps ? static_cast<double>(steps.size()) : frames.GetAsDouble()) - 1.0) / length);
  }
}

}

//----------------------------------------------------------------------------
std::set<vtkSMProxy*> UpstreamOf(vtkSMProxy* filter)
{
  std::set<vtkSMProxy*> all;
  for (unsigned int k = 0; k < filter->GetNumberOfProducers(); ++k)
  {
    vtkSMProxy* producer = filter->GetProducerProxy(k);
    const std::set<vtkSMProxy*> further = UpstreamOf(producer);
    all.insert(producer);
    all.insert(further.begin(), further.end());
  }
  return all;
}

//----------------------------------------------------------------------------
void SetValues(vtkSMProxy* proxy, vtkPVXMLElement* description)
{
  for (unsigned int k = 0; k < description->GetNumberOfNestedElements(); ++k)
  {
    vtkPVXMLElement* one = description->GetNestedElement(k);
    if (IsCalled(one, "Set"))
    {
      vtkSMPropertyHelper property(proxy, Attribute(one, "property").c_str());
      std::istringstream values(Attribute(one, "values"));
      double value = 0.0;
      for (unsigned int n = 0; values >> value; ++n)
      {
        property.Set(n, value);
      }
    }
  }
}

//----------------------------------------------------------------------------
void ScaleDepths(vtkSMSourceProxy* source, vtkPVXMLElement* scene, double ratio)
{
  std::set<vtkSMProxy*> parts;
  for (unsigned int k = 0; k < source->GetNumberOfConsumers(); ++k)
  {
    if (vtkSMProxy* consumer = source->GetConsumerProxy(k))
    {
      const std::set<vtkSMProxy*> upstream = UpstreamOf(consumer);
      parts.insert(upstream.begin(), upstream.end());
    }
  }
  for (unsigned int k = 0; k < scene->GetNumberOfNestedElements(); ++k)
  {
    vtkPVXMLElement* description = scene->GetNestedElement(k);
    for (vtkSMProxy* part : parts)
    {
      if (Attribute(description, "type") == part->GetXMLName())
      {
        ScaleDepthsOf(part, description, ratio);
      }
    }
  }
}

//----------------------------------------------------------------------------
bool IsLastOfPipeline(vtkSMSourceProxy* source)
{
  for (unsigned int k = 0; k < source->GetNumberOfConsumers(); ++k)
  {
    vtkSMProxy* consumer = source->GetConsumerProxy(k); // null if it was deleted
    const char* group = consumer ? consumer->GetXMLGroup() : nullptr;
    if (group && std::strcmp(group, "filters") == 0)
    {
      return false;
    }
  }
  return true;
}

//----------------------------------------------------------------------------
void MakeScene(vtkSMSourceProxy* source, vtkPVXMLElement* scene, vtkSMViewProxy* view)
{
  Parts parts = { { source->GetXMLName(), source } };
  const bool takesLight = TakesLandscapeLight(view);
  for (unsigned int k = 0; k < scene->GetNumberOfNestedElements(); ++k)
  {
    vtkPVXMLElement* description = scene->GetNestedElement(k);
    const bool isLight = Attribute(description, "type") == "LandscapeLight";
    if (IsCalled(description, "Set") || (isLight && !takesLight)) // Set: of the source
    {
      continue;
    }
    vtkSMSourceProxy* part = Make(source->GetSessionProxyManager(), description, parts);
    if (!part)
    {
      return;
    }
    parts[Attribute(description, "name")] = part;
    if (vtkPVXMLElement* values = description->FindNestedElementByName("Display"))
    {
      ShowWithValues(part, values, view);
    }
    else if (vtkPVXMLElement* look = description->FindNestedElementByName("NaturalDisplay"))
    {
      Show(part, look, view);
      SetFrames(part);
    }
  }
  // Each part became the active source in turn.
  if (vtkSMProxySelectionModel* active = source->GetSessionProxyManager()->GetSelectionModel("ActiveSources"))
  {
    active->SetCurrentProxy(source, vtkSMProxySelectionModel::CLEAR_AND_SELECT);
  }
}

}
