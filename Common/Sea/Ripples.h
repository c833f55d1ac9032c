// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralRipples_h
#define LittoralRipples_h

#include "Numerics/Parallel.h"

#include <complex>
#include <vector>

namespace littoral
{

/// Slopes of a surface along x and y.
struct SurfaceSlope
{
  double X = 0.0;
  double Y = 0.0;
};

/**
 * Short waves on a square of a sea, which repeats itself along both sides: slopes with the variance 1 on the mean over
 * time, X and Y together, the same in each octave of the wavelength from half the side down to two samples, and in all
 * directions (saturated waves: the spectrum of elevations falls with the fourth power of the wave number).
 */
class Ripples
{
public:
  /// Side [m]; samples along it, a power of two of at least 4.
  Ripples(double side, int samples, int seed);

  /// Slopes by rows along x at a time [s].
  std::vector<SurfaceSlope> SlopesAt(double time, const ParallelFor& parallel = SerialFor) const;

private:
  struct Wave
  {
    std::complex<double> Amplitude; ///< of the slope along the wave
    SurfaceSlope Direction;         ///< of length 1
    double Frequency = 0.0;         ///< angular [rad/s]
  };

  int Samples;
  std::vector<Wave> Waves; ///< one for each wave vector, by rows
};

/**
 * Light that reaches a level plane below a surface that repeats itself, over that below a level surface, at half as
 * many places along the side: rays through each sample are turned by the slope times `arm` [m], the depth times 1 - 1 /
 * n for rays from the zenith, and share their light among the four places around their end. The mean is 1.
 */
std::vector<double> GatheredLight(const std::vector<SurfaceSlope>& slopes, int samples, double side, double arm);

}

#endif
