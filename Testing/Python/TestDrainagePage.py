# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The programs of the guide's page on drainage, run as they stand there with a GeoTIFF as their place.

What the first writes lies where the place does, for GDAL's own Python package, and has the place's heights and no
hollow. The second writes the areas that a drainage of the whole place has.
"""

import os
import sys
import tempfile

import numpy as np

try:
    from osgeo import gdal, osr
except ImportError:
    print("no python3-gdal")
    sys.exit(125)

from littoral import vtkDrainageFilter
from littoral.elevation import array_from_image, read_elevation

PAGE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Documentation", "guide", "drainage.md")
#: Corner and pixels [m] in UTM zone 16 north.
PLACE, SYSTEM = (725000.0, 90.0, 0.0, 4040000.0, 0.0, -90.0), 32616

gdal.UseExceptions()


def write_place(name):
    """A part of the Jacksboro fault as a GeoTIFF."""
    heights = array_from_image(read_elevation())[100:220, 150:300]
    raster = gdal.GetDriverByName("GTiff").Create(name, heights.shape[1], heights.shape[0], 1, gdal.GDT_Float32)
    system = osr.SpatialReference()
    system.ImportFromEPSG(SYSTEM)
    raster.SetSpatialRef(system)
    raster.SetGeoTransform(PLACE)
    raster.GetRasterBand(1).WriteArray(heights[::-1])
    return heights


with open(PAGE, encoding="utf-8") as page:
    program, by_tiles = (part.split("```")[0] for part in page.read().split("```python\n")[1:3])
call = "read_elevation()"
assert program.count(call) == 1, program
with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    heights = write_place("place.tif")
    names = {}
    exec(compile(program.replace(call, 'read_elevation("place.tif")'), PAGE, "exec"), names)
    found = gdal.Open("valleys.tif")
    valleys = found.ReadAsArray()
    assert found.GetGeoTransform() == PLACE, found.GetGeoTransform()
    assert found.GetSpatialRef().GetAuthorityCode(None) == str(SYSTEM)
    assert valleys.shape == heights.shape
    for of in np.mean, np.std, np.min, np.max:
        assert abs(of(valleys) - of(heights)) < 0.02 * heights.std(), (of, of(valleys), of(heights))
    assert np.corrcoef(valleys.ravel(), heights[::-1].ravel())[0, 1] < 0.9, "the place itself"
    again = vtkDrainageFilter()
    again.SetInputData(read_elevation("valleys.tif"))
    again.CarveOff()
    again.Update()
    sunk = again.GetOutput().GetFieldData().GetArray("DepressionFraction").GetComponent(0, 0)
    print(f"{sunk:.4%} of the cells of the file are sunk")
    assert sunk < 1e-3
    found = None

    assert by_tiles.count("1024") == 1, by_tiles
    exec(compile(by_tiles.replace("1024", "32"), PAGE, "exec"), names)
    again.SetInputData(read_elevation("place.tif"))
    again.Update()
    areas = gdal.Open("areas.tif")
    assert areas.GetGeoTransform() == PLACE, areas.GetGeoTransform()
    np.testing.assert_array_equal(areas.ReadAsArray(), array_from_image(again.GetOutput(), "DrainageArea")[::-1])
    areas = None
    os.chdir("/")
