// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMGLTFSceneExporterProxy.h"

#include "Daylight.h"
#include "Light/AirLayers.h"
#include "Light/SunPosition.h"

#include "vtkObjectFactory.h"
#include "vtkSMDataTypeDomain.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMWriterProxy.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkSMGLTFSceneExporterProxy);

namespace
{

void CopyNumbers(vtkSMProxy* from, const char* name, vtkSMProxy* to, const char* target)
{
  vtkSMPropertyHelper(to, target).Set(vtkSMPropertyHelper(from, name).GetDoubleArray().data(), 3);
}

void ClearSources(vtkSMProxy* writer)
{
  vtkSMPropertyHelper(writer, "Input").RemoveAllValues();
  vtkSMPropertyHelper(writer, "SourceNames").SetNumberOfElements(0);
}

/// Makes the contents of a view the writer's input, with the names of the pipeline browser.
void SetSources(vtkSMProxy* view, vtkSMProxy* writer)
{
  ClearSources(writer);
  vtkSMPropertyHelper inputs(writer, "Input");
  vtkSMPropertyHelper names(writer, "SourceNames");
  auto* domain = writer->GetProperty("Input")->FindDomain<vtkSMDataTypeDomain>();
  std::set<std::pair<vtkSMProxy*, unsigned int>> known;
  vtkSMPropertyHelper representations(view, "Representations");
  for (unsigned int index = 0; index < representations.GetNumberOfElements(); ++index)
  {
    vtkSMProxy* representation = representations.GetAsProxy(index);
    if (!representation->GetProperty("Input") || !representation->GetProperty("Visibility") ||
      vtkSMPropertyHelper(representation, "Visibility").GetAsInt() == 0)
    {
      continue;
    }
    vtkSMPropertyHelper input(representation, "Input");
    auto* source = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
    const unsigned int port = input.GetOutputPort();
    if (source && domain->IsInDomain(source, static_cast<int>(port)) && known.emplace(source, port).second)
    {
      const char* name = source->GetSessionProxyManager()->GetProxyName("sources", source);
      names.Set(inputs.GetNumberOfElements(), name ? name : source->GetXMLLabel());
      inputs.Add(source, port);
    }
  }
}

void SetCamera(vtkSMProxy* view, vtkSMProxy* writer)
{
  CopyNumbers(view, "CameraPosition", writer, "CameraPosition");
  CopyNumbers(view, "CameraFocalPoint", writer, "CameraFocalPoint");
  CopyNumbers(view, "CameraViewUp", writer, "CameraViewUp");
  vtkSMPropertyHelper(writer, "CameraViewAngle").Set(vtkSMPropertyHelper(view, "CameraViewAngle").GetAsDouble());
}

/// The landscape light that is on in a view; null if there is none.
vtkSMProxy* LandscapeLightOf(vtkSMProxy* view)
{
  const vtkSMPropertyHelper shown(view, "Representations");
  for (unsigned int index = 0; index < shown.GetNumberOfElements(); ++index)
  {
    vtkSMProxy* one = shown.GetAsProxy(index);
    if (littoral::IsLandscapeLight(one) && vtkSMPropertyHelper(one, "Visibility").GetAsInt() != 0)
    {
      return one;
    }
  }
  return nullptr;
}

/// Direction towards the sun of a landscape light.
littoral::Vector3 SunOfLandscape(vtkSMProxy* light)
{
  const auto number = [light](const char* name) { return vtkSMPropertyHelper(light, name).GetAsDouble(); };
  littoral::SunAngles angles{ number("SunElevation"), number("SunAzimuth") };
  if (vtkSMPropertyHelper(light, "SunPlacement").GetAsInt() == 1) // by the clock
  {
    const std::vector<int> date = vtkSMPropertyHelper(light, "Date").GetIntArray();
    const littoral::UniversalTime time{ date[0], date[1], date[2], number("Hours") };
    angles =
      littoral::WhyInvalid(time).empty() ? littoral::SunAt(time, number("Latitude"), number("Longitude")) : angles;
  }
  return littoral::DirectionOf(angles);
}

/// The sun of a landscape light with the color that the air leaves it; false if it is below the horizon.
bool SetSunOfLandscape(vtkSMProxy* light, vtkSMProxy* writer)
{
  const littoral::Vector3 towards = SunOfLandscape(light);
  littoral::AirParameters air;
  air.Turbidity = std::clamp(vtkSMPropertyHelper(light, "Turbidity").GetAsDouble(), 1.0, 10.0);
  const littoral::Vector3 left = littoral::AirLayers(air).SunAt(0.0, towards.z);
  const double most = std::max({ left.x, left.y, left.z });
  if (most <= 0.0)
  {
    return false;
  }
  const littoral::Vector3 color = left / most;
  vtkSMPropertyHelper(writer, "SunDirection").Set(&towards.x, 3);
  vtkSMPropertyHelper(writer, "SunColor").Set(&color.x, 3);
  return true;
}

/// The first directional light of a view that stands still in the scene; null if there is none.
vtkSMProxy* LightOf(vtkSMProxy* view)
{
  constexpr int ofScene = 3; // VTK_LIGHT_TYPE_SCENE_LIGHT
  vtkSMPropertyHelper lights(view, "AdditionalLights");
  for (unsigned int index = 0; index < lights.GetNumberOfElements(); ++index)
  {
    vtkSMProxy* light = lights.GetAsProxy(index);
    if (vtkSMPropertyHelper(light, "LightSwitch").GetAsInt() != 0 &&
      vtkSMPropertyHelper(light, "LightType").GetAsInt() == ofScene &&
      vtkSMPropertyHelper(light, "Positional").GetAsInt() == 0)
    {
      return light;
    }
  }
  return nullptr;
}

void SetSunOfLight(vtkSMProxy* light, vtkSMProxy* writer)
{
  const auto position = vtkSMPropertyHelper(light, "LightPosition").GetDoubleArray();
  const auto focus = vtkSMPropertyHelper(light, "FocalPoint").GetDoubleArray();
  const double towards[3] = { position[0] - focus[0], position[1] - focus[1], position[2] - focus[2] };
  vtkSMPropertyHelper(writer, "SunDirection").Set(towards, 3);
  CopyNumbers(light, "DiffuseColor", writer, "SunColor");
}

/// The sun of a view; false if there is none.
bool SetSun(vtkSMProxy* view, vtkSMProxy* writer)
{
  if (vtkSMProxy* landscape = LandscapeLightOf(view))
  {
    return SetSunOfLandscape(landscape, writer);
  }
  vtkSMProxy* light = LightOf(view);
  if (light)
  {
    SetSunOfLight(light, writer);
  }
  return light != nullptr;
}

}

//----------------------------------------------------------------------------
vtkSMGLTFSceneExporterProxy::vtkSMGLTFSceneExporterProxy() = default;

//----------------------------------------------------------------------------
vtkSMGLTFSceneExporterProxy::~vtkSMGLTFSceneExporterProxy() = default;

//----------------------------------------------------------------------------
bool vtkSMGLTFSceneExporterProxy::CanExport(vtkSMProxy* view)
{
  return vtkSMRenderViewProxy::SafeDownCast(view) != nullptr;
}

//----------------------------------------------------------------------------
void vtkSMGLTFSceneExporterProxy::Write()
{
  auto* writer = vtkSMWriterProxy::SafeDownCast(this->GetSubProxy("Writer"));
  vtkSMProxy* view = this->View;
  if (!writer || !this->CanExport(view))
  {
    vtkErrorMacro("There is no render view to export.");
    return;
  }
  this->CreateVTKObjects();
  SetSources(view, writer);
  const int hasCamera = vtkSMPropertyHelper(writer, "WriteCamera").GetAsInt();
  const int hasSun = vtkSMPropertyHelper(writer, "WriteSun").GetAsInt();
  if (hasCamera != 0)
  {
    SetCamera(view, writer);
  }
  const bool isSunny = hasSun != 0 && SetSun(view, writer);
  const bool isParallel = vtkSMPropertyHelper(view, "CameraParallelProjection").GetAsInt() != 0;
  vtkSMPropertyHelper(writer, "WriteCamera").Set(hasCamera != 0 && !isParallel ? 1 : 0);
  vtkSMPropertyHelper(writer, "WriteSun").Set(isSunny ? 1 : 0);
  writer->UpdateVTKObjects();
  writer->UpdatePipeline(vtkSMPropertyHelper(view, "ViewTime").GetAsDouble());
  vtkSMPropertyHelper(writer, "WriteCamera").Set(hasCamera);
  vtkSMPropertyHelper(writer, "WriteSun").Set(hasSun);
  ClearSources(writer);
  writer->UpdateVTKObjects();
}

//----------------------------------------------------------------------------
void vtkSMGLTFSceneExporterProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
