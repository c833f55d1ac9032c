// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralCovarianceTable_h
#define LittoralCovarianceTable_h

#include "Kriging/KrigingModel.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace littoral
{

/// Location in reduced coordinates, in which the field is isotropic [m].
using ReducedPlace = std::array<double, 2>;

/// Transformation to reduced coordinates: rotation by the anisotropy angle a, then stretching of the short axis by the
/// anisotropy ratio r, (x', y') = (x cos a + y sin a, r (y cos a - x sin a)).
class ReducedSpace
{
public:
  explicit ReducedSpace(const KrigingModel& model)
    : Cosine(std::cos(model.AnisotropyAngle))
    , Sine(std::sin(model.AnisotropyAngle))
    , Ratio(model.AnisotropyRatio)
  {
  }

  ReducedPlace operator()(double x, double y) const
  {
    return { this->Cosine * x + this->Sine * y, this->Ratio * (this->Cosine * y - this->Sine * x) };
  }

private:
  double Cosine;
  double Sine;
  double Ratio;
};

/**
 * Table of the covariance of a field C(h), nugget apart, up to a farthest distance: cubic Hermite interpolation in even
 * steps. Where a cubic is off by more than 1e-9 of the variance, which is near the origin of a rough field and at a
 * kink, it is the model itself.
 */
class CovarianceTable
{
public:
  CovarianceTable(const CovarianceParameters& field, double farthest, std::size_t steps);

  /// Covariance at a distance in reduced coordinates [m].
  double At(double distance) const
  {
    const double position = distance * this->StepsPerMetre;
    if (position < this->FirstPosition || position >= this->LastPosition)
    {
      return this->Exact(distance);
    }
    const auto step = static_cast<std::size_t>(position);
    const double t = position - static_cast<double>(step);
    const std::array<double, 4>& cubic = this->Cubics[step];
    const double value = cubic[0] + t * (cubic[1] + t * (cubic[2] + t * cubic[3]));
    return value == value ? value : this->Exact(distance); // NaN where the model has a kink
  }

  double Between(const ReducedPlace& a, const ReducedPlace& b) const
  {
    const double x = a[0] - b[0];
    const double y = a[1] - b[1];
    return this->At(std::sqrt(x * x + y * y));
  }

  /// Places whose sums go side by side.
  static constexpr std::size_t PlacesAtOnce = 4;

  /// Adds to the sum of each place the weighted covariances with data, in their order: s += w_i C(x - x_i), as by
  /// Between(), to the bit.
  void AddWeighted(const std::array<ReducedPlace, PlacesAtOnce>& places, const std::vector<ReducedPlace>& data,
    const double* weights, std::array<double, PlacesAtOnce>& sums) const;

  double GetVariance() const { return this->Field.Variance; }

private:
  double Exact(double distance) const;

  CovarianceParameters Field;
  double StepsPerMetre;
  double FirstPosition; ///< position from which the table is accurate [steps]
  double LastPosition;
  std::vector<std::array<double, 4>> Cubics;
};

}

#endif
