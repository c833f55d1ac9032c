// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PictureShader.h"

#include "OpenGL.h"
#include "Uniforms.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

namespace littoral
{

//----------------------------------------------------------------------------
PictureShader::PictureShader(const char* source, const std::string& defined)
  : Source(source)
{
  vtkShaderProgram::Substitute(this->Source, "//VTK::System::Dec", "//VTK::System::Dec\n" + defined);
}

//----------------------------------------------------------------------------
PictureShader::~PictureShader() = default;

//----------------------------------------------------------------------------
vtkSmartPointer<vtkTextureObject> PictureShader::NewPicture(
  vtkOpenGLRenderWindow* window, int width, int height, int parts)
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

//----------------------------------------------------------------------------
void PictureShader::Release(std::initializer_list<vtkSmartPointer<vtkTextureObject>*> pictures, vtkWindow* window)
{
  for (auto* picture : pictures)
  {
    if (*picture)
    {
      (*picture)->ReleaseGraphicsResources(window);
    }
    *picture = nullptr;
  }
}

//----------------------------------------------------------------------------
/// The program; null if it does not compile.
vtkShaderProgram* PictureShader::Ready(vtkOpenGLRenderWindow* window)
{
  if (!this->Quad)
  {
    this->Quad = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, this->Source.c_str(), "");
  }
  else
  {
    window->GetShaderCache()->ReadyShaderProgram(this->Quad->Program);
  }
  vtkShaderProgram* program = this->Quad->Program;
  return program && program->GetCompiled() ? program : nullptr;
}

//----------------------------------------------------------------------------
void PictureShader::Draw(vtkOpenGLRenderWindow* window, vtkTextureObject* target, const Inputs& inputs,
  const std::function<void(vtkShaderProgram*)>& setUniforms)
{
  vtkShaderProgram* program = this->Ready(window);
  if (!program)
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
  const auto width = static_cast<int>(target->GetWidth());
  const auto height = static_cast<int>(target->GetHeight());
  state->vtkglViewport(0, 0, width, height);
  state->vtkglScissor(0, 0, width, height);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_BLEND);
  for (const auto& [name, picture] : inputs)
  {
    picture->Activate();
    SetUniform(program, name, picture->GetTextureUnit());
  }
  setUniforms(program);
  this->Quad->Render();
  for (const auto& input : inputs)
  {
    input.second->Deactivate();
  }
  this->Frame->RemoveColorAttachment(0);
  state->PopFramebufferBindings();
}

//----------------------------------------------------------------------------
void PictureShader::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Quad.reset();
  this->Frame->ReleaseGraphicsResources(window);
}

}
