# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=looks
"""The representation Full Surface spares work that ParaView does for each frame, and nobody sees it.

Two squares and a line that move: bounds are those of the visible blocks at each time, and the cells that are picked are
those of the representation Surface; no numbers of cells and points are made for polygonal data, but for strips, ghost
cells and volumes. Numbers of blocks, which ParaView makes anew at each time, are the same arrays at all times, and others
when there are more points.
"""

import numpy as np
import quick
from blocks import leaves
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

#: A line and two squares, of two cells each, 1 and 4 times as large, that move to the right by 1 a second; a point that no
#: cell uses is in the middle of the first; an empty block is between them.
BLOCKS = """
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline

def square(x, size):
    data, points, lines, cells = vtkPolyData(), vtkPoints(), vtkCellArray(), vtkCellArray()
    for u, v in ((0, 0), (1, 0), (1, 1), (0, 1), (0.5, 0.5)):
        points.InsertNextPoint(x + size * u, size * v, 0)
    lines.InsertNextCell(2, [0, 1])
    cells.InsertNextCell(3, [0, 1, 2])
    cells.InsertNextCell(3, [0, 2, 3])
    data.SetPoints(points)
    data.SetLines(lines)
    data.SetPolys(cells)
    return data

information = self.GetOutputInformation(0)
time = information.Get(Pipeline.UPDATE_TIME_STEP()) if information.Has(Pipeline.UPDATE_TIME_STEP()) else 0.0
out = self.GetOutputDataObject(0)
out.SetBlock(0, square(time, 1.0))
out.SetBlock(2, square(time + 2.0, 4.0))  # after an empty one
"""
TIMES = """
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
information = self.GetOutputInformation(0)
information.Set(Pipeline.TIME_STEPS(), [0.0, 1.0, 2.0], 3)
information.Set(Pipeline.TIME_RANGE(), [0.0, 2.0], 2)
"""
STRIP = """
from vtkmodules.vtkFiltersCore import vtkStripper, vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource
plane, triangles, strips = vtkPlaneSource(), vtkTriangleFilter(), vtkStripper()
plane.SetResolution(1, 4)
triangles.SetInputConnection(plane.GetOutputPort())
strips.SetInputConnection(triangles.GetOutputPort())
strips.Update()
self.GetOutputDataObject(0).ShallowCopy(strips.GetOutput())
"""
GHOST = """
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes
from vtkmodules.vtkFiltersSources import vtkPlaneSource
plane, ghosts = vtkPlaneSource(), vtkUnsignedCharArray()
plane.SetResolution(1, 4)
plane.Update()
ghosts.SetName(vtkDataSetAttributes.GhostArrayName())
for cell in range(4):
    ghosts.InsertNextValue(vtkDataSetAttributes.DUPLICATECELL if cell == 0 else 0)
plane.GetOutput().GetCellData().AddArray(ghosts)
self.GetOutputDataObject(0).ShallowCopy(plane.GetOutput())
"""
IDS = "vtkOriginalCellIds", "vtkOriginalPointIds"


def check_bounds(view, bounds, where):
    """A camera that is reset looks at the middle of the bounds, and its circle has their diagonal."""
    simple.ResetCamera(view)
    low, high = np.reshape(bounds, (-1, 2)).T
    assert np.allclose(view.CameraFocalPoint[:len(low)], 0.5 * (low + high)), (where, view.CameraFocalPoint)
    assert np.isclose(view.CameraParallelScale, 0.5 * np.linalg.norm(high - low)), (where, view.CameraParallelScale)


def drawn(shown):
    """The blocks that a representation draws."""
    return leaves(shown.GetClientSideObject().GetActiveRepresentation().GetRenderedDataObject(0))


def numbers(shown):
    """Which of the numbers of cells and points the drawn blocks have."""
    return {name for block in drawn(shown) for name in IDS
            if block.GetCellData().HasArray(name) or block.GetPointData().HasArray(name)}


def block_numbers(shown):
    """For each drawn block the arrays with its number, of points and of cells, and how many of which number they have."""
    arrays = [(block.GetPointData().GetArray("vtkCompositeIndex"), block.GetCellData().GetArray("vtkCompositeIndex"))
              for block in drawn(shown)]
    sizes = [(block.GetNumberOfPoints(), block.GetNumberOfCells()) for block in drawn(shown)]
    for number, made, counts in zip((1, 3), arrays, sizes):
        assert [array.GetNumberOfTuples() for array in made] == list(counts), (number, counts)
        assert {array.GetRange() for array in made} == {(number, number)}, [array.GetRange() for array in made]
        assert {int(value) for array in made for value in np.unique(vtk_to_numpy(array))} == {number}
        for array in made:  # VTK would make a list of ranges of all values and another one of those of finite ones
            kept = [array.GetInformation().Get(key()) for key in (array.PER_COMPONENT, array.PER_FINITE_COMPONENT)]
            assert kept[0] and kept[0] is kept[1], kept
    return arrays


def show(source, view, kind):
    shown = simple.Show(source, view)
    shown.SetRepresentationType(kind)
    simple.Render(view)
    return shown


def picked(source, view, column, row):
    """Corners of the cells around a pixel, in the order of the blocks."""
    simple.ClearSelection(source)
    simple.SelectSurfaceCells(Rectangle=[column - 1, row - 1, column + 1, row + 1], View=view)
    if not source.GetSelectionInput(0):
        return []
    extract = simple.ExtractSelection(Input=source)
    extract.Selection = source.GetSelectionInput(0)
    extract.UpdatePipeline()
    found = []
    for block in leaves(servermanager.Fetch(extract)):
        for k in range(block.GetNumberOfCells()):
            corners = block.GetCell(k).GetPoints()
            found.append(tuple(corners.GetPoint(m) for m in range(corners.GetNumberOfPoints())))
    simple.Delete(extract)
    return found


view = simple.CreateView("RenderView")
view.ViewSize = [100, 100]
blocks = simple.ProgrammableSource(OutputDataSetType="vtkMultiblockDataSet", Script=BLOCKS,
                                   ScriptRequestInformation=TIMES)
simple.SetActiveSource(blocks)
shown = show(blocks, view, "Full Surface")
for time in (0.0, 1.0, 2.0):
    view.ViewTime = time
    simple.Render(view)
    check_bounds(view, (time, time + 6.0, 0.0, 4.0), time)
assert numbers(shown) == set(), numbers(shown)
colors = [int(block.GetFieldData().GetArray("vtkBlockColors").GetValue(0)) for block in drawn(shown)]
assert colors == [0, 2], colors
before = block_numbers(shown)
view.ViewTime = 1.0
simple.Render(view)
assert block_numbers(shown) == before, "numbers of blocks are made anew"
blocks.Script = BLOCKS.replace("(0.5, 0.5)", "(0.5, 0.5), (0.25, 0.5)")  # one more point, and as many cells
simple.Render(view)
after = block_numbers(shown)
changed = [(old[0] is not new[0], old[1] is not new[1]) for old, new in zip(before, after)]
assert changed == [(True, False)] * 2, changed
blocks.Script = BLOCKS
view.ViewTime = 2.0
simple.Render(view)

simple.ResetCamera(view)
simple.Render(view)
PIXELS = [(x, y) for x in range(3, 100, 19) for y in range(3, 100, 19)]
ours = [picked(blocks, view, *pixel) for pixel in PIXELS]
shown.SetRepresentationType("Surface")
simple.Render(view)
theirs = [picked(blocks, view, *pixel) for pixel in PIXELS]
assert ours == theirs, [pair for pair in zip(ours, theirs) if pair[0] != pair[1]][:3]
assert len({cell for cells in ours for cell in cells}) >= 4, ours
simple.ClearSelection(blocks)

shown.SetRepresentationType("Full Surface")
for selectors, wanted in ((["/Root/Block0"], [0.0, 1.0, 0.0, 1.0]), (["/Root/Block2"], [2.0, 6.0, 0.0, 4.0]),
                          (["/"], [0.0, 6.0, 0.0, 4.0])):
    shown.BlockSelectors = selectors
    for time in (0.0, 1.0):
        view.ViewTime = time
        simple.Render(view)
        check_bounds(view, (wanted[0] + time, wanted[1] + time, *wanted[2:]), (selectors, time))
simple.Delete(blocks)

strip = simple.ProgrammableSource(OutputDataSetType="vtkPolyData", Script=STRIP)
shown = show(strip, view, "Full Surface")
assert drawn(shown)[0].GetNumberOfPoints() == 10
assert "vtkOriginalCellIds" in numbers(shown), numbers(shown)
simple.Delete(strip)

# A ghost cell is not drawn, so the numbers of the cells after it are others than its own.
ghosts = simple.ProgrammableSource(OutputDataSetType="vtkPolyData", Script=GHOST)
shown = show(ghosts, view, "Full Surface")
assert drawn(shown)[0].GetNumberOfCells() == 3, drawn(shown)[0].GetNumberOfCells()
assert "vtkOriginalCellIds" in numbers(shown), numbers(shown)
simple.Delete(ghosts)

cells = simple.Tetrahedralize(Input=simple.Wavelet(WholeExtent=[0, 4, 0, 5, 0, 6]))
shown = show(cells, view, "Full Surface")
assert numbers(shown) == set(IDS), numbers(shown)
check_bounds(view, (0.0, 4.0, 0.0, 5.0, 0.0, 6.0), "cells of a volume")
