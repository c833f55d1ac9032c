# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython tier=all
"""A client with a server of two ranks: outputs in blocks have the same ones on both, empty or not, and are drawn; a chart has
its series, rows and picture once. TestOtherOnTwoRanks has the other pipelines and charts,
TestRanksOfClasses the blocks of all classes, a picture and a chart without a client.

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
from player import difference
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


def kelp():
    return simple.SeaweedDeformation(Input=simple.Seaweed(), SeaState=simple.SeaState(NumberOfTrains=5, SeaLevel=8.0))


TRANSLUCENT = [tree]


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


def check_picture(output, name, opacity, times=(0.0, 0.5)):
    """It is drawn, at each time."""
    view = simple.CreateView("RenderView")
    view.ViewSize = [100, 80]
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.BackgroundColorMode = "Single Color"
    view.Background = [0.0, 0.0, 1.0]
    simple.SetActiveView(view)
    shown = simple.Show(output, view)
    shown.Opacity = opacity
    for time in times:
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


def draw_charts(charts, folder):
    """Draw some charts; the series and the number of rows of each."""
    found = {}
    for make in charts:
        name, (table, port, kind) = make.__name__, make()
        view = simple.CreateView(kind)
        view.ViewSize = [300, 200]
        output = simple.OutputPort(table, port)
        chart = simple.Show(output, view)
        simple.Render(view)
        simple.SaveScreenshot(f"{folder}-{name}.png", view, ImageResolution=[300, 200])
        found[name] = list(chart.SeriesVisibility), output.GetDataInformation().GetNumberOfRows()
    return found


def sea_chart():
    return simple.SeaStatistics(Input=simple.SeaState(NumberOfTrains=17)), 0, "XYChartView"


def compare_charts(seen, wanted):
    for name, (series, rows) in wanted.items():
        assert series and rows, f"{name}: the chart is empty"
        assert seen[name] == wanted[name], f"{name}: series and rows are {seen[name]}, not {wanted[name]}"
        part = difference(f"ranks-{name}.png", f"alone-{name}.png")
        print(f"{name}: {len(series)} series, {rows} rows, {part:.2%} of the picture is another", flush=True)
        assert part < 0.002, f"{name}: {part:.2%} of the picture is another"


def check_pipeline(make):
    """On a server of two ranks that renders: blocks and pictures."""
    name = make.__name__
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


def check(pipelines, charts):
    if not shutil.which("mpirun"):
        sys.exit(125)
    wanted = draw_charts(charts, "alone")
    with connected(PORT, 2):
        simple.GetSettingsProxy("RenderViewSettings").RemoteRenderThreshold = 0.0
        for make in pipelines:
            check_pipeline(make)
        seen = draw_charts(charts, "ranks")
    compare_charts(seen, wanted)


if __name__ == "__main__":
    check([tree, kelp], [sea_chart])
