// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralWaveTrains_h
#define LittoralWaveTrains_h

#include "SeaSpectrum.h"

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

/// A sea as a sum of wave trains. Crests of a train lie where k d . x - w t + Phase is an odd multiple of pi.
struct SeaState
{
  std::vector<WaveTrain> Trains;
  double Depth = std::numeric_limits<double>::infinity(); ///< [m]
  double SeaLevel = 0.0;                                  ///< [m]
};

/// Why this is no sea state, in words for a user; empty when it is one.
std::string WhyInvalid(const SeaState& sea);

/// How a spectrum is cut into trains.
struct TrainParameters
{
  int Count = 30;             ///< positive
  double Lowest = 0.5;        ///< frequency [peak frequencies], not negative
  double Highest = 4.0;       ///< [peak frequencies], above Lowest
  double MeanDirection = 0.0; ///< [rad]
  double Spreading = 10.0;    ///< s of cos^2s(angle/2); 0: all trains along MeanDirection
  bool EqualSpacing = false;  ///< frequencies at the centres of their bins, else at random places in them
  int Seed = 1;
};

std::string WhyInvalid(const TrainParameters& parameters);

/**
 * The trains of a spectrum, largest amplitude first. Bins of equal width in frequency; the amplitude of a bin is
 * sqrt(2 E) with its exact energy E, so that trains keep the energy of their range for any number of them. Phases are
 * uniform; directions are drawn by strata of the spreading's distribution, one for each train, for two trains of one
 * frequency would stand still against each other. Bins without energy give no train.
 */
std::vector<WaveTrain> TrainsOf(const SeaSpectrum& spectrum, double depth, const TrainParameters& parameters);

/// The angle from the mean direction [rad] below which a part, 0 to 1, of a spreading cos^2s(angle/2) lies.
double SpreadingQuantile(double spreading, double part);

}

#endif
