// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralDataVariogram_h
#define LittoralDataVariogram_h

#include "Kriging/KrigingModel.h"
#include "Numerics/Parallel.h"
#include "Terrain/Variogram.h"

#include <string>
#include <vector>

namespace littoral
{

/// Minimum number of data for the fit of a model.
inline constexpr std::size_t MinimumDataForVariogram = 20;

/**
 * Experimental variogram of scattered data by Matheron's estimator, gamma(h) = sum (z_i - z_j)^2 / (2 N(h)): pairs up
 * to half the diagonal of their bounding rectangle, in 15 lag classes of equal width, of the residuals from the drift.
 * Of more than 4000 data every n-th is taken, the smallest n that leaves at most so many.
 */
std::vector<LagBin> DataVariogram(const KrigingData& data, KrigingType type, const ParallelFor& parallel = SerialFor);

/// The isotropic models of the seven, the one that fits the variogram of the data best first, with a nugget where the
/// fit calls for one. Throws InvalidInput if there are too few data, or all are equal.
std::vector<KrigingModel> FitToData(
  const KrigingData& data, const std::vector<LagBin>& variogram, const ParallelFor& parallel = SerialFor);

}

#endif
