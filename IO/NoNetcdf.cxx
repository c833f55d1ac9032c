// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause

// Formats of netCDF, in a build without it.

#include "PalmFile.h"

namespace littoral
{

namespace
{

constexpr const char* NoNetcdf = "this build of Littoral has no netCDF";

}

FileOutcome WritePalm(const std::string&, const CanopyGrid&, const PalmPlace&, const LayerOfCells&, const LayerOfCells&)
{
  return { false, NoNetcdf };
}

}
