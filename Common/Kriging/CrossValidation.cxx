// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Kriging/CrossValidation.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace littoral
{

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

std::vector<LeaveOneOutEstimate> LeaveOneOut(const KrigingSurvey& survey, const ParallelFor& parallel)
{
  KrigingData data = survey.Data;
  for (double& value : data.Values)
  {
    value -= survey.Mean;
  }
  const Kriging kriging(survey.Model, std::move(data), survey.OptionsAtData(), parallel);
  return kriging.LeaveOneOut(parallel);
}

}

CrossValidation CrossValidate(const KrigingSurvey& survey, const ParallelFor& parallel)
{
  CrossValidation validation;
  double sum = 0.0;
  double squares = 0.0;
  double standardized = 0.0;
  double known = 0.0;
  std::size_t n = 0;
  for (const LeaveOneOutEstimate& left : LeaveOneOut(survey, parallel))
  {
    const double estimate = left.Estimate + survey.Mean;
    const double value = std::isnan(estimate) ? NaN : survey.BackTransformed(estimate);
    const double error = (survey.Data.Values[n] - estimate) / std::sqrt(left.Variance);
    if (std::isfinite(error))
    {
      const double measured = survey.Measured[n] - value;
      known += 1.0;
      sum += measured;
      squares += measured * measured;
      standardized += error * error;
    }
    validation.Estimates.push_back(value);
    validation.Deviations.push_back(std::sqrt(left.Variance));
    validation.StandardizedErrors.push_back(error);
    ++n;
  }
  validation.MeanError = sum / known;
  validation.RootMeanSquareError = std::sqrt(squares / known);
  validation.MeanSquaredStandardizedError = standardized / known;
  return validation;
}

}
