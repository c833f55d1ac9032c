// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LightingQuad.h"

#include "LandscapeLight.h"
#include "LandscapeQuad.h"
#include "Lighting.h"
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

#include <string>

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

}

//----------------------------------------------------------------------------
LightingQuad::LightingQuad() = default;
LightingQuad::~LightingQuad() = default;

//----------------------------------------------------------------------------
void LightingQuad::Allocate(vtkOpenGLRenderWindow* window, int width, int height)
{
  if (this->Albedo && this->Width == width && this->Height == height)
  {
    return;
  }
  this->Width = width;
  this->Height = height;
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
void LightingQuad::TakeSurfaces(vtkRenderer* renderer, const std::function<void()>& drawSurfaces)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  int width = 0;
  int height = 0;
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&width, &height, &origin[0], &origin[1]);
  this->Allocate(window, width, height);

  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  vtkOpenGLState::ScopedglClearColor clearColor(state);
  vtkOpenGLState::ScopedglDepthMask mask(state);
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  state->PushFramebufferBindings();
  this->Frame->SetContext(window);
  this->Frame->Bind();
  this->Frame->AddColorAttachment(0, this->Albedo);
  this->Frame->AddColorAttachment(1, this->Surface);
  this->Frame->AddDepthAttachment(this->Depth);
  this->Frame->ActivateDrawBuffers(2);
  state->vtkglViewport(0, 0, width, height);
  state->vtkglScissor(0, 0, width, height);
  state->vtkglDisable(GL_BLEND);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglClearDepth(1.0);
  state->vtkglClearColor(0.0F, 0.0F, static_cast<float>(SurfacePass::Nothing), 0.0F);
  state->vtkglClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  drawSurfaces();
  this->Frame->RemoveDepthAttachment();
  this->Frame->RemoveColorAttachments(2);
  state->PopFramebufferBindings();
}

//----------------------------------------------------------------------------
void LightingQuad::Draw(vtkRenderer* renderer, const Lighting& light)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  if (!this->Quad)
  {
    std::string source = LandscapeQuad;
    vtkShaderProgram::Substitute(source, "//VTK::Landscape::Dec", LandscapeLight);
    this->Quad = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, source.c_str(), "");
  }
  else
  {
    window->GetShaderCache()->ReadyShaderProgram(this->Quad->Program);
  }
  vtkShaderProgram* program = this->Quad->Program;
  if (!program || !program->GetCompiled())
  {
    return;
  }
  light.SetUniforms(program);
  vtkTextureObject* const pictures[] = { this->Albedo, this->Surface, this->Depth };
  const char* const names[] = { "landscapeAlbedo", "landscapeSurface", "landscapeDepth" };
  for (int picture = 0; picture < 3; ++picture)
  {
    pictures[picture]->Activate();
    SetUniform(program, names[picture], pictures[picture]->GetTextureUnit());
  }
  const glm::dmat4 projection =
    MatrixOf(renderer->GetActiveCamera()->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0));
  SetUniform(program, "landscapeToView", glm::inverse(projection));
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglDepthFunc depth(state);
  vtkOpenGLState::ScopedglDepthMask mask(state);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglDisable(GL_BLEND);
  this->Quad->Render();
  for (vtkTextureObject* picture : pictures)
  {
    picture->Deactivate();
  }
}

//----------------------------------------------------------------------------
void LightingQuad::ReleaseGraphicsResources(vtkWindow* window)
{
  for (auto* picture : { &this->Albedo, &this->Surface, &this->Depth })
  {
    if (*picture)
    {
      (*picture)->ReleaseGraphicsResources(window);
    }
    *picture = nullptr;
  }
  this->Frame->ReleaseGraphicsResources(window);
  if (this->Quad)
  {
    this->Quad->ReleaseGraphicsResources(window);
    this->Quad.reset();
  }
}

}
