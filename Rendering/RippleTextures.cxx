// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RippleTextures.h"

#include "OpenGL.h"
#include "Pipeline/Threads.h"
#include "Uniforms.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <array>
#include <cmath>

namespace littoral
{

namespace
{

constexpr double Side = 6.4; // of the square of waves [m]
constexpr int Samples = 256;

/// Depths of the four channels of the light [m].
constexpr std::array<double, 4> Depths = { 0.75, 2.25, 6.75, 20.25 };

/// Turn of the second layer of waves, which hides the period of the first [rad].
constexpr double Turn = 2.4;

/// Turn of rays from the zenith by a slope, 1 - 1 / n.
constexpr double Refraction = 0.25;

/// Places within the square that repeats itself, in double precision also far from the origin.
glm::dvec4 InSquares(const glm::dvec4& squares)
{
  return squares - glm::floor(squares);
}

/// A texture that repeats itself, with mean values for what is far.
vtkSmartPointer<vtkTextureObject> TextureOf(
  std::vector<float>& numbers, int size, int components, vtkOpenGLRenderWindow* window)
{
  auto texture = vtkSmartPointer<vtkTextureObject>::New();
  texture->SetContext(window);
  texture->SetMaxLevel(static_cast<int>(std::log2(size)));
  texture->SetWrapS(vtkTextureObject::Repeat);
  texture->SetWrapT(vtkTextureObject::Repeat);
  texture->SetMinificationFilter(vtkTextureObject::LinearMipmapLinear);
  texture->SetLinearMagnification(true);
  texture->Create2DFromRaw(
    static_cast<unsigned int>(size), static_cast<unsigned int>(size), components, VTK_FLOAT, numbers.data());
  texture->Bind();
  glGenerateMipmap(GL_TEXTURE_2D);
  return texture;
}

}

//----------------------------------------------------------------------------
void RippleTextures::Take(double time, double variance, double meshVariance, const ScatteringWay& down)
{
  const bool isSameWater = variance == this->Variance && meshVariance == this->MeshVariance &&
    down.Length == this->Down.Length && down.Scattering == this->Down.Scattering;
  if (isSameWater && (variance <= 0.0 || this->Time == time))
  {
    return;
  }
  this->Variance = variance;
  this->MeshVariance = meshVariance;
  this->Down = down;
  this->SlopeTexture = nullptr;
  if (!this->HasWaves())
  {
    return;
  }
  this->Time = time;
  if (!this->Waves)
  {
    this->Waves.emplace(Side, Samples, 1);
  }
  const std::vector<SurfaceSlope> slopes = this->Waves->SlopesAt(time, SmpFor);
  this->Slopes.clear();
  for (const SurfaceSlope& slope : slopes)
  {
    // In the third channel s2, whose mean is the variance
    const auto x = static_cast<float>(slope.X);
    const auto y = static_cast<float>(slope.Y);
    this->Slopes.insert(this->Slopes.end(), { x, y, x * x + y * y });
  }
  this->Gather(slopes);
}

//----------------------------------------------------------------------------
void RippleTextures::Gather(const std::vector<SurfaceSlope>& slopes)
{
  const double deviation = std::sqrt(this->Variance + this->MeshVariance);
  this->Light.resize(Samples * Samples);
  SmpFor(Depths.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t channel = begin; channel < end; ++channel)
    {
      ScatteringWay way = this->Down;
      way.Length *= Depths[channel];
      const std::vector<double> light = ScatteredPattern(
        GatheredLight(slopes, Samples, Side, Refraction * Depths[channel] * deviation), Samples / 2, Side, way);
      for (std::size_t place = 0; place < light.size(); ++place)
      {
        this->Light[4 * place + channel] = static_cast<float>(light[place]);
      }
    }
  });
}

//----------------------------------------------------------------------------
void RippleTextures::Activate(vtkOpenGLRenderWindow* window)
{
  if (!this->HasWaves())
  {
    return;
  }
  if (!this->SlopeTexture)
  {
    this->SlopeTexture = TextureOf(this->Slopes, Samples, 3, window);
    this->LightTexture = TextureOf(this->Light, Samples / 2, 4, window);
  }
  this->SlopeTexture->Activate();
  this->LightTexture->Activate();
}

//----------------------------------------------------------------------------
void RippleTextures::Deactivate()
{
  if (this->HasWaves())
  {
    this->LightTexture->Deactivate();
    this->SlopeTexture->Deactivate();
  }
}

//----------------------------------------------------------------------------
void RippleTextures::SetUniforms(vtkShaderProgram* program, const glm::dvec3& eye) const
{
  SetUniform(program, "landscapeHasRipples", this->HasWaves() ? 1 : 0);
  SetUniform(program, "landscapeRippleSide", Side);
  if (!this->HasWaves())
  {
    return;
  }
  const double c = std::cos(Turn);
  const double s = std::sin(Turn);
  SetUniform(program, "landscapeRippleEye",
    InSquares(glm::dvec4(eye.x, eye.y, c * eye.x + s * eye.y, c * eye.y - s * eye.x) / Side));
  SetUniform(program, "landscapeRippleTurn", glm::dvec2(c, s));
  SetUniform(program, "landscapeRippleSlopes", this->SlopeTexture->GetTextureUnit());
  SetUniform(program, "landscapeRippleLight", this->LightTexture->GetTextureUnit());
}

//----------------------------------------------------------------------------
void RippleTextures::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->SlopeTexture)
  {
    this->SlopeTexture->ReleaseGraphicsResources(window);
    this->LightTexture->ReleaseGraphicsResources(window);
  }
  this->SlopeTexture = nullptr;
  this->LightTexture = nullptr;
}

}
