// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralBlockMapper_h
#define LittoralBlockMapper_h

#include "PinnedArray.h"
#include "TexturedMapper.h"

#include <array>
#include <cstddef>

class vtkCellArray;
class vtkDataArray;
class vtkOpenGLIndexBufferObject;

namespace littoral
{

/**
 * One block of a tree, drawn as by the mapper of the tree, and picked by the block's index in it.
 *
 * The mapper of a tree builds vertices and indices of all blocks anew when anything has changed; this one sends the
 * arrays that have changed, such as points and normals of what moves, and keeps the others in the graphics' memory.
 * Where a processor draws, normals, texture coordinates, points that are not shifted and numbers of triangles' corners
 * are read from the arrays themselves, and many triangles are drawn by parts, since all of them would be kept until
 * they are drawn.
 */
class BlockMapper : public TexturedMapper
{
public:
  static BlockMapper* New();
  vtkTypeMacro(BlockMapper, TexturedMapper);

  /// Whether a processor draws a surface by parts.
  static bool HasManyCells(vtkPolyData* surface);

  /// The index of the block in its tree, by which it is picked.
  void SetBlockIndex(unsigned int index) { this->BlockIndex = index; }

  /// Colors of arrays that are colors are made once.
  vtkUnsignedCharArray* MapScalars(vtkDataSet* input, double alpha, int& cellFlag) override;
  using Superclass::MapScalars;

  void RenderPiece(vtkRenderer* renderer, vtkActor* actor) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  BlockMapper() = default;
  ~BlockMapper() override = default;

  void ComputeBounds() override;
  void BuildBufferObjects(vtkRenderer* renderer, vtkActor* actor) override;
  void BuildIBO(vtkRenderer* renderer, vtkActor* actor, vtkPolyData* block) override;
  void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;

private:
  BlockMapper(const BlockMapper&) = delete;
  void operator=(const BlockMapper&) = delete;

  /// An array that is read where it is.
  struct Read
  {
    const char* Attribute;
    vtkDataArray* Array;
    PinnedArray& Pinned;
  };
  std::array<Read, 3> ReadInPlace();
  bool TakePoints(vtkRenderer* renderer, vtkActor* actor);
  void TakeCorners(vtkActor* actor, vtkPolyData* block);
  bool FillCorners(vtkCellArray* cells);
  void DrawByParts();
  bool IsDrawnByParts(vtkRenderer* renderer, vtkActor* actor) const;
  void FollowMemory(vtkRenderer* renderer);

  /// Time of change of the array whose colors are in use, their opacity and number: no two arrays were ever changed at
  /// one time.
  struct Source
  {
    vtkMTimeType Time = 0;
    double Alpha = 0.0;
    vtkIdType Tuples = 0;
  };
  Source Colored;
  bool CanPin = false;        ///< whether the window draws from the memory of arrays
  bool PointsInPlace = false; ///< whether the points are read so
  PinnedArray PinnedPoints;
  PinnedArray PinnedNormals;
  PinnedArray PinnedTCoords;
  /// The numbers by which triangles are drawn where those that VTK sent have been dropped.
  struct Corners
  {
    vtkSmartPointer<vtkOpenGLIndexBufferObject> Sent;
    vtkSmartPointer<vtkDataArray> Array; ///< that Sent reads in place; null if it has the numbers of a part
    const void* Memory = nullptr;        ///< of the array
    std::size_t Count = 0;
    int PointsOfPart = 0;
    vtkMTimeType Time = 0; ///< of the cells, if they have such corners
  };
  Corners Own;
  unsigned int BlockIndex = 0;
  bool IsDrawing = false;
};

}

#endif
