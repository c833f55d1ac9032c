# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvbatch together=ParaView args=output args=--quick
"""Measured terrain and its synthetic twin, point patterns, a walk through a forest, and an underwater scene.

    pvbatch demo.py [FOLDER]
    pvbatch demo.py FOLDER --films [FRAMES]
    pvbatch demo.py FOLDER --quick

reads the elevation model of the Jacksboro fault, Tennessee, fits covariance models to it, grows
a twin from the best one, and writes pictures and data into FOLDER (default: a new temporary folder):

    twin-terrain.png   the measured terrain, its Gaussian twin and its twin with valleys, with their statistics
    figure2.png        the measured terrain and a fractal field with the paper's fractal dimension
    patterns.png       three classical point patterns, and patterns regrown from the fitted laws
    variogram.png      measured semivariances and the fitted models
    fits.csv           the fitted models, best first
    twin.vti           the twin: image with the point array Elevation [m]
    forest.png         part of the terrain with woods
    wind.vdb           the wind there as an OpenVDB volume
    underwater.png     the surface from below, kelp, and particles that fade into fog
    fog.vdb            that fog as an OpenVDB volume

--films writes two films of FRAMES frames each (default: 48) instead, and their first pictures again; --quick, for a test,
writes small and coarse pictures:

    underwater.ogv     the sea as a film; its frames are underwater.0000.png ...
    walk.ogv           a walk in the forest in that wind; its frames are walk.0000.png ...
"""

import atexit
import errno
import os
import runpy
import shutil
import subprocess
import sys
import tempfile
import time

import numpy as np
from paraview import simple
from vtkmodules.vtkRenderingCore import vtkRenderer

from littoral import (
    vtkCovarianceFitFilter, vtkDrainageFilter, vtkGroundStatisticsFilter, vtkTurningBandsTerrainSource)
from littoral.chart import chart_renderer, save_variogram_chart, slope_area_chart
from littoral.elevation import array_from_image, image_from_array, read_elevation, write_vti
from littoral.gallery.pictures import BELOW, PAPER, save_blocks
from littoral.picture import FAINT, INK, label
from littoral.tables import column, model_names, write_csv

#: The examples for point patterns, the forest and the underwater scene.
HERE = os.path.dirname(os.path.abspath(__file__))
PATTERNS = os.path.join(HERE, "..", "Python", "regrow_patterns.py")
FOREST = os.path.join(HERE, "forest.py")
UNDERWATER = os.path.join(HERE, "underwater.py")
FILM_SIZE = 768, 432
EXAGGERATION = 3.0
#: Space on disk that the pictures and data take, and that a frame of both films takes [bytes]; measured: 46 MB, 1.2 MB.
STILL_BYTES, FRAME_BYTES = 80e6, 1.3e6

#: Time of each picture's step [s], measured with software rendering on two cores, for the progress.
STEP_TIMES = 0.1, 0.5, 0.1, 0.5, 0.7, 2.5, 18.0, 10.0, 0.8, 18.0, 1.0
#: CPU time of each film before its first frame and of a frame [s].
FILM_TIMES = (16.0, 3.4), (13.0, 3.9)


class Progress:
    """Lines of progress: fraction done, time elapsed, time left, and the next step. times: of each step [s]."""

    def __init__(self, times):
        self.start = time.time()
        self.times = times
        self.step = -1

    def line(self, part=0.0):
        """Prefix of each line; part: of this step that is done, 0 to 1."""
        done = sum(self.times[:self.step]) + (part * self.times[self.step] if part else 0.0)
        share, gone = done / sum(self.times), time.time() - self.start
        left = f", about {gone * (1.0 - share) / share:.0f} s left" if 0.02 < share < 1.0 else ""
        return f"[{100.0 * share:3.0f} %, {gone:.0f} s{left}]"

    def begin(self, text):
        """Begin the next step."""
        self.step += 1
        print(self.line(), text, flush=True)

    def film(self, frame, frames):
        """Report every second frame of the film of this step."""
        if frame % 2 == 0 and frame > 0:
            first = FILM_TIMES[self.step][0] / self.times[self.step]
            print(self.line(first + (1.0 - first) * frame / frames), f"frame {frame} of {frames}", flush=True)


def measure(image):
    """Fits and variogram of an image, as two tables."""
    fit = vtkCovarianceFitFilter()
    fit.SetInputData(image)
    fit.Update()
    return fit.GetOutput(0), fit.GetOutput(1)


def grow(place, fits, seed):
    """A terrain on the grid of a measured one, from the first row of fits."""
    source = vtkTurningBandsTerrainSource()
    source.SetInputData(fits)
    source.SetWholeExtent(place.GetExtent())
    source.SetOrigin(place.GetOrigin())
    source.SetSpacing(place.GetSpacing())
    source.SetSeed(seed)
    source.Update()
    return source.GetOutput()


def grow_fractal(place, fits, dimension):
    """A fractal field on the grid of a measured terrain, with the same mean and variance."""
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


def erode(twin, place):
    """The twin with valleys: pieces of a place laid along its long waves."""
    drainage = vtkDrainageFilter()
    drainage.SetMethodToQuilting()
    drainage.SetInputData(twin)
    drainage.SetInputData(1, place)
    drainage.Update()
    return drainage.GetOutput()


def filled(ground):
    """A terrain whose depressions are full of water, over which slopes of streams sum to their falls."""
    drainage = vtkDrainageFilter()
    drainage.SetInputData(ground)
    drainage.CarveOff()
    drainage.Update()
    flooded = drainage.GetOutput()
    return image_from_array(
        array_from_image(flooded) + array_from_image(flooded, "DepressionDepth"), flooded.GetSpacing()[:2])


def statistics_of(ground):
    """Statistics of a terrain, as numbers by their names, and its slopes by drainage area."""
    statistics = vtkGroundStatisticsFilter()
    statistics.SetInputData(ground)
    statistics.Update()
    table = statistics.GetOutput(0)
    numbers = {table.GetColumnName(k): table.GetValue(0, k).ToDouble() for k in range(table.GetNumberOfColumns())}
    return numbers, statistics.GetOutput(1)


def semivariances(image, lags):
    """Half the mean squared difference of heights so many cells apart, along x and y [m2]."""
    z = array_from_image(image).astype(np.float64)
    return np.array([0.25 * (np.mean((z[lag:] - z[:-lag]) ** 2) + np.mean((z[:, lag:] - z[:, :-lag]) ** 2)) for lag in lags])


def table_renderer(titles, rows):
    """A table below blocks: texts of rows, their names first, a column for each title; `*` before a text: bold."""
    renderer = vtkRenderer()
    renderer.SetViewport(0.0, 0.0, 0.62, BELOW)
    renderer.SetBackground(*PAPER)
    for k, row in enumerate([("", *titles), *rows]):
        for column, text in enumerate(row):
            place = 0.40 + 0.60 * (column - 0.5) / len(titles) if column else 0.04
            actor = label(text.lstrip("*"), (place, 0.93 - 0.86 * k / (len(rows) + 1)), 34, INK if k else FAINT)
            if column == 0:
                actor.GetTextProperty().SetJustificationToLeft()
            actor.GetTextProperty().SetBold(text.startswith("*"))
            renderer.AddActor(actor)
    return renderer


def draw_grounds(filename, grounds, note, size):
    """Place, Gaussian twin and twin with valleys as blocks with lakes and rivers, above their statistics."""
    numbers, profiles = [], []
    for ground in grounds:
        number, _ = statistics_of(ground)
        full, profile = statistics_of(filled(ground))
        numbers.append({**number, "Concavity": full["Concavity"]})
        profiles.append(profile)

    def row(name, column_name, form, scale=1.0, tolerance=0.0):
        values = [scale * number[column_name] for number in numbers]
        return (name, *(("*" if abs(value - values[0]) > tolerance else "") + form.format(value) for value in values))

    lags = np.unique(np.geomspace(1, 100, 20).astype(int))
    ratios = [semivariances(ground, lags) / semivariances(grounds[0], lags) for ground in grounds]
    names = "Jacksboro fault", "Gaussian twin", "Twin with valleys"
    notes = f"measured \u00b7 {note}", "of the fitted model: water stands", "pieces of the place: water runs"
    table = table_renderer(names, (
        ("Semivariance over the place's", "1", *(f"{ratio.min():.2f} to {ratio.max():.2f}" for ratio in ratios[1:])),
        row("Depression fraction", "DepressionFraction", "{:.1f} %", 100.0, 5.0),
        row("Hypsometric integral", "HypsometricIntegral", "{:.2f}", 1.0, 0.03),
        row("Skewness of elevation", "ElevationSkewness", "{:.2f}", 1.0, 0.15),
        row("Concavity, filled", "Concavity", "{:.2f}", 1.0, 0.1),
        row("Skewness of curvature", "CurvatureSkewness", "{:.2f}", 1.0, 1.0)))
    chart = chart_renderer(slope_area_chart(profiles, names), (0.38 * size[0], BELOW * size[1]),
                           viewport=(0.62, 0.0, 1.0, BELOW), paper=PAPER)
    save_blocks(filename, grounds, EXAGGERATION, list(zip(names, notes)), size, water=True, panels=(table, chart))


def print_fits(fits):
    """Print the table of fits."""
    print(f"    {'model':<18} {'std. deviation':>14} {'range':>9} {'AICc':>9}")
    columns = (column(fits, name) for name in ("Variance", "Range", "AICc"))
    for model, variance, reach, criterion in zip(model_names(fits), *columns):
        print(f"    {model:<18} {variance ** 0.5:12.1f} m {reach:7.0f} m {criterion:9.1f}")


def clear():
    """Delete all views and sources."""
    for view in simple.GetViews():
        simple.Delete(view)
    for source in reversed(list(simple.GetSources().values())):
        simple.Delete(source)


def begin_forest(folder):
    """Draw the forest in a process of its own, on the core that the next steps leave idle."""
    process = subprocess.Popen(["pvbatch", FOREST, folder, *map(str, FILM_SIZE)],
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    atexit.register(process.kill)  # should the demo end before
    return process


def end_forest(process):
    """Wait for the forest's picture, and show what was said."""
    said = process.communicate()[0]
    print(said, end="", flush=True)
    if process.returncode != 0:
        sys.exit("The forest was not drawn.")


def need_space(folder, needed):
    """Make the folder of the output; raises OSError if its disk is too full, before anything is computed."""
    os.makedirs(folder, exist_ok=True)
    free = shutil.disk_usage(folder).free
    if free < needed:
        raise OSError(errno.ENOSPC, f"The output takes {needed / 1e6:.0f} MB, and {free / 1e6:.0f} MB are free", folder)


def stills(folder, quick=False):
    """Write pictures and data into a folder; quick: all but the forest, of coarse ground and small, and a film of two
    frames. Raises OSError when a file cannot be written."""
    need_space(folder, STILL_BYTES)
    progress = Progress(STEP_TIMES)

    def file(name):
        return os.path.join(folder, name)

    def sized(*size):
        return [length // 4 for length in size] if quick else size

    progress.begin("reading the elevation model of the Jacksboro fault")
    place = read_elevation()
    if quick:
        place = image_from_array(array_from_image(place)[::3, ::3], [3.0 * side for side in place.GetSpacing()])
    bounds = np.array(place.GetBounds()) / 1e3
    note = f"{bounds[1]:.0f} \u00d7 {bounds[3]:.0f} km, heights \u00d7 {EXAGGERATION:.0f}"

    progress.begin("measuring its covariance")
    fits, variogram = measure(place)
    models = model_names(fits)
    print_fits(fits)
    write_csv(fits, file("fits.csv"))

    progress.begin(f"growing its twin: {models[0]}")
    twin = grow(place, fits, seed=1)
    write_vti(twin, file("twin.vti"))

    progress.begin("measuring the twin")
    print_fits(measure(twin)[0])

    progress.begin("drawing variogram.png")
    save_variogram_chart(file("variogram.png"), variogram, models, sized(1200, 750))

    forest_process = None if quick else begin_forest(folder)
    progress.begin("growing its valleys, and drawing forest.png beside it")
    valleys = erode(twin, place)

    progress.begin("drawing twin-terrain.png")
    draw_grounds(file("twin-terrain.png"), (place, twin, valleys), note, sized(1600, 960))

    progress.begin("drawing figure2.png")
    dimension = 2.15  # the paper's: this terrain has no single dimension, since its periodogram bends
    fractal = grow_fractal(place, fits, dimension)
    texts = (("(a) Real terrain", "Jacksboro fault"),
             ("(b) Turning bands", f"fractal field, D = {dimension:.2f} as in the paper"))
    save_blocks(file("figure2.png"), (place, fractal), EXAGGERATION, texts, sized(1600, 760))

    progress.begin("drawing patterns.png")
    runpy.run_path(PATTERNS)["main"](folder)

    if not quick:
        progress.begin("drawing underwater.png")
        runpy.run_path(UNDERWATER, run_name="underwater")["main"](folder, FILM_SIZE)
    progress.begin("waiting for forest.png")
    if forest_process:
        end_forest(forest_process)
    progress.begin(f"all written into {folder}")


def films(folder, frames=48):
    """Write both films of so many frames, one after the other: each keeps both cores busy. Raises OSError as `stills`."""
    need_space(folder, STILL_BYTES + frames * FRAME_BYTES)
    progress = Progress([first + frames * each for first, each in FILM_TIMES])
    for name, script in (("underwater", UNDERWATER), ("walk", FOREST)):
        progress.begin(f"filming {name}.ogv")
        run_name = os.path.splitext(os.path.basename(script))[0]
        runpy.run_path(script, run_name=run_name)["main"](folder, FILM_SIZE, frames, told=progress.film)
        clear()
    progress.begin(f"all written into {folder}")


def main(folder, *options):
    """Pictures and data; with `--films` and perhaps a number of frames the films; with `--quick` small pictures."""
    if options == ("--quick",):
        stills(folder, quick=True)
    elif options[:1] == ("--films",):
        films(folder, *map(int, options[1:2]))
    elif options:
        sys.exit(f"There is no option {options[0]}.")
    else:
        stills(folder)


if __name__ == "__main__":
    arguments = sys.argv[1:] or [tempfile.mkdtemp(prefix="littoral-")]
    try:
        main(*arguments)
    except OSError as error:
        sys.exit(f"{error.filename}: {error.strerror}.")
