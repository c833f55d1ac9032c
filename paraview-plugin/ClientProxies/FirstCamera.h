// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralFirstCamera_h
#define LittoralFirstCamera_h

#include "vtkWeakPointer.h" // for what is watched

#include <array>
#include <functional>

class vtkCamera;
class vtkObject;
class vtkSMProxy;
class vtkSMRenderViewProxy;

namespace littoral
{

/// Whether a representation shows data in its view; a light does not.
bool ShowsData(vtkSMProxy* representation);

/// Whether nothing is shown in a view.
bool IsEmpty(vtkSMProxy* view);

/// Whether a view is in ParaView's mode of two dimensions.
bool IsFlat(vtkSMProxy* view);

/// Whether nobody, and no script of a state, has placed the camera of a view: it is ParaView's, or that of a picture
/// that shows nothing, before which ParaView resets it too.
bool HasFirstCamera(vtkSMRenderViewProxy* view);

/// Eye of a view in which a source is the first thing.
struct CameraPlace
{
  double Elevation = 0.0;     ///< over the horizon, of the eye seen from the middle of the data [degrees]
  double Closer = 1.0;        ///< than a camera that shows a sphere around the data
  bool IsOfFlatData = false;  ///< whether ParaView would look at them from above, in two dimensions
  bool IsOnMap = false;       ///< whether the source replaces what is seen from above
  bool IsBesideLight = false; ///< in a view whose camera ParaView does not reset, since it shows a light
  bool IsFixed = false;       ///< whether Eye and Target count instead
  double Eye[3] = { 0.0, 0.0, 0.0 };
  double Target[3] = { 0.0, 0.0, 0.0 };
  double Angle = 0.0; ///< of view, from the bottom to the top, of a fixed camera [degrees]; 0: the camera's
};

/// Moves a camera that shows all data, with z upwards.
void MoveCamera(vtkCamera* camera, const CameraPlace& place);

/// Moves a camera to where it shows all of a box, so that a level of detail for it has all in sight.
void MoveCamera(vtkCamera* camera, const CameraPlace& place, const double bounds[6]);

/// Makes the focal point of a camera the center of rotation, and a parallel projection show as much there as now.
void TurnAboutFocus(vtkSMRenderViewProxy* view);

/**
 * Waits for the moment at which ParaView, in the window or in a script, first resets the camera of a view, and moves it
 * then; what it looks at is the center of rotation. A picture with another camera, which someone must have chosen, ends
 * the waiting. A view that someone has in two dimensions is left alone.
 */
class FirstCamera
{
public:
  FirstCamera() = default;
  ~FirstCamera();
  FirstCamera(const FirstCamera&) = delete;
  void operator=(const FirstCamera&) = delete;

  void WaitFor(vtkSMRenderViewProxy* view, const CameraPlace& place);

  /// Whether the first reset of a camera is still to come.
  bool IsWaiting() const { return this->View != nullptr; }

  /// Shows all of what is drawn in the next picture, so many times closer than ParaView does, as the camera looks,
  /// unless someone moves it before.
  void ShowAll(vtkSMRenderViewProxy* view, double closer);

private:
  void OnStartWithData(vtkObject*, unsigned long, void*);
  void OnResetCamera(vtkObject*, unsigned long, void*);
  void OnStart(vtkObject*, unsigned long, void*);
  void LiftFlatData();
  void OnPicture(vtkObject*, unsigned long, void*);
  void Stop();

  CameraPlace Place;
  vtkWeakPointer<vtkSMRenderViewProxy> View;
  vtkWeakPointer<vtkObject> Shown; ///< window of the view
  unsigned long ResetObserver = 0;
  unsigned long PictureObserver = 0;
  unsigned long StartObserver = 0;
  int PicturesToWait = 0;
  bool WasReset = false;
  std::array<double, 6> Former{}; ///< where the camera was before the picture that shows all, and looked
};

}

#endif
