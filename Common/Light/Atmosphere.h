// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralAtmosphere_h
#define LittoralAtmosphere_h

#include "Numerics/Parallel.h"
#include "Numerics/Vector3.h"

#include <memory>
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
  double Ozone = 300.0;      ///< column of it, from 0 to 1000 [Dobson units]
};

/// Reason why parameters are no air; empty if they are.
std::string WhyInvalid(const AirParameters& parameters);

/**
 * A round earth under air that scatters the light of the sun: molecules, aerosols of a scale height of 1.2 km and an
 * Angstrom exponent of 1.3, and the ozone that absorbs (coefficients of E. Bruneton, A qualitative and quantitative
 * evaluation of 8 clear sky models, 2017). Light that is scattered once is integrated along the line of sight; that of
 * all later times is LaterLight.
 *
 * Colors are linear, of the primaries of sRGB, each computed at one wavelength, 620, 550 and 440 nm; 1 stands for 1 klx
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

  /// The same in directions of one elevation, which is faster than one by one.
  std::vector<Vector3> SkyLuminances(const std::vector<Vector3>& directions, const Vector3& sun) const;

private:
  struct State;
  std::shared_ptr<const State> Air;
};

/// Luminance of a linear color, 0.2126 R + 0.7152 G + 0.0722 B.
double LuminanceOf(const Vector3& color);

}

#endif
