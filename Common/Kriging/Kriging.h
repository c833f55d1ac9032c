// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralKriging_h
#define LittoralKriging_h

#include "Kriging/KrigingModel.h"
#include "Numerics/InvalidInput.h"
#include "Numerics/Parallel.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace littoral
{

/// How a field is estimated from data.
struct KrigingOptions
{
  KrigingType Type = KrigingType::Ordinary;
  /// Data that take part in an estimate, the nearest ones in the space where the field is isotropic; 0: all.
  std::size_t Neighbors = 0;
  /// Opposite corners of the rectangle in which estimates are wanted. What is tabulated depends on it, and thereby the
  /// last digits.
  KrigingPlace Low;
  KrigingPlace High;
};

/// What the other data say of a datum.
struct LeaveOneOutEstimate
{
  double Estimate; ///< NaN where the others are too few
  double Variance; ///< of the datum less the estimate, with the noise of the datum
};

/// Why an estimate is impossible, in words for a user.
class KrigingFailure : public InvalidInput
{
  using InvalidInput::InvalidInput;
};

/**
 * Best linear unbiased estimates of a random field from data (Matheron 1963; Chiles and Delfiner 2012, chapter 3). Data
 * have noise of the variance Nugget + ErrorVariance; what is estimated is the field without noise, so exact data are
 * met and others are smoothed.
 *
 * With all data, the equations are factored once, and an estimate is a sum over the data (dual kriging). With
 * neighbours, each estimate solves a system of its own. Memory grows with the data, for all data with their square.
 *
 * Numbers do not depend on threads, nor on which places are asked for in one call.
 */
class Kriging
{
public:
  /// Throws KrigingFailure if the system of all data is singular, or there are too few data for the drift.
  /// The data are those that WhyInvalid() passes.
  Kriging(const KrigingModel& model, KrigingData data, const KrigingOptions& options,
    const ParallelFor& parallel = SerialFor);
  ~Kriging();
  Kriging(const Kriging&) = delete;
  Kriging& operator=(const Kriging&) = delete;

  /**
   * Takes other values at the same places. Throws KrigingFailure if the estimates at exact data would miss them by more
   * than 1e-10 of the larger of the field's standard deviation and the largest value.
   */
  void SetValues(std::vector<double> values);

  /// Estimates at `count` places. Variances are of the field less the estimate; null where they are not wanted. On any
  /// thread; throws KrigingFailure where the system of a neighbourhood is singular.
  void Estimate(const KrigingPlace* places, std::size_t count, double* estimates, double* variances = nullptr) const;

  /**
   * Each datum estimated from the others: with all data from the diagonal of the inverse (Dubrule 1983), with
   * neighbours by leaving it out.
   */
  std::vector<LeaveOneOutEstimate> LeaveOneOut(const ParallelFor& parallel = SerialFor) const;

  /// Number of data that take part in an estimate.
  std::size_t GetNeighbors() const;

  /// Bytes that so many data need, neighbourhoods or not, beside the columns of variances that each thread has in work.
  static double MemoryFor(std::size_t data, std::size_t neighbors);

private:
  class Internals;
  class AllData;
  class Neighborhoods;
  std::unique_ptr<Internals> Self;
};

}

#endif
