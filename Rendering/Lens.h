// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralLens_h
#define LittoralLens_h

#include "PictureShader.h"

#include "vtkSmartPointer.h"

class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

namespace littoral
{

/// Blur of what is not in focus, in linear light: each pixel gathers what spreads to it.
class Lens
{
public:
  struct View
  {
    double Blur = 0.0;  ///< radius over the difference of inverse distances [m pixels]
    double Focus = 1.0; ///< [m]
  };

  Lens();
  ~Lens();

  /// Draws what a lit picture, of luminances and distances, is behind the lens.
  void Draw(vtkOpenGLRenderWindow* window, vtkTextureObject* lit, const View& view);

  /// Picture of luminances and of the radius of blur [pixels of the lit picture]; null before Draw().
  vtkTextureObject* GetBlurred() const { return this->Blurred; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  PictureShader ToTiles;
  PictureShader ToBlurred;
  vtkSmartPointer<vtkTextureObject> Tiles;
  vtkSmartPointer<vtkTextureObject> Blurred;
  int Width = 0;
  int Height = 0;
};

}

#endif
