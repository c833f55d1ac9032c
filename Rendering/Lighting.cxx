// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Lighting.h"

#include "Numerics/Constants.h"
#include "Uniforms.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

constexpr double SmallestLandscape = 250.0; // radius [m]
constexpr double IndexOfWater = 1.333;      // of refraction

}

//----------------------------------------------------------------------------
void Lighting::TakeRipples(bool areThere, double time)
{
  // Rays of the sun in water of the index n, sin t = cos e / n
  const double sine = std::sqrt(std::max(0.0, 1.0 - std::pow(this->Sky.GetTables().Sun.z, 2))) / IndexOfWater;
  const double variance = areThere && this->HasWater ? this->WaterSlopeVariance : 0.0;
  this->Ripples.Take(
    time, variance, this->WaterMeshVariance, { 1.0 / std::sqrt(1.0 - sine * sine), this->WaterScattering.y });
}

//----------------------------------------------------------------------------
void Lighting::Activate(vtkOpenGLRenderWindow* window)
{
  this->Sky.Activate(window);
  this->Ripples.Activate(window);
  if (!this->NoMap)
  {
    this->NoMap = DepthMaps::NewTexture(window, 1);
  }
  vtkTextureObject* maps = this->Maps.GetLightTexture();
  this->Bound = { maps ? maps : this->NoMap.Get() };
  if (this->Maps.Has(DepthMaps::Ground))
  {
    this->Bound.push_back(this->Maps.GetGroundTexture());
  }
  for (vtkTextureObject* texture : this->Bound)
  {
    texture->Activate();
  }
  if (this->WantsSoftShadows && this->HasShadows())
  {
    this->Depths.Activate(window, maps);
  }
}

//----------------------------------------------------------------------------
void Lighting::Deactivate()
{
  this->Depths.Deactivate();
  for (vtkTextureObject* texture : this->Bound)
  {
    texture->Deactivate();
  }
  this->Bound.clear();
  this->Ripples.Deactivate();
  this->Sky.Deactivate();
}

//----------------------------------------------------------------------------
void Lighting::SetUniforms(vtkShaderProgram* program) const
{
  const SkyTables& sky = this->Sky.GetTables();
  SetUniform(program, "landscapeToWorld", glm::dmat3(this->ToWorld));
  SetUniform(program, "landscapeIsParallel", this->IsParallel ? 1 : 0);
  SetUniform(program, "landscapeSun", sky.Sun);
  SetUniform(program, "landscapeSunLight", sky.SunLight);
  SetUniform(program, "landscapeExtinction", this->Extinction);
  SetUniform(
    program, "landscapeFog", glm::dvec3(this->FogExtinction, this->FogScaleHeight, this->Eye.z - this->FogLevel));
  SetUniform(program, "landscapeExposure", this->Exposure);
  SetUniform(program, "landscapeBackground", this->Background ? 1 : 0);
  SetUniform(program, "landscapeFilmCurve", this->FilmCurve ? 1 : 0);
  SetUniform(program, "landscapeDome", this->Sky.GetDome()->GetTextureUnit());
  SetUniform(program, "landscapeSkyLight", this->Sky.GetLight()->GetTextureUnit());
  for (const char* texture : { "landscapeRippleSlopes", "landscapeRippleLight" })
  {
    SetUniform(program, texture, this->Sky.GetDome()->GetTextureUnit()); // if there are none
  }
  this->Ripples.SetUniforms(program, this->Eye);
  SetUniform(program, "landscapeMaps", this->Bound.front()->GetTextureUnit());
  float matrices[16 * DepthMaps::LightMaps] = {};
  glm::dvec4 texels(0.0);
  for (int map = 0; map < DepthMaps::LightMaps; ++map)
  {
    if (this->Maps.Has(map))
    {
      const glm::mat4 matrix(this->Maps.GetMatrix(map) * this->ToWorld);
      std::copy_n(&matrix[0][0], 16, matrices + 16 * map);
      texels[map] = this->Maps.GetTexelSize(map);
    }
  }
  program->SetUniformMatrix4x4v("landscapeToMap", DepthMaps::LightMaps, matrices);
  SetUniform(program, "landscapeTexel", texels);
  if (this->HasSoftShadows())
  {
    SetUniform(program, "landscapeMapDepths", this->Depths.GetUnit());
    SetUniform(program, "landscapeMapRange", this->Maps.GetRange(0));
  }
  SetUniform(program, "landscapeMapSize", static_cast<double>(std::max(this->Maps.GetSize(), 1)));
  SetUniform(program, "landscapeOcclusion", this->OcclusionRadius);
  SetUniform(program, "landscapeEyeHeight", std::max(this->Eye.z - this->Maps.GetLowest(), 1.0));
  // Where nothing is shown the earth is lost in haze within twice the size of what is, but not within 1 km: haze is
  // not seen before what stands there.
  const double near = this->Maps.GetRadius() > 0.0 ? 0.25 / std::max(this->Maps.GetRadius(), SmallestLandscape) : 0.0;
  SetUniform(program, "landscapeBareExtinction", this->Extinction > 0.0 ? std::max(this->Extinction, near) : 0.0);
  // A meadow around a ground: albedo / pi times the light of sky and sun
  const glm::dvec3 up(0.0, 0.0, 1.0);
  const Vector3 light = sky.LightOn(up) + std::max(sky.Sun.z, 0.0) * sky.SunLight;
  SetUniform(program, "landscapeBare", this->HasGround ? this->CoverColor / Pi * light : glm::dvec3(-1.0));
  constexpr double period = 32768.0;
  const glm::dvec3 below = this->Eye - glm::dvec3(this->CloudDrift, 0.0);
  SetUniform(program, "landscapeCloudEye", below - period * glm::floor(below / period));
  SetUniform(program, "landscapeClouds", glm::dvec2(this->CloudCover, std::max(this->CloudHeight - this->Eye.z, 1.0)));
  SetUniform(program, "landscapeWater", !this->HasWater ? 0 : this->IsInWater ? 2 : 1);
  SetUniform(program, "landscapeEyeDepth", this->WaterLevel - this->Eye.z);
  SetUniform(program, "landscapeFoamBegins", this->FoamBegins);
  SetUniform(program, "landscapeWetness", this->Wetness);
  SetUniform(program, "landscapeRunUp", this->ShoreRunUp);
  constexpr double swashPeriod = 5.0; // [s]
  const double swashes = this->WaterTime / swashPeriod;
  SetUniform(program, "landscapeSwash", swashes - std::floor(swashes));
  SetUniform(program, "landscapeSlopeVariance", this->WaterSlopeVariance);
  SetUniform(program, "landscapeIndex", IndexOfWater);
  SetUniform(program, "landscapeAbsorption", this->WaterAbsorption);
  SetUniform(program, "landscapeScattering", this->WaterScattering);
  if (this->Maps.Has(DepthMaps::Zenith))
  {
    SetUniform(program, "landscapeZenithAxes", glm::dmat3(this->Maps.GetMatrix(DepthMaps::Zenith)));
  }
}

//----------------------------------------------------------------------------
void Lighting::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Maps.ReleaseGraphicsResources(window);
  this->Sky.ReleaseGraphicsResources(window);
  this->Ripples.ReleaseGraphicsResources(window);
  this->Depths.ReleaseGraphicsResources(window);
  if (this->NoMap)
  {
    this->NoMap->ReleaseGraphicsResources(window);
    this->NoMap = nullptr;
  }
}

}
