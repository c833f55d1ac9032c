// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralInstanceMapper_h
#define LittoralInstanceMapper_h

#include "Instances.h"
#include "TexturedMapper.h"

#include "vtkNew.h"

class vtkOpenGLBufferObject;

namespace littoral
{

/**
 * Polygonal data drawn many times: p -> place + scale R p, normals turned by R, colors times the tint, up to white.
 *
 * Its shader is VTK's, with the vertex, its normal and its color replaced by those of the instance before anything
 * else. vtkGlyph3DMapper has one color an instance, and takes none from the polygons. Instances outside the volume that
 * the camera shows, which is that of a map of depths when it is drawn, are left out before their vertices are computed.
 */
class InstanceMapper : public TexturedMapper
{
public:
  static InstanceMapper* New();
  vtkTypeMacro(InstanceMapper, TexturedMapper);

  /// Instances to draw, and those to draw in coarse maps of depths (vtkLandscapePass::COARSE_MAP()); null: the same.
  void SetInstances(const std::shared_ptr<const InstanceBatch>& batch,
    const std::shared_ptr<const InstanceBatch>& inCoarseMaps = nullptr);

  /// Distances from the eye between which instances disappear, in the pixels in which impostors of them appear
  /// (vtkImpostorMapper::SetFadeRange) [m]; 0 0, or a parallel projection: none does.
  void SetFadeRange(double from, double to);

  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  InstanceMapper();
  ~InstanceMapper() override;

  void ComputeBounds() override;
  void SetMapperShaderParameters(vtkOpenGLHelper& triangles, vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;
  void ReplaceShaderValues(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor) override;

private:
  InstanceMapper(const InstanceMapper&) = delete;
  void operator=(const InstanceMapper&) = delete;

  bool TakeShown(vtkRenderer* renderer, vtkActor* actor);
  void BindAttributes(vtkOpenGLHelper& triangles);

  std::shared_ptr<const InstanceBatch> Batch;
  std::shared_ptr<const InstanceBatch> InCoarseMaps;
  std::vector<float> Shown; ///< instances of the last picture or map of depths
  vtkNew<vtkOpenGLBufferObject> Buffer;
  bool IsUploaded = false;
  float FadeRange[2] = { 0.0F, 0.0F };
};

}

#endif
