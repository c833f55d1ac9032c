// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralAirLayers_h
#define LittoralAirLayers_h

#include "Light/Atmosphere.h"
#include "Numerics/Parallel.h"
#include "Numerics/Vector3.h"

#include <vector>

namespace littoral
{

// Lengths in kilometres, colors at 620, 550 and 440 nm.
constexpr double EarthRadius = 6360.0;
constexpr double AirHeight = 100.0;

/// Part of a line of sight, in one place for all of it.
struct SightPart
{
  double Altitude;
  double CosView; ///< of the line's angle from the zenith there
  double CosTurn; ///< of the angle at the earth's center from where the line begins
  double SinTurn;
  Vector3 Molecules; ///< integral of their scattering coefficient times the transmittance to where the line begins
  Vector3 Aerosols;
};

/// Line through the air to its top or to the ground.
struct SightLine
{
  std::vector<SightPart> Parts;
  bool MeetsGround = false;
  double CosTurn = 1.0; ///< of its end
  double SinTurn = 0.0;
  Vector3 Through{ 1.0 }; ///< transmittance
};

/// Air in layers around a round earth: how it scatters and absorbs, and what it lets through of the sun.
class AirLayers
{
public:
  struct Coefficients ///< [1/km]
  {
    Vector3 Molecules; ///< scattering
    Vector3 Aerosols;  ///< scattering
    Vector3 Extinction;
  };

  explicit AirLayers(const AirParameters& parameters, const ParallelFor& parallel = SerialFor);

  Coefficients At(double altitude) const;
  /// Line that begins at an altitude in an angle from the zenith, in at most so many parts.
  SightLine Line(double altitude, double cosView, int parts) const;
  /// Part of the sun's light that comes to an altitude.
  Vector3 SunAt(double altitude, double cosSun) const;
  /// Cosine of the angle from the zenith at which the earth ends, and of that at which none of the sun is seen.
  static double CosHorizon(double altitude);
  static double CosSunset(double altitude);

private:
  Vector3 Thickness(double altitude, double cosView) const;

  Vector3 AerosolScattering; ///< at the ground
  Vector3 OzoneAbsorption;   ///< at 25 km
  std::vector<Vector3> ThicknessToTop;
};

/// Phase functions, per solid angle.
double MoleculePhase(double cosine);
double AerosolPhase(double cosine);

constexpr double AerosolAsymmetry = 0.8;

}

#endif
