// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralRippleTextures_h
#define LittoralRippleTextures_h

#include "Sea/Ripples.h"
#include "Sea/ScatteredPattern.h"

#include "vtkSmartPointer.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <optional>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace littoral
{

/// Waves that meshes of water do not have, and the light that they gather below, as textures of LandscapeWater.glsl.
class RippleTextures
{
public:
  /// Waves at a time [s], with a variance of their slopes; level water without waves if it is 0. Light is gathered by
  /// these and by what a mesh has of waves. It goes down on a way that is longer than the depth, which is its length.
  void Take(double time, double variance, double meshVariance, const ScatteringWay& down);

  bool HasWaves() const { return this->Variance > 0.0; }

  /// Between them, the textures are bound.
  void Activate(vtkOpenGLRenderWindow* window);
  void Deactivate();

  /// For a program with LandscapeWater.glsl, while the textures are bound, by the place of the camera.
  void SetUniforms(vtkShaderProgram* program, const glm::dvec3& eye) const;

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  void Gather(const std::vector<SurfaceSlope>& slopes);

  std::optional<Ripples> Waves;
  std::optional<double> Time; ///< of the textures
  double Variance = 0.0;
  double MeshVariance = 0.0;
  ScatteringWay Down; ///< over the depth
  std::vector<float> Slopes;
  std::vector<float> Light;
  vtkSmartPointer<vtkTextureObject> SlopeTexture;
  vtkSmartPointer<vtkTextureObject> LightTexture;
};

}

#endif
