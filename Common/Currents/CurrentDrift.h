// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralCurrentDrift_h
#define LittoralCurrentDrift_h

#include "Currents/WaterLayer.h"
#include "Numerics/Vector3.h"

namespace littoral
{

/**
 * One step of the classical Runge-Kutta method of fourth order along a current: eq. 3 of Coulais et al., in place of
 * Euler's method, with which particles leave a vortex in spirals. `velocity(place, stage)` is the current at the
 * beginning (stage 0), the middle (1) and the end (2) of the step. `ahead` becomes where half a step along the first
 * velocity leads to: where a step is too long, the method can stand still between velocities that cancel, but this way
 * shows what lies ahead.
 *
 * No current of FlowField or of a grid leads through the bed or the surface. What a step of finite length still puts
 * beyond them is mirrored, so that no point leaves the water.
 */
template <typename Velocity>
Vector3 DriftStep(
  const WaterLayer& layer, const Vector3& place, double step, const Velocity& velocity, Vector3* ahead = nullptr)
{
  const auto mirrored = [&](Vector3 at, int stage) {
    bool upright = true;
    at.z = layer.Fold(at.z, upright);
    Vector3 flow = velocity(at, stage);
    flow.z = upright ? flow.z : -flow.z;
    return flow;
  };
  // k_1 = v(x), k_2 = v(x + h/2 k_1), k_3 = v(x + h/2 k_2), k_4 = v(x + h k_3)
  const Vector3 first = mirrored(place, 0);
  const Vector3 midway = place + 0.5 * step * first;
  if (ahead)
  {
    *ahead = midway;
  }
  const Vector3 second = mirrored(midway, 1);
  const Vector3 third = mirrored(place + 0.5 * step * second, 1);
  const Vector3 fourth = mirrored(place + step * third, 2);
  // x + h/6 (k_1 + 2 k_2 + 2 k_3 + k_4)
  Vector3 moved = place + step / 6.0 * (first + 2.0 * second + 2.0 * third + fourth);
  bool upright = true;
  moved.z = layer.Fold(moved.z, upright);
  return moved;
}

}

#endif
