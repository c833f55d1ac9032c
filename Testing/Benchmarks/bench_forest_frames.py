# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 9 of Setas et al. in time: frames of a forest with levels of detail and cells, over those with neither.

    build/bin/littoral-env xvfb-run -a python3 Testing/Benchmarks/bench_forest_frames.py [TREES [VIEWS]]

TREES: default 1000; VIEWS: default 12, but 2 with neither, where all trees are drawn in any view. It takes minutes.
Views from within, spread over places and headings, are drawn in software, 480 x 270: a frame is the update of the
scatter and its drawing. More than 2000 trees are not made in full: gains are then over levels without cells. Printed
are means of processor time [s] of all threads and the gains beside the paper's; what is slower with levels than
without is marked.
"""

import math
import sys
import time

import littoral
from vtkmodules.vtkRenderingCore import vtkActor, vtkCompositePolyDataMapper, vtkRenderer, vtkRenderWindow
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  # pylint: disable=unused-import

#: Frames a second in the paper by (levels, cells).
PAPER = {(0, 0): 0.9, (1, 0): 3.7, (0, 1): 5.2, (1, 1): 12.2}
#: Trees that are made in full.
MOST_IN_FULL = 2000
WORDS = {(0, 0): "neither", (1, 0): "levels", (0, 1): "cells", (1, 1): "both"}


def forest_of(trees):
    """The scatter of a forest, with sites on a square as dense for any number, and the square's side [m]."""
    side = 500.0 * math.sqrt(trees / 1000.0)
    sites = littoral.vtkQuadratPointSource()
    sites.SetQuadrats(10, max(1, trees // 10))
    sites.SetSize(side, side)
    forest = littoral.vtkPlantScatterFilter()
    forest.SetInputConnection(sites.GetOutputPort())
    for species in (1, 2, 3):
        tree = littoral.vtkReevesTreeSource()
        tree.SetPreset(species)
        forest.AddPrototypeConnection(tree.GetOutputPort())
    forest.SetViewAngle(45.0)
    forest.SetAspectRatio(480.0 / 270.0)
    forest.SetViewHeight(270)
    return forest, side


def window_of(forest):
    """A window that shows a forest, and its renderer."""
    mapper = vtkCompositePolyDataMapper()
    mapper.SetInputConnection(forest.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    renderer = vtkRenderer()
    renderer.AddActor(actor)
    window = vtkRenderWindow()
    window.OffScreenRenderingOn()
    window.SetSize(480, 270)
    window.AddRenderer(renderer)
    return window, renderer


def look(forest, renderer, view, side):
    """Turns forest and camera to a view: places and headings by powers of 1 / 1.2207, the root of g^4 = g + 1."""
    x, y, turn = (math.fmod((view + 0.5) * 1.2207440846 ** -power, 1.0) for power in (1, 2, 3))
    place = side * x, side * y, 1.7
    ahead = math.cos(2.0 * math.pi * turn), math.sin(2.0 * math.pi * turn), 0.0
    forest.SetViewPoint(place)
    forest.SetViewDirection(ahead)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(place)
    camera.SetFocalPoint([a + b for a, b in zip(place, ahead)])
    camera.SetViewUp(0.0, 0.0, 1.0)
    camera.SetViewAngle(45.0)
    camera.SetClippingRange(0.5, 2.0 * side)


def measure(trees, views, levels, cells):
    """Mean processor times of updates and of frames [s]; the first view, which makes all that stays, is left out."""
    forest, side = forest_of(trees)
    forest.SetUseLevels(bool(levels))
    forest.SetUseCulling(bool(cells))
    window, renderer = window_of(forest)
    updates = frames = 0.0
    for view in range(views + 1):
        look(forest, renderer, view, side)
        begin = time.process_time()
        forest.Update()
        middle = time.process_time()
        window.Render()
        end = time.process_time()
        if view > 0:
            updates += (middle - begin) / views
            frames += (end - begin) / views
    return updates, frames


def main():
    given = [int(word) for word in sys.argv[1:]]
    trees, views = given + [1000, 12][len(given):]
    slowest = None
    for key, published in PAPER.items():
        if not key[0] and trees > MOST_IN_FULL:
            print(f"{trees} trees, {WORDS[key]}: not made, {trees} trees in full take more memory than there is")
            continue
        update, frame = measure(trees, views if any(key) else 2, *key)
        slowest = slowest or frame
        gain = slowest / frame
        print(f"{trees} trees, {WORDS[key]}: update {update:.4f} s, frame {frame:.3f} s, gain {gain:.2f}"
              f"{' SLOWER' if gain < 0.95 else ''}, paper's {published / PAPER[0, 0]:.1f}", flush=True)


main()
