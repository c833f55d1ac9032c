// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause

// Formats of netCDF, in a build without it.

#include "InflowNetcdf.h"
#include "NetcdfKind.h"
#include "Numerics/InvalidInput.h"
#include "PalmFile.h"

namespace littoral
{

namespace
{

constexpr const char* NoNetcdf = "this build of Littoral has no netCDF";

}

std::unique_ptr<InflowRecords> OpenInflowNetcdf(const std::string&)
{
  Refuse(NoNetcdf);
}

NetcdfKind KindOfNetcdf(const std::string&)
{
  return NetcdfKind::Other;
}

FileOutcome WriteInflowNetcdf(const std::string&, const InflowGrid&, const InflowSource&)
{
  return { false, NoNetcdf };
}

FileOutcome WritePalm(const std::string&, const CanopyGrid&, const PalmPlace&, const LayerOfCells&, const LayerOfCells&)
{
  return { false, NoNetcdf };
}

}
