// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralLeafMotion_h
#define LittoralLeafMotion_h

#include "Numerics/RandomStream.h"
#include "Numerics/Vector3.h"
#include "Plants/Skinning.h"

#include <array>
#include <cstdint>

namespace littoral
{

/// How leaves answer to the wind (eq. 26 of Setas et al.).
struct LeafMotionOptions
{
  std::array<double, 2> AligningSpeeds{ 2.0, 14.0 };  ///< where k1 begins and ends to rise [m/s]
  double LargestAlignment = 0.6;                      ///< of k1, 0 to 1
  std::array<double, 2> FlutteringSpeeds{ 0.3, 6.0 }; ///< where k2 begins and ends to rise [m/s]
  double FlutterAngle = 0.7;                          ///< the range of angles at k2 = 1 [rad]
  double FlutterRate = 4.0;                           ///< new random angles a second [Hz]
  double Period = 0.0;                                ///< after which the motion repeats [s]; 0 for never
  int Seed = 1;
};

/// A smooth step from 0 at the first speed to 1 at the second.
double RiseBetween(double speed, const std::array<double, 2>& speeds);

/// Random angles that are a function of a leaf and a time alone, and vary smoothly with time.
class LeafFlutter
{
public:
  explicit LeafFlutter(const LeafMotionOptions& options);

  /// Two angles as parts of the range, each from -1/2 to 1/2, at a time [s], any finite number.
  std::array<double, 2> At(std::uint64_t leaf, double time) const;

private:
  RandomStream Random;
  double Rate;
  double Cells; // in a period; 0 where there is none
  double Period;
};

/// A leaf as a quadrilateral of a plant's mesh.
struct LeafCorners
{
  std::array<int, 4> Corners{}; ///< vertices: the first is the foot, the third the tip
  int Node = 0;                 ///< of the skeleton, which carries the leaf
  double Area = 0.0;            ///< [m2]
};

/// A leaf that its twig has already carried along.
struct LeafAxes
{
  Vector3 Main;   ///< from foot to tip, of unit length
  Vector3 Facing; ///< at a right angle to it, of unit length
};

/**
 * The rotation of a leaf about its foot: the main axis goes towards the wind along the great circle, and flutters. The
 * secondary axis stays at a right angle to it. No wind, no rotation, exactly.
 */
glm::dquat LeafRotation(
  const LeafAxes& leaf, const Vector3& wind, const std::array<double, 2>& flutter, const LeafMotionOptions& options);

/// Turns a leaf of four corners about the first of them; the third is its tip. Points and normals (which may be null)
/// are tuples of three, of which the corners are indices.
void TurnLeaf(const std::array<int, 4>& corners, const Vector3& wind, const std::array<double, 2>& flutter,
  const LeafMotionOptions& options, float* points, float* normals);

}

#endif
