// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralGroundQuilt_h
#define LittoralGroundQuilt_h

#include "Drainage/DrainageCarving.h"
#include "Numerics/Parallel.h"
#include "Terrain/GridSamples.h"

namespace littoral
{

/// Side of the pieces of which ground like a place is quilted [cells]: 3 sqrt(n) for n cells of its shorter side, even.
int PieceSideFor(const GridSamples& place);

/// Standard deviation of the Gauss function that smooths ground and guide before they are compared [cells]: 0.35 of a
/// piece's side, but a ninth of the place's shorter side at most.
double GuideSmoothing(const GridSamples& place);

/**
 * Quilts ground of pieces of a place (image quilting: Efros & Freeman 2001, Mahmud et al. 2014). Squares are laid row
 * by row, each over three tenths of its side of those beside it; rows are shifted along and columns up by chance, by
 * half of that at most, so that no seam goes on straight:
 *
 * 1. The cost of each piece is the mean over the overlap of the squared differences of heights, over their deviation,
 *    and of a half of the differences from cell to cell over their root mean square, of heights that are softened by
 *    one cell, and of 1 where only one of both is standing water, of half a piece and more, plus three times the mean
 *    of those of smooth heights to the guide; times 1 + u + u^2 where its cells on land are used u times already.
 * 2. One whose cost is within 1.3 of the least is drawn. None goes on in the place where one beside it ends: their
 *    shifts differ by half a side at least.
 * 3. It is cut from what is there along the ways of least difference through the overlaps.
 *
 * Pieces hand on differences from cell to cell. The heights are those whose differences are nearest to them by least
 * squares, with 1e-4 of the weight on the pieces' own heights, so that no seam is a step.
 *
 * The place and the guide have cells of one size and no missing heights; the result has the guide's grid. The smooth
 * guide is followed as far as there are pieces for it. Same bytes for any threads; the progress is told once a piece.
 * Quilts of two draws share no numbers.
 */
GridSamples QuiltGround(const GridSamples& place, const GridSamples& guide, int side, int seed,
  const ParallelFor& parallel = SerialFor, const CarvingProgress& progress = NoProgress, int draw = 0);

}

#endif
