# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The country of the forests: its trees stand on the ground, off the brooks, more of them where it is steeper."""

import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkProbeFilter

from littoral.elevation import array_from_image
from littoral.gallery.country import BROOK, WOODS, jacksboro, wood_sites

#: Two trees that stand alone: positions [m] and species.
ALONE = np.array(((5000.0, 5000.0), (5200.0, 5000.0))), np.array((3, 1))


class Country(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.terrain = jacksboro(1).GetOutput()
        sites = wood_sites(cls.terrain, 20.0, ALONE)
        cls.places = vtk_to_numpy(sites.GetPoints().GetData()).astype(float)
        cls.species = vtk_to_numpy(sites.GetPointData().GetArray("Species"))
        level, probe = vtkPolyData(), vtkProbeFilter()
        level.CopyStructure(sites)
        cls.height = cls.places[:, 2].copy()
        places = vtk_to_numpy(level.GetPoints().GetData())
        places[:, 2] = 0.0  # where the image is
        probe.SetInputData(level)
        probe.SetSourceData(cls.terrain)
        probe.Update()
        cls.probed = {name: vtk_to_numpy(probe.GetOutput().GetPointData().GetArray(name))
                      for name in ("Elevation", "DrainageArea")}

    def test_trees_stand_on_the_ground(self):
        self.assertLess(np.abs(self.height - self.probed["Elevation"]).max(), 0.01)
        low, high = self.places[:, :2].min(axis=0), self.places[:, :2].max(axis=0)
        self.assertTrue((low >= WOODS[0]).all() and (high <= np.add(*WOODS)).all())

    def test_no_tree_stands_in_a_brook(self):
        self.assertLess(self.probed["DrainageArea"][:-2].max(), BROOK)

    def test_trees_alone_have_room(self):
        np.testing.assert_allclose(self.places[-2:, :2], ALONE[0])
        self.assertEqual(self.species[-2:].tolist(), [3, 1])
        for place in ALONE[0]:
            self.assertGreater(np.hypot(*(self.places[:-2, :2] - place).T).min(), 25.0)

    def test_woods_are_on_slopes(self):
        z, spacing = array_from_image(self.terrain).astype(float), np.array(self.terrain.GetSpacing()[:2])
        slope = np.degrees(np.arctan(np.hypot(*np.gradient(z, *spacing[::-1]))))
        column, row = (self.places[:, :2] / spacing).astype(int).T
        first, last = (np.array(corner) // spacing for corner in (WOODS[0], np.add(*WOODS)))
        part = slope[int(first[1]):int(last[1]), int(first[0]):int(last[0])]

        def density(low, high):
            return np.count_nonzero((slope[row, column] >= low) & (slope[row, column] < high)) / np.count_nonzero(
                (part >= low) & (part < high))

        self.assertGreater(density(15.0, 25.0), 2.0 * density(0.0, 5.0))
        self.assertEqual(set(self.species), {0, 1, 2, 3})


if __name__ == "__main__":
    unittest.main()
