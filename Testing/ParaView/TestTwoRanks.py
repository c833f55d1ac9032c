# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython
"""A client with a server of two ranks: all outputs in blocks have the same ones on both, empty or not, and are drawn.

ParaView's ranks exchange data block by block, so that a rank with fewer of them never answers. Translucent blocks are
redistributed before they are drawn. A rank that never answers is ended here, with what was drawn.
"""

import os
import shutil
import signal
import sys
import tempfile
import time as clock

import numpy as np
import quick
from paraview import simple
from server import connected
from window import colors

PORT = 21541
LIMIT = 600  # of an entry [s]

#: Writes names and paths of all blocks, and whether they have data, to a file of the rank.
STRUCTURE = """
import os
from paraview.servermanager import vtkProcessModule

def lines(data, path):
    if data is None:
        return [path + " (null)"]
    if not data.IsA("vtkMultiBlockDataSet"):
        return [path + " " + data.GetClassName()]
    found = []
    for k in range(data.GetNumberOfBlocks()):
        name = data.GetMetaData(k).Get(data.NAME()) if data.HasMetaData(k) else ""
        found += lines(data.GetBlock(k), path + "/" + str(name))
    return found

rank = vtkProcessModule.GetProcessModule().GetPartitionId()
data = self.GetInputDataObject(0, 0)
with open(os.path.join({folder!r}, str(rank)), "w") as file:
    file.write("\\n".join(lines(data, "")))
"""


def tree():
    return simple.ReevesTree(Preset="Shrub")


def forest():
    sites = simple.QuadratPoints(Quadrats=[5, 5], Size=[30.0, 30.0])
    return simple.PlantScatter(Sites=sites, Prototypes=[tree()], NearDistance=10.0, FarDistance=40.0)


def swaying_tree():
    return simple.BeamTreeDeformation(Input=tree(), Wind=simple.WindField(Dimensions=[100, 16, 8]))


def swaying_forest():
    one = tree()
    sites = simple.QuadratPoints(Quadrats=[3, 3], Size=[20.0, 20.0])
    return simple.BeamTreeDeformation(Input=simple.PlantScatter(Sites=sites, Prototypes=[one]), Prototypes=[one],
                                      Wind=simple.WindField(Dimensions=[100, 16, 8]))


def kelp():
    return simple.SeaweedDeformation(Input=simple.Seaweed(), SeaState=simple.SeaState(NumberOfTrains=5, SeaLevel=8.0))


def terrain_levels():
    terrain = simple.TurningBandsTerrain(WholeExtent=[0, 100, 0, 100, 0, 0])
    return simple.TerrainLevelOfDetail(Input=terrain, UseCulling=0)


def particle_levels():
    sea = simple.SeaState(NumberOfTrains=5)
    particles = simple.SuspendedParticles(Density=0.05)
    levels = simple.ParticleLevelOfDetail(Input=particles, SeaState=sea, UseCulling=0, VisibleDistance=0.0)
    return simple.ParticleOrbits(Input=levels, SeaState=sea)


PIPELINES = (simple.Seaweed, tree, forest, swaying_tree, swaying_forest, kelp, terrain_levels, particle_levels)
TRANSLUCENT = (simple.Seaweed, tree, terrain_levels)


def check_structure(output, name):
    """Both ranks have the same blocks, none of them null."""
    with tempfile.TemporaryDirectory() as folder:
        seen = simple.ProgrammableFilter(Input=output, Script=STRUCTURE.replace("{folder!r}", repr(folder)))
        seen.UpdatePipeline()
        simple.Delete(seen)
        ranks = []
        for rank in range(2):
            with open(os.path.join(folder, str(rank))) as file:
                ranks.append(file.read())
    assert "(null)" not in ranks[0] and ranks[0].count("\n") > 0, f"{name}: blocks\n{ranks[0]}"
    assert ranks[0] == ranks[1], f"{name}: the first rank has\n{ranks[0]}\nthe second\n{ranks[1]}"


def check_picture(output, name, opacity):
    """It is drawn, at a second time and from another place too."""
    view = simple.CreateView("RenderView")
    view.ViewSize = [200, 150]
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.BackgroundColorMode = "Single Color"
    view.Background = [0.0, 0.0, 1.0]
    simple.SetActiveView(view)
    shown = simple.Show(output, view)
    shown.Opacity = opacity
    for time in (0.0, 0.5):
        view.ViewTime = time
        simple.ResetCamera(view)
        simple.Render(view)
        covered = (np.abs(colors(view) - (0, 0, 255)).max(axis=1) > 20).mean()
        assert covered > 0.001, f"{name}: {covered:.2%} of the picture is drawn at {time} s with opacity {opacity}"
    simple.Delete(view)


def end(name):
    """Ends this process: it waits for a rank that does not answer."""
    print(f"{name}: no picture after {LIMIT} s", file=sys.stderr, flush=True)
    os._exit(1)


if not shutil.which("mpirun"):
    sys.exit(125)
with connected(PORT, 2):
    simple.GetSettingsProxy("RenderViewSettings").RemoteRenderThreshold = 0.0
    for make in PIPELINES:
        name = getattr(make, "__name__", str(make))
        signal.signal(signal.SIGALRM, lambda *_: end(name))
        signal.alarm(LIMIT)
        start = clock.monotonic()
        output = make()
        check_structure(output, name)
        for opacity in (1.0, 0.5) if make in TRANSLUCENT else (1.0,):
            check_picture(output, name, opacity)
        signal.alarm(0)
        print(f"{name}: the same blocks on two ranks, drawn in {clock.monotonic() - start:.1f} s", flush=True)
        simple.Delete(output)
