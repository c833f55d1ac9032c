// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/CanopyProfile.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

constexpr int Steps = 4096;        ///< of the table of integrals
constexpr double PowerBelow = 6.0; ///< n below z_m
constexpr double PowerAbove = 0.5; ///< n above z_m

}

CanopyProfile::CanopyProfile(double maximum)
  : Maximum(maximum)
  , Below{ 0.0 }
{
  constexpr double step = 1.0 / Steps;
  for (int n = 0; n < Steps; ++n)
  {
    // Simpson's rule over a step
    const double low = n * step;
    const double ends = this->Density(low) + this->Density(low + step);
    this->Below.push_back(this->Below.back() + step / 6.0 * (ends + 4.0 * this->Density(low + 0.5 * step)));
  }
}

double CanopyProfile::Density(double height) const
{
  if (height < 0.0 || height >= 1.0)
  {
    return 0.0;
  }
  // L / L_m = q^n exp(n (1 - q)), q = (h - z_m) / (h - z)
  const double q = (1.0 - this->Maximum) / (1.0 - height);
  const double n = height < this->Maximum ? PowerBelow : PowerAbove;
  return std::pow(q, n) * std::exp(n * (1.0 - q));
}

double CanopyProfile::ShareBelow(double height) const
{
  const double place = std::clamp(height, 0.0, 1.0) * Steps;
  const int step = std::min(static_cast<int>(place), Steps - 1);
  const double from = this->Below[step];
  return (from + (place - step) * (this->Below[step + 1] - from)) / this->Integral();
}

double CanopyProfile::MeanHeight() const
{
  // integral of 1 - F over the height
  double above = 0.0;
  for (int n = 0; n < Steps; ++n)
  {
    above += (1.0 - 0.5 * (this->Below[n] + this->Below[n + 1]) / this->Integral()) / Steps;
  }
  return above;
}

double MaximumOfMean(double meanHeight)
{
  double low = 0.05;
  double high = 0.95;
  for (int n = 0; n < 30; ++n)
  {
    const double middle = 0.5 * (low + high);
    (CanopyProfile(middle).MeanHeight() < meanHeight ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}
