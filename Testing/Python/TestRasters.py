# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Rasters of heights against GDAL's own Python package: places, units, holes, projections, damaged files."""

import os
import re
import unittest

import numpy as np
from osgeo import gdal, osr

import littoral
from littoral import errors
from littoral.elevation import array_from_image, metres_per_degree, read_elevation
from TestFiles import InFolder

gdal.UseExceptions()
RANDOM = np.random.default_rng(19)
#: A raster in UTM zone 16 north: corner, spacings.
UTM16 = (725000.0, 30.0, 0.0, 4040000.0, 0.0, -25.0)


def hills(rows, columns):
    """Smooth heights [m], float32, different in every pixel."""
    y, x = np.mgrid[0:rows, 0:columns].astype(float)
    return (300.0 + 40.0 * np.sin(x / 5.0) * np.cos(y / 7.0) + 0.01 * x + 0.5 * y).astype(np.float32)


def system(code):
    """A coordinate system of EPSG with x to the east first."""
    made = osr.SpatialReference()
    made.ImportFromEPSG(code)
    made.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
    return made


def create(name, heights, place=UTM16, code=32616, driver="GTiff", kind=gdal.GDT_Float32, change=None, options=()):
    """Write bands of heights by GDAL; change: called with the dataset."""
    bands = heights if heights.ndim == 3 else heights[None]
    raster = gdal.GetDriverByName(driver).Create(
        name, bands.shape[2], bands.shape[1], len(bands), kind, options=list(options))
    if place is not None:
        raster.SetGeoTransform(place)
    if code:
        raster.SetSpatialRef(system(code) if isinstance(code, int) else code)
    for number, band in enumerate(bands, 1):
        raster.GetRasterBand(number).WriteArray(band)
    if change:
        change(raster)
    raster = None
    return name


def model(name, x, y, units, names=("x", "y"), heights=None):
    """A netCDF file as models write it: heights over coordinate variables with units, and no more."""
    file = gdal.GetDriverByName("netCDF").CreateMultiDimensional(name)
    root, double = file.GetRootGroup(), gdal.ExtendedDataType.Create(gdal.GDT_Float64)
    sizes = []
    for axis, values in ((1, y), (0, x)):
        sizes.append(root.CreateDimension(names[axis], None, None, len(values)))
        variable = root.CreateMDArray(names[axis], sizes[-1:], double)
        variable.Write(np.asarray(values, float))
        if units:
            variable.SetUnit(units[axis])
    made = root.CreateMDArray("z", sizes, double)
    made.Write(hills(len(y), len(x)).astype(float) if heights is None else heights)
    made = variable = sizes = root = file = None
    return name


def write_grib(name, values, south_west, step, parameter):
    """A message of GRIB 1: rows from the south, degrees, parameters of the standard table, packed in 16 bits."""
    def three(number):
        return (abs(number) | (number < 0) << 23).to_bytes(3, "big")

    def real(number):  # of IBM: sign, exponent of 16, 24 bits
        exponent = int(np.floor(np.log(abs(number)) / np.log(16.0))) + 1
        return bytes([(number < 0) << 7 | exponent + 64]) + round(abs(number) / 16.0**exponent * 2**24).to_bytes(3, "big")

    rows, columns = values.shape
    scale = max(-30, int(np.ceil(np.log2(np.ptp(values) / 65000.0))))
    packed = np.round((values - values.min()) / 2.0**scale).astype(">u2").tobytes()
    product = three(28) + bytes([2, 7, 96, 255, 128, parameter, 1, 0, 0, 24, 1, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 21, 0, 0, 0])
    south, west, dense = (round(1000 * number) for number in (*south_west, step))
    grid = (three(32) + bytes([0, 255, 0]) + columns.to_bytes(2, "big") + rows.to_bytes(2, "big") + three(south) + three(west)
            + bytes([128]) + three(south + (rows - 1) * dense) + three(west + (columns - 1) * dense)
            + 2 * dense.to_bytes(2, "big") + bytes([64, 0, 0, 0, 0]))
    data = bytes([8]) + (scale & 0x7FFF | (scale < 0) << 15).to_bytes(2, "big") + real(values.min()) + b"\x10" + packed + b"\0"
    body = product + grid + three(3 + len(data)) + data + b"7777"
    with open(name, "wb") as file:
        file.write(b"GRIB" + three(8 + len(body)) + b"\1" + body)
    return name


def field(image, name):
    """The values of a field array."""
    array = image.GetFieldData().GetAbstractArray(name)
    return None if array is None else [array.GetVariantValue(k) for k in range(array.GetNumberOfValues())]


def numbers(image, name):
    return [value.ToDouble() for value in field(image, name)]


def text(image, name):
    return field(image, name)[0].ToString()


class Rasters(InFolder):
    """Rasters in files."""

    def refuses(self, pattern, name, **settings):
        """One error, which names the file and then says why; the next good file is read as by a fresh object."""
        reader = littoral.vtkElevationReader()
        messages = errors.kept(reader)
        reader.SetFileName(name)
        for key, value in settings.items():
            getattr(reader, "Set" + key)(value)
        reader.Update()
        self.assertEqual(len(messages), 1, messages)
        self.assertRegex(messages[0], pattern)
        self.assertRegex(messages[0], f"^(Cannot|.*: cannot) read {re.escape(os.path.basename(name))}[:,] ")
        self.assertNotIn(self.folder, messages[0])
        self.assertNotIn("\n", messages[0])
        self.assertTrue(messages[0].endswith("."), messages[0])
        self.assertEqual(reader.GetOutput().GetNumberOfPoints(), 0)
        good = create(self.path("good.tif"), hills(4, 5))
        fresh = littoral.vtkElevationReader()
        for made in (reader, fresh):
            made.SetFileName(good)
        for key in settings:
            getattr(reader, "Set" + key)(getattr(fresh, "Get" + key)())
        reader.Update()
        self.assertEqual(len(messages), 1, messages)
        self.assertTrue(np.array_equal(array_from_image(reader.GetOutput()), hills(4, 5)[::-1]))


class Places(Rasters):
    """Points are centers of pixels, in metres, wherever the file says they are."""

    def check_place(self, name, heights, image=None, code=32616, tolerance=0.0):
        """Each point of the image against GDAL's transform of its pixel, and its height."""
        image = image or read_elevation(name)
        raster = gdal.Open(name)
        transform = raster.GetGeoTransform()
        rows, columns = heights.shape
        found = array_from_image(image)
        unit = system(code).GetLinearUnits() if code else 1.0
        for row, column in ((0, 0), (rows - 1, 0), (rows // 2, columns - 1)):
            x, y = gdal.ApplyGeoTransform(transform, column + 0.5, row + 0.5)
            i = round((x * unit - image.GetOrigin()[0]) / image.GetSpacing()[0])
            j = round((y * unit - image.GetOrigin()[1]) / image.GetSpacing()[1])
            point = image.GetPoint(image.ComputePointId((i, j, 0)))
            self.assertAlmostEqual(point[0], x * unit, delta=1e-6)
            self.assertAlmostEqual(point[1], y * unit, delta=1e-6)
            self.assertAlmostEqual(float(found[j, i]), float(heights[row, column]), delta=tolerance)
        return image

    def test_formats(self):
        heights = hills(11, 7)
        tif = create(self.path("a.tif"), heights)
        south = create(self.path("south.tif"), heights, (725000.0, 30.0, 0.0, 4040000.0, 0.0, 25.0))
        netcdf = gdal.Translate(self.path("a.nc"), tif, format="netCDF").GetDescription()
        asc = gdal.Translate(self.path("a.asc"), create(self.path("square.tif"), heights, (725000.0, 30.0, 0.0,
                             4040000.0, 0.0, -30.0)), format="AAIGrid", creationOptions=["DECIMAL_PRECISION=6"])
        asc = asc.GetDescription()
        for name, tolerance in ((tif, 0.0), (south, 0.0), (netcdf, 0.0), (asc, 1e-4)):
            with self.subTest(name=os.path.basename(name)):
                image = self.check_place(name, heights, tolerance=tolerance)
                self.assertEqual(image.GetDimensions(), (7, 11, 1))
                found = osr.SpatialReference(text(image, "CoordinateSystem"))
                self.assertTrue(found.IsSame(system(32616)), name)
                self.assertEqual(numbers(image, "CoordinateUnit"), [1.0])
                self.assertEqual(numbers(image, "CoordinateOffset"), [0.0, 0.0])

    def test_without_a_place_the_first_row_is_the_northernmost(self):
        heights = hills(3, 4)
        image = read_elevation(create(self.path("a.tif"), heights, place=None, code=0))
        self.assertTrue(np.array_equal(array_from_image(image), heights[::-1]))
        self.assertEqual((image.GetOrigin()[:2], image.GetSpacing()[:2]), ((0.5, 0.5), (1.0, 1.0)))
        self.assertIsNone(field(image, "CoordinateSystem"))

    def test_one_row_and_one_pixel(self):
        for shape in ((1, 6), (6, 1), (1, 1)):
            heights = hills(*shape)
            name = create(self.path("line.tif"), heights)
            self.check_place(name, heights)
            os.remove(name)
        fit = littoral.vtkCovarianceFitFilter()
        messages = errors.kept(fit)
        fit.SetInputData(read_elevation(create(self.path("row.tif"), hills(1, 60))))
        fit.Update()
        self.assertEqual(len(messages), 1, messages)

    def test_local_origin(self):
        name = create(self.path("a.tif"), hills(5, 6))
        there, here = read_elevation(name), read_elevation(name, LocalOrigin=True)
        self.assertEqual(here.GetOrigin()[:2], (0.0, 0.0))
        self.assertEqual(tuple(numbers(here, "CoordinateOffset")), there.GetOrigin()[:2])
        self.assertTrue(np.array_equal(array_from_image(here), array_from_image(there)))

    def test_feet_become_metres(self):
        heights = hills(6, 5)
        name = create(self.path("feet.tif"), heights, (1500000.0, 100.0, 0.0, 700000.0, 0.0, -100.0), 2274,
                      change=lambda raster: raster.GetRasterBand(1).SetUnitType("ft"))
        foot = 1200.0 / 3937.0  # of the survey, in the plane
        image = self.check_place(name, heights * np.float32(0.3048), code=2274, tolerance=1e-4)
        self.assertAlmostEqual(image.GetSpacing()[0], 100.0 * foot, delta=1e-12 * 100)
        self.assertAlmostEqual(numbers(image, "CoordinateUnit")[0], foot, delta=1e-12)
        metres = array_from_image(read_elevation(name, HeightUnit=littoral.vtkElevationReader.Metres))
        self.assertTrue(np.array_equal(metres, heights[::-1]))
        survey = array_from_image(read_elevation(name, HeightUnit=littoral.vtkElevationReader.USSurveyFeet))
        self.assertTrue(np.allclose(survey, heights[::-1] * foot, rtol=1e-6))

    def test_heights_in_the_unit_of_a_vertical_system(self):
        compound = osr.SpatialReference()
        compound.SetFromUserInput("EPSG:32616+6360")  # NAVD88 height in US survey feet
        image = read_elevation(create(self.path("a.tif"), hills(4, 4), code=compound))
        self.assertTrue(np.allclose(array_from_image(image), hills(4, 4)[::-1] * 1200.0 / 3937.0, rtol=1e-6))
        self.assertTrue(osr.SpatialReference(text(image, "CoordinateSystem")).IsSame(system(32616)))

    def test_scaled_values(self):
        def scale(raster):
            raster.GetRasterBand(1).SetScale(0.1)
            raster.GetRasterBand(1).SetOffset(-50.0)
        stored = (hills(4, 5) * 10).astype(np.int16)
        name = create(self.path("scaled.tif"), stored, kind=gdal.GDT_Int16, change=scale)
        self.assertTrue(np.allclose(array_from_image(read_elevation(name)), stored[::-1] * 0.1 - 50.0, atol=1e-4))

    def test_bands(self):
        heights = np.stack([hills(4, 5), hills(4, 5) + 7.0, hills(4, 5) + 9.0])
        name = create(self.path("bands.tif"), heights)
        for band in (1, 2, 3):
            self.assertTrue(np.array_equal(array_from_image(read_elevation(name, Band=band)), heights[band - 1][::-1]))
        self.refuses("Band is 4; it must be from 1 to 3", name, Band=4)
        self.refuses("Band is 0", name, Band=0)

    def test_datasets(self):
        # Two variables in one file, as many models of the sea floor have.
        from osgeo import gdal_array  # noqa: F401
        driver = gdal.GetDriverByName("netCDF")
        file = driver.CreateMultiDimensional(self.path("two.nc"))
        root = file.GetRootGroup()
        y, x = root.CreateDimension("y", None, None, 4), root.CreateDimension("x", None, None, 5)
        for name, along, size in (("x", x, 5), ("y", y, 4)):
            axis = root.CreateMDArray(name, [along], gdal.ExtendedDataType.Create(gdal.GDT_Float64))
            axis.Write(1000.0 + 30.0 * np.arange(size))
            unit = axis.CreateAttribute("units", [], gdal.ExtendedDataType.CreateString())
            unit.WriteString("m")
            kind = axis.CreateAttribute("standard_name", [], gdal.ExtendedDataType.CreateString())
            kind.WriteString(f"projection_{name}_coordinate")
            unit = kind = axis = None
        for name, shift in (("bottom", 0.0), ("top", 50.0)):
            array = root.CreateMDArray(name, [y, x], gdal.ExtendedDataType.Create(gdal.GDT_Float32))
            array.Write(hills(4, 5) + np.float32(shift))
            array = None
        root = x = y = file = None
        first = array_from_image(read_elevation(self.path("two.nc")))
        top = read_elevation(self.path("two.nc"), Dataset="top")
        self.assertTrue(np.array_equal(array_from_image(top), hills(4, 5) + np.float32(50.0)))
        self.assertTrue(np.array_equal(first, hills(4, 5)))
        self.assertEqual(top.GetOrigin()[:2], (1000.0, 1000.0))
        self.refuses("no dataset 'middle'; it has bottom, top", self.path("two.nc"), Dataset="middle")

    def test_parts_are_those_of_the_whole(self):
        name = create(self.path("a.tif"), hills(90, 70))
        reader = littoral.vtkElevationReader()
        reader.SetFileName(name)
        reader.UpdateExtent((10, 33, 5, 80, 0, 0))
        part = array_from_image(reader.GetOutput())
        self.assertTrue(np.array_equal(part, hills(90, 70)[::-1][5:81, 10:34]))


class Holes(Rasters):
    """Heights that are missing are NaN, hidden, and counted."""

    def test_no_data_values(self):
        heights = hills(5, 6)
        heights[1, 2] = heights[4, 0] = -32768.0
        name = create(self.path("a.tif"), heights,
                      change=lambda raster: raster.GetRasterBand(1).SetNoDataValue(-32768.0))
        image = read_elevation(name)
        found = array_from_image(image)
        self.assertTrue(np.array_equal(np.isnan(found), heights[::-1] == -32768.0))
        ghosts = array_from_image(image, "vtkGhostType")
        self.assertTrue(np.array_equal(ghosts == 2, np.isnan(found)))
        self.assertIn("; 2 missing; WGS 84 / UTM zone 16N (EPSG:32616);", text(image, "ElevationSummary"))
        low, high = image.GetPointData().GetArray("Elevation").GetFiniteRange()
        self.assertAlmostEqual(low, heights[heights > 0].min(), delta=1e-3)

    def test_values_that_the_file_does_not_name(self):
        heights = hills(5, 6)
        heights[2, 2] = -9999.0
        name = create(self.path("a.tif"), heights)
        self.assertEqual(np.isnan(array_from_image(read_elevation(name))).sum(), 0)
        self.assertIsNone(read_elevation(name).GetPointData().GetArray("vtkGhostType"))
        self.assertEqual(np.isnan(array_from_image(read_elevation(name, UseNoDataValue=True))).sum(), 1)
        projected = array_from_image(read_elevation(name, "EPSG:32617", UseNoDataValue=True))
        self.assertGreater(np.nanmin(projected), 200.0)

    def test_nan_infinity_and_masks(self):
        heights = hills(5, 6)
        heights[0, 0], heights[0, 1], heights[0, 2] = np.nan, np.inf, -np.inf
        found = array_from_image(read_elevation(create(self.path("a.tif"), heights)))
        self.assertTrue(np.array_equal(np.isnan(found), ~np.isfinite(heights[::-1])))

        def mask(raster):
            raster.CreateMaskBand(gdal.GMF_PER_DATASET)
            raster.GetRasterBand(1).GetMaskBand().WriteArray(np.eye(5, 6, dtype=np.uint8) * 255)
        masked = create(self.path("masked.tif"), hills(5, 6), change=mask)
        found = array_from_image(read_elevation(masked))
        self.assertTrue(np.array_equal(np.isfinite(found), np.eye(5, 6, dtype=bool)[::-1]))

    def test_numbers_beyond_all_heights(self):
        """1e300 is a hole, not infinity; so is what single precision cannot hold."""
        heights = hills(8, 8).astype(float)
        heights[2, 2], heights[5, 1], heights[6, 6] = 1e300, -3.4028234663852886e38, 2e15
        name = create(self.path("large.tif"), heights, kind=gdal.GDT_Float64)
        read = array_from_image(read_elevation(name))[::-1]
        self.assertEqual(np.argwhere(np.isnan(read)).tolist(), [[2, 2], [5, 1], [6, 6]])
        self.assertFalse(np.isinf(read).any())

    def test_unit_of_no_name(self):
        def set_unit(raster):
            raster.GetRasterBand(1).SetUnitType("unspecified")
        image = read_elevation(create(self.path("idrisi.tif"), hills(8, 8), change=set_unit))
        self.assertIn("no unit of heights named", text(image, "ElevationSummary"))

    def test_nothing_but_holes(self):
        self.refuses("all of its 20 heights are missing", create(self.path("a.tif"), np.full((4, 5), np.nan)))


class Degrees(Rasters):
    """Coordinates that are no lengths are refused, or projected."""

    def tile(self, name="N36W085.hgt", size=1201):
        """A tile of the Shuttle mission: big-endian heights from north to south, a degree wide."""
        y, x = np.mgrid[0:size, 0:size] / (size - 1.0)
        heights = (500.0 + 200.0 * np.sin(9.0 * x) * np.cos(7.0 * y) + 100.0 * x).astype(np.int16)
        heights[100:103, 50] = -32768
        heights.astype(">i2").tofile(self.path(name))
        return self.path(name), heights

    def test_are_refused_with_what_to_do(self):
        tile, _ = self.tile()
        self.refuses("Set Projection to UTM.*its coordinates are degrees, not lengths", tile)
        with self.assertRaisesRegex(ValueError, "N36W085.hgt, its coordinates are degrees"):
            read_elevation(tile)

    def test_tile_in_its_zone(self):
        tile, stored = self.tile()
        image = read_elevation(tile, "UTM")
        heights = array_from_image(image)
        self.assertTrue(osr.SpatialReference(text(image, "CoordinateSystem")).IsSame(system(32616)))
        # Where PROJ puts a few pixels, there they are.
        way = osr.CoordinateTransformation(system(4326), system(32616))
        for row, column in ((300, 300), (600, 601), (900, 120), (77, 1100)):
            x, y, _ = way.TransformPoint(-85.0 + column / 1200.0, 37.0 - row / 1200.0)
            i = (x - image.GetOrigin()[0]) / image.GetSpacing()[0]
            j = (y - image.GetOrigin()[1]) / image.GetSpacing()[1]
            around = heights[int(j):int(j) + 2, int(i):int(i) + 2]
            s, t = i % 1.0, j % 1.0
            there = (1 - t) * ((1 - s) * around[0, 0] + s * around[0, 1]) + t * ((1 - s) * around[1, 0] + s * around[1, 1])
            self.assertAlmostEqual(there, stored[row, column], delta=1.5)  # of heights in whole metres
        # The area is that on the ellipsoid, as far as UTM keeps lengths (0.1 %).
        east, north = metres_per_degree(36.5)
        inside = np.isfinite(heights)
        area = inside.sum() * image.GetSpacing()[0] * image.GetSpacing()[1]
        self.assertAlmostEqual(area / (east * north), 1.0, delta=0.003)

    def test_truth_of_gdalwarp(self):
        """The same as that program, block by block; as a whole it takes other blocks, and kernels of other widths."""
        tile, _ = self.tile()
        settings = {"dstSRS": "EPSG:32616", "resampleAlg": "cubic", "errorThreshold": 0.0,
                    "outputType": gdal.GDT_Float32, "dstNodata": float("nan")}
        wanted = gdal.Warp("", tile, format="VRT", **settings)
        image = read_elevation(tile, "UTM")
        found = array_from_image(image)[::-1]
        block = wanted.GetRasterBand(1).GetBlockSize()[1]  # more rows are no longer read by blocks from GDAL 3.10 on
        truth = np.vstack([wanted.ReadAsArray(0, row, wanted.RasterXSize, min(block, wanted.RasterYSize - row))
                           for row in range(0, wanted.RasterYSize, block)])
        self.assertEqual(found.shape, truth.shape)
        transform = wanted.GetGeoTransform()
        self.assertAlmostEqual(image.GetOrigin()[0], transform[0] + 0.5 * transform[1], delta=1e-6)
        both = np.isfinite(found) & np.isfinite(truth)
        self.assertGreater(both.mean(), 0.9)
        self.assertTrue(np.array_equal(found[both], truth[both]))
        whole = gdal.Warp("", tile, format="MEM", **settings).ReadAsArray()
        self.assertLess(np.nanpercentile(np.abs(found - whole), 99.0), 0.05)  # [m], of steps of 1 m
        reader = littoral.vtkElevationReader()
        reader.SetFileName(tile)
        reader.SetProjectionToUTM()
        reader.UpdateExtent((300, 500, 700, 900, 0, 0))
        self.assertTrue(np.array_equal(array_from_image(reader.GetOutput()), found[::-1][700:901, 300:501]))

    def test_parts_of_a_strip(self):
        """Few rows, which GDAL 3.10 projects at once if they are asked for as a whole."""
        name = create(self.path("a.tif"), hills(50, 1900) + RANDOM.normal(size=(50, 1900)).astype(np.float32),
                      (-87.8, 1.0 / 1200.0, 0.0, 37.0, 0.0, -1.0 / 1200.0), 4326)
        whole = read_elevation(name, "UTM", ProjectedSpacing=90.0)
        self.assertEqual(whole.GetDimensions(), (1566, 54, 1))
        reader = littoral.vtkElevationReader()
        reader.SetFileName(name)
        reader.SetProjectionToUTM()
        reader.SetProjectedSpacing(90.0)
        reader.UpdateExtent((300, 700, 0, 10, 0, 0))
        part = array_from_image(reader.GetOutput())
        self.assertTrue(np.array_equal(part, array_from_image(whole)[:11, 300:701], equal_nan=True))

    def test_spacing_on_request(self):
        tile, _ = self.tile()
        image = read_elevation(tile, "UTM", ProjectedSpacing=250.0)
        self.assertEqual(image.GetSpacing()[:2], (250.0, 250.0))

    def test_southern_zone_and_other_datum(self):
        north = create(self.path("a.tif"), hills(40, 40), (-84.5, 0.001, 0.0, 36.5, 0.0, -0.001), 4269)
        self.assertTrue(osr.SpatialReference(text(read_elevation(north, "UTM"), "CoordinateSystem"))
                        .IsSame(system(26916)))  # NAD 83 stays
        south = create(self.path("b.tif"), hills(40, 40), (150.0, 0.001, 0.0, -33.5, 0.0, -0.001), 4326)
        self.assertTrue(osr.SpatialReference(text(read_elevation(south, "UTM"), "CoordinateSystem"))
                        .IsSame(system(32756)))

    def test_too_wide_for_a_zone(self):
        """The scale of a zone is 1 + (width cos(latitude))^2 / 2 at its edges, 5 % at 18 degrees from its meridian."""
        def wide(width):
            return create(self.path(f"{width}.tif"), hills(40, 40), (9 - width / 2, width / 40, 0, 1, 0, -0.05), 4326)
        self.refuses("so wide.*cut it, or set Projection to Given System", wide(44), Projection=1)
        self.refuses("so wide", create(self.path("world.tif"), hills(60, 120), (-180, 3, 0, 90, 0, -3), 4326), Projection=1)
        self.assertTrue(np.isfinite(array_from_image(read_elevation(wide(32), "UTM"))).any())

    def test_weather_models(self):
        """GRIB 1 on the sphere of its model: heights by their units, lengths those on the sphere."""
        rows, columns = 40, 60
        heights = np.add.outer(100.0 * np.sin(np.arange(rows) / 6.0), 200.0 + 3.0 * np.arange(columns))  # from the south
        def read(name, parameter, values):
            write_grib(self.path(name), values, (46.0, 7.0), 0.01, parameter)
            return read_elevation(self.path(name), "UTM", Resampling=0)
        image = read("height.grb", 8, heights)
        inside = np.isfinite(array_from_image(image))
        area = inside.sum() * image.GetSpacing()[0] * image.GetSpacing()[1]
        radius = osr.SpatialReference(text(image, "CoordinateSystem")).GetSemiMajor()
        self.assertAlmostEqual(radius, 6.37e6, delta=5e3)
        side = radius * np.radians(0.01)
        self.assertAlmostEqual(area / (rows * columns * side * side * np.cos(np.radians(46.195))), 1.0, delta=0.003)
        for name, parameter, values in (("potential.grb", 6, 9.80665 * heights), ("gpm.grb", 7, heights)):
            there = array_from_image(read(name, parameter, values))
            self.assertLess(np.nanmax(np.abs(there - array_from_image(image))), 0.02)  # packed in 16 bits
        self.refuses("in 'C', which is no unit of heights", self.path(write_grib(
            self.path("temperature.grb"), 0.01 * heights + 270.0, (46.0, 7.0), 0.01, 11)))

    def test_degrees_without_a_name(self):
        name = self.path("a.asc")
        with open(name, "w", encoding="utf-8") as file:
            file.write("ncols 9\nnrows 9\nxllcorner -84.5\nyllcorner 36.1\ncellsize 0.001\n" + "1 2 3 4 5 6 7 8 9\n" * 9)
        self.refuses("Set FileCoordinateSystem to EPSG:4326 and Projection to UTM.*look like degrees", name)
        image = read_elevation(name, "UTM", FileCoordinateSystem="EPSG:4326")
        self.assertTrue(osr.SpatialReference(text(image, "CoordinateSystem")).IsSame(system(32616)))
        self.refuses("names no coordinate system to project from", name, Projection=1)

    def test_coordinates_of_models(self):
        """What coordinate variables say is believed: lengths in their unit, degrees as of WGS 84."""
        x, y = 500.0 + 0.5 * np.arange(30), 4000.0 + 0.25 * np.arange(20)
        for count, (factor, units) in enumerate(((1000.0, ("km", "km")), (1.0, ("m", "m")), (1.0, None),
                                                 (0.3048, ("feet", "feet")))):
            for way in (1, -1):
                image = read_elevation(model(self.path(f"{count}{way}.nc"), x, y[::way], units,
                                             heights=np.add.outer(y[::way], x)))
                np.testing.assert_allclose(image.GetOrigin()[:2], (500.0 * factor, 4000.0 * factor), rtol=1e-12)
                np.testing.assert_allclose(image.GetSpacing()[:2], (0.5 * factor, 0.25 * factor), rtol=1e-9)
                np.testing.assert_allclose(array_from_image(image), np.add.outer(y, x), rtol=1e-6)
        # Another way to the map: coordinates in km of a system in metres.
        name = model(self.path("map.nc"), x, y, ("km", "km"))
        self.assertEqual(read_elevation(name, FileCoordinateSystem="EPSG:32632").GetOrigin()[:2], (500e3, 4000e3))
        self.refuses("in 'parsec', which is no unit of lengths or angles",
                     model(self.path("far.nc"), x, y, ("parsec", "parsec")))
        self.refuses("not the same distance apart", model(self.path("uneven.nc"), x**2, y, ("m", "m")))

        degrees = ("degrees_east", "degrees_north")
        coarse = model(self.path("coarse.nc"), 5.0 + 0.5 * np.arange(6), 40.0 + 0.5 * np.arange(6), degrees, ("lon", "lat"))
        past = model(self.path("past.nc"), 365.0 + 0.5 * np.arange(6), 40.0 + 0.5 * np.arange(6), degrees, ("lon", "lat"))
        for name in (coarse, past):
            self.refuses("Set Projection to UTM.*its coordinates are degrees, not lengths", name)
        image, other = (read_elevation(name, "UTM") for name in (coarse, past))
        self.assertIn("UTM zone 32N", text(image, "CoordinateSystem"))
        np.testing.assert_allclose(image.GetBounds(), other.GetBounds(), rtol=1e-9)
        east, north = metres_per_degree(41.25)
        self.assertAlmostEqual(image.GetBounds()[1] - image.GetBounds()[0], 2.5 * east, delta=0.2 * east)
        self.assertAlmostEqual(image.GetBounds()[3] - image.GetBounds()[2], 2.5 * north, delta=0.2 * north)
        turned = model(self.path("turned.nc"), np.arange(9.0), np.arange(9.0), ("degrees", "degrees"), ("rlon", "rlat"))
        self.refuses("degrees about a turned pole", turned)
        self.refuses("degrees about a turned pole", turned, Projection=1)

    def test_cells_of_a_degree(self):
        heights = hills(9, 9)
        for west, south, step in ((5.0, 41.0, 1.0), (-180.0, 41.0, 1.0), (5.0, 41.0, 0.25), (355.0, -60.0, 2.0)):
            name = self.path("cells.asc")
            with open(name, "w", encoding="ascii") as file:
                file.write(f"ncols 9\nnrows 9\nxllcorner {west}\nyllcorner {south}\ncellsize {step}\n")
                np.savetxt(file, heights)
            self.refuses("Set FileCoordinateSystem to EPSG:4326 .* or FileCoordinateSystem to metres.*like degrees", name)
            image = read_elevation(name, FileCoordinateSystem="metres")
            self.assertEqual((image.GetSpacing()[0], image.GetOrigin()[0]), (step, west + 0.5 * step))
        with open(name, "w", encoding="ascii") as file:  # a plot of metres
            file.write("ncols 9\nnrows 9\nxllcorner 0\nyllcorner 0\ncellsize 1\n")
            np.savetxt(file, heights)
        self.assertEqual(read_elevation(name).GetSpacing()[0], 1.0)

    def test_maps_that_stretch(self):
        web = create(self.path("web.tif"), hills(40, 40), (-9400000.0, 30.0, 0.0, 4360000.0, 0.0, -30.0), 3857)
        # At 36.4 degrees of latitude lengths are 1/cos(latitude) times too long.
        self.refuses(r"Set Projection to UTM.*EPSG:3857\) are 1\.24 times those on the ground", web)
        image = read_elevation(web, "UTM")
        self.assertAlmostEqual(image.GetSpacing()[0] / 30.0, np.cos(np.radians(36.4)), delta=0.01)
        self.refuses("Choose another CoordinateSystem", web, Projection=2, CoordinateSystem="EPSG:3857")

    def test_no_zone_at_the_poles(self):
        name = create(self.path("pole.tif"), hills(40, 40), (10.0, 0.01, 0.0, 87.0, 0.0, -0.01), 4326)
        self.refuses("no zone of UTM", name, Projection=1)
        self.assertTrue(np.isfinite(array_from_image(read_elevation(name, "EPSG:3413"))).any())

    def test_systems_that_are_none(self):
        name = create(self.path("a.tif"), hills(9, 9))
        self.refuses("CoordinateSystem is 'nowhere', which is no", name, Projection=2, CoordinateSystem="nowhere")
        self.refuses("CoordinateSystem is '', which is no", name, Projection=2)
        self.refuses("CoordinateSystem is WGS 84 .*, which is no projection", name, Projection=2,
                     CoordinateSystem="EPSG:4326")
        self.refuses("FileCoordinateSystem is 'nowhere', which is no", name, FileCoordinateSystem="nowhere")

    def test_turned_rasters(self):
        """A plane on a turned grid is that plane on the upright one."""
        turn, step = np.radians(30.0), 20.0
        place = (725000.0, step * np.cos(turn), step * np.sin(turn), 4040000.0, step * np.sin(turn),
                 -step * np.cos(turn))
        j, i = np.mgrid[0:60, 0:80] + 0.5
        x = place[0] + place[1] * i + place[2] * j
        y = place[3] + place[4] * i + place[5] * j
        plane = 0.02 * (x - 725000.0) - 0.05 * (y - 4040000.0)
        image = read_elevation(create(self.path("turned.tif"), plane.astype(np.float32), place))
        found = array_from_image(image)
        rows, columns = np.nonzero(np.isfinite(found))
        self.assertGreater(len(rows), 0.8 * plane.size)
        x = image.GetOrigin()[0] + image.GetSpacing()[0] * columns
        y = image.GetOrigin()[1] + image.GetSpacing()[1] * rows
        wrong = np.abs(found[rows, columns] - (0.02 * (x - 725000.0) - 0.05 * (y - 4040000.0)))
        self.assertLess(np.percentile(wrong, 90), 0.01)
        self.assertLess(wrong.max(), 1.0)  # at the border, where half of the neighbours are missing


class BadFiles(Rasters):
    """One sentence, and no crash."""

    def test_files_that_are_none(self):
        missing = self.path("missing.tif")
        self.refuses("there is no such file", missing)
        with self.assertRaises(FileNotFoundError):
            read_elevation(missing)
        for name in ("text.tif", "text.asc", "N36W085.hgt", "text.nc"):
            with open(self.path(name), "w", encoding="utf-8") as file:
                file.write("no raster at all")
            self.refuses("GDAL finds no whole raster in it", self.path(name))
        self.refuses("SRTM tile is called by its southwestern corner", self.path("N36W085.hgt"))
        reader = littoral.vtkElevationReader()
        messages = errors.kept(reader)
        reader.Update()
        self.assertEqual(messages, ["Cannot read a raster: FileName is empty."])

    def test_cut_files(self):
        heights = RANDOM.normal(size=(150, 150)).astype(np.float32)
        names = [create(self.path("a.tif"), heights), create(self.path("b.tif"), heights, options=["COMPRESS=DEFLATE"]),
                 create(self.path("c.tif"), heights, options=["TILED=YES"])]
        names.append(gdal.Translate(self.path("d.nc"), names[0], format="netCDF").GetDescription())
        names.append(gdal.Translate(self.path("e.asc"), names[0], format="AAIGrid",
                                    creationOptions=["FORCE_CELLSIZE=YES"]).GetDescription())
        for name in names:
            with open(name, "rb") as file:
                whole = file.read()
            for share in (0.3, 0.6, 0.9):
                cut = self.path("cut" + os.path.splitext(name)[1])
                with open(cut, "wb") as file:
                    file.write(whole[:int(share * len(whole))])
                with self.subTest(name=os.path.basename(name), share=share):
                    self.refuses("cut off or damaged|no whole raster", cut)

    def test_tiles_of_a_mosaic(self):
        """A tile that is gone or of another size is told, where it is asked for; the others are read."""
        heights = RANDOM.uniform(100.0, 200.0, size=(30, 60)).astype(np.float32)

        def tile(number, rows, columns):
            values = np.resize(heights[:, 20 * number:20 * number + 20], (rows, columns))
            return create(self.path(f"tile{number}.tif"), values, (5e5 + 200.0 * number, 10.0, 0.0, 4e6, 0.0, -10.0))

        mosaic = self.path("mosaic.vrt")
        gdal.BuildVRT(mosaic, [tile(number, 30, 20) for number in range(3)]).FlushCache()
        np.testing.assert_array_equal(array_from_image(read_elevation(mosaic)), heights[::-1])
        for rows, columns in (30, 7), (29, 20), (60, 40):
            tile(1, rows, columns)
            self.refuses(f"mosaic anew: its tile tile1.tif has {columns} x {rows} pixels and not 20 x 30", mosaic)
        reader = littoral.vtkElevationReader()
        reader.SetFileName(mosaic)
        for extent, is_read in ((0, 19, 0, 29, 0, 0), True), ((10, 20, 0, 0, 0, 0), False), ((40, 59, 3, 4, 0, 0), True):
            with self.subTest(extent=extent):
                messages = errors.kept(reader)
                reader.UpdateExtent(extent)
                self.assertEqual(messages == [], is_read, messages)
        os.remove(self.path("tile1.tif"))
        self.refuses("tile1.tif: No such file", mosaic)

    def test_mosaics_of_mosaics(self):
        """Tiles of a mosaic in a mosaic are looked at, too, in the part that is shown, and beside the file of a link."""
        names = [create(self.path(f"{number}.tif"), np.full((30, 20), 5.0 + number),
                        (5e5 + 200.0 * number, 10.0, 0.0, 4e6, 0.0, -10.0)) for number in range(2)]
        inner, outer, part, link = (self.path(name) for name in ("inner.vrt", "outer.vrt", "part.vrt", "link/link.vrt"))
        gdal.BuildVRT(inner, names).FlushCache()
        gdal.BuildVRT(outer, [inner]).FlushCache()
        gdal.Translate(part, inner, format="VRT", srcWin=[0, 0, 20, 30]).FlushCache()
        os.mkdir(self.path("link"))
        os.symlink(os.path.join("..", "inner.vrt"), link)
        create(names[1], np.full((15, 20), 6.0), (5e5 + 200.0, 10.0, 0.0, 4e6, 0.0, -10.0))
        for name in inner, outer, link:
            self.refuses("mosaic anew: its tile 1.tif has 20 x 15 pixels and not 20 x 30", name)
        np.testing.assert_array_equal(array_from_image(read_elevation(part)), np.full((30, 20), 5.0))
        with open(inner) as file:
            text = file.read()
        with open(self.path("itself.vrt"), "w") as file:
            file.write(re.sub("[01][.]tif", "itself.vrt", text).replace('XSize="20"', 'XSize="40"'))
        self.refuses("cut off or damaged", file.name)

    def test_tiles_of_overviews(self):
        """A mosaic of an overview has the overview's size, not the file's."""
        name = create(self.path("whole.tif"), np.arange(200.0).reshape(10, 20))
        raster = gdal.Open(name)
        raster.BuildOverviews("NEAREST", [2])
        raster = gdal.OpenEx(name, gdal.OF_RASTER, open_options=["OVERVIEW_LEVEL=0"])
        wanted = raster.ReadAsArray()
        mosaic = self.path("overview.vrt")
        gdal.Translate(mosaic, raster, format="VRT").FlushCache()
        with open(mosaic) as file:
            self.assertIn("OVERVIEW_LEVEL", file.read())
        np.testing.assert_array_equal(array_from_image(read_elevation(mosaic)), wanted[::-1])

    def test_sizes_beyond_memory(self):
        """Small files that claim much, and spacings that make much of little, are refused before memory is taken."""
        claims = self.path("claims.asc")
        with open(claims, "w", encoding="ascii") as file:
            file.write("ncols 100000\nnrows 100000\nxllcorner 0\nyllcorner 0\ncellsize 30\n" + "1 2 3\n" * 100)
        self.refuses("100000 x 100000 heights needs 46.6 GiB of memory|Too large raster dimension", claims)  # GDAL 3.12 itself
        sparse = self.path("sparse.tif")
        raster = gdal.GetDriverByName("GTiff").Create(
            sparse, 200000, 200000, 1, gdal.GDT_Float32, ["SPARSE_OK=TRUE", "TILED=YES", "BLOCKXSIZE=16384",
                                                          "BLOCKYSIZE=16384", "BIGTIFF=YES"])
        raster.SetGeoTransform(UTM16)
        raster = None
        self.refuses("200000 x 200000 heights needs .* GiB of memory.*: read a part of it", sparse)
        virtual = self.path("virtual.vrt")
        with open(virtual, "w", encoding="ascii") as file:
            file.write('<VRTDataset rasterXSize="150000" rasterYSize="90000"><GeoTransform>0,1,0,0,0,-1</GeoTransform>'
                       '<VRTRasterBand dataType="Float32" band="1"/></VRTDataset>')
        self.refuses("150000 x 90000 heights", virtual)
        degrees = create(self.path("degrees.tif"), hills(40, 50), (-84.0, 0.0008, 0.0, 36.0, 0.0, -0.0008), 4326)
        self.refuses("set a larger ProjectedSpacing", degrees, Projection=1, ProjectedSpacing=0.02)
        # One pixel from all pixels: what lies under a block is read at once.
        wide = self.path("wide.tif")
        raster = gdal.GetDriverByName("GTiff").Create(
            wide, 90000, 90000, 1, gdal.GDT_Float32, ["SPARSE_OK=TRUE", "TILED=YES", "COMPRESS=DEFLATE"])
        raster.SetGeoTransform((-84.0, 1e-5, 0.0, 36.0, 0.0, -1e-5))
        raster.SetSpatialRef(system(4326))
        raster = None
        self.refuses("set a smaller ProjectedSpacing", wide, Projection=1, ProjectedSpacing=2000.0)

    def test_systems_that_cannot_be_read(self):
        name = create(self.path("a.tif"), hills(9, 9))
        with open(name, "rb") as file:
            whole = file.read()
        code = (32616).to_bytes(2, "little")
        self.assertEqual(whole.count(code), 1)
        with open(name, "wb") as file:
            file.write(whole.replace(code, (32799).to_bytes(2, "little")))  # which EPSG does not have
        self.refuses("[Ss]et FileCoordinateSystem.*its coordinate system cannot be read", name)
        self.assertEqual(read_elevation(name, FileCoordinateSystem="EPSG:32616").GetDimensions(), (9, 9, 1))
        asc = self.path("b.asc")
        with open(asc, "w", encoding="utf-8") as file:
            file.write("ncols 3\nnrows 3\nxllcorner 500000\nyllcorner 4000000\ncellsize 30\n" + "1 2 3\n" * 3)
        self.assertEqual(read_elevation(asc).GetSpacing()[:2], (30.0, 30.0))
        with open(self.path("b.prj"), "w", encoding="utf-8") as file:
            file.write("nonsense")
        self.refuses("its coordinate system cannot be read", asc)

    def test_values_that_are_no_heights(self):
        name = create(self.path("a.tif"), hills(9, 9),
                      change=lambda raster: raster.GetRasterBand(1).SetUnitType("Kelvin"))
        self.refuses("Set HeightUnit: cannot read .*values are in 'Kelvin', which is no unit of heights", name)

    def test_pictures_are_left_to_other_readers(self):
        reader = littoral.vtkElevationReader()
        picture = create(self.path("picture.tif"), np.zeros((3, 9, 9)), None, 0, kind=gdal.GDT_Byte,
                         options=["PHOTOMETRIC=RGB"])
        photograph = create(self.path("photograph.tif"), np.zeros((3, 9, 9)), kind=gdal.GDT_Byte,
                            options=["PHOTOMETRIC=RGB"])
        self.assertEqual([reader.CanReadFile(name) for name in (
            create(self.path("a.tif"), hills(9, 9)), picture, photograph, self.path("none.tif"))], [1, 0, 0, 0])


if __name__ == "__main__":
    unittest.main()
