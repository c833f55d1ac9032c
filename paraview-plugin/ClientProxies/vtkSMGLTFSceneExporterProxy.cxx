// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMGLTFSceneExporterProxy.h"

#include "vtkObjectFactory.h"
#include "vtkSMDataTypeDomain.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMWriterProxy.h"

#include <set>
#include <utility>

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

/// The sun of a view: its first directional light that stands still in the scene; null if there is none.
vtkSMProxy* SunOf(vtkSMProxy* view)
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

void SetSun(vtkSMProxy* light, vtkSMProxy* writer)
{
  const auto position = vtkSMPropertyHelper(light, "LightPosition").GetDoubleArray();
  const auto focus = vtkSMPropertyHelper(light, "FocalPoint").GetDoubleArray();
  const double towards[3] = { position[0] - focus[0], position[1] - focus[1], position[2] - focus[2] };
  vtkSMPropertyHelper(writer, "SunDirection").Set(towards, 3);
  CopyNumbers(light, "DiffuseColor", writer, "SunColor");
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
  vtkSMProxy* sun = SunOf(view);
  if (hasSun != 0 && sun)
  {
    SetSun(sun, writer);
  }
  const bool isParallel = vtkSMPropertyHelper(view, "CameraParallelProjection").GetAsInt() != 0;
  vtkSMPropertyHelper(writer, "WriteCamera").Set(hasCamera != 0 && !isParallel ? 1 : 0);
  vtkSMPropertyHelper(writer, "WriteSun").Set(hasSun != 0 && sun ? 1 : 0);
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
