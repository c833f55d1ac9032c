// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPlantSway_h
#define LittoralPlantSway_h

#include "BeamModes.h"
#include "Parallel.h"
#include "Skeleton.h"
#include "WindLoads.h"
#include "WoodParameters.h"

#include <array>
#include <functional>
#include <vector>

namespace littoral
{

/// How the response of a branch is found.
enum class SwayResponse
{
  Interpolated = 0, ///< from three orthogonal beams in the wind at the plant's middle (eq. 25, halved)
  Direct = 1        ///< each beam has the wind where it is, and a recurrence of its own
};

/// How a plant answers to the wind.
struct SwayOptions
{
  int NumberOfModes = 1; ///< 1 to MostModes
  SwayResponse Response = SwayResponse::Interpolated;
  WindLoadParameters Load; ///< eq. 25 goes with the drag law Projection and without lift, whatever is said here
  WoodParameters Wood;
  bool Gravity = false;   ///< adds weight to plants that stand as if there were none
  bool Carries = true;    ///< a branch bears mass and drag of all that grows on it, spread along it
  double LeafDrag = 0.06; ///< drag coefficient of leaves, which fold in the wind, by their area
  double LeafMass = 0.2;  ///< of an area of leaves [kg/m2]
};

/// A branch as a uniform beam.
struct BranchBeam
{
  RoundBeam Beam;
  Vector3 Axis{ 0.0, 0.0, 1.0 };
  Vector3 Middle{ 0.0, 0.0, 0.0 }; ///< where it meets the wind [m]
  double DragDiameter = 0.1;       ///< of the bare cylinder with the same drag [m]
};

/// The branches of a valid skeleton as uniform beams that give way at the tip as the tapered ones do. Areas of leaves
/// [m2] are those on each node; or empty.
std::vector<BranchBeam> BeamsOf(
  const Skeleton& skeleton, const std::vector<double>& leafAreas, const SwayOptions& options);

/// The wind at a place over one period, in equal steps of time. Called from many threads.
using WindAtPlace = std::function<void(const Vector3& place, std::vector<Vector3>& velocities)>;

/**
 * The modal amplitudes of a plant's branches in a wind that repeats: a periodic steady state, tabulated once, from
 * which any time can be read without its past.
 */
class PlantSway
{
public:
  /// The wind's step [s]; `middle` [m] is where the interpolated response meets the wind.
  PlantSway(const std::vector<BranchBeam>& beams, const SwayOptions& options, double step, const Vector3& middle,
    const WindAtPlace& wind, const ParallelFor& parallelFor = SerialFor);

  /// Memory of a table [bytes].
  static double TableBytes(std::size_t branches, const SwayOptions& options, std::size_t samples);

  /// The amplitudes at a time [s], any finite number, for PlantMotion: modes of a branch side by side.
  void Amplitudes(double time, Vector3* amplitudes) const;

private:
  using Triple = std::array<float, 3>;

  /// A mode of a branch.
  struct Motion
  {
    Vector3 Axis;
    Vector3 Rest; // amplitude under its weight [m]
    double Gain;  // amplitude for a unit of the table
    int Column;   // of the table, the first of four
    std::array<double, 4> Weights;
  };

  double Step;
  bool Shared; // whether motions read between the columns of all, or each its own
  std::size_t Samples = 0;
  std::size_t Columns = 0;
  std::vector<Motion> Motions;
  std::vector<Triple> Table; // row by row, a time each

  void TabulateOrthogonal(const std::vector<double>& frequencies, double damping, const std::vector<Vector3>& wind,
    const ParallelFor& parallelFor);
  void TabulateEach(const std::vector<BranchBeam>& beams, const SwayOptions& options, const WindAtPlace& wind,
    const ParallelFor& parallelFor);
  void Store(std::size_t column, const std::vector<Vector3>& series);
};

}

#endif
