// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSkyTextures_h
#define LittoralSkyTextures_h

#include "Light/Atmosphere.h"
#include "Light/SkyTables.h"

#include "vtkSmartPointer.h"

#include <memory>
#include <optional>

class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

namespace littoral
{

/// Tables of a sky, computed anew where its air or its sun changed, and as textures of a window.
class SkyTextures
{
public:
  /// A clear sky under a sun.
  void TakeClear(const AirParameters& air, const Vector3& sun);
  /// The same luminance of 1 kcd/m2 from everywhere, without a sun.
  void TakeEven();

  const SkyTables& GetTables() const { return *this->Tables; }

  /// Dome and light as textures that are bound; between them, pictures are drawn.
  void Activate(vtkOpenGLRenderWindow* window);
  void Deactivate();
  vtkTextureObject* GetDome() const { return this->Dome; }
  vtkTextureObject* GetLight() const { return this->Light; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  std::shared_ptr<const Atmosphere> Air; ///< none for an even sky
  AirParameters Parameters;
  std::optional<SkyTables> Tables;
  vtkSmartPointer<vtkTextureObject> Dome;
  vtkSmartPointer<vtkTextureObject> Light;
};

}

#endif
