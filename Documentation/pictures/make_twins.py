# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draw twins.jpg: the Jacksboro fault, a quilted and a grown twin of it as hillshades, each lit from two sides.

    ./littoral run python3 Documentation/pictures/make_twins.py [FOLDER]

FOLDER: default, that of this script.
"""

import os
import sys

from make_shades import hillshade, twin, write_jpeg

from littoral import vtkDrainageFilter
from littoral.elevation import array_from_image, read_elevation

AZIMUTHS = (315.0, 60.0)  # degrees from north

place = read_elevation()
spacing = place.GetSpacing()
grounds = [array_from_image(place).astype(float), twin(place, 1), twin(place, 1, vtkDrainageFilter.Growth)]
rows = [[hillshade(ground, spacing, azimuth) for ground in grounds] for azimuth in reversed(AZIMUTHS)]
write_jpeg(rows, os.path.join(sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(__file__), "twins.jpg"))
