// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ContactShade.h"

#include "LandscapeContact.h"
#include "LandscapeUnfolded.h"
#include "NearestPixels.h"
#include "OpenGL.h"
#include "Uniforms.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <string>
#include <vector>

namespace littoral
{

namespace
{

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
ContactShade::ContactShade()
  : ToWays(LandscapeContact, std::string("#define ContactPart ContactWays\n") + LandscapeUnfolded)
  , ToHidden(LandscapeContact, std::string("#define ContactPart ContactHidden\n") + LandscapeUnfolded)
{
}

//----------------------------------------------------------------------------
ContactShade::~ContactShade() = default;

//----------------------------------------------------------------------------
void ContactShade::Allocate(vtkOpenGLRenderWindow* window, int width, int height)
{
  if (!this->Ways || this->Width != width || this->Height != height)
  {
    this->Width = width;
    this->Height = height;
    this->Ways = PictureShader::NewPicture(window, width, height, 1);
    this->Hidden = PictureShader::NewPicture(window, width, height, 4);
  }
}

//----------------------------------------------------------------------------
void ContactShade::Draw(vtkOpenGLRenderWindow* window, vtkTextureObject* surface, vtkTextureObject* depth,
  const View& view, vtkMultiProcessController* processes)
{
  const auto setUniforms = [&view](vtkShaderProgram* program) {
    SetUniform(program, "contactToView", view.ToView);
    SetUniform(program, "contactRays", RaysOf(view));
    SetUniform(program, "contactIsParallel", view.IsParallel ? 1 : 0);
    SetUniform(program, "contactToWorld", view.ToWorld);
    SetUniform(program, "contactRadius", view.Radius);
    SetUniform(program, "contactCounts", glm::dvec2(view.Counts));
    SetUniform(program, "contactStep", static_cast<double>(Step));
  };
  const auto part = [](unsigned int side) { return (static_cast<int>(side) + Step - 1) / Step; };
  this->Allocate(window, part(surface->GetWidth()), part(surface->GetHeight()));
  this->ToWays.Draw(window, this->Ways, { { "contactSurface", surface }, { "contactDepth", depth } }, setUniforms);
  if (processes)
  {
    this->TakeNearest(processes);
  }
  this->ToHidden.Draw(window, this->Hidden,
    { { "contactWays", this->Ways }, { "contactSurface", surface }, { "contactDepth", depth } }, setUniforms);
  if (processes)
  {
    TakeNearestPixels(this->Hidden, processes);
  }
}

//----------------------------------------------------------------------------
/// The least of the distances that the processes have.
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
void ContactShade::ReleaseGraphicsResources(vtkWindow* window)
{
  PictureShader::Release({ &this->Ways, &this->Hidden }, window);
  this->ToWays.ReleaseGraphicsResources(window);
  this->ToHidden.ReleaseGraphicsResources(window);
}

}
