// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralContactShade_h
#define LittoralContactShade_h

#include "PictureShader.h"

#include "vtkSmartPointer.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

class vtkMultiProcessController;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace littoral
{

/**
 * Shade where things meet: the part of the sky that surfaces within a short distance hide from each other, by the
 * depths of a picture (Bavoil, Sainz and Dimitrov 2008; Jimenez, Wu, Pesce and Jarabo 2016).
 */
class ContactShade
{
public:
  struct View
  {
    glm::dmat4 ToView = glm::dmat4(1.0); ///< from clip coordinates
    glm::dmat3 ToWorld = glm::dmat3(1.0);
    bool IsParallel = false;
    double Radius = 0.0; ///< [m]
    glm::ivec2 Counts;   ///< slices, and taps on each of their sides
  };

  /// Pixels of the picture, along its sides, from one whose shade is found to the next.
  static constexpr int Step = 2;

  ContactShade();
  ~ContactShade();

  /// Draws what hides the sky from the surfaces of a picture (SurfacePass): from the nearest of all processes, if any
  /// are given, which do so together.
  void Draw(vtkOpenGLRenderWindow* window, vtkTextureObject* surface, vtkTextureObject* depth, const View& view,
    vtkMultiProcessController* processes);

  /// Texture of the part that is hidden, the sum of its directions to the east and to the north, and the distance along
  /// the view's axis; null before Draw().
  vtkTextureObject* GetHidden() const { return this->Hidden; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  void Allocate(vtkOpenGLRenderWindow* window, int width, int height);
  void TakeNearest(vtkMultiProcessController* processes);

  PictureShader ToWays;
  PictureShader ToHidden;
  vtkSmartPointer<vtkTextureObject> Ways;
  vtkSmartPointer<vtkTextureObject> Hidden;
  int Width = 0;
  int Height = 0;
};

}

#endif
