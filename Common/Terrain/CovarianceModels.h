// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralCovarianceModels_h
#define LittoralCovarianceModels_h

#include "Numerics/ParameterTraits.h"

#include <string>
#include <vector>

namespace littoral
{

/// The covariance models of Setas et al., section 2.1 (after Mantoglou and Wilson 1982). Values are user-visible.
enum class CovarianceModel
{
  Fractal = 0,
  SimpleExponential = 1,
  DoubleExponential = 2,
  Bessel1 = 3,
  Bessel2 = 4,
  Telis = 5,
  Spherical = 6,
};

inline constexpr int NumberOfCovarianceModels = 7;

/**
 * An isotropic random field of the plane. With b = 1 / Range and s2 = Variance, at distance r:
 * | model             | covariance C(r)                                   | Range is                       |
 * |-------------------|---------------------------------------------------|--------------------------------|
 * | Fractal           | power spectrum w^(2D-7) above w0 = 2 pi / Range   | the largest wavelength         |
 * | SimpleExponential | s2 exp(-b r)                                      | 1/b                            |
 * | DoubleExponential | s2 exp(-(b r)^2)                                  | 1/b                            |
 * | Bessel1           | s2 b r K1(b r)                                    | 1/b                            |
 * | Bessel2           | s2 [b r K1(b r) - (b r)^2 K0(b r) / 2]            | 1/b                            |
 * | Telis             | s2 [K0(r/Range) - K0(r/Range2)] / ln(Range/Range2)| one scale, Range2 the other    |
 * | Spherical         | s2 [1 - 3r/2a + (r/a)^3 / 2] for r < a, else 0    | a, where correlation ends      |
 * The names Bessel2 and Telis have no formula in the paper: these are our readings (see errata).
 */
struct CovarianceParameters
{
  CovarianceModel Model = CovarianceModel::SimpleExponential;
  double Variance = 1.0;         ///< s2, the variance of the field [unit of the field squared]
  double Range = 1.0;            ///< [m], see the table
  double SecondRange = 0.1;      ///< [m], Telis only
  double FractalDimension = 2.3; ///< D of the surface, 2 < D < 3, Fractal only
};

/// The correlation c(r) = C(r) / s2 of a field at many distances, and its change with each of its parameters.
struct CorrelationTable
{
  std::vector<double> Uncorrelation; ///< 1 - c, without cancellation for the fractal model
  std::vector<double> ByDistance;    ///< r dc/dr; less BySecondRange it is the opposite of Range dc/dRange
  std::vector<double> BySecondRange; ///< Range2 dc/dRange2; Telis only, else 0
  std::vector<double> ByDimension;   ///< dc/dD; Fractal only, else 0
};

/// The row of a model: everything that sets it apart. A new model is an enumerator and a row.
struct CovarianceTraits
{
  using Function = double (*)(const CovarianceParameters&, double);

  const char* Name;            ///< as in the enumeration
  Function Correlation;        ///< C(r) / s2
  Function Spectrum;           ///< f(w)
  Function CumulativeSpectrum; ///< integral of f from 0 to w
  /// Fills a table of the distances' length.
  void (*Tabulate)(const CovarianceParameters&, const std::vector<double>& distances, CorrelationTable&);
  ParameterList<CovarianceParameters> Parameters;
  /// Distance at which correlation has fallen to about a third, as part of that of an exponential of the same Range:
  /// by it the longest range of a fit is multiplied.
  double RangeScale = 1.0;
  /// 1 - C(r) / s2 where it cannot be had from the correlation without cancellation; else null.
  Function Uncorrelation = nullptr;
  /// Wave number below which there is no power; null where the spectrum begins at 0.
  double (*LowestWaveNumber)(const CovarianceParameters&) = nullptr;
};

/// The row of a model, which must be one of the enumeration.
const CovarianceTraits& TraitsOf(CovarianceModel model);

/// The parameters of all models, in the order of tables.
const ParameterList<CovarianceParameters>& AllCovarianceParameters();

/// The name of a model, as in the enumeration.
const char* CovarianceModelName(CovarianceModel model);

/// Wave number below which there is no power [rad/m].
double LowestWaveNumber(const CovarianceParameters& field);

/// Why these parameters describe no field, in words for a user; empty when they do. A second field beside the first has
/// a Model and a Range of its own, whose names begin with the prefix.
std::string WhyInvalid(const CovarianceParameters& field, const std::string& prefix = "");

/// Covariance at distance r >= 0 [m].
double Covariance(const CovarianceParameters& field, double r);

/// Semivariance at distance r: Variance - Covariance, without cancellation for the fractal model.
double Semivariance(const CovarianceParameters& field, double r);

/// The correlation at distances r >= 0 [m] and its changes.
CorrelationTable TabulateCorrelation(const CovarianceParameters& field, const std::vector<double>& distances);

/**
 * Radial spectral density f(w) at wave number w [rad/m], of integral 1, such that
 * C(r) = s2 * integral of f(w) J0(w r) dw over w > 0; the paper's eq. 4 is S1 = s2 f / 2.
 */
double RadialSpectrum(const CovarianceParameters& field, double waveNumber);

/// The part of the variance at wave numbers below the given one: the integral of f from 0.
double CumulativeSpectrum(const CovarianceParameters& field, double waveNumber);

/// The wave number above which only the given part of the variance remains (0 < part < 1).
double WaveNumberAtTail(const CovarianceParameters& field, double part);

}

#endif
