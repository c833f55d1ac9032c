# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Measured places drained by tiles: each cell as in the whole grid, in whole metres with flats too; all water leaves."""

import os
import sys
import unittest

import matplotlib
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from littoral import vtkDrainageFilter
from littoral.elevation import image_from_array

sys.path.insert(0, os.path.join(os.environ["LITTORAL_SOURCE_DIR"], "Testing", "Landscapes"))
import places  # noqa: E402

ARRAYS = "Elevation", "DrainageArea", "FlowDirection", "DepressionDepth"


def drained(image, tile):
    drainage = vtkDrainageFilter()
    drainage.SetInputData(image)
    drainage.CarveOff()
    drainage.SetTileSize(tile)
    drainage.Update()
    points = drainage.GetOutput().GetPointData()
    return [vtk_to_numpy(points.GetArray(name)) for name in ARRAYS]


def place(name):
    """Heights [m] and spacings [m] of a place; topobathy is the earth with its seas, of matplotlib, as if it were flat."""
    if name != "topobathy":
        return places.place(name)
    sample = os.path.join(matplotlib.get_data_path(), "sample_data", "topobathy.npz")
    return np.load(sample)["topo"].astype(float), (1e5, 1e5)


class TiledPlaces(unittest.TestCase):
    def test_cells_are_those_of_the_whole(self):
        for name in "jacksboro", "topobathy", "volcano", "olinda":
            with self.subTest(place=name):
                try:
                    heights, spacing = place(name)
                except RuntimeError as reason:
                    self.skipTest(str(reason))
                image = image_from_array(np.floor(heights), spacing)
                whole, tiled = drained(image, 0), drained(image, 37)
                for one, other in zip(whole, tiled):
                    np.testing.assert_array_equal(one, other)
                _, areas, ways, depths = tiled
                self.assertAlmostEqual(areas[ways < 0].sum() / (spacing[0] * spacing[1] * heights.size), 1.0, places=12)
                self.assertGreater((depths > 0.0).sum(), 0)


if __name__ == "__main__":
    unittest.main()
