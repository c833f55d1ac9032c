# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Winds in files of turbine codes, made and read here by struct and numpy: layout, byte order, places, bad files."""
import os
import struct
import sys
import tempfile
import unittest

import littoral
import numpy as np
from classic_netcdf import Variable, read, write
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonDataModel import vtkImageData

if not hasattr(littoral, "vtkWindFieldWriter"):
    print("built without readers and writers")
    sys.exit(125)

HEADER = "<h4i6f6fi"
HAS_NETCDF = hasattr(littoral, "vtkOceanCurrentReader")


def bts(values, tower=None, ident=8, spacing=(25.0, 25.0, 0.05), speed=8.0, hub=90.0, bottom=65.0, text=b"a wind",
        order="<"):
    """Bytes of a .bts file: values by time, height, across and component; those of the tower by time and depth."""
    times, up, across, _ = values.shape
    tower = np.zeros((times, 0, 3)) if tower is None else tower
    everything = np.concatenate([values.reshape(times, -1, 3), tower], axis=1)
    low, high = everything.min(axis=(0, 1)), everything.max(axis=(0, 1))
    slope = (65535.0 / np.where(high > low, high - low, 1.0)).astype("f4")
    offset = (-32768.0 - slope * low).astype("f4")
    stored = np.clip(np.rint(everything * slope + offset), -32768, 32767).astype(order + "i2")
    scales = np.stack([slope, offset], axis=1).ravel()
    head = struct.pack(HEADER.replace("<", order), ident, up, across, tower.shape[1], times, *spacing, speed, hub,
                       bottom, *scales, len(text))
    return head + text + stored.tobytes()


def read_bts(path):
    """Header, values by time, height, across and component, and those of the tower, of all bytes of a file."""
    with open(path, "rb") as file:
        data = file.read()
    head = struct.unpack_from(HEADER, data)
    _, up, across, tower, times = head[:5]
    start = struct.calcsize(HEADER) + head[17]
    stored = np.frombuffer(data, "<i2", offset=start).reshape(times, up * across + tower, 3)
    slope, offset = np.array(head[11:17:2]), np.array(head[12:17:2])
    values = (stored - offset) / slope
    return head, values[:, : up * across].reshape(times, up, across, 3), values[:, up * across:], data


def read_hawc(path, speed):
    """Values by time, height, across and component, and the lines of the text without comments."""
    with open(path, encoding="ascii") as file:
        text = file.read()
    lines = [line.split(";")[0].split() for line in text.splitlines()]
    words = {line[0]: line[1:] for line in lines if line}
    shape = [int(words["box_dim_" + letter][0]) for letter in "uvw"]
    parts = []
    for letter in "uvw":
        with open(os.path.join(os.path.dirname(path), words["filename_" + letter][0]), "rb") as file:
            data = file.read()
        assert len(data) == 4 * np.prod(shape)
        box = np.frombuffer(data, "<f4").reshape(shape)  # plane, across from the left, height
        parts.append(box.transpose(0, 2, 1)[:, :, ::-1])
    values = np.stack(parts, axis=-1) + (speed, 0.0, 0.0)
    return (values if "first_plane earliest" in text else values[::-1]), words


BLADED = "<2hi6f3fi4f10i"


def read_wnd(path):
    """Header and values by time, height, across and component, by the scales of the summary."""
    with open(path, "rb") as file:
        data = file.read()
    with open(path[:-3] + "sum", encoding="ascii") as file:
        summary = file.read()
    head = struct.unpack_from(BLADED, data)
    times, up, across = 2 * head[12], head[19], head[20]
    stored = np.frombuffer(data, "<i2", offset=104).reshape(times, up, across, 3)[:, :, ::-1]  # clockwise
    speed = float(summary.split("UBAR =")[1].split()[0])
    scale = np.array([float(summary.split(f"TI({letter}) =")[1].split()[0]) for letter in "uvw"]) * speed * 1e-5
    return head, stored * scale + (speed, 0.0, 0.0), scale, summary


def netcdf_parts(values):
    """Lengths and variables of a wind in netCDF without attributes of the file, by time, height, across and component."""
    times, up, across, _ = values.shape
    axes = {"time": Variable("time", 0.05 * np.arange(times), "f4", units="seconds since 2020-01-01"),
            "z": Variable("z", 65.0 + 25.0 * np.arange(up), units="m"),
            "y": Variable("y", 25.0 * (np.arange(across) - 0.5 * (across - 1)), units="m")}
    winds = {name: Variable("time z y", values[..., n], "f4", units="m s-1") for n, name in enumerate("uvw")}
    return {"time": times, "z": up, "y": across}, {**axes, **winds}


def random_wind(times, across, up):
    """Velocities by time, height, across and component."""
    return np.random.default_rng(times).normal((8.0, 0.0, 0.0), (1.2, 0.9, 0.6), (times, up, across, 3)).astype("f4")


def numbers(image):
    """Velocity by height, across, along and component."""
    size = image.GetDimensions()[::-1]
    return vtk_to_numpy(image.GetPointData().GetArray("Velocity")).reshape(*size, 3)


def field(image, name):
    array = image.GetFieldData().GetArray(name)
    return array.GetValue(0) if array else None


class SlowSource(VTKPythonAlgorithmBase):
    """A wind by time, height, across and component, made in the extents that are asked for and counts them."""

    def __init__(self, values, turned=False):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType="vtkImageData")
        self.values, self.turned, self.most, self.first = values, turned, 0, (2, -3, 1)

    def RequestInformation(self, request, inputs, outputs):
        times, up, across, _ = self.values.shape
        whole = [n for first, size in zip(self.first, (times, across, up)) for n in (first, first + size - 1)]
        outputs.GetInformationObject(0).Set(self.GetExecutive().WHOLE_EXTENT(), whole, 6)
        return 1

    def RequestData(self, request, inputs, outputs):
        info, output = outputs.GetInformationObject(0), vtkImageData.GetData(outputs)
        extent = info.Get(self.GetExecutive().UPDATE_EXTENT())
        output.SetExtent(extent)
        output.SetSpacing(0.8, 25.0, 10.0)
        output.SetOrigin(0.0, 0.0, 20.0)
        (i, l), (j, m), (k, n) = ((extent[2 * axis] - first, extent[2 * axis + 1] + 1 - first)
                                  for axis, first in enumerate(self.first))
        part = self.values[::-1][i:l, k:n, j:m].transpose(1, 2, 0, 3).reshape(-1, 3)  # what is upwind comes later
        if self.turned:
            output.SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1)
            part = part[:, [1, 0, 2]] * (-1.0, 1.0, 1.0)
        array = numpy_to_vtk(np.ascontiguousarray(part), deep=True)
        array.SetName("Velocity")
        output.GetPointData().AddArray(array)
        self.most = max(self.most, output.GetNumberOfPoints())
        for name, value in (("ConvectionSpeed", 8.0), ("Period", 0.1 * len(self.values))):
            number = numpy_to_vtk(np.array([value]), deep=True)
            number.SetName(name)
            output.GetFieldData().AddArray(number)
        return 1


class WindFiles(unittest.TestCase):
    """Each in a folder of its own."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = temporary.name

    def path(self, name, content=None):
        path = os.path.join(self.folder, name)
        if content is not None:
            with open(path, "wb") as file:
                file.write(content)
        return path

    def reader(self, name, content=None, **settings):
        reader = littoral.vtkWindFieldReader()
        reader.SetFileName(self.path(name, content))
        for key, value in settings.items():
            getattr(reader, "Set" + key)(*np.atleast_1d(value))
        return reader

    def refused(self, algorithm, words, write=False):
        """One message with the words, and no output."""
        messages = []

        def listen(_, __, text):
            messages.append(text)
        listen.CallDataType = "string0"
        algorithm.AddObserver("ErrorEvent", listen)
        algorithm.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
        if write:
            self.assertEqual(algorithm.Write(), 0)
        else:
            algorithm.Update()
            self.assertEqual(algorithm.GetOutput().GetNumberOfPoints(), 0)
        self.assertEqual(len(messages), 1, messages)
        self.assertIn(words, messages[0])

    def test_sample_of_another_tool(self):
        """A file with the figures of one that is published: 7372 bytes, of which all are read."""
        values, tower = random_wind(100, 3, 3), random_wind(100, 3, 1)[:, 0]
        values[0, 0, 0] = (6.4163, 0.8205, -0.3333)
        content = bts(values, tower, text=b"x" * 102)
        self.assertEqual(len(content), 7372)
        reader = self.reader("sample.bts", content)
        reader.Update()
        image, below = reader.GetOutput(0), reader.GetOutput(1)
        self.assertEqual(image.GetDimensions(), (100, 3, 3))
        np.testing.assert_allclose(image.GetSpacing(), (0.4, 25.0, 25.0), rtol=1e-6)
        np.testing.assert_allclose(image.GetOrigin(), (-39.6, -25.0, 65.0), rtol=1e-6)
        self.assertEqual((field(image, "ConvectionSpeed"), field(image, "HubHeight")), (8.0, 90.0))
        self.assertAlmostEqual(field(image, "Period"), 5.0, 6)
        # the first plane is at Center, the last sample along the wind; the first point is the right lowest one
        step = np.ptp(np.concatenate([values.reshape(-1, 3), tower.reshape(-1, 3)]), axis=0) / 65535.0
        found = numbers(image)[:, :, ::-1].transpose(2, 0, 1, 3)
        self.assertTrue((abs(found - values) <= 0.51 * step + 1e-6).all())
        self.assertEqual(below.GetDimensions(), (100, 1, 3))
        np.testing.assert_allclose(below.GetOrigin(), (-39.6, 0.0, -10.0), rtol=1e-6)
        found = numbers(below)[::-1, 0, ::-1].transpose(1, 0, 2)
        self.assertTrue((abs(found - tower) <= 0.51 * step + 1e-6).all())

    def test_times_and_places(self):
        """At each time its plane is at Center; parts are those of the whole; a turned wind has turned velocities."""
        values = random_wind(7, 4, 2)
        reader = self.reader("wind.bts", bts(values, ident=7), Center=(100.0, 20.0), WindDirection=90.0)
        for step in (0, 3, 6, 8, -1):
            reader.UpdateTimeStep(step * 0.05)
            image = reader.GetOutput()
            index = image.FindPoint((100.0, 20.0 - 1e-4, 65.0))
            plane = numbers(image)[:, :, -1]
            np.testing.assert_allclose(plane[..., 1], values[step % 7][..., 0], atol=1e-3)
            np.testing.assert_allclose(plane[..., 0], -values[step % 7][..., 1], atol=1e-3)
            np.testing.assert_allclose(image.GetPoint(image.ComputePointId((6, 0, 0))), (137.5, 20.0, 65.0), atol=1e-4)
            self.assertGreaterEqual(index, 0)
        whole = numbers(reader.GetOutput()).copy()
        self.assertIsNone(field(reader.GetOutput(), "Period"))  # it is not periodic
        reader.Modified()
        reader.UpdateExtent((1, 4, 2, 3, 1, 1))
        np.testing.assert_array_equal(numbers(reader.GetOutput()), whole[1:2, 2:4, 1:5])

    def test_written_file(self):
        """Header, order of planes and points, errors within range/65535, periodicity and tower, from parts."""
        values = random_wind(300, 51, 61)
        for turned in (False, True):
            source = SlowSource(values, turned)
            writer = littoral.vtkWindFieldWriter()
            writer.SetInputConnection(source.GetOutputPort())
            writer.SetFileName(self.path("wind.bts"))
            writer.SetTowerLayers(2)
            self.assertEqual(writer.Write(), 1)
            self.assertLessEqual(source.most * 12, 32 << 20)  # 11 MB of a part, and of 37 in all two or more
            head, grid, tower, data = read_bts(writer.GetFileName())
            self.assertEqual(head[:5], (8, 59, 51, 2, 300))
            # bottom: 20 m, first index 1, two layers of the tower; hub: the middle of the grid
            np.testing.assert_allclose(head[5:11], (10.0, 25.0, 0.1, 8.0, 340.0, 50.0), rtol=1e-6)
            bound = np.ptp(values.reshape(-1, 3), axis=0) / 65535.0
            self.assertTrue((abs(grid - values[:, 2:]) <= bound).all())
            self.assertTrue((abs(tower - values[:, 1::-1, 25]) <= bound).all())
            self.assertEqual(len(data), 70 + head[17] + 300 * (51 * 59 + 2) * 6)
        os.rename(writer.GetFileName(), self.path("first.bts"))
        again = self.reader("first.bts")
        again.Update()
        writer.SetInputConnection(again.GetOutputPort())
        writer.SetTowerLayers(0)
        self.assertEqual(writer.Write(), 1)
        head_again, grid_again, _, _ = read_bts(writer.GetFileName())
        np.testing.assert_allclose(head_again[5:11], head[5:11], rtol=1e-6)
        self.assertTrue((abs(grid_again - grid) <= bound).all())

    def test_steady_and_sheared(self):
        """Constant components are kept; a wind whose upper point leads leads in the file and after reading."""
        times = np.arange(64)
        values = np.zeros((64, 3, 2, 3), "f4")
        values[..., 1] = 1.25
        values[..., 0] = 10.0 + np.sin(2.0 * np.pi * (times[:, None, None] + 4 * np.arange(3)[:, None]) / 64.0)
        source = SlowSource(values)
        writer = littoral.vtkWindFieldWriter()
        writer.SetInputConnection(source.GetOutputPort())
        writer.SetFileName(self.path("wind.bts"))
        writer.SetHubHeight(31.0)
        self.assertEqual(writer.Write(), 1)
        head, grid, _, _ = read_bts(writer.GetFileName())
        self.assertAlmostEqual(head[9], 31.0, 5)
        np.testing.assert_allclose(grid[..., 1:], values[..., 1:], atol=3e-7)
        reader = self.reader("wind.bts")
        peaks = []
        for step in times:
            reader.UpdateTimeStep(step * 0.1)
            peaks.append(numbers(reader.GetOutput())[:, 0, -1, 0])
        self.assertEqual(list(np.argmax(peaks, axis=0)), [16, 12, 8])
        self.assertEqual(list(np.argmax(grid[:, :, 0, 0], axis=0)), [16, 12, 8])

    def test_hawc_leads_in_both_orders(self):
        """A sheared field whose upper point leads: in the binaries and after reading, in both orders."""
        times = np.arange(64)
        values = random_wind(64, 4, 3)
        values[:, :, 1, 0] = 10.0 + np.sin(2.0 * np.pi * (times[:, None] + 4 * np.arange(3)) / 64.0)
        source = SlowSource(values)
        for order in (0, 1):
            writer = littoral.vtkWindFieldWriter()
            writer.SetInputConnection(source.GetOutputPort())
            writer.SetFileName(self.path("box.hawc"))
            writer.SetPlaneOrder(order)
            self.assertEqual(writer.Write(), 1)
            box, words = read_hawc(writer.GetFileName(), 8.0)
            np.testing.assert_allclose(box, values, atol=1e-6)
            self.assertEqual(words["wsp"] + words["box_dim_v"] + words["dont_scale"], ["8", "4", "25", "1"])
            self.assertAlmostEqual(float(words["center_pos0"][2]), -40.0, 9)
            self.assertEqual(words["shear_format"], ["1", "8"])
            with open(self.path("box_u.bin"), "rb") as file:
                first = np.frombuffer(file.read(12), "<f4")  # heights at the left of the first plane
            np.testing.assert_allclose(first + 8.0, values[0 if order == 0 else -1, :, 3, 0], atol=1e-6)
            reader = self.reader("box.hawc", PlaneOrder=1 - order)  # the text tells
            peaks = []
            for step in times:
                reader.UpdateTimeStep(step * 0.1)
                plane = numbers(reader.GetOutput())[:, :, -1]
                np.testing.assert_allclose(plane, values[step], atol=1e-6)
                peaks.append(plane[:, 1, 0])
            self.assertEqual(list(np.argmax(peaks, axis=0)), [16, 12, 8])
            image = reader.GetOutput()
            self.assertAlmostEqual(field(image, "Period"), 6.4, 9)
            self.assertAlmostEqual(image.GetOrigin()[2], 30.0, 9)
        with open(self.path("box.hawc"), encoding="ascii") as file:
            text = "".join(line for line in file if not line.startswith("; littoral first"))
        others = self.reader("others.hawc", text.encode(), PlaneOrder=1)
        others.Update()
        np.testing.assert_allclose(numbers(others.GetOutput())[:, :, -1], values[0], atol=1e-6)
        os.truncate(self.path("box_v.bin"), 100)
        self.refused(self.reader("box.hawc"), "its file box_v.bin: it is cut off")
        os.remove(self.path("box_w.bin"))
        os.remove(self.path("box_v.bin"))
        self.refused(self.reader("box.hawc"), "its file box_v.bin: N")
        for words, bad in (("no line wsp", text.replace("wsp 8", "")),
                           ("line wsp has 2", text.replace("wsp 8", "wsp 8 9")),
                           ("'x' for a number", text.replace("wsp 8", "wsp x")),
                           ("for a number of points", text.replace("box_dim_u 64", "box_dim_u 6.5")),
                           ("neither", text + "; littoral first_plane middle\n")):
            self.refused(self.reader("bad.hawc", bad.encode()), words)

    def test_bladed(self):
        """Header and integers of .wnd, scales of .sum, both read again; contradictions are refused."""
        values = random_wind(40, 4, 3)
        source = SlowSource(values)
        writer = littoral.vtkWindFieldWriter()
        writer.SetInputConnection(source.GetOutputPort())
        writer.SetFileName(self.path("wind.wnd"))
        writer.SetHubHeight(45.0)
        self.assertEqual(writer.Write(), 1)
        head, found, scale, summary = read_wnd(writer.GetFileName())
        self.assertEqual(head[:3] + head[12:13] + head[19:21], (-99, 4, 3, 20, 3, 4))
        np.testing.assert_allclose(head[5], 40.0)
        np.testing.assert_allclose(head[9:12] + head[13:14], (10.0, 25.0, 0.8, 8.0), rtol=1e-6)
        deviation = np.sqrt(((values.astype(float) - (8.0, 0.0, 0.0)) ** 2).mean(axis=(0, 1, 2)))
        np.testing.assert_allclose(scale, deviation / 1000.0, rtol=1e-6)
        self.assertTrue((abs(found - values) <= 0.51 * scale).all())
        reader = self.reader("wind.wnd")
        for step in (0, 1, 39):
            reader.UpdateTimeStep(step * 0.1)
            plane = numbers(reader.GetOutput())[:, :, -1]
            self.assertTrue((abs(plane - values[step]) <= 0.52 * scale).all())
        image = reader.GetOutput()
        np.testing.assert_allclose((image.GetOrigin()[2], field(image, "HubHeight"), field(image, "Period")),
                                   (30.0, 45.0, 4.0), rtol=1e-6)
        for words, bad in (("contradicts it: the speed", summary.replace("UBAR = 8", "UBAR = 9")),
                           ("contradicts it: an intensity", summary.replace("TI(v) = ", "TI(v) = 1")),
                           ("contradicts it: the height", summary.replace("HEIGHT OFFSET = 5", "HEIGHT OFFSET = 3")),
                           ("no line CLOCKWISE", ""), ("T or F", summary.replace("T   CLOCK", "9   CLOCK")),
                           ("no number for UBAR", summary.replace("UBAR = 8", "UBAR = x"))):
            self.path("wind.sum", bad.encode())
            self.refused(self.reader("wind.wnd"), words)
        self.path("wind.sum", summary.replace("T   CLOCK", "F   CLOCK").encode())
        other = self.reader("wind.wnd")
        other.Update()
        self.assertTrue((abs(numbers(other.GetOutput())[:, ::-1, -1] - values[0]) <= 0.52 * scale).all())
        os.truncate(self.path("wind.wnd"), 1000)
        self.refused(self.reader("wind.wnd"), "cut off")
        os.remove(self.path("wind.sum"))
        self.refused(self.reader("wind.wnd"), "its .sum: N")

    @unittest.skipUnless(HAS_NETCDF, "built without netCDF")
    def test_netcdf(self):
        """Axes, records and attributes; a wind and its tower come back to the bit."""
        values = (np.arange(70 * 203 * 205 * 3, dtype="f4") % 10007).reshape(70, 203, 205, 3) * np.float32(1e-3)
        source = SlowSource(values)
        writer = littoral.vtkWindFieldWriter()
        writer.SetInputConnection(source.GetOutputPort())
        writer.SetFileName(self.path("wind.nc"))
        writer.SetTowerLayers(2)
        self.assertEqual(writer.Write(), 1)
        self.assertLessEqual(source.most * 12, 32 << 20)  # of 35 MB
        lengths, attributes, found = read(self.path("wind.nc"))
        self.assertEqual(lengths, {"time": 70, "z": 201, "y": 205, "z_tower": 2})
        self.assertEqual([attributes[name] for name in ("mean_wind_speed", "hub_height", "periodic")], [8.0, 1050.0, 1.0])
        np.testing.assert_allclose(found["time"].values, 0.1 * np.arange(70), rtol=1e-12)
        np.testing.assert_array_equal(found["z"].values, 50.0 + 10.0 * np.arange(201))
        np.testing.assert_array_equal(found["y"].values, 25.0 * np.arange(-102, 103))
        np.testing.assert_array_equal(found["z_tower"].values, [30.0, 40.0])
        for n, name in enumerate("uvw"):
            self.assertEqual((found[name].dimensions, found[name].kind), (["time", "z", "y"], "f4"))
            self.assertEqual(found[name].attributes["units"], "m s-1")
            np.testing.assert_array_equal(found[name].values, values[:, 2:, :, n])
            np.testing.assert_array_equal(found[name + "_tower"].values, values[:, :2, 102, n])
        reader = self.reader("wind.nc")
        reader.Update()
        np.testing.assert_array_equal(numbers(reader.GetOutput())[:, :, ::-1], values[:, 2:].transpose(1, 2, 0, 3))
        np.testing.assert_array_equal(numbers(reader.GetOutput(1))[:, 0, ::-1], values[:, :2, 102].transpose(1, 0, 2))
        image = reader.GetOutput()
        self.assertEqual((image.GetOrigin()[2], field(image, "HubHeight"), field(image, "ConvectionSpeed")),
                         (50.0, 1050.0, 8.0))
        self.assertAlmostEqual(field(image, "Period"), 7.0, 9)

    @unittest.skipUnless(HAS_NETCDF, "built without netCDF")
    def test_netcdf_of_others(self):
        """Standard names, packed integers, no attributes of the file: mean and hub by the stated rules; bad files."""
        values = random_wind(20, 3, 3)
        lengths, good = netcdf_parts(values)

        def reader_of(name, parts, **attributes):
            write(self.path(name), {**lengths, "x": 3}, parts, unlimited=None, attributes=attributes or None)
            return self.reader(name)

        packed = np.rint((values[..., 0] - 8.0) / 1e-3)
        other = {{"v": "left"}.get(name, name): one for name, one in good.items() if name != "u"}
        other["left"].attributes["standard_name"] = "y_wind"
        other["wind"] = Variable("time z y", packed, "i2", standard_name="x_wind", scale_factor=1e-3, add_offset=8.0)
        reader = reader_of("others.nc", other)
        self.assertEqual(reader.CanReadFile(self.path("others.nc")), 1)
        reader.Update()
        image = reader.GetOutput()
        np.testing.assert_allclose(numbers(image)[:, :, -1, 0], packed[0] * 1e-3 + 8.0, rtol=1e-6)
        np.testing.assert_array_equal(numbers(image)[:, :, -1, 1], values[0, ..., 1])
        self.assertAlmostEqual(field(image, "ConvectionSpeed"), 8.0 + 1e-3 * packed[:, 1, 1].mean(), 5)
        self.assertEqual(field(image, "HubHeight"), 90.0)
        self.assertIsNone(field(image, "Period"))

        def axis(name, places, **attributes):
            return {**good, name: Variable(name, np.array(places, float), **{**good[name].attributes, **attributes})}

        def wind(name, dimensions="time z y", change=None, **attributes):
            array = good[name].values if dimensions == "time z y" else np.zeros([lengths.get(d, 3) for d in dimensions.split()])
            array = array.copy()
            if change is not None:
                array[4, 1, 1] = change
            return {**good, name: Variable(dimensions, array, "f4", **attributes)}

        steps = np.arange(20) * 0.05
        for words, parts in (
                ("no variable v", {name: one for name, one in good.items() if name != "v"}),
                ("its axis y has no places", {name: one for name, one in good.items() if name != "y"}),
                ("has the axis y more than once", wind("u", "time y y")),
                ("has the axes time, y, z; they must be time, height, across", wind("u", "time y z")),
                ("has the axes time, z; they must be", wind("w", "time z")),
                ("its axis y must rise; at index 1 25 follows on 25", axis("y", [25, 25, 30])),
                ("its axis z must rise", axis("z", [90, 60, 30])),
                ("its axis time must have even steps; at index 7", axis("time", np.where(steps == steps[7], 0.36, steps))),
                ("its axis z has no number at index 2", axis("z", [1, 2, np.nan])),
                ("its axis z is in feet; it must be in m", axis("z", [1, 2, 3], units="feet")),
                ("its axis time is in hours; it must be in s", axis("time", steps, units="hours since 2000-01-01")),
                ("its variable v is in knots", wind("v", units="knots")),
                ("its v is missing, or no number, at time index 4", wind("v", change=np.nan)),
                ("its w is missing, or no number, at time index 4", wind("w", change=-999.0, missing_value=-999.0))):
            with self.subTest(words):
                self.refused(reader_of("bad.nc", parts), words)
        self.refused(reader_of("bad.nc", good, mean_wind_speed=-3.0), "Mean wind speed")
        reader = reader_of("short.nc", good)
        os.truncate(self.path("short.nc"), os.path.getsize(self.path("short.nc")) - 100)
        self.refused(reader, "cut off")
        self.refused(self.reader("none.nc", b"no netCDF"), "netCDF says of it")
        self.assertEqual(reader.CanReadFile(self.path("none.nc")), 0)

    def test_bad_files(self):
        """One message each."""
        good = bts(random_wind(5, 2, 2))
        for words, content in (("cut off", good[:-1]), ("cut off", good[:40]), ("cut off", b""),
                               ("goes on after its last plane", good + b"x"),
                               ("big-endian", bts(random_wind(5, 2, 2), order=">")),
                               ("it begins with 9", bts(random_wind(5, 2, 2), ident=9)),
                               ("slope", good[:42] + struct.pack("<f", 0.0) + good[46:]),
                               ("Mean wind speed", good[:30] + struct.pack("<f", np.nan) + good[34:]),
                               ("Number of points up", good[:2] + struct.pack("<i", -3) + good[6:]),
                               ("Number of points across", good[:6] + struct.pack("<i", 2**31 - 1) + good[10:])):
            with self.subTest(words):
                self.refused(self.reader("bad.bts", content), words)
        self.refused(littoral.vtkWindFieldReader(), "FileName is empty")
        self.refused(self.reader("nowhere.bts"), "o such file")
        changed = self.reader("wind.bts", good)
        changed.UpdateInformation()
        self.path("wind.bts", bts(random_wind(3, 2, 2)))
        self.refused(changed, "has changed")

    def test_bad_winds(self):
        """One message each, and the file that was there is as it was."""
        values = random_wind(6, 2, 2)
        gust = np.zeros((600, 2, 2, 3), "f4")
        gust[300, 0, 0, 1] = 5.0
        broken = values.copy()
        broken[3, 1, 1, 2] = np.nan
        for words, wind, settings in (("must be finite", broken, {}), ("odd number", values, {"TowerLayers": 1}),
                                      ("TowerLayers", values[:, :, :1], {"TowerLayers": 2}),
                                      ("HubHeight", values, {"HubHeight": 200.0}),
                                      ("HubHeight", values, {"HubHeight": -1.0}),
                                      ("no duration", values[:1], {}),
                                      ("ends in .bts", values, {"FileName": self.path("wind.dat")}),
                                      ("points of a tower", random_wind(6, 3, 2),
                                       {"TowerLayers": 1, "FileName": self.path("wind.hawc")}),
                                      ("even number", values[:5], {"FileName": self.path("wind.wnd")}),
                                      ("beyond its integers", gust, {"FileName": self.path("wind.wnd")}),
                                      ("PlaneOrder", values, {"PlaneOrder": 2})):
            with self.subTest(words):
                source = SlowSource(wind)
                writer = littoral.vtkWindFieldWriter()
                writer.SetInputConnection(source.GetOutputPort())
                writer.SetFileName(self.path("wind.bts", b"old"))
                for key, value in settings.items():
                    getattr(writer, "Set" + key)(value)
                self.refused(writer, words, write=True)
                with open(self.path("wind.bts"), "rb") as file:
                    self.assertEqual(file.read(), b"old")
                self.assertEqual(os.listdir(self.folder), ["wind.bts"])
        writer = littoral.vtkWindFieldWriter()
        writer.SetFileName(self.path("wind.bts"))
        self.refused(writer, "no input", write=True)
        image = vtkImageData()
        image.SetDimensions(3, 3, 3)
        writer.SetInputData(image)
        self.refused(writer, "ConvectionSpeed", write=True)

    def test_iec_turbulence(self):
        """Each layer has the deviation of class and model, in the field and in its file; an event is in the file."""
        source = littoral.vtkWindFieldSource()
        source.SetDimensions(120, 9, 3)
        source.SetBottomHeight(88.0)
        source.SetReferenceHeight(90.0)
        source.SetReferenceSpeed(12.0)
        source.SetSpectrumToIECKaimal()
        source.SetIECClassToA()
        source.NormalizeVarianceOn()
        writer = littoral.vtkWindFieldWriter()
        writer.SetInputConnection(source.GetOutputPort())
        writer.SetFileName(self.path("iec.bts"))
        for model, deviation in ((0, 2.336), (1, 3.5686)):
            source.SetIECTurbulence(model)
            source.Update()
            layers = numbers(source.GetOutput())[..., 0]
            layers = layers - layers.mean(axis=(1, 2), keepdims=True)
            np.testing.assert_allclose(layers.std(axis=(1, 2)), deviation, rtol=1e-3)
            self.assertAlmostEqual(field(source.GetOutput(), "TurbulenceIntensity"), deviation / 12.0, 4)
            self.assertEqual(writer.Write(), 1)
            head, grid, _, _ = read_bts(writer.GetFileName())
            np.testing.assert_allclose((grid[:, 1, :, 0] - 12.0).std(), deviation, rtol=1e-3)
            np.testing.assert_allclose(head[9], 90.0)
        source.SetIECEventToOperatingGust()
        source.SetEventStart(1.0)
        source.SetVeer(5.0)  # degrees/m: 10 degrees to the left below the hub, to the right above it
        self.assertEqual(writer.Write(), 1)
        hub = read_bts(writer.GetFileName())[1][:, 1, 4]
        # 2.4 and 5.3 s after the beginning
        np.testing.assert_allclose(hub[[10, 34, 63], 0] - 12.0, (0.0, -1.585, 4.383), atol=2e-3)
        np.testing.assert_array_equal(abs(hub[:, 1:]) < 1e-3, True)
        layers = read_bts(writer.GetFileName())[1][:, :, 4]
        turns = np.degrees(np.arctan2(layers[..., 1], layers[..., 0]))
        np.testing.assert_allclose(turns, np.broadcast_to((10.0, 0.0, -10.0), turns.shape), atol=0.01)
        source.SetIECClassToNoClass()
        self.refused(source, "IECEvent needs an IECClass")

    def test_wind_of_the_source(self):
        """A Wind Field written and read is the same wind, and periodic; trees take it."""
        source = littoral.vtkWindFieldSource()
        source.SetDimensions(64, 5, 4)
        source.SetWindDirection(30.0)
        writer = littoral.vtkWindFieldWriter()
        writer.SetInputConnection(source.GetOutputPort())
        writer.SetFileName(self.path("wind.bts"))
        self.assertEqual(writer.Write(), 1)
        reader = self.reader("wind.bts", WindDirection=30.0)
        for time in (0.0, 1.7):
            source.UpdateTimeStep(time)
            reader.UpdateTimeStep(time)
            np.testing.assert_allclose(numbers(reader.GetOutput()), numbers(source.GetOutput()), atol=5e-4)
        tree = littoral.vtkReevesTreeSource()
        sway = littoral.vtkBeamTreeDeformationFilter()
        sway.SetInputConnection(0, tree.GetOutputPort())
        sway.SetInputConnection(1, reader.GetOutputPort())
        sway.UpdateTimeStep(1.0)
        self.assertGreater(sway.GetOutputDataObject(0).GetNumberOfPoints(), 0)


if __name__ == "__main__":
    unittest.main()
