// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralImpostorAtlas_h
#define LittoralImpostorAtlas_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <glm/vec3.hpp>

#include <vector>

class vtkActor;
class vtkCamera;
class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkProp;
class vtkRenderer;
class vtkTextureObject;
class vtkWindow;

namespace littoral
{

class SurfacePass;
struct FramePicture;

/**
 * Pictures of a plant from the directions of an octahedron's grid, in parallel projection, as SurfacePass sees it: what
 * is needed to light it, not its look. Frames are squares in rows and columns; those of the rim have the directions of
 * the lower half of the octahedron, which is unfolded to a square.
 *
 * One texture has albedo, as the display's code, and coverage, which is cut at a half at all mip levels; another the
 * mean of the normals in the plant's axes, which is the shorter the less they agree, and the place along the direction,
 * both as 0 to 1 from -1 to 1 [radii]; the third transmittances.
 */
class ImpostorAtlas
{
public:
  struct Sphere
  {
    glm::dvec3 Center = glm::dvec3(0.0);
    double Radius = 0.0;
  };

  ImpostorAtlas();
  ~ImpostorAtlas();

  /// Draws actors anew, with an odd number of frames a side, of a power of 2 texels a side. The renderer's camera and
  /// the bound frame buffer stay as they were.
  void Draw(
    vtkRenderer* renderer, const std::vector<vtkActor*>& parts, const Sphere& around, int frames, int frameSize);

  vtkTextureObject* GetColors() const { return this->Colors; }
  vtkTextureObject* GetForms() const { return this->Forms; }
  vtkTextureObject* GetLeaves() const { return this->Leaves; }

  /// Mip levels of a frame, the last of 8 texels a side.
  static int LevelsOf(int frameSize);
  /// Graphics memory of the textures [bytes]: 9 (frames size)^2 (1 + 1/4 + 1/16 + ...).
  static vtkTypeInt64 BytesOf(int frames, int frameSize);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct Bytes;

  void Allocate(vtkOpenGLRenderWindow* window, int side);
  FramePicture TakeFrame(vtkRenderer* renderer, const std::vector<vtkProp*>& props, const Sphere& around,
    const glm::dvec3& towards, int side);
  FramePicture Read(const glm::dvec3& towards, int side) const;

  vtkNew<SurfacePass> Surfaces;
  vtkNew<vtkOpenGLFramebufferObject> Frame;
  vtkNew<vtkCamera> Camera;
  vtkSmartPointer<vtkTextureObject> Albedo; ///< of one frame, and so on
  vtkSmartPointer<vtkTextureObject> Surface;
  vtkSmartPointer<vtkTextureObject> Depth;
  vtkSmartPointer<vtkTextureObject> Colors;
  vtkSmartPointer<vtkTextureObject> Forms;
  vtkSmartPointer<vtkTextureObject> Leaves;
};

}

#endif
