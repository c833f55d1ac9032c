// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volume.h"

#include <algorithm>

namespace littoral
{

namespace
{

constexpr int LeafSide = 8;
constexpr double BytesOfBox = 16.0 * 1024.0 * 1024.0;

double BytesOf(const std::array<int, 6>& box, int components)
{
  double samples = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    samples *= static_cast<double>(box[2 * axis + 1]) - box[2 * axis] + 1.0;
  }
  return samples * (sizeof(float) * static_cast<double>(components) + 1.0);
}

/// The largest number of leaves, at least one, that boxes can have along an axis, with so many samples across it.
long long LeavesAtOnce(int components, double samplesAcross)
{
  const double bytes = (sizeof(float) * static_cast<double>(components) + 1.0) * samplesAcross * LeafSide;
  return static_cast<long long>(std::clamp(BytesOfBox / std::max(1.0, bytes), 1.0, 1e8));
}

/// The parts of an axis of so many leaves each.
std::vector<std::array<int, 2>> PartsOf(int low, int high, long long leaves)
{
  std::vector<std::array<int, 2>> parts;
  long long first = low;
  while (first <= high)
  {
    const long long begin = first & ~static_cast<long long>(LeafSide - 1);
    const long long last = std::min<long long>(high, begin + LeafSide * leaves - 1);
    parts.push_back({ { static_cast<int>(first), static_cast<int>(last) } });
    first = last + 1;
  }
  return parts;
}

}

std::vector<std::array<int, 6>> BoxesToLoad(const VolumeBlock& block, int components)
{
  const auto along = static_cast<double>(block.Count(0));
  const auto across = static_cast<double>(block.Count(1));
  const long long layers = LeavesAtOnce(components, along * across);
  const long long rows = layers > 1 ? LeavesAtOnce(components, 0.0) : LeavesAtOnce(components, along * LeafSide);
  std::vector<std::array<int, 6>> boxes;
  for (const std::array<int, 2>& z : PartsOf(block.Extent[4], block.Extent[5], layers))
  {
    for (const std::array<int, 2>& y : PartsOf(block.Extent[2], block.Extent[3], rows))
    {
      boxes.push_back({ { block.Extent[0], block.Extent[1], y[0], y[1], z[0], z[1] } });
    }
  }
  return boxes;
}

double BytesToLoad(const VolumeBlock& block, int components)
{
  double bytes = 0.0;
  for (const std::array<int, 6>& box : BoxesToLoad(block, components))
  {
    bytes = std::max(bytes, BytesOf(box, components));
  }
  return bytes;
}

}
