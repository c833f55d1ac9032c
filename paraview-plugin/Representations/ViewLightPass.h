// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralViewLightPass_h
#define LittoralViewLightPass_h

#include "vtkNew.h"
#include "vtkRenderPass.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <functional>

class vtkCallbackCommand;
class vtkLandscapePass;
class vtkMultiProcessController;
class vtkOpenGLFXAAFilter;
class vtkPVDefaultPass;
class vtkRenderer;

namespace littoral
{

/**
 * A vtkLandscapePass as ParaView's view draws by it: with the view's smoothing of edges, and without light where the
 * view selects or where this process draws no surfaces.
 *
 * Where several ranks draw, IceT composes their pictures, and asks no rank that shows nothing: what ranks do together
 * is done before, at the start of the renderer's picture, and so long a prop has bounds that fill the view. In pictures
 * that are composed in order, instead of by depths, the farthest rank draws the sky.
 */
class ViewLightPass : public vtkRenderPass
{
public:
  static ViewLightPass* New();
  vtkTypeMacro(ViewLightPass, vtkRenderPass);

  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  vtkSmartPointer<vtkLandscapePass> Landscape;
  bool IsOn = false;
  bool ShowsSky = true; ///< where there are no surfaces

  /// The ranks that draw the pictures of a renderer together; null: there is one. The function tells whether this one
  /// has the background.
  void SetRanks(vtkMultiProcessController* ranks, vtkRenderer* renderer, const std::function<bool()>& hasBackground);

protected:
  ViewLightPass();
  ~ViewLightPass() override;

private:
  ViewLightPass(const ViewLightPass&) = delete;
  void operator=(const ViewLightPass&) = delete;

  class Everywhere;

  void BeforePicture();

  vtkNew<vtkPVDefaultPass> Plain;
  vtkNew<vtkOpenGLFXAAFilter> Smoothing;
  vtkNew<vtkCallbackCommand> Start;
  vtkSmartPointer<Everywhere> Whole;
  vtkWeakPointer<vtkRenderer> Renderer; ///< of several ranks
  std::function<bool()> HasBackground;
};

}

#endif
