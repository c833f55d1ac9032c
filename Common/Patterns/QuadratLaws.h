// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralQuadratLaws_h
#define LittoralQuadratLaws_h

#include "Numerics/ParameterTraits.h"

#include <cstddef>
#include <string>
#include <vector>

namespace littoral
{

/// Laws of the number of points in a quadrat (Setas et al., section 2.2.1, after Rogers 1974). Values are user-visible.
enum class QuadratLaw
{
  Poisson = 0,
  Binomial = 1,
  NegativeBinomial = 2,
  PoissonPoisson = 3,
  PoissonBinomial = 4,
  PoissonNegativeBinomial = 5,
};

inline constexpr int NumberOfQuadratLaws = 6;

/**
 * A law with its parameters. Mean is that of the points in a quadrat, in every law:
 * | law                     | points in a quadrat                              | variance / mean          |
 * |-------------------------|--------------------------------------------------|--------------------------|
 * | Poisson                 | independent: random                              | 1                        |
 * | Binomial                | Trials places, each taken with Mean / Trials     | 1 - Mean / Trials        |
 * | NegativeBinomial        | aggregation index ClusterShape k                 | 1 + Mean / k             |
 * | PoissonPoisson          | clusters of Poisson size, mean ClusterMean t     | 1 + t     (Neyman type A)|
 * | PoissonBinomial         | clusters of binomial size, Trials n, Success p   | 1 + (n - 1) p            |
 * | PoissonNegativeBinomial | clusters of negative binomial size, mean t and k | 1 + t (1 + 1 / k)        |
 * In the last three the number of clusters in a quadrat is Poisson, of mean Mean / (mean size of a cluster).
 */
struct QuadratLawParameters
{
  QuadratLaw Law = QuadratLaw::Poisson;
  double Mean = 1.0;
  int Trials = 5;
  double ClusterShape = 1.0;
  double ClusterMean = 2.0;
  double ClusterSuccess = 0.5;
};

/// The numbers of counts and of sizes of clusters that matter; no sizes in a law without clusters.
struct QuadratLawLengths
{
  double Counts;
  double Sizes = 0.0;
};

/// The row of a law: everything that sets it apart but its fit, see QuadratFit. A new law is an enumerator and a row.
struct QuadratLawTraits
{
  const char* Name; ///< as in the enumeration
  ParameterList<QuadratLawParameters> Parameters;
  double (*CountVariance)(const QuadratLawParameters&);
  std::vector<double> (*Mass)(const QuadratLawParameters&, std::size_t count); ///< P(0), P(1)... at least `count`
  QuadratLawLengths (*Lengths)(const QuadratLawParameters&);
  /// Why parameters that are allowed one by one make no law together; null where all do.
  std::string (*WhyInvalid)(const QuadratLawParameters&) = nullptr;
};

/// The row of a law, which must be one of the enumeration.
const QuadratLawTraits& TraitsOf(QuadratLaw law);

/// The parameters of all laws, in the order of tables.
const ParameterList<QuadratLawParameters>& AllQuadratLawParameters();

/// The name of a law, as in the enumeration.
const char* QuadratLawName(QuadratLaw law);

/// Why these parameters make no law, or one of so many points and so large clusters that it takes seconds, in words for
/// a user; empty when they do.
std::string WhyInvalid(const QuadratLawParameters& law);

/// Variance of the number of points in a quadrat.
double CountVariance(const QuadratLawParameters& law);

/// Probability of 0, 1, 2... last points.
std::vector<double> MassFunctionUpTo(const QuadratLawParameters& law, int last);

/// Probability of 0, 1, 2... points, as far as more than 1e-15 in all is left, but at least up to the given count. The
/// law must be valid.
std::vector<double> MassFunction(const QuadratLawParameters& law, int atLeast = 0);

}

#endif
