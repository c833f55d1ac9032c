// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/StandAllometry.h"

#include "Numerics/ParameterCheck.h"

#include <cmath>

namespace littoral
{

namespace
{

constexpr double BreastHeightOfCurves = 1.3716; // 4.5 feet [m]
constexpr double Centimetres = 100.0;
constexpr double ThinnestMeasured = 7.62; // 3 inches [cm]
constexpr double MaximumDiameter = 3.0;   // [m]
constexpr double WeibullShape = 2.5;

/// The form itself, without the line of thin trees.
double Curve(const HeightCurve& curve, double centimetres)
{
  const double power = std::pow(centimetres, curve.C);
  return curve.Form == HeightCurveForm::Curtis ? BreastHeightOfCurves + curve.A * std::exp(-curve.B * power)
                                               : curve.A * -std::expm1(-curve.B * power);
}

}

std::string WhyInvalid(const HeightCurve& curve)
{
  ParameterCheck check;
  check.Positive("a", curve.A, "m", 1e6);
  check.Positive("b", curve.B, "", 1e3);
  const bool isCurtis = curve.Form == HeightCurveForm::Curtis;
  check.Range("c", curve.C, isCurtis ? -10.0 : 1e-3, isCurtis ? -1e-3 : 10.0);
  return check.Reason();
}

double HeightOf(const HeightCurve& curve, double diameter)
{
  const double centimetres = Centimetres * diameter;
  if (curve.Form == HeightCurveForm::Curtis && centimetres < ThinnestMeasured)
  {
    const double reached = Curve(curve, ThinnestMeasured);
    return BreastHeightOfCurves + (reached - BreastHeightOfCurves) * centimetres / ThinnestMeasured;
  }
  return Curve(curve, centimetres);
}

double DiameterOf(const HeightCurve& curve, double height)
{
  double low = 0.0;
  double high = MaximumDiameter;
  for (int step = 0; step < 60; ++step)
  {
    const double middle = 0.5 * (low + high);
    (HeightOf(curve, middle) < height ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double CrownDiameterOf(double diameter, double height)
{
  const double factor = 0.557 * std::exp(0.5 * 0.056 * 0.056);
  return std::pow(Centimetres * diameter / factor, 1.0 / 0.809) / height;
}

double DiameterOfDensity(double treesPerHectare)
{
  constexpr double index = 284.0;
  return 0.254 * std::pow(index / treesPerHectare, 1.0 / 1.605);
}

double DiameterInStand(double quadraticMean, double uniform)
{
  // E D^2 = b^2 Gamma(1 + 2 / c), D = b (-ln(1 - u))^(1 / c)
  const double scale = quadraticMean / std::sqrt(std::tgamma(1.0 + 2.0 / WeibullShape));
  return scale * std::pow(-std::log1p(-uniform), 1.0 / WeibullShape);
}

}
