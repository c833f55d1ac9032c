// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralGridHoles_h
#define LittoralGridHoles_h

#include "Terrain/GridSamples.h"

#include <string>

namespace littoral
{

/// Makes missing what is missing in another grid of the same size, after FillHoles().
void TakeHoles(const GridSamples& from, GridSamples& samples, const Poll& poll = NoPoll);

/// Why a grid is too small for a landscape, in words that begin with its name: it has fewer than 16 rows or columns.
/// Empty when it is not.
std::string WhyTooSmall(const GridSamples& samples, const std::string& name);

}

#endif
