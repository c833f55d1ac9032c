// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralTexturedMapper_h
#define LittoralTexturedMapper_h

#include "vtkOpenGLPolyDataMapper.h"

namespace littoral
{

/// A mapper of polygons that can carry a texture. Where they do, an array is mapped to colors at the points: VTK's
/// other way, a texture of the map, would take the coordinates of theirs.
class TexturedMapper : public vtkOpenGLPolyDataMapper
{
public:
  vtkTypeMacro(TexturedMapper, vtkOpenGLPolyDataMapper);

  /// Texture or none, set before properties of another mapper are copied.
  void SetTextured(bool isTextured) { this->IsTextured = isTextured; }

  void SetInterpolateScalarsBeforeMapping(vtkTypeBool interpolates) override
  {
    this->Superclass::SetInterpolateScalarsBeforeMapping(interpolates && !this->IsTextured);
  }

protected:
  TexturedMapper() = default;
  ~TexturedMapper() override = default;

private:
  TexturedMapper(const TexturedMapper&) = delete;
  void operator=(const TexturedMapper&) = delete;

  bool IsTextured = false;
};

}

#endif
