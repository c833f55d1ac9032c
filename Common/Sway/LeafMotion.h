// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralLeafMotion_h
#define LittoralLeafMotion_h

#include "Numerics/RandomStream.h"
#include "Numerics/Vector3.h"
#include "Plants/Skinning.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace littoral
{

/// Parameters of the motion of leaves in the wind (eq. 26 of Setas et al.).
struct LeafMotionOptions
{
  std::array<double, 2> AligningSpeeds{ 2.0, 14.0 };  ///< where k1 begins and ends to rise [m/s]
  double MaximumAlignment = 0.6;                      ///< of k1, 0 to 1
  std::array<double, 2> FlutteringSpeeds{ 0.3, 6.0 }; ///< where k2 begins and ends to rise [m/s]
  double FlutterAngle = 0.7;                          ///< the range of angles at k2 = 1 [rad]
  double FlutterRate = 4.0;                           ///< new random angles a second [Hz]
  double Period = 0.0;                                ///< after which the motion repeats [s]; 0 for never
  int Seed = 1;
};

/// A smooth step from 0 at the first speed to 1 at the second.
double RiseBetween(double speed, const std::array<double, 2>& speeds);

/// A leaf that flutters, a quadrilateral of a mesh: the first corner is its foot, the third its tip. What is drawn for
/// it at random is kept until it is no longer needed.
struct FlutteringLeaf
{
  static constexpr std::int64_t NoCell = -(std::int64_t(1) << 62);

  std::array<int, 4> Corners{};
  int Plant = 0;                 ///< whose wind it has
  float Phase = 0.0f;            ///< part of a cell of time by which its cells begin earlier, 0 to 1
  std::uint64_t Identity = 0;    ///< object of its random numbers
  std::int64_t Cell = NoCell;    ///< of time, at whose ends its angles are known
  std::array<float, 2> Before{}; ///< angles at the beginning of the cell, 0 to 1
  std::array<float, 2> After{};  ///< and at its end
};

/// Random angles that are a function of a leaf and a time alone, and vary smoothly with time.
class LeafFlutter
{
public:
  explicit LeafFlutter(const LeafMotionOptions& options);

  /// A time as a cell, and the part of it that has passed.
  struct Moment
  {
    std::int64_t Cell;
    double Part;
  };

  /// Factors of a time [s], any finite number.
  Moment MomentOf(double time) const;

  /// A leaf whose phase is drawn.
  FlutteringLeaf Leaf(const std::array<int, 4>& corners, int plant, std::uint64_t identity) const;

  /// Draws the angles around a moment, unless the leaf has them: one draw a cell for those who follow time.
  void Follow(const Moment& moment, FlutteringLeaf& leaf) const
  {
    const std::int64_t cell = this->CellOf(moment, leaf);
    if (cell != leaf.Cell)
    {
      this->Draw(cell, leaf);
    }
  }

  /// Two angles as parts of the range, each from -1/2 to 1/2, at a time [s], any finite number.
  std::array<double, 2> At(std::uint64_t leaf, double time) const;

private:
  RandomStream Random;
  double Rate;
  std::int64_t Cells; // in a period; 0 where there is none
  double Period;

  std::int64_t Wrapped(std::int64_t cell) const { return cell == this->Cells && cell > 0 ? 0 : cell; }
  std::int64_t CellOf(const Moment& moment, const FlutteringLeaf& leaf) const
  {
    return this->Wrapped(moment.Cell + (moment.Part + leaf.Phase >= 1.0 ? 1 : 0));
  }
  std::array<float, 2> Angles(std::uint64_t identity, std::int64_t cell) const;
  void Draw(std::int64_t cell, FlutteringLeaf& leaf) const;
};

/// A leaf as a quadrilateral of a plant's mesh.
struct LeafCorners
{
  std::array<int, 4> Corners{}; ///< vertices: the first is the foot, the third the tip
  int Node = 0;                 ///< of the skeleton, which carries the leaf
  double Area = 0.0;            ///< [m2]
};

/// Effect of the wind on the leaves of a plant.
struct LeafWind
{
  Vector3 Direction{ 0.0, 0.0, 1.0 }; ///< of unit length
  double Alignment = 0.0;             ///< k1, 0 to 1
  double Range = 0.0;                 ///< of the angles of flutter, k2 times the largest one [rad]
};

/// Effect of a wind [m/s].
LeafWind LeafWindOf(const Vector3& wind, const LeafMotionOptions& options);

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
glm::dquat LeafRotation(const LeafAxes& leaf, const LeafWind& wind, const std::array<double, 2>& flutter);

/// Turns the leaves [begin, end) about their feet at a time, each in the wind of its plant. Points and normals (which
/// may be null) are tuples of three, of which the corners are indices; no two leaves share a corner.
void TurnLeaves(const LeafFlutter& flutter, const LeafFlutter::Moment& moment, const LeafWind* winds, std::size_t begin,
  std::size_t end, FlutteringLeaf* leaves, float* points, float* normals);

}

#endif
