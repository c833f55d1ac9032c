# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=waters
"""The ripples of littoral.gallery.water move without a new shader, as the waves that its ripples() lists, and states
keep their time; a turn of the camera runs no filter.

Mesa writes each program that it links into a folder, so their number is known. In the reference the phases of the time
are constants of the shaders.
"""

import os
import re
import tempfile

CAPTURED = tempfile.mkdtemp()
os.environ["MESA_SHADER_CAPTURE_PATH"] = CAPTURED  # before the first window

import numpy as np
import quick
from paraview import simple
from window import colors

from littoral.gallery import bay, underwater, views, water

SIZE, DEPTH, EYE, TIME = 160, 6.0, (0.0, 0.0, -3.0), 7.3


def compiled():
    """Number of programs linked since the start."""
    return len(os.listdir(CAPTURED))


def scene(view, folder):
    """A surface, a bed, a kelp and the water behind; returns their representations."""
    sea = simple.SeaState(SeaBy="Height And Period", WaterDepth=DEPTH, NumberOfTrains=4)
    level = views.reader("level", bay.mesh(bay.fan(rings=30, spokes=40)), folder)
    surface = simple.ParticleOrbits(Input=level, SeaState=sea)
    ground, height = bay.bed(DEPTH, EYE, samples=60)
    kelp = simple.PlantScatter(
        Sites=views.reader("sites", bay.kelp_sites(height, count=0), folder), FollowCamera=0, UseLevels=0, UseCulling=0,
        Prototypes=[simple.Seaweed(), simple.Seaweed()])
    underwater.prepare_view(view)
    view.CameraPosition, view.CameraFocalPoint = list(EYE), [0.0, 10.0, -2.4]
    view.CameraViewUp, view.CameraViewAngle = [0.0, 0.0, 1.0], 66.0
    shown = [underwater.show_seaweeds(kelp, view, TIME), underwater.show_bed(views.reader("bed", ground, folder), view, TIME),
             underwater.show_surface(surface, view, TIME), underwater.show_beyond(view, TIME, EYE)]
    return shown


def picture(view):
    simple.Render(view)
    return colors(view).reshape(SIZE, SIZE, -1)[:, :, :3].astype(float)


def at(view, shown, time):
    for each in shown:
        underwater.set_time(each, time)
    return picture(view)


def with_constant_phases(view, shown, time):
    """The picture with the ripples of a time written into the shaders."""
    waves = ", ".join("vec4({:.6f}, {:.6f}, {:.6f}, {:.6f})".format(*wave) for wave in water.ripples(time))
    for each in shown:
        text, count = re.subn(r"(vec4 ripples\[\d+\] = vec4\[\d+\])\([^;]*\);", lambda found: f"{found[1]}({waves});",
                              each.ShaderReplacements)
        assert count == (2 if "shaftsMC" in text else 1)  # where the vertices have them too
        each.ShaderReplacements = text
        underwater.set_time(each, 0.0)
    return picture(view)


def check_ripples():
    """The shader's phases are those of the waves: rates and phases in its text against ripples()."""
    text = water.water_shader()
    waves = np.array([[float(number) for number in row.split(",")] for row in
                      re.findall(r"vec4\(([-0-9., ]+)\)", text)])
    rates = np.array([float(number) for number in re.search(r"float\[\d+\]\(([^)]*)\)", text)[1].split(",")])
    for time in (0.0, TIME, 100.0):
        wanted = water.ripples(time)
        assert np.abs(waves[:, :3] - wanted[:, :3]).max() < 1e-6
        assert np.abs(waves[:, 3] - rates * time - wanted[:, 3]).max() < 1e-6 * (1.0 + time), f"phases at {time} s"


def main():
    check_ripples()
    view = simple.CreateView("RenderView")
    view.ViewSize = [SIZE, SIZE]
    simple._DisableFirstRenderCameraReset()
    view.ViewTime = TIME
    with tempfile.TemporaryDirectory() as folder:
        shown = scene(view, folder)
        pictures = [picture(view)]
        first = compiled()
        for frame in (1, 2, 3):
            view.ViewTime = TIME + frame / 12.0
            pictures.append(at(view, shown, view.ViewTime))
        new = compiled() - first
        if first == 0:
            print("TestUnderwater: this OpenGL does not tell how many programs it links")
        assert new == 0, f"{new} programs compiled after the first frame, which needed {first}"
        for former, later in zip(pictures, pictures[1:]):
            assert np.abs(former - later).mean() > 0.5, "nothing moves"

        # A turn of the camera: all that is shown is up to date.
        runs = []
        made = [source.SMProxy.GetClientSideObject() for source in simple.GetSources().values()]
        for algorithm in made:
            algorithm.AddObserver("StartEvent", lambda caller, _: runs.append(caller.GetClassName()))
        view.GetActiveCamera().Azimuth(1.0)
        turned = picture(view)
        assert not runs, f"a turn of the camera runs {runs}"
        assert np.abs(turned - pictures[-1]).mean() > 0.5, "no turn"
        view.GetActiveCamera().Azimuth(-1.0)
        view.ViewTime = TIME
        at(view, shown, TIME)
        assert runs, "the clock does not run the filters"

        state = os.path.join(folder, "scene.pvsm")
        simple.SaveState(state)
        with open(state) as stream:
            kept = re.findall(r'name="SpecularColor"[^>]*>\s*<Element index="0" value="([^"]*)"', stream.read())
        assert [float(value) for value in kept].count(TIME) == len(shown), f"the state keeps the times {kept}"

        moved = at(view, shown, TIME)
        assert np.abs(moved - pictures[0]).max() <= 1.0, "another picture at the same time"
        constant = with_constant_phases(view, shown, TIME)
        assert np.abs(moved - constant).mean() < 0.05, f"{np.abs(moved - constant).mean()} from constant phases"
        if first > 0:
            assert compiled() - first >= 4, "programs are not counted"


main()
