// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralBeamModes_h
#define LittoralBeamModes_h

#include <array>

namespace littoral
{

/// The highest mode of vibration that is kept.
inline constexpr int MaximumModes = 10;

/// A uniform round cantilever.
struct RoundBeam
{
  double Length = 1.0;        ///< [m]
  double Radius = 0.05;       ///< of what bends [m]
  double YoungModulus = 9e9;  ///< [Pa]
  double MassPerLength = 5.0; ///< [kg/m]
};

/// The second moment of area of a round section, pi R^4 / 4 [m^4].
double SecondMoment(double radius);

/// The n-th positive root of cos(a) cosh(a) = -1, for n from 1 to MaximumModes: wave number times length.
double CantileverRoot(int mode);

/// A mode's shape at a part of the length from 0, the clamped end, to 1; the mean of its square is 1 and its value at
/// the tip 2 or -2 (eqs. 18 and 19 of Setas et al. in a form that neither overflows nor cancels).
double ModeShape(int mode, double part);

/// The derivative of the shape by the part of the length.
double ModeSlope(int mode, double part);

/// The second derivative of the shape by the part of the length.
double ModeCurvature(int mode, double part);

/// Amounts of the shapes 1 to MaximumModes of a uniform cantilever, or their values.
using ShapeMixture = std::array<double, MaximumModes>;

/// All shapes at a part of the length, their derivatives by it, and their second derivatives.
ShapeMixture ShapesAt(double part);
ShapeMixture SlopesAt(double part);
ShapeMixture CurvaturesAt(double part);

/// The mean of the shape over the beam: the share of a uniform load that drives the mode.
double MeanShape(int mode);

/// Angular frequency of a mode without damping [rad/s] (eq. 20).
double AngularFrequency(const RoundBeam& beam, int mode);

}

#endif
