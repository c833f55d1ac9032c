// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralStandAllometry_h
#define LittoralStandAllometry_h

#include <string>

namespace littoral
{

/// Forms of curves of height over diameter.
enum class HeightCurveForm
{
  Curtis = 0,  ///< H = 1.37 m + a exp(-b D^c), of Curtis (1967) and Arney (1985)
  Weibull = 1, ///< H = a (1 - exp(-b D^c))
};

/// The height of trees of a species by their diameter. D is the diameter at breast height in centimetres, H in metres.
struct HeightCurve
{
  HeightCurveForm Form = HeightCurveForm::Curtis;
  double A = 33.4465; ///< [m]
  double B = 3.30682;
  double C = -0.412975;
};

/// Why there is no such curve, with the name of the column; empty if there is: it must grow with the diameter.
std::string WhyInvalid(const HeightCurve& curve);

/// The height [m] of a tree of a diameter [m]. Below 7.62 cm, where those who measured the trees had none, a Curtis
/// curve goes on as a straight line to 1.37 m at a diameter of 0.
double HeightOf(const HeightCurve& curve, double diameter);

/// The diameter [m] of a tree of a height [m]; that of the largest tree, 3 m, if the curve does not reach the height.
double DiameterOf(const HeightCurve& curve, double height);

/// The diameter of a crown [m] of a tree of a diameter and a height [m]: D = 0.557 (H W)^0.809 exp(0.056^2 / 2) with D
/// in centimetres, solved for the width W (Jucker et al. 2017, trees of the whole world).
double CrownDiameterOf(double diameter, double height);

/// The quadratic mean diameter [m] of a stand of a number of trees a hectare that is half as dense as the densest, by
/// Reineke (1933): N (D / 25.4 cm)^1.605 = 284, half of what upland oaks reach (230 an acre).
double DiameterOfDensity(double treesPerHectare);

/// A diameter [m] of a stand of a quadratic mean diameter [m], by a number from 0 to 1: a Weibull law of shape 2.5
/// (Bailey and Dell 1973).
double DiameterInStand(double quadraticMean, double uniform);

}

#endif
