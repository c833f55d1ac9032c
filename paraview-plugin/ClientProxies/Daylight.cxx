// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Daylight.h"

#include "FirstCamera.h"

#include "vtkNew.h"
#include "vtkSMParaViewPipelineController.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSmartPointer.h"

#include <cstring>
#include <string>
#include <vector>

namespace littoral
{
namespace
{

struct Mood
{
  const char* Name;
  double Bottom[3]; ///< color of the background
  double Top[3];
  double Sun[3]; ///< direction towards it, of any length
  double SunColor[3];
  double SunIntensity; ///< 0: there is none
  double SkyIntensity; ///< of the light kit's key light
};

constexpr Mood Moods[] = {
  { "land", { 0.90, 0.93, 0.94 }, { 0.33, 0.55, 0.81 }, { -0.85, -0.35, 0.55 }, { 1.0, 0.95, 0.84 }, 0.85, 0.45 },
  { "sea", { 1.00, 1.00, 0.99 }, { 0.45, 0.65, 0.88 }, { -0.35, 0.80, 0.42 }, { 1.0, 0.95, 0.85 }, 0.80, 0.45 },
  { "water", { 0.01, 0.10, 0.16 }, { 0.13, 0.46, 0.55 }, { -0.35, -0.45, 0.85 }, { 0.95, 1.0, 0.95 }, 0.80, 0.50 },
  { "murk", { 0.09, 0.38, 0.44 }, { 0.09, 0.38, 0.44 }, { -0.35, -0.45, 0.85 }, { 0.95, 1.0, 0.95 }, 0.90, 0.60 },
  { "paper", { 1.0, 1.0, 1.0 }, { 1.0, 1.0, 1.0 }, { 0.0, 0.0, 1.0 }, { 1.0, 1.0, 1.0 }, 0.0, 0.75 },
};

/// Properties that a user may have chosen.
constexpr const char* Choices[] = { "UseColorPaletteForBackground", "BackgroundColorMode", "UseLight", "KeyLightWarmth",
  "KeyLightIntensity", "KeyLightElevation", "KeyLightAzimuth" };

/// Marks a view that was lit once.
constexpr const char* Mark = "Littoral.Daylight";

/// The mood of a name; null if there is none.
const Mood* Find(const char* name)
{
  for (const Mood& mood : Moods)
  {
    if (std::strcmp(mood.Name, name) == 0)
    {
      return &mood;
    }
  }
  return nullptr;
}

bool IsAsByDefault(vtkSMProxy* view)
{
  for (const char* name : Choices)
  {
    vtkSMProperty* property = view->GetProperty(name);
    if (!property || !property->IsValueDefault())
    {
      return false;
    }
  }
  return view->GetProperty("AdditionalLights") &&
    vtkSMPropertyHelper(view, "AdditionalLights").GetNumberOfElements() == 0;
}

void AddSun(vtkSMProxy* view, const Mood& mood)
{
  vtkSMSessionProxyManager* proxies = view->GetSessionProxyManager();
  auto sun = vtkSmartPointer<vtkSMProxy>::Take(proxies->NewProxy("additional_lights", "Light"));
  if (!sun)
  {
    return;
  }
  vtkNew<vtkSMParaViewPipelineController> controller;
  controller->PreInitializeProxy(sun);
  const double origin[3] = { 0.0, 0.0, 0.0 };
  vtkSMPropertyHelper(sun, "LightType").Set("Scene");
  vtkSMPropertyHelper(sun, "Positional").Set("Directional");
  vtkSMPropertyHelper(sun, "LightPosition").Set(mood.Sun, 3);
  vtkSMPropertyHelper(sun, "FocalPoint").Set(origin, 3);
  vtkSMPropertyHelper(sun, "DiffuseColor").Set(mood.SunColor, 3);
  vtkSMPropertyHelper(sun, "LightIntensity").Set(mood.SunIntensity);
  controller->PostInitializeProxy(sun);
  sun->UpdateVTKObjects();
  controller->RegisterLightProxy(sun, view, "Sun");
  vtkSMPropertyHelper(view, "AdditionalLights").Add(sun);
}

}

//----------------------------------------------------------------------------
bool IsLandscapeLight(vtkSMProxy* representation)
{
  return std::strcmp(representation->GetXMLName(), "LandscapeLightRepresentation") == 0;
}

//----------------------------------------------------------------------------
bool TakesLandscapeLight(vtkSMProxy* view)
{
  const vtkSMPropertyHelper shown(view, "Representations");
  for (unsigned int k = 0; k < shown.GetNumberOfElements(); ++k)
  {
    vtkSMProxy* one = shown.GetAsProxy(k);
    if (one && IsLandscapeLight(one) && vtkSMPropertyHelper(one, "Visibility").GetAsInt() != 0)
    {
      return false;
    }
  }
  return IsEmpty(view) && (view->HasAnnotation(Mark) || IsAsByDefault(view));
}

//----------------------------------------------------------------------------
bool IsMap(vtkSMProxy* view)
{
  const char* mood = view->GetAnnotation(Mark);
  if (!mood || std::strcmp(mood, "paper") != 0 ||
    vtkSMPropertyHelper(view, "AdditionalLights").GetNumberOfElements() != 0)
  {
    return false;
  }
  const std::vector<double> color = vtkSMPropertyHelper(view, "Background").GetDoubleArray();
  return color == std::vector<double>{ 1.0, 1.0, 1.0 };
}

//----------------------------------------------------------------------------
void LightView(vtkSMProxy* view, const char* name)
{
  const Mood* mood = Find(name);
  if (!mood || (!IsMap(view) && (view->HasAnnotation(Mark) || !IsAsByDefault(view))))
  {
    return;
  }
  view->SetAnnotation(Mark, mood->Name);
  vtkSMPropertyHelper(view, "UseColorPaletteForBackground").Set(0);
  vtkSMPropertyHelper(view, "BackgroundColorMode").Set("Gradient");
  vtkSMPropertyHelper(view, "Background").Set(mood->Bottom, 3);
  vtkSMPropertyHelper(view, "Background2").Set(mood->Top, 3);
  vtkSMPropertyHelper(view, "KeyLightIntensity").Set(mood->SkyIntensity);
  if (mood->SunIntensity > 0.0)
  {
    AddSun(view, *mood);
  }
  view->UpdateVTKObjects();
}

}
