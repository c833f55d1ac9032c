// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralQuadratFit_h
#define LittoralQuadratFit_h

#include "Patterns/QuadratLaws.h"

#include <vector>

namespace littoral
{

/// Numbers of quadrats that hold 0, 1, 2... points.
std::vector<long long> CountFrequencies(const std::vector<int>& counts);

/// Moments of the counts, and the index of dispersion as a test of randomness.
struct QuadratMoments
{
  long long Quadrats = 0;
  long long Points = 0;
  double Mean = 0.0;
  double Variance = 0.0;         ///< unbiased
  double ThirdMoment = 0.0;      ///< central
  double DispersionIndex = 0.0;  ///< variance / mean: 1 random, below regular, above clustered
  double DispersionPValue = 1.0; ///< two-sided chance of an index so far from 1 in a random pattern
};
QuadratMoments MomentsOfCounts(const std::vector<long long>& frequencies);

/// One law, fitted.
struct QuadratFit
{
  QuadratLawParameters Moments; ///< by the method of moments; NaN or 0 where the moments allow no such law
  QuadratLawParameters Law;     ///< by maximum likelihood
  bool MomentsExist = false;
  bool Exists = false; ///< false where the likelihood has no maximum inside this law (it runs into its Poisson limit)
  int Parameters = 0;
  double LogLikelihood = 0.0;
  double AIC = 0.0;
  double ChiSquare = 0.0;
  int DegreesOfFreedom = 0;
  double PValue = 1.0; ///< chance of a larger ChiSquare under the law; NaN without a degree of freedom
};

/// Fits one law by moments and by maximum likelihood; cells of the test are pooled to an expectation of at least 5.
QuadratFit FitQuadratLaw(QuadratLaw law, const std::vector<long long>& frequencies);

/// Fits all laws; the smallest AIC first, laws that do not exist last.
std::vector<QuadratFit> FitAllQuadratLaws(const std::vector<long long>& frequencies);

/// AICs closer than this are not distinguishable.
inline constexpr double DistinguishableAIC = 2.0;

}

#endif
