# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Water of a landscape on a straight valley: one brook along its floor, wet ground beside it, bands on the ground."""

import unittest

import numpy as np

from littoral.elevation import image_from_array
from littoral.gallery import brooks

#: Cells [m], columns and rows; the floor of the valley is in the middle column and falls towards y = 0.
CELL, COLUMNS, ROWS = 10.0, 41, 80
FLOOR = CELL * (COLUMNS // 2)


def valley():
    y, x = np.mgrid[0:ROWS, 0:COLUMNS] * CELL
    return 100.0 + 0.2 * np.abs(x - FLOOR) + 0.02 * y


class Brooks(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.z = valley()
        cls.water = brooks.Water(image_from_array(cls.z, (CELL, CELL)))

    def test_the_brook_runs_along_the_floor(self):
        longest = max(self.water.courses, key=lambda course: len(course[0]))
        places, areas = longest
        self.assertLess(np.abs(places[:, 0] - FLOOR).max(), 1e-9)
        self.assertTrue((np.diff(places[:, 1]) < 0.0).all())
        self.assertTrue((np.diff(areas) >= 0.0).all())
        self.assertGreaterEqual(areas[0], brooks.LEAST_AREA - CELL**2)
        # nearly all of the inner cells drain through its lower end
        self.assertGreater(areas[-1], 0.7 * CELL**2 * COLUMNS * ROWS)

    def test_widths(self):
        self.assertEqual(brooks.width_of(brooks.METRE_AREA), 1.0)
        self.assertAlmostEqual(brooks.width_of(32.0 * brooks.METRE_AREA), 2.0 ** (5.0 * brooks.WIDTH_EXPONENT))

    def test_ground_is_wet_along_the_floor_and_under_water_there_alone(self):
        rows = slice(10, 60)
        wet = self.water.wetness[rows]
        self.assertTrue((wet.argmax(axis=1) == COLUMNS // 2).all())
        self.assertGreater((wet[:, COLUMNS // 2] - wet[:, 5]).min(), 2.0)
        cover = self.water.cover[rows]
        self.assertTrue((cover[:, COLUMNS // 2] > 0.0).all() and (cover < 1.0).all())
        self.assertEqual(np.delete(cover, COLUMNS // 2, axis=1).max(), 0.0)

    def test_distance_to_the_bank(self):
        places = np.array(((FLOOR, 200.0), (FLOOR + 30.0, 200.0)))
        in_water, beside = self.water.distance_to(places)
        self.assertLess(in_water, 0.0)
        self.assertAlmostEqual(beside, 30.0 + in_water, places=1)

    def test_bands_lie_on_the_ground(self):
        def height(x, y):
            return 100.0 + 0.2 * np.abs(x - FLOOR) + 0.02 * y

        points, triangles = brooks.bands(self.water.courses, height, (FLOOR, 300.0), 1000.0)
        self.assertLess(np.abs(points[:, 2] - height(points[:, 0], points[:, 1]) - 0.25).max(), 1e-9)
        self.assertEqual(triangles.max(), len(points) - 1)
        a, b, c = (points[triangles[:, k], :2] for k in range(3))
        turn = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]
        self.assertTrue((turn > 0.0).all() or (turn < 0.0).all())  # no band folds over itself
        self.assertEqual(len(brooks.bands(self.water.courses, height, (FLOOR, 1e6), 1000.0)[0]), 0)

    def test_dry_ground_has_no_brooks(self):
        y, x = np.mgrid[0:12, 0:12] * CELL
        water = brooks.Water(image_from_array(100.0 + 0.1 * x + 0.07 * y, (CELL, CELL)))
        self.assertEqual((water.courses, water.cover.max()), ([], 0.0))
        self.assertEqual(water.distance_to(np.zeros((1, 2)))[0], np.inf)


if __name__ == "__main__":
    unittest.main()
