// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralDispersion_h
#define LittoralDispersion_h

namespace littoral
{

/**
 * The wave number k [rad/m] of a wave of angular frequency w [rad/s] on water of a depth h [m], the root of
 * w2 = g k tanh(k h). An infinite depth is deep water; a frequency that is not positive has the wave number 0.
 */
double WaveNumber(double frequency, double depth);

/// The angular frequency [rad/s] of a wave number [rad/m] on water of a depth [m].
double WaveFrequency(double waveNumber, double depth);

/// Depth regimes of a wave.
enum class DepthRegime
{
  Deep,         ///< deeper than half a wavelength
  Intermediate, ///< between the two
  Shallow,      ///< less deep than a twentieth of a wavelength
};

/// The regime of a wave number [rad/m] on water of a depth [m]. A label: all formulas hold in all regimes.
DepthRegime RegimeOf(double waveNumber, double depth);

/// deep, intermediate or shallow.
const char* RegimeName(DepthRegime regime);

}

#endif
