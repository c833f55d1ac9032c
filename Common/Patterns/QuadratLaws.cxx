// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/QuadratLaws.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace littoral
{

namespace
{

/// Beyond this mean a law is refused.
constexpr double LargestMean = 1e5;
/// More counts than these are refused.
constexpr double MostCounts = 2e6;
/// More products than these are refused: a law of clusters takes the number of counts times that of sizes.
constexpr double MostProducts = 2e9;
/// Clusters that hold less than this of all points are left out.
constexpr double SmallestShare = 1e-18;

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

/// Sizes of clusters: g(0), g(1)... and ln of the chance that a quadrat has no point.
struct ClusterSizes
{
  double ClustersPerQuadrat;
  std::vector<double> Mass;
};

/// In four sums at once, which is some three times as fast.
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
  for (double left = weight.back(); weight.size() > 2 && left < SmallestShare * whole; left += weight.back())
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

std::vector<double> PoissonMass(double mean, std::size_t count)
{
  return Recur(-mean, count,
    [mean](const std::vector<double>& mass) { return mass.back() * mean / static_cast<double>(mass.size()); });
}

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

/// Negative binomial of mean k p.
std::vector<double> NegativeBinomialMass(double k, double p, std::size_t count)
{
  return Recur(-k * std::log1p(p), count, [=](const std::vector<double>& mass) {
    const double r = static_cast<double>(mass.size());
    return mass.back() * (k + r - 1.0) / r * p / (1.0 + p);
  });
}

std::vector<double> MassUpTo(const QuadratLawParameters& law, std::size_t count)
{
  switch (law.Law)
  {
    case QuadratLaw::Poisson:
      return PoissonMass(law.Mean, count);
    case QuadratLaw::Binomial:
      return BinomialMass(law.Trials, law.Mean / law.Trials, count);
    case QuadratLaw::NegativeBinomial:
      return NegativeBinomialMass(law.ClusterShape, law.Mean / law.ClusterShape, count);
    case QuadratLaw::PoissonPoisson:
      return Compound({ law.Mean / law.ClusterMean, PoissonMass(law.ClusterMean, count) }, count);
    case QuadratLaw::PoissonBinomial:
      return Compound(
        { law.Mean / (law.Trials * law.ClusterSuccess), BinomialMass(law.Trials, law.ClusterSuccess, law.Trials + 1) },
        count);
    case QuadratLaw::PoissonNegativeBinomial:
      return Compound({ law.Mean / law.ClusterMean,
                        NegativeBinomialMass(law.ClusterShape, law.ClusterMean / law.ClusterShape, count) },
        count);
  }
  return {};
}

/// How many points a quadrat or a cluster holds, but for a chance of e^-40 or so: with a tail that falls to a part e in
/// as many points as given.
double Reach(double mean, double variance, double tail)
{
  return mean + 12.0 * std::sqrt(variance) + 40.0 * tail + 20.0;
}

/// The numbers of counts and of sizes of clusters that matter; no sizes in a law without clusters.
struct Lengths
{
  double Counts;
  double Sizes = 0.0;
};

Lengths LengthsOf(const QuadratLawParameters& law)
{
  const double variance = CountVariance(law);
  const double t = law.ClusterMean;
  const double k = law.ClusterShape;
  switch (law.Law)
  {
    case QuadratLaw::Poisson:
      return { Reach(law.Mean, variance, 0.0) };
    case QuadratLaw::Binomial:
      return { std::min(Reach(law.Mean, variance, 0.0), law.Trials + 1.0) };
    case QuadratLaw::NegativeBinomial:
      return { Reach(law.Mean, variance, law.Mean / k) };
    case QuadratLaw::PoissonPoisson:
      return { Reach(law.Mean, variance, t), Reach(t, t, 0.0) };
    case QuadratLaw::PoissonBinomial:
      return { Reach(law.Mean, variance, law.Trials * law.ClusterSuccess), law.Trials + 1.0 };
    case QuadratLaw::PoissonNegativeBinomial:
      return { Reach(law.Mean, variance, t + t / k), Reach(t, t + t * t / k, t / k) };
  }
  return { 0.0 };
}

bool IsPositive(double value)
{
  return std::isfinite(value) && value > 0.0;
}

}

const char* QuadratLawName(QuadratLaw law)
{
  static const char* const names[NumberOfQuadratLaws] = { "Poisson", "Binomial", "NegativeBinomial", "PoissonPoisson",
    "PoissonBinomial", "PoissonNegativeBinomial" };
  return names[static_cast<int>(law)];
}

std::string WhyInvalid(const QuadratLawParameters& law)
{
  std::ostringstream text;
  const int id = static_cast<int>(law.Law);
  const auto uses = [&](std::initializer_list<QuadratLaw> laws) {
    return std::find(laws.begin(), laws.end(), law.Law) != laws.end();
  };
  if (id < 0 || id >= NumberOfQuadratLaws)
  {
    text << "Law is " << id << "; it must be one of 0 to 5.";
  }
  else if (!IsPositive(law.Mean) || law.Mean > LargestMean)
  {
    text << "MeanPerQuadrat is " << law.Mean << "; it must be positive and at most " << LargestMean << ".";
  }
  else if (uses({ QuadratLaw::Binomial, QuadratLaw::PoissonBinomial }) && law.Trials < 1)
  {
    text << "Trials is " << law.Trials << "; it must be positive.";
  }
  else if (law.Law == QuadratLaw::Binomial && law.Mean > law.Trials)
  {
    text << "MeanPerQuadrat is " << law.Mean << ", more than the " << law.Trials
         << " Trials, which are the most points that a quadrat of the binomial law can hold.";
  }
  else if (uses({ QuadratLaw::NegativeBinomial, QuadratLaw::PoissonNegativeBinomial }) && !IsPositive(law.ClusterShape))
  {
    text << "ClusterShape is " << law.ClusterShape << "; it must be finite and positive.";
  }
  else if (uses({ QuadratLaw::PoissonPoisson, QuadratLaw::PoissonNegativeBinomial }) && !IsPositive(law.ClusterMean))
  {
    text << "ClusterMean is " << law.ClusterMean << "; it must be finite and positive.";
  }
  else if (law.Law == QuadratLaw::PoissonBinomial && !(law.ClusterSuccess > 0.0 && law.ClusterSuccess <= 1.0))
  {
    text << "ClusterSuccess is " << law.ClusterSuccess << "; it must be above 0 and at most 1.";
  }
  else if (const Lengths lengths = LengthsOf(law); !(lengths.Counts <= MostCounts) ||
           !(lengths.Counts * std::min(lengths.Counts, lengths.Sizes) <= MostProducts))
  {
    text << "Quadrats of this law hold up to " << lengths.Counts << " points";
    if (lengths.Sizes > 0.0)
    {
      text << ", in clusters of up to " << lengths.Sizes;
    }
    text << "; that is too much to compute. Lower MeanPerQuadrat, or make clusters smaller or of more equal sizes.";
  }
  return text.str();
}

double CountVariance(const QuadratLawParameters& law)
{
  switch (law.Law)
  {
    case QuadratLaw::Poisson:
      return law.Mean;
    case QuadratLaw::Binomial:
      return law.Mean * (1.0 - law.Mean / law.Trials);
    case QuadratLaw::NegativeBinomial:
      return law.Mean * (1.0 + law.Mean / law.ClusterShape);
    case QuadratLaw::PoissonPoisson:
      return law.Mean * (1.0 + law.ClusterMean);
    case QuadratLaw::PoissonBinomial:
      return law.Mean * (1.0 + (law.Trials - 1) * law.ClusterSuccess);
    case QuadratLaw::PoissonNegativeBinomial:
      return law.Mean * (1.0 + law.ClusterMean * (1.0 + 1.0 / law.ClusterShape));
  }
  return 0.0;
}

std::vector<double> MassFunctionUpTo(const QuadratLawParameters& law, int last)
{
  std::vector<double> mass = MassUpTo(law, static_cast<std::size_t>(last) + 1);
  mass.resize(static_cast<std::size_t>(last) + 1, 0.0);
  return mass;
}

std::vector<double> MassFunction(const QuadratLawParameters& law, int atLeast)
{
  // First as far as a normal tail reaches, then further while something is left.
  const double first = std::max(Reach(law.Mean, CountVariance(law), 0.0), atLeast + 1.0);
  const double most = std::max(2.0 * LengthsOf(law).Counts, first);
  std::size_t count = static_cast<std::size_t>(first);
  while (static_cast<double>(count) < most)
  {
    std::vector<double> mass = MassUpTo(law, count);
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
  return MassUpTo(law, count);
}

}
