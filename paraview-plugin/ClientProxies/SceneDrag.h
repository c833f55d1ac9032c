// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSceneDrag_h
#define LittoralSceneDrag_h

#include "Numerics/Vector3.h"

#include "vtkWeakPointer.h" // for what is watched

#include <vector>

class vtkCamera;
class vtkObject;
class vtkSMProxy;
class vtkSMRenderViewProxy;

namespace littoral
{

/// Heights of an eye [m], over the property SeaLevel of a source if it has one.
struct EyeHeights
{
  double Elevation = -90.0; ///< least one over the horizon, seen from what the camera looks at [degrees]
  double Lowest = -1e30;
  double Highest = 1e30; ///< if below 0, the eye is under water, and stays above the bed of property WaterDepth too
};

/**
 * Keeps a camera that is dragged upright, on its side of the ground or the surface of the sea.
 *
 * ParaView's trackball rolls the horizon, and turns through the ground. A camera that was rolled, or brought to the
 * other side by other means than a drag, is left alone.
 */
class SceneDrag
{
public:
  SceneDrag() = default;
  ~SceneDrag();
  SceneDrag(const SceneDrag&) = delete;
  void operator=(const SceneDrag&) = delete;

  /// Starts with the next still picture of a view.
  void Keep(vtkSMRenderViewProxy* view, vtkSMProxy* source, const EyeHeights& heights);

  /// Scales the depths of an eye under water and of what it looks at, in the view that is kept and in others.
  void ScaleDepths(double ratio, std::vector<vtkSMRenderViewProxy*> views);

private:
  struct Sight
  {
    Vector3 Eye;
    Vector3 Focus;
    Vector3 Up;
  };

  static Sight SightOf(vtkCamera* camera);
  EyeHeights Limits() const;
  Sight Kept(const Sight& dragged) const;
  void OnStart(vtkObject*, unsigned long, void* isInteractive);

  EyeHeights Heights;
  vtkWeakPointer<vtkSMProxy> Source;
  vtkWeakPointer<vtkSMRenderViewProxy> View;
  unsigned long Observer = 0;
  Sight Former; ///< in the picture before
  bool IsKept = false;
};

}

#endif
