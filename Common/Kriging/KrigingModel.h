// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralKrigingModel_h
#define LittoralKrigingModel_h

#include "Terrain/CovarianceModels.h"

#include <cstddef>
#include <string>
#include <vector>

namespace littoral
{

/// Covariance model of a field, with nugget and geometric anisotropy.
struct KrigingModel
{
  CovarianceParameters Field;
  double Nugget = 0.0; ///< variance of the noise of each datum, beside its ErrorVariance [unit of the field squared]
  double AnisotropyRatio = 1.0; ///< longest over shortest range, at least 1; Field.Range is the longest
  double AnisotropyAngle = 0.0; ///< [rad], direction of the longest range, counter-clockwise from x
};

/// Why a model is invalid for kriging, in words for a user; empty when it is not.
std::string WhyInvalid(const KrigingModel& model);

/// Kinds of kriging, by the knowledge of the mean (Chiles and Delfiner 2012, chapter 3). Values are user-visible.
enum class KrigingType
{
  Simple = 0,         ///< known mean, which has been subtracted from the values
  Ordinary = 1,       ///< unknown constant mean
  LinearDrift = 2,    ///< universal kriging, a polynomial of degree 1
  QuadraticDrift = 3, ///< universal kriging, a polynomial of degree 2
  ExternalDrift = 4,  ///< unknown constant plus an unknown multiple of an external drift
};

inline constexpr int NumberOfKrigingTypes = 5;

/// Place of the plane [m], with the external drift there.
struct KrigingPlace
{
  double X = 0.0;
  double Y = 0.0;
  double External = 0.0;
};

/// Measured data: locations, values and error variances.
struct KrigingData
{
  std::vector<KrigingPlace> Places;
  std::vector<double> Values;         ///< one for each place
  std::vector<double> ErrorVariances; ///< one for each place [unit of the field squared]; empty: all exact

  /// Error variance of a datum, nugget apart.
  double ErrorVariance(std::size_t datum) const
  {
    return this->ErrorVariances.empty() ? 0.0 : this->ErrorVariances[datum];
  }
};

/**
 * Why data cannot be kriged, in words for a user; empty when they can: numbers of no sensible magnitude, error
 * variances below 0, or two exact data at one place, whether they contradict each other or not. Data are named by their
 * index.
 */
std::string WhyInvalid(const KrigingData& data, const KrigingModel& model);

}

#endif
