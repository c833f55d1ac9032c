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

/// A point with a x + b y + c z + d >= 0 is inside.
using Plane = std::array<double, 4>;

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

/// Reach of a box along a plane's normal from its middle: the sum of |n . h| over its half edges h
double ReachOf(const InstanceBox& box, const Plane& plane)
{
  double reach = 0.0;
  for (const auto& half : box.Halves)
  {
    reach += std::abs(vtkMath::Dot(plane.data(), half.data()));
  }
  return reach;
}

/// Whether some of a box is on the inner side of each plane.
bool IsInside(const InstanceBox& box, const std::array<Plane, 6>& planes)
{
  return std::all_of(planes.begin(), planes.end(), [&](const Plane& plane) {
    return vtkMath::Dot(plane.data(), box.Center.data()) + plane[3] >= -ReachOf(box, plane);
  });
}

}

//----------------------------------------------------------------------------
std::vector<float> InstancesInSight(const InstanceBatch& batch, const vtkMatrix4x4* toClip)
{
  const std::array<Plane, 6> planes = PlanesOf(toClip);
  std::vector<float> shown;
  auto instance = batch.Values.begin();
  for (const InstanceBox& box : batch.Boxes)
  {
    if (IsInside(box, planes))
    {
      shown.insert(shown.end(), instance, instance + InstanceBatch::Numbers);
    }
    instance += InstanceBatch::Numbers;
  }
  return shown;
}

}
