// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralGroundCoverMapper_h
#define LittoralGroundCoverMapper_h

#include "vtkOpenGLPolyDataMapper.h"
#include "vtkSmartPointer.h" // for the strips

#include <functional>
#include <vector>

class vtkPolyData;

namespace littoral
{

/// Draws some of its strips of triangles, all of which have as many points. They are dropped after they were sent to
/// the graphics' memory, and made again where they have to be sent again.
class GroundCoverMapper : public vtkOpenGLPolyDataMapper
{
public:
  static GroundCoverMapper* New();
  vtkTypeMacro(GroundCoverMapper, vtkOpenGLPolyDataMapper);

  /// Strips one after the other, from one up to before another.
  struct Run
  {
    int From;
    int To;
  };
  void SetRuns(std::vector<Run> runs);

  /// Makes the points of the strips, as many of each, one strip after the other, the same each time. They become the
  /// input. The first strips are its cells; all others are drawn as these are, by the same indices from other points
  /// on.
  using Maker = std::function<vtkSmartPointer<vtkPolyData>()>;
  void SetMaker(Maker maker);

protected:
  GroundCoverMapper() = default;
  ~GroundCoverMapper() override = default;

  void ComputeBounds() override;
  void BuildBufferObjects(vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;

private:
  GroundCoverMapper(const GroundCoverMapper&) = delete;
  void operator=(const GroundCoverMapper&) = delete;

  void DropStrips();

  std::vector<Run> Runs;
  Maker MakeStrips;
  int Indexed = 0; ///< strips whose indices are in the graphics' memory
  int PointsOfStrip = 0;
  int CornersOfStrip = 0; ///< of the triangles of a strip
};

}

#endif
