# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws seaweeds.jpg of the user guide: three kinds of seaweeds under water.

    ./littoral run pvpython Documentation/pictures/make_seaweeds.py [FOLDER]
"""

import os
import sys

import numpy as np
import vtkmodules.vtkRenderingFreeType  # noqa: F401, draws text
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, draws everything
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderer, vtkRenderWindow

from littoral import vtkSeaweedSource
from littoral.picture import label, write_jpg
from littoral.plants import BOTH_SIDES, block, plant_actor

SIZE = (900, 500)
OVERSAMPLING = 2
PANELS = (  # kind, title, height of what is seen [m], places and seeds, camera
    dict(kind="SugarKelp", title="Sugar kelp", seen=2.75, low=(0.05, 0.25, 0.33), high=(0.42, 0.72, 0.74),
         clear=9.0, bed=(0.50, 0.47, 0.40), rocks=26, tilt=0.02,
         plants=((0.05, 0.0, 3), (-0.75, 1.7, 4), (1.0, 2.3, 6), (-0.1, 4.2, 5), (-1.7, 4.6, 8), (1.9, 5.6, 9),
                 (0.8, 7.0, 10), (-2.7, 7.5, 2))),
    dict(kind="GiantKelp", title="Giant kelp", seen=13.6, low=(0.02, 0.19, 0.30), high=(0.50, 0.80, 0.80),
         clear=38.0, bed=(0.42, 0.42, 0.38), rocks=20, tilt=0.03,
         plants=((0.6, 0.0, 2), (-3.9, 7.0, 3), (5.2, 13.0, 4), (-1.5, 20.0, 5), (-9.5, 24.0, 6), (9.0, 30.0, 7),
                 (2.2, 34.0, 8), (-5.5, 38.0, 9))),
    dict(kind="Eelgrass", title="Eelgrass", seen=1.25, low=(0.10, 0.33, 0.34), high=(0.56, 0.80, 0.74),
         clear=4.2, bed=(0.62, 0.56, 0.44), rocks=0, tilt=0.05, plants=None))
DISTANCE = 2.9  # of the eye, in heights of what is seen

#: Light on its way through the water takes on the color that the water has there.
WATER = """//VTK::Light::Impl
  float haze = 1.0 - exp(-max(0.0, length(vertexVC.xyz) - %(near)f) / %(clear)f);
  vec3 deep = mix(vec3(%(low)s), vec3(%(high)s), gl_FragCoord.y / %(rows)f);
  gl_FragData[0].rgb = mix(gl_FragData[0].rgb, deep, haze);
"""


def under_water(actor, panel):
    """The actor as seen through water."""
    text = WATER % dict(
        near=(DISTANCE - 0.5) * panel["seen"], clear=panel["clear"], rows=OVERSAMPLING * SIZE[1],
        **{end: ", ".join(f"{c:f}" for c in panel[end]) for end in ("low", "high")})
    shader = actor.GetShaderProperty()
    shader.AddFragmentShaderReplacement("//VTK::Light::Impl", True, text, False)
    shader.AddFragmentShaderReplacement("//VTK::Normal::Impl", True, BOTH_SIDES, False)
    return actor


def caustics(x, y):
    """The net of light that waves throw on the bed, about 0 to 1; x, y in wavelengths."""
    warp_x = x + 0.35 * np.sin(2.1 * y + 1.0) + 0.2 * np.sin(4.3 * x + 2.2 * y)
    warp_y = y + 0.35 * np.sin(1.9 * x + 0.3) + 0.2 * np.sin(3.7 * y - 2.9 * x)
    net = np.abs(np.sin(2.6 * warp_x)) * np.abs(np.sin(2.6 * warp_y))
    return (1.0 - net) ** 7


def colored(data, colors):
    """The polygons with these colors, rows of 0 to 1."""
    rgb = numpy_to_vtk((255.0 * np.clip(colors, 0.0, 1.0)).astype(np.uint8), deep=True)
    rgb.SetName("RGB")
    data.GetPointData().SetScalars(rgb)
    normals = vtkPolyDataNormals()
    normals.SetInputData(data)
    normals.SplittingOff()
    normals.Update()
    return normals.GetOutput()


def bed(panel, random):
    """Sand with ripples and light, or rock."""
    seen = panel["seen"]
    plane = vtkPlaneSource()
    plane.SetOrigin(-3.0 * seen, -0.9 * seen, 0.0)
    plane.SetPoint1(3.0 * seen, -0.9 * seen, 0.0)
    plane.SetPoint2(-3.0 * seen, 6.0 * seen, 0.0)
    plane.SetResolution(500, 500)
    plane.Update()
    data = plane.GetOutput()
    points = vtk_to_numpy(data.GetPoints().GetData())
    x, y = points[:, 0] / seen, points[:, 1] / seen
    ripples = np.sin(60.0 * y + 5.0 * np.sin(2.0 * x) + 3.0 * np.sin(5.0 * x + 3.0 * y))
    bumps = np.sin(9.0 * x + 1.3) * np.sin(7.0 * y) + 0.6 * np.sin(17.0 * x - 5.0 * y) * np.sin(15.0 * y + 2.0)
    rough = 0.010 if panel["rocks"] else 0.004
    points[:, 2] = seen * (0.0012 * ripples + rough * (bumps - 1.0))
    noise = random.standard_normal(len(points))
    shade = 1.0 + 0.07 * noise + 0.05 * ripples + 0.1 * bumps
    light = 0.75 + 0.65 * caustics(6.0 * x, 6.0 * y)
    return under_water(plant_actor(colored(data, np.array(panel["bed"]) * (shade * light)[:, None])), panel)


def rock(panel, place, radius, random):
    """A boulder."""
    ball = vtkSphereSource()
    ball.SetThetaResolution(48)
    ball.SetPhiResolution(32)
    ball.Update()
    data = ball.GetOutput()
    points = vtk_to_numpy(data.GetPoints().GetData())
    unit = points / np.linalg.norm(points, axis=1)[:, None]
    size = np.ones(len(unit))
    for wave in range(1, 5):
        for _ in range(4):
            axis = random.standard_normal(3)
            size += 0.09 / wave * np.sin(1.6 * wave * unit @ axis + 6.28 * random.random())
    points[:] = radius * unit * size[:, None] * (1.0, 0.9, 0.55) + (*place, 0.0)
    light = 0.65 + 0.5 * caustics(*(6.0 * points[:, :2].T / panel["seen"])) * np.clip(unit[:, 2], 0.0, 1.0)
    tint = np.array(random.choice([(0.36, 0.35, 0.33), (0.40, 0.34, 0.33), (0.33, 0.36, 0.32)]))
    shade = light * (1.0 + 0.08 * random.standard_normal(len(unit)))
    return under_water(plant_actor(colored(data, tint * shade[:, None])), panel)


def plants_of(panel, random):
    """Places of the plants and their seeds."""
    if panel["plants"]:
        return panel["plants"]
    return [(0.23 * column + 0.12 * (row % 2) + 0.06 * random.standard_normal(), 0.25 * row - 0.1 +
             0.05 * random.standard_normal(), 20 * row + column + 30) for row in range(14)
            for column in range(-4 - row // 2, 5 + row // 2)
            if random.random() < 0.8]


def add_light(renderer):
    """Daylight from above, and what comes back from the water around."""
    renderer.AutomaticLightCreationOff()
    for towards, color, intensity in (((0.25, -0.35, 1.0), (1.0, 1.0, 0.90), 0.9),
                                       ((-0.6, -1.0, 0.25), (0.75, 0.95, 1.0), 0.5),
                                       ((0.5, 1.0, 0.5), (1.0, 1.0, 0.75), 0.35)):
        light = vtkLight()
        light.SetPosition(*(1e4 * c for c in towards))
        light.SetFocalPoint(0.0, 0.0, 0.0)
        light.SetColor(*color)
        light.SetIntensity(intensity)
        renderer.AddLight(light)


def draw(panel, index):
    """A renderer with one kind."""
    random = np.random.default_rng(5 + index)
    seen = panel["seen"]
    renderer = vtkRenderer()
    gap = 0.0022 * np.array((index > 0, index + 1 < len(PANELS)))
    renderer.SetViewport(index / len(PANELS) + gap[0], 0.0, (index + 1) / len(PANELS) - gap[1], 1.0)
    renderer.GradientBackgroundOn()
    renderer.SetBackground(*panel["low"])
    renderer.SetBackground2(*panel["high"])
    add_light(renderer)
    renderer.AddActor(bed(panel, random))
    for _ in range(panel["rocks"]):
        place = (seen * random.uniform(-1.5, 1.5), seen * random.uniform(-0.2, 3.0))
        renderer.AddActor(rock(panel, place, seen * random.uniform(0.02, 0.075), random))
    for x, y, seed in plants_of(panel, random):
        source = vtkSeaweedSource()
        source.SetPreset(getattr(source, panel["kind"]))
        source.SetSeed(seed)
        source.Update()
        if panel["rocks"]:
            renderer.AddActor(rock(panel, (x, y), 0.06 * seen, random))
        for part, picture in (("Skin", None), ("Leaves", source.GetOutputDataObject(2))):
            actor = plant_actor(block(source.GetOutput(), "High", part), picture, tinted=True)
            actor.GetProperty().SetAmbient(0.55)
            actor.GetProperty().SetSpecular(0.08)
            actor.GetProperty().SetSpecularPower(8.0)
            actor.SetPosition(x, y, 0.025 * seen if panel["rocks"] else 0.0)
            actor.RotateZ(67.0 * seed)
            renderer.AddActor(under_water(actor, panel))
    title = label(panel["title"], (0.5, 0.985), 20 * OVERSAMPLING, (1.0, 1.0, 1.0))
    title.GetTextProperty().ShadowOn()
    renderer.AddActor(title)
    camera = renderer.GetActiveCamera()
    middle = 0.44 * seen
    camera.SetPosition(0.0, -DISTANCE * seen, middle + panel["tilt"] * DISTANCE * seen)
    camera.SetFocalPoint(0.0, 0.0, middle)
    camera.SetViewUp(0.0, 0.0, 1.0)
    camera.SetViewAngle(2.0 * np.degrees(np.arctan(0.5 / DISTANCE)))
    renderer.ResetCameraClippingRange()
    return renderer


def main(folder):
    """Draw it into a folder."""
    window = vtkRenderWindow()
    paper = vtkRenderer()
    paper.SetBackground(1.0, 1.0, 1.0)
    window.AddRenderer(paper)
    for index, panel in enumerate(PANELS):
        window.AddRenderer(draw(panel, index))
    write_jpg(window, os.path.join(folder, "seaweeds.jpg"), SIZE, 86, OVERSAMPLING)


main(sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__)))
