// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BlockMapper.h"
#include "OpenGL.h"
#include "PartsInTurn.h"
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

/// Corners of the triangles of a part.
constexpr std::size_t CornersOfPart = 3 << 15;

/// Draws triangles by parts in turn. Numbers of corners go on from part to part, or each part has the first ones and
/// its points after those of the part before.
void DrawTrianglesByParts(std::size_t corners, int pointsOfPart)
{
  PartsInTurn parts;
  for (std::size_t begin = 0, part = 0; begin < corners; begin += CornersOfPart, ++part)
  {
    const std::uintptr_t offset = pointsOfPart > 0 ? 0 : begin * sizeof(GLuint);
    glDrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(std::min(CornersOfPart, corners - begin)),
      GL_UNSIGNED_INT, reinterpret_cast<const GLvoid*>(offset), static_cast<GLint>(part) * pointsOfPart);
    parts.End();
  }
}

/// Whether each cell has the next points, as many as any other one.
template <typename Number>
bool AreInOrder(const Number* corners, vtkIdType count)
{
  vtkIdType next = 0;
  return std::all_of(corners, corners + count, [&next](Number corner) { return corner == next++; });
}

/// The corners of triangles of a part of cells with so many points each, the next ones.
std::vector<GLuint> CornersOfFirst(int pointsOfCell)
{
  std::vector<GLuint> corners;
  for (GLuint first = 0; corners.size() < CornersOfPart; first += static_cast<GLuint>(pointsOfCell))
  {
    for (GLuint n = 2; n < static_cast<GLuint>(pointsOfCell); ++n)
    {
      corners.insert(corners.end(), { first, first + n - 1, first + n });
    }
  }
  return corners;
}

}

vtkStandardNewMacro(BlockMapper);

//----------------------------------------------------------------------------
bool BlockMapper::HasManyCells(vtkPolyData* surface)
{
  return 3 * surface->GetNumberOfPolys() > static_cast<vtkIdType>(CornersOfPart);
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
void BlockMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Own = Corners();
  this->Superclass::ReleaseGraphicsResources(window);
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
  this->TakeCorners(actor, block);
}

//----------------------------------------------------------------------------
/// Drops what VTK has sent for many triangles, where they can be drawn without it.
void BlockMapper::TakeCorners(vtkActor* actor, vtkPolyData* block)
{
  vtkOpenGLIndexBufferObject* sent = this->Primitives[PrimitiveTris].IBO;
  vtkCellArray* cells = block->GetPolys();
  const bool areMany =
    this->CanPin && sent->IndexCount > CornersOfPart && actor->GetProperty()->GetRepresentation() == VTK_SURFACE;
  const bool areSame = areMany && this->Own.Time > 0 && this->Own.Time == cells->GetMTime();
  if (!areMany || (!areSame && !this->FillCorners(cells)))
  {
    this->Own = Corners();
    return;
  }
  this->Own.Time = cells->GetMTime();
  sent->ReleaseGraphicsResources();
}

//----------------------------------------------------------------------------
/// Sends what cells are drawn by, or has it read in place. VTK leaves out triangles without an area, which draw
/// nothing.
bool BlockMapper::FillCorners(vtkCellArray* cells)
{
  vtkDataArray* array = cells->GetConnectivityArray();
  const vtkIdType count = array->GetNumberOfValues();
  const vtkIdType pointsOfCell = cells->IsHomogeneous();
  const bool areTriangles = pointsOfCell == 3 && array->GetDataTypeSize() == sizeof(GLuint);
  const auto trianglesOfPart = static_cast<vtkIdType>(CornersOfPart / 3);
  this->Own = Corners();
  this->Own.Sent = vtkSmartPointer<vtkOpenGLIndexBufferObject>::New();
  if (areTriangles)
  {
    this->Own.Array = array;
    this->Own.Memory = array->GetVoidPointer(0);
    this->Own.Count = static_cast<std::size_t>(count);
    this->Own.Sent->GenerateBuffer(vtkOpenGLBufferObject::ElementArrayBuffer);
    return PinnedArray::ReadBy(this->Own.Sent, array);
  }
  const bool areInOrder = pointsOfCell >= 3 && trianglesOfPart % (pointsOfCell - 2) == 0 &&
    (array->GetDataTypeSize() == sizeof(vtkTypeInt64)
        ? AreInOrder(static_cast<const vtkTypeInt64*>(array->GetVoidPointer(0)), count)
        : AreInOrder(static_cast<const vtkTypeInt32*>(array->GetVoidPointer(0)), count));
  if (!areInOrder)
  {
    return false;
  }
  this->Own.Count = static_cast<std::size_t>(3 * (pointsOfCell - 2) * cells->GetNumberOfCells());
  this->Own.PointsOfPart = static_cast<int>(trianglesOfPart / (pointsOfCell - 2) * pointsOfCell);
  return this->Own.Sent->Upload(
    CornersOfFirst(static_cast<int>(pointsOfCell)), vtkOpenGLBufferObject::ElementArrayBuffer);
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
  if (this->Own.Array && this->Own.Array->GetVoidPointer(0) != this->Own.Memory)
  {
    this->Own.Memory = this->Own.Array->GetVoidPointer(0);
    PinnedArray::ReadBy(this->Own.Sent, this->Own.Array);
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
  if (this->IsDrawnByParts(renderer, actor))
  {
    this->DrawingVertices = false;
    this->DrawingSelection = false;
    this->UpdateShaders(this->Primitives[PrimitiveTris], renderer, actor);
    this->DrawByParts();
    return;
  }
  if (this->Own.Sent)
  {
    this->Own = Corners();
    this->IBOBuildState.Clear();
    this->TempState.Clear();
    this->Superclass::BuildIBO(renderer, actor, this->CurrentInput);
  }
  this->Superclass::RenderPieceDraw(renderer, actor);
}

//----------------------------------------------------------------------------
void BlockMapper::DrawByParts()
{
  vtkOpenGLHelper& triangles = this->Primitives[PrimitiveTris];
  if (!triangles.Program)
  {
    return;
  }
  vtkOpenGLIndexBufferObject* corners = this->Own.Sent ? this->Own.Sent.Get() : triangles.IBO;
  corners->Bind();
  DrawTrianglesByParts(this->Own.Sent ? this->Own.Count : corners->IndexCount, this->Own.PointsOfPart);
  corners->Release();
}

}
