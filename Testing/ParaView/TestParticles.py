# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=waters
"""Particles draws what ParaView's Point Gaussian draws, without a copy of the points; with Extinction it fades them as
ParaView's Calculator would.

Pictures are the same to the last bit: of blocks and of a single set, and of points that are no vertices, which are copied.
"""

import numpy as np
import quick
from paraview import simple
from window import colors

EYE, EXTINCTION, STRENGTH = (1.0, -4.0, 2.0), 0.35, 0.8
#: Two blocks of points with Radius, Alpha and RGB; each a vertex, or without cells, or a vertex of all.
BLOCKS = """
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
random = np.random.default_rng(3)
def block(count):
    data, points, vertices = vtkPolyData(), vtkPoints(), vtkCellArray()
    points.SetData(numpy_to_vtk(random.uniform(-2.0, 2.0, (count, 3)).astype(np.float32), deep=True))
    data.SetPoints(points)
    vertices.SetData({size}, numpy_to_vtkIdTypeArray(np.arange(count, dtype=np.int64), deep=True))
    data.SetVerts(vertices)
    for name, low, high in (("Radius", 0.02, 0.1), ("Alpha", 0.1, 1.0)):
        array = numpy_to_vtk(random.uniform(low, high, count).astype(np.float32), deep=True)
        array.SetName(name)
        data.GetPointData().AddArray(array)
    array = numpy_to_vtk(random.integers(80, 255, (count, 3)).astype(np.uint8), deep=True)
    array.SetName("RGB")
    data.GetPointData().AddArray(array)
    return data
out = self.GetOutputDataObject(0)
if out.IsA("vtkMultiBlockDataSet"):
    out.SetBlock(0, block(300))
    out.SetBlock(1, block(500))
else:
    out.ShallowCopy(block(800))
"""


def shown_in(view, source, kind):
    """Shows points as spots of their radius."""
    shown = simple.Show(source, view, "GeometryRepresentation")
    shown.SetRepresentationType(kind)
    shown.ColorArrayName, shown.MapScalars = ["POINTS", "RGB"], 0  # Point Gaussian has no opacities without colors
    shown.ShaderPreset, shown.GaussianRadius, shown.Emissive = "Gaussian Blur", 1.0, 0
    shown.ScaleByArray, shown.SetScaleArray, shown.UseScaleFunction = 1, ["POINTS", "Radius"], 0
    shown.OpacityTransferFunction = simple.CreatePiecewiseFunction(Points=[0.0, 0.0, 0.5, 0.0, 1.0, 1.0, 0.5, 0.0])
    shown.Opacity = 0.99
    return shown


def drawn(view):
    simple.Render(view)
    return colors(view).copy()


def main():  # scripts of sources run in the module's own names
    view = simple.CreateView("RenderView")
    view.ViewSize, view.OrientationAxesVisibility = [200, 200], 0
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = list(EYE), [0.0, 0.0, 0.0], [0.0, 0.0, 1.0]
    simple.SetActiveView(view)

    for kind, size in (("vtkMultiblockDataSet", 1), ("vtkPolyData", 1), ("vtkPolyData", 2)):
        source = simple.ProgrammableSource(OutputDataSetType=kind, Script=BLOCKS.format(size=size))
        what = f"{kind}, {size} points a vertex"
        # Without extinction: Point Gaussian.
        gaussian = shown_in(view, source, "Point Gaussian")
        expected = drawn(view)
        assert np.ptp(expected) > 100, f"{what}: nothing is drawn"
        gaussian.SetRepresentationType("Particles")
        assert np.array_equal(drawn(view), expected), f"{what}: Particles are not Point Gaussian"
        # With it: opacities of the calculator, of whose factors each shows.
        gaussian.Visibility = 0
        haze = "exp(-{} * sqrt((coordsX - {})^2 + (coordsY - {})^2 + (coordsZ - {})^2))".format(EXTINCTION, *EYE)
        faded = simple.Calculator(Input=source, ResultArrayName="Faded", Function=f"{STRENGTH} * Alpha * {haze}")
        calculated = shown_in(view, faded, "Point Gaussian")
        calculated.OpacityByArray, calculated.OpacityArray = 1, ["POINTS", "Faded"]
        dim = drawn(view)
        assert not np.array_equal(dim, expected), f"{what}: the calculator fades nothing"
        calculated.Visibility, gaussian.Visibility, particles = 0, 1, gaussian
        particles.Extinction, particles.Strength, particles.Eye = EXTINCTION, STRENGTH, list(EYE)
        assert np.array_equal(drawn(view), dim), f"{what}: fading is not that of the calculator"
        # Each property counts, and all of them leave nothing behind.
        for name, value, before in (
                ("Extinction", 0.1, EXTINCTION), ("Strength", 0.4, STRENGTH), ("Eye", [3.0, 0.0, 0.0], list(EYE))):
            setattr(particles, name, value)
            assert not np.array_equal(drawn(view), dim), f"{what}: {name} changes nothing"
            setattr(particles, name, before)
        assert np.array_equal(drawn(view), dim), f"{what}: a change leaves something behind"
        particles.Extinction, particles.Strength = 0.0, 1.0
        assert np.array_equal(drawn(view), expected), f"{what}: without extinction something fades"
        particles.Visibility = 0

    # Nothing is copied: who draws a block holds the array of the source, which a copy does not.
    def holders(kind):
        source = simple.ProgrammableSource(OutputDataSetType="vtkMultiblockDataSet", Script=BLOCKS.format(size=1))
        shown = shown_in(view, source, kind)
        drawn(view)
        own = source.SMProxy.GetClientSideObject().GetOutputDataObject(0).GetBlock(0)
        shown.Visibility = 0
        return own.GetPointData().GetArray("Radius").GetReferenceCount()

    assert holders("Particles") > holders("Point Gaussian"), "Particles has arrays of its own"


main()
