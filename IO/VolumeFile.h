// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralVolumeFile_h
#define LittoralVolumeFile_h

#include "Numerics/Parallel.h"
#include "ReplacedFile.h"
#include "Volume.h"

#include <functional>
#include <string>
#include <vector>

namespace littoral
{

enum class VolumeCompression
{
  None,
  Zip,
  Blosc ///< Zip where OpenVDB was built without Blosc
};

struct VolumeFileOptions
{
  bool Half = false;      ///< values in 16 bits in the file
  double Tolerance = 0.0; ///< samples whose components are all at most this are not stored
  VolumeCompression Compression = VolumeCompression::Blosc;
};

/// Told the share that is done, 0 to 1; says whether to go on.
using VolumeProgress = std::function<bool(double)>;

/**
 * Writes volumes as grids of an OpenVDB file. Names must differ. A file that is there already stays as it is unless the
 * new one is whole. The bytes depend on the arguments alone.
 */
FileOutcome WriteVolumes(const std::string& path, const std::vector<Volume>& volumes, const VolumeRemarks& remarks,
  const VolumeFileOptions& options, const ParallelFor& parallelFor, const VolumeProgress& progress);

}

#endif
