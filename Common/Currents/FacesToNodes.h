// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralFacesToNodes_h
#define LittoralFacesToNodes_h

#include "Numerics/Vector3.h"

#include <array>
#include <vector>

namespace littoral
{

/// Corners of a face of a mesh in plan view; the fourth of a triangle is -1.
using FaceCorners = std::array<int, 4>;

/**
 * Values in the faces of a mesh, as velocities of FVCOM, brought to its nodes: that of the plane of least squares
 * through the values of the faces around a node, at the node. It is exact where values are linear in the place. Where
 * these faces are too few or weigh more than LargestWeight, as at a coast, their neighbours are taken too; where that
 * does not help either, the mean.
 */
class FacesToNodes
{
public:
  static constexpr double LargestWeight = 3.0; ///< sum of the magnitudes of the weights of a node

  FacesToNodes() = default;
  FacesToNodes(const std::vector<std::array<double, 2>>& nodes, const std::vector<FaceCorners>& faces);

  /// The value at a node, of those of all faces; NaN if one of its faces is, and at a node without faces.
  double At(int node, const double* values) const;
  Vector3 At(int node, const Vector3* values) const;

private:
  std::vector<int> Begin; ///< of each node in the lists below
  std::vector<int> Faces;
  std::vector<double> Weights;
};

}

#endif
