# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=views
"""Macros: a forest of a CSV file has its trees and their heights; a twin has the grid and the variance of its place; a
film has the light of what moves in equal steps."""
import contextlib
import io
import os
import runpy
import tempfile

import numpy as np
import quick
from littoral import film
from paraview import servermanager, simple
from player import picture as picture_of
from states import visible
from window import small_view
from vtkmodules.util.numpy_support import vtk_to_numpy

MACROS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "paraview-plugin", "Macros")


def run(name):
    runpy.run_path(os.path.join(MACROS, name))


TABLES = {  # rows, and heights where they were measured
    "heights": ("x,y,species,height\n0,0,pine,10\n20,0,oak,12\n0,30,Birch,8\n20,30,elm,6\n", [10.0, 12.0, 8.0, 6.0]),
    "diameters": ("gx,gy,sp,dbh,status\n0,0,Pinus taeda,250,A\n20,0,oak,420,A\n0,30,oak,NA,A\n20,30,elm,60,D\n", None),
}


def tops(data, count):
    """Height of each plant, whose ground is level, by its polygons [m]."""
    heights = np.zeros(count)
    for part in (1, 2):
        leaf = data.GetBlock(0).GetBlock(part)
        np.maximum.at(heights, vtk_to_numpy(leaf.GetPointData().GetArray("PlantId")),
                      vtk_to_numpy(leaf.GetPoints().GetData())[:, 2])
    return heights


for name, (rows, measured) in TABLES.items():
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "trees.csv")
        with open(file, "w", encoding="utf-8") as out:
            out.write(rows)
        table = simple.CSVReader(FileName=[file])
        table.UpdatePipeline()
        chosen = simple.StandInventory(Inventory=table)  # columns are chosen from the table's
        columns = chosen.GetProperty("DiameterColumn").Available
        assert set(columns) == {"", *rows.split("\n")[0].split(",")}, columns
        simple.Delete(chosen)
        simple.SetActiveSource(table)
        run("forest_from_inventory.py")
        stand = servermanager.Fetch(simple.FindSource("Stand"))
    heights = vtk_to_numpy(stand.GetPointData().GetArray("Height"))
    assert measured is None or heights.tolist() == measured, heights
    forest = simple.GetActiveSource()
    forest.UseLevels = 0
    forest.UseCulling = 0
    forest.UpdatePipeline()
    data = servermanager.Fetch(forest)
    assert data.GetFieldData().GetArray("PlantsShown").GetValue(0) == (4 if measured else 3)
    assert np.allclose(tops(data, len(heights)), heights, rtol=1e-4), tops(data, len(heights))
    print("an inventory of", name, "has the heights of its trees")
    simple.ResetSession()

place = simple.TurningBandsTerrain(WholeExtent=[0, 90, 0, 70, 0, 0], Spacing=[10.0, 10.0, 1.0], Seed=5)
place.UpdatePipeline()
simple.SetActiveSource(place)
simple.Show(place)
run("twin_from_raster.py")
assert visible(simple.GetActiveView()) == ["Ground", "Light", "Valleys"], visible(simple.GetActiveView())
valleys, ground = servermanager.Fetch(simple.FindSource("Valleys")), servermanager.Fetch(simple.FindSource("Ground"))
heights = [np.sort(vtk_to_numpy(one.GetPointData().GetScalars())) for one in (servermanager.Fetch(place), valleys)]
assert np.abs(heights[0] - heights[1]).max() < 0.1 * heights[0].std(), "heights of the place"
counts = [ground.GetFieldData().GetArray(f"Polygons{of}").GetValue(0) for of in ("Shown", "AtFullDetail")]
assert 0.2 * counts[1] < counts[0] <= counts[1], f"{counts[0]} of {counts[1]} triangles"
for name in ("Fit", "Valleys", "Ground"):
    chosen = simple.FindSource(name).GetProperty("Array")
    assert list(chosen)[1:] == ["Elevation"], f"{name}: Array is {list(chosen)}"
twin = simple.GetActiveSource()
twin.UpdatePipeline()
assert tuple(twin.GetDataInformation().GetBounds()[:4]) == (0.0, 900.0, 0.0, 700.0)
heights = [vtk_to_numpy(servermanager.Fetch(one).GetPointData().GetScalars()) for one in (place, twin)]
assert (heights[0] != heights[1]).any()
ratio = heights[1].std() / heights[0].std()
assert 0.4 < ratio < 2.5, ratio
print("a twin has", ratio, "times the standard deviation of its place")



def said_by(macro):
    said = io.StringIO()
    with contextlib.redirect_stdout(said):
        run(macro)
    return said.getvalue()


def moving_board():
    """A view, without light and smoothed edges, of a white board that moves by 64 pixels a frame to the right."""
    view = small_view([240, 60])
    view.UseColorPaletteForBackground, view.BackgroundColorMode, view.Background = 0, "Single Color", [0.0, 0.0, 0.0]
    board = simple.Box(XLength=60.0, YLength=40.0, ZLength=1.0)
    shown = simple.Show(board, view)
    shown.AmbientColor, shown.Ambient, shown.Diffuse = [1.0, 1.0, 1.0], 1.0, 0.0
    scene = simple.GetAnimationScene()
    scene.PlayMode, scene.StartTime, scene.EndTime, scene.NumberOfFrames = "Sequence", 0.0, 2.0, 3
    track = simple.GetAnimationTrack("Center", 0, board)
    track.KeyFrames = [simple.CompositeKeyFrame(KeyTime=time, KeyValues=[end]) for time, end in enumerate((40.3, 168.3))]
    simple.Render(view)
    view.UseFXAA, view.CameraParallelProjection, view.CameraParallelScale = 0, 1, 30.0
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [120, 0, 50], [120, 0, 0], [0, 1, 0]


def check_film(folder):
    """Behind and before a board that moves while the shutter is half open the light is k/8, for 4 pixels each."""
    frames, save = [], film.save_film

    def watched(filename, pictures, frames_per_second):
        frames.extend(picture_of(picture)[30, :, 0] / 255.0 for picture in pictures)
        save(filename, pictures, frames_per_second)

    film.save_film, home = watched, os.environ["HOME"]
    os.environ["HOME"] = folder
    for name in ("film.ogv", "film-2.ogv"):
        assert said_by("film_with_motion_blur.py") == f"{os.path.join(folder, name)} has 3 frames of 8 pictures each.\n"
        with open(os.path.join(folder, name), "rb") as file:
            assert file.read(4) == b"OggS"
    film.save_film, os.environ["HOME"] = save, home
    for frame, codes in enumerate(frames[:2]):  # after the end nothing moves
        light = np.where(codes <= 0.04045, codes / 12.92, ((codes + 0.055) / 1.055) ** 2.4)  # IEC 61966-2-1
        steps, counts = np.unique(np.round(8.0 * light, 1), return_counts=True)
        assert np.abs(steps - np.arange(9)).max() < 0.11 and (counts[1:8] == 8).all(), (frame, steps, counts)


simple.ResetSession()
assert said_by("film_with_motion_blur.py").startswith("Select a view in three dimensions ")
moving_board()
with tempfile.TemporaryDirectory() as films:
    check_film(films)
print("a film has the light of what moves")

# Something else selected, or nothing: one sentence, and nothing is made.
for selected in (simple.Sphere(), None):
    simple.SetActiveSource(selected)
    before = len(simple.GetSources())
    for name in ("twin_from_raster.py", "forest_from_inventory.py"):
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            run(name)
        assert said.getvalue().startswith("Select ") and said.getvalue().count("\n") == 1, said.getvalue()
    assert len(simple.GetSources()) == before
