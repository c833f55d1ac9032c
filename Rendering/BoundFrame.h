// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralBoundFrame_h
#define LittoralBoundFrame_h

#include "vtkOpenGLState.h"

#include <vector>

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkTextureObject;

namespace littoral
{

/**
 * Textures that are drawn into while this lives: all of their pixels, without blending, with a test of depths if there
 * is a texture of depths. Afterwards frame and state are those from before.
 */
class BoundFrame
{
public:
  /// Textures of colors, of one size, and of depths; null: there is none.
  BoundFrame(vtkOpenGLRenderWindow* window, vtkOpenGLFramebufferObject* frame,
    const std::vector<vtkTextureObject*>& colors, vtkTextureObject* depths);
  ~BoundFrame();
  BoundFrame(const BoundFrame&) = delete;
  BoundFrame& operator=(const BoundFrame&) = delete;

  /// Draws into a square of the textures alone.
  void SetSquare(int column, int row, int side);
  /// Makes all depths the farthest, and all colors r 0 b 0 with this b.
  void Clear(double blue);

private:
  vtkOpenGLState* State;
  vtkOpenGLState::ScopedglViewport Viewport;
  vtkOpenGLState::ScopedglScissor Scissor;
  vtkOpenGLState::ScopedglClearColor ClearColor;
  vtkOpenGLState::ScopedglDepthMask DepthMask;
  vtkOpenGLState::ScopedglEnableDisable DepthTest;
  vtkOpenGLState::ScopedglEnableDisable Blend;
  vtkOpenGLState::ScopedglEnableDisable ScissorTest;
  vtkOpenGLFramebufferObject* Frame;
  unsigned int Colors;
  bool HasDepths;
};

}

#endif
