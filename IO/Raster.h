// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralRaster_h
#define LittoralRaster_h

// Rasters of heights in files that GDAL knows, in metres.

#include "Numerics/InvalidInput.h"

#include <array>
#include <functional>
#include <memory>
#include <string>

namespace littoral
{

/// Why a raster cannot be read, in words that follow "Cannot read FILE: ".
class RasterError : public InvalidInput
{
public:
  using InvalidInput::InvalidInput;
};

/// The coordinate system in which a raster is read.
enum class RasterProjection
{
  AsInFile = 0,
  Utm = 1,
  Given = 2,
};

enum class RasterResampling
{
  Nearest = 0,
  Bilinear = 1,
  Cubic = 2,
};

struct RasterOptions
{
  std::string Path;
  std::string Dataset; ///< of a file with several; empty: the first
  int Band = 1;
  std::string FileSystem; ///< coordinate system of the file; empty: that which it names
  RasterProjection Projection = RasterProjection::AsInFile;
  std::string GivenSystem;
  double Spacing = 0.0; ///< after a projection [m]; 0: that of the file
  RasterResampling Resampling = RasterResampling::Cubic;
  double MetresPerHeight = 0.0; ///< unit of the heights [m]; 0: that which the file names
  bool HasLocalOrigin = false;
  bool UsesNoData = false;
  double NoData = -9999.0;
};

/// Grid of the points of a raster: the centers of its pixels, rows from south to north.
struct RasterGrid
{
  std::array<int, 2> Points{ 0, 0 };
  std::array<double, 2> Origin{ 0.0, 0.0 };  ///< of the southwestern point [m]
  std::array<double, 2> Spacing{ 1.0, 1.0 }; ///< [m]
  std::array<double, 2> Offset{ 0.0, 0.0 };  ///< offset that was subtracted from the coordinates of the map [m]
  double MetresPerUnit = 1.0;                ///< of the coordinate system
  std::string System;                        ///< WKT; empty: none
  std::string SystemName;
};

/// Told what share of the work is done; false stops it.
using RasterProgress = std::function<bool(double share)>;

class Raster
{
public:
  /// Opens a file. Throws RasterError.
  explicit Raster(const RasterOptions& options);
  ~Raster();

  const RasterGrid& Grid() const;

  /// Conversion of heights to metres in words, as "heights in feet".
  const std::string& HeightWords() const;

  /// Memory that reading rows of so many points takes beside the heights: blocks of the file, and what is projected at
  /// once [bytes].
  double WorkBytes(int width) const;

  /**
   * Heights [m] of the points from (i0, j0) to (i1, j1), both included, x fastest, rows from south to north; NaN where
   * there are none. False if stopped. Throws RasterError.
   */
  bool Read(const std::array<int, 4>& window, float* heights, const RasterProgress& progress);

private:
  class Internals;
  std::unique_ptr<Internals> Own;
};

/// Whether a file holds a raster of numbers with a place, rather than a picture.
bool IsPlacedRaster(const std::string& path);

}

#endif
