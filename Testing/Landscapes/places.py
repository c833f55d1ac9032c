# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Measured terrain of eight kinds of relief, out of Debian's packages.

Jacksboro comes with python-matplotlib-data. The others need R (r-base-core) and a package of it each:

    volcano      Maunga Whau, Auckland: r-base-core itself; cells of 10 m
    kagwene      Kagwene sanctuary, Cameroon, by radar: r-cran-spatstat.data, the largest part without holes; 31 m
    barro        plot on Barro Colorado, Panama, a survey: r-cran-spatstat.data; 5 m
    olinda       coast of Olinda, Brazil, by radar: r-cran-stars; 90 m
    switzerland  the Alps and the Mittelland: r-cran-gstat; 1010 m

Held back, for a look after a change that the others have chosen:

    rockies      mountains and plains of Colorado and Wyoming: r-cran-fields; about 3.6 x 4.6 km
    luxembourg   a part of it, in whole metres: r-cran-terra; 0.6 x 0.9 km
"""

import os
import shutil
import subprocess
import tempfile

import numpy as np

from littoral.elevation import array_from_image, read_elevation

#: Expressions of R, of which rows or columns are those of the grid as `place` has it, and spacings.
SCRIPTS = {
    "volcano": ("volcano", 10.0),
    "kagwene": ("spatstat.data::gorillas.extra$elevation$v[20:141, 35:153]", 30.70955),
    "barro": ("spatstat.data::bei.extra$elev$v", 5.0),
    "olinda": ("stars::read_stars(system.file('tif/olinda_dem_utm25s.tif', package = 'stars'))[[1]]", 89.99),
    "switzerland": ("{data(sic97, package = 'gstat'); sp::as.image.SpatialGridDataFrame(demstd)$z}", 1009.975),
}
NAMES = ("jacksboro", *SCRIPTS)
SCRIPTS["rockies"] = "{data(RMelevation, package = 'fields'); RMelevation$z[100:220, 60:180]}", (3640.0, 4630.0)
SCRIPTS["luxembourg"] = (
    "terra::as.matrix(terra::rast(system.file('ex/elev.tif', package = 'terra')), wide = TRUE)[39:81, 21:63]",
    (600.0, 927.0))


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
    if name in ("olinda", "switzerland", "rockies"):  # stored column by column
        heights = heights.T
    if name in ("olinda", "luxembourg"):  # rows from the north
        heights = heights[::-1]
    return heights, spacing if isinstance(spacing, tuple) else (spacing, spacing)
