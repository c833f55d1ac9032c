// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralWaveDirections_h
#define LittoralWaveDirections_h

#include "Numerics/CompositeQuadrature.h"
#include "Numerics/RandomStream.h"

#include <vector>

namespace littoral
{

/// Directional spreading of the energy of waves: cos^2s(angle/2) about their mean direction.
class WaveSpreading
{
public:
  /// Spreading of an exponent s, positive.
  explicit WaveSpreading(double exponent);

  /// The angle [rad] below which a part, 0 to 1, of the energy lies.
  double Quantile(double part) const;

  /// The mean cosine of the angle, s / (s + 1).
  double MeanCosine() const { return this->Exponent / (this->Exponent + 1.0); }

private:
  double Exponent;
  CompositeQuadrature Half; ///< over pi less the angle, 0 to pi, so that small densities keep their digits
};

/**
 * Angles from the mean direction [rad] of wave trains with these energies, in the order of their frequencies.
 *
 * The distribution is cut into strata with the energies of the trains; each train lies at random in its own. Strata are
 * dealt by van der Corput's sequence in a random order of Owen: of each 2^m trains next to each other in frequency, one
 * comes from each 2^m-th of the order, so that no side of the sea has the long waves. A few trains still miss the
 * moments of the distribution; angles are therefore stretched and turned until the mean direction by energy is 0 and
 * the length of the mean vector is the distribution's. One train lies at 0; where trains are too few or too unequal for
 * that length, angles are turned alone.
 */
std::vector<double> WaveAngles(
  const std::vector<double>& energies, const WaveSpreading& spreading, const RandomStream& random);

/// Spreading by frequency over that of the peak, f = w / wp.
enum class SpreadingModel
{
  Constant = 0,     ///< cos^2s(angle/2) with one s
  Mitsuyasu = 1,    ///< s that falls from the peak, as f^5 below it and as f^-2.5 above (Mitsuyasu et al. 1975)
  DonelanBanner = 2 ///< sech^2(b angle), b of Donelan et al. (1985), above 1.6 peaks of Banner (1990)
};

/// Directions of the waves of one frequency.
struct WaveDirection
{
  double Mean;         ///< [rad]
  double Exponent;     ///< s of cos^2s(angle/2), or b of sech^2(b angle); positive
  bool IsSech = false; ///< the latter
};

/// Directions by a model at a frequency over that of the peak; s is that at the peak.
WaveDirection DirectionOf(SpreadingModel model, double mean, double s, double frequency);

/// The mean cosine of the angle from the mean direction.
double MeanCosineOf(const WaveDirection& direction);

/**
 * Directions [rad] of trains that each have a mean and a spreading of their own, in the order of their frequencies:
 * strata as above, the angles from the own mean direction stretched and all turned until the mean vector by energy is
 * that of the distributions; as they come where the seas nearly cancel each other.
 */
std::vector<double> WaveAngles(
  const std::vector<double>& energies, const std::vector<WaveDirection>& directions, const RandomStream& random);

}

#endif
