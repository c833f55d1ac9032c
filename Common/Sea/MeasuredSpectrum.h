// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralMeasuredSpectrum_h
#define LittoralMeasuredSpectrum_h

#include <string>
#include <vector>

namespace littoral
{

/// Meaning of the angles of a file.
enum class DirectionConvention
{
  File = 0,         ///< as the format or the header says
  NauticalFrom = 1, ///< waves come from there, clockwise from north
  NauticalTo = 2,   ///< waves go there, clockwise from north
  CartesianTo = 3,  ///< waves go there, from x (east) towards y (north)
  CartesianFrom = 4 ///< waves come from there, from x towards y
};

/// Unit of the densities of a table by frequency and direction.
enum class DensityUnit
{
  PerDegree = 0, ///< m2/Hz/degree
  PerRadian = 1  ///< m2/Hz/rad
};

struct SpectrumFileOptions
{
  int Record = 0;   ///< of the times of a file, the first one 0
  int Location = 0; ///< of the places of a file
  DirectionConvention Convention = DirectionConvention::File;
  DensityUnit Unit = DensityUnit::PerDegree;
};

/// A spectrum by frequency, with the first directional moments where they were measured.
struct MeasuredSpectrum
{
  std::vector<double> Frequencies; ///< [Hz], increasing
  std::vector<double> Densities;   ///< [m2/Hz]
  std::vector<double> Directions;  ///< mean direction towards which waves travel, from x towards y [rad]; or empty
  std::vector<double> Lengths;     ///< r, of the mean vector of directions, 0 to 1; or empty
  std::string Format;              ///< NDBC, SWAN, Spotter, Table
  std::string Time;                ///< as the file writes it; empty if it does not
};

/// The circular spread [rad] of a mean vector of a length, sqrt(2 (1 - r)).
double CircularSpread(double length);

/**
 * Reads a spectrum from the bytes of a file, whose format they tell:
 *
 * - NDBC: spectral densities, in the form of recent data (.data_spec) or of years; directions of alpha1 and r1 from the
 *   bytes of the other files, empty if there are none. Frequencies whose density is missing are left out.
 * - SWAN: spectra by frequency and direction (VaDens or EnDens per degree) or by frequency alone.
 * - Spotter: the JSON of Sofar's interface, frequencyData.
 * - A table with the columns Frequency and Density, or with alpha1 and r1 beside them as of NDBC.
 * - A table with a row of directions [degrees], a column of frequencies [Hz] and densities, whose convention is asked
 * for.
 *
 * Densities by direction are reduced to their integral and their mean vector. Throws InvalidInput.
 */
MeasuredSpectrum ReadSpectrumFile(const std::string& bytes, const SpectrumFileOptions& options,
  const std::string& alpha1 = {}, const std::string& r1 = {});

}

#endif
