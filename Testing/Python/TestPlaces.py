# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Places in degrees are taken for metres by no class: refused with one message, where the same places as metres are not."""

import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData, vtkRectilinearGrid

import littoral
from littoral import errors
from littoral.elevation import image_from_array

METRES_PER_DEGREE = 111320.0
RANDOM = np.random.default_rng(5)


def points_at(x, y, z=None, **arrays):
    """Points of coordinates, with point arrays."""
    made, places = vtkPolyData(), vtkPoints()
    places.SetDataTypeToDouble()
    places.SetData(numpy_to_vtk(np.column_stack([x, y, np.zeros(len(x)) if z is None else z]), deep=True))
    made.SetPoints(places)
    for name, values in arrays.items():
        array = numpy_to_vtk(np.asarray(values, float), deep=True)
        array.SetName(name)
        made.GetPointData().AddArray(array)
        made.GetPointData().SetActiveScalars(name)
    return made


def current(x, y, uneven=False):
    """A steady current of 0.5 m/s to the east on a grid."""
    if uneven:
        grid = vtkRectilinearGrid()
        grid.SetXCoordinates(numpy_to_vtk(np.asarray(x, float), deep=True))
        grid.SetYCoordinates(numpy_to_vtk(np.asarray(y, float), deep=True))
        grid.SetZCoordinates(numpy_to_vtk(np.zeros(1), deep=True))
    else:
        grid = vtkImageData()
        grid.SetOrigin(x[0], y[0], 0.0)
        grid.SetSpacing(x[1] - x[0], y[1] - y[0], 1.0)
    grid.SetDimensions(len(x), len(y), 1)
    velocity = numpy_to_vtk(np.tile([0.5, 0.0, 0.0], (len(x) * len(y), 1)), deep=True)
    velocity.SetName("Velocity")
    grid.GetPointData().AddArray(velocity)
    return grid


class Places(unittest.TestCase):
    def run_one(self, made, *ports):
        """Messages of an algorithm with inputs."""
        for port, data in enumerate(ports):
            if data is not None:
                adds = port == 1 and hasattr(made, "AddInputData")
                (made.AddInputData if adds else made.SetInputData)(port, data)
        messages = errors.kept(made)
        made.Update()
        return messages

    def refuses(self, made, *ports):
        messages = self.run_one(made, *ports)
        self.assertEqual(len(messages), 1, messages)
        self.assertRegex(messages[0], "which look like degrees: project it to metres, or move it to the origin")

    def takes(self, made, *ports):
        self.assertEqual(self.run_one(made, *ports), [])

    def drift(self):
        made = littoral.vtkCurrentDriftFilter()
        made.SetTimeStep(20.0)
        made.SetKeepInWater(False)
        return made

    def test_currents(self):
        x, y = np.linspace(3.0, 7.0, 41), np.linspace(56.0, 60.0, 41)
        drifters = points_at([5.05], [58.0])
        self.refuses(self.drift(), drifters, current(x, y))
        self.refuses(self.drift(), drifters, current(-70.0 + 0.5 * np.arange(20), 20.0 + 0.5 * np.arange(20), True))
        self.refuses(self.drift(), drifters, current(np.arange(0.0, 360.0), np.arange(-75.0, 90.0), True))
        self.takes(self.drift(), drifters, current(METRES_PER_DEGREE * x, METRES_PER_DEGREE * y))
        self.takes(self.drift(), points_at([2.0], [2.0]), current(x - x[0], y - y[0]))  # a flume

    def test_surveys(self):
        x, y, z = RANDOM.uniform(-80.0, -60.0, 40), RANDOM.uniform(20.0, 40.0, 40), RANDOM.uniform(200.0, 900.0, 40)

        def terrain():
            made = littoral.vtkConditionalTerrainFilter()
            made.SetModel(1)
            made.SetNumberOfLines(8)
            return made
        self.refuses(terrain(), points_at(x, y, z))
        self.refuses(terrain(), points_at(x, y, Elevation=z))
        self.takes(terrain(), points_at(METRES_PER_DEGREE * x, METRES_PER_DEGREE * y, z))
        self.takes(terrain(), points_at(x, y, 0.01 * z))  # lower than wide: some of a plot

    def test_points(self):
        x, y = 11.5 + 0.002 * RANDOM.random(60), 48.1 + 0.001 * RANDOM.random(60)
        metres = (x - 11.5) * 74000.0, (y - 48.1) * METRES_PER_DEGREE
        tree = littoral.vtkReevesTreeSource()
        tree.SetPreset(tree.Shrub)
        tree.Update()
        ground = image_from_array(RANDOM.random((20, 20)), (10.0, 10.0))
        for name, others in (("vtkPointPatternStatisticsFilter", ()), ("vtkPatternVerdictFilter", ()),
                             ("vtkPlantScatterFilter", (tree.GetOutputDataObject(0),)),
                             ("vtkSitePreferenceFilter", (ground,))):
            with self.subTest(name):
                self.refuses(getattr(littoral, name)(), points_at(x, y), *others)
                if name != "vtkPatternVerdictFilter":  # which takes seconds
                    self.takes(getattr(littoral, name)(), points_at(*metres), *others)

    def test_turned_images(self):
        """What takes rows to run along x refuses an image with a direction matrix; what does not puts out its place."""
        turned = image_from_array(10.0 + RANDOM.random((20, 30)), (2.0, 2.0))
        turned.SetDirectionMatrix(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0)
        tree = littoral.vtkReevesTreeSource()
        tree.SetPreset(tree.Shrub)
        tree.Update()
        sites = points_at([-5.0, -9.0, -20.0], [5.0, 9.0, 20.0], [1.0, 2.0, 4.0])
        for name, ports in (("vtkTerrainLevelOfDetailFilter", (turned,)), ("vtkCovarianceFitFilter", (turned,)),
                            ("vtkConditionalTerrainFilter", (sites, turned)), ("vtkSitePreferenceFilter", (sites, turned)),
                            ("vtkPlantScatterFilter", (sites, tree.GetOutputDataObject(0), turned)),
                            ("vtkPointProcessSource", (None, turned))):
            with self.subTest(name):
                made = getattr(littoral, name)()
                if name == "vtkConditionalTerrainFilter":
                    made.SetModel(1)
                messages = self.run_one(made, *ports)
                self.assertEqual(len(messages), 1, messages)
                self.assertRegex(messages[0], "is turned by its direction matrix; resample it")
        drained = littoral.vtkDrainageFilter()
        self.takes(drained, turned)
        self.assertEqual(drained.GetOutput().GetBounds(), turned.GetBounds())
        np.testing.assert_array_less(turned.GetBounds()[0] - 1e-9, drained.GetOutputDataObject(1).GetBounds()[0])

    def test_names_and_georeferences(self):
        """Arrays with the coordinates name them, whatever their numbers; a georeference ends all doubt."""
        x, y = RANDOM.uniform(0.0, 20.0, 60), RANDOM.uniform(0.0, 20.0, 60)
        self.refuses(littoral.vtkPointPatternStatisticsFilter(), points_at(x, y, Lon=x, Lat=y))
        self.takes(littoral.vtkPointPatternStatisticsFilter(), points_at(x, y, Lon=x + 1.0, Lat=y))
        grid = current(np.linspace(3.0, 7.0, 41), np.linspace(56.0, 60.0, 41))
        named = vtkStringArray()
        named.SetName("CoordinateSystem")
        named.InsertNextValue("LOCAL")
        grid.GetFieldData().AddArray(named)
        self.takes(self.drift(), points_at([5.0], [58.0]), grid)


if __name__ == "__main__":
    unittest.main()
