// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef CameraPicture_h
#define CameraPicture_h

// Where places are in the picture of a camera, by the camera's own matrices.

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"

#include <cmath>
#include <limits>
#include <random>

class CameraPicture
{
public:
  CameraPicture(vtkCamera* camera, int width, int height)
    : Width(width)
    , Height(height)
  {
    vtkMatrix4x4::DeepCopy(
      this->Matrix, camera->GetCompositeProjectionTransformMatrix(static_cast<double>(width) / height, -1.0, 1.0));
  }

  /// Whether a place is on the picture and between the clipping planes.
  bool Shows(const double place[3]) const
  {
    double clip[4];
    this->Project(place, clip);
    return clip[3] > 0.0 && std::abs(clip[0]) <= clip[3] && std::abs(clip[1]) <= clip[3] &&
      std::abs(clip[2]) <= clip[3];
  }

  /// How far apart two places are [pixels]; infinite where one is behind the eye.
  double PixelsBetween(const double a[3], const double b[3]) const
  {
    double p[4];
    double q[4];
    this->Project(a, p);
    this->Project(b, q);
    return p[3] > 0.0 && q[3] > 0.0
      ? 0.5 * std::hypot(this->Width * (p[0] / p[3] - q[0] / q[3]), this->Height * (p[1] / p[3] - q[1] / q[3]))
      : std::numeric_limits<double>::infinity();
  }

private:
  void Project(const double place[3], double clip[4]) const
  {
    const double point[4] = { place[0], place[1], place[2], 1.0 };
    vtkMatrix4x4::MultiplyPoint(this->Matrix, point, clip);
  }

  double Matrix[16];
  int Width;
  int Height;
};

/// Sets a camera anywhere within a distance [m] about a place, towards somewhere about it: in perspective of up to 120
/// degrees along either side of the picture, or in parallel projection.
inline void LookFromAnywhere(vtkCamera* camera, std::mt19937& random, const double about[3], double distance)
{
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto near = [&](double reach, double to[3]) {
    for (int axis = 0; axis < 3; ++axis)
    {
      to[axis] = about[axis] + reach * uniform(random);
    }
  };
  double place[3];
  near(distance, place);
  place[2] = about[2] + std::abs(place[2] - about[2]);
  camera->SetPosition(place);
  near(0.4 * distance, place);
  camera->SetFocalPoint(place);
  camera->SetViewUp(0.3 * uniform(random), 0.3 * uniform(random), 1.0);
  camera->SetViewAngle(62.5 + 57.5 * uniform(random));
  camera->SetUseHorizontalViewAngle(uniform(random) > 0.3);
  camera->SetParallelProjection(uniform(random) > 0.0);
  camera->SetParallelScale(distance * (0.52 + 0.5 * uniform(random)));
  camera->SetClippingRange(1e-4 * distance, 10.0 * distance);
}

#endif
