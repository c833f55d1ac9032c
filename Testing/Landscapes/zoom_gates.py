# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Does a place come back from its means? Places averaged to a third and zoomed by 3, against cubic convolution.

    ./littoral run python3 Testing/Landscapes/zoom_gates.py [PLACE]...

PLACE: of places.py; default, all that are not held back. The offset of a ground's channels, of 100, 300 and 1000 fine
cells, is the root mean square of the distances of its channels' cells to the place's and of the place's to its own, in
fine cells: a ground that has few channels gets no gain of it. Gates: half of cubic convolution's offset; the slopes'
mean and quantiles (0.1, 0.5, 0.9, 0.99) within 10 % of the place's. A third row, `waves`, has the place's own waves
that are longer than two coarse cells, unchanged: what a perfect model of that resolution could tell.
"""

import sys

import numpy as np
from ground_measures import distance
from places import NAMES, place
from zoom_measures import block_means, cubic, long_waves, offsets, slope_ratios, steepness, whole_blocks, zoomed

met = np.zeros(2, int)
asked = np.zeros(2, int)
for name in sys.argv[1:] or NAMES:
    try:
        heights, spacing = place(name)
    except RuntimeError as error:
        print(f"{name}: left out: {error}")
        continue
    heights = whole_blocks(heights)
    coarse = block_means(heights)
    wanted = steepness(heights, spacing)
    print(f"{name}: {heights.shape[1]} x {heights.shape[0]} cells of {spacing[0]:.1f} x {spacing[1]:.1f} m")
    print(f"  {'ground':8} {'offset: 100':>12} {'300':>6} {'1000':>6}  {'slopes: mean':>12} "
          f"{'q10':>6} {'q50':>6} {'q90':>6} {'q99':>6} {'Kolmogorov':>11}")
    both = {}
    for kind, ground in (("cubic", cubic(coarse)), ("zoomed", zoomed(coarse, spacing)), ("waves", long_waves(heights))):
        got = steepness(ground, spacing)
        both[kind] = np.sqrt((offsets(ground, heights, spacing) ** 2).mean(1)), slope_ratios(got, wanted)
        far, ratios = both[kind]
        print(f"  {kind:8} {far[0]:12.2f} {far[1]:6.2f} {far[2]:6.2f}  {ratios[4]:12.2f} "
              + " ".join(f"{ratio:6.2f}" for ratio in ratios[:4]) + f" {distance(got, wanted):11.3f}", flush=True)
    good = ~np.isnan(both["cubic"][0]), ~np.isnan(both["zoomed"][1])
    lines = both["zoomed"][0][good[0]] <= 0.5 * both["cubic"][0][good[0]]
    slopes = np.abs(both["zoomed"][1][good[1]] - 1.0) <= 0.1
    best = both["waves"][0][good[0]] <= 0.5 * both["cubic"][0][good[0]]
    print(f"  gates met: {lines.sum()} of {lines.size} offsets (the waves: {best.sum()}), {slopes.sum()} of "
          f"{slopes.size} numbers of slopes")
    met += lines.sum(), slopes.sum()
    asked += lines.size, slopes.size
print(f"all places: {met[0]} of {asked[0]} offsets, {met[1]} of {asked[1]} numbers of slopes")
