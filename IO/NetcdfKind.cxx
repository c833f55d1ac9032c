// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NetcdfKind.h"

#include "InflowNetcdf.h"
#include "NetcdfFile.h"
#include "OceanRoles.h"

#include <exception>

namespace littoral
{

NetcdfKind KindOfNetcdf(const std::string& path)
{
  try
  {
    const NetcdfFile file(path);
    return HoldsInflow(file) ? NetcdfKind::Wind : HasOceanVelocities(file) ? NetcdfKind::Sea : NetcdfKind::Other;
  }
  catch (const std::exception&)
  {
    return NetcdfKind::Other;
  }
}

}
