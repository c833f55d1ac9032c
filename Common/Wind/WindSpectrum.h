// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralWindSpectrum_h
#define LittoralWindSpectrum_h

#include "Numerics/ParameterTraits.h"

#include <array>
#include <string>

namespace littoral
{

/// Components of the wind: along the mean wind, across it to the left, up.
inline constexpr int WindComponents = 3;

/// Families of auto-spectra.
enum class WindSpectrumModel
{
  SimiuScanlan = 0, ///< of the neutral surface layer, heights count (Setas et al., eq. 9, put right)
  IECKaimal = 1,    ///< of IEC 61400-1: one intensity and one length for all heights
};

inline constexpr int NumberOfWindSpectra = 2;

/// Families of root coherence.
enum class WindCoherenceModel
{
  Exponential = 0, ///< of frequency times distance, with a decay for each component (Setas et al., eqs. 11, 12)
  IEC = 1 ///< along the wind that of IEC 61400-1, ed. 3, which does not grow to 1 at low frequencies; else Exponential
};

inline constexpr int NumberOfWindCoherences = 2;

/// Decay of coherence with the separation across and up; positive.
struct WindDecay
{
  double Lateral = 10.0;
  double Vertical = 10.0;
};

/**
 * The neutral wind near the ground: a logarithmic mean profile, the spectra of the three components, and their root
 * coherence. All of one run; nothing here is random.
 */
struct WindModel
{
  double ReferenceSpeed = 10.0;  ///< mean at ReferenceHeight [m/s], positive, at most 1000
  double ReferenceHeight = 10.0; ///< above the ground [m], above RoughnessLength
  double RoughnessLength = 0.03; ///< of the ground [m], positive: 0.01 low grass ... 1 forest
  WindSpectrumModel Spectrum = WindSpectrumModel::SimiuScanlan;
  double TurbulenceIntensity = 0.16; ///< IECKaimal: standard deviation along the wind over ReferenceSpeed, positive
  WindCoherenceModel Coherence = WindCoherenceModel::Exponential;
  std::array<WindDecay, WindComponents> Decay{ { { 10.0, 10.0 }, { 10.0, 10.0 }, { 8.0, 8.0 } } };
  double ShearExponent = 0.0; ///< of a power law of the mean, from 0 to 1; 0: the logarithmic law
  double Veer = 0.0; ///< turn of the mean clockwise with height, 0 at ReferenceHeight [degrees/m], from -10 to 10
};

/// The row of a family of spectra: everything that sets it apart. A new family is an enumerator and a row.
struct WindSpectrumTraits
{
  const char* Name;                    ///< as in the enumeration
  ParameterList<WindModel> Parameters; ///< parameters that count besides the mean wind
  double (*Density)(const WindModel&, int component, double frequency, double height); ///< one-sided [m2/s2/Hz]
  double (*Variance)(const WindModel&, int component); ///< its integral over all frequencies [m2/s2], at any height
};

/**
 * Two points across and up apart as their root coherence sees them: exp(-sqrt((f Delay)^2 + Still^2)) at the frequency
 * f. Of eqs. 11 and 12 the delay is the distance with its decay coefficients over the mean at 10 m, and nothing is
 * still. Of IEC 61400-1 (ed. 3, annex B) they are 12 r / U and 12 x 0.12 r / L_c, with the distance r, the reference
 * speed U, and L_c = 8.1 Lambda_1, where Lambda_1 is 0.7 of the reference height, at most 42 m.
 */
struct WindSeparation
{
  double Delay = 0.0; ///< [s]
  double Still = 0.0;
};

/// The row of a family of root coherence.
struct WindCoherenceTraits
{
  const char* Name; ///< as in the enumeration
  WindSeparation (*Separation)(const WindModel&, int component, double lateral, double vertical);
};

/// The rows of families, which must be of the enumerations.
const WindSpectrumTraits& TraitsOf(WindSpectrumModel spectrum);
const WindCoherenceTraits& TraitsOf(WindCoherenceModel coherence);

/// Why this is no wind, in words for a user; empty when it is one.
std::string WhyInvalid(const WindModel& model);

/// Friction velocity u_* [m/s]: von Karman's constant 0.4 times the slope of the mean over ln z.
double FrictionVelocity(const WindModel& model);

/// The mean at a height above RoughnessLength [m/s]: the logarithmic law (eq. 10), or a power law with ShearExponent.
double MeanSpeed(const WindModel& model, double height);

/// Speed at which the turbulence is carried past, the same for all heights [m/s].
double ConvectionSpeed(const WindModel& model);

/// One-sided power spectral density of a component [m2/s2/Hz] at a frequency [Hz] and a height [m] (eq. 9).
double SpectralDensity(const WindModel& model, int component, double frequency, double height);

/**
 * One-sided co-spectrum of the components along and up [m2/s2/Hz], Kaimal et al. (1972): f C_uw / u_*^2 = -14 n / (1
 * + 9.6 n)^2.4, n = f z / U(z). Its integral over all frequencies is -1.0417 u_*^2.
 */
double ShearDensity(const WindModel& model, double frequency, double height);

/// Variance of a component [m2/s2]: the integral of its spectral density over all frequencies.
double Variance(const WindModel& model, int component);

/// Two points as their root coherence sees them, across and up apart [m].
WindSeparation SeparationOf(const WindModel& model, int component, double lateral, double vertical);

/**
 * |S_ij| / sqrt(S_ii S_jj) of two points a distance across and up apart [m]: real, positive, 1 for the same point. It
 * is the square root of what signal processing calls coherence.
 */
double RootCoherence(const WindModel& model, int component, double frequency, double lateral, double vertical);

}

#endif
