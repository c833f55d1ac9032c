// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "GroundCoverMapper.h"

#include "OpenGL.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkPolyData.h"
#include "vtkShaderProgram.h"

#include <cstdint>
#include <utility>

namespace littoral
{

vtkStandardNewMacro(GroundCoverMapper);

//----------------------------------------------------------------------------
void GroundCoverMapper::SetRuns(std::vector<Run> runs)
{
  this->Runs = std::move(runs);
}

//----------------------------------------------------------------------------
void GroundCoverMapper::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor)
{
  vtkOpenGLHelper& strips = this->Primitives[PrimitiveTriStrips];
  if (this->Runs.empty() || strips.IBO->IndexCount == 0)
  {
    return;
  }
  this->DrawingVertices = false;
  this->UpdateShaders(strips, renderer, actor);
  if (!strips.Program)
  {
    return;
  }
  // VTK has the strips as triangles.
  const auto each = static_cast<int>(strips.IBO->IndexCount) / static_cast<int>(this->GetInput()->GetNumberOfStrips());
  strips.IBO->Bind();
  for (const Run& run : this->Runs)
  {
    const auto offset = static_cast<std::uintptr_t>(run.From * each) * sizeof(GLuint);
    glDrawElements(GL_TRIANGLES, (run.To - run.From) * each, GL_UNSIGNED_INT, reinterpret_cast<const GLvoid*>(offset));
  }
  strips.IBO->Release();
}

}
