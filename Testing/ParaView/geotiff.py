# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""GDAL's own Python package, for tests of rasters; without it, or in a plugin without GDAL, they are skipped."""

import sys

from paraview import servermanager, simple  # noqa: F401  (simple makes the writers)

if not hasattr(servermanager.writers, "ElevationWriter"):
    print("built without GDAL")
    sys.exit(125)
try:
    from osgeo import gdal, osr
except ImportError:
    print("no python3-gdal")
    sys.exit(125)
gdal.UseExceptions()


def set_place(raster, place, code):
    """Put an open raster where a geotransform says, in the coordinate system of an EPSG code."""
    system = osr.SpatialReference()
    system.ImportFromEPSG(code)
    raster.SetSpatialRef(system)
    raster.SetGeoTransform(place)
