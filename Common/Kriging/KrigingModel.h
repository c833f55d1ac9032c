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

/// The second moments of a field and of the noise of its data.
struct KrigingModel
{
  CovarianceParameters Field;
  double Nugget = 0.0;          ///< variance of the noise of each datum, beside its own [unit of the field squared]
  double AnisotropyRatio = 1.0; ///< longest over shortest range; Field.Range is the longest
  double AnisotropyAngle = 0.0; ///< [rad], direction of the longest range, counter-clockwise from x
};

/// Why a model can not be kriged with, in words for a user; empty when it can.
std::string WhyInvalid(const KrigingModel& model);

/// What is known of the mean of the field (Chiles and Delfiner 2012, chapter 3). Values are user-visible.
enum class KrigingType
{
  Simple = 0,         ///< it is known, and has been subtracted from the values
  Ordinary = 1,       ///< an unknown constant
  LinearDrift = 2,    ///< an unknown plane
  QuadraticDrift = 3, ///< an unknown polynomial of degree 2
  ExternalDrift = 4,  ///< an unknown constant and an unknown multiple of another quantity
};

inline constexpr int NumberOfKrigingTypes = 5;

/// A place of the plane [m], with the quantity there that an external drift is a multiple of.
struct KrigingPlace
{
  double X = 0.0;
  double Y = 0.0;
  double External = 0.0;
};

/// Where the field was measured, and how well.
struct KrigingData
{
  std::vector<KrigingPlace> Places;
  std::vector<double> Values;         ///< as many
  std::vector<double> ErrorVariances; ///< as many, or none: all exact [unit of the field squared]

  /// Variance of the noise of a datum, nugget apart.
  double ErrorVariance(std::size_t datum) const
  {
    return this->ErrorVariances.empty() ? 0.0 : this->ErrorVariances[datum];
  }
};

/**
 * Why data can not be kriged, in words for a user; empty when they can: numbers of no sensible magnitude, error
 * variances below 0, or two exact data at one place, whether they contradict each other or not. Data are named by their
 * index.
 */
std::string WhyInvalid(const KrigingData& data, const KrigingModel& model);

}

#endif
