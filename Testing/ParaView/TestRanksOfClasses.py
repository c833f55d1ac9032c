# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvbatch mpi=1,2 args=0
# run-with: pvbatch mpi=1,2 args=1 name=second
# run-with: pvbatch mpi=1,2 args=2 name=third
# run-with: pvbatch mpi=1,2 args=drawn name=drawn
"""Small examples of all classes, by their rows, are the same on any number of ranks, in the same blocks on each of them.

The run on one rank writes its results; the others compare with them. Each run takes every third row, from the given
one on; that from row 0 on writes the volumes of TestVolumes, too. One more draws a tree and a chart.
"""

import hashlib
import json
import os
import pickle
import sys
import tempfile

import numpy as np
import quick
import TestTwoRanks
from mistakes import Messages, classes, pv
from paraview import servermanager, simple
from paraview.servermanager import vtkProcessModule
from vtkmodules.util import numpy_support
from vtkmodules.vtkCommonCore import VTK_DOUBLE
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLImageDataWriter

TIME = 0.7
# Keeps the number of sites that plants are scattered on, in a file of the rank.
SITES = """import os
from paraview.servermanager import vtkProcessModule
scatter = self.GetInputAlgorithm(0, 0)
while not scatter.IsA("vtkPlantScatterFilter"):
    scatter = scatter.GetInputAlgorithm(0, 0)
with open(os.path.join({folder!r}, str(vtkProcessModule.GetProcessModule().GetPartitionId())), "w") as file:
    file.write(str(scatter.GetInputDataObject(0, 0).GetNumberOfPoints()))"""
# Keeps the rows of what comes in, block by block, in a file of the rank.
KEEP = """import os, pickle, sys
from paraview.servermanager import vtkProcessModule
from vtkmodules.util import numpy_support
from vtkmodules.vtkCommonCore import VTK_DOUBLE
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLImageDataWriter
sys.path.insert(0, {here!r})
from blocks import rows_by_path
rank = vtkProcessModule.GetProcessModule().GetPartitionId()
with open(os.path.join({folder!r}, str(rank)), "wb") as file:
    pickle.dump(rows_by_path(self.GetInputDataObject(0, 0)), file)"""
HERE = os.path.dirname(os.path.abspath(__file__))
ranks = vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions()


def rows_of(proxy, port):
    """The rows of an output by its blocks, each once and in an order of their own: ranks share borders."""
    with tempfile.TemporaryDirectory() as folder:
        keep = KEEP.replace("{here!r}", repr(HERE)).replace("{folder!r}", repr(folder))
        simple.ProgrammableFilter(Input=simple.OutputPort(proxy, port), Script=keep).UpdatePipeline(TIME)
        parts = []
        for rank in range(ranks):
            with open(os.path.join(folder, str(rank)), "rb") as file:
                parts.append(pickle.load(file))
    # Scripts of filters leave other functions `all` and `any` here.
    # ParaView's ranks exchange data block by block, so that a rank with fewer of them never answers.
    blocks = [sorted((path, lines is None) for path, lines in part.items()) for part in parts]
    assert blocks.count(blocks[0]) == ranks, f"ranks have other blocks: {blocks}"
    assert not [path for path, is_null in blocks[0] if is_null], f"null blocks: {blocks[0]}"
    for path, _ in blocks[0]:
        lines = [part[path] for part in parts if len(part[path])]
        if lines:
            lines = np.concatenate(lines)
            yield path, np.unique(lines.view(np.dtype((np.void, lines.shape[1]))))
        else:
            yield path, np.empty(0)


def results_of(name):
    """Numbers of rows and hashes of all outputs of a class."""
    proxy = pv.small_example(name)
    for limit in ("UseCulling", "VisibleDistance"):  # no view looks at it
        if proxy.GetProperty(limit):
            proxy.GetProperty(limit).SetData(0)
    proxy.UpdatePipeline(TIME)
    found = {}
    for port in range(proxy.SMProxy.GetNumberOfOutputPorts()):
        if port and proxy.GetDataInformation(port).GetDataClassName() == "vtkImageData":
            continue  # a texture, of which each rank has its own
        for part, lines in rows_of(proxy, port):
            found[f"{name} {port} {part}"] = [len(lines), hashlib.sha256(lines.tobytes()).hexdigest()]
    return found


def reads_raw():
    """Whether VTK reads the raw bytes that it writes, by which ParaView redistributes blocks. VTK 9.1 does not with the
    expat of Debian 12's updates, 2.5.0-1+deb12u2."""
    image = vtkImageData()
    image.SetDimensions(20, 20, 20)
    image.AllocateScalars(VTK_DOUBLE, 1)
    numpy_support.vtk_to_numpy(image.GetPointData().GetScalars())[:] = np.random.default_rng(1).normal(size=8000)
    writer, reader = vtkXMLImageDataWriter(), vtkXMLImageDataReader()
    writer.SetInputData(image)
    writer.SetFileName("raw.vti")
    writer.SetDataModeToAppended()
    writer.EncodeAppendedDataOff()
    writer.Write()
    reader.SetFileName("raw.vti")
    with Messages() as messages:
        reader.Update()
    return not messages.lines


def sites_read():
    """The number of sites that each rank reads, of 900."""
    plants = simple.PlantScatter(Sites=simple.QuadratPoints(Quadrats=[30, 10], MeanPerQuadrat=3.0), UseCulling=0,
                                 Prototypes=[simple.ReevesTree(Preset="Shrub")], FollowCamera=0)
    with tempfile.TemporaryDirectory() as folder:
        keep = SITES.replace("{folder!r}", repr(folder))
        simple.ProgrammableFilter(Input=plants, Script=keep).UpdatePipeline()
        found = []
        for rank in range(ranks):
            with open(os.path.join(folder, str(rank))) as file:
                found.append(int(file.read()))
    return found


def drawn():
    """A translucent tree of blocks, which ranks redistribute before they draw it, is drawn; a chart has its series and
    rows once, and its picture."""
    if ranks == 1 or reads_raw():
        TestTwoRanks.check_picture(pv.tree(), "tree", 0.5, (0.5,))
    charts = TestTwoRanks.draw_charts([TestTwoRanks.sea_chart], "alone" if ranks == 1 else "ranks")
    if ranks > 1:
        TestTwoRanks.compare_charts(charts, charts)  # numbers are compared below
    return {name: list(chart) for name, chart in charts.items()}


# VTK warns, on each rank, where it sends an array with NaN.
simple.ProgrammableSource(Script="from vtkmodules.vtkCommonCore import vtkLogger\n"
                          "vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_ERROR)").UpdatePipeline()
results = {}
for row in [] if sys.argv[1] == "drawn" else classes.ROWS[int(sys.argv[1])::3]:
    if not row.is_of_files:
        simple.SetActiveSource(None)
        results.update(results_of(row.name))
if sys.argv[1] == "drawn":
    read = sites_read()
    assert np.sum(read) == 900 and np.max(read) < 1.1 * 900 / ranks, read
    results.update(drawn())
elif sys.argv[1] == "0" and hasattr(servermanager.writers, "VDBVolumeWriter"):
    import TestVolumes  # noqa: F401
empty = {name.split()[0] for name in results} - {name.split()[0] for name, (count, _) in results.items() if count}
assert not empty, f"nothing in {empty}"
if ranks == 1:
    with open("results.json", "w", encoding="utf-8") as file:
        json.dump(results, file)
else:
    assert os.path.exists("results.json"), "the run on one rank comes first"
    with open("results.json", encoding="utf-8") as file:
        wanted = json.load(file)
    differing = {name: (results.get(name), wanted.get(name)) for name in {*results, *wanted}
                 if results.get(name) != wanted.get(name)}
    assert not differing, f"{ranks} ranks give another result than one: {differing}"
print(f"{len(results)} outputs on {ranks} ranks")
