// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Wind/IecWind.h"

#include "Numerics/Constants.h"
#include "Numerics/ParameterCheck.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

constexpr double GustTime = 10.5;     // of the operating gust [s]
constexpr double TurnTime = 6.0;      // of the direction change [s]
constexpr double RiseTime = 10.0;     // of the coherent gust [s]
constexpr double CoherentRise = 15.0; // of its speed [m/s]

double ReferenceIntensity(IECClass turbulence)
{
  constexpr double intensities[NumberOfIECClasses] = { 0.0, 0.18, 0.16, 0.14, 0.12 };
  return intensities[static_cast<int>(turbulence)];
}

/// 1 + 0.1 D/Lambda_1: the rotor compared with the scale of turbulence.
double RotorFactor(const IECSite& site)
{
  // Lambda_1 = 0.7 z up to 60 m, above 42 m
  return 1.0 + 0.1 * site.RotorDiameter / (0.7 * std::min(60.0, site.HubHeight));
}

/// Rise from 0 to 1 as half a cosine, then 1.
double RiseAt(double time, double duration)
{
  return 0.5 * (1.0 - std::cos(Pi * std::clamp(time / duration, 0.0, 1.0)));
}

/// Angle of the coherent gust [rad].
double CoherentTurnOf(const IECSite& site)
{
  // theta_cg = 180 degrees below 4 m/s, else 720 degrees / V_hub
  return Pi / 180.0 * (site.HubSpeed < 4.0 ? 180.0 : 720.0 / site.HubSpeed);
}

}

std::string WhyInvalid(const IECSite& site, IECEvent event)
{
  ParameterCheck check;
  check.Choice("IECClass", static_cast<int>(site.Class), NumberOfIECClasses);
  check.Choice("IECEvent", static_cast<int>(event), NumberOfIECEvents);
  check.Positive("AnnualMeanSpeed", site.AnnualMeanSpeed, "m/s");
  check.Positive("RotorDiameter", site.RotorDiameter, "m");
  check.Require(
    event == IECEvent::None || site.Class != IECClass::None, "IECEvent needs an IECClass, by which its size goes.");
  return check.Reason();
}

double DeviationOf(const IECSite& site, IECTurbulence turbulence)
{
  const double intensity = ReferenceIntensity(site.Class);
  if (turbulence == IECTurbulence::Normal)
  {
    // NTM: sigma_1 = I_ref (0.75 V_hub + 5.6)
    return intensity * (0.75 * site.HubSpeed + 5.6);
  }
  constexpr double c = 2.0; // [m/s]
  // ETM: sigma_1 = c I_ref (0.072 (V_ave/c + 3) (V_hub/c - 4) + 10)
  return c * intensity * (0.072 * (site.AnnualMeanSpeed / c + 3.0) * (site.HubSpeed / c - 4.0) + 10.0);
}

double OperatingGustOf(const IECSite& site)
{
  // V_e1 = 0.8 x 1.4 V_ref at the hub, V_ref = V_ave / 0.2
  const double extreme = 0.8 * 1.4 * site.AnnualMeanSpeed / 0.2;
  // V_gust = min(1.35 (V_e1 - V_hub), 3.3 sigma_1 / (1 + 0.1 D/Lambda_1))
  const double gust = 3.3 * DeviationOf(site, IECTurbulence::Normal) / RotorFactor(site);
  return std::max(0.0, std::min(1.35 * (extreme - site.HubSpeed), gust));
}

double DirectionChangeOf(const IECSite& site)
{
  // theta_e = 4 arctan(sigma_1 / (V_hub (1 + 0.1 D/Lambda_1))), at most 180 degrees
  const double deviation = DeviationOf(site, IECTurbulence::Normal);
  return std::min(Pi, 4.0 * std::atan(deviation / (site.HubSpeed * RotorFactor(site))));
}

IECState StateOf(const IECSite& site, IECEvent event, double time)
{
  switch (event)
  {
    case IECEvent::OperatingGust:
    {
      const double part = std::clamp(time / GustTime, 0.0, 1.0);
      // V(t) = V - 0.37 V_gust sin(3 pi t/T) (1 - cos(2 pi t/T))
      return { -0.37 * OperatingGustOf(site) * std::sin(3.0 * Pi * part) * (1.0 - std::cos(TwoPi * part)), 0.0 };
    }
    case IECEvent::DirectionChange:
      // theta(t) = 0.5 theta_e (1 - cos(pi t/T))
      return { 0.0, DirectionChangeOf(site) * RiseAt(time, TurnTime) };
    case IECEvent::CoherentGust:
      // V(t) = V + 0.5 V_cg (1 - cos(pi t/T)), theta(t) likewise
      return { CoherentRise * RiseAt(time, RiseTime), CoherentTurnOf(site) * RiseAt(time, RiseTime) };
    default:
      return {};
  }
}

void MakeEventWind(const WindModel& model, const WindGrid& grid, const IECSite& site, IECEvent event, double start,
  float* velocities, const ParallelFor& parallel)
{
  const int length = grid.Count[0];
  parallel(grid.NumberOfLines(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t line = begin; line < end; ++line)
    {
      const double mean = MeanSpeed(model, grid.Height(static_cast<int>(line / grid.Count[1])));
      float* to = velocities + line * length * WindComponents;
      for (int i = 0; i < length; ++i, to += WindComponents)
      {
        // what arrives later at the last sample is farther upwind
        const int step = length - 1 - i;
        const IECState state = StateOf(site, event, step * grid.TimeStep - start);
        to[0] = static_cast<float>((mean + state.Speed) * std::cos(state.Turn));
        to[1] = static_cast<float>((mean + state.Speed) * std::sin(state.Turn));
        to[2] = 0.0f;
      }
    }
  });
}

}
