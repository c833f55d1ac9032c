// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralDepthMaps_h
#define LittoralDepthMaps_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

class vtkCamera;
class vtkMultiProcessController;
class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkProp;
class vtkRenderer;
class vtkTextureObject;
class vtkWindow;

namespace littoral
{

/**
 * Depths seen from the sun, for its shadows, and from the zenith: of all, for what is open to the sky, and of the
 * ground around the eye, for what grows on it. The sun has one map near the eye, one in the middle, one of all that is
 * shown. A map is moved by steps of whole texels, so that shadows do not crawl, and drawn anew only where it moved or
 * what casts shadows changed.
 */
class DepthMaps
{
public:
  static constexpr int SunMaps = 3;
  static constexpr int Zenith = SunMaps;
  static constexpr int LightMaps = SunMaps + 1;
  static constexpr int Ground = LightMaps;
  static constexpr int Count = SunMaps + 2;

  struct Wish
  {
    glm::dvec3 Sun;      ///< towards it, of length 1
    bool HasSun;         ///< whether its maps are wanted
    bool HasZenith;      ///< whether that of the zenith is
    double GroundRadius; ///< around the eye, of that of the ground; 0: it is not wanted
    double Distance;     ///< from the eye, to which the middle map and that of the zenith reach
    int Size;            ///< texels along a side
    double Occlusion;    ///< distance of what hides the sky [m]
    bool IsInHaste;      ///< whether maps are to move seldom, of coarse shapes, rather than to be sharp near the eye
  };

  DepthMaps();
  ~DepthMaps();

  /// A function that draws all that is seen by a map with the renderer's camera.
  using Drawing = std::function<void(int map)>;

  /// Draws the maps, over all that is shown, that are out of date, and tells whether there are any. The processes of a
  /// controller, if there is one, do so together, and have the maps of what casts shadows on all.
  bool Draw(vtkRenderer* renderer, const std::vector<vtkProp*>& shown, const std::vector<vtkProp*>& casters,
    const Wish& wish, const Drawing& drawCasters, vtkMultiProcessController* processes);

  /// A texture of depths, which compares with them or tells them.
  static vtkSmartPointer<vtkTextureObject> NewTexture(vtkOpenGLRenderWindow* window, int size, bool compares = true);

  bool IsCoarse(int map) const { return this->Places[map].IsCoarse; }
  bool Has(int map) const { return this->Places[map].Radius > 0.0 && !this->Places[map].IsIdle; }
  /// Texture of the maps of light: four squares, numbered by row and column.
  vtkTextureObject* GetLightTexture() const { return this->Light; }
  vtkTextureObject* GetGroundTexture() const { return this->OfGround; }
  /// From the world to the coordinates of a map, 0 to 1.
  const glm::dmat4& GetMatrix(int map) const { return this->Places[map].ToMap; }
  double GetTexelSize(int map) const { return 2.0 * this->Places[map].Radius / this->Size; }
  /// Distance along the light from the depth 0 to the depth 1 of a map [m].
  double GetRange(int map) const { return 2.0 * this->Places[map].Depth; }
  int GetSize() const { return this->Size; }
  /// Lowest height of all that is shown [m]; 0 without anything.
  double GetLowest() const { return this->Lowest; }
  /// Radius of the sphere around it [m].
  double GetRadius() const { return this->Radius; }
  /// Greatest height of it [m].
  double GetHighest() const { return this->Highest; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  /// Where a map looks.
  struct Place
  {
    glm::dvec3 Towards = glm::dvec3(0.0); ///< the light
    glm::dvec3 Center = glm::dvec3(0.0);
    double Radius = -1.0;  ///< below 0: there is no map
    double Depth = 0.0;    ///< from the center to the ends along the light
    bool IsCoarse = false; ///< whether leaves are not told apart
    bool IsIdle = false;   ///< whether it waits for pictures that are not in haste
    std::uint64_t State = 0;
    glm::dmat4 ToMap = glm::dmat4(1.0);
  };
  /// All that is shown.
  struct Whole
  {
    glm::dvec3 Center;
    double Radius;
    std::uint64_t State;       ///< a number that changes with it
    std::uint64_t CoarseState; ///< one that changes with what it casts in coarse maps
  };

  void TellMappers(int map);
  Place PlaceOf(int map, vtkRenderer* renderer, const Whole& whole, const Wish& wish) const;
  void DrawOne(int map, vtkRenderer* renderer, const Drawing& drawCasters, vtkMultiProcessController* processes);
  void TakeNearest(int map, vtkMultiProcessController* processes);
  vtkTextureObject* TextureOf(int map) const;
  glm::ivec2 CornerOf(int map) const;
  void Allocate(vtkOpenGLRenderWindow* window, int size);

  std::array<Place, Count> Places;
  vtkSmartPointer<vtkTextureObject> Light;
  vtkSmartPointer<vtkTextureObject> OfGround;
  vtkNew<vtkOpenGLFramebufferObject> Frame;
  vtkNew<vtkCamera> Camera;
  int Size = 0;
  double Radius = 0.0;
  double Lowest = 0.0;
  double Highest = 0.0;
};

}

#endif
