// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralTapSums_h
#define LittoralTapSums_h

namespace littoral
{

/// Lines whose tables are added to a row of points in one pass.
constexpr int LinesAtOnce = 4;
/// Points of a row in one pass, at most.
constexpr int MaximumPointsAtOnce = 256;

/// Weights of the four taps of each line.
using TapWeights = float[4][LinesAtOnce];

/**
 * Adds four lines to the sums of a row of points, each with four taps of constant weights: with the sum of a line
 * S_n(i) = (w_0n t_n0[i] + w_1n t_n1[i]) + (w_2n t_n2[i] + w_3n t_n3[i]),
 * sums[i] += (S_0(i) + S_1(i)) + (S_2(i) + S_3(i)), in this order, for 0 <= i < count.
 */
void AddTaps(const float* const (*taps)[4], const TapWeights& weights, int count, float* sums);

/// Number of values beyond the last tap that AddNeighborTaps may read.
constexpr int Overrun = 32;

/// The same for taps that lie side by side, t_nk[i] = tables[n][i + k]. It may change sums up to the next multiple of
/// 16 beyond count.
void AddNeighborTaps(const float* const* tables, const TapWeights& weights, int count, float* sums);

}

#endif
