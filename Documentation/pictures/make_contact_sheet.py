# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draw contact-sheet.jpg: places and quilted twins of them as hillshades without names, each lit from two sides.

    ./littoral run python3 Documentation/pictures/make_contact_sheet.py [--answers] [--out FOLDER] [FILE SPACING]...

A row is the Jacksboro fault, or heights as rows of text with the spacing of both axes [m], as TestValleys.py lets R
write them. It has the place and twins by seeds 1 and 2, in an order by chance that --answers tells; left from the
north-west, right from the east-north-east. FOLDER: default, that of this script.
"""

import argparse
import os

import numpy as np
from make_shades import hillshade, twin, write_jpeg

from littoral.elevation import array_from_image, image_from_array, read_elevation

AZIMUTHS = (315.0, 60.0)  # degrees from north
SIDE = 200  # pixels of a panel
ORDER_SEED = 3
SHOWN_SLOPE = 0.4  # m/m, mean of the place, to which its row is exaggerated


def panel(heights, spacing, azimuth, exaggeration):
    """The middle of a hillshade, with whole numbers of pixels a cell."""
    pixels = -(-SIDE // min(heights.shape))
    cells = SIDE // pixels
    j, i = ((size - cells) // 2 for size in heights.shape)
    shade = hillshade(heights, spacing, azimuth, exaggeration)[j:j + cells, i:i + cells]
    return np.kron(shade, np.ones((pixels, pixels)))


parser = argparse.ArgumentParser()
parser.add_argument("--answers", action="store_true")
parser.add_argument("--out", default=os.path.dirname(os.path.abspath(__file__)))
parser.add_argument("grounds", nargs="*")
arguments = parser.parse_args()
places = [read_elevation()]
for file, spacing in zip(arguments.grounds[::2], arguments.grounds[1::2]):
    places.append(image_from_array(np.loadtxt(file), (float(spacing), float(spacing))))
random = np.random.default_rng(ORDER_SEED)
rows = []
for place in places:
    grounds = [array_from_image(place).astype(float), twin(place, 1), twin(place, 2)]
    slope = np.hypot(*np.gradient(grounds[0], *reversed(place.GetSpacing()[:2]))).mean()
    order = random.permutation(3)
    if arguments.answers:
        print("place is number", 1 + list(order).index(0), "of its row; seeds:", *order)
    rows.append([[panel(grounds[n], place.GetSpacing(), azimuth, SHOWN_SLOPE / slope) for n in order]
                 for azimuth in AZIMUTHS])
write_jpeg([lights[0] + lights[1] for lights in reversed(rows)], os.path.join(arguments.out, "contact-sheet.jpg"))
