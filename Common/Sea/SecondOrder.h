// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSecondOrder_h
#define LittoralSecondOrder_h

#include "Sea/WaveTrains.h"

#include <vector>

namespace littoral
{

/// Second order of the elevation by a pair of trains, over the product of their amplitudes.
struct PairKernel
{
  double Elevation; ///< of each of the two terms of the double sum, a_i a_j B cos(phi_i +- phi_j) [1/m]
  double Potential; ///< D of the velocity potential [1/m2]
};

/**
 * Kernel of the sum (sign 1) or the difference (sign -1) of two trains at a fixed place (Sharma and Dean 1981). On the
 * surface eta = sum over i, j of a_i a_j [B+ cos(phi_i + phi_j) + B- cos(phi_i - phi_j)]; below, the potential of a
 * pair is g2 D / (2 w_i w_j W) cosh K(z+h) / cosh Kh sin(phi_i +- phi_j), with K = |k_i +- k_j| and W = w_i +- w_j. The
 * difference of a train and itself is its set-down, -k / (2 sinh 2kh).
 */
PairKernel PairKernelOf(const WaveTrain& first, const WaveTrain& second, double depth, double sign);

/// Points that move with bound waves.
enum class BoundMotion
{
  Particles, ///< water that is followed: what its orbit in the trains holds already is taken off
  Surface,   ///< the same at sea level, all of it in the vertical; for places and their gradients
  Places,    ///< the flow at fixed places
};

/**
 * A wave that two trains force, with the phase phi_First + Sign phi_Second. It moves water by Along cosh K(z+h) / sinh
 * Kh sin(phase) horizontally and by Up sinh K(z+h) / sinh Kh cos(phase) vertically, K being Profile; Sign 0 is a rise
 * of the level, with no phase.
 */
struct BoundWave
{
  int First;
  int Second;
  double Sign;
  double Profile;  ///< [rad/m]
  double Along[2]; ///< [m]
  double Up;       ///< [m]
};

/// Bound waves that are asked for.
struct BoundWaveOptions
{
  BoundMotion Motion = BoundMotion::Particles;
  double SkewnessLeftOut = 0.001; ///< change of the elevation's skewness by all pairs that are left out, at most
};

/**
 * Bound waves of a sea. Particles whose horizontal motion in trains is multiplied by choppiness, 0 to 1, get in the
 * vertical what they lack, so that the elevation at a fixed place is that of second order. Pairs with the least effect
 * on the skewness of the elevation are left out. The drift of particles within groups of waves is not among the
 * motions: see StokesDrift of WaveOrbitOptions for its mean.
 */
std::vector<BoundWave> BoundWavesOf(const SeaState& sea, const BoundWaveOptions& options, double choppiness);

/**
 * Whether the surface is that of trains of one direction on deep water, in the order of their wave numbers: it lacks
 * but 1/2 sum a_i a_j min(k_i, k_j) cos(phi_i - phi_j) in the vertical, by sums of trains up to each in turn.
 */
bool IsSortedLongCrestedDeep(const SeaState& sea);

/**
 * Skewness of the elevation at a fixed place, to second order: 3 <eta1^2 eta2> / m0^1.5. In deep water, long-crested,
 * it is 3 sum v_i v_j min(k_i, k_j) / m0^1.5 with v = a2/2.
 */
double SkewnessOf(const SeaState& sea);

}

#endif
