# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The programs of the guide for one's own data, run as they stand there on the files that are shipped.

What they make is compared with what was measured, or is known otherwise; the shipped files that are made are made again.
"""
import filecmp
import os
import re
import sys
import tempfile
import unittest

import guide_data
import littoral
import numpy as np
from TestWindFiles import read_bts
from vtkmodules.util.numpy_support import vtk_to_numpy

TOP = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))

if not hasattr(littoral, "vtkOceanCurrentReader"):
    print("built without netCDF")
    sys.exit(125)


def run(page, heading):
    """The names of the program below a heading of a page of the guide, which has at most twelve lines."""
    with open(os.path.join(TOP, "Documentation", "guide", f"{page}.md"), encoding="utf-8") as file:
        program = file.read().split(f"\n## {heading}\n")[1].split("```python\n")[1].split("```")[0]
    assert len(program.splitlines()) <= 12, program
    names = {}
    exec(compile(program, page, "exec"), names)
    return names


def field(algorithm, name):
    return algorithm.GetOutput().GetFieldData().GetArray(name).GetValue(0)


class GuidePrograms(unittest.TestCase):
    """Each in a folder of its own, in which the examples are."""

    def setUp(self):
        folder, here = tempfile.TemporaryDirectory(), os.getcwd()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, here)
        os.chdir(folder.name)
        os.symlink(os.path.join(TOP, "Examples"), "Examples")

    def test_files_are_made_so(self):
        guide_data.write_current("current.nc")
        guide_data.write_plot("plot.csv")
        self.assertTrue(filecmp.cmp("current.nc", "Examples/Data/sea/current.nc", shallow=False))
        self.assertTrue(filecmp.cmp("plot.csv", "Examples/Data/stand/plot.csv", shallow=False))

    def test_sea_with_drift(self):
        """Sums over the bands of the file, the buoy's own summary, and the way that the current makes."""
        names = run("currents", "From a buoy and a model to a sea with drift")
        parts = []
        for name in ("data_spec", "swdir", "swr1"):
            with open(f"Examples/Data/sea/41010.{name}", encoding="ascii") as file:
                parts.append(np.array([[float(x), float(f)] for x, f in
                                       re.findall(r"([\d.]+) \(([\d.]+)\)", file.read().splitlines()[1])]))
        density, f = parts[0].T
        edges = np.concatenate([[f[0] - 0.0025], 0.5 * (f[1:] + f[:-1]), [f[-1] + 0.01]])
        energy = density * np.diff(edges)
        height, zero = 4.0 * np.sqrt(energy.sum()), np.sqrt(energy.sum() / (energy * f**2).sum())
        there = energy > 0.0
        mean = (parts[2][there, 0] * np.exp(1j * np.radians(parts[1][there, 0])) * energy[there]).sum()
        towards = (270.0 - np.degrees(np.angle(mean))) % 360.0
        for name, bound in (("buoy", 1.0), ("sea", 4.0)):
            read = names[name]
            found = [field(read, one) for one in
                     ("SignificantWaveHeight", "ZeroCrossingPeriod", "PeakPeriod", "MeanDirection")]
            print(f"{name}: {found[0]:.3f} m, {found[1]:.2f} s, {found[2]:.2f} s, towards {found[3]:.1f} degrees;"
                  f" sums {height:.3f} m, {zero:.2f} s, {towards:.1f} degrees")
            self.assertAlmostEqual(found[0] / height, 1.0, delta=0.01 * bound)
            self.assertAlmostEqual(found[1] / zero, 1.0, delta=0.01 * bound)
            self.assertLess(abs((found[3] - towards + 180.0) % 360.0 - 180.0), bound)
            # NOAA's own: 1.1 m, 4.9 s, 5.6 s
            self.assertAlmostEqual(found[0], 1.1, delta=0.05)
            self.assertAlmostEqual(found[1], 4.9, delta=0.15)
        self.assertAlmostEqual(field(names["buoy"], "PeakPeriod"), 5.6, delta=0.05)
        start, drifted, moved = (vtk_to_numpy(names[name].GetOutput().GetPoints().GetData()).astype(float)
                                 for name in ("particles", "drift", "orbits"))
        way = (drifted - start)[:, :2]
        print(f"{len(way)} particles drift by {way.mean(axis=0)} m, {abs(way - guide_data.drift(24)).max():.3f} m from the sum")
        self.assertGreater(len(way), 50)
        self.assertLess(abs(way - guide_data.drift(24)).max(), 1.0)
        self.assertGreater(abs(moved - drifted).max(), 0.1)

    def test_inflow(self):
        """Deviation of the class, power law and veer in the file."""
        run("wind", "An inflow for your turbine code")
        head, grid, _, _ = read_bts("inflow.bts")
        np.testing.assert_allclose(head[5:11], (10.0, 10.0, 0.25, 12.0, 90.0, 20.0), rtol=1e-6)
        hub = grid[:, 7, :, 0]
        deviation = (hub - hub.mean(axis=0)).std()
        means, heights = grid.mean(axis=(0, 2)), 20.0 + 10.0 * np.arange(15)
        turns, speeds = np.degrees(np.arctan2(means[:, 1], means[:, 0])), np.hypot(means[:, 0], means[:, 1])
        print(f"{deviation:.4f} m/s; {speeds[0]:.2f} to {speeds[-1]:.2f} m/s, {turns[0]:.2f} to {turns[-1]:.2f} degrees")
        self.assertAlmostEqual(deviation / 2.336, 1.0, delta=1e-3)
        np.testing.assert_allclose(speeds, 12.0 * (heights / 90.0) ** 0.2, rtol=1e-3)
        np.testing.assert_allclose(turns, -0.1 * (heights - 90.0), atol=0.01)

    def test_leaf_area(self):
        """The index is that of the allometry of the plot, and like measured ones; both files are there."""
        names = run("stands", "Leaf area from your plot")
        density = names["density"]
        index = field(density, "LeafAreaIndex")
        print(f"leaf area index {index:.2f}, leaves of {field(density, 'LeafMass'):.0f} kg")
        # temperate deciduous broadleaved forests: mean 5.1, standard deviation 1.6 (Asner et al. 2003)
        self.assertAlmostEqual(index, 5.1, delta=1.6)
        self.assertGreater(os.path.getsize("leaves.bdf"), 1000)
        with open("leaves.amrwind", encoding="ascii") as file:
            self.assertEqual(len(file.read().split("\n")) - 1, 100)


if __name__ == "__main__":
    unittest.main()
