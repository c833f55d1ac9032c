// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportCameraView_h
#define LittoralSupportCameraView_h

// View of a camera, for filters that depend on the view. Private: never installed, never wrapped.

#include "Geometry/ViewFrustum.h"
#include "Numerics/Constants.h"

#include "vtkCamera.h"

#include <cmath>

namespace littoral
{

/// A view from a camera into a picture of the aspect ratio and height of another view. Off-axis projections, shears and
/// shifts of the window's center are not taken.
inline View ViewOfCamera(vtkCamera* camera, const View& picture)
{
  const auto vectorOf = [](const double a[3]) { return Vector3(a[0], a[1], a[2]); };
  View view = picture;
  view.Point = vectorOf(camera->GetPosition());
  view.Direction = vectorOf(camera->GetDirectionOfProjection());
  view.Up = vectorOf(camera->GetViewUp());
  view.Angle = camera->GetViewAngle() * Pi / 180.0;
  if (camera->GetUseHorizontalViewAngle())
  {
    view.Angle = 2.0 * std::atan(std::tan(0.5 * view.Angle) / view.AspectRatio);
  }
  view.IsParallel = camera->GetParallelProjection() != 0;
  view.ParallelScale = camera->GetParallelScale();
  return view;
}

/// The same for a picture of so many pixels; one that has none yet leaves aspect ratio and height of the other view.
inline View ViewOfCamera(vtkCamera* camera, int width, int height, const View& other)
{
  View view = other;
  if (width > 0 && height > 0)
  {
    view.AspectRatio = static_cast<double>(width) / height;
    view.Height = height;
  }
  return ViewOfCamera(camera, view);
}

}

#endif
