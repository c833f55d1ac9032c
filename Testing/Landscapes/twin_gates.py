# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Are twins places? Gates of all measures, and a classifier, for places of different relief.

    ./littoral run python3 Testing/Landscapes/twin_gates.py [--method METHOD] [--seeds N] [--keep FOLDER] [--brief] [PLACE]...

PLACE: of places.py; default, all that are not held back. Twins by seeds 1 to N, default 10, are fitted and made as
by a user, by carving, growth or quilting (default), with all properties as they are. A row has the place's number, the medians of
Gaussian twins and of those, the one of them that is furthest off, how far off it is, how far off the place itself is in the
median of nine windows with nine tenths of each side, how far a twin may be, and how many of the N are within that. --keep: a
folder of twins that are not grown again. --brief: rows that are not met alone.
"""

import argparse
import os

import numpy as np
from ground_gates import gates
from ground_measures import ground_measures, lags_of
from patch_features import RIM, SIDE
from places import NAMES, place

from littoral import vtkDrainageFilter
from littoral.elevation import array_from_image, image_from_array, twin_of

try:
    from patch_classifier import accuracy
except ImportError:
    accuracy = None

METHODS = {"carving": vtkDrainageFilter.Carving, "growth": vtkDrainageFilter.Growth, "quilting": vtkDrainageFilter.Quilting}


def twins_of(heights, spacing, seed, method):
    """Heights of the Gaussian twin and of the landscape that a method makes of it, by a seed."""
    image = image_from_array(heights, spacing)
    random = twin_of(image, seed)
    drainage = vtkDrainageFilter()
    drainage.SetInputData(random)
    drainage.SetInputData(1, image)
    drainage.SetSeed(seed)
    drainage.SetMethod(METHODS[method])
    drainage.Update()
    return [array_from_image(ground).astype(float) for ground in (random, drainage.GetOutput())]


def kept_twins(name, heights, spacing, seed, method, folder):
    if folder is None:
        return twins_of(heights, spacing, seed, method)
    path = os.path.join(folder, f"{name}-{method}-{seed}.npz")
    if not os.path.exists(path):
        os.makedirs(folder, exist_ok=True)
        random, grown = twins_of(heights, spacing, seed, method)
        np.savez(path, random=random, grown=grown)
    with np.load(path) as file:
        return [file["random"], file["grown"]]


def windows_of(heights, spacing):
    """Measures of the same place: nine windows with nine tenths of each side."""
    size = [round(0.9 * side) for side in heights.shape]
    lags = lags_of(heights)
    starts = [(0, (whole - part) // 2, whole - part) for whole, part in zip(heights.shape, size)]
    return [ground_measures(np.ascontiguousarray(heights[row:row + size[0], column:column + size[1]]), spacing, lags)
            for row in starts[0] for column in starts[1]]


def show_gates(heights, spacing, randoms, growns, brief):
    """Prints the table; numbers of gates, and of those that all twins meet, and that the median meets."""
    truth = ground_measures(heights, spacing)
    gaussians = [ground_measures(ground, spacing) for ground in randoms]
    grown = [ground_measures(ground, spacing) for ground in growns]
    windows = windows_of(heights, spacing)
    print(f"  {'gate':26} {'place':>7} {'Gauss':>7} {'twin':>7} {'worst':>7} {'off by':>7} {'itself':>7} {'limit':>7}  met")
    all_met = median_met = count = 0
    for gate, number, off, limit in gates(heights, spacing, truth, gaussians):
        offs = np.array([off(ground) for ground in grown])
        if np.isnan(number(truth)):  # a place too small for it
            continue
        worst = int(np.argmax(np.nan_to_num(offs, nan=np.inf)))
        met = int((offs <= limit).sum())
        median = np.median(np.nan_to_num(offs, nan=np.inf))
        count, all_met, median_met = count + 1, all_met + (met == len(offs)), median_met + (median <= limit)
        itself = np.median([np.nan_to_num(off(ground), nan=np.inf) for ground in windows])
        middle = [np.nanmedian([number(ground) for ground in grounds]) for grounds in (gaussians, grown)]
        if not brief or met < len(offs):
            print(f"  {gate:26} {number(truth):7.3f} {middle[0]:7.3f} {middle[1]:7.3f} {number(grown[worst]):7.3f} "
                  f"{offs[worst]:7.3f} {itself:7.3f} {limit:7.3f}  {met}/{len(offs)}")
    return count, all_met, median_met


parser = argparse.ArgumentParser()
parser.add_argument("--seeds", type=int, default=10)
parser.add_argument("--method", choices=METHODS, default="quilting")
parser.add_argument("--keep")
parser.add_argument("--brief", action="store_true")
parser.add_argument("places", nargs="*", default=NAMES)
arguments = parser.parse_args()
sums = np.zeros(3, int)
for name in arguments.places:
    try:
        heights, spacing = place(name)
    except RuntimeError as error:
        print(f"{name}: left out: {error}")
        continue
    twins = [kept_twins(name, heights, spacing, seed, arguments.method, arguments.keep) for seed in range(1, arguments.seeds + 1)]
    print(f"{name}: {heights.shape[1]} x {heights.shape[0]} cells of {spacing[0]:.1f} x {spacing[1]:.1f} m, "
          f"{arguments.seeds} seeds", flush=True)
    counts = show_gates(heights, spacing, *zip(*twins), arguments.brief)
    print(f"  {counts[1]} of {counts[0]} gates are met by all twins, {counts[2]} by the median")
    sums += counts
    has_patches = max(heights.shape) // 2 >= SIDE + 2 * RIM and min(heights.shape) >= SIDE + 2 * RIM
    asked = accuracy and arguments.seeds > 1 and has_patches
    for kind, grounds in zip(("Gaussian", arguments.method), zip(*twins)) if asked else ():
        told, betrayals = accuracy(heights, grounds, spacing)
        words = ", ".join(f"{feature} {much:+.2f}" for feature, much, _ in betrayals)
        print(f"  classifier, {kind}: " + ", ".join(f"{by} {share:.2f}" for by, share in told.items()) + f" ({words})",
              flush=True)
print(f"all places: {sums[1]} of {sums[0]} gates are met by all twins, {sums[2]} by the median")
if accuracy is None:
    print("no classifier: there is no sklearn")
