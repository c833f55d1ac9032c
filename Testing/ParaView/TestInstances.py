# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=views
"""A forest as instances looks like the merged forest: in Full Surface by itself, and as ParaView's 3D Glyphs in outline.

TestServers has it before a server.
"""

import numpy as np
import quick
from paraview import simple
from window import apart, picture, small_view

SIZE = (160, 100)
SITES = """
import random
from vtkmodules.vtkCommonCore import vtkPoints
place, points = random.Random(3), vtkPoints()
for _ in range(60):
    points.InsertNextPoint(place.uniform(0, 90), place.uniform(0, 110), 0.0)
self.GetPolyDataOutput().SetPoints(points)
"""


def scene():
    """A view of trees near and far, and shrubs."""
    view = small_view(SIZE)
    view.UseColorPaletteForBackground, view.Background = 0, [0.0, 0.0, 1.0]
    prototypes = [simple.ReevesTree(Preset="Custom", NumberOfLeaves=1500, MainBranches=8, Orders=1), simple.GardnerPlant()]
    forest = simple.PlantScatter(
        Sites=simple.ProgrammableSource(OutputDataSetType="vtkPolyData", Script=SITES), Prototypes=prototypes,
        FollowCamera=0, FaceCamera=0, FarDistance=70.0, ViewPoint=[45.0, -10.0, 10.0], ViewDirection=[0.0, 1.0, -0.1])
    shown = simple.Show(forest, view)
    simple.Render(view)  # sets the camera
    view.CameraPosition, view.CameraFocalPoint = [45.0, -10.0, 10.0], [45.0, 40.0, 5.0]
    view.CameraViewUp = [0.0, 0.0, 1.0]
    return view, forest, shown


def check_forms(view, forest, where):
    forest.OutputForm = "Merged"
    merged = picture(view)
    assert (merged[:, :, 1] > merged[:, :, 2]).mean() > 0.2, f"{where}: no forest in sight"
    forest.OutputForm = "Instances"
    instances = picture(view)
    assert apart(merged, instances, 16) < 0.002, f"{where}: {apart(merged, instances, 16)} of the pixels"
    view.CameraParallelProjection = 1
    view.CameraParallelScale = 30.0
    aside = picture(view)
    forest.OutputForm = "Merged"
    assert apart(picture(view), aside, 16) < 0.002, f"{where}: in parallel projection"
    view.CameraParallelProjection = 0
    forest.OutputForm = "Instances"
    simple.Hide(forest, view)
    assert (picture(view) == [0, 0, 255]).all(), f"{where}: hidden instances are drawn"
    simple.Show(forest, view)
    assert apart(picture(view), instances, 16) == 0.0, f"{where}: shown again"


def check_camera(view, forest):
    """It fits the whole forest, not the prototypes at the origin: boxes of turned prototypes are a little larger."""
    forest.UseCulling = 0
    bounds = []
    for form in ("Merged", "Instances"):
        forest.OutputForm = form
        simple.Render(view)
        simple.ResetCamera(view)
        bounds.append(np.array([*view.CameraPosition, *view.CameraFocalPoint]))
    assert np.abs(bounds[1] - bounds[0]).max() < 0.03 * np.linalg.norm(bounds[0][3:] - bounds[0][:3]), bounds
    forest.UseCulling = 1
    view.CameraPosition, view.CameraFocalPoint = [45.0, -10.0, 10.0], [45.0, 40.0, 5.0]


def check_glyphs(view, forest, shown):
    """ParaView's own glyphs have the same outline of plants in full. (Their colors are one an instance.)"""
    forest.UseLevels, forest.UseCulling, forest.OutputForm = 0, 0, "Merged"
    shown.SetRepresentationType("Surface")
    outlines = [(picture(view) != [0, 0, 255]).any(axis=2)]
    forest.OutputForm = "Instances"
    simple.Hide(forest, view)
    points = simple.ExtractBlock(Input=forest, Selectors=["/Root/Instances"])
    glyphs = simple.Show(points, view, "GeometryRepresentation")
    glyphs.SetRepresentationType("3D Glyphs")
    glyphs.GlyphType = forest
    glyphs.UseGlyphTable, glyphs.UseCompositeGlyphTable, glyphs.GlyphTableIndexArray = 1, 1, "Prototype"
    glyphs.Orient, glyphs.OrientationMode, glyphs.SelectOrientationVectors = 1, "Quaternion", "Rotation"
    glyphs.Scaling, glyphs.ScaleMode, glyphs.SelectScaleArray, glyphs.ScaleFactor = 1, "Magnitude", "Scale", 1.0
    outlines.append((picture(view) != [0, 0, 255]).any(axis=2))
    changed = (outlines[0] != outlines[1]).mean()
    assert 0.2 < outlines[0].mean() < 0.9 and changed < 0.002, f"{changed} of the pixels differ in outline"


def main():
    view, forest, shown = scene()
    assert str(shown.Representation).strip("'") == "Full Surface"
    check_forms(view, forest, "alone")
    check_camera(view, forest)
    check_glyphs(view, forest, shown)


if __name__ == "__main__":
    main()
