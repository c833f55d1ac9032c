// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "GroundCoverMapper.h"

#include "OpenGL.h"
#include "PartsInTurn.h"
#include "vtkLandscapePass.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
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
void GroundCoverMapper::SetMaker(Maker maker)
{
  this->MakeStrips = std::move(maker);
  this->SetInputData(this->MakeStrips());
}

//----------------------------------------------------------------------------
/// Bounds of all strips, which stay when these are dropped.
void GroundCoverMapper::ComputeBounds()
{
  if (this->GetInput()->GetNumberOfStrips() > 0)
  {
    this->GetInput()->GetPoints()->GetBounds(this->Bounds);
  }
}

//----------------------------------------------------------------------------
void GroundCoverMapper::BuildBufferObjects(vtkRenderer* renderer, vtkActor* actor)
{
  vtkPolyData* strips = this->GetInput();
  if (strips->GetNumberOfStrips() == 0)
  {
    strips->ShallowCopy(this->MakeStrips());
  }
  this->Superclass::BuildBufferObjects(renderer, actor);
  // VTK has the strips as triangles.
  this->Indexed = static_cast<int>(strips->GetNumberOfStrips());
  this->PointsOfStrip = static_cast<int>(strips->GetStrips()->GetNumberOfConnectivityIds()) / this->Indexed;
  this->CornersOfStrip = static_cast<int>(this->Primitives[PrimitiveTriStrips].IBO->IndexCount) / this->Indexed;
  this->DropStrips();
  // What was sent is as new as what is left: VTK takes note of its time when it is asked.
  this->VBOBuildTime.Modified();
  this->GetNeedToRebuildBufferObjects(renderer, actor);
}

//----------------------------------------------------------------------------
/// Leaves a point, without which VTK draws nothing, and its values.
void GroundCoverMapper::DropStrips()
{
  vtkPolyData* strips = this->GetInput();
  strips->GetPoints()->GetData()->Resize(1);
  for (int index = 0; index < strips->GetPointData()->GetNumberOfArrays(); ++index)
  {
    strips->GetPointData()->GetAbstractArray(index)->Resize(1);
  }
  strips->SetStrips(vtkNew<vtkCellArray>());
  if (this->Colors)
  {
    this->Colors->Resize(1);
  }
  if (vtkOpenGLVertexBufferObject* sent = this->VBOs->GetVBO("scalarColor"))
  {
    std::vector<float>().swap(sent->GetPackedVBO());
  }
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
  const bool areInTurn = vtkLandscapePass::IsDrawnBySoftware(renderer->GetRenderWindow());
  PartsInTurn parts;
  strips.IBO->Bind();
  for (const Run& run : this->Runs)
  {
    for (int from = run.From; from < run.To; from += this->Indexed)
    {
      const int corners = this->CornersOfStrip * std::min(this->Indexed, run.To - from);
      glDrawElementsBaseVertex(GL_TRIANGLES, corners, GL_UNSIGNED_INT, nullptr, this->PointsOfStrip * from);
      if (areInTurn)
      {
        parts.End();
      }
    }
  }
  strips.IBO->Release();
}

}
