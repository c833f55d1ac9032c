// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SecondSampler.h"

#include "OpenGL.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureObject.h"
#include "vtkTextureUnitManager.h"

namespace littoral
{

//----------------------------------------------------------------------------
SecondSampler::SecondSampler() = default;
SecondSampler::~SecondSampler() = default;

//----------------------------------------------------------------------------
void SecondSampler::Activate(vtkOpenGLRenderWindow* window, vtkTextureObject* texture)
{
  // OpenGL 3.3 or ARB_sampler_objects
  if (!glGenSamplers || !glBindSampler)
  {
    return;
  }
  this->Unit = window->GetState()->GetTextureUnitManager()->Allocate();
  if (this->Unit < 0)
  {
    return;
  }
  this->Window = window;
  if (this->Sampler == 0)
  {
    glGenSamplers(1, &this->Sampler);
    glSamplerParameteri(this->Sampler, GL_TEXTURE_COMPARE_MODE, GL_NONE);
    glSamplerParameteri(this->Sampler, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glSamplerParameteri(this->Sampler, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glSamplerParameteri(this->Sampler, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glSamplerParameteri(this->Sampler, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  }
  window->GetState()->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned int>(this->Unit));
  glBindTexture(GL_TEXTURE_2D, texture->GetHandle());
  glBindSampler(static_cast<unsigned int>(this->Unit), this->Sampler);
}

//----------------------------------------------------------------------------
void SecondSampler::Deactivate()
{
  if (!this->Window)
  {
    return;
  }
  this->Window->GetState()->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned int>(this->Unit));
  glBindTexture(GL_TEXTURE_2D, 0);
  glBindSampler(static_cast<unsigned int>(this->Unit), 0);
  this->Window->GetState()->GetTextureUnitManager()->Free(this->Unit);
  this->Window = nullptr;
  this->Unit = -1;
}

//----------------------------------------------------------------------------
void SecondSampler::ReleaseGraphicsResources(vtkWindow*)
{
  if (this->Sampler != 0)
  {
    glDeleteSamplers(1, &this->Sampler);
    this->Sampler = 0;
  }
}

}
