// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Terrain/CovarianceModels.h"

#include "Numerics/Constants.h"

#include <boost/math/special_functions/bessel.hpp>
#include <boost/math/special_functions/digamma.hpp>

#include <cmath>
#include <iterator>

namespace littoral
{

namespace
{

/// Bessel functions are computed in double precision: the digits of long double, which Boost takes else, would be
/// rounded away.
using InDouble = boost::math::policies::policy<boost::math::policies::promote_double<false>>;

double BesselJ(int order, double x)
{
  return boost::math::cyl_bessel_j(order, x, InDouble());
}

/// x^order K_order(x) for the orders 0 and 1, finite at zero for order 1; beyond 700 it is zero in double precision.
double ScaledBesselK(int order, double x)
{
  if (x > 700.0)
  {
    return 0.0;
  }
  return (order == 0 ? 1.0 : x) * boost::math::cyl_bessel_k(order, x, InDouble());
}

/// Whittle's x K1(x), which is 1 at zero.
double Whittle(double x)
{
  return x > 0.0 ? ScaledBesselK(1, x) : 1.0;
}

/// A number, and its change with an exponent.
struct Changing
{
  double Value;
  double Change;
};

/**
 * x^n times the integral of t^(-n) J0(t) from x to infinity, for large x, and its change with n: integration by parts,
 * twice for each term, gives an asymptotic series.
 */
Changing ScaledTail(double n, double x, double J0, double J1)
{
  Changing sum{ 0.0, 0.0 };
  Changing factor{ 1.0, 0.0 };
  for (int k = 0; k < 6; ++k)
  {
    const double a = n + 1.0 + 2.0 * k;
    sum.Value += factor.Value * (-J1 + a * J0 / x);
    sum.Change += factor.Change * (-J1 + a * J0 / x) + factor.Value * J0 / x;
    factor.Change = -a * (a * factor.Change + 2.0 * factor.Value) / (x * x);
    factor.Value *= -a * a / (x * x);
  }
  return sum;
}

double ScaledTailOfBesselJ0(double n, double x)
{
  return ScaledTail(n, x, BesselJ(0, x), BesselJ(1, x)).Value;
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

/// One place of a table.
struct CorrelationPoint
{
  double Uncorrelation = 0.0;
  double ByDistance = 0.0;
  double BySecondRange = 0.0;
  double ByDimension = 0.0;
};

/// A shape is made of a field once, with what is the same at all distances, and gives the point at each.
template <typename Shape>
void TabulateShape(const CovarianceParameters& field, const std::vector<double>& distances, CorrelationTable& table)
{
  const Shape shape(field);
  for (std::size_t n = 0; n < distances.size(); ++n)
  {
    const CorrelationPoint point = shape.At(distances[n]);
    table.Uncorrelation[n] = point.Uncorrelation;
    table.ByDistance[n] = point.ByDistance;
    table.BySecondRange[n] = point.BySecondRange;
    table.ByDimension[n] = point.ByDimension;
  }
}

/// Shapes of x = r / Range alone.
struct ReducedShape
{
  explicit ReducedShape(const CovarianceParameters& field)
    : Range(field.Range)
  {
  }
  double Range;
};

// -------------------------------------------------------------------------------------------------------------------
// Exponentials of the distance and of its square.

double ExponentialCorrelation(const CovarianceParameters& field, double r)
{
  return std::exp(-(r / field.Range));
}

double ExponentialSpectrum(const CovarianceParameters& field, double w)
{
  const double x = w * field.Range;
  const double q = 1.0 / (1.0 + x * x);
  return field.Range * x * q * std::sqrt(q);
}

double ExponentialBelow(const CovarianceParameters& field, double w)
{
  const double x = w * field.Range;
  return -std::expm1(-0.5 * std::log1p(x * x));
}

struct ExponentialShape : ReducedShape
{
  using ReducedShape::ReducedShape;
  CorrelationPoint At(double r) const
  {
    const double x = r / this->Range;
    const double c = std::exp(-x);
    return { 1.0 - c, -x * c };
  }
};

double GaussianCorrelation(const CovarianceParameters& field, double r)
{
  const double x = r / field.Range;
  return std::exp(-x * x);
}

double GaussianSpectrum(const CovarianceParameters& field, double w)
{
  const double x = w * field.Range;
  return 0.5 * field.Range * x * std::exp(-0.25 * x * x);
}

double GaussianBelow(const CovarianceParameters& field, double w)
{
  const double x = w * field.Range;
  return -std::expm1(-0.25 * x * x);
}

struct GaussianShape : ReducedShape
{
  using ReducedShape::ReducedShape;
  CorrelationPoint At(double r) const
  {
    const double x = r / this->Range;
    const double c = std::exp(-x * x);
    return { 1.0 - c, -2.0 * x * x * c };
  }
};

// -------------------------------------------------------------------------------------------------------------------
// Bessel functions.

double Bessel1Correlation(const CovarianceParameters& field, double r)
{
  return Whittle(r / field.Range);
}

double Bessel1Spectrum(const CovarianceParameters& field, double w)
{
  const double x = w * field.Range;
  const double q = 1.0 / (1.0 + x * x);
  return 2.0 * field.Range * x * q * q;
}

double Bessel1Below(const CovarianceParameters& field, double w)
{
  const double x = w * field.Range;
  return x * x / (1.0 + x * x);
}

/// (x K1)' = -x K0
struct Bessel1Shape : ReducedShape
{
  using ReducedShape::ReducedShape;
  CorrelationPoint At(double r) const
  {
    const double x = r / this->Range;
    return x > 0.0 ? CorrelationPoint{ 1.0 - Whittle(x), -x * x * ScaledBesselK(0, x) } : CorrelationPoint{};
  }
};

double Bessel2Correlation(const CovarianceParameters& field, double r)
{
  const double x = r / field.Range;
  return x > 0.0 ? Whittle(x) - 0.5 * x * x * ScaledBesselK(0, x) : 1.0;
}

double Bessel2Spectrum(const CovarianceParameters& field, double w)
{
  const double x = w * field.Range;
  const double q = 1.0 / (1.0 + x * x);
  return 4.0 * field.Range * x * x * x * q * q * q;
}

double Bessel2Below(const CovarianceParameters& field, double w)
{
  const double p = Bessel1Below(field, w);
  return p * p;
}

/// (x K1 - x^2 K0 / 2)' = x^2 K1 / 2 - 2 x K0
struct Bessel2Shape : ReducedShape
{
  using ReducedShape::ReducedShape;
  CorrelationPoint At(double r) const
  {
    const double x = r / this->Range;
    if (!(x > 0.0))
    {
      return {};
    }
    const double xK1 = Whittle(x);
    const double x2K0 = x * x * ScaledBesselK(0, x);
    return { 1.0 - (xK1 - 0.5 * x2K0), 0.5 * x * x * xK1 - 2.0 * x2K0 };
  }
};

// -------------------------------------------------------------------------------------------------------------------
// Telis: with equal scales it is Bessel 1.

/// log of the two scales' ratio.
double TelisLogRatio(const CovarianceParameters& field)
{
  return std::log(field.Range / field.SecondRange);
}

bool IsDegenerateTelis(const CovarianceParameters& field)
{
  return std::abs(TelisLogRatio(field)) < 1e-5;
}

double TelisCorrelation(const CovarianceParameters& field, double r)
{
  if (IsDegenerateTelis(field))
  {
    return Bessel1Correlation(field, r);
  }
  if (r <= 0.0)
  {
    return 1.0;
  }
  return (ScaledBesselK(0, r / field.Range) - ScaledBesselK(0, r / field.SecondRange)) / TelisLogRatio(field);
}

double TelisSpectrum(const CovarianceParameters& field, double w)
{
  if (IsDegenerateTelis(field))
  {
    return Bessel1Spectrum(field, w);
  }
  const double k1 = 1.0 / field.Range;
  const double k2 = 1.0 / field.SecondRange;
  return w * (k2 * k2 - k1 * k1) / ((w * w + k1 * k1) * (w * w + k2 * k2) * TelisLogRatio(field));
}

double TelisBelow(const CovarianceParameters& field, double w)
{
  if (IsDegenerateTelis(field))
  {
    return Bessel1Below(field, w);
  }
  const double x = w * field.Range;
  const double x2 = w * field.SecondRange;
  return 0.5 * (std::log1p(x * x) - std::log1p(x2 * x2)) / TelisLogRatio(field);
}

class TelisShape
{
public:
  explicit TelisShape(const CovarianceParameters& field)
    : Equal(field)
    , SecondRange(field.SecondRange)
    , LogRatio(TelisLogRatio(field))
    , IsDegenerate(IsDegenerateTelis(field))
  {
  }

  CorrelationPoint At(double r) const
  {
    if (this->IsDegenerate)
    {
      CorrelationPoint point = this->Equal.At(r);
      point.BySecondRange = -0.5 * point.ByDistance; // both ranges do the same
      return point;
    }
    if (r <= 0.0)
    {
      return {};
    }
    // With x = r/a, y = r/b and L = ln(a/b): c = (K0(x) - K0(y)) / L, r dc/dr = (y K1(y) - x K1(x)) / L,
    // b dc/db = (c - y K1(y)) / L
    const double x = r / this->Equal.Range;
    const double y = r / this->SecondRange;
    const double c = (ScaledBesselK(0, x) - ScaledBesselK(0, y)) / this->LogRatio;
    const double yK1 = ScaledBesselK(1, y);
    return { 1.0 - c, (yK1 - ScaledBesselK(1, x)) / this->LogRatio, (c - yK1) / this->LogRatio };
  }

private:
  Bessel1Shape Equal;
  double SecondRange;
  double LogRatio;
  bool IsDegenerate;
};

// -------------------------------------------------------------------------------------------------------------------
// Spherical.

double SphericalCorrelation(const CovarianceParameters& field, double r)
{
  const double x = r / field.Range;
  return x < 1.0 ? 1.0 - 1.5 * x + 0.5 * x * x * x : 0.0;
}

struct SphericalShape : ReducedShape
{
  using ReducedShape::ReducedShape;
  CorrelationPoint At(double r) const
  {
    const double x = r / this->Range;
    return x < 1.0 ? CorrelationPoint{ x * (1.5 - 0.5 * x * x), 1.5 * x * (x * x - 1.0) } : CorrelationPoint{ 1.0 };
  }
};

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

/// The spectrum over a, of x = w a.
double ReducedSphericalSpectrum(double x)
{
  if (x < 1.0)
  {
    return SphericalSeries(x, false);
  }
  const double A = IntegralOfBesselJ0(x);
  const double x2 = x * x;
  return 1.5 * A / x2 + 4.5 * (A / (x2 * x2) - BesselJ(0, x) / (x2 * x) - BesselJ(1, x) / x2);
}

double SphericalSpectrum(const CovarianceParameters& field, double w)
{
  return field.Range * ReducedSphericalSpectrum(w * field.Range);
}

double SphericalBelow(const CovarianceParameters& field, double w)
{
  const double x = w * field.Range;
  if (!(x > 0.0))
  {
    return 0.0;
  }
  if (x < 1.0)
  {
    return SphericalSeries(x, true);
  }
  const double A = IntegralOfBesselJ0(x);
  return 1.0 - 1.5 / x * (A - BesselJ(1, x) - BesselJ(0, x) / x + A / (x * x));
}

// -------------------------------------------------------------------------------------------------------------------
// Fractal: a power law above w0 = 2 pi / Range.

/// Half of the exponent of the variogram, r^(2H).
double HurstExponent(const CovarianceParameters& field)
{
  return 3.0 - field.FractalDimension;
}

/// x up to which the series of the fractal model is of use.
constexpr double FractalSeriesEnd = 22.0;

/**
 * 1 - C/s2 of the power spectrum cut off below w0, x = w0 r. The uncut variogram is a pure power of x; the part below
 * w0 is an alternating series, of use up to x of about 22; an asymptotic series takes over beyond.
 */
double CutPowerVariogram(double H, double x)
{
  if (x <= 0.0)
  {
    return 0.0;
  }
  if (x < FractalSeriesEnd)
  {
    const double half = 0.5 * x;
    double sum = 0.0;
    double term = 1.0;
    double last = 1.0;
    for (int k = 1; k < 60 && (k < half || std::abs(last) > 1e-17 * std::abs(sum)); ++k)
    {
      term *= -half * half / (double(k) * k);
      last = term / (2.0 * k - 2.0 * H);
      sum += last;
    }
    return std::pow(half, 2.0 * H) * std::tgamma(1.0 - H) / std::tgamma(1.0 + H) + 2.0 * H * sum;
  }
  return 1.0 - 2.0 * H / x * ScaledTailOfBesselJ0(2.0 * H + 1.0, x);
}

double FractalUncorrelation(const CovarianceParameters& field, double r)
{
  return CutPowerVariogram(HurstExponent(field), TwoPi * r / field.Range);
}

double FractalCorrelation(const CovarianceParameters& field, double r)
{
  return 1.0 - CutPowerVariogram(HurstExponent(field), TwoPi * (r / field.Range));
}

class FractalShape
{
public:
  explicit FractalShape(const CovarianceParameters& field)
    : LowestWaveNumber(TwoPi / field.Range)
    , H(HurstExponent(field))
    , Gamma(std::tgamma(1.0 - this->H) / std::tgamma(1.0 + this->H))
    , LogChange(boost::math::digamma(1.0 - this->H, InDouble()) + boost::math::digamma(1.0 + this->H, InDouble()))
  {
  }

  CorrelationPoint At(double r) const
  {
    const double x = this->LowestWaveNumber * r;
    return !(x > 0.0) ? CorrelationPoint{} : x < FractalSeriesEnd ? this->Near(x) : this->Far(x);
  }

private:
  /// The series of CutPowerVariogram, that of 1 - J0 beside it: r dc/dr = 2 H (c - J0).
  CorrelationPoint Near(double x) const
  {
    const double half = 0.5 * x;
    double oneLessJ0 = 0.0;
    Changing sum{ 0.0, 0.0 };
    double term = 1.0;
    double last = 1.0;
    for (int k = 1; k < 60 && (k < half || std::abs(last) > 1e-17 * std::abs(sum.Value)); ++k)
    {
      term *= -half * half / (double(k) * k);
      last = term / (2.0 * k - 2.0 * this->H);
      oneLessJ0 -= term;
      sum.Value += last;
      sum.Change += last / (k - this->H);
    }
    const double power = std::pow(half, 2.0 * this->H) * this->Gamma;
    const double variogram = power + 2.0 * this->H * sum.Value;
    const double change = power * (2.0 * std::log(half) - this->LogChange) + 2.0 * (sum.Value + this->H * sum.Change);
    return { variogram, 2.0 * this->H * (oneLessJ0 - variogram), 0.0, change };
  }

  /// c = 2 H / x times the tail.
  CorrelationPoint Far(double x) const
  {
    const double J0 = BesselJ(0, x);
    const Changing tail = ScaledTail(2.0 * this->H + 1.0, x, J0, BesselJ(1, x));
    const double c = 2.0 * this->H / x * tail.Value;
    const double change = -2.0 / x * (tail.Value + 2.0 * this->H * tail.Change);
    return { 1.0 - c, 2.0 * this->H * (c - J0), 0.0, change };
  }

  double LowestWaveNumber;
  double H;
  double Gamma;
  double LogChange; ///< of 1 / Gamma with H
};

double FractalLowest(const CovarianceParameters& field)
{
  return TwoPi / field.Range;
}

double FractalSpectrum(const CovarianceParameters& field, double w)
{
  const double w0 = FractalLowest(field);
  const double H = HurstExponent(field);
  return w < w0 ? 0.0 : 2.0 * H / w0 * std::pow(w / w0, -2.0 * H - 1.0);
}

double FractalBelow(const CovarianceParameters& field, double w)
{
  const double x = w * field.Range;
  return x <= TwoPi ? 0.0 : 1.0 - std::pow(x / TwoPi, -2.0 * HurstExponent(field));
}

// -------------------------------------------------------------------------------------------------------------------
// Rows.

using Field = CovarianceParameters;

constexpr auto Variance = MakeParameter<Field, &Field::Variance>("Variance", "m2", ValueInterval::NotNegative());
constexpr auto Range = MakeParameter<Field, &Field::Range>("Range", "m", ValueInterval::Positive());
constexpr auto SecondRange = MakeParameter<Field, &Field::SecondRange>("SecondRange", "m", ValueInterval::Positive());
constexpr auto Dimension =
  MakeParameter<Field, &Field::FractalDimension>("FractalDimension", "", ValueInterval::Between(2.0, 3.0));

constexpr ParameterList<Field> AllParameters = { { &Variance, &Range, &SecondRange, &Dimension } };

/// Rows in the order of the enumeration.
constexpr CovarianceTraits Rows[] = {
  // name, correlation, spectrum, spectrum below, table, parameters, scale of Range, uncorrelation, lowest wave number
  { "Fractal", FractalCorrelation, FractalSpectrum, FractalBelow, TabulateShape<FractalShape>,
    { { &Variance, &Range, &Dimension } }, 1.0, FractalUncorrelation, FractalLowest },
  { "SimpleExponential", ExponentialCorrelation, ExponentialSpectrum, ExponentialBelow, TabulateShape<ExponentialShape>,
    { { &Variance, &Range } } },
  { "DoubleExponential", GaussianCorrelation, GaussianSpectrum, GaussianBelow, TabulateShape<GaussianShape>,
    { { &Variance, &Range } } },
  { "Bessel1", Bessel1Correlation, Bessel1Spectrum, Bessel1Below, TabulateShape<Bessel1Shape>,
    { { &Variance, &Range } } },
  { "Bessel2", Bessel2Correlation, Bessel2Spectrum, Bessel2Below, TabulateShape<Bessel2Shape>,
    { { &Variance, &Range } } },
  { "Telis", TelisCorrelation, TelisSpectrum, TelisBelow, TabulateShape<TelisShape>,
    { { &Variance, &Range, &SecondRange } } },
  { "Spherical", SphericalCorrelation, SphericalSpectrum, SphericalBelow, TabulateShape<SphericalShape>,
    { { &Variance, &Range } }, 2.0 },
};
static_assert(std::size(Rows) == NumberOfCovarianceModels, "a row a model");

}

const CovarianceTraits& TraitsOf(CovarianceModel model)
{
  return Rows[static_cast<int>(model)];
}

const ParameterList<CovarianceParameters>& AllCovarianceParameters()
{
  return AllParameters;
}

const char* CovarianceModelName(CovarianceModel model)
{
  return TraitsOf(model).Name;
}

double LowestWaveNumber(const CovarianceParameters& field)
{
  const CovarianceTraits& traits = TraitsOf(field.Model);
  return traits.LowestWaveNumber ? traits.LowestWaveNumber(field) : 0.0;
}

std::string WhyInvalid(const CovarianceParameters& field, const std::string& prefix)
{
  ParameterCheck check;
  check.Choice(prefix + "Model", static_cast<int>(field.Model), NumberOfCovarianceModels);
  if (check.IsGood())
  {
    for (const ParameterTraits<CovarianceParameters>* parameter : TraitsOf(field.Model).Parameters)
    {
      const std::string name = parameter->Name;
      check.Within((name == "Range" ? prefix : "") + name, parameter->Get(field), parameter->Allowed, parameter->Unit);
    }
  }
  return check.Reason();
}

CorrelationTable TabulateCorrelation(const CovarianceParameters& field, const std::vector<double>& distances)
{
  CorrelationTable table;
  for (std::vector<double>* column :
    { &table.Uncorrelation, &table.ByDistance, &table.BySecondRange, &table.ByDimension })
  {
    column->resize(distances.size());
  }
  TraitsOf(field.Model).Tabulate(field, distances, table);
  return table;
}

double Covariance(const CovarianceParameters& field, double r)
{
  return field.Variance * TraitsOf(field.Model).Correlation(field, r);
}

double Semivariance(const CovarianceParameters& field, double r)
{
  const CovarianceTraits& traits = TraitsOf(field.Model);
  return field.Variance * (traits.Uncorrelation ? traits.Uncorrelation(field, r) : 1.0 - traits.Correlation(field, r));
}

double RadialSpectrum(const CovarianceParameters& field, double waveNumber)
{
  return TraitsOf(field.Model).Spectrum(field, waveNumber);
}

double CumulativeSpectrum(const CovarianceParameters& field, double waveNumber)
{
  return TraitsOf(field.Model).CumulativeSpectrum(field, waveNumber);
}

double WaveNumberAtTail(const CovarianceParameters& field, double part)
{
  // The spectrum below is monotone: bracket by decades, then halve in the logarithm.
  double low = 1e-6 / field.Range;
  double high = 1.0 / field.Range;
  while (CumulativeSpectrum(field, high) < 1.0 - part && high * field.Range < 1e9)
  {
    low = high;
    high *= 10.0;
  }
  for (int step = 0; step < 60; ++step)
  {
    const double middle = std::sqrt(low * high);
    (CumulativeSpectrum(field, middle) < 1.0 - part ? low : high) = middle;
  }
  return high;
}

}
