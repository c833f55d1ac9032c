// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralImpostorQuads_h
#define LittoralImpostorQuads_h

#include "ImpostorAtlas.h"

#include "vtkBoundingBox.h"
#include "vtkNew.h"
#include "vtkOpenGLPolyDataMapper.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <vector>

class vtkOpenGLBufferObject;

namespace littoral
{

/// Numbers of instances in single precision, relative to a place, so that it holds them.
struct ImpostorInstances
{
  /// Numbers of each: place and scale, rotation as a quaternion x, y, z, w, and tint with the width over the scale,
  /// below 0 for one that fades.
  static constexpr int Numbers = 12;

  std::vector<float> Values;
  glm::dvec3 Anchor = glm::dvec3(0.0);
  vtkBoundingBox Bounds;
};

/**
 * A square an instance, through the middle of a sphere around the plant and facing the eye or, where maps of shadows
 * are drawn, the sun. Its fragments are those of the plant: each follows its line of sight to the depths of the three
 * frames whose directions are around that of the eye, and has their albedo, normal, transmittance and place.
 */
class ImpostorQuads : public vtkOpenGLPolyDataMapper
{
public:
  static ImpostorQuads* New();
  vtkTypeMacro(ImpostorQuads, vtkOpenGLPolyDataMapper);

  void SetInstances(ImpostorInstances instances);
  const ImpostorInstances& GetInstances() const { return this->Instances; }

  /// The pictures that are shown, which exist while they are drawn.
  void SetAtlas(const ImpostorAtlas* atlas, const ImpostorAtlas::Sphere& around, int frames, int frameSize);

  /// Distances from the eye between which instances that fade appear [m].
  void SetFade(const glm::dvec2& range) { this->Fade = range; }

  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  ImpostorQuads();
  ~ImpostorQuads() override;

  void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;
  void ReplaceShaderValues(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor) override;
  void SetMapperShaderParameters(vtkOpenGLHelper& squares, vtkRenderer* renderer, vtkActor* actor) override;

private:
  ImpostorQuads(const ImpostorQuads&) = delete;
  void operator=(const ImpostorQuads&) = delete;

  static bool HasInstancedArrays();
  void DrawTogether(vtkOpenGLHelper& squares);
  void DrawEach(vtkOpenGLHelper& squares);
  void BindAttributes(vtkOpenGLHelper& squares);

  ImpostorInstances Instances;
  const ImpostorAtlas* Atlas = nullptr;
  ImpostorAtlas::Sphere Around;
  glm::dvec2 Grid = glm::dvec2(0.0); ///< frames along a side, texels along a side of a frame
  glm::dvec2 Fade = glm::dvec2(0.0);
  vtkNew<vtkOpenGLBufferObject> Buffer;
  bool IsUploaded = false;
};

}

#endif
