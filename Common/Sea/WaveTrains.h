// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralWaveTrains_h
#define LittoralWaveTrains_h

#include "Sea/SeaSpectrum.h"
#include "Sea/WaveDirections.h"

#include <limits>
#include <string>
#include <vector>

namespace littoral
{

/// One regular wave.
struct WaveTrain
{
  double Amplitude;        ///< [m]
  double AngularFrequency; ///< [rad/s]
  double WaveNumber;       ///< [rad/m]
  double Direction;        ///< towards which it travels, from x towards y [rad]
  double Phase;            ///< [rad]
};

/// Order in the steepness of waves to which a sea is summed.
enum class SeaOrder
{
  First = 1, ///< trains alone
  Second = 2 ///< and the waves that pairs of them force
};

/// A sea as a sum of wave trains. Crests of a train lie where k d . x - w t + Phase is an odd multiple of pi.
struct SeaState
{
  std::vector<WaveTrain> Trains;
  double Depth = std::numeric_limits<double>::infinity(); ///< [m]
  double SeaLevel = 0.0;                                  ///< [m]
  /// After which the sea returns [s]; infinite: never.
  double Period = std::numeric_limits<double>::infinity();
  SeaOrder Order = SeaOrder::First;
};

/// Trains that a sea of second order has at most.
constexpr int MostBoundTrains = 200;

/// Why this is no sea state, in words for a user; empty when it is one.
std::string WhyInvalid(const SeaState& sea);

/// Mean vector of the directions of waves at a frequency.
struct DirectionAt
{
  double Frequency; ///< [rad/s]
  double Mean;      ///< [rad]
  double Length;    ///< 0 to 1, s / (s + 1) of cos^2s(angle/2)
  double Density;   ///< of energy, not negative
};

/// Parameters of the discretization of a spectrum into trains.
struct TrainParameters
{
  int Count = 30;               ///< positive
  double Lowest = 0.0;          ///< frequency [peak frequencies], not negative
  double Highest = 0.0;         ///< [peak frequencies], above Lowest; both 0: the spectrum's own range
  double MeanDirection = 0.0;   ///< [rad]
  double Spreading = 10.0;      ///< s of cos^2s(angle/2); 0: all trains along MeanDirection
  double SwellDirection = 0.0;  ///< MeanDirection of the swell of a spectrum that has one [rad]
  double SwellSpreading = 50.0; ///< Spreading of that swell; 0: none
  SpreadingModel Model = SpreadingModel::Constant; ///< Spreading is that at the peak
  /// Mean vectors of directions by frequency [rad/s], increasing, in place of MeanDirection and Spreading; none: these.
  std::vector<DirectionAt> Directions;
  bool EqualSpacing = false; ///< frequencies are multiples of one, else at random places in their bins
  int Seed = 1;
};

std::string WhyInvalid(const TrainParameters& parameters);

/**
 * The trains of a spectrum, largest amplitude first. Frequencies are cut into bins of equal width; the amplitude of a
 * bin is sqrt(2 E) with its energy E, so that trains keep the energy of their range for any number of them. Phases are
 * uniform; each train has one direction, see WaveAngles and SpreadingModel, for two trains of one frequency would stand
 * still against each other. Bins without energy give no train.
 *
 * A regular sea is one train along MeanDirection, whatever else is asked for, with a crest at the origin at time 0.
 *
 * With EqualSpacing frequencies are m w0, m = M to M + Count - 1, with the middle of the range as theirs, and M such
 * that they fill it best. Bins end half-way between them, the outermost at the range's ends.
 */
std::vector<WaveTrain> TrainsOf(const SeaSpectrum& spectrum, double depth, const TrainParameters& parameters);

/// Angular frequencies [rad/s] between which the bins of trains lie, one more than there are bins; none of a regular
/// sea.
std::vector<double> BinEdges(const SeaSpectrum& spectrum, const TrainParameters& parameters);

/// After which all trains return [s]: 2 pi / w0 with EqualSpacing; of a regular sea that of its wave; else infinite.
double PeriodOf(const SeaSpectrum& spectrum, const TrainParameters& parameters);

/// The variance of the elevation of trains [m2], the sum of half the squares of their amplitudes.
double EnergyOf(const std::vector<WaveTrain>& trains);

}

#endif
