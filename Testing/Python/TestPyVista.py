# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""In PyVista a plant looks as in plain VTK, to the pixel but for rounding; the example draws land, trees and water."""

import os
import runpy
import sys

try:
    import pyvista as pv
except ImportError:
    print("skipped: PyVista is not installed")
    sys.exit(125)

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, draws everything
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter

from littoral import vtkGardnerPlantSource, vtkReevesTreeSource
from littoral.plants import add_daylight, block, level_actors
from littoral.pyvista import add_plants

SKY = (0.6, 0.7, 0.9)
SIZE = (300, 300)


def place(camera):
    """A view of the whole plant."""
    camera.SetPosition(0.0, -32.0, 6.0)
    camera.SetFocalPoint(0.0, 0.0, 5.5)
    camera.SetViewUp(0.0, 0.0, 1.0)
    camera.SetViewAngle(26.0)
    camera.SetClippingRange(10.0, 60.0)


def in_vtk(source, level):
    """The picture in plain VTK, [row, column, 3]."""
    renderer, window, grab = vtkRenderer(), vtkRenderWindow(), vtkWindowToImageFilter()
    renderer.SetBackground(*SKY)
    add_daylight(renderer)
    for actor in level_actors(source, level, cut_leaves=True):
        renderer.AddActor(actor)
    place(renderer.GetActiveCamera())
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(*SIZE)
    window.AddRenderer(renderer)
    window.Render()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    return vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars()).reshape(*SIZE, 3)[::-1]


def in_pyvista(source, level):
    """The picture in PyVista."""
    plotter = pv.Plotter(off_screen=True, window_size=SIZE, lighting="none")
    plotter.disable_anti_aliasing()
    plotter.set_background(SKY)
    add_daylight(plotter.renderer)
    actors = add_plants(plotter, source.GetOutputDataObject(0), (level,))
    assert len(actors) == (1 if level == "Low" else 2), level
    place(plotter.camera)
    picture = plotter.screenshot(return_img=True)
    plotter.close()
    return picture[..., :3]


def check_plants():
    """All levels of a tree with leaves cut out."""
    tree = vtkReevesTreeSource()
    tree.SetPreset(vtkReevesTreeSource.Oak)
    tree.SetNumberOfLeaves(2000)
    tree.Update()
    for level in ("High", "Medium", "Low"):
        one, other = (draw(tree, level).astype(int) for draw in (in_vtk, in_pyvista))
        apart = abs(one - other).max(axis=-1)
        seen = (abs(one - 255.0 * np.array(SKY)) > 3.0).any(axis=-1).mean()
        print(f"{level}: the plant covers {seen:.3f} of the picture, {(apart > 8).mean():.5f} of it differ")
        assert seen > 0.05, level
        assert (apart > 8).mean() < 2e-3, level
    normals = vtk_to_numpy(block(tree.GetOutputDataObject(0), "High", "Leaves").GetPointData().GetNormals()).copy()
    plotter = pv.Plotter(off_screen=True)
    shown = add_plants(plotter, tree.GetOutputDataObject(0))[1].mapper.dataset.point_data["Normals"]
    np.testing.assert_array_equal(shown, normals)
    plotter.close()


def check_without_picture():
    """A plant without leaves to cut out is shown in its colors."""
    plant = vtkGardnerPlantSource()
    plant.Update()
    plotter = pv.Plotter(off_screen=True)
    for actor in add_plants(plotter, plant.GetOutputDataObject(0)):
        assert actor.mapper.scalar_visibility
    plotter.close()


def check_example():
    """Sky above, water below, trees and their shade between."""
    example = os.path.join(os.environ["LITTORAL_SOURCE_DIR"], "Examples", "Python", "pyvista_coast.py")
    runpy.run_path(example)["main"](".")
    picture = np.asarray(pv.Texture("pyvista_coast.png").to_array())[..., :3].astype(float)
    top, middle, bottom = (picture[rows].reshape(-1, 3) for rows in (slice(0, 20), slice(220, 400), slice(600, 640)))
    green = (middle[:, 1] > 1.1 * middle[:, 2]) & (middle[:, 1] > middle[:, 0])
    assert (top[:, 2] > 1.3 * top[:, 0]).mean() > 0.9, "no sky"
    assert (bottom[:, 1:].sum(axis=1) > 2.2 * bottom[:, 0]).mean() > 0.75, "no water"  # green over a shoal, with a sand bank
    assert green.mean() > 0.3, "no trees"


check_plants()
check_without_picture()
check_example()
