// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPlantSway_h
#define LittoralPlantSway_h

#include "Plants/Skeleton.h"
#include "Plants/WoodParameters.h"
#include "Sway/BeamModes.h"
#include "Sway/TrunkModes.h"
#include "Wind/WindLoads.h"
#include "Wind/WindTimes.h"

#include <array>
#include <vector>

namespace littoral
{

/// Methods for the response of a branch.
enum class SwayResponse
{
  Interpolated = 0, ///< from three orthogonal beams in the wind at the plant's middle (eq. 25, halved)
  Direct = 1        ///< each beam has the wind where it is, and a recurrence of its own
};

/// Options of the response of a plant to the wind.
struct SwayOptions
{
  int NumberOfModes = 1; ///< 1 to MaximumModes
  SwayResponse Response = SwayResponse::Interpolated;
  WindLoadParameters Load; ///< eq. 25 goes with the law Projection, whatever is said here
  WoodParameters Wood;
  bool Gravity = false;          ///< adds weight to plants that stand as if there were none
  bool Carries = true;           ///< a branch bears mass and drag of all that grows on it, spread along it
  double LeafDrag = 0.06;        ///< drag coefficient of leaves, which fold in the wind, by their area
  double LeafMass = 0.35;        ///< of an area of leaves with the twigs that bear them [kg/m2]
  double LeafAreaRatio = 3500.0; ///< of leaves to the trunk's section at the crown's base; 0: leaves as drawn
};

/// A branch as a uniform beam, or the trunk.
struct BranchBeam
{
  RoundBeam Beam;
  std::vector<TrunkMode> Modes; ///< of a trunk; the uniform beam's where there are none
  Vector3 Axis{ 0.0, 0.0, 1.0 };
  Vector3 Middle{ 0.0, 0.0, 0.0 }; ///< where it meets the wind [m]
  double DragDiameter = 0.1;       ///< of the bare cylinder with the same drag [m]
};

/// The branches of a valid skeleton as uniform beams that give way at the tip as the tapered ones do; the trunk with
/// its own modes. Areas of leaves [m2] are those on each node; or empty.
std::vector<BranchBeam> BeamsOf(
  const Skeleton& skeleton, const std::vector<double>& leafAreas, const SwayOptions& options);

/// The first of BeamsOf for a plant that was scaled and turned about the vertical [rad]. Its middle is left at the
/// origin.
BranchBeam TrunkBeam(const TrunkMeasures& trunk, double scale, double azimuth, const SwayOptions& options);

/**
 * The modal amplitudes of a plant's branches in a wind that repeats: the periodic steady state. Any time can be asked
 * for, and has the same bytes whatever was asked before. A table holds a short window of time around the last
 * one asked for; the next window starts from rest the settling time of the slowest branch before. So memory does not
 * grow with the wind.
 */
class PlantSway
{
public:
  /// `middle` [m] is where the interpolated response meets the wind.
  PlantSway(const std::vector<BranchBeam>& beams, const SwayOptions& options, const WindTimes& times,
    const Vector3& middle, const WindAtPlace& wind);

  /// Memory of a plant at most [bytes].
  static double BytesOf(std::size_t branches, const SwayOptions& options);

  /// The amplitudes at a time [s], any finite number, for PlantMotion: modes of a branch side by side. One thread at a
  /// time.
  void Amplitudes(double time, Vector3* amplitudes);

  /// The wind at the plant's middle at a time [s]. One thread at a time.
  Vector3 Wind(double time);

private:
  /// A mode of a branch.
  struct Motion
  {
    Vector3 Axis;
    Vector3 Rest; // amplitude under its weight [m]
    double Gain;  // amplitude for a unit of the table, across the beam
    double Lift;  // and across that
    int Column;   // of the table, the first of those that are read
    std::array<double, 4> Weights;
  };

  WindTimes Times;
  Vector3 Middle;
  WindAtPlace WindAt;
  WindLoadParameters Load;
  double Damping;
  std::vector<Motion> Motions;
  std::vector<double> Frequencies; // of the columns
  int Taps = 1;                    // columns that a motion reads
  std::vector<BranchBeam> Beams;   // of the direct response; else empty
  std::size_t Offset = 0;          // samples, of the first window, so that not all plants begin one at the same time
  long long Window = -1;           // that the table holds; -1: none
  std::vector<float> Table;        // by sample, axis and column
  std::vector<Vector3> Winds;      // at the middle, each half a step
  std::vector<double> Now;         // by axis and column

  long long Follow(long long sample);
  void TabulateWind(long long first, const Vector3* whole);
  void TakeColumns(const std::vector<double>& frequencies);
  void Tabulate(long long first);
  void TabulateShared(long long first);
  void TabulateBranch(std::size_t branch, long long first);
};

}

#endif
