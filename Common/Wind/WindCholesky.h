// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralWindCholesky_h
#define LittoralWindCholesky_h

#include "Wind/WindField.h"

#include <vector>

namespace littoral
{

/// Lines that the method still takes in reasonable time.
inline constexpr std::size_t MostCholeskyLines = 256;

/**
 * The same wind as WindField by the method of Veers (1988): at each frequency the matrix of coherence between all lines
 * is factored. Coherence is exact for any separations, at a cost that grows with the cube of the number of lines: the
 * reference for small grids. NormalizeVariance has no effect.
 */
std::vector<float> CholeskyWind(const WindModel& model, const WindGrid& grid, const WindSynthesis& synthesis);

}

#endif
