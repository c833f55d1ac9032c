# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Rasters that are written, against GDAL's own Python package: places, holes, blocks and overviews, rights, full disks."""

import hashlib
import os
import unittest

import numpy as np
from osgeo import gdal

import littoral
from littoral import errors
from littoral.elevation import array_from_image, image_from_array, read_elevation, twin_of, write_tif, write_vti
from littoral.tables import model_names, one_model, table_of
from TestFiles import full_disk
from TestRasters import RANDOM, UTM16, Rasters, create, field, hills, system


class WrittenRasters(Rasters):
    """What is written has the same places, heights and coordinate system in GDAL's eyes."""

    def check_twin(self, name, code, projection=None, **settings):
        """Corners and coordinate system of a twin in a file are those of its place."""
        place = read_elevation(name, projection, **settings)
        twin = twin_of(place, seed=3)
        write_tif(twin, self.path("twin.tif"))
        raster = gdal.Open(self.path("twin.tif"))
        self.assertTrue(raster.GetSpatialRef().IsSame(system(code)), raster.GetSpatialRef())
        self.assertEqual(raster.GetSpatialRef().GetAuthorityCode(None), str(code))
        self.assertTrue(np.array_equal(raster.ReadAsArray(), array_from_image(twin)[::-1]))
        self.assertFalse(os.path.exists(self.path("twin.tif.aux.xml")))
        return raster

    def test_twin_lies_where_its_place_does(self):
        for number, (place, code) in enumerate(((UTM16, 32616),
                                                ((1500000.0, 100.0, 0.0, 700000.0, 0.0, -120.0), 2274))):
            name = create(self.path(f"{number}.tif"), hills(40, 50) + RANDOM.normal(size=(40, 50)), place, code)
            for local in (False, True):
                found = self.check_twin(name, code, LocalOrigin=local).GetGeoTransform()
                self.assertTrue(np.allclose(found, place, rtol=0.0, atol=1e-6), (found, place))

    def test_twin_of_a_projected_place(self):
        name = create(self.path("a.tif"), hills(60, 60) + RANDOM.normal(size=(60, 60)),
                      (-84.5, 0.001, 0.0, 36.5, 0.0, -0.001), 4326)
        truth = gdal.Warp("", name, format="MEM", dstSRS="EPSG:32616").GetGeoTransform()
        found = self.check_twin(name, 32616, "UTM").GetGeoTransform()
        self.assertTrue(np.allclose(found, truth, rtol=0.0, atol=1e-6), (found, truth))

    def test_twin_through_a_table_without_its_pipeline(self):
        name = create(self.path("a.tif"), hills(40, 50) + RANDOM.normal(size=(40, 50)))
        fit = littoral.vtkCovarianceFitFilter()
        fit.SetInputData(read_elevation(name))
        fit.Update()
        twin = littoral.vtkTurningBandsTerrainSource()
        twin.SetInputData(fit.GetOutput(0))
        twin.UseMeasuredGridOn()
        twin.Update()
        write_tif(twin.GetOutput(), self.path("twin.tif"))
        self.assertEqual(gdal.Open(self.path("twin.tif")).GetGeoTransform(), UTM16)
        # On another grid it is in no place.
        twin.UseMeasuredGridOff()
        twin.Update()
        self.assertIsNone(field(twin.GetOutput(), "CoordinateSystem"))
        self.assertEqual(twin.GetOutput().GetDimensions(), (501, 501, 1))
        alone = littoral.vtkTurningBandsTerrainSource()
        alone.UseMeasuredGridOn()
        messages = errors.kept(alone)
        alone.Update()
        self.assertEqual((messages, alone.GetOutput().GetDimensions()), ([], (501, 501, 1)))
        alone.SetInputData(table_of({"ModelId": [1.0]}))
        alone.Update()
        self.assertEqual(len(messages), 1, messages)
        self.assertRegex(messages[0], "the table of fits names no grid")
        alone.SetInputData(one_model(fit.GetOutput(0), model_names(fit.GetOutput(0))[1]))
        alone.Update()
        self.assertEqual((len(messages), alone.GetOutput().GetDimensions()), (1, (50, 40, 1)))

    def test_filled_raster_and_its_carved_twin(self):
        """Holes filled by kriging, normal scores and their way back, valleys: each step keeps the place on earth."""
        heights = hills(40, 50) + RANDOM.normal(size=(40, 50)).astype(np.float32)
        holed = heights.copy()
        holed[20:24, 30:33] = np.nan
        filled = littoral.vtkConditionalTerrainFilter()
        filled.SetInputData(read_elevation(create(self.path("a.tif"), holed), LocalOrigin=True))
        filled.SetResultToKrigingEstimate()
        filled.SetModelToSimpleExponential()
        filled.Update()
        place = filled.GetOutput()
        self.assertTrue(np.isfinite(array_from_image(place)).all())
        scores, back, drainage = (littoral.vtkNormalScoresFilter(), littoral.vtkNormalScoresFilter(),
                                  littoral.vtkDrainageFilter())
        scores.SetInputData(place)
        scores.Update()
        back.SetInputData(twin_of(scores.GetOutput(), seed=3))
        back.SetInputData(1, place)
        back.InverseOn()
        drainage.SetInputConnection(back.GetOutputPort())
        drainage.SetInputData(1, place)
        drainage.SetMaximumNumberOfIterations(2)
        drainage.Update()
        for number, image in enumerate((place, back.GetOutput(), drainage.GetOutput())):
            with self.subTest(number=number):
                name = self.path(f"{number}.tif")
                write_tif(image, name)
                raster = gdal.Open(name)
                self.assertEqual(raster.GetGeoTransform(), UTM16)
                self.assertTrue(raster.GetSpatialRef().IsSame(system(32616)))
        known = np.isfinite(holed)
        written = gdal.Open(self.path("0.tif")).ReadAsArray()
        self.assertTrue(np.allclose(written[known], holed[known], rtol=0.0, atol=1e-4))

    def test_field_data_survive_a_vti(self):
        place = read_elevation(create(self.path("a.tif"), hills(6, 7)), LocalOrigin=True)
        write_vti(place, self.path("a.vti"))
        write_tif(read_elevation(self.path("a.vti")), self.path("b.tif"))
        self.assertEqual(gdal.Open(self.path("b.tif")).GetGeoTransform(), UTM16)
        self.assertTrue(gdal.Open(self.path("b.tif")).GetSpatialRef().IsSame(system(32616)))

    def test_holes_precision_and_names(self):
        heights = hills(6, 7)
        heights[2, 3] = np.nan
        place = read_elevation(create(self.path("a.tif"), heights))
        write_tif(place, self.path("b.tif"))
        raster = gdal.Open(self.path("b.tif"))
        band = raster.GetRasterBand(1)
        self.assertTrue(np.isnan(band.GetNoDataValue()))
        self.assertEqual(band.GetUnitType(), "m")
        self.assertTrue(np.array_equal(band.ReadAsArray(), heights, equal_nan=True))
        self.assertEqual(band.DataType, gdal.GDT_Float32)
        self.assertEqual(band.GetMaskBand().ReadAsArray()[2, 3], 0)

    def test_named_system_and_none(self):
        image = image_from_array(hills(4, 5), (10.0, 20.0), (500005.0, 4000010.0))
        write_tif(image, self.path("a.tif"))
        raster = gdal.Open(self.path("a.tif"))
        self.assertIsNone(raster.GetSpatialRef())
        self.assertEqual(raster.GetGeoTransform(), (500000.0, 10.0, 0.0, 4000080.0, 0.0, -20.0))
        write_tif(image, self.path("a.tif"), "EPSG:32632")
        self.assertTrue(gdal.Open(self.path("a.tif")).GetSpatialRef().IsSame(system(32632)))
        for bad in ("nowhere", "EPSG:4326"):
            with self.assertRaisesRegex(ValueError, "CoordinateSystem is"):
                write_tif(image, self.path("a.tif"), bad)
        self.assertTrue(gdal.Open(self.path("a.tif")).GetSpatialRef().IsSame(system(32632)))

    def test_turned_images(self):
        image = image_from_array(hills(4, 5), (10.0, 20.0), (500005.0, 4000010.0))
        c, s = np.cos(0.5), np.sin(0.5)
        image.SetDirectionMatrix(c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0)
        write_tif(image, self.path("a.tif"))
        raster = gdal.Open(self.path("a.tif"))
        for row, column in ((0, 0), (3, 4), (2, 1)):
            x, y = gdal.ApplyGeoTransform(raster.GetGeoTransform(), column + 0.5, row + 0.5)
            point = image.GetPoint(image.ComputePointId((column, 3 - row, 0)))
            self.assertTrue(np.allclose((x, y), point[:2], atol=1e-6))
        image.SetDirectionMatrix(1.0, 0.0, 0.0, 0.0, c, -s, 0.0, s, c)
        with self.assertRaisesRegex(ValueError, "tilted"):
            write_tif(image, self.path("a.tif"))

    def test_same_bytes(self):
        sums = set()
        for name in ("a.tif", "b.tif"):
            write_tif(image_from_array(hills(200, 300), (10.0, 10.0)), self.path(name), "EPSG:32632")
            with open(self.path(name), "rb") as file:
                sums.add(hashlib.sha256(file.read()).digest())
        self.assertEqual(len(sums), 1)

    def test_cloud_optimized(self):
        """A file in blocks with overviews, made of parts of a terrain that is never whole; overviews are means."""
        terrain = littoral.vtkTurningBandsTerrainSource()
        terrain.SetWholeExtent(3, 4302, -8, 1023, 0, 0)
        terrain.SetNumberOfLines(8)
        writer = littoral.vtkElevationWriter()
        writer.SetInputConnection(terrain.GetOutputPort())
        writer.SetFileName(self.path("parts.tif"))
        self.assertEqual(writer.Write(), 1)
        self.assertLessEqual(terrain.GetOutput().GetNumberOfPoints(), 4300 * 512)
        terrain.UpdateWholeExtent()
        heights = array_from_image(terrain.GetOutput())[::-1]
        writer.SetInputData(terrain.GetOutput())
        writer.SetFileName(self.path("whole.tif"))
        self.assertEqual(writer.Write(), 1)
        with open(self.path("parts.tif"), "rb") as parts, open(self.path("whole.tif"), "rb") as whole:
            self.assertEqual(parts.read(), whole.read())
        raster = gdal.Open(self.path("parts.tif"))
        band = raster.GetRasterBand(1)
        self.assertEqual(raster.GetMetadataItem("LAYOUT", "IMAGE_STRUCTURE"), "COG")
        self.assertEqual(band.GetBlockSize(), [512, 512])
        np.testing.assert_array_equal(band.ReadAsArray(), heights.astype(np.float32))
        self.assertEqual([band.GetOverview(i).XSize for i in range(band.GetOverviewCount())], [2150, 1075, 538, 269])
        means = heights.reshape(516, 2, 2150, 2).mean(axis=(1, 3))
        np.testing.assert_allclose(band.GetOverview(0).ReadAsArray(), means, atol=1e-3)

    def test_images_that_cannot_be_written(self):
        writer = littoral.vtkElevationWriter()
        messages = errors.kept(writer)
        writer.SetFileName(self.path("a.tif"))
        self.assertEqual(writer.Write(), 0)
        vector = image_from_array(hills(4, 5), (1.0, 1.0))
        vector.GetPointData().GetScalars().SetNumberOfComponents(2)
        vector.GetPointData().GetScalars().SetNumberOfTuples(20)
        none = image_from_array(hills(4, 5), (1.0, 1.0))
        none.GetPointData().Initialize()
        layers = littoral.vtkWindFieldSource()
        layers.SetDimensions(16, 4, 4)
        layers.Update()
        wrong = image_from_array(hills(4, 5), (1.0, 1.0))
        from vtkmodules.vtkCommonCore import vtkDoubleArray
        unit = vtkDoubleArray()
        unit.SetName("CoordinateUnit")
        unit.InsertNextValue(0.0)
        wrong.GetFieldData().AddArray(unit)
        for image, reason in ((vector, "2 components"), (none, "no point array 'Elevation'"),
                              (layers.GetOutput(), "layer"), (wrong, "CoordinateUnit must be above 0")):
            writer.SetInputData(image)
            self.assertEqual(writer.Write(), 0)
            self.assertRegex(messages[-1], reason)
        self.assertEqual(len(messages), 5, messages)
        self.assertEqual(os.listdir(self.folder), [])
        writer.SetInputData(image_from_array(hills(4, 5), (1.0, 1.0)))
        self.assertEqual(writer.Write(), 1)
        self.assertEqual(len(messages), 5, messages)

    def test_what_tells_of_the_old_file_goes(self):
        """Statistics, overviews and masks beside a raster are those of the file that it replaces."""
        name = self.path("again.tif")
        write_tif(image_from_array(hills(20, 20), (10.0, 10.0)), name)
        raster = gdal.Open(name)
        old = raster.GetRasterBand(1).ComputeStatistics(False)
        raster.BuildOverviews("NEAREST", [2])
        raster = None
        self.assertEqual(sorted(os.listdir(self.folder)), ["again.tif", "again.tif.aux.xml", "again.tif.ovr"])
        write_tif(image_from_array(hills(30, 30) + 1000.0, (10.0, 10.0)), name)
        self.assertEqual(os.listdir(self.folder), ["again.tif"])
        raster = gdal.Open(name)
        self.assertGreater(raster.GetRasterBand(1).GetStatistics(True, True)[0], old[1])

    def test_mode_owner_and_links_stay(self):
        for writes in (write_tif, write_vti):
            with self.subTest(writes.__name__):
                name = self.path("kept" + writes.__name__)
                image = image_from_array(hills(9, 9), (10.0, 10.0))
                writes(image, name)
                with open(name, "rb") as file:
                    whole = file.read()
                self.assertEqual(os.stat(name).st_mode & 0o777, 0o666 & ~self.umask())
                for mode in (0o600, 0o640, 0o444):
                    os.chmod(name, mode)
                    if os.geteuid() == 0:
                        os.chown(name, 12345, 54321)
                    owner = os.stat(name).st_uid, os.stat(name).st_gid
                    writes(image, name)
                    self.assertEqual(os.stat(name).st_mode & 0o777, mode)
                    self.assertEqual((os.stat(name).st_uid, os.stat(name).st_gid), owner)
                os.chmod(name, 0o600)
                os.link(name, name + "2")
                os.symlink(name, name + "3")
                with open(name, "ab") as file:
                    file.write(b"longer than before" * 1000)
                writes(image, name + "3")
                self.assertEqual((os.stat(name).st_nlink, os.path.islink(name + "3")), (2, True))
                with open(name + "2", "rb") as file:
                    self.assertEqual(file.read(), whole)

    @staticmethod
    def umask():
        old = os.umask(0)
        os.umask(old)
        return old

    def test_folder_and_full_disk(self):
        image = image_from_array(RANDOM.normal(size=(400, 400)).astype(np.float32), (10.0, 10.0))
        with self.assertRaisesRegex(OSError, "there is no folder"):
            write_tif(image, self.path("none/a.tif"))
        with self.assertRaisesRegex(OSError, "it is a folder"):
            write_tif(image, self.folder)
        with full_disk(100000) as disk:
            name = os.path.join(disk, "a.tif")
            small = image_from_array(hills(8, 8), (10.0, 10.0))
            write_tif(small, name)
            with open(name, "rb") as file:
                before = file.read()
            with self.assertRaisesRegex(OSError, "No space left on device"):
                write_tif(image, name)
            with open(name, "rb") as file:
                self.assertEqual(file.read(), before)
            self.assertEqual(os.listdir(disk), ["a.tif"])


if __name__ == "__main__":
    unittest.main()
