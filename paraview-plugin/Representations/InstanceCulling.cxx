// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "InstanceCulling.h"

#include "vtkMath.h"
#include "vtkMatrix4x4.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace littoral
{
namespace
{

constexpr double Margin = 1.001; // of radii, for numbers in single precision

/// A point with a x + b y + c z + d >= 0 is inside.
using Plane = std::array<double, 4>;

struct Sphere
{
  double Center[3];
  double Radius;
};

/// The planes -w <= x, y, z <= w, with normals of length 1  (Gribb and Hartmann 2001)
std::array<Plane, 6> PlanesOf(const vtkMatrix4x4* toClip)
{
  std::array<Plane, 6> planes;
  for (int side = 0; side < 6; ++side)
  {
    Plane& plane = planes[side];
    for (int k = 0; k < 4; ++k)
    {
      plane[k] = toClip->GetElement(3, k) + (side % 2 ? -1.0 : 1.0) * toClip->GetElement(side / 2, k);
    }
    const double length = std::max(vtkMath::Norm(plane.data()), 1e-300);
    std::for_each(plane.begin(), plane.end(), [length](double& number) { number /= length; });
  }
  return planes;
}

/// The sphere around a box that is placed as InstanceMapper's shader places points: p -> place + scale R (g x, g y, z)
Sphere SphereOf(const vtkBoundingBox& box, const float* instance)
{
  const double girth = instance[11];
  double own[3];
  double lengths[3];
  box.GetCenter(own);
  box.GetLengths(lengths);
  const double rotation[4] = { instance[7], instance[4], instance[5], instance[6] };
  const double wide[3] = { girth * own[0], girth * own[1], own[2] };
  Sphere sphere;
  vtkMath::RotateVectorByNormalizedQuaternion(wide, rotation, sphere.Center);
  for (int axis = 0; axis < 3; ++axis)
  {
    sphere.Center[axis] = instance[axis] + instance[3] * sphere.Center[axis];
  }
  const double diagonal = std::hypot(girth * lengths[0], girth * lengths[1], lengths[2]);
  sphere.Radius = Margin * 0.5 * std::abs(instance[3]) * diagonal;
  return sphere;
}

bool IsInside(const Sphere& sphere, const std::array<Plane, 6>& planes)
{
  return std::all_of(planes.begin(), planes.end(),
    [&](const Plane& plane) { return vtkMath::Dot(plane.data(), sphere.Center) + plane[3] >= -sphere.Radius; });
}

}

//----------------------------------------------------------------------------
std::vector<float> InstancesInSight(const InstanceBatch& batch, const vtkMatrix4x4* toClip)
{
  const std::array<Plane, 6> planes = PlanesOf(toClip);
  std::vector<float> shown;
  for (auto instance = batch.Values.begin(); instance != batch.Values.end(); instance += InstanceBatch::Numbers)
  {
    if (IsInside(SphereOf(batch.Prototype, &*instance), planes))
    {
      shown.insert(shown.end(), instance, instance + InstanceBatch::Numbers);
    }
  }
  return shown;
}

}
