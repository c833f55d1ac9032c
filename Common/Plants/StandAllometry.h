// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralStandAllometry_h
#define LittoralStandAllometry_h

#include <string>

namespace littoral
{

/// Forms of height-diameter curves.
enum class HeightCurveForm
{
  Curtis = 0,  ///< H = 1.37 m + a exp(-b D^c), of Curtis (1967) and Arney (1985)
  Weibull = 1, ///< H = a (1 - exp(-b D^c))
};

/// Height-diameter curve of a species, H [m] over the diameter at breast height D [cm].
struct HeightCurve
{
  HeightCurveForm Form = HeightCurveForm::Curtis;
  double A = 33.4465; ///< [m]
  double B = 3.30682;
  double C = -0.412975;
};

/// Why there is no such curve, with the name of the column; empty if there is: it must grow with the diameter.
std::string WhyInvalid(const HeightCurve& curve);

/// Height [m] of a tree of a diameter at breast height [m]. Below 7.62 cm, the smallest diameter of the trees that were
/// measured for it, a Curtis curve is a straight line to 1.37 m at a diameter of 0.
double HeightOf(const HeightCurve& curve, double diameter);

/// Diameter at breast height [m] of a tree of a height [m]; 3 m if the curve does not reach the height.
double DiameterOf(const HeightCurve& curve, double height);

/// Crown diameter [m] of a tree of a diameter and a height [m], by D = 0.557 (H W)^0.809 exp(0.056^2 / 2) with D
/// in centimetres, solved for the width W (Jucker et al. 2017, trees of the whole world).
double CrownDiameterOf(double diameter, double height);

/// Quadratic mean diameter [m] of a stand of N trees a hectare at half of the maximum stand density index (Reineke
/// 1933), N (D / 25.4 cm)^1.605 = 284; upland oaks reach 568 (230 an acre).
double DiameterOfDensity(double treesPerHectare);

/// Quantile of the diameter distribution [m] of a stand of a quadratic mean diameter [m], at a probability: a Weibull
/// distribution of shape c = 2.5 (Bailey and Dell 1973), D = b (-ln(1 - u))^(1 / c), b^2 Gamma(1 + 2 / c) = mean D^2.
double DiameterInStand(double quadraticMean, double uniform);

}

#endif
