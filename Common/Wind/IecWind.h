// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralIecWind_h
#define LittoralIecWind_h

#include "Numerics/Parallel.h"
#include "Wind/WindField.h"

#include <string>

namespace littoral
{

/// Classes of turbulence of IEC 61400-1.
enum class IECClass
{
  None = 0,
  APlus = 1, ///< reference intensity 0.18
  A = 2,     ///< 0.16
  B = 3,     ///< 0.14
  C = 4      ///< 0.12
};

inline constexpr int NumberOfIECClasses = 5;

/// Models of turbulence of IEC 61400-1, edition 3.
enum class IECTurbulence
{
  Normal = 0, ///< NTM
  Extreme = 1 ///< ETM
};

/// Transients of IEC 61400-1, edition 3, in a steady wind.
enum class IECEvent
{
  None = 0,
  OperatingGust = 1,   ///< EOG
  DirectionChange = 2, ///< EDC
  CoherentGust = 3     ///< ECD, with a change of direction
};

inline constexpr int NumberOfIECEvents = 4;

/// A wind turbine and its site.
struct IECSite
{
  IECClass Class = IECClass::None;
  double AnnualMeanSpeed = 10.0; ///< at the hub [m/s], positive: 10, 8.5, 7.5 in the classes I, II, III
  double RotorDiameter = 126.0;  ///< [m], positive
  double HubSpeed = 10.0;        ///< mean [m/s], positive
  double HubHeight = 10.0;       ///< above the ground [m], positive
};

/// Why there is no such event, in words for a user; empty when there is one.
std::string WhyInvalid(const IECSite& site, IECEvent event);

/// Standard deviation along the wind [m/s]; the class must not be None.
double DeviationOf(const IECSite& site, IECTurbulence turbulence);

/// Size of the operating gust [m/s] and angle of the direction change [rad].
double OperatingGustOf(const IECSite& site);
double DirectionChangeOf(const IECSite& site);

/// Speed that an event adds [m/s], and the angle by which it turns the wind to the left [rad].
struct IECState
{
  double Speed = 0.0;
  double Turn = 0.0;
};

/// State at a time after the beginning of an event [s]; before it there is none, after it stays what has changed.
IECState StateOf(const IECSite& site, IECEvent event, double time);

/// A steady wind with an event that begins at a time [s] at the last samples along the wind; velocities as WindField
/// makes them.
void MakeEventWind(const WindModel& model, const WindGrid& grid, const IECSite& site, IECEvent event, double start,
  float* velocities, const ParallelFor& parallel = SerialFor);

}

#endif
