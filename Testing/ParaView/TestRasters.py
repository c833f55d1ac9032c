# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=views
"""File > Open reads a raster of heights in metres, and Save Data writes its twin in the same place."""
import os
import tempfile

import numpy as np
from geotiff import gdal, set_place
from messages import complaints
from paraview import servermanager, simple

PLACES = {32616: (725000.0, 30.0, 0.0, 4040000.0, 0.0, -25.0), 4326: (-84.5, 0.001, 0.0, 36.5, 0.0, -0.001)}


def raster(folder, code):
    """A file of hills in a coordinate system, with a hole."""
    y, x = np.mgrid[0:40, 0:60].astype(float)
    heights = (300.0 + 40.0 * np.sin(x / 5.0) * np.cos(y / 7.0) + 5.0 * np.cos(x * y)).astype(np.float32)
    heights[10:15, 20:25] = -9999.0
    name = os.path.join(folder, f"{code}.tif")
    made = gdal.GetDriverByName("GTiff").Create(name, 60, 40, 1, gdal.GDT_Float32)
    set_place(made, PLACES[code], code)
    made.GetRasterBand(1).SetNoDataValue(-9999.0)
    made.GetRasterBand(1).WriteArray(heights)
    made = None
    return name


def picture(folder):
    """A file of colors."""
    name = os.path.join(folder, "colors.png")
    made = gdal.GetDriverByName("MEM").Create("", 8, 8, 3, gdal.GDT_Byte)
    gdal.GetDriverByName("PNG").CreateCopy(name, made)
    return name


with tempfile.TemporaryDirectory() as folder:
    place = simple.OpenDataFile(raster(folder, 32616))
    assert place.SMProxy.GetXMLName() == "ElevationReader", place.SMProxy.GetXMLName()
    place.UpdatePipeline()
    info = place.GetDataInformation()
    assert np.allclose(info.GetBounds()[:4], (725015.0, 726785.0, 4039012.5, 4039987.5)), info.GetBounds()
    assert 255.0 < place.PointData["Elevation"].GetRange(0)[0] < 300.0  # without the hole

    # As relief it has its hole and nothing else is missing.
    view = simple.CreateView("RenderView")
    shown = simple.Show(place, view)
    assert shown.Representation == "Relief", shown.Representation
    assert complaints(lambda: simple.Render(view)) == ""
    relief = simple.TerrainLevelOfDetail(Input=place, NumberOfLevels=1)
    relief.UpdatePipeline()
    assert relief.GetDataInformation().GetNumberOfCells() == 2 * 59 * 39 - 70, "cells at the hole"

    # Without a choice of mine degrees are no metres; the zone is one choice away.
    degrees = simple.OpenDataFile(raster(folder, 4326))
    text = complaints(degrees.UpdatePipeline)
    assert text.count("its coordinates are degrees, not lengths") == 1, text
    degrees.Projection = "UTM"
    assert complaints(degrees.UpdatePipeline) == ""
    west, east = degrees.GetDataInformation().GetBounds()[:2]
    assert abs(east - west - 0.059 * 89600.0) < 200.0, (west, east)  # UTM turns the rows
    assert complaints(lambda: simple.ElevationRaster(
        FileName=os.path.join(folder, "4326.tif"), Projection="UTM").UpdatePipeline()) == ""

    fit = simple.CovarianceFit(Input=place)
    twin = simple.TurningBandsTerrainFromFits(Input=simple.OutputPort(fit, 0), UseMeasuredGrid=1, Seed=4)
    twin.UpdatePipeline()
    assert np.allclose(twin.GetDataInformation().GetBounds()[:4], info.GetBounds()[:4])
    saved = os.path.join(folder, "twin.tif")
    simple.SaveData(saved, proxy=twin)
    found = gdal.Open(saved)
    assert found.GetGeoTransform() == PLACES[32616], found.GetGeoTransform()
    assert found.GetSpatialRef().GetAuthorityCode(None) == "32616"
    found = None

    # Colors are no heights.
    factory = servermanager.vtkSMProxyManager.GetProxyManager().GetWriterFactory()
    factory.UpdateAvailableWriters()
    colors = simple.PNGSeriesReader(FileNames=[picture(folder)])
    colors.UpdatePipeline()
    for proxy, offers in ((twin, True), (colors, False)):
        assert ("GeoTIFF heights of Littoral" in factory.GetSupportedFileTypes(proxy.SMProxy, 0)) == offers
    assert not [name for name in os.listdir(folder) if name.endswith(".part")]
