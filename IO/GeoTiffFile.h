// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralGeoTiffFile_h
#define LittoralGeoTiffFile_h

#include "Raster.h"
#include "ReplacedFile.h"

#include <array>
#include <functional>
#include <string>

namespace littoral
{

/// Heights and where they are on a map.
struct GeoTiffContent
{
  std::array<int, 2> Points{ 0, 0 };
  /// Map coordinates of the first point, and of the steps to the next one in a row and in the next row, in units of the
  /// coordinate system.
  std::array<double, 2> First{ 0.0, 0.0 };
  std::array<double, 2> Along{ 1.0, 0.0 };
  std::array<double, 2> Across{ 0.0, 1.0 };
  std::string System;  ///< in any form that GDAL reads; empty: none
  bool IsWide = false; ///< double instead of single precision
  bool IsCompressed = true;
  /// Fills some rows of heights [m], NaN where there is none; rows in the order of the file, each of them once.
  std::function<void(int first, int count, double* heights)> FillRows;
};

/// Number of rows that are filled at once: whole rows of blocks, at most 32 MiB of heights if one row of them is.
int RowsAtOnce(const GeoTiffContent& content);

/// Writes a cloud-optimized GeoTIFF: in blocks of at most 512 x 512, with overviews of half the size until one is a
/// block, each value of them the mean of those that it stands for. It takes the place of another file only when it is
/// whole. The disk holds it twice until then, once without compression. The same content makes the same bytes.
FileOutcome WriteGeoTiff(const std::string& path, const GeoTiffContent& content, const RasterProgress& progress);

}

#endif
