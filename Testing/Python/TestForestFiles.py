# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Forests in files of fire and flow codes, read here by struct and numpy: layout, byte order, bad forests."""
import os
import struct
import sys
import tempfile
import unittest

import littoral
import numpy as np
from classic_netcdf import read
from littoral import errors
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLImageDataWriter

if not hasattr(littoral, "vtkForestDensityWriter"):
    print("built without readers and writers")
    sys.exit(125)

FOLDER = tempfile.mkdtemp()
HAS_NETCDF = hasattr(littoral, "vtkOceanCurrentReader")


def trees():
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    for place in ((3.0, 2.5, 0.0), (7.0, 6.1, 0.0), (5.0, 5.0, 0.0)):
        data.GetPoints().InsertNextPoint(place)
    for name, values in (("Height", [11.0, 9.0, 4.0]), ("CrownDiameter", [4.0, 5.0, 1.0]), ("LeafArea", [60.0, 40.0, 0.0])):
        array = numpy_to_vtk(np.array(values), deep=True)
        array.SetName(name)
        data.GetPointData().AddArray(array)
    return data


def density():
    one = littoral.vtkForestDensityFilter()
    one.SetInputDataObject(0, trees())
    one.SetBounds(1.0, 11.0, -1.0, 11.0, 0.0, 12.0)
    one.SetCellSize(2.0, 3.0, 1.5)
    one.Update()
    return one


def cells(image, name):
    """Values by height, y and x."""
    nx, ny, nz = (n - 1 for n in image.GetDimensions())
    return vtk_to_numpy(image.GetCellData().GetArray(name)).reshape(nz, ny, nx)


def bulk(image):
    return cells(image, "BulkDensity")


def written(data, name, **settings):
    """The bytes of a file."""
    path = os.path.join(FOLDER, name)
    writer = littoral.vtkForestDensityWriter()
    writer.SetInputDataObject(0, data)
    writer.SetFileName(path)
    for key, value in settings.items():
        getattr(writer, "Set" + key)(value)
    assert writer.Write() == 1
    with open(path, "rb") as file:
        return file.read()


def records(data):
    """The records of a Fortran file, of all bytes of it."""
    found, place = [], 0
    while place < len(data):
        size, = struct.unpack_from("<i", data, place)
        found.append(data[place + 4: place + 4 + size])
        assert struct.unpack_from("<i", data, place + 4 + size) == (size,)
        place += size + 8
    assert place == len(data)
    return found


class TestForestFiles(unittest.TestCase):
    def test_fds(self):
        image = density().GetOutput()
        bounds, spacing, count, *cells = records(written(image, "a.bdf"))
        self.assertEqual(struct.unpack("<6d", bounds), (1.0, 11.0, -1.0, 11.0, 0.0, 12.0))
        self.assertEqual(struct.unpack("<3d", spacing), (2.0, 3.0, 1.5))
        number, = struct.unpack("<i", count)
        self.assertEqual(2 * number, len(cells))
        grid = np.zeros_like(bulk(image))
        for middle, value in zip(cells[::2], cells[1::2]):
            x, y, z = struct.unpack("<3d", middle)
            grid[int((z - 0.75) / 1.5), int((y + 1.0 - 1.5) / 3.0), int((x - 1.0 - 1.0) / 2.0)] = struct.unpack("<d", value)[0]
        self.assertTrue((grid == bulk(image)).all())
        self.assertEqual(number, (bulk(image) > 0.0).sum())
        self.assertAlmostEqual(grid.sum() * 9.0, 100.0 * 0.0686, delta=1e-5)

    def test_quic_fire(self):
        image = density().GetOutput()
        one, = records(written(image, "a.dat"))
        values = np.frombuffer(one, "<f4").reshape(bulk(image).shape)  # z, y, x
        self.assertTrue((values == bulk(image)).all())

    @unittest.skipUnless(HAS_NETCDF, "built without netCDF")
    def test_palm(self):
        """Axes, attributes and densities of lad and bad: levels from the ground, rows, columns."""
        image = density().GetOutput()
        for cell in (7, 31, 90):  # wood, of which these trees have none
            image.GetCellData().GetArray("PlantAreaDensity").SetValue(cell, 0.125 * cell)
        data = written(image, "a.nc", Latitude=52.5, Longitude=13.25, OriginTime="2026-07-01 06:00:00 +02")
        self.assertEqual(data, written(image, "a.nc", Latitude=52.5, Longitude=13.25, OriginTime="2026-07-01 06:00:00 +02"))
        lengths, place, variables = read(os.path.join(FOLDER, "a.nc"))
        self.assertEqual(lengths, {"zlad": 9, "y": 4, "x": 5})
        self.assertEqual([place["origin_" + name] for name in "x y z lat lon time".split()],
                         [1.0, -1.0, 0.0, 52.5, 13.25, "2026-07-01 06:00:00 +02"])
        self.assertEqual(place["rotation_angle"], 0.0)
        np.testing.assert_array_equal(variables["zlad"].values, [0.0, *np.arange(0.75, 12.0, 1.5)])
        np.testing.assert_array_equal(variables["y"].values, [1.5, 4.5, 7.5, 10.5])
        np.testing.assert_array_equal(variables["x"].values, [1.0, 3.0, 5.0, 7.0, 9.0])
        lad, bad = variables["lad"], variables["bad"]
        for one in (lad, bad):
            self.assertEqual((one.dimensions, one.kind), (["zlad", "y", "x"], "f4"))
            self.assertEqual((one.attributes["units"], one.attributes["_FillValue"]), ("m2 m-3", -9999.0))
            self.assertTrue((one.values[0] == 0.0).all())
        self.assertTrue((lad.values[1:] == cells(image, "LeafAreaDensity")).all())
        self.assertAlmostEqual(lad.values.sum(dtype=float) * 9.0, 100.0, delta=1e-4)
        wood = cells(image, "PlantAreaDensity").astype(float) - cells(image, "LeafAreaDensity")
        self.assertTrue((bad.values[1:] == np.maximum(wood, 0.0).astype("f4")).all())
        self.assertGreater((bad.values > 0.0).sum(), 1)
        image.GetCellData().RemoveArray("PlantAreaDensity")
        above = numpy_to_vtk(np.ones(1), deep=True)
        above.SetName("HeightsAboveGround")
        image.GetFieldData().AddArray(above)  # its lowest face is the ground
        written(image, "b.nc")
        self.assertNotIn("bad", read(os.path.join(FOLDER, "b.nc"))[2])

    def test_forest_rows(self):
        text = written(density().GetOutputDataObject(3), "a.amrwind", DragCoefficient=0.3).decode("ascii")
        rows = [[float(word) for word in line.split()] for line in text.splitlines()]
        self.assertEqual(len(rows), 2)  # without the tree that has no leaves
        self.assertEqual(rows[0][:6], [2.0, 3.0, 2.5, 11.0, 4.0, 0.3])
        for row, area in zip(rows, (60.0, 40.0)):
            self.assertAlmostEqual(row[6] * np.pi / 4.0 * row[4]**2, area, delta=1e-9)
            self.assertEqual(row[7], 0.7)

    def test_volumes(self):
        """The image is one as others are: VTI, and OpenVDB where there is."""
        image = density().GetOutput()
        writer, reader = vtkXMLImageDataWriter(), vtkXMLImageDataReader()
        for each in (writer, reader):
            each.SetFileName(os.path.join(FOLDER, "a.vti"))
        writer.SetInputData(image)
        writer.Write()
        reader.Update()
        self.assertTrue((bulk(reader.GetOutput()) == bulk(image)).all())
        if hasattr(littoral, "vtkVDBVolumeWriter"):
            volume = littoral.vtkVDBVolumeWriter()
            volume.SetInputData(image)
            volume.SetFileName(os.path.join(FOLDER, "a.vdb"))
            self.assertEqual(volume.Write(), 1)
            with open(os.path.join(FOLDER, "a.vdb"), "rb") as file:
                self.assertIn(b"LeafAreaDensity", file.read())

    def test_bad_forests(self):
        def refusal(words, data, name, **settings):
            path = os.path.join(FOLDER, name)
            with open(path, "wb") as file:
                file.write(b"old")
            writer = littoral.vtkForestDensityWriter()
            writer.SetInputDataObject(0, data)
            writer.SetFileName(path)
            for key, value in settings.items():
                getattr(writer, "Set" + key)(value)
            messages = errors.kept(writer)
            self.assertEqual(writer.Write(), 0)
            self.assertEqual(len(messages), 1, messages)
            self.assertIn(words, messages[0])
            with open(path, "rb") as file:
                self.assertEqual(file.read(), b"old")

        def changed(value, cell=7, name="BulkDensity"):
            image = vtkImageData()
            image.DeepCopy(density().GetOutput())
            image.GetCellData().GetArray(name).SetValue(cell, value)
            return image

        image = density().GetOutput()
        for value in (-1.0, float("nan"), float("inf")):
            refusal("BulkDensity of cell 7", changed(value), "b.bdf")
            refusal("BulkDensity of cell 7", changed(value), "b.dat")
            if HAS_NETCDF:
                refusal("LeafAreaDensity of cell 7", changed(value, name="LeafAreaDensity"), "b.nc")
                refusal("PlantAreaDensity of cell 7", changed(value, name="PlantAreaDensity"), "b.nc")
        refusal("FileName must end in", image, "b.txt")
        refusal("image of densities", trees(), "b.bdf")
        refusal("written of trees", image, "b.amrwind")
        refusal("no point array LeafAreaIndex", trees(), "b.amrwind")
        refusal("DragCoefficient", density().GetOutputDataObject(3), "b.amrwind", DragCoefficient=-1.0)
        plain = vtkImageData()
        plain.SetDimensions(3, 3, 3)
        refusal("no cell array BulkDensity", plain, "b.bdf")
        refusal("no cell array LeafAreaDensity", plain, "b.nc")
        refusal("Latitude", image, "b.nc", Latitude=91.0)
        raised = changed(0.5)
        raised.SetOrigin(*raised.GetOrigin()[:2], 2.0)
        above = numpy_to_vtk(np.ones(1), deep=True)
        above.SetName("HeightsAboveGround")
        raised.GetFieldData().AddArray(above)
        refusal("begins at 2 m above the ground", raised, "b.nc")
        flat = vtkImageData()
        flat.SetDimensions(3, 3, 1)
        refusal("no cells", flat, "b.dat")


if __name__ == "__main__":
    unittest.main()
