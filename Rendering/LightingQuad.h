// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralLightingQuad_h
#define LittoralLightingQuad_h

#include "ContactShade.h"
#include "Lens.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <map>
#include <memory>
#include <string>

class vtkMultiProcessController;
class vtkOpenGLFramebufferObject;
class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkTextureObject;
class vtkWindow;

namespace littoral
{

class Lighting;

/// Pictures of surfaces (SurfacePass) of the size of a renderer, or twice as wide and high, and their light, which is
/// computed once a pixel of them.
class LightingQuad
{
public:
  LightingQuad();
  ~LightingQuad();

  /// Pixels of the pictures along a side of one of the renderer, 1 or 2.
  void SetSamples(int samples) { this->Samples = samples; }
  /// Pixels of the renderer along a side of one of the pictures, which is enlarged by a linear filter.
  void SetPixelSize(double size) { this->PixelSize = size; }

  /// Draws surfaces by functions into the pictures: those of water into pictures of their own, null for none.
  void TakeSurfaces(
    vtkRenderer* renderer, const std::function<void()>& drawSurfaces, const std::function<void()>& drawWater);

  /// Puts crowns of woods on ridges of the surfaces that are taken.
  void RaiseWoods(vtkRenderer* renderer, const Lighting& light);

  /// Draws the shade where things meet of the nearest of the surfaces that all processes have taken, together.
  void ShareContact(vtkRenderer* renderer, const Lighting& light, vtkMultiProcessController* processes);

  /// Takes the nearest of the surfaces that all processes have taken for what is seen through water, together.
  void ShareBed(vtkMultiProcessController* processes);

  /// Whether the picture mixes pixels of the pictures.
  bool IsMixed(const Lighting& light) const;

  /// Lights the surfaces, and takes the nearest of all processes for what mixes them, together.
  void ShareLit(vtkRenderer* renderer, const Lighting& light, vtkMultiProcessController* processes);

  /// Draws the lit surfaces, and the sky behind them, with their depths.
  void Draw(vtkRenderer* renderer, const Lighting& light);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  /// Pictures of what SurfacePass writes.
  struct Layer
  {
    vtkSmartPointer<vtkTextureObject> Albedo;
    vtkSmartPointer<vtkTextureObject> Surface;
    vtkSmartPointer<vtkTextureObject> Depth;

    void Allocate(vtkOpenGLRenderWindow* window, int width, int height);
    void Clear(vtkWindow* window);
  };

  void Allocate(vtkOpenGLRenderWindow* window, int width, int height);
  void AllocateLit(vtkOpenGLRenderWindow* window, bool hasLens);
  void Take(vtkOpenGLRenderWindow* window, const Layer& layer, const std::function<void()>& draw);
  void DrawLit(vtkRenderer* renderer, const Lighting& light);
  void DrawContact(vtkRenderer* renderer, const Lighting& light, vtkMultiProcessController* processes);
  void DrawShownDepths(vtkRenderer* renderer, const Lighting& light);
  void DrawKinds(vtkRenderer* renderer, const Lighting& light);
  void DrawPart(const std::string& part, int kind, vtkRenderer* renderer, const Lighting& light);

  vtkNew<vtkOpenGLFramebufferObject> Frame;
  Layer Dry;
  Layer Raised; ///< the next dry one; empty if there are no woods
  Layer Wet;    ///< of water; empty if there is none
  Layer Bed;    ///< below water, of all processes; empty before they share it
  vtkSmartPointer<vtkTextureObject> Lit;
  vtkSmartPointer<vtkTextureObject> Kinds;                           ///< of pixels, as depths
  std::map<std::string, std::unique_ptr<vtkOpenGLQuadHelper>> Parts; ///< by what is defined in their shaders
  vtkSmartPointer<vtkTextureObject> Shafts; ///< of light in water, and lengths of lines of sight
  ContactShade Contact;
  Lens Glass;
  bool IsLinear = false;   ///< whether Lit has luminances and distances, for the lens
  bool HasContact = false; ///< of all processes, for the next picture
  bool HasLit = false;     ///< the same of Lit
  bool HasBed = false;     ///< the same of Bed
  int Samples = 1;
  double PixelSize = 1.0;
  int Width = 0;
  int Height = 0;
};

}

#endif
