// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralInflowNetcdf_h
#define LittoralInflowNetcdf_h

// Winds in netCDF: u, v and w (along, across to the left, up) in float32 over time, z and y, a record a time; those of
// a tower are u_tower, v_tower and w_tower over time and z_tower, upwards. Attributes of the file: mean_wind_speed
// [m/s], hub_height [m], periodic (0 or 1) and title.

#include "InflowFile.h"

#include <memory>
#include <string>

namespace littoral
{

class NetcdfFile;

/// Planes of a wind in a file that its own library reads.
class InflowRecords
{
public:
  virtual ~InflowRecords() = default;

  virtual const InflowGrid& GetGrid() const = 0;

  /// As InflowFile::Read().
  virtual void Read(int first, int count, float* velocities) const = 0;
};

/**
 * Opens a wind in netCDF, of this program or of another that names its variables or their standard names so. Its axes
 * have the attribute axis (T, Z, Y) or a usual name; they rise in even steps, in s and m. Without an attribute of the
 * file the mean wind is that of the point at the hub, the hub in the middle of the grid, and the wind not periodic.
 * Throws InvalidInput.
 */
std::unique_ptr<InflowRecords> OpenInflowNetcdf(const std::string& path);

/// Whether a netCDF file has the three components over planes.
bool HoldsInflow(const NetcdfFile& file);

/// Writes planes from a source record by record.
FileOutcome WriteInflowNetcdf(const std::string& path, const InflowGrid& grid, const InflowSource& source);

}

#endif
