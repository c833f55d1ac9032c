// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/LeafInclination.h"

#include "Numerics/Constants.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

constexpr double Width = 0.5 * Pi / LeafInclination::Classes;

}

double ProjectionOf(double inclination, double zenith)
{
  // cos t cos a, times 1 + 2 (tan p - p) / pi where the leaf is seen from both sides, cos p = cot t cot a
  const double both = std::cos(zenith) * std::cos(inclination);
  const double sines = std::sin(zenith) * std::sin(inclination);
  if (both >= sines)
  {
    return both;
  }
  const double p = std::acos(both / sines);
  // 2 / pi (sines sin p + both (pi / 2 - p)), which holds for both = 0 too
  return 2.0 / Pi * (sines * std::sin(p) + both * (0.5 * Pi - p));
}

void LeafInclination::Add(const Vector3& normal, double area)
{
  const double angle = std::atan2(std::hypot(normal.x, normal.y), std::abs(normal.z));
  this->Areas.Add(static_cast<std::size_t>(std::clamp(static_cast<int>(angle / Width), 0, Classes - 1)), area);
}

void LeafInclination::AddSphere(double area)
{
  for (int index = 0; index < Classes; ++index)
  {
    // share of a half sphere between two angles to its axis: the difference of their cosines
    this->Areas.Add(index, area * (std::cos(index * Width) - std::cos((index + 1) * Width)));
  }
}

void LeafInclination::Add(const LeafInclination& other, double factor)
{
  for (int index = 0; index < Classes; ++index)
  {
    this->Areas.Add(index, factor * other.Areas.At(index));
  }
}

double LeafInclination::Projection(double zenith) const
{
  double area = 0.0;
  double projected = 0.0;
  for (int index = 0; index < Classes; ++index)
  {
    // G = sum of areas times projections over sum of areas
    area += this->Areas.At(index);
    projected += this->Areas.At(index) * ProjectionOf((index + 0.5) * Width, zenith);
  }
  return area > 0.0 ? projected / area : 0.5;
}

}
