# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvbatch args=output args=2
"""Measure a real place, grow a terrain like it, walk through a forest there, and dive into the sea.

    pvbatch demo.py [FOLDER [FRAMES]]

reads the elevation model of the Jacksboro fault, Tennessee, fits models of covariance to it, grows
a twin from the best one, and writes into FOLDER (default: a new temporary folder):

    twin-terrain.png   the place and its twin
    figure2.png        the place and a fractal field of the same dimension
    patterns.png       three classical point patterns, and patterns regrown from their laws
    variogram.png      what was measured, and what the models say
    fits.csv           the fitted models, best first
    twin.vti           the twin: image with the point array Elevation [m]
    forest.png         a part of the place with woods
    walk.ogv           a walk there in the wind, and its pictures walk.0000.png and on
    wind.vdb           that wind as an OpenVDB volume
    underwater.png     the surface from below, kelp, and particles that fade into fog
    underwater.ogv     the same as a film, and its pictures underwater.0000.png and on
    fog.vdb            that fog as an OpenVDB volume
"""

import os
import runpy
import sys
import tempfile
import time

import numpy as np
from paraview import simple

from littoral import vtkCovarianceFitFilter, vtkTurningBandsTerrainSource
from littoral.chart import save_variogram_chart
from littoral.elevation import read_elevation, write_vti
from littoral.picture import save_pair
from littoral.scene import height_colour
from littoral.tables import column, model_names, write_csv

#: The examples that regrow point patterns, walk through a forest and dive.
HERE = os.path.dirname(os.path.abspath(__file__))
PATTERNS = os.path.join(HERE, "..", "Python", "regrow_patterns.py")
FOREST = os.path.join(HERE, "forest.py")
UNDERWATER = os.path.join(HERE, "underwater.py")
FILM_SIZE = 768, 432
STEPS = 10
EXAGGERATION = 3.0
START = time.time()


def say(step, text):
    """A line of progress: share done, seconds gone, what comes now."""
    print(f"[{100 * step // STEPS:3d} %, {time.time() - START:4.1f} s] {text}", flush=True)


def tell_frames(frame, frames):
    """Progress of the film."""
    if frame % 6 == 0:
        print(f"    frame {frame} of {frames}, {time.time() - START:4.1f} s", flush=True)


def measure(image):
    """Fits and variogram of an image, as two tables."""
    fit = vtkCovarianceFitFilter()
    fit.SetInputData(image)
    fit.Update()
    return fit.GetOutput(0), fit.GetOutput(1)


def grow(place, fits, seed):
    """A terrain on the grid of a place, from the first row of fits."""
    source = vtkTurningBandsTerrainSource()
    source.SetInputData(fits)
    source.SetWholeExtent(place.GetExtent())
    source.SetOrigin(place.GetOrigin())
    source.SetSpacing(place.GetSpacing())
    source.SetSeed(seed)
    source.Update()
    return source.GetOutput()


def grow_fractal(place, fits, dimension):
    """A fractal field on the grid of a place, of the same mean and variance."""
    fields = fits.GetFieldData()
    bounds = place.GetBounds()
    source = vtkTurningBandsTerrainSource()
    source.SetModelToFractal()
    source.SetFractalDimension(dimension)
    source.SetStandardDeviation(fields.GetArray("SampleVariance").GetValue(0) ** 0.5)
    source.SetMean(column(fits, "Mean")[0])
    source.SetRange(max(bounds[1] - bounds[0], bounds[3] - bounds[2]))
    source.SetWholeExtent(place.GetExtent())
    source.SetOrigin(place.GetOrigin())
    source.SetSpacing(place.GetSpacing())
    source.Update()
    return source.GetOutput()


def print_fits(fits):
    """The fits for a reader."""
    print(f"    {'model':<18} {'std. deviation':>14} {'range':>9} {'AICc':>9}")
    columns = (column(fits, name) for name in ("Variance", "Range", "AICc"))
    for model, variance, reach, criterion in zip(model_names(fits), *columns):
        print(f"    {model:<18} {variance ** 0.5:12.1f} m {reach:7.0f} m {criterion:9.1f}")


def clear():
    """Leave no view or source."""
    for view in simple.GetViews():
        simple.Delete(view)
    for source in reversed(list(simple.GetSources().values())):
        simple.Delete(source)


def main(folder, frames=48):
    """Do all of it, into a folder; films have so many frames."""
    os.makedirs(folder, exist_ok=True)

    def file(name):
        return os.path.join(folder, name)

    say(0, "reading the elevation model of the Jacksboro fault")
    place = read_elevation()
    bounds = np.array(place.GetBounds()) / 1e3
    size = f"{bounds[1]:.0f} \u00d7 {bounds[3]:.0f} km, heights \u00d7 {EXAGGERATION:.0f}"

    say(1, "measuring its covariance")
    fits, variogram = measure(place)
    models = model_names(fits)
    print_fits(fits)
    write_csv(fits, file("fits.csv"))

    say(2, f"growing its twin: {models[0]}")
    twin = grow(place, fits, seed=1)
    write_vti(twin, file("twin.vti"))

    say(3, "measuring the twin")
    print_fits(measure(twin)[0])

    say(4, "drawing variogram.png")
    save_variogram_chart(file("variogram.png"), variogram, models)

    say(5, "drawing twin-terrain.png")
    save_pair(
        file("twin-terrain.png"), (place, twin), ("Jacksboro fault, Tennessee", "Its twin"),
        (f"measured \u00b7 {size}", f"grown by Littoral \u00b7 {size}"), EXAGGERATION)

    say(6, "drawing figure2.png")
    dimension = 2.15  # the paper's: this place tells none, since its periodogram bends
    save_pair(
        file("figure2.png"), (place, grow_fractal(place, fits, dimension)),
        ("(a) Real terrain", "(b) Turning bands"),
        ("Jacksboro fault", f"fractal field, D = {dimension:.2f} as in the paper"),
        EXAGGERATION, height_colour)

    say(7, "drawing patterns.png")
    runpy.run_path(PATTERNS)["main"](folder)

    say(8, "drawing forest.png and filming walk.ogv: the longest part")
    runpy.run_path(FOREST, run_name="forest")["main"](folder, FILM_SIZE, frames, tell_frames)
    clear()

    say(9, "drawing underwater.png and filming underwater.ogv")
    runpy.run_path(UNDERWATER, run_name="underwater")["main"](folder, FILM_SIZE, frames, tell_frames)
    say(STEPS, f"all written into {folder}")


if __name__ == "__main__":
    arguments = sys.argv[1:]
    main(arguments[0] if arguments else tempfile.mkdtemp(prefix="littoral-"), *map(int, arguments[1:2]))
