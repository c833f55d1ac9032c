// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralNaturalDisplay_h
#define LittoralNaturalDisplay_h

#include "vtkWeakPointer.h" // for what is watched

class vtkObject;
class vtkSMProxy;
class vtkSMRenderViewProxy;
class vtkSMSessionProxyManager;
class vtkSMSourceProxy;

namespace littoral
{

/**
 * How a source is first shown in ParaView: in its own colors, and from the side where that is the better view.
 *
 * ParaView colors by a color map, with a legend, and looks down along z unless it is told otherwise. This tells each
 * new representation of a source to take the point array RGB, if there is one, as it is, or to color by the array that
 * color="..." names. Where the hint
 *
 *     <NaturalDisplay blocks="/Root/High/Skin /Root/High/Leaves" elevation="12" closer="2" />
 *
 * of the proxy names blocks, only these are shown at first, of the first output; of a scattered forest (field data
 * SiteId) those that forest-blocks="..." names, if it does. Where it names an elevation
 * [degrees] and the source is the first thing in its view, the camera looks from that far above the horizon, z upwards,
 * and so many times closer than ParaView would go to show all. With own-levels="1" it is a Full Surface, not decimated
 * while the camera moves: it would tear leaves and crowns to shreds. Later changes by the user, and those of a state
 * file, stay.
 */
class NaturalDisplay
{
public:
  explicit NaturalDisplay(vtkSMSourceProxy* owner)
    : Owner(owner)
  {
  }
  ~NaturalDisplay();
  NaturalDisplay(const NaturalDisplay&) = delete;
  void operator=(const NaturalDisplay&) = delete;

  /// To be called when the owner has a session.
  void Watch();

private:
  const char* Hint(const char* name);
  void OnRegister(vtkObject*, unsigned long, void* information);
  void TakeColors(vtkSMProxy* representation, int port);
  void WaitForData(vtkSMProxy* representation, int port);
  void OnData(vtkObject*, unsigned long, void*);
  vtkSMRenderViewProxy* ActiveView();
  void WaitForLegend(vtkSMProxy* representation);
  void OnStartOfPicture(vtkObject*, unsigned long, void*);
  void StopWaitingForLegend();
  void WaitForCamera();
  void OnResetCamera(vtkObject*, unsigned long, void*);
  void OnPicture(vtkObject*, unsigned long, void*);
  void StopWaiting();

  vtkSMSourceProxy* Owner;
  vtkWeakPointer<vtkSMSessionProxyManager> Manager;
  unsigned long RegisterObserver = 0;
  vtkWeakPointer<vtkSMProxy> Empty; ///< what was shown without data
  int EmptyPort = 0;
  unsigned long DataObserver = 0;
  vtkWeakPointer<vtkSMProxy> Colored; ///< whose legend would mean nothing
  vtkWeakPointer<vtkSMRenderViewProxy> LegendView;
  unsigned long LegendObserver = 0;
  vtkWeakPointer<vtkSMRenderViewProxy> View; ///< whose camera is waited for
  vtkWeakPointer<vtkObject> Shown;           ///< what it shows on
  unsigned long ResetObserver = 0;
  unsigned long PictureObserver = 0;
  int PicturesToWait = 0;
};

}

#endif
