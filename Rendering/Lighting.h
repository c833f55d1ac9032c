// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralLighting_h
#define LittoralLighting_h

#include "DepthMaps.h"
#include "RippleTextures.h"
#include "SecondSampler.h"
#include "SkyTextures.h"

#include "vtkSmartPointer.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace littoral
{

/// The light of a picture, as the uniforms and textures of LandscapeLight.glsl.
class Lighting
{
public:
  SkyTextures Sky;
  DepthMaps Maps;
  RippleTextures Ripples;
  glm::dmat4 ToWorld = glm::dmat4(1.0); ///< from view coordinates
  glm::dvec3 Eye = glm::dvec3(0.0);     ///< place of the camera
  bool IsParallel = false;              ///< whether the camera is
  double Exposure = 1.0;                ///< of a luminance [m2/kcd]
  bool FilmCurve = true;
  bool Background = true;                       ///< sky behind the surfaces
  double Extinction = 0.0;                      ///< of the air [1/m]
  glm::dvec3 CoverColor = glm::dvec3(0.0);      ///< albedo of grass, linear
  bool HasBark = false;                         ///< some surface is of this material
  glm::dvec2 Turf = glm::dvec2(0.0);            ///< height of grass, and distance of its last blades [m]; 0: no grass
  double WoodCover = 0.0;                       ///< part of the ground, from 0 to 1
  double CloudCover = 0.0;                      ///< part of the sky, from 0 to 1
  double FogExtinction = 0.0;                   ///< up to its level [1/m]
  double FogLevel = 0.0;                        ///< [m]
  double FogScaleHeight = 10.0;                 ///< above its level [m]
  double CloudHeight = 1500.0;                  ///< [m]
  glm::dvec2 CloudDrift = glm::dvec2(0.0);      ///< [m]
  double OcclusionRadius = 0.0;                 ///< distance of what hides the sky [m]
  double ContactRadius = 0.0;                   ///< the same for what meets, by the picture's depths [m]
  glm::ivec2 ContactCounts = glm::ivec2(0);     ///< slices and taps (ContactShade)
  bool WantsSoftShadows = false;                ///< whether shadows are as soft as the sun is wide
  double Aperture = 0.0;                        ///< diameter of the lens [m]
  double FocusDistance = 10.0;                  ///< along the view's axis [m]
  bool HasGround = false;                       ///< whether surfaces of the material Ground are shown
  bool HasWater = false;                        ///< whether surfaces of water are shown
  bool LightsColorMaps = false;                 ///< whether surfaces with a color map are lit
  bool HasSea = false;                          ///< whether there is water at WaterLevel
  bool IsInWater = false;                       ///< whether the eye is below that of a sea
  double WaterLevel = 0.0;                      ///< mean height of them [m]
  double FoamBegins = 0.0;                      ///< stretch of them below which there is foam
  double Wetness = 0.0;                         ///< part of surfaces, from 0 to 1
  double ShoreRunUp = 0.0;                      ///< of waves on a shore [m]
  double WaterTime = 0.0;                       ///< [s]
  double WaterSlopeVariance = 0.0;              ///< of what their meshes do not have
  double WaterMeshVariance = 0.0;               ///< of slopes of their meshes
  bool HasShafts = false;                       ///< whether the water between its waves' light is drawn
  glm::dvec3 WaterAbsorption = glm::dvec3(0.0); ///< [1/m]
  glm::dvec3 WaterScattering = glm::dvec3(0.0); ///< [1/m]

  /// Whether waves run on a ground.
  bool HasShore() const { return this->ShoreRunUp > 0.0 && this->HasGround && this->HasSea; }

  /// Whether anything is hidden from the sun, or from the sky.
  bool HasShadows() const { return this->Maps.Has(0) || this->Maps.Has(1) || this->Maps.Has(2); }
  bool HasOcclusion() const { return this->OcclusionRadius > 0.0 && this->Maps.Has(DepthMaps::Zenith); }

  /// Whether shadows are soft: where depths may be read from their maps.
  bool HasSoftShadows() const { return this->WantsSoftShadows && this->HasShadows() && this->Depths.IsOn(); }
  /// Whether they are wanted but may not, while the textures are bound.
  bool LacksSoftShadows() const { return this->WantsSoftShadows && this->HasShadows() && !this->Depths.IsOn(); }

  /// Whether what is out of focus is blurred.
  bool HasLens() const { return this->Aperture > 0.0 && !this->IsParallel; }

  /// Waves at a time [s] if there are any, and what the sun sends through them.
  void TakeRipples(bool areThere, double time);

  /// Between them, the textures are bound.
  void Activate(vtkOpenGLRenderWindow* window);
  void Deactivate();

  /// For a program with LandscapeLight.glsl, while the textures are bound.
  void SetUniforms(vtkShaderProgram* program) const;

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkSmartPointer<vtkTextureObject> NoMap; ///< in place of maps that there are not
  std::vector<vtkTextureObject*> Bound;
  SecondSampler Depths; ///< of the maps of light
};

}

#endif
