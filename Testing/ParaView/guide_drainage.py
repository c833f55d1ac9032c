# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The guide's list from a raster of heights to its twin with valleys, in the window, and back to a raster by GDAL."""

import quick  # noqa: F401
from paraview import simple

from geotiff import gdal, set_place
from player import drawn

PAGE = "drainage"

#: Corner and pixels [m] in UTM zone 16 north.
PLACE, SYSTEM = (725000.0, 90.0, 0.0, 4040000.0, 0.0, -90.0), 32616


def write_raster(file):
    """Hills with valleys as a GeoTIFF of some place."""
    hills = simple.TurningBandsTerrain(WholeExtent=[0, 90, 0, 80, 0, 0], Spacing=[90.0, 90.0, 1.0], Range=6000.0,
                                       FractalDimension=2.1, StandardDeviation=120.0, Mean=400.0, Seed=3)
    simple.SaveData("hills.tif", proxy=simple.Drainage(Input=hills, MaximumNumberOfIterations=5))
    simple.ResetSession()
    set_place(gdal.GetDriverByName("GTiff").CreateCopy(file, gdal.Open("hills.tif")), PLACE, SYSTEM)


def statistics(source):
    """The row of numbers of Ground Statistics."""
    table = source.GetClientSideObject().GetOutputDataObject(0)
    return {table.GetColumnName(k): table.GetValue(0, k).ToDouble() for k in range(table.GetNumberOfColumns())}


def close_tables():
    """In the client: closes tables and charts, for which a small window has no room."""
    scene = simple.GetRenderViews()[0]
    layout = simple.GetLayout(scene).SMProxy
    for view in simple.GetViews():
        if view.GetXMLName() != "RenderView":
            at = layout.GetViewLocation(view.SMProxy)
            layout.RemoveView(view.SMProxy)
            layout.Collapse(at)
            simple.Delete(view)
    simple.SetActiveView(scene)


def check_valleys():
    """In the client: the twin with valleys has the place's heights, and its water runs as that of the place."""
    place, valley = (statistics(simple.FindSource(name)) for name in ("GroundStatistics1", "GroundStatistics2"))
    sunk = 2.0 * place["DepressionFraction"]
    assert valley["DepressionFraction"] <= sunk, (place, valley)
    assert abs(valley["HypsometricIntegral"] - place["HypsometricIntegral"]) < 0.03, (place, valley)
    assert abs(valley["ElevationSkewness"] - place["ElevationSkewness"]) < 0.15, (place, valley)
    drainage = simple.FindSource("Drainage1")
    twin = simple.FindSource("TurningBandsTerrainFromFits1").GetClientSideObject().GetOutputDataObject(0)
    before = drainage.GetClientSideObject().GetOutputDataObject(0).GetFieldData().GetArray("DepressionFraction")
    assert twin.GetNumberOfPoints() == 91 * 81 and before.GetComponent(0, 0) > 0.1 and before.GetComponent(0, 1) <= sunk
    assert simple.OutputPort(drainage, 1).GetDataInformation().GetNumberOfCells() > 5


def prepare():
    write_raster("place.tif")


def walk(walk):
    walk.next()
    walk.open("place.tif", "GDALRasterReader")
    walk.apply()
    walk.next()
    walk.entry("Filters > Littoral > Ground Statistics")
    walk.apply()
    walk.call(close_tables)
    walk.next()
    walk.select(0)
    walk.entry("Filters > Littoral > Covariance Fit")
    walk.apply()
    walk.call(close_tables)
    walk.say("Fits")
    walk.select(0, 1, 0)
    walk.entry("Filters > Littoral > Turning Bands Terrain From Fits")
    walk.tick("Use Measured Grid")
    walk.apply()
    walk.next("Terrain", "Rivers")
    walk.entry("Filters > Littoral > Drainage")
    walk.say("Target")
    walk.connect("Target", "place.tif")
    walk.say("Quilting")
    walk.say("Method")
    walk.choose("Method", "Quilting")
    walk.apply()
    walk.look("valleys")
    walk.next()
    walk.say("Terrain")
    walk.select(0, 1, 0, 0, 0)
    walk.entry("Filters > Littoral > Ground Statistics")
    walk.apply()
    walk.call(check_valleys)
    walk.next()
    walk.say("Terrain")
    walk.select(0, 1, 0, 0, 0)
    walk.save("valleys.tif")


def check():
    assert drawn("valleys.png") > 0.2
    found = gdal.Open("valleys.tif")
    assert found.GetGeoTransform() == PLACE, found.GetGeoTransform()
    assert found.GetSpatialRef().GetAuthorityCode(None) == str(SYSTEM)
    assert (found.RasterXSize, found.RasterYSize) == (91, 81)
