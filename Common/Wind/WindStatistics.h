// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralWindStatistics_h
#define LittoralWindStatistics_h

#include "Numerics/Parallel.h"
#include "Wind/WindField.h"

#include <array>
#include <vector>

namespace littoral
{

/// A number for each component: along, across, up.
using WindTriple = std::array<double, WindComponents>;

/// Mean of a quantity over the frequencies of a band, measured in a field and by its model.
struct WindBand
{
  double Frequency; ///< mean of the band [Hz]
  WindTriple Measured;
  WindTriple Model;
};

/// Moments of a layer, measured and by the model.
struct WindLayer
{
  double Height;             ///< [m]
  double Speed;              ///< mean speed along the wind [m/s]
  double ModelSpeed;         ///< logarithmic law [m/s]
  WindTriple Deviation;      ///< standard deviations about the means of lines [m/s]
  WindTriple ModelDeviation; ///< square root of the sum of the spectrum over the frequencies of the field [m/s]
};

/// Layers and columns of a grid that stand for a height, and for the separation of a coherence.
struct WindPlaces
{
  int Layer = 0;
  int Columns = 0;
  int Layers = 0; ///< to the other layer of the coherence, downwards where there is none above
};

/// Places nearest to a height and to a separation across and up [m], which is one spacing at least. Throws InvalidInput
/// if there are none.
WindPlaces FindPlaces(const WindGrid& grid, double height, const std::array<double, 2>& separation);

/**
 * Statistics of a periodic wind field, compared with those of its model: spectra, coherence and profile.
 *
 * Lines along the wind are time series by Taylor's hypothesis: frequencies are k / T, k = 1, 2 ... below N / 2, with
 * the period T and N samples. The model is averaged over the same frequencies as the measurement.
 */
class WindStatistics
{
public:
  /// Velocities as WindField::Make gives them, which must outlive this; model and grid must be valid. `onLine` is
  /// called at each line.
  WindStatistics(const float* velocities, const WindGrid& grid, const WindModel& model, Poll onLine = NoPoll);

  /// One-sided spectral densities of a layer [m2/s2/Hz], mean over its lines, in bands of equal ratio of frequencies.
  /// Bands that hold no frequency are left out.
  std::vector<WindBand> Spectra(int layer, int bands) const;

  /// Root coherence of a layer with lines so many columns across and layers up (negative: down), mean over all such
  /// pairs: the real part of the mean cross spectrum over the root of the mean spectra. The separation must not be 0
  /// and lie in the grid.
  std::vector<WindBand> Coherence(int layer, int columns, int layers, int bands) const;

  /// All layers, from the lowest.
  std::vector<WindLayer> Profile() const;

private:
  class Bands;
  using Amplitudes = std::vector<double>; ///< real and imaginary part for each frequency

  double At(int sample, int column, int layer, int component) const;
  Amplitudes AmplitudesOf(int column, int layer, int component) const;

  const float* Velocities;
  WindGrid Grid;
  WindModel Model;
  Poll OnLine;
};

}

#endif
