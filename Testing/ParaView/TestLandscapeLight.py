# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=looks
# run-with: pvpython tier=all args=each
"""Landscape Light lights the view that shows it, and no other: what is hidden leaves the bytes as they were. Under it,
colors that are to be read, annotations, volumes, selections and screenshots are as without it.

A ball over a plane, with a shadow where the sun puts it. With the argument `each`, panes of glass too, whose shaders take
a while. TestLightBeforeServer has servers and ranks.
"""

import sys

import numpy as np
import quick
import TestTextures
from mistakes import Messages
from paraview import simple
from paraview.servermanager import Fetch
from paraview.vtk.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader
from together import reset
from window import colors, picture, small_view

SIZE = [240, 160]
SUN = {"SunElevation": 45.0, "SunAzimuth": 270.0, "MapSize": "1024"}


def look(view, eye=(0.0, -9.0, 7.0), target=(0.0, 0.0, 0.5)):
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = list(eye), list(target), [0.0, 0.0, 1.0]
    view.CameraViewAngle = 30.0


def scene(size=SIZE):
    """A view of a ball 1 m above a plane."""
    view = small_view(size)
    ground = simple.Plane(Origin=[-3.0, -3.0, 0.0], Point1=[3.0, -3.0, 0.0], Point2=[-3.0, 3.0, 0.0],
                          XResolution=12, YResolution=12)
    ball = simple.Sphere(Center=[0.0, 0.0, 1.5], Radius=0.5, ThetaResolution=32, PhiResolution=32)
    simple.Show(ground, view)
    simple.Show(ball, view).DiffuseColor = [0.8, 0.3, 0.2]
    simple.Render(view)
    look(view)
    return view, ground, ball


def pixel_of(view, place):
    """Column and row of a place."""
    renderer = view.GetRenderer()
    renderer.SetWorldPoint(*place, 1.0)
    renderer.WorldToDisplay()
    return [int(number) for number in renderer.GetDisplayPoint()[:2]]


def shade_at(view, lit, place):
    column, row = pixel_of(view, place)
    return lit[row - 1:row + 2, column - 1:column + 2].mean()


def check_light(view, light):
    """The shadow is where the sun puts it, for two suns, and the view without the light as before; returns the display."""
    before = picture(view)
    shown = simple.Show(light, view, **SUN)
    lit = picture(view)
    assert not np.array_equal(lit, before), "no light"
    west, east = (-1.5, 0.0, 0.0), (1.5, 0.0, 0.0)  # 45 degrees high, in the west
    assert shade_at(view, lit, east) < 0.75 * shade_at(view, lit, west), "no shadow in the east of the ball"
    shown.SunAzimuth = 90.0
    other = picture(view)
    assert shade_at(view, other, west) < 0.75 * shade_at(view, other, east), "no shadow in the west of the ball"
    view.UseFXAA = 0
    assert not np.array_equal(picture(view), other), "edges are not smoothed"
    view.UseFXAA = 1
    simple.Hide(light, view)
    assert np.array_equal(picture(view), before), "a view without light is another one after it"
    simple.Show(light, view)
    assert np.array_equal(picture(view), other), "another light when it is shown again"
    return shown


def check_clock(view, shown):
    """NREL's example (Reda and Andreas 2008): 39.888 degrees high, from 194.340 degrees."""
    shown.SunPlacement, shown.Date, shown.Hours = "Clock", [2003, 10, 17], 19.508333
    shown.Latitude, shown.Longitude = 39.742476, -105.1786
    by_clock = picture(view)
    shown.SunPlacement, shown.SunElevation, shown.SunAzimuth = "Angles", 39.888, 194.340
    assert np.abs(picture(view) - by_clock).max() <= 2, "the clock has another sun than its angles"


def check_two_views(view, light):
    """A second view of the same things is lit only by a light of its own."""
    second, _, _ = scene()
    plain = picture(second)
    lit = picture(view)
    simple.Show(light, second, **SUN)
    assert not np.array_equal(picture(second), plain)
    simple.Hide(light, second)
    assert np.array_equal(picture(second), plain) and np.array_equal(picture(view), lit)
    simple.Delete(second)
    simple.SetActiveView(view)


def selected(source, view, kind):
    getattr(simple, kind)(Rectangle=[80, 40, 130, 90], View=view)
    found = simple.ExtractSelection(Input=source, Selection=source.GetSelectionInput(0))
    data = Fetch(found)
    simple.Delete(found)
    source.SMProxy.SetSelectionInput(0, None, 0)
    attributes, name = ((data.GetPointData(), "vtkOriginalPointIds") if kind.endswith("Points") else
                        (data.GetCellData(), "vtkOriginalCellIds"))
    return sorted(vtk_to_numpy(attributes.GetArray(name)))


def check_selection(view, ground, light):
    """The same points and cells are selected through the view with the light and without."""
    for kind in ("SelectSurfacePoints", "SelectSurfaceCells"):
        simple.Show(light, view)
        simple.Render(view)
        lit = selected(ground, view, kind)
        simple.Hide(light, view)
        simple.Render(view)
        plain = selected(ground, view, kind)
        assert lit == plain and len(plain) > 10, f"{kind}: {lit} with the light, {plain} without"
    simple.Show(light, view)


def check_screenshot(view):
    lit = picture(view)
    simple.SaveScreenshot("lit.png", view, ImageResolution=SIZE)
    reader = vtkPNGReader()
    reader.SetFileName("lit.png")
    reader.Update()
    saved = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(lit.shape)
    assert np.array_equal(saved, lit), "a screenshot is another picture"


def check_drag(view):
    """A drag has coarser pixels, also of a scene below ParaView's threshold; the picture after it is the one before."""
    still = picture(view)
    view.SMProxy.InteractiveRender()
    dragged = colors(view).reshape(still.shape)
    changes = (np.abs(dragged - still).max(axis=2) > 8).mean()
    assert 0.0 < changes < 0.1, f"{changes:.3f} of the pixels change while dragging"
    assert np.array_equal(picture(view), still), "a drag leaves another picture behind"


def check_others(view, light):
    """Colors to be read keep their values, a text, a legend and the cross of the axes are drawn, a volume too."""
    view.OrientationAxesVisibility = 1
    view.UseColorPaletteForBackground, view.BackgroundColorMode = 0, "Gradient"
    view.Background, view.Background2 = [0.2, 0.3, 0.9], [0.9, 0.1, 0.1]
    board = simple.Plane(Origin=[-1.0, 0.0, -1.0], Point1=[1.0, 0.0, -1.0], Point2=[-1.0, 0.0, 1.0])
    colored = simple.Elevation(Input=board, LowPoint=[0.0, 0.0, -1.0], HighPoint=[0.0, 0.0, 1.0])
    shown = simple.Show(colored, view)
    simple.ColorBy(shown, ("POINTS", "Elevation"))
    shown.SetScalarBarVisibility(view, True)
    words = simple.Text(Text="West wind")
    simple.Show(words, view).WindowLocation = "Upper Left Corner"
    simple.Render(view)
    look(view, (0.0, -8.0, 0.0), (0.0, 0.0, 0.0))
    before = picture(view)
    display = simple.Show(light, view, **SUN)
    lit = picture(view)
    column, row = pixel_of(view, (0.0, 0.0, 0.0))
    middle = np.s_[row - 20:row + 20, column - 20:column + 20]
    assert np.abs(lit[middle] - before[middle]).max() <= 1, "a color map has other colors"
    display.ShowSky = 0
    sides = np.s_[SIZE[1] // 2:, ::SIZE[0] - 1]
    assert np.array_equal(picture(view)[sides], before[sides]), "another background than the view's"
    display.ShowSky = 1
    display.LightsColorMaps = 1
    assert np.abs(picture(view)[middle] - before[middle]).max() > 12, "a color map that is to be lit is not"
    display.LightsColorMaps = 0
    assert np.array_equal(picture(view), lit), "a color map stays lit"
    corner = np.s_[:SIZE[1] // 4, :SIZE[0] // 5]
    assert (lit[corner][..., 1] - lit[corner][..., ::2].max(axis=-1) > 80).sum() > 5, "no cross of the axes"
    simple.HideAll(view)
    simple.Show(light, view)
    bare = picture(view)
    simple.Show(words, view)
    assert (np.abs(picture(view) - bare).max(axis=-1) > 60).sum() > 60, "no text"
    simple.HideAll(view)
    image = simple.Wavelet(WholeExtent=[-5, 5, -5, 5, -5, 5])
    volume = simple.Show(image, view)
    volume.SetRepresentationType("Volume")
    look(view, (0.0, -40.0, 0.0), (0.0, 0.0, 0.0))
    fog = picture(view)
    simple.Show(light, view)
    cloud = picture(view)
    simple.Hide(image, view)
    sky = picture(view)
    part = (np.abs(cloud - sky).max(axis=-1) > 12).mean()
    assert part > 0.1, f"{part:.1%} of the picture are a volume"
    simple.Hide(light, view)
    simple.Show(image, view)
    assert np.array_equal(picture(view), fog), "a view of a volume is another one after the light"
    simple.HideAll(view)
    simple.Show(colored, view), simple.Show(words, view)
    shown.SetScalarBarVisibility(view, True)
    look(view, (0.0, -8.0, 0.0), (0.0, 0.0, 0.0))
    assert np.array_equal(picture(view), before), "another background"
    simple.HideAll(view)


def check_glass(view, light):
    """Three panes, one behind the other, look the same in whatever order they were added."""
    simple.Show(light, view, **SUN)
    look(view, (0.0, -9.0, 1.0), (0.0, 0.0, 0.0))
    seen = []
    for order in ((0, 1, 2), (2, 0, 1)):
        panes = [simple.Plane(Origin=[-1.0, -k, -1.0], Point1=[1.0, -k, -1.0], Point2=[-1.0, -k, 1.0]) for k in order]
        for k, pane in zip(order, panes):
            glass = simple.Show(pane, view)
            glass.Opacity, glass.DiffuseColor = 0.5, [float(k == part) for part in range(3)]
        seen.append(picture(view))
        for pane in panes:
            simple.Delete(pane)
    assert np.abs(seen[0] - seen[1]).max() <= 1, "the order of panes makes a difference"
    assert np.ptp(seen[0][SIZE[1] // 2, SIZE[0] // 2]) > 30, "panes without color"


def linear(code):
    """Part of the light of white of a color of the display (IEC 61966-2-1)."""
    return code / 12.92 if code <= 0.04045 else ((code + 0.055) / 1.055) ** 2.4


def check_leaves(view, light):
    """Boards that face away from the sun: one is dark, one of leaves has 0.4 of the light on its far side."""
    script = TestTextures.SQUARES.replace("x + 2 * u, 2 * v, 0)", "x + 2 * u, 0, 2 * v)").replace(
        "[(0, 0, 1)] * 4", "[(0, -1, 0)] * 4").replace('"Cut"', '"0 High/Leaves"')
    boards = simple.Show(simple.ProgrammableSource(OutputDataSetType="vtkMultiblockDataSet", Script=script), view)
    boards.SetRepresentationType("Full Surface")
    simple.ColorBy(boards, ("POINTS", "RGB"))
    boards.MapScalars = 0
    simple.Render(view)
    look(view, (4.0, -20.0, 1.0), (4.0, 0.0, 1.0))
    display = simple.Show(light, view, SunElevation=30.0, SunAzimuth=0.0, FilmCurve=0, OcclusionRadius=0.0, MapSize="512",
                          ExposureCompensation=-1.0, VisibilityDistance=1e9)
    boards = {"wood": (1.0, 0.0, 1.0), "leaf": (3.5, 0.0, 1.0)}
    found = {}
    for side, azimuth in (("back", 0.0), ("front", 180.0)):
        display.SunAzimuth = azimuth
        lit = picture(view)
        for board, place in boards.items():
            column, row = pixel_of(view, place)
            found[side, board] = linear(lit[row, column, 0] / 255.0)
    wanted = found["back", "wood"] + 0.4 * found["front", "wood"]
    assert abs(found["back", "leaf"] / wanted - 1.0) < 0.03, f"backlit leaves are {found['back', 'leaf']}, not {wanted}"
    simple.HideAll(view)


def check_mistake(view, light):
    """A bad property is one message for all pictures, which are as without the light meanwhile."""
    simple.Hide(light, view)
    plain = picture(view)
    shown = simple.Show(light, view)
    with Messages() as messages:
        shown.Turbidity = 20.0
        unlit = [picture(view) for _ in range(3)]
    assert len(messages.lines) == 1 and "Turbidity" in messages.lines[0], messages.lines
    assert [np.array_equal(one, plain) for one in unlit] == [True] * 3, "another picture than without the light"
    shown.Turbidity = 2.5


def check_first_look(light):
    """A view that shows a light alone counts as empty: the first look of a sea is the same there."""
    looks = []
    for is_lit in (0, 1):
        view = small_view([60, 40])
        if is_lit:
            simple.Show(light, view)
        simple.Render(view)
        simple.Show(simple.SeaState(NumberOfTrains=3), view)
        looks.append([*view.GetActiveCamera().GetPosition(), *view.Background2, len(view.AdditionalLights)])
        simple.Delete(view)
    assert looks[0] == looks[1] and looks[0][2] == 9.0, f"another first look beside a light: {looks}"


def name_of(proxy):
    return next(key[0] for key, one in simple.GetSources().items() if one == proxy)


def check_state(lit, *names):
    """The light comes back with a state; returns the view and the sources of these names."""
    simple.SaveState("light.pvsm")
    reset()
    simple.LoadState("light.pvsm")
    view = simple.GetRenderViews()[0]
    view.ViewSize = SIZE
    assert np.array_equal(picture(view), lit), "another light after a state"
    return view, *map(simple.FindSource, names)


def check_deletion(view, light):
    lit = picture(view)
    simple.Delete(light)
    assert not np.array_equal(picture(view), lit), "lit by a light that was deleted"


def main():
    light = simple.LandscapeLight()
    view = small_view(SIZE)
    check_others(view, light)
    check_leaves(view, light)
    if "each" in sys.argv:
        check_glass(view, light)
    simple.Delete(view)
    check_first_look(light)
    view, ground, _ = scene()
    check_clock(view, check_light(view, light))
    check_two_views(view, light)
    check_screenshot(view)
    check_drag(view)
    check_mistake(view, light)
    lit, names = picture(view), [name_of(light), name_of(ground)]
    del view, light, ground  # VTK fails where a window outlives its session
    view, light, ground = check_state(lit, *names)
    check_selection(view, ground, light)
    check_deletion(view, light)


if __name__ == "__main__":
    main()
