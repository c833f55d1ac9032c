// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralRasterTiles_h
#define LittoralRasterTiles_h

// The tiles of a mosaic, GDAL's VRT. Private: never installed.

#include <array>
#include <string>

namespace littoral
{

/// Columns and rows in the order of a file: the first and the last.
using PixelWindow = std::array<int, 4>;

/// Why the tiles of a band of a mosaic that are in a window are not those that the mosaic says; empty for a file of
/// another kind and where nothing is wrong; tiles can be mosaics in turn. GDAL has zeros where a tile is smaller. A
/// tile that cannot be opened is left to who reads it.
std::string WhyOtherTiles(void* dataset, int band, const PixelWindow& window);

}

#endif
