// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BoundFrame.h"

#include "OpenGL.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

namespace littoral
{

//----------------------------------------------------------------------------
BoundFrame::BoundFrame(vtkOpenGLRenderWindow* window, vtkOpenGLFramebufferObject* frame,
  const std::vector<vtkTextureObject*>& colors, vtkTextureObject* depths)
  : State(window->GetState())
  , Viewport(State)
  , Scissor(State)
  , ClearColor(State)
  , DepthMask(State)
  , DepthTest(State, GL_DEPTH_TEST)
  , Blend(State, GL_BLEND)
  , ScissorTest(State, GL_SCISSOR_TEST)
  , Frame(frame)
  , Colors(static_cast<unsigned int>(colors.size()))
  , HasDepths(depths != nullptr)
{
  this->State->PushFramebufferBindings();
  frame->SetContext(window);
  frame->Bind();
  for (unsigned int k = 0; k < this->Colors; ++k)
  {
    frame->AddColorAttachment(k, colors[k]);
  }
  if (depths)
  {
    frame->AddDepthAttachment(depths);
  }
  frame->DeactivateDrawBuffers(); // else VTK takes those of the frame that was bound before for its own
  if (this->Colors > 0)
  {
    frame->ActivateDrawBuffers(this->Colors);
  }
  vtkTextureObject* any = depths ? depths : colors.front();
  const auto width = static_cast<int>(any->GetWidth());
  const auto height = static_cast<int>(any->GetHeight());
  this->State->vtkglViewport(0, 0, width, height);
  this->State->vtkglScissor(0, 0, width, height);
  this->State->vtkglDisable(GL_BLEND);
  depths ? this->State->vtkglEnable(GL_DEPTH_TEST) : this->State->vtkglDisable(GL_DEPTH_TEST);
  this->State->vtkglDepthMask(GL_TRUE);
}

//----------------------------------------------------------------------------
BoundFrame::~BoundFrame()
{
  if (this->HasDepths)
  {
    this->Frame->RemoveDepthAttachment();
  }
  this->Frame->RemoveColorAttachments(this->Colors);
  this->State->PopFramebufferBindings();
}

//----------------------------------------------------------------------------
void BoundFrame::SetSquare(int column, int row, int side)
{
  this->State->vtkglViewport(column, row, side, side);
  this->State->vtkglScissor(column, row, side, side);
  this->State->vtkglEnable(GL_SCISSOR_TEST);
}

//----------------------------------------------------------------------------
void BoundFrame::Clear(double blue)
{
  this->State->vtkglClearDepth(1.0);
  this->State->vtkglClearColor(0.0F, 0.0F, static_cast<float>(blue), 0.0F);
  this->State->vtkglClear((this->Colors > 0 ? GL_COLOR_BUFFER_BIT : 0) | GL_DEPTH_BUFFER_BIT);
}

}
