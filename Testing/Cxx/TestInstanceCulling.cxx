// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Instances that are left out are those without a point in the view: points of their prototype are placed and projected
// one by one, by matrices of rotation.
#include "Check.h"
#include "InstanceCulling.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkNew.h"
#include "vtkTransform.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <string>
#include <vector>

namespace
{

constexpr int Instances = 400;
constexpr int Points = 5; // of the prototype along an edge of its box
constexpr double Low[3] = { 6.0, -12.0, 0.0 };
constexpr double High[3] = { 9.0, -8.0, 12.0 };

struct Chance
{
  vtkNew<vtkMinimalStandardRandomSequence> Sequence;
  double operator()(double from, double to)
  {
    this->Sequence->Next();
    return this->Sequence->GetRangeValue(from, to);
  }
};

littoral::InstanceBatch BatchOf(Chance& chance)
{
  littoral::InstanceBatch batch;
  const double bounds[6] = { Low[0], High[0], Low[1], High[1], Low[2], High[2] };
  for (int instance = 0; instance < Instances; ++instance)
  {
    std::array<double, 4> turn{ chance(-1.0, 1.0), chance(-1.0, 1.0), chance(-1.0, 1.0), chance(0.1, 1.0) };
    const double length = std::hypot(std::hypot(turn[0], turn[1]), std::hypot(turn[2], turn[3]));
    std::array<float, littoral::InstanceBatch::Numbers> values{};
    const double numbers[] = { chance(-200.0, 200.0), chance(-200.0, 200.0), chance(-20.0, 20.0), chance(0.3, 2.0),
      turn[0] / length, turn[1] / length, turn[2] / length, turn[3] / length, 1.0, 1.0, 1.0, chance(0.5, 2.0) };
    std::copy(std::begin(numbers), std::end(numbers), values.begin());
    batch.Add(values, vtkBoundingBox(bounds));
  }
  return batch;
}

/// Whether a point of the prototype, as an instance places it, is in the clip volume.
bool IsSeen(const float* instance, vtkMatrix4x4* toClip)
{
  vtkNew<vtkTransform> place; // the last that is set comes first
  place->Translate(instance[0], instance[1], instance[2]);
  const double half = std::acos(std::clamp(static_cast<double>(instance[7]), -1.0, 1.0));
  place->RotateWXYZ(2.0 * half * 57.29577951308232, instance[4], instance[5], instance[6]);
  place->Scale(instance[3] * instance[11], instance[3] * instance[11], instance[3]);
  for (int k = 0; k < Points * Points * Points; ++k)
  {
    const int steps[3] = { k % Points, k / Points % Points, k / Points / Points };
    double at[4] = { 0.0, 0.0, 0.0, 1.0 };
    for (int axis = 0; axis < 3; ++axis)
    {
      at[axis] = Low[axis] + (High[axis] - Low[axis]) * steps[axis] / (Points - 1.0);
    }
    place->TransformPoint(at, at);
    toClip->MultiplyPoint(at, at);
    if (std::abs(at[0]) <= at[3] && std::abs(at[1]) <= at[3] && std::abs(at[2]) <= at[3])
    {
      return true;
    }
  }
  return false;
}

/// All that a view shows are kept, in their order, and not many more.
bool TestView(const littoral::InstanceBatch& batch, vtkMatrix4x4* toClip)
{
  const std::vector<float> kept = littoral::InstancesInSight(batch, toClip);
  auto next = kept.begin();
  int seen = 0;
  bool good = true;
  for (auto instance = batch.Values.begin(); instance != batch.Values.end();
       instance += littoral::InstanceBatch::Numbers)
  {
    const bool isKept = next != kept.end() && std::equal(next, next + littoral::InstanceBatch::Numbers, instance);
    const bool isSeen = IsSeen(&*instance, toClip);
    good &= isKept || !isSeen;
    seen += isSeen;
    next += isKept ? littoral::InstanceBatch::Numbers : 0;
  }
  const auto count = static_cast<int>(kept.size() / littoral::InstanceBatch::Numbers);
  good = Check(good && next == kept.end(), "An instance in the view is left out, or the order is another.");
  return good & Check(count <= 1.3 * seen + 6, std::to_string(count) + " are kept, " + std::to_string(seen) + " seen.");
}

}

int TestInstanceCulling(int, char*[])
{
  Chance chance;
  const littoral::InstanceBatch batch = BatchOf(chance);
  bool good = true;
  for (int view = 0; view < 12; ++view)
  {
    vtkNew<vtkCamera> camera;
    camera->SetPosition(chance(-150.0, 150.0), chance(-150.0, 150.0), chance(-10.0, 60.0));
    camera->SetFocalPoint(chance(-50.0, 50.0), chance(-50.0, 50.0), 0.0);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetViewAngle(45.0);
    camera->SetParallelProjection(view % 2);
    camera->SetParallelScale(40.0);
    camera->SetClippingRange(1.0, 120.0);
    good &= TestView(batch, camera->GetCompositeProjectionTransformMatrix(1.7, -1.0, 1.0));
  }
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
