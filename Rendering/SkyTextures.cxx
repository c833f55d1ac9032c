// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SkyTextures.h"

#include "Pipeline/Threads.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

#include <glm/geometric.hpp>

#include <vector>

namespace littoral
{

namespace
{

constexpr double SameDirection = 1e-9;

vtkSmartPointer<vtkTextureObject> TextureOf(const ColorTable& table, vtkOpenGLRenderWindow* window)
{
  std::vector<float> numbers;
  numbers.reserve(3 * table.Colors.size());
  for (const Vector3& color : table.Colors)
  {
    numbers.insert(
      numbers.end(), { static_cast<float>(color.x), static_cast<float>(color.y), static_cast<float>(color.z) });
  }
  auto texture = vtkSmartPointer<vtkTextureObject>::New();
  texture->SetContext(window);
  texture->Create2DFromRaw(
    static_cast<unsigned int>(table.Columns), static_cast<unsigned int>(table.Rows), 3, VTK_FLOAT, numbers.data());
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetMinificationFilter(vtkTextureObject::Linear);
  texture->SetLinearMagnification(true);
  return texture;
}

bool AreSame(const AirParameters& a, const AirParameters& b)
{
  return a.Turbidity == b.Turbidity && a.GroundAlbedo == b.GroundAlbedo && a.Altitude == b.Altitude;
}

/// An atmosphere of parameters, which takes a second to compute: the last one is kept for other pictures.
std::shared_ptr<const Atmosphere> AtmosphereOf(const AirParameters& air)
{
  static AirParameters lastAir;
  static std::shared_ptr<const Atmosphere> last;
  if (!last || !AreSame(air, lastAir))
  {
    last = std::make_shared<const Atmosphere>(air, SmpFor);
    lastAir = air;
  }
  return last;
}

}

//----------------------------------------------------------------------------
void SkyTextures::TakeClear(const AirParameters& air, const Vector3& sun)
{
  if (!this->Air || !AreSame(air, this->Parameters))
  {
    this->Air = AtmosphereOf(air);
    this->Parameters = air;
    this->Tables.reset();
  }
  if (!this->Tables || glm::length(this->Tables->Sun - sun) > SameDirection)
  {
    this->Tables = TabulateSky(*this->Air, sun, SmpFor);
    this->Dome = nullptr;
  }
}

//----------------------------------------------------------------------------
void SkyTextures::TakeEven()
{
  if (this->Tables && !this->Air)
  {
    return;
  }
  this->Air.reset();
  const auto even = [](const std::vector<Vector3>& directions) {
    return std::vector<Vector3>(directions.size(), Vector3(1.0));
  };
  this->Tables = TabulateSky(even, { 0.0, 0.0, 1.0 }, Vector3(0.0), SmpFor);
  this->Dome = nullptr;
}

//----------------------------------------------------------------------------
void SkyTextures::Activate(vtkOpenGLRenderWindow* window)
{
  if (!this->Dome)
  {
    this->Dome = TextureOf(this->Tables->Dome, window);
    this->Light = TextureOf(this->Tables->Light, window);
  }
  this->Dome->Activate();
  this->Light->Activate();
}

//----------------------------------------------------------------------------
void SkyTextures::Deactivate()
{
  this->Light->Deactivate();
  this->Dome->Deactivate();
}

//----------------------------------------------------------------------------
void SkyTextures::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Dome)
  {
    this->Dome->ReleaseGraphicsResources(window);
    this->Light->ReleaseGraphicsResources(window);
  }
  this->Dome = nullptr;
  this->Light = nullptr;
}

}
