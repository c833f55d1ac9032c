# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A terrain clipped to its catchment, missing heights around it: what is outside is left out, and ends no work."""

import json
import struct
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import littoral
from littoral import errors
from littoral.elevation import array_from_image, image_from_array
from TestFiles import InFolder
from TestPlaces import points_at

ROWS, COLUMNS, STEP = 40, 50, 10.0
Y, X = np.mgrid[0:ROWS, 0:COLUMNS] * STEP
OUTSIDE = np.hypot(X - 240.0, Y - 190.0) > 150.0
HEIGHTS = np.where(OUTSIDE, np.nan, 300.0 + 0.1 * X + 5.0 * np.sin(Y / 40.0))


def catchment(heights=HEIGHTS):
    return image_from_array(heights, (STEP, STEP))


class Holes(InFolder):
    def update(self, made):
        messages = errors.kept(made)
        made.Update()
        self.assertEqual(messages, [])
        return made.GetOutputDataObject(0)

    @unittest.skipUnless(hasattr(littoral, "vtkGLTFSceneWriter"), "built without tinygltf")
    def test_scene_file(self):
        """Quads of the mesh are those whose four corners have a height, and no point is anywhere else."""
        drained = littoral.vtkDrainageFilter()
        drained.CarveOff()
        drained.SetInputData(catchment())
        for image in (catchment(), self.update(drained)):
            writer = littoral.vtkGLTFSceneWriter()
            writer.SetFileName(self.path("catchment.glb"))
            writer.AddInputDataObject(0, image)
            messages = errors.kept(writer)
            self.assertEqual((writer.Write(), messages), (1, []))
            with open(self.path("catchment.glb"), "rb") as file:
                content = file.read()
            length, = struct.unpack_from("<I", content, 12)
            scene = json.loads(content[20:20 + length])
            mesh = scene["meshes"][0]["primitives"][0]
            corners = [~OUTSIDE[j:ROWS - 1 + j, i:COLUMNS - 1 + i] for i in (0, 1) for j in (0, 1)]
            quads = np.logical_and.reduce(corners)
            used = np.zeros((ROWS, COLUMNS), bool)
            for i in (0, 1):
                for j in (0, 1):
                    used[j:ROWS - 1 + j, i:COLUMNS - 1 + i] |= quads
            self.assertEqual(scene["accessors"][mesh["indices"]]["count"], 6 * quads.sum())
            places = scene["accessors"][mesh["attributes"]["POSITION"]]
            self.assertEqual(places["count"], used.sum())
            bounds = np.array([places["min"], places["max"]])
            self.assertTrue(np.isfinite(bounds).all())
            self.assertAlmostEqual(np.ptp(bounds, 0).max(), np.ptp(X[used]), delta=1e-3)

    def test_preferences(self):
        """Sites in holes are left out, sites beside the terrain are a mistake."""
        x, y = np.random.default_rng(3).uniform(0.0, 390.0, (2, 400))
        made = littoral.vtkSitePreferenceFilter()
        made.SetInputData(0, points_at(x, y))
        made.SetInputData(1, catchment())
        kept = vtk_to_numpy(self.update(made).GetPoints().GetData())
        self.assertLess(np.hypot(kept[:, 0] - 240.0, kept[:, 1] - 190.0).max(), 150.0)
        inside = np.hypot(x - 240.0, y - 190.0) < 150.0 - 1.5 * STEP
        ids = set(vtk_to_numpy(made.GetOutput().GetPointData().GetArray("SiteId")).tolist())
        self.assertGreater(len(ids & set(np.flatnonzero(inside).tolist())), 0.9 * inside.sum())
        made.SetInputData(0, points_at([900.0], [10.0]))
        messages = errors.kept(made)
        made.Update()
        self.assertRegex(messages[0], "lies outside of the Terrain")

    def test_intensity(self):
        """Points of an image with holes: none there, and the intensity of the process is the mean of what is there."""
        intensity = np.where(OUTSIDE, np.nan, 1.0 + (X > 240.0))
        made = littoral.vtkPointProcessSource()
        made.SetInputData(1, catchment(intensity))
        made.SetIntensityArray("Elevation")
        made.SetOrigin(-5.0, -5.0)
        made.SetSize(COLUMNS * STEP, ROWS * STEP)
        made.SetIntensity(0.05)
        points = vtk_to_numpy(self.update(made).GetPoints().GetData())
        cell = np.floor((points[:, :2] + 5.0) / STEP).astype(int)
        self.assertFalse(OUTSIDE[cell[:, 1], cell[:, 0]].any())
        expected = 0.05 * (~OUTSIDE).sum() * STEP**2
        self.assertAlmostEqual(len(points), expected, delta=5.0 * expected**0.5)
        east = (points[:, 0] > 245.0).sum()
        cells = (~OUTSIDE & (X > 240.0)).sum(), (~OUTSIDE).sum()
        share = 2.0 * cells[0] / (cells[0] + cells[1])
        self.assertAlmostEqual(east / len(points), share, delta=5.0 * (share * (1 - share) / len(points)) ** 0.5)

    def test_levels_with_rivers(self):
        """Terrain in levels takes what Drainage makes of a catchment."""
        drained, levels = littoral.vtkDrainageFilter(), littoral.vtkTerrainLevelOfDetailFilter()
        drained.CarveOff()
        drained.SetInputData(catchment())
        image = self.update(drained)
        self.assertEqual(np.isnan(array_from_image(image)).tolist(), OUTSIDE.tolist())
        levels.SetInputData(image)
        levels.UseCullingOff()
        blocks = self.update(levels)
        self.assertGreater(sum(blocks.GetBlock(k).GetNumberOfPoints() for k in range(blocks.GetNumberOfBlocks())), 500)


if __name__ == "__main__":
    unittest.main()
