# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: python3 tier=all
"""Shares of geomorphons against those of r.geomorphon, on the Jacksboro fault in cells of 80 m.

Its whole metres get up to a quarter of a metre at random: where a line of sight has one slope all along, r.geomorphon
takes it as level, however steep it is.
Needs `grass` of Debian's package grass-core; skipped without it.
"""

import os
import shutil
import subprocess
import sys
import tempfile

import numpy as np

from littoral import vtkGroundStatisticsFilter
from littoral.elevation import array_from_image, image_from_array, read_elevation

GRASS = shutil.which("grass")
if not GRASS:
    print("no grass")
    sys.exit(125)

SPACING = 80.0
HEADER = "ncols {1}\nnrows {0}\nxllcorner 0\nyllcorner 0\ncellsize {2}\nNODATA_value -9999\n"
SCRIPT = """set -e
r.in.gdal -o --quiet input=heights.asc output=heights
g.region raster=heights
r.geomorphon --quiet elevation=heights forms=forms search={0} flat={1}
r.out.ascii --quiet input=forms output=forms.txt null_value=0
"""


def shares_of_grass(heights, search, flat):
    """Shares of forms 1 to 10 in the inner cells."""
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "heights.asc"), "w", encoding="ascii") as file:
            file.write(HEADER.format(*heights.shape, SPACING))
            np.savetxt(file, heights[::-1], "%.3f")
        with open(os.path.join(folder, "script.sh"), "w", encoding="ascii") as file:
            file.write(SCRIPT.format(search, flat))
        subprocess.run([GRASS, "--tmp-location", "XY", "--exec", "bash", "script.sh"], cwd=folder, check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env={**os.environ, "HOME": folder})
        forms = np.loadtxt(os.path.join(folder, "forms.txt"), skiprows=6).astype(int)[1:-1, 1:-1]
    counts = np.bincount(forms.ravel(), minlength=11)[1:]
    return counts / counts.sum()


place = array_from_image(read_elevation()).astype(float)
place = np.round(place + np.random.default_rng(1).uniform(0.0, 0.25, place.shape), 3)
statistics = vtkGroundStatisticsFilter()
statistics.SetInputData(image_from_array(place, (SPACING, SPACING)))
for radius, flatness in ((3, 1), (10, 1), (10, 4), (30, 2)):
    statistics.SetSearchRadius(radius)
    statistics.SetFlatness(flatness)
    statistics.Update()
    column = statistics.GetOutput(4).GetColumnByName("Share")
    shares = np.array([column.GetValue(row) for row in range(10)])
    theirs = shares_of_grass(place, radius, flatness)
    print(f"search {radius}, flat {flatness}: sum of differences {np.abs(shares - theirs).sum():.5f}", shares.round(3))
    assert np.abs(shares - theirs).sum() < 0.02  # the belt of two cells at the border has other lines there
