// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BlockMapper.h"
#include "OpenGL.h"
#include "vtkLandscapePass.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkHardwareSelector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectCache.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace littoral
{

namespace
{

/// Corners of the triangles that are drawn before a processor is waited for. llvmpipe keeps all triangles that are
/// still to be drawn, at up to a kilobyte each.
constexpr GLsizei CornersOfPart = 3 << 15;

/// Waits until the commands before a fence are done, and deletes it.
void Pass(GLsync fence)
{
  constexpr GLuint64 second = 1000000000; // ns
  while (glClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT, second) == GL_TIMEOUT_EXPIRED)
  {
  }
  glDeleteSync(fence);
}

/// Draws triangles by parts, each of them while the one before is still drawn, but not more at a time.
void DrawTrianglesByParts(GLsizei corners)
{
  GLsync before = nullptr;
  for (GLsizei begin = 0; begin < corners; begin += CornersOfPart)
  {
    const auto offset = static_cast<std::uintptr_t>(begin) * sizeof(GLuint);
    glDrawElements(
      GL_TRIANGLES, std::min(CornersOfPart, corners - begin), GL_UNSIGNED_INT, reinterpret_cast<const GLvoid*>(offset));
    GLsync drawn = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    if (before)
    {
      Pass(before);
    }
    before = drawn;
  }
  Pass(before);
}

}

vtkStandardNewMacro(BlockMapper);

//----------------------------------------------------------------------------
bool BlockMapper::HasManyCells(vtkPolyData* surface)
{
  return 3 * surface->GetNumberOfPolys() > CornersOfPart;
}

//----------------------------------------------------------------------------
vtkUnsignedCharArray* BlockMapper::MapScalars(vtkDataSet* input, double alpha, int& cellFlag)
{
  int association = 0;
  vtkAbstractArray* array =
    GetAbstractScalars(input, this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, association);
  const bool areColors = this->ScalarVisibility && this->ColorMode == VTK_COLOR_MODE_DIRECT_SCALARS &&
    vtkUnsignedCharArray::SafeDownCast(array);
  const vtkMTimeType time = array ? array->GetMTime() : 0;
  const bool areDropped =
    this->Colors && this->Colored.Tuples > 0 && this->Colors->GetNumberOfTuples() != this->Colored.Tuples;
  // Others than the graphics, such as exporters, need all colors.
  const bool areSent = this->IsDrawing && this->VBOs->GetVBO("scalarColor");
  const bool areMade = this->Colors && (areSent || !areDropped);
  if (areColors && areMade && !this->ColorTextureMap && this->Colored.Time == time && this->Colored.Alpha == alpha)
  {
    cellFlag = association;
    return this->Colors;
  }
  if (areDropped)
  {
    this->Colors->UnRegister(this); // VTK takes those that it finds
    this->Colors = nullptr;
  }
  vtkUnsignedCharArray* colors = this->Superclass::MapScalars(input, alpha, cellFlag);
  this->Colored = areColors && colors ? Source{ time, alpha, colors->GetNumberOfTuples() } : Source{};
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
void BlockMapper::RenderPiece(vtkRenderer* renderer, vtkActor* actor)
{
  this->IsDrawing = true;
  this->Superclass::RenderPiece(renderer, actor);
  this->IsDrawing = false;
}

//----------------------------------------------------------------------------
/// Lets go of the vertices of the last picture before others are sent: what draws them holds them until it has the
/// others. Drops those that were sent, and their colors, since the graphics' memory has them too: VTK would keep them.
/// What is read where it is is not sent.
void BlockMapper::BuildBufferObjects(vtkRenderer* renderer, vtkActor* actor)
{
  for (vtkOpenGLHelper& primitive : this->Primitives)
  {
    primitive.VAO->ReleaseGraphicsResources();
    primitive.AttributeUpdateTime = vtkTimeStamp();
  }
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  std::vector<vtkSmartPointer<vtkOpenGLVertexBufferObject>> pinned; // until the mapper has those that it needs
  this->CanPin = PinnedArray::IsPossible(window);
  this->PointsInPlace = this->CanPin && this->TakePoints(renderer, actor);
  if (this->CanPin)
  {
    for (const Read& read : this->ReadInPlace())
    {
      pinned.push_back(read.Pinned.Pin(read.Array, window));
    }
  }
  this->Superclass::BuildBufferObjects(renderer, actor);
  for (const char* name : { "vertexMC", "normalMC", "scalarColor", "tcoord" })
  {
    if (vtkOpenGLVertexBufferObject* sent = this->VBOs->GetVBO(name))
    {
      std::vector<float>().swap(sent->GetPackedVBO());
    }
  }
  if (this->Colored.Tuples > 0 && !this->HaveCellScalars && this->VBOs->GetVBO("scalarColor"))
  {
    this->Colors->Resize(1); // VTK takes none for no colors
  }
}

//----------------------------------------------------------------------------
/// Indices of cells that are the same stay: VTK appends what they depend on to another state, which has the time of all
/// of the data in it.
void BlockMapper::BuildIBO(vtkRenderer* renderer, vtkActor* actor, vtkPolyData* block)
{
  this->TempState.Clear();
  this->Superclass::BuildIBO(renderer, actor, block);
  this->PinCorners(actor, block);
}

//----------------------------------------------------------------------------
/// Where VTK has sent the numbers of triangles as they are, has them read in place.
void BlockMapper::PinCorners(vtkActor* actor, vtkPolyData* block)
{
  this->Corners = nullptr;
  vtkCellArray* triangles = block->GetPolys();
  vtkOpenGLIndexBufferObject* sent = this->Primitives[PrimitiveTris].IBO;
  vtkDataArray* corners = triangles->GetConnectivityArray();
  const bool isSame = actor->GetProperty()->GetRepresentation() == VTK_SURFACE &&
    corners->GetDataTypeSize() == sizeof(GLuint) && corners->GetNumberOfValues() > 0 &&
    corners->GetNumberOfValues() == 3 * triangles->GetNumberOfCells() &&
    static_cast<vtkIdType>(sent->IndexCount) == corners->GetNumberOfValues(); // there is no triangle without an area
  if (this->CanPin && isSame && PinnedArray::ReadBy(sent, corners))
  {
    this->Corners = corners;
    this->PinnedCorners = corners->GetVoidPointer(0);
  }
}

//----------------------------------------------------------------------------
/// Whether VTK would send the points as they are; their buffer takes what the mapper will set, so that VTK finds
/// nothing changed.
bool BlockMapper::TakePoints(vtkRenderer* renderer, vtkActor* actor)
{
  auto* points = vtkFloatArray::SafeDownCast(this->CurrentInput->GetPoints()->GetData());
  if (!points || points->GetNumberOfTuples() == 0 ||
    this->ShiftScaleMethod != vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE)
  {
    return false;
  }
  vtkOpenGLVertexBufferObjectCache* cache =
    vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow())->GetVBOCache();
  const auto buffer = vtkSmartPointer<vtkOpenGLVertexBufferObject>::Take(cache->GetVBO(points, VTK_FLOAT));
  if (buffer->GetCoordShiftAndScaleEnabled())
  {
    return false; // another mapper shifts them
  }
  buffer->SetCoordShiftAndScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
  buffer->SetProp3D(actor);
  buffer->SetCamera(renderer->GetActiveCamera());
  return true;
}

//----------------------------------------------------------------------------
std::array<BlockMapper::Read, 3> BlockMapper::ReadInPlace()
{
  vtkPointData* arrays = this->CurrentInput->GetPointData();
  return { Read{ "vertexMC", this->PointsInPlace ? this->CurrentInput->GetPoints()->GetData() : nullptr,
             this->PinnedPoints },
    Read{ "normalMC", arrays->GetNormals(), this->PinnedNormals },
    Read{ "tcoord", arrays->GetTCoords(), this->PinnedTCoords } };
}

//----------------------------------------------------------------------------
/// Reads no memory that an array has left, also where nobody has told that the array has changed.
void BlockMapper::FollowMemory(vtkRenderer* renderer)
{
  if (this->Corners && this->Corners->GetVoidPointer(0) != this->PinnedCorners)
  {
    PinnedArray::ReadBy(this->Primitives[PrimitiveTris].IBO, this->Corners);
    this->PinnedCorners = this->Corners->GetVoidPointer(0);
  }
  for (const Read& read : this->ReadInPlace())
  {
    if (read.Pinned.HasMoved(read.Array, this->VBOs->GetVBO(read.Attribute)))
    {
      read.Pinned.Pin(read.Array, vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()));
    }
  }
}

//----------------------------------------------------------------------------
/// Many triangles and nothing else, whose numbers the shader does not ask for, drawn by a processor.
bool BlockMapper::IsDrawnByParts(vtkRenderer* renderer, vtkActor* actor) const
{
  const auto count = [this](int primitive) { return this->Primitives[primitive].IBO->IndexCount; };
  vtkProperty* property = actor->GetProperty();
  return count(PrimitiveTris) > CornersOfPart && count(PrimitivePoints) + count(PrimitiveLines) == 0 &&
    count(PrimitiveTriStrips) == 0 && !this->HaveCellScalars && !this->HaveCellNormals && !renderer->GetSelector() &&
    property->GetRepresentation() == VTK_SURFACE && !property->GetEdgeVisibility() &&
    !property->GetVertexVisibility() && vtkLandscapePass::IsDrawnBySoftware(renderer->GetRenderWindow());
}

//----------------------------------------------------------------------------
void BlockMapper::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor)
{
  if (vtkHardwareSelector* selector = renderer->GetSelector())
  {
    selector->RenderCompositeIndex(this->BlockIndex);
  }
  this->FollowMemory(renderer);
  if (!this->IsDrawnByParts(renderer, actor))
  {
    this->Superclass::RenderPieceDraw(renderer, actor);
    return;
  }
  vtkOpenGLHelper& triangles = this->Primitives[PrimitiveTris];
  this->DrawingVertices = false;
  this->DrawingSelection = false;
  this->UpdateShaders(triangles, renderer, actor);
  if (triangles.Program)
  {
    triangles.IBO->Bind();
    DrawTrianglesByParts(static_cast<GLsizei>(triangles.IBO->IndexCount));
    triangles.IBO->Release();
  }
}

}
