// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ContactShade.h"

#include "LandscapeContact.h"
#include "OpenGL.h"
#include "Uniforms.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <string>
#include <vector>

namespace littoral
{

namespace
{

constexpr int WaysPart = 0;
constexpr int HiddenPart = 1;

vtkSmartPointer<vtkTextureObject> NewPicture(vtkOpenGLRenderWindow* window, int width, int height, int parts)
{
  auto texture = vtkSmartPointer<vtkTextureObject>::New();
  texture->SetContext(window);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  texture->Allocate2D(static_cast<unsigned int>(width), static_cast<unsigned int>(height), parts, VTK_FLOAT);
  return texture;
}

/// x and y of the place of texture coordinates t, at a distance of 1, as xy + zw t.
glm::dvec4 RaysOf(const ContactShade::View& view)
{
  const auto at = [&](double x) {
    const glm::dvec4 place = view.ToView * glm::dvec4(x, x, 0.0, 1.0);
    return glm::dvec2(place) / (view.IsParallel ? place.w : -place.z);
  };
  return { at(-1.0), at(1.0) - at(-1.0) };
}

}

//----------------------------------------------------------------------------
ContactShade::ContactShade() = default;
ContactShade::~ContactShade() = default;

//----------------------------------------------------------------------------
void ContactShade::Allocate(vtkOpenGLRenderWindow* window, int width, int height)
{
  if (!this->Ways || this->Width != width || this->Height != height)
  {
    this->Width = width;
    this->Height = height;
    this->Ways = NewPicture(window, width, height, 1);
    this->Hidden = NewPicture(window, width, height, 4);
  }
}

//----------------------------------------------------------------------------
void ContactShade::TakeWays(
  vtkOpenGLRenderWindow* window, vtkTextureObject* surface, vtkTextureObject* depth, const View& view)
{
  this->Allocate(window, static_cast<int>(surface->GetWidth()), static_cast<int>(surface->GetHeight()));
  this->DrawPart(WaysPart, window, this->Ways, { nullptr, surface, depth }, view);
}

//----------------------------------------------------------------------------
void ContactShade::Draw(vtkOpenGLRenderWindow* window, vtkTextureObject* surface, const View& view)
{
  this->DrawPart(HiddenPart, window, this->Hidden, { this->Ways, surface, nullptr }, view);
}

//----------------------------------------------------------------------------
void ContactShade::TakeNearest(vtkMultiProcessController* processes)
{
  const auto count = static_cast<std::size_t>(this->Width) * this->Height;
  std::vector<float> own(count);
  std::vector<float> nearest(count);
  this->Ways->Activate();
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RED, GL_FLOAT, own.data());
  processes->AllReduce(own.data(), nearest.data(), static_cast<vtkIdType>(count), vtkCommunicator::MIN_OP);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, this->Width, this->Height, GL_RED, GL_FLOAT, nearest.data());
  this->Ways->Deactivate();
}

//----------------------------------------------------------------------------
void ContactShade::DrawPart(int part, vtkOpenGLRenderWindow* window, vtkTextureObject* target,
  const std::array<vtkTextureObject*, 3>& pictures, const View& view)
{
  auto& quad = this->Quads[part];
  if (!quad)
  {
    const std::string source = "#define ContactPart " + std::to_string(part) + "\n";
    std::string shader = LandscapeContact;
    vtkShaderProgram::Substitute(shader, "//VTK::System::Dec", "//VTK::System::Dec\n" + source);
    quad = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, shader.c_str(), "");
  }
  else
  {
    window->GetShaderCache()->ReadyShaderProgram(quad->Program);
  }
  vtkShaderProgram* program = quad->Program;
  if (!program || !program->GetCompiled())
  {
    return;
  }
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  state->PushFramebufferBindings();
  this->Frame->SetContext(window);
  this->Frame->Bind();
  this->Frame->AddColorAttachment(0, target);
  this->Frame->ActivateDrawBuffers(1);
  state->vtkglViewport(0, 0, this->Width, this->Height);
  state->vtkglScissor(0, 0, this->Width, this->Height);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_BLEND);
  const char* const names[] = { "contactWays", "contactSurface", "contactDepth" };
  for (int picture = 0; picture < 3; ++picture)
  {
    if (pictures[picture])
    {
      pictures[picture]->Activate();
      SetUniform(program, names[picture], pictures[picture]->GetTextureUnit());
    }
  }
  SetUniform(program, "contactToView", view.ToView);
  SetUniform(program, "contactRays", RaysOf(view));
  SetUniform(program, "contactIsParallel", view.IsParallel ? 1 : 0);
  SetUniform(program, "contactToWorld", view.ToWorld);
  SetUniform(program, "contactRadius", view.Radius);
  SetUniform(program, "contactCounts", glm::dvec2(view.Counts));
  quad->Render();
  for (vtkTextureObject* picture : pictures)
  {
    if (picture)
    {
      picture->Deactivate();
    }
  }
  this->Frame->RemoveColorAttachment(0);
  state->PopFramebufferBindings();
}

//----------------------------------------------------------------------------
void ContactShade::ReleaseGraphicsResources(vtkWindow* window)
{
  for (auto* picture : { &this->Ways, &this->Hidden })
  {
    if (*picture)
    {
      (*picture)->ReleaseGraphicsResources(window);
    }
    *picture = nullptr;
  }
  for (auto& quad : this->Quads)
  {
    quad.reset();
  }
  this->Frame->ReleaseGraphicsResources(window);
}

}
