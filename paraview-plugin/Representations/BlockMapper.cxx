// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BlockMapper.h"

#include "vtkHardwareSelector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <vector>

namespace littoral
{

vtkStandardNewMacro(BlockMapper);

//----------------------------------------------------------------------------
vtkUnsignedCharArray* BlockMapper::MapScalars(vtkDataSet* input, double alpha, int& cellFlag)
{
  int association = 0;
  vtkAbstractArray* array =
    GetAbstractScalars(input, this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, association);
  const bool areColors = this->ScalarVisibility && this->ColorMode == VTK_COLOR_MODE_DIRECT_SCALARS &&
    vtkUnsignedCharArray::SafeDownCast(array);
  const vtkMTimeType time = array ? array->GetMTime() : 0;
  if (areColors && this->Colors && !this->ColorTextureMap && this->Colored.Time == time && this->Colored.Alpha == alpha)
  {
    cellFlag = association;
    return this->Colors;
  }
  vtkUnsignedCharArray* colors = this->Superclass::MapScalars(input, alpha, cellFlag);
  this->Colored = areColors ? Source{ time, alpha } : Source{};
  return colors;
}

//----------------------------------------------------------------------------
/// Bounds of the points, which know them, and not of the points that cells use.
void BlockMapper::ComputeBounds()
{
  vtkPolyData* block = this->GetInput();
  vtkMath::UninitializeBounds(this->Bounds);
  if (block && block->GetNumberOfPoints() > 0)
  {
    block->GetPoints()->GetBounds(this->Bounds);
  }
}

//----------------------------------------------------------------------------
/// Drops vertices after they were sent, since the graphics' memory has them too: VTK would keep them.
void BlockMapper::BuildBufferObjects(vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::BuildBufferObjects(renderer, actor);
  for (const char* name : { "vertexMC", "normalMC", "scalarColor", "tcoord" })
  {
    if (vtkOpenGLVertexBufferObject* sent = this->VBOs->GetVBO(name))
    {
      std::vector<float>().swap(sent->GetPackedVBO());
    }
  }
}

//----------------------------------------------------------------------------
/// Indices of cells that are the same stay: VTK appends what they depend on to another state, which has the time of all
/// of the data in it.
void BlockMapper::BuildIBO(vtkRenderer* renderer, vtkActor* actor, vtkPolyData* block)
{
  this->TempState.Clear();
  this->Superclass::BuildIBO(renderer, actor, block);
}

//----------------------------------------------------------------------------
void BlockMapper::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor)
{
  if (vtkHardwareSelector* selector = renderer->GetSelector())
  {
    selector->RenderCompositeIndex(this->BlockIndex);
  }
  this->Superclass::RenderPieceDraw(renderer, actor);
}

}
