// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/QuadratLaws.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

namespace littoral
{

namespace
{

/// Beyond this mean a law is refused.
constexpr double MaximumMean = 1e5;
/// More counts than these are refused.
constexpr double MaximumCounts = 2e6;
/// More products than these are refused: a law of clusters takes the number of counts times that of sizes.
constexpr double MaximumProducts = 2e9;
/// Clusters that hold less than this of all points are left out.
constexpr double MinimumProbability = 1e-18;

/**
 * Builds P(0), P(1)... from ln P(0) and a recurrence, which is given all earlier values. They are kept within the range
 * of doubles by a common factor, as P(0) of a law with a large mean is not a double.
 */
template <typename Next>
std::vector<double> Recur(double logFirst, std::size_t count, const Next& next)
{
  constexpr double Huge = 1e250;
  std::vector<double> mass = { 1.0 };
  double logScale = logFirst;
  mass.reserve(count);
  while (mass.size() < count)
  {
    mass.push_back(next(mass));
    if (mass.back() > Huge)
    {
      for (double& value : mass)
      {
        value /= Huge;
      }
      logScale += std::log(Huge);
    }
  }
  for (double& value : mass)
  {
    value = value > 0.0 ? std::exp(std::log(value) + logScale) : 0.0;
  }
  return mass;
}

/// Clusters of a compound law: their mean number a quadrat v, and the probabilities of their sizes g(0), g(1)...
struct ClusterSizes
{
  double ClustersPerQuadrat;
  std::vector<double> Mass;
};

/// Dot product in four sums at once, some three times as fast as in one.
double Product(const double* a, const double* b, std::size_t count)
{
  double sums[4] = { 0.0, 0.0, 0.0, 0.0 };
  std::size_t i = 0;
  for (; i + 4 <= count; i += 4)
  {
    for (std::size_t k = 0; k < 4; ++k)
    {
      sums[k] += a[i + k] * b[i + k];
    }
  }
  for (; i < count; ++i)
  {
    sums[0] += a[i] * b[i];
  }
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

/// Compound Poisson law (Panjer): P(r) = (v / r) * sum over j = 1 ... r of j g(j) P(r - j), P(0) = exp(-v (1 - g(0))).
std::vector<double> Compound(const ClusterSizes& sizes, std::size_t count)
{
  std::vector<double> weight(sizes.Mass.size());
  double whole = 0.0;
  for (std::size_t j = 0; j < weight.size(); ++j)
  {
    weight[j] = sizes.ClustersPerQuadrat * static_cast<double>(j) * sizes.Mass[j];
    whole += weight[j];
  }
  for (double left = weight.back(); weight.size() > 2 && left < MinimumProbability * whole; left += weight.back())
  {
    weight.pop_back();
  }
  std::reverse(weight.begin(), weight.end());
  const std::size_t largest = weight.size() - 1;
  return Recur(-sizes.ClustersPerQuadrat * (1.0 - sizes.Mass[0]), count, [&](const std::vector<double>& mass) {
    const std::size_t r = mass.size();
    const std::size_t terms = std::min(r, largest);
    return Product(&weight[largest - terms], &mass[r - terms], terms) / static_cast<double>(r);
  });
}

/// eq. 6: P(0) = e^-v, P(r) = P(r-1) v / r.
std::vector<double> PoissonMass(double mean, std::size_t count)
{
  return Recur(-mean, count,
    [mean](const std::vector<double>& mass) { return mass.back() * mean / static_cast<double>(mass.size()); });
}

/// eq. 7: P(0) = (1 - p)^n, P(r) = P(r-1) (n - r + 1) / r p / (1 - p).
std::vector<double> BinomialMass(int trials, double success, std::size_t count)
{
  if (success >= 1.0)
  {
    std::vector<double> mass(std::max<std::size_t>(count, trials + 1), 0.0);
    mass[trials] = 1.0;
    return mass;
  }
  return Recur(trials * std::log1p(-success), count, [=](const std::vector<double>& mass) {
    const double r = static_cast<double>(mass.size());
    return r > trials ? 0.0 : mass.back() * (trials - r + 1.0) / r * success / (1.0 - success);
  });
}

/// eq. 8, of mean k p: P(0) = (1 + p)^-k, P(r) = P(r-1) (k + r - 1) / r p / (1 + p).
std::vector<double> NegativeBinomialMass(double k, double p, std::size_t count)
{
  return Recur(-k * std::log1p(p), count, [=](const std::vector<double>& mass) {
    const double r = static_cast<double>(mass.size());
    return mass.back() * (k + r - 1.0) / r * p / (1.0 + p);
  });
}

/// Bound of the number of points in a quadrat or a cluster, which is exceeded with a probability of e^-40 or so: for a
/// tail that falls to a part e in as many points as given.
double Reach(double mean, double variance, double tail)
{
  return mean + 12.0 * std::sqrt(variance) + 40.0 * tail + 20.0;
}

using Law = QuadratLawParameters;

// -------------------------------------------------------------------------------------------------------------------
// Each law: variance of the count, probabilities, lengths.

double PoissonVariance(const Law& law)
{
  return law.Mean;
}

std::vector<double> PoissonLaw(const Law& law, std::size_t count)
{
  return PoissonMass(law.Mean, count);
}

QuadratLawLengths PoissonLengths(const Law& law)
{
  return { Reach(law.Mean, PoissonVariance(law), 0.0) };
}

double BinomialVariance(const Law& law)
{
  return law.Mean * (1.0 - law.Mean / law.Trials);
}

std::vector<double> BinomialLaw(const Law& law, std::size_t count)
{
  return BinomialMass(law.Trials, law.Mean / law.Trials, count);
}

QuadratLawLengths BinomialLengths(const Law& law)
{
  return { std::min(Reach(law.Mean, BinomialVariance(law), 0.0), law.Trials + 1.0) };
}

std::string WhyNotBinomial(const Law& law)
{
  std::ostringstream text;
  if (law.Mean > law.Trials)
  {
    text << "MeanPerQuadrat is " << law.Mean << ", more than the " << law.Trials
         << " Trials, which are the most points that a quadrat of the binomial law can hold.";
  }
  return text.str();
}

double NegativeBinomialVariance(const Law& law)
{
  return law.Mean * (1.0 + law.Mean / law.ClusterShape);
}

std::vector<double> NegativeBinomialLaw(const Law& law, std::size_t count)
{
  return NegativeBinomialMass(law.ClusterShape, law.Mean / law.ClusterShape, count);
}

QuadratLawLengths NegativeBinomialLengths(const Law& law)
{
  return { Reach(law.Mean, NegativeBinomialVariance(law), law.Mean / law.ClusterShape) };
}

double PoissonPoissonVariance(const Law& law)
{
  return law.Mean * (1.0 + law.ClusterMean);
}

std::vector<double> PoissonPoissonLaw(const Law& law, std::size_t count)
{
  return Compound({ law.Mean / law.ClusterMean, PoissonMass(law.ClusterMean, count) }, count);
}

QuadratLawLengths PoissonPoissonLengths(const Law& law)
{
  const double t = law.ClusterMean;
  return { Reach(law.Mean, PoissonPoissonVariance(law), t), Reach(t, t, 0.0) };
}

double PoissonBinomialVariance(const Law& law)
{
  return law.Mean * (1.0 + (law.Trials - 1) * law.ClusterSuccess);
}

std::vector<double> PoissonBinomialLaw(const Law& law, std::size_t count)
{
  const double size = law.Trials * law.ClusterSuccess;
  return Compound({ law.Mean / size, BinomialMass(law.Trials, law.ClusterSuccess, law.Trials + 1) }, count);
}

QuadratLawLengths PoissonBinomialLengths(const Law& law)
{
  return { Reach(law.Mean, PoissonBinomialVariance(law), law.Trials * law.ClusterSuccess), law.Trials + 1.0 };
}

double PoissonNegativeBinomialVariance(const Law& law)
{
  return law.Mean * (1.0 + law.ClusterMean * (1.0 + 1.0 / law.ClusterShape));
}

std::vector<double> PoissonNegativeBinomialLaw(const Law& law, std::size_t count)
{
  const double t = law.ClusterMean;
  const double k = law.ClusterShape;
  return Compound({ law.Mean / t, NegativeBinomialMass(k, t / k, count) }, count);
}

QuadratLawLengths PoissonNegativeBinomialLengths(const Law& law)
{
  const double t = law.ClusterMean;
  const double k = law.ClusterShape;
  return { Reach(law.Mean, PoissonNegativeBinomialVariance(law), t + t / k), Reach(t, t + t * t / k, t / k) };
}

// -------------------------------------------------------------------------------------------------------------------
// Rows.

constexpr auto Mean = MakeParameter<Law, &Law::Mean>("MeanPerQuadrat", "", ValueInterval::Above(0.0, MaximumMean));
constexpr auto Trials = MakeParameter<Law, &Law::Trials>("Trials", "", ValueInterval::AtLeast(1.0));
constexpr auto Shape = MakeParameter<Law, &Law::ClusterShape>("ClusterShape", "", ValueInterval::Positive());
constexpr auto ClusterMean = MakeParameter<Law, &Law::ClusterMean>("ClusterMean", "", ValueInterval::Positive());
constexpr auto Success = MakeParameter<Law, &Law::ClusterSuccess>("ClusterSuccess", "", ValueInterval::Above(0.0, 1.0));

constexpr ParameterList<Law> AllParameters = { { &Mean, &Trials, &Shape, &ClusterMean, &Success } };

/// Rows in the order of the enumeration.
constexpr QuadratLawTraits Rows[] = {
  // name, parameters, variance of the count, probabilities, lengths, what parameters must fulfil together
  { "Poisson", { { &Mean } }, PoissonVariance, PoissonLaw, PoissonLengths },
  { "Binomial", { { &Mean, &Trials } }, BinomialVariance, BinomialLaw, BinomialLengths, WhyNotBinomial },
  { "NegativeBinomial", { { &Mean, &Shape } }, NegativeBinomialVariance, NegativeBinomialLaw, NegativeBinomialLengths },
  { "PoissonPoisson", { { &Mean, &ClusterMean } }, PoissonPoissonVariance, PoissonPoissonLaw, PoissonPoissonLengths },
  { "PoissonBinomial", { { &Mean, &Trials, &Success } }, PoissonBinomialVariance, PoissonBinomialLaw,
    PoissonBinomialLengths },
  { "PoissonNegativeBinomial", { { &Mean, &Shape, &ClusterMean } }, PoissonNegativeBinomialVariance,
    PoissonNegativeBinomialLaw, PoissonNegativeBinomialLengths },
};
static_assert(std::size(Rows) == NumberOfQuadratLaws, "a row a law");

/// Why a law is too long to compute; empty when it is not.
std::string WhyTooLong(const Law& law)
{
  const QuadratLawLengths lengths = TraitsOf(law.Law).Lengths(law);
  if (lengths.Counts <= MaximumCounts && lengths.Counts * std::min(lengths.Counts, lengths.Sizes) <= MaximumProducts)
  {
    return {};
  }
  std::ostringstream text;
  text << "Quadrats of this law hold up to " << lengths.Counts << " points";
  if (lengths.Sizes > 0.0)
  {
    text << ", in clusters of up to " << lengths.Sizes;
  }
  text << "; that is too much to compute. Lower MeanPerQuadrat, or make clusters smaller or of more equal sizes.";
  return text.str();
}

}

const QuadratLawTraits& TraitsOf(QuadratLaw law)
{
  return Rows[static_cast<int>(law)];
}

const ParameterList<QuadratLawParameters>& AllQuadratLawParameters()
{
  return AllParameters;
}

const char* QuadratLawName(QuadratLaw law)
{
  return TraitsOf(law).Name;
}

std::string WhyInvalid(const QuadratLawParameters& law)
{
  ParameterCheck check;
  check.Choice("Law", static_cast<int>(law.Law), NumberOfQuadratLaws);
  if (check.IsGood())
  {
    const QuadratLawTraits& traits = TraitsOf(law.Law);
    check.Require(traits.Parameters.WhyInvalid(law));
    check.Require(check.IsGood() && traits.WhyInvalid ? traits.WhyInvalid(law) : std::string());
    check.Require(check.IsGood() ? WhyTooLong(law) : std::string());
  }
  return check.Reason();
}

double CountVariance(const QuadratLawParameters& law)
{
  return TraitsOf(law.Law).CountVariance(law);
}

std::vector<double> MassFunctionUpTo(const QuadratLawParameters& law, int last)
{
  std::vector<double> mass = TraitsOf(law.Law).Mass(law, static_cast<std::size_t>(last) + 1);
  mass.resize(static_cast<std::size_t>(last) + 1, 0.0);
  return mass;
}

std::vector<double> MassFunction(const QuadratLawParameters& law, int atLeast)
{
  const QuadratLawTraits& traits = TraitsOf(law.Law);
  // First as far as a normal tail reaches, then further while something is left.
  const double first = std::max(Reach(law.Mean, CountVariance(law), 0.0), atLeast + 1.0);
  const double most = std::max(2.0 * traits.Lengths(law).Counts, first);
  std::size_t count = static_cast<std::size_t>(first);
  while (static_cast<double>(count) < most)
  {
    std::vector<double> mass = traits.Mass(law, count);
    double total = 0.0;
    for (double value : mass)
    {
      total += value;
    }
    if (mass.back() < 1e-17 && mass.back() * static_cast<double>(mass.size()) < 1e-15 * total)
    {
      return mass;
    }
    count *= 2;
  }
  return traits.Mass(law, count);
}

}
