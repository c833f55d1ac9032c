# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Currents in files of ocean models, made here byte by byte: places, levels, velocities, drift, land, bad files."""
import os
import sys
import tempfile
import unittest

import littoral
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline

if not hasattr(littoral, "vtkOceanCurrentReader"):
    print("built without the reader of ocean models")
    sys.exit(125)

from classic_netcdf import Variable, write  # noqa: E402
from ocean_files import EAST, NORTH, axis, inverse, mesh, on_earth, regular, roms, times, to_map  # noqa: E402

ORIGIN = (12.5, 54.25)
DAY = 86400.0
RATE = 1.4e-5  # of the rotation [1/s]


def turning(x, y, z, t):
    """A rotation with a uniform current that grows: linear in place and time, so that grids hold it exactly."""
    return -RATE * y + 4e-7 * t + 1e-3 * z, RATE * x + 0.05 + 0.0 * y


class Reading(unittest.TestCase):
    """Tests with a folder of their own."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = os.path.join(self.folder.name, "sea.nc")

    def tearDown(self):
        self.folder.cleanup()

    def reader(self, origin=ORIGIN, **settings):
        reader = littoral.vtkOceanCurrentReader()
        reader.SetFileName(self.path)
        if origin:
            reader.SetGivenOrigin(True)
            reader.SetOrigin(*origin)
        for name, value in settings.items():
            getattr(reader, "Set" + name)(*(value if isinstance(value, tuple) else (value,)))
        return reader

    def refused(self, words, reader=None):
        """One message with the words, and no output."""
        reader = reader or self.reader()
        messages = []

        def listen(_, __, text):
            messages.append(text)
        listen.CallDataType = "string0"
        reader.AddObserver("ErrorEvent", listen)
        reader.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
        reader.Update()
        self.assertEqual(reader.GetOutputDataObject(0).GetNumberOfPoints(), 0)
        self.assertEqual(len(messages), 1, messages)
        self.assertIn(words, messages[0])
        self.assertIn("sea.nc", messages[0])

    def arrays(self, reader, time=0.0):
        """Points and velocities at a time."""
        reader.UpdateTimeStep(time)
        data = reader.GetOutputDataObject(0)
        return (vtk_to_numpy(data.GetPoints().GetData()), vtk_to_numpy(data.GetPointData().GetArray("Velocity")), data)

    def check_flow(self, reader, time, flow=turning, tolerance=2e-7):
        points, velocity, data = self.arrays(reader, time)
        wanted = np.stack(flow(*points.T, time) + (np.zeros(len(points)),), 1)
        np.testing.assert_allclose(velocity, wanted, atol=tolerance)
        return points, data


def dimensions(grid):
    extent = grid.GetExtent()
    return tuple(extent[2 * n + 1] - extent[2 * n] + 1 for n in range(3))


def drift(reader, start, step, end, **settings):
    """Places at the end of points that start at time 0."""
    points = vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(np.asarray(start, float), deep=1))
    cloud = vtkPolyData()
    cloud.SetPoints(points)
    filter_ = littoral.vtkCurrentDriftFilter()
    filter_.SetInputData(0, cloud)
    filter_.AddCurrentConnection(reader.GetOutputPort())
    filter_.SetTimeStep(step)
    for name, value in settings.items():
        getattr(filter_, "Set" + name)(value)
    filter_.UpdateTimeStep(end)
    return vtk_to_numpy(filter_.GetOutputDataObject(0).GetPoints().GetData()).copy()


def integrate(flow, start, step, end):
    """The same by Runge and Kutta's method, here."""
    place = np.array(start, float)

    def speed(p, t):
        u, v = flow(p[:, 0], p[:, 1], p[:, 2], t)
        return np.stack([u * np.ones(len(p)), v * np.ones(len(p)), np.zeros(len(p))], 1)

    for n in range(int(round(end / step))):
        t = n * step
        a = speed(place, t)
        b = speed(place + step / 2 * a, t + step / 2)
        c = speed(place + step / 2 * b, t + step / 2)
        d = speed(place + step * c, t + step)
        place = place + step / 6 * (a + 2 * b + 2 * c + d)
    return place


START = [(6000.0, 3000.0, -4.0), (-9000.0, 1000.0, -6.0), (0.0, -8000.0, -5.0)]


class TestKinds(Reading):
    """Each kind of grid: places, velocities, and a day's drift within 1 m."""

    def check(self, start=START, seconds=DAY, **settings):
        self.check_flow(self.reader(**settings), seconds)
        ends = drift(self.reader(**settings), start, 600.0, DAY)
        wanted = integrate(turning, start, 60.0, DAY)
        self.assertGreater(np.abs(wanted - start).max(), 5000.0)
        self.assertLess(np.linalg.norm(ends - wanted, axis=1).max(), 1.0)

    def test_regular(self):
        lons, lats = ORIGIN[0] + np.linspace(-0.6, 0.6, 13), ORIGIN[1] + np.linspace(-0.35, 0.35, 11)
        regular(self.path, turning, ORIGIN, lons, lats, [0.0, DAY], [2.0, 5.0, 9.0])
        self.check()

    def test_regular_with_axes_that_fall(self):
        lons, lats = ORIGIN[0] - np.linspace(-0.6, 0.6, 13), ORIGIN[1] - np.linspace(-0.35, 0.35, 11)
        regular(self.path, turning, ORIGIN, lons, lats, [0.0, DAY], [9.0, 5.0, 2.0])
        self.check()
        points, data = self.check_flow(self.reader(), 0.0)
        self.assertEqual(dimensions(data), (13, 11, 3))
        self.assertGreater(data.GetCell(0).GetBounds()[5], points[0, 2])
        corner = points.reshape(3, 11, 13, 3)
        self.assertGreater(corner[1, 0, 0, 2], corner[0, 0, 0, 2])
        along, across = corner[0, 0, 1] - corner[0, 0, 0], corner[0, 1, 0] - corner[0, 0, 0]
        turn = along[0] * across[1] - along[1] * across[0]
        self.assertGreater(turn, 0.0)

    def test_surface_alone_holds_at_all_depths(self):
        lons, lats = ORIGIN[0] + np.linspace(-0.6, 0.6, 13), ORIGIN[1] + np.linspace(-0.35, 0.35, 11)
        flat = lambda x, y, z, t: turning(x, y, 0.0, t)
        regular(self.path, flat, ORIGIN, lons, lats, [0.0, DAY])
        ends = drift(self.reader(), START, 600.0, DAY)
        self.assertLess(np.linalg.norm(ends - integrate(flat, START, 60.0, DAY), axis=1).max(), 1.0)

    def test_across_the_date_line(self):
        origin = (180.0, -17.0)
        lons, lats = 180.0 + np.linspace(-0.5, 0.5, 11), origin[1] + np.linspace(-0.35, 0.35, 11)
        regular(self.path, turning, origin, np.where(lons > 180.0, lons - 360.0, lons), lats, [0.0, DAY], [2.0, 9.0])
        self.check(origin=origin)

    def test_roms_by_both_transforms(self):
        for transform, turn in ((1, 0.4), (2, -2.0)):
            def flow(x, y, z, t):
                return turning(x, y, 0.0, t)
            depth = lambda x, y: 60.0 + 1e-3 * x + 2e-3 * y
            surface = lambda x, y, t: 0.4 + 1e-5 * x + 2e-6 * t
            middle = np.array([np.cos(turn) * 16e3 - np.sin(turn) * 14e3, np.sin(turn) * 16e3 + np.cos(turn) * 14e3])
            x, y, z = roms(self.path, flow, ORIGIN, tuple(-middle), turn, 2000.0, (15, 17), [0.0, DAY], depth, surface,
                           transform)
            for n, t in enumerate((0.0, DAY)):
                points, data = self.check_flow(self.reader(), t, flow)
                self.assertEqual(dimensions(data), (15, 13, 6))
                np.testing.assert_allclose(points[:, 2], z[n].ravel(), atol=1e-6)
                np.testing.assert_allclose(points[:195, 0], x.ravel(), atol=1e-3)
                np.testing.assert_allclose(points[:195, 1], y.ravel(), atol=1e-3)
                found = vtk_to_numpy(data.GetPointData().GetArray("Depth"))[:195]
                np.testing.assert_allclose(found, depth(x, y).ravel(), atol=1e-4)
            start = [(4000.0, 3000.0, -20.0), (-5000.0, 1000.0, -5.0)]
            ends = drift(self.reader(), start, 600.0, DAY)
            self.assertLess(np.linalg.norm(ends - integrate(flow, start, 60.0, DAY), axis=1).max(), 1.0)

    def test_roms_without_its_stretching_and_angle(self):
        flat = lambda x, y: 60.0
        level = lambda x, y, t: 0.4
        flow = lambda x, y, z, t: turning(x, y, 0.0, t)
        for drop in ((), ("Cs_r", "angle")):
            _, _, z = roms(self.path, flow, ORIGIN, (-15e3, -15e3), 0.3, 2500.0, (13, 13), [0.0], flat, level,
                           drop=drop)
            points, _ = self.check_flow(self.reader(), 0.0, flow)
            np.testing.assert_allclose(points[:, 2], z.ravel(), atol=1e-6)

    def test_rotated_pole(self):
        pole = (-162.0, 39.25)
        rlon, rlat = np.linspace(-3.5, -2.5, 11), np.linspace(3.0, 3.8, 9)

        def to_earth(a, b):
            """PROJ's and CF's definition by the spherical triangle of both poles."""
            a, b, p = np.radians(a), np.radians(b), np.radians(pole[1])
            lat = np.arcsin(np.sin(b) * np.sin(p) + np.cos(b) * np.cos(a) * np.cos(p))
            lon = np.arctan2(np.cos(b) * np.sin(a), np.sin(p) * np.cos(b) * np.cos(a) - np.cos(p) * np.sin(b))
            return np.degrees(lon) + pole[0] + 180.0, np.degrees(lat)

        a, b = np.meshgrid(rlon, rlat)
        lon, lat = to_earth(a, b)
        origin = (lon.mean(), lat.mean())
        east, north = on_earth(lon, lat, origin, lambda x, y: turning(x, y, 0.0, 0.0))
        # components along the rotated axes: the direction of a small step along them
        ahead = to_earth(a + 1e-5, b)
        angle = np.arctan2(ahead[1] - lat, np.cos(np.radians(lat)) * (ahead[0] - lon))
        u, v = np.cos(angle) * east + np.sin(angle) * north, np.cos(angle) * north - np.sin(angle) * east
        write(self.path, {"rlat": 9, "rlon": 11}, {
            "rotated_pole": Variable("", np.array(0), "i4", grid_mapping_name="rotated_latitude_longitude",
                                     grid_north_pole_latitude=np.array(pole[1]),
                                     grid_north_pole_longitude=np.array(pole[0])),
            "rlon": axis("rlon", rlon, units="degrees", standard_name="grid_longitude"),
            "rlat": axis("rlat", rlat, units="degrees", standard_name="grid_latitude"),
            "u": Variable("rlat rlon", u, "f8", units="m/s", standard_name="sea_water_x_velocity",
                          grid_mapping="rotated_pole"),
            "v": Variable("rlat rlon", v, "f8", units="m/s", standard_name="sea_water_y_velocity",
                          grid_mapping="rotated_pole")})
        points, _ = self.check_flow(self.reader(origin), 0.0, tolerance=1e-6)
        np.testing.assert_allclose(points[:, :2], to_map(lon, lat, origin).reshape(2, -1).T, atol=1e-3)

    def projected(self, mapping, x, y, to_earth, unit="m"):
        """A file on the axes of a map of a flow along them; longitudes and latitudes of its points."""
        a, b = np.meshgrid(x, y)
        lon, lat = to_earth(a, b)
        origin = (lon.mean(), lat.mean())
        east, north = on_earth(lon, lat, origin, lambda x, y: turning(x, y, 0.0, 0.0))
        # components along the map's axes: the direction of a small step along x
        ahead, behind = to_earth(a + 5.0, b), to_earth(a - 5.0, b)
        angle = np.arctan2(ahead[1] - behind[1], np.cos(np.radians(lat)) * (ahead[0] - behind[0]))
        u, v = np.cos(angle) * east + np.sin(angle) * north, np.cos(angle) * north - np.sin(angle) * east
        metres_per_unit = {"m": 1.0, "km": 1000.0}[unit]
        write(self.path, {"y": len(y), "x": len(x)}, {
            "crs": Variable("", np.array(0), "i4", **mapping),
            "x": axis("x", x / metres_per_unit, units=unit, standard_name="projection_x_coordinate"),
            "y": axis("y", y / metres_per_unit, units=unit, standard_name="projection_y_coordinate"),
            "u": Variable("y x", u, "f8", units="m/s", standard_name="sea_water_x_velocity", grid_mapping="crs"),
            "v": Variable("y x", v, "f8", units="m/s", standard_name="sea_water_y_velocity", grid_mapping="crs")})
        return lon, lat, origin

    def test_axes_of_a_map(self):
        """Grid mappings without longitudes and latitudes beside them: Snyder's stereographic map, and maps of spheres."""
        middle, radius = (9.0, 54.0), 6371229.0
        number = {name: np.array(value) for name, value in (
            ("latitude_of_projection_origin", middle[1]), ("longitude_of_projection_origin", middle[0]),
            ("false_easting", 1.0e5), ("semi_major_axis", 6378137.0), ("inverse_flattening", 298.257223563))}
        x, y = 1.0e5 + np.linspace(-9e4, -3e4, 11), np.linspace(7e4, 2e4, 9)  # y falls
        lon, lat, origin = self.projected(dict(grid_mapping_name="stereographic", **number), x, y,
                                          lambda a, b: inverse(a - 1.0e5, b, middle))
        self.assertEqual(self.reader().CanReadFile(self.path), 1)
        points, _ = self.check_flow(self.reader(origin), 0.0, tolerance=1e-6)
        np.testing.assert_allclose(points[:, :2], to_map(lon, lat, origin)[:, ::-1].reshape(2, -1).T, atol=1e-3)
        reader = self.reader(origin, GivenRegion=True, Region=(lon.min(), lon.max(), lat.min(), lat.mean()))
        self.assertLess(self.arrays(reader)[0].shape[0], 99)

        def polar(a, b):
            """True to scale at 70 degrees north, 45 degrees west downwards."""
            k = 0.5 * (1.0 + np.sin(np.radians(70.0)))
            colatitude = 2.0 * np.arctan(np.hypot(a, b) / (2.0 * radius * k))
            return np.degrees(np.arctan2(a, -b)) - 45.0, 90.0 - np.degrees(colatitude)

        def conic(a, b):
            """Lambert's, tangent at 50 degrees, about 10 degrees east, 48 degrees north."""
            n, where = np.sin(np.radians(50.0)), lambda phi: np.tan(np.pi / 4 + np.radians(phi) / 2)
            f = np.cos(np.radians(50.0)) * where(50.0)**n / n
            up = radius * f / where(48.0)**n - b
            phi = 2.0 * np.arctan((radius * f / np.hypot(a, up))**(1.0 / n)) - np.pi / 2
            return 10.0 + np.degrees(np.arctan2(a, up)) / n, np.degrees(phi)

        def numbers(**values):
            return {name: np.array(value) for name, value in values.items()}

        for name, to_earth, unit, mapping in (
                ("polar_stereographic", polar, "km", numbers(
                    standard_parallel=70.0, straight_vertical_longitude_from_pole=-45.0,
                    latitude_of_projection_origin=90.0, earth_radius=radius)),
                ("lambert_conformal_conic", conic, "m", numbers(
                    standard_parallel=50.0, longitude_of_central_meridian=10.0, latitude_of_projection_origin=48.0,
                    earth_radius=radius))):
            lon, lat, origin = self.projected(dict(grid_mapping_name=name, **mapping), np.linspace(4.0e5, 4.6e5, 11),
                                              np.linspace(-3.5e5, -3.0e5, 9), to_earth, unit)
            points, _ = self.check_flow(self.reader(origin), 0.0, tolerance=1e-5)
            np.testing.assert_allclose(points[:, :2], to_map(lon, lat, origin).reshape(2, -1).T, atol=1e-2)
        for words, mapping in {"of a kind that is not read, 'cubed_sphere'": dict(grid_mapping_name="cubed_sphere"),
                               "PROJ does not know the map": dict(crs_wkt="nonsense")}.items():
            self.projected(mapping, x, y, lambda a, b: inverse(a - 1.0e5, b, middle))
            self.refused(words)

    def test_axes_of_two_dimensions(self):
        # as HYCOM's: indices along the axes, and longitudes beyond 360 degrees at each point
        x, y = np.meshgrid(np.linspace(-20e3, 20e3, 9), np.linspace(-18e3, 18e3, 8))
        lon, lat = inverse(x + 0.2 * y, y - 0.1 * x, ORIGIN)
        u, v = on_earth(lon, lat, ORIGIN, lambda a, b: turning(a, b, 0.0, 0.0))
        shapes = dict(coordinates="Longitude Latitude Date", units="m/s")
        write(self.path, {"MT": 1, "Depth": 1, "Y": 8, "X": 9}, {
            "MT": Variable("MT", np.array([43830.0]), "f8", units="days since 1900-12-31 00:00:00", axis="T"),
            "Depth": axis("Depth", [0.0], units="m", positive="down", axis="Z"),
            "Y": Variable("Y", np.arange(1, 9), "i4", axis="Y"), "X": Variable("X", np.arange(1, 10), "i4", axis="X"),
            "Latitude": Variable("Y X", lat, "f8", standard_name="latitude", **NORTH),
            "Longitude": Variable("Y X", lon + 360.0, "f8", standard_name="longitude", **EAST),
            "u": Variable("MT Depth Y X", u[None, None], "f8", standard_name="eastward_sea_water_velocity", **shapes),
            "v": Variable("MT Depth Y X", v[None, None], "f8", standard_name="northward_sea_water_velocity", **shapes)},
              unlimited="MT")
        _, data = self.check_flow(self.reader(), 0.0)
        self.assertEqual(data.GetFieldData().GetAbstractArray("FirstDate").GetValue(0), "2020-12-31T00:00:00Z")

    def test_fvcom(self):
        mesh(self.path, turning, ORIGIN, 20e3, [0.0, DAY], 12.0, 0.5)
        self.check()

    def test_ugrid(self):
        flat = lambda x, y, z, t: turning(x, y, 0.0, t)
        x, y, faces = mesh(self.path, flat, ORIGIN, 20e3, [0.0, DAY], 12.0, 0.0, "ugrid")
        points, data = self.check_flow(self.reader(), DAY, flat)
        np.testing.assert_allclose(points[:, :2], np.stack([x, y], 1), atol=1e-3)
        self.assertEqual(data.GetNumberOfCells(), len(faces))
        ends = drift(self.reader(), START, 600.0, DAY)
        self.assertLess(np.linalg.norm(ends - integrate(flat, START, 60.0, DAY), axis=1).max(), 1.0)



def metres(u, v, land=None, side=100.0, /, **changes):
    """A steady surface current on axes of lengths, as dimensions and variables."""
    shape = np.shape(u)
    u, v = (np.where(land, np.nan, one) if land is not None else one for one in (u, v))
    parts = {"y": axis("y", side * np.arange(shape[0]), units="m", axis="Y"),
             "x": axis("x", side * np.arange(shape[1]), units="m", axis="X"),
             "u": Variable("y x", u, "f8", units="m/s"), "v": Variable("y x", v, "f8", units="m/s")}
    parts.update(changes)
    return {"y": shape[0], "x": shape[1]}, {name: one for name, one in parts.items() if one}


class TestLandAndNumbers(Reading):
    """Land, missing values, packed numbers, units, names and times."""

    def test_land_stops_particles_or_lets_them_slide(self):
        # columns from x = 900 on are land: in the last cell before it u falls as the share of water s = 1 - a/L
        land = np.zeros((12, 11), bool)
        land[:, 9:] = True
        u, v, size = 0.3, 0.4, 100.0
        write(self.path, *metres(np.full(land.shape, u), np.full(land.shape, v), land))
        start, end = [(810.0, 200.0, 0.0)], 1500.0
        left = 90.0 * np.exp(-u * end / size)  # to the land
        ways = {0: v * 90.0 / u * (1.0 - np.exp(-u * end / size)), 1: v * end}
        for coast, way in ways.items():
            place = drift(self.reader(None), start, 5.0, end, Coast=coast)[0]
            np.testing.assert_allclose(place[:2], [900.0 - left, 200.0 + way], atol=1e-4)

    def test_all_marks_of_missing_numbers(self):
        u = np.full((4, 5), 0.25)
        marks = {"_FillValue": -999.0, "missing_value": np.array([1e20, -5e3]), "valid_range": np.array([-5.0, 5.0])}
        stored = u.copy()
        stored[0, 0], stored[0, 1], stored[1, 2], stored[2, 3], stored[3, 4] = -999.0, 1e20, -5e3, 7.0, np.nan
        write(self.path, *metres(stored, u, u=Variable("y x", stored, "f8", units="m/s", **marks)))
        _, velocity, _ = self.arrays(self.reader(None))
        missing = np.isnan(velocity[:, 0]).reshape(4, 5)
        np.testing.assert_array_equal(missing, stored != 0.25)
        stored[stored != 0.25] = 9.969209968386869e36  # of netCDF itself
        write(self.path, *metres(stored, u, u=Variable("y x", stored, "f4", units="m/s")))
        np.testing.assert_array_equal(np.isnan(self.arrays(self.reader(None))[1][:, 0]).reshape(4, 5), missing)

    def test_packed_numbers(self):
        lons, lats = ORIGIN[0] + np.linspace(-0.6, 0.6, 13), ORIGIN[1] + np.linspace(-0.35, 0.35, 11)
        for kind, fill in (("i2", -32767), ("i1", -127)):
            scale = 5e-5 if kind == "i2" else 0.01

            def flow(x, y, z, t):
                return tuple(np.where((x > 30e3) & (y > 10e3), np.nan, one) for one in turning(x, y, 0.0, t))
            regular(self.path, flow, ORIGIN, lons, lats, [0.0], kind=kind, scale_factor=scale, add_offset=0.02,
                    _FillValue=np.array(fill, kind))
            points, velocity, _ = self.arrays(self.reader())
            wanted = np.stack(flow(*points.T, 0.0), 1)
            self.assertGreater(np.isnan(wanted).sum(), 4)
            np.testing.assert_allclose(velocity[:, :2], wanted, atol=0.75 * scale)  # half a step along each axis

    def test_units_and_names(self):
        for unit, one in (("cm s-1", 0.01), ("knots", 1852 / 3600), ("meter second-1", 1.0), ("km/h", 1 / 3.6)):
            u = np.full((3, 4), 2.0)
            dims, parts = metres(u, u, u=None, v=None)
            parts["east"] = Variable("y x", u, "f8", units=unit)
            parts["north"] = Variable("y x", 2 * u, "f8", units=unit)
            write(self.path, dims, parts)
            _, velocity, _ = self.arrays(self.reader(None, UVariable="east", VVariable="north"))
            np.testing.assert_allclose(velocity, np.tile([2 * one, 4 * one, 0.0], (12, 1)), rtol=1e-6)

    def test_times(self):
        lons, lats = ORIGIN[0] + np.linspace(-0.1, 0.1, 3), ORIGIN[1] + np.linspace(-0.1, 0.1, 3)
        regular(self.path, lambda x, y, z, t: (0 * x + t / DAY, 0 * y), ORIGIN, lons, lats, [0.0, DAY, 3 * DAY])
        reader = self.reader(StartDate="2020-01-02T12:00:00Z")
        reader.UpdateInformation()
        info = reader.GetOutputInformation(0)
        self.assertEqual(info.Get(Pipeline.TIME_STEPS()), (-1.5 * DAY, -0.5 * DAY, 1.5 * DAY))
        for time, near in ((-9e9, 0), (-1.1 * DAY, 0), (-0.9 * DAY, 1), (0.6 * DAY, 3), (9e9, 3)):
            self.assertAlmostEqual(self.arrays(reader, time)[1][4, 0], near, 5)

    def test_parts_are_those_of_the_whole(self):
        lons, lats = ORIGIN[0] + np.linspace(-0.6, 0.6, 13), ORIGIN[1] - np.linspace(-0.35, 0.35, 11)
        regular(self.path, turning, ORIGIN, lons, lats, [0.0], [2.0, 5.0, 9.0])
        points, velocity, _ = (np.array(one).reshape(3, 11, 13, 3) if n < 2 else one
                               for n, one in enumerate(self.arrays(self.reader())))
        reader = self.reader()
        reader.UpdateInformation()
        reader.GetOutputInformation(0).Set(Pipeline.UPDATE_EXTENT(), (4, 9, 2, 7, 1, 2), 6)
        reader.Update()
        part = reader.GetOutputDataObject(0)
        self.assertEqual(part.GetExtent(), (4, 9, 2, 7, 1, 2))
        cut = np.s_[1:3, 2:8, 4:10]
        np.testing.assert_array_equal(vtk_to_numpy(part.GetPoints().GetData()), points[cut].reshape(-1, 3))
        own = vtk_to_numpy(part.GetPointData().GetArray("Velocity"))
        np.testing.assert_array_equal(own, velocity[cut].reshape(-1, 3))

    def test_pieces_of_a_mesh(self):
        mesh(self.path, turning, ORIGIN, 20e3, [0.0], 12.0, 0.5)
        points, velocity, whole = self.arrays(self.reader())
        of_place = {tuple(p): tuple(v) for p, v in zip(points, velocity)}
        cells, volume = 0, 0.0
        for piece in range(3):
            reader = self.reader()
            reader.UpdatePiece(piece, 3, 0)
            part = reader.GetOutputDataObject(0)
            cells += part.GetNumberOfCells()
            own = vtk_to_numpy(part.GetPoints().GetData())
            for p, v in zip(own, vtk_to_numpy(part.GetPointData().GetArray("Velocity"))):
                self.assertEqual(of_place[tuple(p)], tuple(v))
            for n in range(part.GetNumberOfCells()):
                wedge = [own[part.GetCell(n).GetPointId(c)] for c in range(6)]
                base = np.cross(wedge[2] - wedge[0], wedge[1] - wedge[0])
                self.assertGreater(base @ (wedge[3] - wedge[0]), 0.0)  # as VTK wants wedges
                volume += base[2] / 2 * (wedge[3] - wedge[0])[2]
        self.assertEqual(cells, whole.GetNumberOfCells())
        self.assertAlmostEqual(volume / (40e3 ** 2 * 12.5 * 3 / 4), 1.0, 6)

    def test_region_around_the_earth(self):
        lons, lats = np.arange(0.0, 360.0, 5.0), np.arange(-80.0, 81.0, 5.0)
        u = np.broadcast_to(np.cos(np.radians(lons)), (len(lats), len(lons)))
        dims, parts = {"lat": len(lats), "lon": len(lons)}, {
            "lat": axis("lat", lats, **NORTH), "lon": axis("lon", lons, **EAST),
            "u": Variable("lat lon", u, "f8", units="m/s"), "v": Variable("lat lon", 0 * u, "f8", units="m/s")}
        write(self.path, dims, parts)
        self.refused("Give a Region: cannot read sea.nc, its grid reaches 90 degrees", self.reader(None))
        reader = self.reader(None, GivenRegion=True, Region=(-11.0, 16.0, -1.0, 21.0))
        points, velocity, grid = self.arrays(reader)
        self.assertEqual(dimensions(grid), (6, 5, 1))
        middle = to_map(np.arange(-10.0, 16.0, 5.0), 0.0, (2.5, 10.1))[0]
        self.assertLess(np.abs(points[:6, 0] - middle).max(), 0.02 * 1.5e6)
        self.assertTrue((np.diff(points.reshape(5, 6, 3)[:, :, 0], axis=1) > 4e5).all())
        # at the equator eastward velocities are those on earth but for the scale of the map, within r^2/4R^2
        speed = np.linalg.norm(velocity[:6], axis=1) / np.cos(np.radians(np.arange(-10.0, 16.0, 5.0)))
        self.assertTrue(((speed > 1.0) & (speed < 1.02)).all(), speed)

    def test_other_program_and_format(self):
        try:
            from osgeo import gdal
        except ImportError:
            self.skipTest("GDAL's Python module is absent")
        lons, lats = ORIGIN[0] + np.linspace(-0.6, 0.6, 13), ORIGIN[1] - np.linspace(-0.35, 0.35, 11)
        regular(self.path, turning, ORIGIN, lons, lats, [0.0, DAY], [2.0, 9.0])
        points, velocity, _ = self.arrays(self.reader(), DAY)
        classic, self.path = self.path, os.path.join(self.folder.name, "hdf5.nc")
        gdal.UseExceptions()
        gdal.MultiDimTranslate(self.path, classic, format="netCDF", creationOptions=["FORMAT=NC4"])
        with open(self.path, "rb") as file:
            self.assertEqual(file.read(4), b"\x89HDF")
        other, same, _ = self.arrays(self.reader(), DAY)
        np.testing.assert_array_equal(other, points)
        np.testing.assert_array_equal(same, velocity)

    def test_kelp_bends_as_in_a_uniform_flow(self):
        u = np.full((2, 2), 0.3)
        sides = {name: axis(name, [-50.0, 50.0], units="m") for name in "xy"}
        write(self.path, *metres(u, 0 * u, **sides))
        uniform = littoral.vtkFlowPrimitiveSource()
        uniform.SetFlowTypeToUniform()
        uniform.SetAxis(1.0, 0.0, 0.0)
        uniform.SetStrength(0.3)
        ends = []
        for current in (None, self.reader(None), uniform):
            kelp, sea = littoral.vtkSeaweedSource(), littoral.vtkSeaStateSource()
            sea.SetWaterDepth(10.0)
            sea.SetSeaLevel(10.0)
            bend = littoral.vtkSeaweedDeformationFilter()
            bend.SetInputConnection(0, kelp.GetOutputPort())
            bend.SetInputConnection(1, sea.GetOutputPort())
            bend.SetTimeStep(0.05)
            if current:
                bend.AddCurrentConnection(current.GetOutputPort())
            bend.UpdateTimeStep(1.0)
            leaves = bend.GetOutputDataObject(0).NewIterator()
            leaves.InitTraversal()
            ends.append(vtk_to_numpy(leaves.GetCurrentDataObject().GetPoints().GetData()))
        np.testing.assert_allclose(ends[1], ends[2], atol=1e-5)
        self.assertGreater(np.abs(ends[1] - ends[0]).max(), 0.02)

    def test_arrows(self):
        land = np.zeros((21, 41), bool)
        land[:, 30:] = True
        write(self.path, *metres(np.full(land.shape, 0.3), np.full(land.shape, 0.4), land))
        reader, arrows = self.reader(None), littoral.vtkFlowArrowFilter()
        arrows.SetInputConnection(reader.GetOutputPort())
        arrows.SetArrowsAlong(20)
        arrows.Update()
        drawn = arrows.GetOutput()
        np.testing.assert_allclose(vtk_to_numpy(drawn.GetPointData().GetArray("Speed")), 0.5, rtol=1e-6)
        one = littoral.vtkFlowArrowFilter()
        one.SetInputConnection(reader.GetOutputPort())
        one.SetArrowsAlong(1)
        one.Update()
        # the water is 2900 x 2000 m: cells of 145 m
        self.assertEqual(drawn.GetNumberOfPoints() / one.GetOutput().GetNumberOfPoints(), 20 * 14)
        points = vtk_to_numpy(drawn.GetPoints().GetData())
        self.assertLess(points[:, 0].max(), 3000.0)

    def test_vertical_velocities_and_coasts_of_c_grids(self):
        # w lies between the levels; sides of a cell on the coast that are missing have no flow
        up = np.broadcast_to(np.arange(7.0)[None, :, None, None], (1, 7, 7, 7))
        land = np.zeros((7, 7), bool)
        land[:, 4:] = True
        east = np.ones((1, 6, 7, 6))
        east[..., 3:] = np.nan
        roms(self.path, lambda x, y, z, t: (0 * x, 0 * y), ORIGIN, (-15e3, -15e3), 0.0, 5000.0, (7, 7), [0.0],
             lambda x, y: 60.0, lambda x, y, t: 0.0, land=land,
             w=Variable("ocean_time s_w eta_rho xi_rho", up, "f8", units="m/s"),
             u=Variable("ocean_time s_rho eta_u xi_u", east, "f8", units="m/s", _FillValue=np.array(np.nan)))
        velocity = self.arrays(self.reader())[1].reshape(6, 5, 5, 3)
        for k in range(6):
            np.testing.assert_allclose(velocity[k, :, :3, 2], k + 0.5, rtol=1e-6)
        np.testing.assert_allclose(velocity[:, :, :2, 0], 1.0, rtol=1e-3)
        np.testing.assert_allclose(velocity[:, :, 2, 0], 0.5, rtol=1e-3)
        self.assertTrue(np.isnan(velocity[:, :, 3:]).all())


class TestBadFiles(Reading):
    """One message each, and nothing half read."""

    def good(self, **changes):
        """A good file of levels and times, but for some variables."""
        dims = {"time": 2, "depth": 2, "lat": 3, "lon": 4}
        flow = np.zeros((2, 2, 3, 4))
        parts = {"time": times([0.0, 3600.0]), "depth": axis("depth", [1.0, 5.0], units="m", positive="down"),
                 "lat": axis("lat", [50.0, 51.0, 52.0], **NORTH), "lon": axis("lon", [1.0, 2.0, 3.0, 4.0], **EAST),
                 "u": Variable("time depth lat lon", flow, "f4", units="m/s"),
                 "v": Variable("time depth lat lon", flow, "f4", units="m/s")}
        parts.update(changes)
        write(self.path, dims, {name: one for name, one in parts.items() if one})

    def test_axes_and_times(self):
        self.good()
        self.assertEqual(self.reader().CanReadFile(self.path), 1)
        self.assertEqual(len(self.arrays(self.reader())[0]), 24)
        nan = float("nan")
        for words, changes in {
                "no variables of it are known as velocities": dict(u=None),
                "the places of its u are missing": dict(lat=None),
                "the times of its axis 'time' are missing": dict(time=None),
                "the levels of its axis 'depth' are missing": dict(depth=None),
                "its axis lon repeats 2, as number 3": dict(lon=axis("lon", [1.0, 2.0, 2.0, 4.0], **EAST)),
                "its axis lat turns back at number 3": dict(lat=axis("lat", [50.0, 51.0, 50.5], **NORTH)),
                "its lon has a gap: number 2": dict(lon=axis("lon", [1.0, nan, 3.0, 4.0], **EAST)),
                "its axis depth repeats 1": dict(depth=axis("depth", [1.0, 1.0], units="m", positive="down")),
                "is not after the one before it": dict(time=times([5.0, 5.0])),
                "number 2 of its times time is missing": dict(time=times([5.0, nan])),
                "is no unit of times": dict(time=times([0.0, 1.0], "fortnights since 2000-01-01")),
                "has no length": dict(time=times([0.0, 1.0], "months since 2000-01-01")),
                "its calendar 'mayan'": dict(time=times([0.0, 1.0], calendar="mayan")),
                "the unit 'furlongs' of its levels depth is no length": dict(
                    depth=axis("depth", [1.0, 5.0], units="furlongs")),
                "the unit 'kg' of its u is none of velocities": dict(
                    u=Variable("time depth lat lon", np.zeros((2, 2, 3, 4)), "f4", units="kg")),
                "two axes of its variable u are of the same kind": dict(
                    depth=axis("depth", [1.0, 5.0], units="seconds since 2000-01-01")),
                "have other axes": dict(v=Variable("time lat lon", np.zeros((2, 3, 4)), "f4", units="m/s"))}.items():
            self.good(**changes)
            self.refused(words)

    def test_levels_without_their_terms(self):
        flat = lambda x, y: 60.0
        level = lambda x, y, t: 0.4
        flow = lambda x, y, z, t: (0 * x, 0 * y)
        for words, drop in {"lack their term 'depth'": ("h",), "lack their term 'eta'": ("zeta",),
                            "lack their term 'depth_c'": ("hc",), "lack their term 'C'": ("Cs_r", "theta_s")}.items():
            roms(self.path, flow, ORIGIN, (-15e3, -15e3), 0.3, 5000.0, (7, 7), [0.0], flat, level, drop=drop)
            self.refused(words)
        kind = Variable("s_rho", np.linspace(-0.9, -0.1, 6), "f8", standard_name="ocean_double_sigma_coordinate")
        roms(self.path, flow, ORIGIN, (-15e3, -15e3), 0.3, 5000.0, (7, 7), [0.0], flat, level, s_rho=kind)
        self.refused("")

    def test_files_that_are_not_whole(self):
        self.good()
        with open(self.path, "rb") as file:
            whole = file.read()
        for words, content in {"it is cut off": whole[:-40], "it is cut off: 60 bytes": whole[:60],
                               "netCDF says of it": b"CDF\x02" + whole[4:60][::-1] + whole[60:],
                               "netCDF": b"text\n"}.items():
            with open(self.path, "wb") as file:
                file.write(content)
            self.refused(words)
            self.assertEqual(self.reader().CanReadFile(self.path), 0)
        os.remove(self.path)
        self.refused("No such file")

    def test_file_that_changes(self):
        self.good()
        reader = self.reader()
        reader.UpdateInformation()
        write(self.path, *metres(np.zeros((7, 7)), np.zeros((7, 7))))
        self.refused("it has changed since it was opened", reader)
        self.good()
        reader = self.reader()
        reader.AddObserver("ProgressEvent", lambda *_: os.utime(self.path, (1e9, os.stat(self.path).st_mtime - 9)))
        self.refused("it changed while it was read", reader)

    def test_properties(self):
        self.good()
        for words, settings in {"it has no variable 'speed'": dict(UVariable="speed", VVariable="v"),
                                "go together": dict(UVariable="u"), "is no date": dict(StartDate="soon"),
                                "Origin": dict(Origin=(0.0, 91.0)), "no points in the Region": dict(GivenRegion=True),
                                "VectorDirections": dict(VectorDirections=3)}.items():
            self.refused(words, self.reader(**settings))


if __name__ == "__main__":
    unittest.main()
