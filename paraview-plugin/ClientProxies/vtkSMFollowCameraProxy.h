// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMFollowCameraProxy
 * @brief   a filter that follows the camera of the active view
 *
 * While the property FollowCamera of the proxy is on, the properties ViewPoint, ViewDirection, ViewUp, ViewAngle,
 * ParallelProjection, ParallelScale, AspectRatio and ViewHeight take the values of the active render view, or of
 * another one where that shows nothing of it, before each of its pictures, and DetailFactor that of InteractiveDetail
 * while the camera is dragged, if these differ by more than MoveTolerance and TurnTolerance, directions only where they
 * count: else nothing downstream would change, yet be drawn anew. It lives in the client, with or without a window: in
 * ParaView, in pvpython, and in front of a server; a state file keeps it.
 */
#ifndef vtkSMFollowCameraProxy_h
#define vtkSMFollowCameraProxy_h

#include "LittoralClientProxiesModule.h" // for export macro
#include "vtkSMNaturalDisplayProxy.h"
#include "vtkWeakPointer.h" // for what is watched

class vtkSMRenderViewProxy;
class vtkSMSessionProxyManager;

namespace littoral
{
struct View;
}

class LITTORALCLIENTPROXIES_EXPORT vtkSMFollowCameraProxy : public vtkSMNaturalDisplayProxy
{
public:
  static vtkSMFollowCameraProxy* New();
  vtkTypeMacro(vtkSMFollowCameraProxy, vtkSMNaturalDisplayProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void UpdateVTKObjects() override;

protected:
  vtkSMFollowCameraProxy();
  ~vtkSMFollowCameraProxy() override;

private:
  vtkSMFollowCameraProxy(const vtkSMFollowCameraProxy&) = delete;
  void operator=(const vtkSMFollowCameraProxy&) = delete;

  void WatchSelection(vtkObject* selection);
  void WatchView(vtkSMRenderViewProxy* view);
  void OnActiveView();
  void OnPicture(vtkObject*, unsigned long, void* isInteractive);
  bool Shows(const littoral::View& view);
  void Take(const littoral::View& view);

  vtkWeakPointer<vtkObject> Selection; ///< of the active view
  vtkWeakPointer<vtkSMSessionProxyManager> Manager;
  vtkWeakPointer<vtkSMRenderViewProxy> View;
  unsigned long SelectionObserver = 0;
  unsigned long StateObserver = 0;
  unsigned long ViewObserver = 0;
  bool IsTaking = false;
};

#endif
