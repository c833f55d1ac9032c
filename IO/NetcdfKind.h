// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralNetcdfKind_h
#define LittoralNetcdfKind_h

// The readers of netCDF files share an extension: each claims only the files that are its own.

#include <string>

namespace littoral
{

enum class NetcdfKind
{
  Other, ///< rasters, forests, or no netCDF at all
  Wind,  ///< planes of vtkWindFieldReader
  Sea,   ///< velocities of vtkOceanCurrentReader
};

/// The kind of a file by dimensions, units and standard names; Other for one that cannot be read, and without netCDF.
NetcdfKind KindOfNetcdf(const std::string& path);

}

#endif
