// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSeaStatistics_h
#define LittoralSeaStatistics_h

#include "Sea/WaveTrains.h"

#include <vector>

namespace littoral
{

/// Spectral density at a frequency: of the spectrum, and of the train in whose bin it lies.
struct FrequencyDensity
{
  double Frequency; ///< [Hz]
  double Spectrum;  ///< [m2/Hz]
  double Trains;    ///< energy of the trains of the bin over its width [m2/Hz]
};

/**
 * The spectrum and its trains as curves, the latter as steps: each bin has points at both of its edges and at equal
 * steps between them. Edges [Hz] are increasing; densities [m2/Hz] are those of the spectrum at the edges and at
 * equally many steps within each bin, so one more than a multiple of the number of bins.
 */
std::vector<FrequencyDensity> SpectrumOfTrains(
  const std::vector<WaveTrain>& trains, const std::vector<double>& edges, const std::vector<double>& densities);

/// Fraction of the energy per degree of direction: of trains in a sector, and by the model.
struct DirectionDensity
{
  double Direction; ///< from x towards y [degrees]
  double Spreading; ///< cos^2s(angle / 2), normalized [1/degree]; NaN where all trains have one direction
  double Trains;    ///< energy of the trains in the sector over that of all and its width [1/degree]
};

/// Mean direction by energy [rad], and the length of the mean vector, 0 to 1.
struct MeanVector
{
  double Direction;
  double Length;
};

MeanVector MeanVectorOf(const std::vector<WaveTrain>& trains);

/// Spreading of trains about their mean direction, as steps of so many sectors; the exponent s of the model follows
/// from the length of the mean vector, s / (s + 1).
std::vector<DirectionDensity> SpreadingOfTrains(const std::vector<WaveTrain>& trains, int sectors);

}

#endif
