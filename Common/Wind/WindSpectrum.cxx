// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Wind/WindSpectrum.h"

#include "Numerics/Constants.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace littoral
{

namespace
{
constexpr double VonKarman = 0.4;
/// Height of the speed in the exponent of the coherence [m] (eqs. 11, 12).
constexpr double CoherenceHeight = 10.0;
/// Beyond it there is no wind on Earth [m/s].
constexpr double FastestWind = 1000.0;

/// The paper's spectra. Written with z / U(z) in place of nu / f, they are finite at frequency 0.
double SimiuScanlanDensity(const WindModel& model, int component, double frequency, double height)
{
  const double friction = FrictionVelocity(model);
  const double time = height / MeanSpeed(model, height);
  const double nu = frequency * time;
  const double unit = friction * friction * time;
  switch (component)
  {
    case 0:
      // eq. 9.a: S_u = u_*^2 200 (z/U) / (1 + 50 nu)^(5/3)
      return unit * 200.0 / std::pow(1.0 + 50.0 * nu, 5.0 / 3.0);
    case 1:
      // eq. 9.b: S_v = u_*^2 15 (z/U) / (1 + 9.5 nu)^(5/3)
      return unit * 15.0 / std::pow(1.0 + 9.5 * nu, 5.0 / 3.0);
    default:
      // eq. 9.c: S_w = u_*^2 3.36 (z/U) / (1 + 10 nu^(5/3)), the power of nu alone: see Documentation/errata.md
      return unit * 3.36 / (1.0 + 10.0 * std::pow(nu, 5.0 / 3.0));
  }
}

/// Closed forms of the integrals over the frequency, as multiples of the friction velocity squared.
double SimiuScanlanVariance(const WindModel& model, int component)
{
  // The integral of 1 / (1 + 10 nu^(5/3)) is 10^(-3/5) (3 pi / 5) / sin(3 pi / 5).
  static const double shares[] = { 200.0 * 1.5 / 50.0, 15.0 * 1.5 / 9.5,
    3.36 * std::pow(10.0, -0.6) * 0.6 * Pi / std::sin(0.6 * Pi) };
  const double friction = FrictionVelocity(model);
  return shares[component] * friction * friction;
}

/// Lambda_1 of IEC 61400-1, the scale of turbulence along the wind at the reference height [m].
double IECScale(const WindModel& model)
{
  return 0.7 * std::min(60.0, model.ReferenceHeight);
}

/// Standard deviation of a component.
double IECDeviation(const WindModel& model, int component)
{
  constexpr double shares[] = { 1.0, 0.8, 0.5 };
  return shares[component] * model.TurbulenceIntensity * model.ReferenceSpeed;
}

double IECKaimalDensity(const WindModel& model, int component, double frequency, double)
{
  constexpr double lengths[] = { 8.1, 2.7, 0.66 };
  const double time = lengths[component] * IECScale(model) / model.ReferenceSpeed;
  const double deviation = IECDeviation(model, component);
  // IEC 61400-1, annex B: S = 4 sigma^2 (L/U) / (1 + 6 f L/U)^(5/3)
  return 4.0 * deviation * deviation * time / std::pow(1.0 + 6.0 * frequency * time, 5.0 / 3.0);
}

double IECKaimalVariance(const WindModel& model, int component)
{
  const double deviation = IECDeviation(model, component);
  return deviation * deviation;
}

WindSeparation ExponentialSeparation(const WindModel& model, int component, double lateral, double vertical)
{
  const WindDecay& decay = model.Decay[component];
  // eqs. 11 and 12: f (c_y^2 dy^2 + c_z^2 dz^2)^(1/2) / U(10)
  return { std::hypot(decay.Lateral * lateral, decay.Vertical * vertical) / MeanSpeed(model, CoherenceHeight), 0.0 };
}

WindSeparation IECSeparation(const WindModel& model, int component, double lateral, double vertical)
{
  if (component != 0)
  {
    return ExponentialSeparation(model, component, lateral, vertical);
  }
  constexpr double decay = 12.0;
  constexpr double lengths = 8.1; // Lambda_1 in the scale of coherence, L_c
  const double distance = std::hypot(lateral, vertical);
  // IEC 61400-1, annex B: 12 ((f r/U)^2 + (0.12 r/L_c)^2)^(1/2)
  return { decay * distance / model.ReferenceSpeed, decay * 0.12 * distance / (lengths * IECScale(model)) };
}

constexpr auto Intensity =
  MakeParameter<WindModel, &WindModel::TurbulenceIntensity>("TurbulenceIntensity", "", ValueInterval::Positive());

/// Rows in the order of the enumerations.
constexpr WindSpectrumTraits Spectra[] = {
  // name, parameters besides the mean wind, density, variance
  { "SimiuScanlan", {}, SimiuScanlanDensity, SimiuScanlanVariance },
  { "IECKaimal", { { &Intensity } }, IECKaimalDensity, IECKaimalVariance },
};
static_assert(std::size(Spectra) == NumberOfWindSpectra, "a row a spectrum");

constexpr WindCoherenceTraits Coherences[] = {
  { "Exponential", ExponentialSeparation },
  { "IEC", IECSeparation },
};
static_assert(std::size(Coherences) == NumberOfWindCoherences, "a row a coherence");

}

const WindSpectrumTraits& TraitsOf(WindSpectrumModel spectrum)
{
  return Spectra[static_cast<int>(spectrum)];
}

const WindCoherenceTraits& TraitsOf(WindCoherenceModel coherence)
{
  return Coherences[static_cast<int>(coherence)];
}

std::string WhyInvalid(const WindModel& model)
{
  ParameterCheck check;
  check.Positive("ReferenceSpeed", model.ReferenceSpeed, "m/s", FastestWind);
  check.Positive("RoughnessLength", model.RoughnessLength, "m");
  check.Finite("ReferenceHeight", model.ReferenceHeight, "m");
  check.Require(model.ReferenceHeight > model.RoughnessLength, "ReferenceHeight", model.ReferenceHeight, "m",
    "finite and above the RoughnessLength of " + TextOf(model.RoughnessLength) + " m");
  check.Within("RoughnessLength", model.RoughnessLength, ValueInterval::Between(0.0, CoherenceHeight), "m");
  check.Finite("TurbulenceIntensity", model.TurbulenceIntensity); // also where it does not count: it is written
  check.Range("ShearExponent", model.ShearExponent, 0.0, 1.0);
  check.Range("Veer", model.Veer, -10.0, 10.0, "degrees/m");
  check.Choice("Spectrum", static_cast<int>(model.Spectrum), NumberOfWindSpectra);
  check.Choice("Coherence", static_cast<int>(model.Coherence), NumberOfWindCoherences);
  if (!check.IsGood())
  {
    return check.Reason();
  }
  check.Require(TraitsOf(model.Spectrum).Parameters.WhyInvalid(model));
  constexpr const char* names[] = { "LongitudinalDecay", "LateralDecay", "VerticalDecay" };
  for (int component = 0; component < WindComponents; ++component)
  {
    const std::string name = names[component];
    check.Positive(name + ", lateral", model.Decay[component].Lateral);
    check.Positive(name + ", vertical", model.Decay[component].Vertical);
  }
  return check.Reason();
}

double FrictionVelocity(const WindModel& model)
{
  // eq. 10 at the reference height: u_* = k U / ln(z/z_0)
  return VonKarman * model.ReferenceSpeed / std::log(model.ReferenceHeight / model.RoughnessLength);
}

double MeanSpeed(const WindModel& model, double height)
{
  if (model.ShearExponent > 0.0)
  {
    // IEC 61400-1: U(z) = U_r (z/z_r)^alpha
    return model.ReferenceSpeed * std::pow(height / model.ReferenceHeight, model.ShearExponent);
  }
  // eq. 10: U(z) = u_*/k ln(z/z_0)
  return FrictionVelocity(model) / VonKarman * std::log(height / model.RoughnessLength);
}

double ConvectionSpeed(const WindModel& model)
{
  return model.ReferenceSpeed;
}

double SpectralDensity(const WindModel& model, int component, double frequency, double height)
{
  return TraitsOf(model.Spectrum).Density(model, component, frequency, height);
}

double ShearDensity(const WindModel& model, double frequency, double height)
{
  const double friction = FrictionVelocity(model);
  const double time = height / MeanSpeed(model, height);
  // Kaimal et al. (1972): C_uw = -u_*^2 14 (z/U) / (1 + 9.6 n)^2.4
  return -14.0 * friction * friction * time / std::pow(1.0 + 9.6 * frequency * time, 2.4);
}

double Variance(const WindModel& model, int component)
{
  return TraitsOf(model.Spectrum).Variance(model, component);
}

WindSeparation SeparationOf(const WindModel& model, int component, double lateral, double vertical)
{
  return TraitsOf(model.Coherence).Separation(model, component, lateral, vertical);
}

double RootCoherence(const WindModel& model, int component, double frequency, double lateral, double vertical)
{
  const WindSeparation separation = SeparationOf(model, component, lateral, vertical);
  return std::exp(-std::hypot(frequency * separation.Delay, separation.Still));
}

}
