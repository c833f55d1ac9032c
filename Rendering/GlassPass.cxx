// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "GlassPass.h"

#include "LandscapeLight.h"
#include "LandscapeNoise.h"
#include "Lighting.h"
#include "SurfacePass.h"
#include "vtkLandscapePass.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkRenderState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <string>

namespace littoral
{

vtkStandardNewMacro(GlassPass);

//----------------------------------------------------------------------------
void GlassPass::Begin(const vtkRenderState* state, const Lighting& light)
{
  this->Light = &light;
  this->PreRender(state);
}

//----------------------------------------------------------------------------
void GlassPass::End(const vtkRenderState* state)
{
  this->PostRender(state);
  this->Light = nullptr;
}

//----------------------------------------------------------------------------
bool GlassPass::PreReplaceShaderValues(
  std::string&, std::string&, std::string& fragment, vtkAbstractMapper* mapper, vtkProp* prop)
{
  if (vtkOpenGLPolyDataMapper::SafeDownCast(mapper) && SurfacePass::IsLit(prop, this->Light->LightsColorMaps))
  {
    vtkShaderProgram::Substitute(fragment, "//VTK::Light::Dec",
      std::string("//VTK::Light::Dec\n#define LandscapeLight\n") + LandscapeNoise + LandscapeLight +
        "uniform float landscapeTransmittance;\n",
      false);
    vtkShaderProgram::Substitute(
      fragment, "//VTK::Light::Impl", "gl_FragData[0] = vec4(max(ambientColor, diffuseColor), opacity);\n", false);
    vtkShaderProgram::Substitute(
      fragment, "//VTK::DepthPeeling::Impl", "//VTK::Landscape::Impl\n  //VTK::DepthPeeling::Impl", false);
  }
  return true;
}

//----------------------------------------------------------------------------
bool GlassPass::PostReplaceShaderValues(std::string&, std::string&, std::string& fragment, vtkAbstractMapper*, vtkProp*)
{
  const bool hasPlace = fragment.find("vertexVC") != std::string::npos;
  const bool hasNormal = fragment.find("normalVCVSOutput") != std::string::npos;
  vtkShaderProgram::Substitute(fragment, "//VTK::Landscape::Impl",
    hasPlace && hasNormal
      ? "if (landscapeTransmittance >= 0.0) gl_FragData[0].rgb = landscapeLit(landscapeLinear(gl_FragData[0].rgb), "
        "landscapeEyeOf(vertexVC.xyz), vertexVC.xyz, normalVCVSOutput, landscapeTransmittance);\n"
      : "",
    false);
  return true;
}

//----------------------------------------------------------------------------
bool GlassPass::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  if (this->Light && program->IsUniformUsed("landscapeDome"))
  {
    this->Light->SetUniforms(program);
    program->SetUniformf("landscapeTransmittance", static_cast<float>(SurfacePass::TransmittanceOf(prop)));
  }
  return true;
}

}
