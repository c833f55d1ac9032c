// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralCrossValidation_h
#define LittoralCrossValidation_h

#include "Kriging/KrigingSurvey.h"
#include "Numerics/Parallel.h"

#include <vector>

namespace littoral
{

/// Each datum of a survey beside its estimate from the others. NaN where the others are too few.
struct CrossValidation
{
  std::vector<double> Estimates;          ///< transformed back from scores
  std::vector<double> Deviations;         ///< kriging standard deviations, of scores where the data are scores
  std::vector<double> StandardizedErrors; ///< datum less estimate, in these deviations

  double MeanError = 0.0;                    ///< mean of value less estimate
  double RootMeanSquareError = 0.0;          ///< root of the mean of its square
  double MeanSquaredStandardizedError = 0.0; ///< 1 if the model is right
};

/// Throws KrigingFailure.
CrossValidation CrossValidate(const KrigingSurvey& survey, const ParallelFor& parallel = SerialFor);

}

#endif
