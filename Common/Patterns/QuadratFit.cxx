// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/QuadratFit.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace littoral
{

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/// Trials that are looked at, for each point of the largest count seen. Beyond, the law is Poisson's for any data.
constexpr int MaximumTrialsAPoint = 1000;
/// Binomial clusters that are looked at one by one, and, where clusters have to be larger, up to how many times the
/// least and in what steps.
constexpr int MaximumSmallCluster = 12;
constexpr double MaximumCluster = 20.0;
constexpr double ClusterStep = 1.1;

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
Maximum MaximiseOver(double low, double high, const Function& function, int bits = 26)
{
  const double a = std::log(low);
  const double b = std::log(high);
  const auto [x, negative] =
    boost::math::tools::brent_find_minima([&](double t) { return -function(std::exp(t)); }, a, b, bits);
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
    fit.Parameters = TraitsOf(law).Parameters.Size();
    if (const auto fitLaw = Fits[static_cast<int>(law)])
    {
      (this->*fitLaw)(fit);
    }
    else
    {
      fit.MomentsExist = fit.Exists = true;
    }
    return fit;
  }

private:
  /// Fits of the laws, in the order of the enumeration; null: the mean is the only parameter.
  static void (LawFitter::*const Fits[NumberOfQuadratLaws])(QuadratFit&) const;

  double Likelihood(const QuadratLawParameters& law) const { return LogLikelihood(law, this->Frequencies); }
  bool IsClustered() const { return this->Moments.Variance > this->Moments.Mean; }
  /// Second factorial cumulant over the mean: what clusters add to the variance of a random pattern.
  double Excess() const { return this->Moments.Variance / this->Moments.Mean - 1.0; }

  void FitBinomial(QuadratFit& fit) const
  {
    const int largest = std::max(1, static_cast<int>(this->Frequencies.size()) - 1);
    const int most = (largest + 1) * MaximumTrialsAPoint;
    if (this->Excess() < 0.0)
    {
      fit.MomentsExist = true;
      // n = m / (1 - s^2/m)
      const double trials = std::min<double>(most, std::round(this->Moments.Mean / -this->Excess()));
      fit.Moments.Trials = std::max(largest, static_cast<int>(trials));
    }
    const auto likelihoodAt = [&](int trials) {
      QuadratLawParameters law = fit.Law;
      law.Trials = trials;
      return this->Likelihood(law);
    };
    // The profile has one maximum. Steps double until it falls; then two of three parts are left each time.
    int low = largest;
    int middle = largest;
    int high = largest + 1;
    double best = likelihoodAt(middle);
    while (middle < most && !fit.Exists)
    {
      const double next = likelihoodAt(high);
      fit.Exists = next < best; // a maximum inside
      if (!fit.Exists)
      {
        best = next;
        low = std::exchange(middle, high);
        high = std::min(most, largest + 2 * (high - largest));
      }
    }
    while (high - low > 2)
    {
      const int third = (high - low) / 3;
      const bool rises = likelihoodAt(low + third) < likelihoodAt(high - third);
      (rises ? low : high) = rises ? low + third : high - third;
    }
    fit.Law.Trials = low;
    for (int trials = low + 1; trials <= high; ++trials)
    {
      fit.Law.Trials = likelihoodAt(trials) > likelihoodAt(fit.Law.Trials) ? trials : fit.Law.Trials;
    }
  }

  void FitNegativeBinomial(QuadratFit& fit) const
  {
    fit.MomentsExist = this->IsClustered();
    // k = m / (s^2/m - 1)
    fit.Moments.ClusterShape = fit.MomentsExist ? this->Moments.Mean / this->Excess() : NaN;
    const Maximum best = MaximiseOver(1e-3, std::max(1e4, 1e3 * this->Moments.Mean), [&](double shape) {
      QuadratLawParameters law = fit.Law;
      law.ClusterShape = shape;
      return this->Likelihood(law);
    });
    fit.Law.ClusterShape = best.Argument;
    fit.Exists = best.Inside && fit.MomentsExist;
  }

  void FitPoissonPoisson(QuadratFit& fit) const
  {
    fit.MomentsExist = this->IsClustered();
    // t = s^2/m - 1
    fit.Moments.ClusterMean = fit.MomentsExist ? this->Excess() : NaN;
    const Maximum best = MaximiseOver(1e-3, std::max(1e3, 10.0 * this->Excess()), [&](double size) {
      QuadratLawParameters law = fit.Law;
      law.ClusterMean = size;
      return this->Likelihood(law);
    });
    fit.Law.ClusterMean = best.Argument;
    fit.Exists = best.Inside && fit.MomentsExist;
  }

  void FitPoissonBinomial(QuadratFit& fit) const
  {
    // Clusters of n points are too small for the variance where n - 1 is below the excess.
    const int least = std::max(2, static_cast<int>(std::ceil(1.0 + std::max(0.0, this->Excess()))));
    fit.MomentsExist = this->IsClustered();
    // p = (s^2/m - 1) / (n - 1)
    fit.Moments.Trials = fit.MomentsExist ? least : fit.Moments.Trials;
    fit.Moments.ClusterSuccess = fit.MomentsExist ? this->Excess() / (least - 1) : fit.Moments.ClusterSuccess;
    std::vector<int> sizes;
    for (int trials = 2; trials <= MaximumSmallCluster; ++trials)
    {
      sizes.push_back(trials);
    }
    for (double trials = least; trials > MaximumSmallCluster && trials < MaximumCluster * least; trials *= ClusterStep)
    {
      sizes.push_back(static_cast<int>(trials));
    }
    double best = -std::numeric_limits<double>::infinity();
    for (const int trials : sizes)
    {
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
    const double mean = this->Moments.Mean;
    // Factorial cumulants K_2 = s^2 - m and K_3 = m_3 - 3 s^2 + 2 m, with K_2/m = (k + 1) p and K_3/K_2 = (k + 2) p
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
      // Mean sizes of clusters not far from that of the variance, t (1 + 1 / k).
      const double size = this->IsClustered() ? this->Excess() / (1.0 + 1.0 / k) : 1.0;
      const auto likelihoodAt = [&](double t) {
        law.ClusterMean = t;
        return this->Likelihood(law);
      };
      return MaximiseOver(1e-2 * size, 10.0 * size, likelihoodAt, 20);
    };
    const auto likelihoodAt = [&](double k) { return bestSize(k).Value; };
    fit.Law.ClusterShape = MaximiseOver(0.02, 200.0, likelihoodAt, 14).Argument;
    fit.Law.ClusterMean = bestSize(fit.Law.ClusterShape).Argument;
    fit.Exists = this->IsClustered();
  }

  const std::vector<long long>& Frequencies;
  const QuadratMoments& Moments;
};

void (LawFitter::*const LawFitter::Fits[NumberOfQuadratLaws])(QuadratFit&) const = {
  nullptr, // Poisson
  &LawFitter::FitBinomial,
  &LawFitter::FitNegativeBinomial,
  &LawFitter::FitPoissonPoisson,
  &LawFitter::FitPoissonBinomial,
  &LawFitter::FitPoissonNegativeBinomial,
};

/// Pearson's test with neighbouring counts pooled until at least 5 quadrats are expected; all above the largest seen
/// are one.
void TestFit(QuadratFit& fit, const std::vector<long long>& frequencies, double quadrats)
{
  const std::vector<double> mass = MassFunctionUpTo(fit.Law, static_cast<int>(frequencies.size()) - 1);
  std::vector<std::pair<double, double>> cells; // expected, observed
  double expected = 0.0;
  double observed = 0.0;
  double beyond = quadrats;
  const auto closeCell = [&]() {
    if (expected >= 5.0)
    {
      cells.emplace_back(expected, observed);
      expected = observed = 0.0;
    }
  };
  for (std::size_t r = 0; r < mass.size(); ++r)
  {
    expected += quadrats * mass[r];
    observed += static_cast<double>(frequencies[r]);
    beyond -= quadrats * mass[r];
    closeCell();
  }
  expected += std::max(0.0, beyond);
  closeCell();
  if (!cells.empty())
  {
    cells.back().first += expected;
    cells.back().second += observed;
  }
  fit.ChiSquare = 0.0;
  for (const auto& [e, o] : cells)
  {
    // chi^2 = sum (o - e)^2 / e
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
    // s^2 = sum f_r (r - m)^2 / (n - 1),  m_3 = sum f_r (r - m)^3 / n
    const double off = static_cast<double>(r) - moments.Mean;
    moments.Variance += static_cast<double>(frequencies[r]) * off * off / std::max(1.0, n - 1.0);
    moments.ThirdMoment += static_cast<double>(frequencies[r]) * off * off * off / n;
  }
  if (moments.Quadrats > 1 && moments.Points > 0)
  {
    moments.DispersionIndex = moments.Variance / moments.Mean;
    const boost::math::chi_squared law(n - 1.0);
    // (n - 1) s^2/m has the law of chi^2 with n - 1 degrees of freedom, if points are random
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
  fits.reserve(NumberOfQuadratLaws);
  for (int law = 0; law < NumberOfQuadratLaws; ++law)
  {
    fits.push_back(FitQuadratLaw(static_cast<QuadratLaw>(law), frequencies));
  }
  std::stable_sort(fits.begin(), fits.end(),
    [](const QuadratFit& a, const QuadratFit& b) { return a.Exists != b.Exists ? a.Exists : a.AIC < b.AIC; });
  return fits;
}

}
