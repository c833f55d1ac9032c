// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralConditionalField_h
#define LittoralConditionalField_h

#include "Kriging/KrigingSurvey.h"
#include "Numerics/Parallel.h"
#include "Terrain/TurningBands.h"

#include <memory>
#include <optional>
#include <vector>

namespace littoral
{

/// Options of a field through data.
struct ConditionalOptions
{
  bool Simulates = true; ///< else it is the kriging estimate
  int NumberOfLines = 0; ///< lines of the simulated field; 0: enough (EnoughLines)
  int Seed = 1;
};

/// Bytes that a field of these points from the data of a survey needs, with or without kriging variances.
double MemoryOf(const KrigingSurvey& survey, double points, bool hasVariances);

/// Time that a point of this field takes, in times of 4.8 us on one core: by sums over all n data, or by a system of k.
double CostOfPoint(const KrigingSurvey& survey, bool hasVariances);

/**
 * A field that honours data (Chiles and Delfiner 2012, section 7.3.1): a turning bands field, plus the kriged
 * differences of the data from it; without a simulated field the kriging estimate. Exact data at points of the grid are
 * met there; data with errors are met but for noise of the variance of the error.
 *
 * Use: construct, Tabulate, Solve, then Fill. The survey must live as long.
 */
class ConditionalField
{
public:
  /// Throws KrigingFailure if no field can be simulated with the model of the survey on its grid.
  ConditionalField(const KrigingSurvey& survey, const ConditionalOptions& options);

  /// Tabulates the lines of the simulated field.
  void Tabulate(const ParallelFor& parallel = SerialFor);

  /// Solves for the differences at the data. Throws KrigingFailure.
  void Solve(const ParallelFor& parallel = SerialFor);

  /// Sets the values at the points of a part of the grid, x fastest, and their kriging variances unless null. Throws
  /// KrigingFailure where the system of a neighbourhood is singular.
  void Fill(
    const GridWindow& part, double* values, double* variances = nullptr, const ParallelFor& parallel = SerialFor) const;

  /// The field at each datum.
  std::vector<double> AtData(const ParallelFor& parallel = SerialFor) const;

private:
  void FillRows(const GridWindow& part, int first, int last, double* values, double* variances) const;

  const KrigingSurvey& Survey;
  ConditionalOptions Options;
  TurningBandsParameters Bands;
  std::optional<TurningBandsField> Simulated;
  std::vector<double> SimulatedAtData; ///< 0 without a simulated field
  std::unique_ptr<Kriging> Differences;
};

}

#endif
