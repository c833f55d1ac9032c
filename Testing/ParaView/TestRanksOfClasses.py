# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvbatch mpi=1,2 args=0
# run-with: pvbatch mpi=1,2 args=1
"""Small examples of all classes, by their rows, are the same on any number of ranks.

The run on one rank writes its results; the others compare with them. Each run takes every second row, from the given
one on.
"""

import hashlib
import json
import os
import sys

import numpy as np
import quick
from mistakes import classes, pv
from paraview import servermanager, simple
from paraview.servermanager import vtkProcessModule
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDataArray

TIME = 0.7
# VTK's reader stumbles over field data that are NaN and have come from another rank.
WITHOUT_FIELDS = """output = self.GetOutputDataObject(0)
output.ShallowCopy(self.GetInputDataObject(0, 0))
output.GetFieldData().Initialize()"""
ranks = vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions()


def rows_of(data):
    """Points with their arrays, or the rows of a table, each once and in an order of their own: ranks share borders."""
    is_table = data.IsA("vtkTable")
    attributes = data.GetRowData() if is_table else data.GetPointData()
    arrays = [] if is_table or not data.GetNumberOfPoints() else [data.GetPoints().GetData()]
    arrays += [attributes.GetAbstractArray(index)
               for index in sorted(range(attributes.GetNumberOfArrays()), key=attributes.GetArrayName)
               if isinstance(attributes.GetAbstractArray(index), vtkDataArray)]
    columns = [np.ascontiguousarray(vtk_to_numpy(array).reshape(array.GetNumberOfTuples(), -1)).view(np.uint8)
               for array in arrays if array.GetNumberOfTuples() and not (array.GetName() or "").startswith("vtk")]
    if not columns:
        return np.empty(0)
    lines = np.ascontiguousarray(np.concatenate(columns, axis=1))
    return np.unique(lines.view(np.dtype((np.void, lines.shape[1]))))


def parts_of(proxy, port):
    """What an output consists of: names, and data of all ranks as points or tables: proxies and their ports. Further
    images are textures, of which each rank has its own."""
    output = simple.OutputPort(proxy, port)
    information = proxy.GetDataInformation(port)
    if information.GetDataClassName() == "vtkImageData":
        if port == 0:
            yield "", simple.ConvertToPointCloud(Input=output), 0
    elif information.GetDataClassName() == "vtkTable":
        yield "", proxy, port
    elif not information.IsCompositeDataSet():
        yield "", simple.ProgrammableFilter(Input=output, Script=WITHOUT_FIELDS), 0
    else:
        blocks = information.GetHierarchy()
        for node in blocks.GetChildNodes(blocks.GetRootNode(), True, 0):
            if blocks.GetNumberOfChildren(node) == 0:
                path = blocks.GetNodePath(node)
                one = simple.ExtractBlock(Input=output, Selectors=[path])
                yield path, simple.MergeBlocks(Input=one, MergePoints=0), 0


def results_of(name):
    """Numbers of rows and hashes of all outputs of a class."""
    proxy = pv.small_example(name)
    proxy.UpdatePipeline(TIME)
    found = {}
    for port in range(proxy.SMProxy.GetNumberOfOutputPorts()):
        for part, one, index in parts_of(proxy, port):
            lines = rows_of(servermanager.Fetch(one, idx=index))
            found[f"{name} {port} {part}"] = [len(lines), hashlib.sha256(lines.tobytes()).hexdigest()]
    return found


# VTK warns, on each rank, where it sends an array with NaN.
simple.ProgrammableSource(Script="from vtkmodules.vtkCommonCore import vtkLogger\n"
                          "vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_ERROR)").UpdatePipeline()
results = {}
for row in classes.ROWS[int(sys.argv[1])::2]:
    if not row.is_of_files:
        results.update(results_of(row.name))
        simple.ResetSession()
empty = [name for name, (count, _) in results.items() if count == 0]
assert len(empty) < len(results) / 3, f"nothing in {empty}"
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
