// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Terrain/CovarianceModels.h"

#include "Numerics/Constants.h"

#include <boost/math/special_functions/bessel.hpp>

#include <cmath>
#include <sstream>

namespace littoral
{

namespace
{

double BesselJ(int order, double x)
{
  return boost::math::cyl_bessel_j(order, x);
}

/// x^order K_order(x), finite at zero for order 1; beyond 700 it is zero in double precision.
double ScaledBesselK(int order, double x)
{
  if (x > 700.0)
  {
    return 0.0;
  }
  return std::pow(x, order) * boost::math::cyl_bessel_k(order, x);
}

/// Whittle's x K1(x), which is 1 at zero.
double Whittle(double x)
{
  return x > 0.0 ? ScaledBesselK(1, x) : 1.0;
}

/**
 * x^n times the integral of t^(-n) J0(t) from x to infinity, for large x: integration by parts, twice for each term,
 * gives an asymptotic series.
 */
double ScaledTailOfBesselJ0(double n, double x)
{
  const double J0 = BesselJ(0, x);
  const double J1 = BesselJ(1, x);
  double sum = 0.0;
  double factor = 1.0;
  for (int k = 0; k < 6; ++k)
  {
    const double a = n + 1.0 + 2.0 * k;
    sum += factor * (-J1 + a * J0 / x);
    factor *= -a * a / (x * x);
  }
  return sum;
}

/**
 * The integral of J0 from 0 to x: 2 (J1 + J3 + J5 + ...). All orders come from one backward recurrence (Miller),
 * scaled by J0 + 2 J2 + 2 J4 + ... = 1. Far out, 1 less the tail.
 */
double IntegralOfBesselJ0(double x)
{
  if (x > 60.0)
  {
    return 1.0 - ScaledTailOfBesselJ0(0.0, x);
  }
  const int start = 2 * static_cast<int>(0.5 * (x + 12.0 * std::cbrt(x) + 20.0));
  double above = 0.0;
  double here = 1e-280;
  double odd = 0.0;
  double even = 0.0;
  for (int order = start; order > 0; --order)
  {
    const double below = 2.0 * order / x * here - above;
    above = here;
    here = below;
    ((order - 1) % 2 ? odd : even) += here;
    if (std::abs(here) > 1e250)
    {
      above *= 1e-250;
      here *= 1e-250;
      odd *= 1e-250;
      even *= 1e-250;
    }
  }
  return 2.0 * odd / (2.0 * even - here);
}

/**
 * Power series of the spherical model's spectrum in x = w a, for x < 1 where the closed form cancels. The moments are
 * those of 1 - 3s/2 + s^3/2 on the unit interval.
 */
double SphericalSeries(double x, bool integrated)
{
  double sum = 0.0;
  double term = 1.0;
  for (int k = 0; k < 12; ++k)
  {
    const double moment = 1.0 / (2 * k + 2) - 1.5 / (2 * k + 3) + 0.5 / (2 * k + 5);
    sum += term * moment * (integrated ? x * x / (2 * k + 2) : x);
    term *= -0.25 * x * x / ((k + 1.0) * (k + 1.0));
  }
  return sum;
}

double SphericalSpectrum(double x)
{
  if (x < 1.0)
  {
    return SphericalSeries(x, false);
  }
  const double A = IntegralOfBesselJ0(x);
  const double x2 = x * x;
  return 1.5 * A / x2 + 4.5 * (A / (x2 * x2) - BesselJ(0, x) / (x2 * x) - BesselJ(1, x) / x2);
}

double SphericalBelow(double x)
{
  if (x < 1.0)
  {
    return SphericalSeries(x, true);
  }
  const double A = IntegralOfBesselJ0(x);
  return 1.0 - 1.5 / x * (A - BesselJ(1, x) - BesselJ(0, x) / x + A / (x * x));
}

/// log of the two scales' ratio; Telis with equal scales is Bessel 1.
double TelisLogRatio(const CovarianceParameters& field)
{
  return std::log(field.Range / field.SecondRange);
}

CovarianceParameters AsBessel1(const CovarianceParameters& telis)
{
  CovarianceParameters limit = telis;
  limit.Model = CovarianceModel::Bessel1;
  return limit;
}

bool IsDegenerateTelis(const CovarianceParameters& field)
{
  return field.Model == CovarianceModel::Telis && std::abs(TelisLogRatio(field)) < 1e-5;
}

double TelisCorrelation(const CovarianceParameters& field, double r)
{
  if (r <= 0.0)
  {
    return 1.0;
  }
  return (ScaledBesselK(0, r / field.Range) - ScaledBesselK(0, r / field.SecondRange)) / TelisLogRatio(field);
}

/// Half of the exponent of the variogram, r^(2H).
double HurstExponent(const CovarianceParameters& field)
{
  return 3.0 - field.FractalDimension;
}

/**
 * 1 - C/s2 of the power spectrum cut off below w0, x = w0 r. The uncut variogram is a pure power of x; the part below
 * w0 is an alternating series, of use up to x of about 22; an asymptotic series takes over beyond.
 */
double FractalUncorrelation(double H, double x)
{
  if (x <= 0.0)
  {
    return 0.0;
  }
  if (x < 22.0)
  {
    const double half = 0.5 * x;
    double sum = 0.0;
    double term = 1.0;
    for (int k = 1; k < 60; ++k)
    {
      term *= -half * half / (double(k) * k);
      sum += term / (2.0 * k - 2.0 * H);
    }
    return std::pow(half, 2.0 * H) * std::tgamma(1.0 - H) / std::tgamma(1.0 + H) + 2.0 * H * sum;
  }
  return 1.0 - 2.0 * H / x * ScaledTailOfBesselJ0(2.0 * H + 1.0, x);
}

double Correlation(const CovarianceParameters& field, double r)
{
  const double x = r / field.Range;
  switch (field.Model)
  {
    case CovarianceModel::Fractal:
      return 1.0 - FractalUncorrelation(HurstExponent(field), TwoPi * x);
    case CovarianceModel::SimpleExponential:
      return std::exp(-x);
    case CovarianceModel::DoubleExponential:
      return std::exp(-x * x);
    case CovarianceModel::Bessel1:
      return Whittle(x);
    case CovarianceModel::Bessel2:
      return x > 0.0 ? Whittle(x) - 0.5 * x * x * ScaledBesselK(0, x) : 1.0;
    case CovarianceModel::Telis:
      return IsDegenerateTelis(field) ? Whittle(x) : TelisCorrelation(field, r);
    case CovarianceModel::Spherical:
      return x < 1.0 ? 1.0 - 1.5 * x + 0.5 * x * x * x : 0.0;
  }
  return 0.0;
}

}

const char* CovarianceModelName(CovarianceModel model)
{
  static const char* const names[NumberOfCovarianceModels] = { "Fractal", "SimpleExponential", "DoubleExponential",
    "Bessel1", "Bessel2", "Telis", "Spherical" };
  return names[static_cast<int>(model)];
}

std::string WhyInvalid(const CovarianceParameters& field)
{
  const auto complain = [](const char* what, double value, const char* wanted) {
    std::ostringstream text;
    text << what << " is " << value << "; it must be " << wanted << ".";
    return text.str();
  };
  const int model = static_cast<int>(field.Model);
  if (model < 0 || model >= NumberOfCovarianceModels)
  {
    return complain("Model", model, "one of 0 to 6");
  }
  if (!std::isfinite(field.Variance) || field.Variance < 0.0)
  {
    return complain("Variance", field.Variance, "finite and not negative");
  }
  if (!std::isfinite(field.Range) || field.Range <= 0.0)
  {
    return complain("Range", field.Range, "finite and positive");
  }
  if (field.Model == CovarianceModel::Telis && (!std::isfinite(field.SecondRange) || field.SecondRange <= 0.0))
  {
    return complain("SecondRange", field.SecondRange, "finite and positive");
  }
  if (field.Model == CovarianceModel::Fractal && !(field.FractalDimension > 2.0 && field.FractalDimension < 3.0))
  {
    return complain("FractalDimension", field.FractalDimension, "between 2 and 3, both excluded");
  }
  return {};
}

double Covariance(const CovarianceParameters& field, double r)
{
  return field.Variance * Correlation(field, r);
}

double Semivariance(const CovarianceParameters& field, double r)
{
  if (field.Model == CovarianceModel::Fractal)
  {
    return field.Variance * FractalUncorrelation(HurstExponent(field), TwoPi * r / field.Range);
  }
  return field.Variance * (1.0 - Correlation(field, r));
}

double RadialSpectrum(const CovarianceParameters& field, double w)
{
  const double a = field.Range;
  const double x = w * a;
  const double q = 1.0 / (1.0 + x * x);
  switch (field.Model)
  {
    case CovarianceModel::Fractal:
    {
      const double w0 = TwoPi / a;
      const double H = HurstExponent(field);
      return w < w0 ? 0.0 : 2.0 * H / w0 * std::pow(w / w0, -2.0 * H - 1.0);
    }
    case CovarianceModel::SimpleExponential:
      return a * x * q * std::sqrt(q);
    case CovarianceModel::DoubleExponential:
      return 0.5 * a * x * std::exp(-0.25 * x * x);
    case CovarianceModel::Bessel1:
      return 2.0 * a * x * q * q;
    case CovarianceModel::Bessel2:
      return 4.0 * a * x * x * x * q * q * q;
    case CovarianceModel::Telis:
    {
      if (IsDegenerateTelis(field))
      {
        return RadialSpectrum(AsBessel1(field), w);
      }
      const double k1 = 1.0 / field.Range;
      const double k2 = 1.0 / field.SecondRange;
      return w * (k2 * k2 - k1 * k1) / ((w * w + k1 * k1) * (w * w + k2 * k2) * TelisLogRatio(field));
    }
    case CovarianceModel::Spherical:
      return a * SphericalSpectrum(x);
  }
  return 0.0;
}

double SpectrumBelow(const CovarianceParameters& field, double w)
{
  const double x = w * field.Range;
  const double p = x * x / (1.0 + x * x);
  switch (field.Model)
  {
    case CovarianceModel::Fractal:
      return x <= TwoPi ? 0.0 : 1.0 - std::pow(x / TwoPi, -2.0 * HurstExponent(field));
    case CovarianceModel::SimpleExponential:
      return -std::expm1(-0.5 * std::log1p(x * x));
    case CovarianceModel::DoubleExponential:
      return -std::expm1(-0.25 * x * x);
    case CovarianceModel::Bessel1:
      return p;
    case CovarianceModel::Bessel2:
      return p * p;
    case CovarianceModel::Telis:
    {
      if (IsDegenerateTelis(field))
      {
        return SpectrumBelow(AsBessel1(field), w);
      }
      const double x2 = w * field.SecondRange;
      return 0.5 * (std::log1p(x * x) - std::log1p(x2 * x2)) / TelisLogRatio(field);
    }
    case CovarianceModel::Spherical:
      return x > 0.0 ? SphericalBelow(x) : 0.0;
  }
  return 0.0;
}

double WaveNumberAtTail(const CovarianceParameters& field, double part)
{
  // The spectrum below is monotone: bracket by decades, then halve in the logarithm.
  double low = 1e-6 / field.Range;
  double high = 1.0 / field.Range;
  while (SpectrumBelow(field, high) < 1.0 - part && high * field.Range < 1e9)
  {
    low = high;
    high *= 10.0;
  }
  for (int step = 0; step < 60; ++step)
  {
    const double middle = std::sqrt(low * high);
    (SpectrumBelow(field, middle) < 1.0 - part ? low : high) = middle;
  }
  return high;
}

}
