# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: python3 tier=all
"""Rasters that Littoral has written, opened in QGIS: where the elevation model lies, there lie its copy and its twin.

Needs Debian's package python3-qgis; skipped without it. QGIS runs in a process of its own, without a window.
"""

import json
import os
import subprocess
import sys
import tempfile

import numpy as np

try:
    from osgeo import gdal, osr
except ImportError:
    print("no python3-gdal")
    sys.exit(125)

#: What QGIS says of layers: coordinate system, extent, size, and values at points of the first one's system.
QGIS = """
import json, os, sys
from qgis.core import (QgsApplication, QgsCoordinateTransform, QgsPointXY, QgsProject, QgsRasterLayer)
application = QgsApplication([], False)
application.initQgis()
names, places = json.load(sys.stdin)
layers = [QgsRasterLayer(name, "layer") for name in names]
said = []
for layer in layers:
    assert layer.isValid(), layer.error().summary()
    extent = layer.extent()
    there = QgsCoordinateTransform(layers[0].crs(), layer.crs(), QgsProject.instance())
    samples = [layer.dataProvider().sample(there.transform(QgsPointXY(*place)), 1) for place in places]
    said.append({"system": layer.crs().authid(), "unit": layer.crs().mapUnits(), "size": [layer.width(), layer.height()],
                 "extent": [extent.xMinimum(), extent.yMinimum(), extent.xMaximum(), extent.yMaximum()],
                 "values": [value if good else None for value, good in samples]})
print(json.dumps(said), flush=True)
os._exit(0)  # without what QGIS does at its end
"""


def in_qgis(names, places):
    """What QGIS says of files, as a list; None if there is no QGIS."""
    with tempfile.TemporaryDirectory() as home:
        environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen", "HOME": home, "XDG_RUNTIME_DIR": home}
        environment.pop("PYTHONPATH", None)
        environment.pop("LD_LIBRARY_PATH", None)
        if subprocess.run([sys.executable, "-c", "import qgis.core"], env=environment, capture_output=True,
                          check=False).returncode:
            return None
        ended = subprocess.run([sys.executable, "-c", QGIS], input=json.dumps([names, places]), text=True,
                               env=environment, capture_output=True, check=False)
        assert ended.returncode == 0, (ended.returncode, ended.stdout, ended.stderr)
        return json.loads(ended.stdout.splitlines()[-1])


if in_qgis([], []) is None:
    print("no python3-qgis")
    sys.exit(125)

from littoral.elevation import array_from_image, read_elevation, twin_of, write_tif  # noqa: E402

gdal.UseExceptions()
RANDOM = np.random.default_rng(19)
ROWS, COLUMNS = 60, 80
#: Corner and pixels of a place in an EPSG code, and how it is read.
PLACES = {
    "UTM": ((725000.0, 30.0, 0.0, 4040000.0, 0.0, -25.0), 32616, {}),
    "UTM, local origin": ((725000.0, 30.0, 0.0, 4040000.0, 0.0, -25.0), 32616, {"LocalOrigin": True}),
    "feet": ((1500000.0, 100.0, 0.0, 700000.0, 0.0, -120.0), 2274, {"HeightUnit": 1}),
    "south of the equator": ((300000.0, 90.0, 0.0, 6300000.0, 0.0, -90.0), 32756, {}),
    "degrees": ((-84.5, 0.001, 0.0, 36.5, 0.0, -0.001), 4326, {"projection": "UTM"}),
}


def write_model(name, place, code):
    """An elevation model, smooth enough that resampling keeps it; its heights."""
    y, x = np.mgrid[0:ROWS, 0:COLUMNS].astype(float)
    heights = (300.0 + 80.0 * np.sin(x / 9.0) * np.cos(y / 8.0) + RANDOM.normal(size=(ROWS, COLUMNS))).astype(np.float32)
    raster = gdal.GetDriverByName("GTiff").Create(name, COLUMNS, ROWS, 1, gdal.GDT_Float32)
    system = osr.SpatialReference()
    system.ImportFromEPSG(code)
    raster.SetSpatialRef(system)
    raster.SetGeoTransform(place)
    raster.GetRasterBand(1).WriteArray(heights)


def check(title, place, code, settings):
    names = [f"{kind}.tif" for kind in ("model", "copy", "twin")]
    write_model(names[0], place, code)
    image = read_elevation(names[0], **settings)
    twin = twin_of(image, seed=3)
    write_tif(image, names[1])
    write_tif(twin, names[2])
    # Middles of pixels of the model, not near its border.
    pixels = [(column, row) for column in (9, 31, 62) for row in (8, 25, 50)]
    middles = [(place[0] + (column + 0.5) * place[1], place[3] + (row + 0.5) * place[5]) for column, row in pixels]
    model, copy, grown = in_qgis(names, middles)
    assert model["system"] == f"EPSG:{code}", model
    projected = "projection" in settings
    assert copy["system"] == grown["system"] == ("EPSG:32616" if projected else model["system"]), (copy, grown)
    assert copy["extent"] == grown["extent"] and copy["size"] == grown["size"], (copy, grown)
    values = np.array([one["values"] for one in (model, copy, grown)], float)
    assert np.isfinite(values).all(), values
    # Of resampled heights: noise of 1 m that is moved by up to half a pixel.
    off = np.abs(values[1] - values[0]).max()
    assert off <= (6.0 if projected else 0.0), (off, values)
    if not projected:
        assert copy["size"] == [COLUMNS, ROWS], copy
        assert np.allclose(copy["extent"], model["extent"], rtol=0.0, atol=1e-6), (copy, model)
        heights = array_from_image(twin)
        wanted = [heights[ROWS - 1 - row, column] for column, row in pixels]
        assert np.array_equal(values[2], np.array(wanted, float)), (values[2], wanted)
    print(f"{title}: {copy['system']}, {copy['size'][0]} x {copy['size'][1]}, heights off by {off:.2f} m")


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    for title, (place, code, settings) in PLACES.items():
        check(title, place, code, settings)
    os.chdir("/")
