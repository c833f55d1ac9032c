// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralVelocitySpline_h
#define LittoralVelocitySpline_h

#include "Numerics/Parallel.h"
#include "Numerics/Vector3.h"

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace littoral
{

/// The B-splines through samples along an axis: cubic, with no knots at the second and the last but one (not-a-knot).
/// Of three samples they are parabolas, of two straight lines, and one sample holds everywhere.
class SplineAxis
{
public:
  static constexpr int MaximumWeights = 4;

  /// Coefficients that make up a value, from First on, and their weights.
  struct Weights
  {
    int First = 0;
    std::array<double, MaximumWeights> Values{ { 1.0, 0.0, 0.0, 0.0 } };
  };

  SplineAxis() = default;
  /// Axis with samples at these places, strictly rising or falling.
  explicit SplineAxis(const std::vector<double>& nodes);

  static bool IsMonotone(const std::vector<double>& nodes);

  int Size() const { return this->Count; }
  int NumberOfWeights() const { return this->Degree + 1; }

  /// False outside of the samples.
  bool At(double position, Weights& weights) const;

  /// Coefficients of values at the nodes, column by column: `columns` lines of Size() each.
  void Solve(std::vector<double>& values, std::size_t columns) const;

private:
  double Sign = 1.0; ///< -1 for nodes that fall
  int Count = 1;
  int Degree = 0;
  std::vector<double> Nodes; ///< rising
  std::vector<double> Knots;
};

/**
 * A field of velocities by its samples on a rectilinear grid, in tensor products of cubic splines: twice continuously
 * differentiable, and with an error of the fourth order in the spacing h. Derivatives at the samples are of the fourth
 * order too, so that the divergence of a field that has none stays small: linear interpolation has one of h^2/24 times
 * the third derivatives, which drives particles together slowly but for ever.
 */
class VelocitySpline
{
public:
  /// `sample(n)` is that with the number i + Size(0) (j + Size(1) k).
  /// With coefficients in single precision it takes half the memory.
  VelocitySpline(const std::array<SplineAxis, 3>& axes, const std::function<Vector3(std::size_t)>& sample,
    bool isSingle = false, const ParallelFor& parallel = SerialFor);

  /// Memory that it takes at most while it is made on so many threads [bytes].
  static double BytesOf(const std::array<std::size_t, 3>& samples, bool isSingle, int threads);

  /// The velocity at a position along the axes; at rest outside.
  Vector3 At(const Vector3& position) const;

private:
  std::array<SplineAxis, 3> Axes;
  std::vector<float> Single; ///< coefficients, three a sample; or
  std::vector<double> Double;
};

}

#endif
