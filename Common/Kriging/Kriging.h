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

/// Options of kriging.
struct KrigingOptions
{
  KrigingType Type = KrigingType::Ordinary;
  /// Size of the moving neighbourhood: the data nearest in reduced coordinates; 0: all data, a unique neighbourhood.
  std::size_t Neighbors = 0;
  /// Opposite corners of the rectangle in which estimates are wanted. The table of covariances depends on it, and
  /// thereby the last digits.
  KrigingPlace Low;
  KrigingPlace High;
};

/// Leave-one-out estimate: a datum kriged from the others.
struct LeaveOneOutEstimate
{
  double Estimate; ///< kriging estimate; NaN where the others are too few
  double Variance; ///< variance of the datum less the estimate, with the noise of the datum
};

/// Why an estimate is impossible, in words for a user.
class KrigingFailure : public InvalidInput
{
  using InvalidInput::InvalidInput;
};

/**
 * Kriging: best linear unbiased estimates of a random field from data (Matheron 1963; Chiles and Delfiner 2012, chapter
 * 3). Data have noise of the variance Nugget + ErrorVariance; the field without noise is estimated, so exact data are
 * honoured and others are filtered.
 *
 * With a unique neighbourhood the system is factored once, and an estimate is a sum over the data (dual kriging), z*(x)
 * = sum b_i C(x - x_i) + sum c_m f_m(x). With a moving neighbourhood each estimate solves a system of its own
 * (KrigingSolver). Memory grows with the data, with a unique neighbourhood with their square.
 *
 * Numbers do not depend on threads, nor on which places are asked for in one call.
 */
class Kriging
{
public:
  /// Takes data that WhyInvalid() passes. Throws KrigingFailure if there are too few data for the drift, or if the
  /// system of all data is singular: it cannot be factored, or its residuals at exact data exceed 1e-10 of the larger of
  /// the field's standard deviation and the largest value.
  Kriging(const KrigingModel& model, KrigingData data, const KrigingOptions& options,
    const ParallelFor& parallel = SerialFor);
  ~Kriging();
  Kriging(const Kriging&) = delete;
  Kriging& operator=(const Kriging&) = delete;

  /// Estimates at `count` places, and kriging variances of the field less the estimate; null: not wanted. On any
  /// thread; throws KrigingFailure where the system of a neighbourhood is singular.
  void Estimate(const KrigingPlace* places, std::size_t count, double* estimates, double* variances = nullptr) const;

  /**
   * Cross-validation: each datum kriged from the others; with a unique neighbourhood by the diagonal of the inverse
   * (Dubrule 1983), with a moving one by leaving it out.
   */
  std::vector<LeaveOneOutEstimate> LeaveOneOut(const ParallelFor& parallel = SerialFor) const;

  /// Number of data of a neighbourhood.
  std::size_t GetNeighbors() const;

  /// Memory of so many data and neighbours [bytes], beside the columns of variances that each thread has in work.
  static double MemoryFor(std::size_t data, std::size_t neighbors);

private:
  class Internals;
  class AllData;
  class Neighborhoods;
  std::unique_ptr<Internals> Self;
};

}

#endif
