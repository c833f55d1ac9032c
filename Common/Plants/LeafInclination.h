// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralLeafInclination_h
#define LittoralLeafInclination_h

#include "Plants/CanopyCells.h"

namespace littoral
{

/// Shares of the leaf area by the angle of the leaf to the horizontal, in classes of a degree.
class LeafInclination
{
public:
  static constexpr int Classes = 90;

  LeafInclination()
    : Areas(Classes)
  {
  }

  /// Adds an area [m2] with a normal of any length but 0, of any sign. From any thread.
  void Add(const Vector3& normal, double area);

  /// Adds an area [m2] whose normals are those of a sphere.
  void AddSphere(double area);

  /// Adds those of another, times a factor.
  void Add(const LeafInclination& other, double factor);

  /// Mean projection G of a unit of leaf area on a plane across a direction at an angle to the vertical [rad], leaves
  /// facing all azimuths alike; 0.5 without leaves.
  double Projection(double zenith) const;

private:
  OrderFreeSums Areas;
};

/// Mean projection over all azimuths of a leaf at an angle to the horizontal, on a plane across a direction at an angle
/// to the vertical [rad] (Warren Wilson 1960).
double ProjectionOf(double inclination, double zenith);

}

#endif
