// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfacePass.h"

#include "Uniforms.h"
#include "vtkLandscapePass.h"

#include "vtkActor.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderState.h"
#include "vtkShaderProgram.h"

#include <string>

namespace littoral
{

vtkStandardNewMacro(SurfacePass);

namespace
{

constexpr const char* CutOut = "  if (gl_FragData[0].a < 0.5) discard;";

constexpr const char* LitOutput = R"(
  gl_FragData[0] = landscapeMaterial > 3.5 ? landscapeCarried() : vec4(gl_FragData[0].rgb, 1.0);
#ifdef LandscapeOwnPlace
  gl_FragData[0].a = 0.5 + 0.5 * landscapeAgreed;
#endif
  vec3 landscapeN = normalVCVSOutput / max(dot(abs(normalVCVSOutput), vec3(1.0)), 1e-9);
  vec2 landscapeS = vec2(landscapeN.x >= 0.0 ? 1.0 : -1.0, landscapeN.y >= 0.0 ? 1.0 : -1.0);
  vec2 landscapeO = landscapeN.z >= 0.0 ? landscapeN.xy : (1.0 - abs(landscapeN.yx)) * landscapeS;
  gl_FragData[1] = vec4(landscapeO, landscapeMaterial, landscapeW);
)";

/// Stretch of a surface of water by its Jacobian (vtkLandscapePass::SetMaterial), up to 1, and by the foam that is left
/// of former ones, in alpha; 0 for one without. In red, green and blue the way of the water from its place at rest, in
/// 1/128 m, by 12 bits a coordinate.
constexpr const char* Stretch = R"(
in float landscapeStretchVS;
in float landscapeFoamVS;
in vec2 landscapeWayVS;
vec4 landscapeCarried()
{
  ivec2 way = clamp(ivec2(floor(128.0 * landscapeWayVS + 2048.5)), 0, 4095);
  float stretch =
    landscapeStretchVS == 0.0 ? 0.0 : clamp(min(landscapeStretchVS, 1.0 - landscapeFoamVS), 0.004, 1.0);
  return vec4(vec3(way.x >> 4, ((way.x & 15) << 4) | (way.y >> 8), way.y & 255) / 255.0, stretch);
}
)";
/// Where a fragment of a river is between its banks, from 0 to 1, and how wide the river is [m], in parts of 16 octaves
/// from 1/16 m on; 0 where that is not told.
constexpr const char* Banks = R"(
in float landscapeBankVS;
in float landscapeChannelVS;
vec4 landscapeCarried()
{
  float width = landscapeChannelVS > 0.0 ? clamp((log2(landscapeChannelVS) + 4.0) / 16.0, 0.004, 1.0) : 0.0;
  return vec4(0.5 + 0.5 * landscapeBankVS, width, 0.0, 0.0);
}
)";
constexpr const char* NoStretch = "vec4 landscapeCarried() { return vec4(0.0); }\n";

/// w of the clip coordinates, by which the place of a fragment is found; impostors are not where they are drawn.
constexpr const char* Solid = R"(
#ifdef LandscapeOwnPlace
  float landscapeW = landscapeOwnW;
#else
  float landscapeW = 1.0 / gl_FragCoord.w;
#endif
)";

/// Normal of the sphere that a sprite of vtkPointGaussianMapper is a picture of, without a w, which since VTK 9.4 is
/// not that of its place; and the shade that ParaView paints on it.
constexpr const char* Sprite = R"(
  float landscapeW = 0.0;
  vec3 normalVCVSOutput = vec3(offsetVCVSOutput, sqrt(max(0.0, 1.0 - dot(offsetVCVSOutput, offsetVCVSOutput))));
)";
constexpr const char* PaintedShade = "float scale = (1.0 - dist);";

constexpr const char* UnlitOutput = R"(
  gl_FragData[1] = vec4(0.0, 0.0, -1.0, 1.0 / gl_FragCoord.w);
)";

}

//----------------------------------------------------------------------------
bool SurfacePass::IsLit(vtkProp* prop, bool lightsColorMaps)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  return !actor || (actor->GetProperty()->GetLighting() && (lightsColorMaps || !vtkLandscapePass::HasColorMap(prop)));
}

//----------------------------------------------------------------------------
double SurfacePass::TransmittanceOf(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  const bool isAmbient = actor && actor->GetProperty()->GetDiffuse() <= 0.0;
  return isAmbient ? Unlit : vtkLandscapePass::GetTransmittance(prop);
}

//----------------------------------------------------------------------------
void SurfacePass::Begin(const vtkRenderState* state)
{
  this->SetActiveDrawBuffers(2);
  this->PreRender(state);
}

//----------------------------------------------------------------------------
void SurfacePass::End(const vtkRenderState* state)
{
  this->PostRender(state);
}

//----------------------------------------------------------------------------
bool SurfacePass::PreReplaceShaderValues(
  std::string& vertex, std::string&, std::string& fragment, vtkAbstractMapper* mapper, vtkProp* prop)
{
  if (!vtkOpenGLPolyDataMapper::SafeDownCast(mapper))
  {
    return true;
  }
  if (IsLit(prop, this->LightsColorMaps))
  {
    // The color without light, which a texture then multiplies
    vtkShaderProgram::Substitute(
      fragment, "//VTK::Light::Impl", "gl_FragData[0] = vec4(max(ambientColor, diffuseColor), opacity);\n", false);
  }
  vtkShaderProgram::Substitute(
    fragment, "//VTK::DepthPeeling::Impl", "//VTK::Landscape::Impl\n  //VTK::DepthPeeling::Impl", false);
  vtkShaderProgram::Substitute(fragment, "//VTK::Light::Dec",
    "//VTK::Light::Dec\n#define LandscapeLight\nuniform float landscapeMaterial;\n//VTK::Landscape::Dec", false);
  const bool isWater = vtkLandscapePass::GetMaterial(prop) == vtkLandscapePass::Water;
  const bool isRiver = vtkLandscapePass::GetMaterial(prop) == vtkLandscapePass::River;
  if (isRiver)
  {
    vtkShaderProgram::Substitute(vertex, "//VTK::Normal::Dec",
      "//VTK::Normal::Dec\nin float landscapeBank;\nout float landscapeBankVS;\n"
      "in float landscapeChannel;\nout float landscapeChannelVS;\n",
      false);
    vtkShaderProgram::Substitute(vertex, "//VTK::Normal::Impl",
      "//VTK::Normal::Impl\n  landscapeBankVS = landscapeBank;\n  landscapeChannelVS = landscapeChannel;\n", false);
  }
  vtkShaderProgram::Substitute(fragment, "//VTK::Landscape::Dec",
    isWater     ? Stretch
      : isRiver ? Banks
                : NoStretch,
    false);
  if (isWater)
  {
    vtkShaderProgram::Substitute(vertex, "//VTK::Normal::Dec",
      "//VTK::Normal::Dec\nin float landscapeStretch;\nout float landscapeStretchVS;\nin float landscapeLeft;\n"
      "out float landscapeFoamVS;\nin vec2 landscapeWay;\nout vec2 landscapeWayVS;\n",
      false);
    vtkShaderProgram::Substitute(vertex, "//VTK::Normal::Impl",
      "//VTK::Normal::Impl\n  landscapeStretchVS = landscapeStretch;\n  landscapeFoamVS = landscapeLeft;\n"
      "  landscapeWayVS = landscapeWay;\n",
      false);
  }
  return true;
}

//----------------------------------------------------------------------------
bool SurfacePass::PostReplaceShaderValues(
  std::string&, std::string&, std::string& fragment, vtkAbstractMapper*, vtkProp* prop)
{
  const bool hasNormal = fragment.find("normalVCVSOutput") != std::string::npos;
  const bool isLit = IsLit(prop, this->LightsColorMaps);
  const bool isSprite = !hasNormal && isLit && fragment.find("offsetVCVSOutput") != std::string::npos;
  std::string output = std::string(CutOut) + (isSprite ? Sprite : Solid);
  output += isSprite || (hasNormal && isLit) ? LitOutput : UnlitOutput;
  vtkShaderProgram::Substitute(fragment, "//VTK::Landscape::Impl", output, false);
  if (isSprite)
  {
    vtkShaderProgram::Substitute(fragment, PaintedShade, "float scale = 1.0;", false);
  }
  return true;
}

//----------------------------------------------------------------------------
bool SurfacePass::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  if (program->IsUniformUsed("landscapeMaterial"))
  {
    const int material = vtkLandscapePass::GetMaterial(prop);
    SetUniform(program, "landscapeMaterial",
      material == vtkLandscapePass::Ground    ? Ground
        : material == vtkLandscapePass::Cover ? Cover
        : material == vtkLandscapePass::Water ? Water
        : material == vtkLandscapePass::River ? River
        : material == vtkLandscapePass::Bark  ? Bark
                                              : TransmittanceOf(prop));
  }
  return true;
}

}
