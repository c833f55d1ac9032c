// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PictureShader.h"

#include "BoundFrame.h"
#include "Uniforms.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
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
  const BoundFrame bound(window, this->Frame, { target }, nullptr);
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
}

//----------------------------------------------------------------------------
void PictureShader::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Quad.reset();
  this->Frame->ReleaseGraphicsResources(window);
}

}
