// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sea/SeaPeriods.h"

#include "Numerics/Constants.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

/// Steps of the integrals, evenly in the logarithm of the frequency.
constexpr int Steps = 8192;
/// Frequencies between which a form is summed, the lowest over that of its range [peaks].
constexpr double LowestPart = 0.4;
constexpr double HighestPart = 100.0;
constexpr double LowestOfTable = 1e-3;

/// m-1, m0, m1, m2 over angular frequency.
struct Moments
{
  double Sums[4] = { 0.0, 0.0, 0.0, 0.0 };

  /// Adds energy at an angular frequency.
  void Add(double frequency, double energy)
  {
    double power = energy / frequency;
    for (double& sum : this->Sums)
    {
      sum += power;
      power *= frequency;
    }
  }

  SeaPeriods Periods(double peak) const
  {
    const double* m = this->Sums;
    return { 4.0 * std::sqrt(m[1]), TwoPi / peak, TwoPi * m[0] / m[1], TwoPi * m[1] / m[2],
      TwoPi * std::sqrt(m[1] / m[3]) };
  }
};

}

SeaPeriods PeriodsOf(const SeaSpectrum& spectrum)
{
  const double peak = spectrum.PeakFrequency();
  if (spectrum.IsRegular())
  {
    Moments one;
    one.Add(peak, spectrum.TotalEnergy());
    return one.Periods(peak);
  }
  const bool isTable = spectrum.IsTable();
  const double lowest = spectrum.Range()[0];
  const double low = isTable ? std::max(LowestOfTable * peak, lowest) : LowestPart * lowest;
  const double high = isTable ? spectrum.Range()[1] : HighestPart * peak;
  const double ratio = std::log(high / low) / Steps;
  Moments moments;
  for (int n = 0; n <= Steps; ++n)
  {
    // Simpson's rule for the integral of S w d ln w
    const double weight = n == 0 || n == Steps ? 1.0 : n % 2 == 1 ? 4.0 : 2.0;
    const double w = low * std::exp(ratio * n);
    moments.Add(w, weight / 3.0 * ratio * w * spectrum.Density(w));
  }
  // Above, S = c w^-5: m_n = c W^(n - 4) / (4 - n)
  const double top = isTable ? 0.0 : high * spectrum.Density(high);
  double power = 1.0 / high;
  for (int n = -1; n <= 2; ++n)
  {
    moments.Sums[n + 1] += top * power / (4.0 - n);
    power *= high;
  }
  return moments.Periods(peak);
}

SeaPeriods PeriodsOf(const std::vector<WaveTrain>& trains)
{
  Moments moments;
  for (const WaveTrain& train : trains)
  {
    moments.Add(train.AngularFrequency, 0.5 * train.Amplitude * train.Amplitude);
  }
  const auto highest = std::max_element(
    trains.begin(), trains.end(), [](const WaveTrain& a, const WaveTrain& b) { return a.Amplitude < b.Amplitude; });
  return moments.Periods(highest->AngularFrequency);
}

}
