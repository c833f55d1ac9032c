# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Frames of the two papers' scenes with levels of detail over those without: update and drawing, in software.

    build/bin/littoral-env xvfb-run -a python3 Testing/Benchmarks/bench_paper_frames.py SCENE [NUMBER [FRAMES]]

SCENE: trees (figure 9 of Setas et al.; NUMBER 1000), particles (table 1 of Coulais et al.; 400 000 in 30 trains, from 0 to
12 m) or seaweeds (their table 2; 30 000). FRAMES: default 12, but 2 of all trees in full. It takes minutes.

Pictures of 480 x 270 pixels. Trees are seen from within, from places and headings that are spread; particles and
seaweeds move. Levels of seaweeds are those of their motion and of their plants. Of particles with levels the far ones are fog and not drawn as points. More than 2000 trees are not made in
full: gains are then over levels without cells. Printed are means of processor time of all threads [ms], what a graphics
card would have to do, by the pipeline's own counters, in two of the frames, and the gains; what is slower with levels
than without is marked. Mesa's llvmpipe counts fragments in squares of 16. Trees that stand still need no update without levels and cells: of them a frame counts.
"""

import ctypes
import math
import sys
import time

import littoral
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkRenderingCore import vtkActor, vtkCompositePolyDataMapper, vtkRenderer, vtkRenderWindow
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  # pylint: disable=unused-import

SIZE = 480, 270
#: Trees that are made in full.
MOST_IN_FULL = 2000
#: Gains of the papers.
TREES = {"levels": 4.1, "cells": 5.8, "both": 13.6}
PARTICLES = {0: 2.0, 3: 2.5, 6: 3.5, 9: 5.6, 12: 11.1}
SEAWEEDS = 1.78
GL_VERTICES, GL_FRAGMENTS, GL_RESULT = 0x82EE, 0x82F4, 0x8866


class Picture:
    """A window, to draw what is put on its mapper."""

    def __init__(self):
        self.mapper = vtkCompositePolyDataMapper()
        actor = vtkActor()
        actor.SetMapper(self.mapper)
        self.renderer = vtkRenderer()
        self.renderer.AddActor(actor)
        self.window = vtkRenderWindow()
        self.window.OffScreenRenderingOn()
        self.window.SetMultiSamples(0)
        self.window.SetSize(*SIZE)
        self.window.AddRenderer(self.renderer)

    def look(self, place, ahead, angle, depth):
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(place)
        camera.SetFocalPoint([a + b for a, b in zip(place, ahead)])
        camera.SetViewUp(0.0, 0.0, 1.0)
        camera.SetViewAngle(angle)
        camera.SetClippingRange(0.1, depth)

    def counts(self):
        """Vertices and fragments of a picture."""
        self.window.Render()
        gl = ctypes.CDLL("libGL.so.1")
        queries = (ctypes.c_uint * 2)()
        counts = (ctypes.c_ulonglong * 2)()
        gl.glGenQueries(2, queries)
        for target, query in zip((GL_VERTICES, GL_FRAGMENTS), queries):
            gl.glBeginQuery(target, query)
        self.window.Render()
        for target in (GL_VERTICES, GL_FRAGMENTS):
            gl.glEndQuery(target)
        for index in range(2):
            gl.glGetQueryObjectui64v(queries[index], GL_RESULT, ctypes.byref(counts, 8 * index))
        return tuple(counts)


def measure(picture, frames, show):
    """Mean processor times of updates and of frames [ms], and what is drawn. show(frame) updates; the first two frames,
    which make all that stays, are left out."""
    updates = drawn = 0.0
    for frame in range(-2, frames):
        begin = time.process_time()
        show(frame)
        middle = time.process_time()
        picture.window.Render()
        end = time.process_time()
        if frame >= 0:
            updates += 1e3 * (middle - begin) / frames
            drawn += 1e3 * (end - begin) / frames
    vertices = fragments = 0
    for frame in range(2):
        show(frame)
        vertices, fragments = (sum(pair) for pair in zip((vertices, fragments), picture.counts()))
    return updates, drawn, vertices / 2, fragments / 2


def tell(words, now, before, published):
    """Prints a measurement, with gains over another one."""
    gains = [old / max(new, 1e-9) for new, old in zip(now, before or now)]
    print(f"{words}: update {now[0]:.1f} ms, frame {now[1]:.1f} ms, {now[2] / 1e3:.0f} thousand vertices, {now[3] / 1e3:.0f} "
          "thousand fragments" + (f"; gain {gains[0]:.3g} in updates, {gains[1]:.3g} in frames, {gains[2]:.3g} in vertices, "
                                  f"{gains[3]:.3g} in fragments{' SLOWER' if gains[1] < 0.95 else ''}, paper's {published}"
                                  if before else ""), flush=True)


def tree_frames(trees, frames, levels, cells):
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
    forest.SetAspectRatio(SIZE[0] / SIZE[1])
    forest.SetViewHeight(SIZE[1])
    forest.SetUseLevels(levels)
    forest.SetUseCulling(cells)
    picture = Picture()
    picture.mapper.SetInputConnection(forest.GetOutputPort())

    def show(view):
        # Places and headings by powers of 1 / 1.2207, the root of g^4 = g + 1.
        x, y, turn = (math.fmod((view + 2.5) * 1.2207440846 ** -power, 1.0) for power in (1, 2, 3))
        place, ahead = (side * x, side * y, 1.7), (math.cos(2.0 * math.pi * turn), math.sin(2.0 * math.pi * turn), 0.0)
        forest.SetViewPoint(place)
        forest.SetViewDirection(ahead)
        picture.look(place, ahead, 45.0, 2.0 * side)
        forest.Update()

    return measure(picture, frames, show)


def trees_scene(number, frames):
    before = None
    for words, levels, cells in (("neither", 0, 0), ("levels", 1, 0), ("cells", 0, 1), ("both", 1, 1)):
        if not levels and number > MOST_IN_FULL:
            print(f"{number} trees, {words}: not made, {number} trees in full take more memory than there is")
            continue
        now = tree_frames(number, frames if levels or cells else 2, levels, cells)
        tell(f"{number} trees, {words}", now, before, TREES.get(words))
        before = before or now


def particle_frames(number, frames, distance, levels):
    source = littoral.vtkSuspendedParticleSource()
    source.SetPreset(source.Custom)
    source.SetAmountIs(source.Count)
    source.AddBox([-5.0, 5.0, 0.0, 10.0, -8.5, -7.5, 1.0, 0.01, number, 1.0, 1.0, 1.0])
    current = littoral.vtkFlowPrimitiveSource()
    current.SetStrength(0.1)
    drift = littoral.vtkCurrentDriftFilter()
    drift.SetInputConnection(0, source.GetOutputPort())
    drift.AddCurrentConnection(current.GetOutputPort())
    sea = littoral.vtkSeaStateSource()
    select = littoral.vtkParticleLevelOfDetailFilter()
    select.SetInputConnection(0, drift.GetOutputPort())
    select.SetSeaStateConnection(sea.GetOutputPort())
    select.SetUseLevels(levels)
    select.SetUseCulling(levels)
    select.SetTrainSelection(select.PerTrain if levels else select.AllTrains)
    select.SetVisibleDistance(30.0)
    select.SetViewPoint(0.0, -distance, -8.0)
    select.SetViewAngle(45.0)
    select.SetAspectRatio(SIZE[0] / SIZE[1])
    select.SetViewHeight(SIZE[1])
    orbits = littoral.vtkParticleOrbitFilter()
    orbits.SetInputConnection(0, select.GetOutputPort())
    orbits.SetSeaStateConnection(sea.GetOutputPort())
    picture = Picture()
    picture.look((0.0, -distance, -8.0), (0.0, 1.0, 0.0), 45.0, 60.0)
    near = vtkMultiBlockDataSet()
    shown = vtkTrivialProducer()
    shown.SetOutput(near)
    picture.mapper.SetInputConnection(shown.GetOutputPort())

    def show(frame):
        orbits.UpdateTimeStep(0.04 * (frame + 2))
        moved = orbits.GetOutputDataObject(0)
        for index, name in enumerate(("Near", "MasterSlave")):
            found = [moved.GetBlock(i) for i in range(moved.GetNumberOfBlocks())
                     if moved.GetMetaData(i).Get(vtkMultiBlockDataSet.NAME()) == name]
            near.SetBlock(index, found[0] if found else vtkPolyData())
        near.Modified()

    return measure(picture, frames, show)


def particles_scene(number, frames):
    for distance, published in PARTICLES.items():
        before = particle_frames(number, frames, distance, False)
        tell(f"{number} particles at {distance} m, without", before, None, None)
        tell(f"{number} particles at {distance} m, both", particle_frames(number, frames, distance, True), before, published)


def seaweed_frames(number, frames, levels):
    sites, places = vtkPolyData(), vtkPoints()
    for plant in range(number):
        # A sequence of low discrepancy.
        x, y = (math.fmod(0.5 + step * plant, 1.0) for step in (0.7548776662466927, 0.5698402909980532))
        places.InsertNextPoint(40.0 * x, 10.0 * y - 5.0, -10.0)
    sites.SetPoints(places)
    weed = littoral.vtkSeaweedSource()
    weed.SetPreset(weed.Custom)
    weed.SetForm(weed.Tuft)
    weed.SetNumberOfFronds(1)
    weed.SetSegmentsPerBranch(6)
    scatter = littoral.vtkPlantScatterFilter()
    scatter.SetInputData(sites)
    scatter.AddPrototypeConnection(weed.GetOutputPort())
    scatter.SetUseLevels(levels)
    scatter.SetUseCulling(levels)
    scatter.SetNearDistance(5.0)
    scatter.SetFarDistance(20.0)
    scatter.SetViewPoint(0.0, 0.0, -9.5)
    scatter.SetViewDirection(1.0, 0.0, 0.0)
    scatter.SetViewAngle(60.0)
    scatter.SetAspectRatio(SIZE[0] / SIZE[1])
    sea = littoral.vtkSeaStateSource()
    sea.SetWaterDepth(10.0)
    current = littoral.vtkFlowPrimitiveSource()
    move = littoral.vtkSeaweedDeformationFilter()
    move.SetInputConnection(0, scatter.GetOutputPort())
    move.SetSeaStateConnection(sea.GetOutputPort())
    move.AddCurrentConnection(current.GetOutputPort())
    move.SetMethodToProcedural()
    move.SetUseLevels(levels)
    move.SetNearDistance(5.0)
    move.SetFarDistance(20.0)
    move.SetBlendDistance(0.0)
    move.SetViewPoint(0.0, 0.0, -9.5)
    move.SetViewDirection(1.0, 0.0, 0.0)
    move.SetViewAngle(60.0)
    move.SetAspectRatio(SIZE[0] / SIZE[1])
    picture = Picture()
    picture.look((0.0, 0.0, -9.5), (1.0, 0.0, 0.0), 60.0, 60.0)
    picture.mapper.SetInputConnection(move.GetOutputPort())
    return measure(picture, frames, lambda frame: move.UpdateTimeStep(0.04 * (frame + 2)))


def seaweeds_scene(number, frames):
    before = seaweed_frames(number, frames, False)
    tell(f"{number} seaweeds, without", before, None, None)
    tell(f"{number} seaweeds, levels", seaweed_frames(number, frames, True), before, SEAWEEDS)


SCENES = {"trees": (trees_scene, 1000), "particles": (particles_scene, 400000), "seaweeds": (seaweeds_scene, 30000)}


def main():
    if len(sys.argv) < 2 or sys.argv[1] not in SCENES:
        sys.exit(f"bench_paper_frames.py: SCENE is one of {', '.join(SCENES)}")
    scene, number = SCENES[sys.argv[1]]
    given = [int(word) for word in sys.argv[2:]]
    scene(*(given + [number, 12][len(given):]))


main()
