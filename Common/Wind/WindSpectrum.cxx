// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Wind/WindSpectrum.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace littoral
{

namespace
{
constexpr double VonKarman = 0.4;
/// Height of the speed in the exponent of the coherence [m] (eqs. 11, 12).
constexpr double CoherenceHeight = 10.0;
/// Beyond it there is no wind on Earth [m/s].
constexpr double FastestWind = 1000.0;

bool IsPositive(double value)
{
  return value > 0.0 && std::isfinite(value);
}

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
      return unit * 200.0 / std::pow(1.0 + 50.0 * nu, 5.0 / 3.0);
    case 1:
      return unit * 15.0 / std::pow(1.0 + 9.5 * nu, 5.0 / 3.0);
    default: // here the power is of nu alone: printed otherwise, see Documentation/errata.md
      return unit * 3.36 / (1.0 + 10.0 * std::pow(nu, 5.0 / 3.0));
  }
}

/// Lambda_1 of IEC 61400-1, the scale of turbulence along the wind at the reference height [m].
double IecScale(const WindModel& model)
{
  return 0.7 * std::min(60.0, model.ReferenceHeight);
}

double IecKaimalDensity(const WindModel& model, int component, double frequency)
{
  constexpr double lengths[] = { 8.1, 2.7, 0.66 };
  constexpr double shares[] = { 1.0, 0.8, 0.5 };
  const double time = lengths[component] * IecScale(model) / model.ReferenceSpeed;
  const double deviation = shares[component] * model.TurbulenceIntensity * model.ReferenceSpeed;
  return 4.0 * deviation * deviation * time / std::pow(1.0 + 6.0 * frequency * time, 5.0 / 3.0);
}
}

std::string WhyInvalid(const WindModel& model)
{
  std::ostringstream reason;
  if (!IsPositive(model.ReferenceSpeed) || model.ReferenceSpeed > FastestWind)
  {
    reason << "ReferenceSpeed is " << model.ReferenceSpeed << " m/s; it must be positive and at most " << FastestWind
           << ".";
  }
  else if (!IsPositive(model.RoughnessLength))
  {
    reason << "RoughnessLength is " << model.RoughnessLength << " m; it must be positive.";
  }
  else if (!(model.ReferenceHeight > model.RoughnessLength) || !std::isfinite(model.ReferenceHeight))
  {
    reason << "ReferenceHeight is " << model.ReferenceHeight << " m; it must be above the RoughnessLength of "
           << model.RoughnessLength << " m.";
  }
  else if (!(model.RoughnessLength < CoherenceHeight))
  {
    reason << "RoughnessLength is " << model.RoughnessLength << " m; it must be below " << CoherenceHeight << " m.";
  }
  else if (model.Spectrum != WindSpectrumModel::SimiuScanlan && model.Spectrum != WindSpectrumModel::IecKaimal)
  {
    reason << "Spectrum is " << static_cast<int>(model.Spectrum) << "; it must be 0 or 1.";
  }
  else if (model.Coherence != WindCoherenceModel::Exponential && model.Coherence != WindCoherenceModel::Iec)
  {
    reason << "Coherence is " << static_cast<int>(model.Coherence) << "; it must be 0 or 1.";
  }
  else if (model.Spectrum == WindSpectrumModel::IecKaimal && !IsPositive(model.TurbulenceIntensity))
  {
    reason << "TurbulenceIntensity is " << model.TurbulenceIntensity << "; it must be positive.";
  }
  else
  {
    constexpr const char* names[] = { "LongitudinalDecay", "LateralDecay", "VerticalDecay" };
    for (int component = 0; component < WindComponents && reason.str().empty(); ++component)
    {
      const WindDecay& decay = model.Decay[component];
      if (!IsPositive(decay.Lateral) || !IsPositive(decay.Vertical))
      {
        reason << names[component] << " is " << decay.Lateral << ", " << decay.Vertical << "; both must be positive.";
      }
    }
  }
  return reason.str();
}

double FrictionVelocity(const WindModel& model)
{
  return VonKarman * model.ReferenceSpeed / std::log(model.ReferenceHeight / model.RoughnessLength);
}

double MeanSpeed(const WindModel& model, double height)
{
  return FrictionVelocity(model) / VonKarman * std::log(height / model.RoughnessLength);
}

double ConvectionSpeed(const WindModel& model)
{
  return model.ReferenceSpeed;
}

double SpectralDensity(const WindModel& model, int component, double frequency, double height)
{
  return model.Spectrum == WindSpectrumModel::IecKaimal ? IecKaimalDensity(model, component, frequency)
                                                        : SimiuScanlanDensity(model, component, frequency, height);
}

WindSeparation SeparationOf(const WindModel& model, int component, double lateral, double vertical)
{
  if (model.Coherence == WindCoherenceModel::Iec && component == 0)
  {
    constexpr double decay = 12.0;
    constexpr double lengths = 8.1; // Lambda_1 in the scale of coherence, L_c
    const double distance = std::hypot(lateral, vertical);
    return { decay * distance / model.ReferenceSpeed, decay * 0.12 * distance / (lengths * IecScale(model)) };
  }
  const WindDecay& decay = model.Decay[component];
  return { std::hypot(decay.Lateral * lateral, decay.Vertical * vertical) / MeanSpeed(model, CoherenceHeight), 0.0 };
}

double RootCoherence(const WindModel& model, int component, double frequency, double lateral, double vertical)
{
  const WindSeparation separation = SeparationOf(model, component, lateral, vertical);
  return std::exp(-std::hypot(frequency * separation.Delay, separation.Still));
}

}
