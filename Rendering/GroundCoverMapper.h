// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralGroundCoverMapper_h
#define LittoralGroundCoverMapper_h

#include "vtkOpenGLPolyDataMapper.h"

#include <vector>

namespace littoral
{

/// Draws some of its strips of triangles, all of which have as many points.
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

protected:
  GroundCoverMapper() = default;
  ~GroundCoverMapper() override = default;

  void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;

private:
  GroundCoverMapper(const GroundCoverMapper&) = delete;
  void operator=(const GroundCoverMapper&) = delete;

  std::vector<Run> Runs;
};

}

#endif
