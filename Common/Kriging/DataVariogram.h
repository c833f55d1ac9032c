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

/// The fewest data from whose pairs a model is fitted.
inline constexpr std::size_t MinimumDataForVariogram = 20;

/**
 * The variogram of scattered data: pairs up to half the diagonal of their rectangle, in 15 classes of equal width
 * (Matheron's estimator). A plane is removed first where the drift is not constant. Of more than 4000 data every n-th
 * is taken, the least n that leaves at most so many.
 */
std::vector<LagBin> DataVariogram(const KrigingData& data, KrigingType type, const ParallelFor& parallel = SerialFor);

/// The isotropic models of the seven, the one that fits the variogram of the data best first, with a nugget where the
/// fit calls for one. Throws InvalidInput if there are too few data, or all are equal.
std::vector<KrigingModel> FitToData(const KrigingData& data, KrigingType type, const ParallelFor& parallel = SerialFor);

}

#endif
