// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LightingQuad.h"

#include "BoundFrame.h"
#include "LandscapeBark.h"
#include "LandscapeFringe.h"
#include "LandscapeGround.h"
#include "LandscapeLight.h"
#include "LandscapeNoise.h"
#include "LandscapeQuad.h"
#include "LandscapeSoftShadow.h"
#include "LandscapeUnfolded.h"
#include "LandscapeWater.h"
#include "LandscapeWetness.h"
#include "LandscapeWoods.h"
#include "Lighting.h"
#include "NearestPixels.h"
#include "OpenGL.h"
#include "SurfacePass.h"
#include "Uniforms.h"

#include "vtkCamera.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <cmath>
#include <string>
#include <utility>

namespace littoral
{

namespace
{

vtkSmartPointer<vtkTextureObject> NewPicture(vtkOpenGLRenderWindow* window)
{
  auto texture = vtkSmartPointer<vtkTextureObject>::New();
  texture->SetContext(window);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  return texture;
}

constexpr const char* Corners = R"(//VTK::System::Dec
in vec4 ndCoordIn;
in vec2 texCoordIn;
uniform float landscapeKind;   // depth from 0 to 1
uniform vec4 landscapeTakes;   // place in the pictures of surfaces of what is at t of the one drawn: xy + zw t
out vec2 texCoord;
void main()
{
  texCoord = landscapeTakes.xy + landscapeTakes.zw * texCoordIn;
  gl_Position = vec4(ndCoordIn.xy, 2.0 * landscapeKind - 1.0, 1.0);
}
)";

/// From view to clip coordinates.
glm::dmat4 ProjectionOf(vtkRenderer* renderer)
{
  return MatrixOf(
    renderer->GetActiveCamera()->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0));
}

/// Pixels of the picture, along its sides, from one whose shafts are found to the next.
constexpr int ShaftStep = 2;

bool HasShafts(const Lighting& light)
{
  return light.HasShafts && light.IsInWater && light.Ripples.HasWaves();
}

ContactShade::View ContactOf(vtkRenderer* renderer, const Lighting& light)
{
  return { glm::inverse(ProjectionOf(renderer)), glm::dmat3(light.ToWorld), light.IsParallel, light.ContactRadius,
    light.ContactCounts };
}

/// The program of a quad that is made, with what is defined, if there is none; null if it does not compile.
vtkShaderProgram* Ready(
  std::unique_ptr<vtkOpenGLQuadHelper>& quad, vtkOpenGLRenderWindow* window, const std::string& defined)
{
  if (!quad)
  {
    std::string source = LandscapeQuad;
    vtkShaderProgram::Substitute(source, "//VTK::Landscape::Dec",
      defined + LandscapeUnfolded + LandscapeNoise + LandscapeLight + LandscapeSoftShadow + LandscapeBark +
        LandscapeWoods + LandscapeGround + LandscapeWater + LandscapeWetness);
    vtkShaderProgram::Substitute(source, "//VTK::Fringe::Dec", LandscapeFringe);
    quad = std::make_unique<vtkOpenGLQuadHelper>(window, Corners, source.c_str(), "");
  }
  else
  {
    window->GetShaderCache()->ReadyShaderProgram(quad->Program);
  }
  return quad->Program && quad->Program->GetCompiled() ? quad->Program : nullptr;
}

}

//----------------------------------------------------------------------------
LightingQuad::LightingQuad() = default;
LightingQuad::~LightingQuad() = default;

//----------------------------------------------------------------------------
void LightingQuad::Layer::Allocate(vtkOpenGLRenderWindow* window, int width, int height)
{
  this->Albedo = NewPicture(window);
  this->Surface = NewPicture(window);
  this->Depth = NewPicture(window);
  const auto w = static_cast<unsigned int>(width);
  const auto h = static_cast<unsigned int>(height);
  this->Albedo->Allocate2D(w, h, 4, VTK_UNSIGNED_CHAR);
  this->Surface->Allocate2D(w, h, 4, VTK_FLOAT);
  this->Depth->AllocateDepth(w, h, vtkTextureObject::Float32);
}

//----------------------------------------------------------------------------
void LightingQuad::Layer::Clear(vtkWindow* window)
{
  PictureShader::Release({ &this->Albedo, &this->Surface, &this->Depth }, window);
}

//----------------------------------------------------------------------------
void LightingQuad::Allocate(vtkOpenGLRenderWindow* window, int width, int height)
{
  if (this->Dry.Albedo && this->Width == width && this->Height == height)
  {
    return;
  }
  this->Width = width;
  this->Height = height;
  this->Dry.Allocate(window, width, height);
  this->Wet = Layer();
  this->Raised = Layer();
  this->Bed = Layer();
  this->Lit = nullptr;
  this->HasLit = false;
  this->HasContact = false;
  this->HasBed = false;
  this->Kinds = NewPicture(window);
  this->Kinds->AllocateDepth(
    static_cast<unsigned int>(width), static_cast<unsigned int>(height), vtkTextureObject::Float32);
}

//----------------------------------------------------------------------------
void LightingQuad::AllocateLit(vtkOpenGLRenderWindow* window, bool hasLens)
{
  if (this->Lit && this->IsLinear == hasLens)
  {
    return;
  }
  this->IsLinear = hasLens;
  if (hasLens)
  {
    this->Lit = PictureShader::NewPicture(window, this->Width, this->Height, 4);
    return;
  }
  // A linear filter between four pixels is their mean.
  this->Lit = NewPicture(window);
  this->Lit->SetMinificationFilter(vtkTextureObject::Linear);
  this->Lit->SetMagnificationFilter(vtkTextureObject::Linear);
  this->Lit->Allocate2D(
    static_cast<unsigned int>(this->Width), static_cast<unsigned int>(this->Height), 4, VTK_UNSIGNED_CHAR);
}

//----------------------------------------------------------------------------
void LightingQuad::TakeSurfaces(
  vtkRenderer* renderer, const std::function<void()>& drawSurfaces, const std::function<void()>& drawWater)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  int width = 0;
  int height = 0;
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&width, &height, &origin[0], &origin[1]);
  const auto pixels = [this](int side) { return static_cast<int>(std::ceil(this->Samples * side / this->PixelSize)); };
  this->Allocate(window, pixels(width), pixels(height));
  this->Take(window, this->Dry, drawSurfaces);
  if (!drawWater)
  {
    this->Wet.Clear(window);
    return;
  }
  if (!this->Wet.Albedo)
  {
    this->Wet.Allocate(window, this->Width, this->Height);
  }
  this->Take(window, this->Wet, drawWater);
}

//----------------------------------------------------------------------------
void LightingQuad::Take(vtkOpenGLRenderWindow* window, const Layer& layer, const std::function<void()>& draw)
{
  BoundFrame bound(window, this->Frame, { layer.Albedo, layer.Surface }, layer.Depth);
  bound.Clear(SurfacePass::Nothing);
  draw();
}

//----------------------------------------------------------------------------
void LightingQuad::RaiseWoods(vtkRenderer* renderer, const Lighting& light)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  if (light.WoodCover <= 0.0 || !light.HasGround || light.IsInWater || light.IsParallel)
  {
    this->Raised.Clear(window);
    return;
  }
  if (!this->Raised.Albedo)
  {
    this->Raised.Allocate(window, this->Width, this->Height);
  }
  this->AllocateLit(window, light.HasLens());
  vtkOpenGLState::ScopedglDepthFunc depth(window->GetState());
  BoundFrame bound(window, this->Frame, { this->Raised.Albedo, this->Raised.Surface }, this->Raised.Depth);
  window->GetState()->vtkglDepthFunc(GL_ALWAYS);
  this->DrawPart("LandscapeFringe", 0, renderer, light);
  std::swap(this->Dry, this->Raised);
}

//----------------------------------------------------------------------------
void LightingQuad::Draw(vtkRenderer* renderer, const Lighting& light)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  if (!this->HasLit)
  {
    this->DrawLit(renderer, light);
  }
  this->HasBed = false;
  if (light.HasLens())
  {
    // The distance in pixels at which the picture has its angle of view is P_11 H / 2
    const double blur = 0.5 * light.Aperture * 0.5 * ProjectionOf(renderer)[1][1] * this->Height;
    this->Glass.Draw(window, this->Lit, { blur, light.FocusDistance });
  }
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglDepthFunc depth(state);
  vtkOpenGLState::ScopedglDepthMask mask(state);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglDepthFunc(GL_LEQUAL);
  vtkTextureObject* blurred = light.HasLens() ? this->Glass.GetBlurred() : this->Lit.Get();
  this->Lit->Activate();
  blurred->Activate();
  this->DrawPart("LandscapeShown", 0, renderer, light);
  blurred->Deactivate();
  this->Lit->Deactivate();
  this->HasLit = false;
}

//----------------------------------------------------------------------------
void LightingQuad::DrawLit(vtkRenderer* renderer, const Lighting& light)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  this->AllocateLit(window, light.HasLens());
  this->DrawContact(renderer, light, nullptr);
  if (HasShafts(light))
  {
    const auto part = [](int side) { return (side + ShaftStep - 1) / ShaftStep; };
    const int width = part(this->Width);
    const int height = part(this->Height);
    if (!this->Shafts || static_cast<int>(this->Shafts->GetWidth()) != width ||
      static_cast<int>(this->Shafts->GetHeight()) != height)
    {
      this->Shafts = PictureShader::NewPicture(window, width, height, 4);
    }
    const BoundFrame bound(window, this->Frame, { this->Shafts }, nullptr);
    this->DrawPart("LandscapeShafts", 0, renderer, light);
  }
  this->DrawKinds(renderer, light);
}

//----------------------------------------------------------------------------
bool LightingQuad::IsMixed(const Lighting& light) const
{
  return light.HasLens() || this->Samples != 1 || this->PixelSize != 1.0;
}

//----------------------------------------------------------------------------
void LightingQuad::ShareLit(vtkRenderer* renderer, const Lighting& light, vtkMultiProcessController* processes)
{
  this->DrawLit(renderer, light);
  if (light.HasLens())
  {
    TakeNearestPixels(this->Lit, processes);
  }
  else
  {
    this->DrawShownDepths(renderer, light);
    TakeNearestColors(this->Lit, this->Kinds, processes);
  }
  this->HasLit = true;
}

//----------------------------------------------------------------------------
/// Draws the depths that go with the lit surfaces where their kinds were.
void LightingQuad::DrawShownDepths(vtkRenderer* renderer, const Lighting& light)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkOpenGLState::ScopedglDepthFunc depth(window->GetState());
  BoundFrame bound(window, this->Frame, {}, this->Kinds);
  bound.Clear(0.0);
  window->GetState()->vtkglDepthFunc(GL_ALWAYS);
  this->Lit->Activate();
  this->DrawPart("LandscapeShown", 0, renderer, light);
  this->Lit->Deactivate();
}

//----------------------------------------------------------------------------
void LightingQuad::ShareContact(vtkRenderer* renderer, const Lighting& light, vtkMultiProcessController* processes)
{
  this->DrawContact(renderer, light, processes);
  this->HasContact = true;
}

//----------------------------------------------------------------------------
void LightingQuad::ShareBed(vtkMultiProcessController* processes)
{
  if (!this->Bed.Albedo)
  {
    this->Bed.Allocate(this->Dry.Albedo->GetContext(), this->Width, this->Height);
  }
  TakeNearestBelow(this->Wet.Depth, { this->Dry.Albedo, this->Dry.Surface, this->Dry.Depth },
    { this->Bed.Albedo, this->Bed.Surface, this->Bed.Depth }, processes);
  this->HasBed = true;
}

//----------------------------------------------------------------------------
void LightingQuad::DrawContact(vtkRenderer* renderer, const Lighting& light, vtkMultiProcessController* processes)
{
  if (light.ContactRadius > 0.0 && !this->HasContact)
  {
    auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
    this->Contact.Draw(window, this->Dry.Surface, this->Dry.Depth, ContactOf(renderer, light), processes);
  }
  this->HasContact = false;
}

//----------------------------------------------------------------------------
void LightingQuad::DrawKinds(vtkRenderer* renderer, const Lighting& light)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglDepthFunc depth(state);
  vtkOpenGLState::ScopedglColorMask colorMask(state);
  BoundFrame bound(window, this->Frame, { this->Lit }, this->Kinds);
  bound.Clear(0.0); // there may be no background
  state->vtkglDepthFunc(GL_ALWAYS);
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  this->DrawPart("LandscapeKinds", 0, renderer, light);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglDepthFunc(GL_EQUAL);
  const bool isDry = !light.IsInWater;
  const bool areThere[] = { isDry && light.Background, isDry, isDry && light.HasGround, isDry && light.HasWater, !isDry,
    !isDry, !isDry };
  const char* const parts[] = { "LandscapeSky", "LandscapeSurface", "LandscapeGround", "LandscapeAbove",
    "LandscapeBelow", "LandscapeOver", "LandscapeOpen" };
  for (int k = 0; k < 7; ++k)
  {
    if (areThere[k])
    {
      this->DrawPart(parts[k], k + 1, renderer, light);
    }
  }
}

//----------------------------------------------------------------------------
void LightingQuad::DrawPart(const std::string& part, int kind, vtkRenderer* renderer, const Lighting& light)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  std::string defined = "#define LandscapePart " + part + "\n#define LandscapeHasWater ";
  defined += this->Wet.Albedo ? "1\n" : "0\n";
  defined += light.HasShore() ? "#define LandscapeHasShore 1\n" : "#define LandscapeHasShore 0\n";
  defined += light.Wetness > 0.0 ? "#define LandscapeIsWet 1\n" : "#define LandscapeIsWet 0\n";
  defined += light.HasShadows() ? "" : "#define LandscapeNoShadows\n";
  defined += "#define LandscapeFirstMap " + std::string(light.Maps.Has(0) ? "0\n" : light.Maps.Has(1) ? "1\n" : "2\n");
  defined += light.HasSoftShadows() ? "#define LandscapeSoftShadows\n" : "";
  defined += light.HasOcclusion() ? "" : "#define LandscapeNoOcclusion\n";
  defined += light.FogExtinction > 0.0 ? "" : "#define LandscapeNoFog\n";
  defined += light.ContactRadius > 0.0 ? "#define LandscapeHasContact\n" : "";
  defined += light.HasLens() ? "#define LandscapeHasLens\n" : "";
  defined += this->HasLit ? "#define LandscapeIsShared\n" : "";
  defined += HasShafts(light) ? "#define LandscapeHasShafts\n" : "";
  defined += light.HasBark ? "#define LandscapeHasBark\n" : "";
  defined += light.Turf.x > 0.0 ? "#define LandscapeHasTurf\n" : "";
  defined += light.WoodCover > 0.0 ? "#define LandscapeHasWoods\n" : "";
  defined += light.CloudCover > 0.0 ? "" : "#define LandscapeNoClouds\n";
  vtkShaderProgram* program = Ready(this->Parts[defined], window, defined);
  if (!program)
  {
    return;
  }
  SetUniform(program, "landscapeKind", kind / 8.0);
  light.SetUniforms(program);
  const Layer& wet = this->Wet.Albedo ? this->Wet : this->Dry;
  const Layer& dry = this->HasBed && part == "LandscapeAbove" ? this->Bed : this->Dry;
  vtkTextureObject* const pictures[] = { dry.Albedo, dry.Surface, dry.Depth, wet.Albedo, wet.Surface, wet.Depth };
  const char* const names[] = { "landscapeAlbedo", "landscapeSurface", "landscapeDepth", "landscapeWetColor",
    "landscapeWetSurface", "landscapeWetDepth" };
  for (int picture = 0; picture < (this->Wet.Albedo ? 6 : 3); ++picture)
  {
    pictures[picture]->Activate();
  }
  const bool isOfShafts = part == "LandscapeShafts";
  const glm::dvec2 size(this->Width, this->Height);
  const glm::dvec2 parts = glm::ceil(size / static_cast<double>(ShaftStep));
  const glm::dvec2 scale = isOfShafts ? static_cast<double>(ShaftStep) * parts / size : glm::dvec2(1.0);
  const glm::dvec2 first = isOfShafts ? 0.5 * (1.0 - ShaftStep) / size : glm::dvec2(0.0);
  SetUniform(program, "landscapeTakes", glm::dvec4(first, scale));
  vtkTextureObject* const shafts = HasShafts(light) && !isOfShafts ? this->Shafts.Get() : nullptr;
  if (shafts)
  {
    shafts->Activate();
    SetUniform(program, "landscapeShaftsBefore", shafts->GetTextureUnit());
    SetUniform(program, "landscapeStep", ShaftStep);
  }
  vtkTextureObject* const hidden = light.ContactRadius > 0.0 ? this->Contact.GetHidden() : nullptr;
  if (hidden)
  {
    hidden->Activate();
    SetUniform(program, "landscapeContact", hidden->GetTextureUnit());
  }
  for (int picture = 0; picture < 6; ++picture)
  {
    SetUniform(program, names[picture], pictures[picture]->GetTextureUnit());
  }
  const glm::dmat4 projection = ProjectionOf(renderer);
  SetUniform(program, "landscapeToView", glm::inverse(projection));
  const auto modulo = [&](double period) { return light.Eye - period * glm::floor(light.Eye / period); };
  SetUniform(program, "landscapeEye", modulo(NoisePeriod));
  SetUniform(program, "landscapeWideEye", glm::dvec2(modulo(65536.0)));
  SetUniform(program, "landscapeWoodCover", light.WoodCover);
  SetUniform(program, "landscapeCoverColor", light.CoverColor);
  SetUniform(program, "landscapeTurf", light.Turf);
  SetUniform(program, "landscapeDrawn", this->Lit->GetTextureUnit());
  if (part == "LandscapeShown" && light.HasLens())
  {
    SetUniform(program, "landscapeBlurred", this->Glass.GetBlurred()->GetTextureUnit());
    SetUniform(program, "landscapeSamples", this->Samples);
  }
  SetUniform(program, "landscapePixel", 2.0 / (projection[1][1] * this->Height));
  SetUniform(program, "landscapeContactRadius", light.ContactRadius);
  SetUniform(program, "landscapeContactStep", ContactShade::Step);
  this->Parts[defined]->Render();
  for (vtkTextureObject* picture : { shafts, hidden })
  {
    if (picture)
    {
      picture->Deactivate();
    }
  }
  for (int picture = 0; picture < (this->Wet.Albedo ? 6 : 3); ++picture)
  {
    pictures[picture]->Deactivate();
  }
}

//----------------------------------------------------------------------------
void LightingQuad::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Dry.Clear(window);
  this->Wet.Clear(window);
  this->Raised.Clear(window);
  this->Bed.Clear(window);
  this->Contact.ReleaseGraphicsResources(window);
  this->Glass.ReleaseGraphicsResources(window);
  PictureShader::Release({ &this->Lit, &this->Kinds, &this->Shafts }, window);
  this->Frame->ReleaseGraphicsResources(window);
  for (auto& [defined, quad] : this->Parts)
  {
    quad->ReleaseGraphicsResources(window);
  }
  this->Parts.clear();
}

}
