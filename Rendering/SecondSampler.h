// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSecondSampler_h
#define LittoralSecondSampler_h

#include "vtkSmartPointer.h"

class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

namespace littoral
{

/// Lets shaders read the depths of a texture that compares with them: by a second unit, with a sampler that does not.
class SecondSampler
{
public:
  SecondSampler();
  ~SecondSampler();

  /// Binds a texture to a second unit, if OpenGL has samplers and a unit is free.
  void Activate(vtkOpenGLRenderWindow* window, vtkTextureObject* texture);
  void Deactivate();

  bool IsOn() const { return this->Unit >= 0; }
  int GetUnit() const { return this->Unit; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkSmartPointer<vtkOpenGLRenderWindow> Window; ///< between Activate() and Deactivate()
  unsigned int Sampler = 0;
  int Unit = -1;
};

}

#endif
