# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: python3 tier=all
"""A forest as 3D Tiles: its files by Khronos' validator of glTF, and the page of the examples, which opens it by CesiumJS
on its place on earth, in Chromium, where there is one. Needs node and two packages: `npm install cesium gltf-validator`
somewhere; LITTORAL_CESIUM names the folder that they are in, node_modules."""

import glob
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import in_chromium
import littoral
import numpy as np

MODULES = os.environ.get("LITTORAL_CESIUM", "")
PAGE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples", "Web", "forest.html")
if not MODULES or not shutil.which("node") or not hasattr(littoral, "vtkForestTilesWriter"):
    print("LITTORAL_CESIUM does not name the packages, or there is no node, or Littoral was built without GDAL or tinygltf")
    sys.exit(125)

VALIDATE = """
const [validator, fs, path] = [require(process.argv[1] + '/gltf-validator'), require('fs'), require('path')];
const name = process.argv[2];
const read = (file) => Promise.resolve(new Uint8Array(fs.readFileSync(path.join(path.dirname(name), file))));
validator.validateBytes(new Uint8Array(fs.readFileSync(name)), { externalResourceFunction: read }).then((report) =>
  console.log(JSON.stringify(report.issues.messages.filter((message) => message.severity < 2))));
"""
#: Where the middle of zone 32 of UTM is at 5 400 000 m, by PROJ [degrees].
LONGITUDE, LATITUDE = 9.0, 48.753013


def write_forest(folder):
    """A wood of 300 m x 300 m around the false easting."""
    sites, tree, forest = littoral.vtkQuadratPointSource(), littoral.vtkReevesTreeSource(), littoral.vtkPlantScatterFilter()
    sites.SetOrigin(-150.0, -150.0)
    sites.SetSize(300.0, 300.0)
    forest.SetInputConnection(sites.GetOutputPort())
    forest.AddPrototypeConnection(tree.GetOutputPort())
    forest.UseCullingOff()
    forest.SetOutputFormToInstances()
    tiles = littoral.vtkForestTilesWriter()
    tiles.SetInputConnection(forest.GetOutputPort())
    tiles.SetCoordinateSystem("EPSG:32632")
    tiles.SetCoordinateOffset(500000.0, 5400000.0)
    tiles.SetHeightOffset(48.0)
    tiles.SetFileName(os.path.join(folder, "forest.json"))
    return tiles.Write()


class Cesium(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = temporary.name
        assert write_forest(cls.folder)

    def test_the_validator_finds_nothing(self):
        files = glob.glob(os.path.join(self.folder, "forest*", "*.glb"))
        self.assertGreater(len(files), 2)
        for name in files:
            found = subprocess.run(["node", "-e", VALIDATE, os.path.abspath(MODULES), name], capture_output=True, text=True,
                                   check=True).stdout
            self.assertEqual(found, "[]\n")

    def test_in_chromium(self):
        if not shutil.which("chromium"):
            self.skipTest("there is no chromium")
        shutil.copyfile(PAGE, os.path.join(self.folder, "forest.html"))
        os.symlink(os.path.abspath(MODULES), os.path.join(self.folder, "node_modules"))
        told = in_chromium.open_page(self.folder, "forest.html?forest.json", 20000, "--dump-dom")
        self.assertIn("<title>All tiles are there</title>", told)
        place = [float(number) for number in re.search(r'data-place="([^"]*)"', told)[1].split()]
        np.testing.assert_allclose(place[:2], (LONGITUDE, LATITUDE), atol=3e-5)  # the middle of the trees: some 2 m
        self.assertGreater(place[2], 48.0)
        red, green, blue = np.moveaxis(in_chromium.picture(self.folder, "forest.html?forest.json", 20000)[..., :3], -1, 0)
        leaves = (green > 1.2 * blue) & (green > red) & (green < 90)
        self.assertGreater(leaves.mean(), 0.02, "the page shows no trees")
        self.assertLess(leaves.mean(), 0.5)


if __name__ == "__main__":
    unittest.main()
