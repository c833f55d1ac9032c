# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Measured terrain of six kinds of relief, out of Debian's packages.

Jacksboro comes with python-matplotlib-data. The others need R (r-base-core) and a package of it each:

    volcano      Maunga Whau, Auckland: r-base-core itself; cells of 10 m
    kagwene      Kagwene sanctuary, Cameroon, by radar: r-cran-spatstat.data, the largest part without holes; 31 m
    barro        plot on Barro Colorado, Panama, a survey: r-cran-spatstat.data; 5 m
    olinda       coast of Olinda, Brazil, by radar: r-cran-stars; 90 m
    switzerland  the Alps and the Mittelland: r-cran-gstat; 1010 m
"""

import os
import shutil
import subprocess
import tempfile

import numpy as np

from littoral.elevation import array_from_image, read_elevation

#: Rows from south to north.
SCRIPTS = {
    "volcano": ("volcano", 10.0),
    "kagwene": ("spatstat.data::gorillas.extra$elevation$v[20:141, 35:153]", 30.70955),
    "barro": ("spatstat.data::bei.extra$elev$v", 5.0),
    "olinda": ("stars::read_stars(system.file('tif/olinda_dem_utm25s.tif', package = 'stars'))[[1]]", 89.99),
    "switzerland": ("{data(sic97, package = 'gstat'); sp::as.image.SpatialGridDataFrame(demstd)$z}", 1009.975),
}
NAMES = ("jacksboro", *SCRIPTS)


def of_r(expression):
    """A matrix of R; RuntimeError where R or the package is not there."""
    if not shutil.which("Rscript"):
        raise RuntimeError("there is no Rscript")
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "heights.txt")
        script = f"library(methods); write.table({expression}, '{path}', row.names = FALSE, col.names = FALSE)"
        done = subprocess.run(["Rscript", "-e", script], capture_output=True, text=True, check=False)
        if done.returncode:
            raise RuntimeError(done.stderr.strip())
        return np.loadtxt(path)


def place(name):
    """Heights [m], rows from south to north, and spacings [m] along x and y."""
    if name == "jacksboro":
        image = read_elevation()
        return array_from_image(image).astype(float), image.GetSpacing()[:2]
    expression, spacing = SCRIPTS[name]
    heights = of_r(expression)
    if name in ("olinda", "switzerland"):  # columns of R are rows from south or from north
        heights = heights.T[::-1] if name == "olinda" else heights.T
    return heights, (spacing, spacing)
