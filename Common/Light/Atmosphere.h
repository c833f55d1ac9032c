// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralAtmosphere_h
#define LittoralAtmosphere_h

#include "Numerics/Parallel.h"
#include "Numerics/Vector3.h"

#include <array>
#include <string>
#include <vector>

namespace littoral
{

/// Air and ground of a clear sky.
struct AirParameters
{
  double Turbidity = 2.5;    ///< optical thickness of molecules and aerosols over that of molecules at 550 nm, 1 to 10
  double GroundAlbedo = 0.2; ///< of the earth, from 0 to 1
  double Altitude = 0.0;     ///< of the eye above sea level, from 0 to 10000 [m]
};

/// Reason why parameters are no air; empty if they are.
std::string WhyInvalid(const AirParameters& parameters);

/**
 * A round earth under air that scatters the light of the sun: molecules, aerosols of a scale height of 1.2 km and an
 * Angstrom exponent of 1.3, and the ozone that absorbs (coefficients of E. Bruneton, A qualitative and quantitative
 * evaluation of 8 clear sky models, 2017). Light that is scattered once is integrated along the line of sight by the
 * phase functions themselves; that of all later times by successive orders of scattering, with the forward peak of the
 * aerosols taken for light that goes straight on (the delta-M method of W. J. Wiscombe, 1977, with the exact first
 * order of T. Nakajima and M. Tanaka, 1988).
 *
 * Colors are linear, of the primaries of sRGB, each computed at one wavelength, 680, 550 and 440 nm; 1 stands for 1 klx
 * of light and 1 kcd/m2 of luminance.
 */
class Atmosphere
{
public:
  explicit Atmosphere(const AirParameters& parameters, const ParallelFor& parallel = SerialFor);

  /// Light of the sun at right angles to it [klx]; less of it where it sets.
  Vector3 SunLight(const Vector3& sun) const;

  /// Luminance in a direction of length 1 under a sun in another, without the sun's disk [kcd/m2]; below the horizon
  /// with the ground that is seen there. A night has the luminance of stars and airglow everywhere.
  Vector3 SkyLuminance(const Vector3& direction, const Vector3& sun) const;

private:
  /// Moments of the luminance around a place, of which the light scattered there is made: its mean, its flux, and what
  /// molecules tell apart. The sun is in the plane of x and z, z is up.
  struct Moments
  {
    Vector3 Mean = Vector3(0.0);
    Vector3 FluxX = Vector3(0.0);
    Vector3 FluxZ = Vector3(0.0);
    Vector3 XX = Vector3(0.0);
    Vector3 ZZ = Vector3(0.0);
    Vector3 XZ = Vector3(0.0);

    void Add(double weight, const Moments& other);
    void AddLuminance(double weight, const Vector3& direction, const Vector3& luminance);
  };
  /// Coefficients at an altitude [1/km].
  struct Medium
  {
    Vector3 Molecules;  ///< scattering
    Vector3 Aerosols;   ///< scattering
    Vector3 Extinction; ///< without the forward peak of the aerosols
  };
  /// Place on a line of sight.
  struct Place
  {
    double Length; ///< of its part of the line [km]
    double Altitude;
    double CosSun;
    Vector3 Up;
    Medium Air;
    double Aerosols; ///< scattering thickness of those between the eye and the place at 550 nm
  };

  Medium MediumAt(double altitude) const;
  double PathLength(const Vector3& from, const Vector3& direction, bool& meetsGround) const;
  template <typename Value>
  Value ToTop(const std::vector<Value>& table, double radius, double cosZenith) const;
  Vector3 Transmittance(double radius, double cosZenith) const;
  Moments MomentsAt(const std::vector<Moments>& table, double altitude, double cosSun) const;
  template <typename Source, typename GroundLight>
  Vector3 Along(const Vector3& from, const Vector3& direction, const Vector3& sun, int steps, const Source& source,
    const GroundLight& groundLight) const;
  Vector3 LitOnce(const Place& place) const;
  Vector3 Scattered(const Moments& moments, const Place& place, const Vector3& direction, const Vector3& sun) const;
  void MakeTransmittance(const ParallelFor& parallel);
  void MakeLater(const ParallelFor& parallel);

  AirParameters Parameters;
  Vector3 AerosolScattering; ///< at the ground [1/km]
  double EyeRadius;
  std::vector<Vector3> TransmittanceTable;
  std::vector<double> AerosolTable; ///< scattering thickness to the top of the air at 550 nm
  std::vector<Moments> Later;       ///< of light that was scattered once or more
};

/// Luminance of a linear color, 0.2126 R + 0.7152 G + 0.0722 B.
double LuminanceOf(const Vector3& color);

}

#endif
