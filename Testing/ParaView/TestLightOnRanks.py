# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvbatch mpi=1,2,3 tier=all
"""Landscape Light has the same picture of surfaces on one rank and spread over ranks, where those of one rank shade
those of another, and of a sea, its bed, a river and woods on 1, 2 and 3 ranks; the sky is there where nothing is, and where
pictures are composed in order."""

import numpy as np
import quick
from paraview import simple
from paraview.servermanager import vtkProcessModule
from paraview.vtk.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader
from window import small_view

SIZE = [240, 160]

module = vtkProcessModule.GetProcessModule()
ranks, rank = module.GetNumberOfLocalPartitions(), module.GetPartitionId()

#: A ground and three boxes above it, all on the first rank or each on another.
BOXES = """
from paraview.servermanager import vtkProcessModule
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkFiltersCore import vtkAppendPolyData

module = vtkProcessModule.GetProcessModule()
ranks, rank = module.GetNumberOfLocalPartitions(), module.GetPartitionId()
append = vtkAppendPolyData()
for box in range(4):
    if box % ({spread} * (ranks - 1) + 1) == rank:
        cube = vtkCubeSource()
        cube.SetBounds(-4, 4, -4, 4, -0.2, 0) if box == 0 else cube.SetBounds(
            2 * box - 4.5, 2 * box - 3.5, -0.5, 0.5, 1, 2)
        append.AddInputConnection(cube.GetOutputPort())
if append.GetNumberOfInputConnections(0):
    append.Update()
    self.GetOutput().ShallowCopy(append.GetOutput())
"""


def picture_of(view):
    """The picture of a view on the first rank, else black."""
    simple.Render(view)
    simple.SaveScreenshot(f"light-{ranks}.png", view, ImageResolution=SIZE)
    if rank > 0:
        return np.zeros((SIZE[1], SIZE[0], 3), int)
    reader = vtkPNGReader()
    reader.SetFileName(f"light-{ranks}.png")
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(SIZE[1], SIZE[0], -1).astype(int)


def look(view, eye):
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = eye, [0.0, 0.0, 0.5], [0.0, 0.0, 1.0]


def pictures(view, light, spread):
    """Pictures of the boxes under two suns, from two places, with a lens, and without the light."""
    shown = simple.Show(simple.ProgrammableSource(Script=BOXES.format(spread=spread)), view)
    shown.DiffuseColor = [0.5, 0.5, 0.5]  # white would send on all the light that is hidden
    simple.Render(view)
    look(view, [0.0, -14.0, 8.0])
    display = simple.Show(light, view, SunElevation=40.0, SunAzimuth=250.0, MapSize="512", ContactRadius=1.5,
                          Aperture=0.0)
    found = {"lit": picture_of(view)}
    display.SunAzimuth = 110.0
    found["another sun"] = picture_of(view)
    look(view, [2.0, -14.0, 2.0])
    found["another place"] = picture_of(view)
    display.Aperture, display.FocusDistance = 0.4, 6.0
    found["with a lens"] = picture_of(view)
    display.Visibility = 0
    found["unlit"] = picture_of(view)
    shown.Visibility = 0
    return found


def check_sky(view, light):
    """The sky around a translucent surface, before which ranks compose in order, is that around an opaque one."""
    simple.Show(light, view)
    pane = simple.Plane(Origin=[-2.0, -3.0, 0.5], Point1=[2.0, -3.0, 0.5], Point2=[-2.0, -3.0, 3.0])
    glass = simple.Show(pane, view)
    opaque = picture_of(view)
    glass.Opacity = 0.5
    seen = picture_of(view)
    part = (np.abs(seen - opaque).max(axis=-1) > 1).mean()
    assert rank > 0 or 0.1 < part < 0.4, f"{part:.1%} of the picture are glass before a sky"
    corners = np.s_[::SIZE[1] - 1, ::SIZE[0] - 1]
    assert np.array_equal(seen[corners], opaque[corners]), "another sky beside glass"


def compare_with_one(name, seen):
    """A picture is that of one rank, on which this test runs first."""
    if rank == 0:
        np.save(f"{name}-{ranks}.npy", seen)
        apart = np.abs(seen - np.load(f"{name}-1.npy")).max(axis=-1)
        print(f"{name}, {ranks} ranks: {(apart > 1).mean():.2%} of the picture are another, by {apart.max()}", flush=True)
        assert (apart > 1).mean() < 0.0005, f"{name}: another picture on {ranks} ranks"


def check_water(view, light):
    """A sea over its bed and a river in its valley, from above and in the water, are those of one rank."""
    bed = simple.TurningBandsTerrain(WholeExtent=[0, 40, 0, 40, 0, 0], Spacing=[2.0, 2.0, 1.0], Origin=[-40.0, -40.0, 0.0],
                                     Mean=-3.0, StandardDeviation=1.2, Range=40.0)
    sea = simple.SeaSurface(Input=simple.SeaState(NumberOfTrains=20, WindSpeed=4.0, WaterDepth=6.0), Radius=40.0)
    drained = simple.Drainage(Input=bed, StreamThreshold=30)
    rivers = simple.RiverSurface(Input=simple.OutputPort(drained, 1), Terrain=drained, WidthOfUnitArea=60.0)
    simple.Show(drained, view)
    simple.Render(view)
    simple.Show(light, view, MapSize="512", WaterRipples=0)
    for name, shown, eye in (("sea", sea, [3.0, -14.0, 2.0]), ("in the sea", sea, [14.0, -24.0, -1.0]),
                             ("river", rivers, [3.0, -30.0, 60.0])):
        simple.Show(shown, view)
        look(view, eye)
        compare_with_one(name, picture_of(view))
        simple.Hide(shown, view)
    simple.Hide(drained, view)
    check_beds(view, sea, bed, simple.Show(light, view))


def check_beds(view, sea, bed, display):
    """A sea over a bed of which each rank has a piece, by a lens, by four samples a pixel, and in parallel projection."""
    simple.Show(sea, view)
    simple.Show(bed, view)
    look(view, [3.0, -14.0, 2.0])
    display.Aperture, display.FocusDistance = 0.4, 6.0
    compare_with_one("sea behind a lens", picture_of(view))
    display.Aperture, display.Quality = 0.0, "Best"
    compare_with_one("sea in samples", picture_of(view))
    display.Quality = "Good"
    view.CameraParallelProjection, view.CameraParallelScale = 1, 8.0
    look(view, [3.0, -14.0, 9.0])
    compare_with_one("sea in parallel", picture_of(view))


def check_woods(view, light):
    """Hills with woods on their ridges, of which each rank has some."""
    hills = simple.TurningBandsTerrain(WholeExtent=[0, 100, 0, 100, 0, 0], Spacing=[40.0, 40.0, 1.0], Mean=0.0,
                                       Origin=[-2000.0, -2000.0, 0.0], StandardDeviation=120.0, Range=4000.0,
                                       MinimumWavelength=400.0)
    simple.Show(hills, view)
    simple.Render(view)
    simple.Show(light, view, WoodCover=0.5)
    look(view, [0.0, -4500.0, 420.0])
    view.CameraViewAngle = 7.0
    compare_with_one("woods", picture_of(view))


def main():
    view, light = small_view(SIZE), simple.LandscapeLight()
    wanted, seen = (pictures(view, light, spread) for spread in (0, 1))
    check_sky(view, light)
    check_water(small_view(SIZE), light)
    check_woods(small_view(SIZE), light)
    for name in wanted:
        apart = np.abs(seen[name] - wanted[name]).max(axis=-1)
        print(f"{name}, {ranks} ranks: {(apart > 1).mean():.2%} of the picture are another, by {apart.max()}", flush=True)
        assert (apart > 1).mean() < 0.0005, f"{name}: another picture on {ranks} ranks"
    blurred = np.abs(wanted["with a lens"] - wanted["another place"]).max(axis=-1)
    assert rank > 0 or (blurred > 12).mean() > 0.01, "no blur"
    assert rank > 0 or (np.abs(wanted["lit"] - wanted["another sun"]).max(axis=-1) > 12).mean() > 0.02, "no shadows"


main()
