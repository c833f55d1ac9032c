// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "QuadratFit.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace littoral
{

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/// Trials that are looked at beyond the largest count seen.
constexpr int MostTrials = 400;
/// Largest binomial cluster that is looked at.
constexpr int LargestCluster = 12;

double LogLikelihood(const QuadratLawParameters& law, const std::vector<long long>& frequencies)
{
  const std::vector<double> mass = MassFunctionUpTo(law, static_cast<int>(frequencies.size()) - 1);
  double sum = 0.0;
  for (std::size_t r = 0; r < frequencies.size(); ++r)
  {
    if (frequencies[r] > 0)
    {
      sum += static_cast<double>(frequencies[r]) * std::log(std::max(mass[r], 1e-300));
    }
  }
  return sum;
}

/// The largest likelihood over one parameter, searched in its logarithm between two bounds.
struct Maximum
{
  double Argument;
  double Value;
  bool Inside; ///< not at a bound
};

template <typename Function>
Maximum MaximiseOver(double low, double high, const Function& function)
{
  const double a = std::log(low);
  const double b = std::log(high);
  const auto [x, negative] =
    boost::math::tools::brent_find_minima([&](double t) { return -function(std::exp(t)); }, a, b, 26);
  return { std::exp(x), -negative, x > a + 1e-3 * (b - a) && x < b - 1e-3 * (b - a) };
}

class LawFitter
{
public:
  LawFitter(const std::vector<long long>& frequencies, const QuadratMoments& moments)
    : Frequencies(frequencies)
    , Moments(moments)
  {
  }

  QuadratFit Fit(QuadratLaw law) const
  {
    QuadratFit fit;
    fit.Law.Law = fit.Moments.Law = law;
    fit.Law.Mean = fit.Moments.Mean = this->Moments.Mean; // also the maximum likelihood keeps the mean
    switch (law)
    {
      case QuadratLaw::Poisson:
        fit.MomentsExist = fit.Exists = true;
        fit.Parameters = 1;
        break;
      case QuadratLaw::Binomial:
        this->FitBinomial(fit);
        break;
      case QuadratLaw::NegativeBinomial:
        this->FitNegativeBinomial(fit);
        break;
      case QuadratLaw::PoissonPoisson:
        this->FitPoissonPoisson(fit);
        break;
      case QuadratLaw::PoissonBinomial:
        this->FitPoissonBinomial(fit);
        break;
      case QuadratLaw::PoissonNegativeBinomial:
        this->FitPoissonNegativeBinomial(fit);
        break;
    }
    return fit;
  }

private:
  double Likelihood(const QuadratLawParameters& law) const { return LogLikelihood(law, this->Frequencies); }
  bool IsClustered() const { return this->Moments.Variance > this->Moments.Mean; }
  /// Second factorial cumulant over the mean: what clusters add to the variance of a random pattern.
  double Excess() const { return this->Moments.Variance / this->Moments.Mean - 1.0; }

  void FitBinomial(QuadratFit& fit) const
  {
    fit.Parameters = 2;
    const int largest = static_cast<int>(this->Frequencies.size()) - 1;
    if (this->Excess() < 0.0)
    {
      fit.MomentsExist = true;
      fit.Moments.Trials = std::max(largest, static_cast<int>(std::lround(this->Moments.Mean / -this->Excess())));
    }
    double best = -std::numeric_limits<double>::infinity();
    for (int trials = std::max(1, largest); trials <= largest + MostTrials; ++trials)
    {
      QuadratLawParameters law = fit.Law;
      law.Trials = trials;
      const double likelihood = this->Likelihood(law);
      if (likelihood < best)
      {
        fit.Exists = true; // a maximum inside: the profile has one
        break;
      }
      best = likelihood;
      fit.Law.Trials = trials;
    }
  }

  void FitNegativeBinomial(QuadratFit& fit) const
  {
    fit.Parameters = 2;
    fit.MomentsExist = this->IsClustered();
    fit.Moments.ClusterShape = fit.MomentsExist ? this->Moments.Mean / this->Excess() : NaN;
    const Maximum best = MaximiseOver(1e-3, 1e4, [&](double shape) {
      QuadratLawParameters law = fit.Law;
      law.ClusterShape = shape;
      return this->Likelihood(law);
    });
    fit.Law.ClusterShape = best.Argument;
    fit.Exists = best.Inside && fit.MomentsExist;
  }

  void FitPoissonPoisson(QuadratFit& fit) const
  {
    fit.Parameters = 2;
    fit.MomentsExist = this->IsClustered();
    fit.Moments.ClusterMean = fit.MomentsExist ? this->Excess() : NaN;
    const Maximum best = MaximiseOver(1e-3, 1e3, [&](double size) {
      QuadratLawParameters law = fit.Law;
      law.ClusterMean = size;
      return this->Likelihood(law);
    });
    fit.Law.ClusterMean = best.Argument;
    fit.Exists = best.Inside && fit.MomentsExist;
  }

  void FitPoissonBinomial(QuadratFit& fit) const
  {
    fit.Parameters = 3;
    double best = -std::numeric_limits<double>::infinity();
    for (int trials = 2; trials <= LargestCluster; ++trials)
    {
      const double success = this->Excess() / (trials - 1);
      if (!fit.MomentsExist && success > 0.0 && success <= 1.0)
      {
        fit.MomentsExist = true;
        fit.Moments.Trials = trials;
        fit.Moments.ClusterSuccess = success;
      }
      const Maximum inner = MaximiseOver(1e-3, 1.0, [&](double p) {
        QuadratLawParameters law = fit.Law;
        law.Trials = trials;
        law.ClusterSuccess = p;
        return this->Likelihood(law);
      });
      if (inner.Value > best)
      {
        best = inner.Value;
        fit.Law.Trials = trials;
        fit.Law.ClusterSuccess = inner.Argument;
      }
    }
    fit.Exists = this->IsClustered();
  }

  void FitPoissonNegativeBinomial(QuadratFit& fit) const
  {
    fit.Parameters = 3;
    const double mean = this->Moments.Mean;
    const double second = this->Moments.Variance - mean;
    const double third = this->Moments.ThirdMoment - 3.0 * this->Moments.Variance + 2.0 * mean;
    const double p = third / second - second / mean;
    const double shape = second / (mean * p) - 1.0;
    fit.MomentsExist = this->IsClustered() && p > 0.0 && shape > 0.0;
    fit.Moments.ClusterShape = fit.MomentsExist ? shape : NaN;
    fit.Moments.ClusterMean = fit.MomentsExist ? shape * p : NaN;
    const auto bestSize = [&](double k) {
      QuadratLawParameters law = fit.Law;
      law.ClusterShape = k;
      return MaximiseOver(1e-2, 1e2, [&](double t) {
        law.ClusterMean = t;
        return this->Likelihood(law);
      });
    };
    fit.Law.ClusterShape = MaximiseOver(0.02, 200.0, [&](double k) { return bestSize(k).Value; }).Argument;
    fit.Law.ClusterMean = bestSize(fit.Law.ClusterShape).Argument;
    fit.Exists = this->IsClustered();
  }

  const std::vector<long long>& Frequencies;
  const QuadratMoments& Moments;
};

/// Pearson's test with neighbouring counts pooled until at least 5 quadrats are expected.
void TestFit(QuadratFit& fit, const std::vector<long long>& frequencies, double quadrats)
{
  const std::vector<double> mass = MassFunction(fit.Law, static_cast<int>(frequencies.size()) - 1);
  std::vector<std::pair<double, double>> cells; // expected, observed
  double expected = 0.0;
  double observed = 0.0;
  for (std::size_t r = 0; r < mass.size(); ++r)
  {
    expected += quadrats * mass[r];
    observed += r < frequencies.size() ? static_cast<double>(frequencies[r]) : 0.0;
    if (expected >= 5.0)
    {
      cells.emplace_back(expected, observed);
      expected = observed = 0.0;
    }
  }
  if (!cells.empty())
  {
    cells.back().first += expected;
    cells.back().second += observed;
  }
  fit.ChiSquare = 0.0;
  for (const auto& [e, o] : cells)
  {
    fit.ChiSquare += (o - e) * (o - e) / e;
  }
  fit.DegreesOfFreedom = static_cast<int>(cells.size()) - 1 - fit.Parameters;
  fit.PValue = fit.DegreesOfFreedom > 0
    ? boost::math::cdf(boost::math::complement(boost::math::chi_squared(fit.DegreesOfFreedom), fit.ChiSquare))
    : NaN;
}

}

std::vector<long long> CountFrequencies(const std::vector<int>& counts)
{
  std::vector<long long> frequencies;
  for (int count : counts)
  {
    if (static_cast<std::size_t>(count) >= frequencies.size())
    {
      frequencies.resize(static_cast<std::size_t>(count) + 1, 0);
    }
    ++frequencies[static_cast<std::size_t>(count)];
  }
  return frequencies;
}

QuadratMoments MomentsOfCounts(const std::vector<long long>& frequencies)
{
  QuadratMoments moments;
  for (std::size_t r = 0; r < frequencies.size(); ++r)
  {
    moments.Quadrats += frequencies[r];
    moments.Points += frequencies[r] * static_cast<long long>(r);
  }
  const double n = static_cast<double>(moments.Quadrats);
  moments.Mean = moments.Quadrats > 0 ? static_cast<double>(moments.Points) / n : 0.0;
  for (std::size_t r = 0; r < frequencies.size(); ++r)
  {
    const double off = static_cast<double>(r) - moments.Mean;
    moments.Variance += static_cast<double>(frequencies[r]) * off * off / std::max(1.0, n - 1.0);
    moments.ThirdMoment += static_cast<double>(frequencies[r]) * off * off * off / n;
  }
  if (moments.Quadrats > 1 && moments.Points > 0)
  {
    moments.DispersionIndex = moments.Variance / moments.Mean;
    const boost::math::chi_squared law(n - 1.0);
    const double statistic = (n - 1.0) * moments.DispersionIndex;
    const double below = boost::math::cdf(law, statistic);
    const double above = boost::math::cdf(boost::math::complement(law, statistic));
    moments.DispersionPValue = std::min(1.0, 2.0 * std::min(below, above));
  }
  return moments;
}

QuadratFit FitQuadratLaw(QuadratLaw law, const std::vector<long long>& frequencies)
{
  const QuadratMoments moments = MomentsOfCounts(frequencies);
  QuadratFit fit = LawFitter(frequencies, moments).Fit(law);
  fit.LogLikelihood = LogLikelihood(fit.Law, frequencies);
  fit.AIC = 2.0 * fit.Parameters - 2.0 * fit.LogLikelihood;
  TestFit(fit, frequencies, static_cast<double>(moments.Quadrats));
  return fit;
}

std::vector<QuadratFit> FitAllQuadratLaws(const std::vector<long long>& frequencies)
{
  std::vector<QuadratFit> fits;
  for (int law = 0; law < NumberOfQuadratLaws; ++law)
  {
    fits.push_back(FitQuadratLaw(static_cast<QuadratLaw>(law), frequencies));
  }
  std::stable_sort(fits.begin(), fits.end(),
    [](const QuadratFit& a, const QuadratFit& b) { return a.Exists != b.Exists ? a.Exists : a.AIC < b.AIC; });
  return fits;
}

}
