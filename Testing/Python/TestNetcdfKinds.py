# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Each reader of netCDF claims the files that it reads, and no other."""
import os
import sys
import tempfile

import littoral
import numpy as np
from classic_netcdf import Variable, write
from ocean_files import axis, regular

if not hasattr(littoral, "vtkOceanCurrentReader") or not hasattr(littoral, "vtkElevationReader"):
    print("built without netCDF or GDAL")
    sys.exit(125)

READERS = {"wind": littoral.vtkWindFieldReader, "sea": littoral.vtkOceanCurrentReader,
           "raster": littoral.vtkElevationReader}


def write_wind(path):
    source, writer = littoral.vtkWindFieldSource(), littoral.vtkWindFieldWriter()
    source.SetDimensions(8, 3, 3)
    writer.SetInputConnection(source.GetOutputPort())
    writer.SetFileName(path)
    assert writer.Write() == 1


def write_forest(path):
    from TestForestFiles import density
    writer = littoral.vtkForestDensityWriter()
    writer.SetInputDataObject(0, density().GetOutput())
    writer.SetFileName(path)
    assert writer.Write() == 1


def write_sea(path):
    regular(path, lambda x, y, z, t: (0.1 + 0.0 * x, 0.2 + 0.0 * x), (10.0, 50.0), 10.0 + 0.1 * np.arange(4),
            50.0 + 0.1 * np.arange(4), [0.0, 3600.0])


def write_grid(path, unit, name="elevation", **more):
    """Values on axes of longitude and latitude."""
    lons, lats = 10.0 + 0.01 * np.arange(5), 50.0 + 0.01 * np.arange(4)
    variables = {"lat": axis("lat", lats, units="degrees_north", standard_name="latitude"),
                 "lon": axis("lon", lons, units="degrees_east", standard_name="longitude"),
                 name: Variable("lat lon", np.arange(20.0).reshape(4, 5), "f4", units=unit, **more)}
    write(path, {"lat": 4, "lon": 5}, variables)


def write_weather(path):
    """Winds of a weather model, which are no sea, and no planes that a turbine meets."""
    lons, lats = 10.0 + 0.01 * np.arange(5), 50.0 + 0.01 * np.arange(4)
    of_wind = {letter: Variable("time lat lon", np.ones((2, 4, 5)), "f4", units="m s-1", standard_name=name)
               for letter, name in (("u", "eastward_wind"), ("v", "northward_wind"), ("w", "upward_air_velocity"))}
    write(path, {"time": 2, "lat": 4, "lon": 5},
          {"time": Variable("time", np.arange(2.0), "f8", units="hours since 2020-01-01"),
           "lat": axis("lat", lats, units="degrees_north"), "lon": axis("lon", lons, units="degrees_east"), **of_wind})


#: Files by their names, and the reader of each; "" for none of ours.
FILES = {"wind.nc": (write_wind, "wind"), "forest.nc": (write_forest, ""), "sea.nc": (write_sea, "sea"),
         "heights.nc": (lambda path: write_grid(path, "m"), "raster"),
         "temperature.nc": (lambda path: write_grid(path, "K", "t"), ""), "weather.nc": (write_weather, "")}


def write_all(folder):
    for name, (make, _) in FILES.items():
        make(os.path.join(folder, name))


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        write_all(folder)
        with open(os.path.join(folder, "text.nc"), "w", encoding="ascii") as file:
            file.write("no netCDF")
        for name in [*FILES, "text.nc", "nowhere.nc"]:
            claimed = [kind for kind, reader in READERS.items() if reader().CanReadFile(os.path.join(folder, name))]
            wanted = FILES[name][1] if name in FILES else ""
            print(f"{name}: {claimed}")
            assert claimed == ([wanted] if wanted else []), (name, claimed)
