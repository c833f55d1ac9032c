// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralGardnerTexture_h
#define LittoralGardnerTexture_h

#include "Geometry/TextureImage.h"

#include <array>
#include <vector>

namespace littoral
{

/// Gardner's texturing function and where it is opaque.
struct GardnerTextureParameters
{
  int Terms = 6;                            ///< of each sum, 4 to 7
  int Frequency = 4;                        ///< FX_1: periods of the first term around a quadric, even
  double FrequencyY = 6.0;                  ///< FY_1 [1/rad]
  double Offset = 1.0;                      ///< T0
  double CenterThreshold = 0.08;            ///< T1
  double SilhouetteThreshold = 0.4;         ///< T2
  std::array<double, 2> Origin{ 0.0, 0.0 }; ///< added to x and y [rad]
};

/**
 * Gardner (1984): T(x, y) = k sum C_i [sin(FX_i x + PX_i) + T0] sum C_i [sin(FY_i y + PY_i) + T0], i = 1 ... n, with
 * C_1 = 1, C_{i+1} = 0.707 C_i, FX_{i+1} = 2 FX_i, PX_i = pi/2 sin(FY_{i-1} y), the same for y, and F_0 = F_1 / 2. k
 * makes the largest value that the sums allow 1. x is the longitude on a quadric, y the angle from its lower pole.
 */
class GardnerTexture
{
public:
  explicit GardnerTexture(const GardnerTextureParameters& parameters);

  /// T, at most 1; x and y in radians, with the period 2 pi in x.
  double At(double x, double y) const;

  /// T at all pairs of an x and a y, row by row of one y each.
  std::vector<double> OnGrid(const std::vector<double>& x, const std::vector<double>& y) const;

  /// Opaque is what lies above this: T1 + (T2 - T1) (1 - g). The profile g is 1 in the middle of a quadric's outline
  /// and 0 at its silhouette.
  double Threshold(double profile) const;

private:
  struct Term
  {
    double Amplitude;
    double X; ///< frequency
    double Y;
    double XBefore; ///< x of the term before
    double YBefore;
  };
  /// A term at a place along one direction: its own angle, and the phase that the place gives to the other direction.
  struct Wave
  {
    double Sine;
    double Cosine;
    double PhaseSine;
    double PhaseCosine;
  };
  GardnerTextureParameters P;
  std::vector<Term> Terms;
  double Scale; // k
};

/// Columns of the picture that holds the texture as quadrics show it, and rows of its two parts.
inline constexpr int GardnerColumns = 512;
inline constexpr int SectionRows = 256; ///< at the foot: two sections side by side, each a square
inline constexpr int ShellRows = 768;   ///< above them: the shells

/// Rows of the picture for a shell.
inline int StripRows(int shells)
{
  return ShellRows / shells;
}

/// The profiles of shells: of the outermost and as the innermost approaches it.
inline constexpr double OuterProfile = 0.35;
inline constexpr double InnerProfile = 0.95;

/**
 * The profile of a shell, the outermost being 0. The shell is the quadric scaled by sqrt(1 - g): a line of sight that
 * meets no shell further in passes the middle of the outline at that distance, where Gardner's profile, 1 less the
 * squared distance, is the same g. Nearer to the silhouette shells are seen edge on, and sections take over.
 */
inline double ShellProfile(int shell, int shells)
{
  return OuterProfile + (InnerProfile - OuterProfile) * shell / (shells - 1);
}

/**
 * The texture as quadrics show it. Below, two sections: the outline of a quadric in a square, opaque by Gardner's rule
 * with the profile 1 - r^2. Above, its shells, the outermost first: each goes around in all the columns and from pole
 * to pole in StripRows rows, opaque by the rule with its own profile. Texels are opaque or transparent, nothing
 * between; the shade follows T.
 */
TextureImage GardnerPicture(const GardnerTexture& texture, int shells);

}

#endif
