// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPictureShader_h
#define LittoralPictureShader_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <initializer_list>
#include <memory>
#include <string>
#include <utility>
#include <vector>

class vtkOpenGLFramebufferObject;
class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace littoral
{

/// A shader that makes a picture of numbers from others.
class PictureShader
{
public:
  /// A source, with what is defined in it.
  PictureShader(const char* source, const std::string& defined);
  ~PictureShader();

  /// A picture without a filter, with a number of channels.
  static vtkSmartPointer<vtkTextureObject> NewPicture(vtkOpenGLRenderWindow* window, int width, int height, int parts);

  /// Gives back what pictures, of which some may be null, have of a window, and makes them null.
  static void Release(std::initializer_list<vtkSmartPointer<vtkTextureObject>*> pictures, vtkWindow* window);

  using Inputs = std::vector<std::pair<const char*, vtkTextureObject*>>;

  /// Fills a picture, from others by the names of their uniforms, and by uniforms that a function sets.
  void Draw(vtkOpenGLRenderWindow* window, vtkTextureObject* target, const Inputs& inputs,
    const std::function<void(vtkShaderProgram*)>& setUniforms);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkShaderProgram* Ready(vtkOpenGLRenderWindow* window);

  std::string Source;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
  vtkNew<vtkOpenGLFramebufferObject> Frame;
};

}

#endif
