// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralLinearVelocity_h
#define LittoralLinearVelocity_h

// Linear interpolation of velocities between their samples along three axes.

#include "Numerics/Vector3.h"

#include <algorithm>
#include <array>
#include <functional>
#include <vector>

namespace littoral
{

/// A place among the samples of one axis: the sample before it and the share of the next.
struct AxisPlace
{
  int Index = 0;
  double Share = 0.0;
};

/// Finds the place of a position among samples at 0, 1 ... samples - 1; a single one holds everywhere. False outside.
inline bool FindPlace(int samples, double position, AxisPlace& place)
{
  if (samples == 1)
  {
    place = {};
    return true;
  }
  if (!(position >= 0.0 && position <= samples - 1))
  {
    return false;
  }
  place.Index = std::min(static_cast<int>(position), samples - 2);
  place.Share = position - place.Index;
  return true;
}

/// Finds the place of a position among samples at the nodes, which rise or fall; a single one holds everywhere. False
/// outside.
inline bool FindPlace(const std::vector<double>& nodes, double position, AxisPlace& place)
{
  if (nodes.size() == 1)
  {
    place = {};
    return true;
  }
  const bool rising = nodes.front() < nodes.back();
  if (!(position >= std::min(nodes.front(), nodes.back()) && position <= std::max(nodes.front(), nodes.back())))
  {
    return false;
  }
  const auto after = rising ? std::upper_bound(nodes.begin(), nodes.end(), position)
                            : std::upper_bound(nodes.begin(), nodes.end(), position, std::greater<double>());
  const int next = std::clamp(static_cast<int>(after - nodes.begin()), 1, static_cast<int>(nodes.size()) - 1);
  const double width = nodes[next] - nodes[next - 1];
  place = { next - 1, width != 0.0 ? (position - nodes[next - 1]) / width : 0.0 };
  return true;
}

/// Trilinear interpolation between the eight samples around a place, `valueAt(n)` with the number n = i + samples[0] (j
/// + samples[1] k). One layer of samples holds all along its axis.
template <typename ValueAt>
Vector3 Trilinear(const ValueAt& valueAt, const std::array<int, 3>& samples, const std::array<AxisPlace, 3>& place)
{
  Vector3 sum(0.0);
  for (int corner = 0; corner < 8; ++corner)
  {
    double weight = 1.0;
    long long number = 0;
    long long stride = 1;
    for (int axis = 0; axis < 3; ++axis)
    {
      const int side = (corner >> axis) & 1;
      weight *= side ? place[axis].Share : 1.0 - place[axis].Share;
      number += stride * std::min(place[axis].Index + side, samples[axis] - 1);
      stride *= samples[axis];
    }
    if (weight != 0.0)
    {
      sum += weight * valueAt(number);
    }
  }
  return sum;
}

/// Whether no sample of the layers around a place along the third axis has a vertical velocity there.
template <typename ValueAt>
bool IsLevel(const ValueAt& valueAt, const std::array<int, 3>& samples, const AxisPlace& height)
{
  for (int j = 0; j < samples[1]; ++j)
  {
    for (int i = 0; i < samples[0]; ++i)
    {
      if (Trilinear(valueAt, samples, { AxisPlace{ i, 0.0 }, { j, 0.0 }, height }).z != 0.0)
      {
        return false;
      }
    }
  }
  return true;
}

}

#endif
