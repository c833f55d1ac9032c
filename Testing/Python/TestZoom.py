# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: python3 tier=all
"""A place averaged to a third and zoomed by 3 has its slopes and its drainage lines again.

    python3 TestZoom.py [FILE SPACING]...

Places: the Jacksboro fault; or heights as rows of text, with the spacing of both axes [m], which are shown alone.
Measures are those of Testing/Landscapes/zoom_measures.py.
"""

import sys
from pathlib import Path

import numpy as np

from littoral.elevation import array_from_image, read_elevation

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "Landscapes"))
from ground_measures import distance  # noqa: E402
from zoom_measures import (  # noqa: E402
    block_means, channels, cubic, offset, slope_ratios, steepness, whole_blocks, zoomed)


def show(place, spacing):
    """Prints what comes back, cubic first; the zoomed ground's ratios of slopes, both offsets, distances."""
    place = whole_blocks(place)
    coarse = block_means(place)
    fine = zoomed(coarse, spacing)
    means = block_means(fine)
    padded = np.pad(coarse, 1, mode="edge")
    around = np.array([padded[y:y + coarse.shape[0], x:x + coarse.shape[1]] for y in range(3) for x in range(3)])
    assert (np.abs(means - coarse) <= 0.5 * np.ptp(around, axis=0) + 1e-6).all()
    wanted = steepness(place, spacing)
    offsets, distances = [], []
    for ground in (cubic(coarse), fine):
        got = steepness(ground, spacing)
        ratios = slope_ratios(got, wanted)
        distances.append(distance(got, wanted))
        offsets.append([offset(channels(ground, spacing, cells), channels(place, spacing, cells))
                        for cells in (100, 300, 1000)])
        print(f"offsets {np.round(offsets[-1], 2)} cells, quantiles and mean of slopes {np.round(ratios, 3)}, "
              f"distance {distances[-1]:.3f}")
    return ratios, offsets, distances


for name, step in zip(sys.argv[1::2], sys.argv[2::2]):
    print(name)
    show(np.loadtxt(name), (float(step), float(step)))
if len(sys.argv) == 1:
    image = read_elevation()
    slopes, offsets, distances = show(array_from_image(image).astype(float), image.GetSpacing()[:2])
    assert (abs(slopes - 1.0) < 0.1).all()
    assert distances[1] < 0.5 * distances[0]
    assert offsets[1][2] < 0.75 * offsets[0][2]
