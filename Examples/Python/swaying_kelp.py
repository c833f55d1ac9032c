# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: python3 args=. args=--quick
# run-with: python3 tier=all
"""Kelp that sways in a swell and a current, and particles that drift in the current, the swell and its wakes.

    python3 swaying_kelp.py [FOLDER] [FRAMES] [--quick]

writes swaying_kelp.0000.png ... into FOLDER, a frame each 1/12 s, and prints amplitude and phase lag of a frond, and
the displacement of particles by the wakes of the kelp. --quick, for a test, has fewer plants and particles, measures at
fewer times and draws small.
"""

import os
import sys
import tempfile

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, draws everything
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkTexture)

from littoral import (
    vtkCurrentDriftFilter, vtkFlowPrimitiveSource, vtkLandscapePass, vtkParticleOrbitFilter, vtkPlantScatterFilter,
    vtkPlantWakeFilter, vtkQuadratPointSource, vtkSeaStateSource, vtkSeaSurfaceFilter, vtkSeaweedDeformationFilter,
    vtkSeaweedSource, vtkSuspendedParticleSource, vtkTerrainLevelOfDetailFilter, vtkTurningBandsTerrainSource)
from littoral.picture import write_png
from littoral.plants import block
from littoral.properties import set_properties

DEPTH = 7.0  # of the water at the center of the bed [m]
START, TIME, FRAME = -12.0, 9.0, 1.0 / 12.0  # kelp at rest, first frame, frame interval [s]
SAMPLES = 24  # per period of the swell
EYE, FOCUS, VIEW_ANGLE = (0.0, -4.3, 1.0), (0.0, 0.0, 1.35), 42.0
#: Light in rather murky water.
LIGHT = dict(SunElevation=55.0, SunAzimuth=330.0, CloudCover=0.2, ExposureCompensation=1.1, ShadowDistance=30.0,
             WaterLevel=DEPTH, WaterAbsorption=(0.31, 0.07, 0.05), WaterScattering=(0.04, 0.05, 0.05),
             WaterSlopeVariance=0.012)


def make_bed():
    """Sand with low dunes, an image with the array Elevation."""
    sand = vtkTurningBandsTerrainSource()
    sand.SetWholeExtent(0, 200, 0, 160, 0, 0)
    sand.SetOrigin(-20.0, -6.0, 0.0)
    sand.SetSpacing(0.2, 0.2, 1.0)
    sand.SetRange(12.0)
    sand.SetMinimumWavelength(1.5)
    sand.SetMean(0.0)
    sand.SetStandardDeviation(0.12)
    return sand


def make_kelp(sand, quick):
    """Sugar kelp at random positions on the bed."""
    sites = vtkQuadratPointSource()
    sites.SetOrigin(-7.0, -1.5)
    sites.SetSize(14.0, 12.0)
    sites.SetQuadrats(*((3, 3) if quick else (7, 6)))
    sites.SetSeed(4)
    plant = vtkSeaweedSource()
    plant.SetPreset(vtkSeaweedSource.SugarKelp)
    kelp = vtkPlantScatterFilter()
    kelp.SetInputConnection(0, sites.GetOutputPort())
    kelp.AddPrototypeConnection(plant.GetOutputPort())
    kelp.SetTerrainConnection(sand.GetOutputPort())
    kelp.SetUseLevels(False)
    kelp.SetUseCulling(False)
    return kelp


def make_swell():
    """A regular swell towards the right."""
    sea = vtkSeaStateSource()
    sea.SetSpectrum(vtkSeaStateSource.Regular)
    sea.SetSeaBy(vtkSeaStateSource.HeightAndPeriod)
    sea.SetSignificantWaveHeight(0.5)  # trough to crest
    sea.SetPeakPeriod(4.5)
    sea.SetWaterDepth(DEPTH)
    sea.SetSeaLevel(DEPTH)
    return sea


def make_currents():
    """A slow flow to the right, and a vortex among the kelp."""
    along, around = vtkFlowPrimitiveSource(), vtkFlowPrimitiveSource()
    along.SetStrength(0.05)
    around.SetFlowType(vtkFlowPrimitiveSource.Vortex)
    around.SetStrength(0.5)
    around.SetCenter(1.5, 3.0, 1.0)
    around.SetAxis(0.0, 0.0, 1.0)
    around.SetInfluenceRadius(5.0)
    return [along, around]


class Scene:
    """The pipeline: kelp, its wakes, and particles with and without these wakes."""

    def __init__(self, quick):
        self.sand, self.sea, self.currents = make_bed(), make_swell(), make_currents()
        standing = make_kelp(self.sand, quick)
        self.kelp = vtkSeaweedDeformationFilter()
        self.kelp.SetInputConnection(0, standing.GetOutputPort())
        self.kelp.SetSeaStateConnection(self.sea.GetOutputPort())
        for current in self.currents:
            self.kelp.AddCurrentConnection(current.GetOutputPort())
        self.kelp.SetStartTime(START)
        self.kelp.GenerateMotionOn()
        self.wake = vtkPlantWakeFilter()
        self.wake.SetInputConnection(self.kelp.GetOutputPort())
        self.particles = vtkSuspendedParticleSource()
        self.particles.SetMode(vtkSuspendedParticleSource.Quads)
        self.particles.SetBounds(-8.0, 8.0, -4.5, 11.0, 0.0, 4.5)
        self.particles.SetDensity(2.0 if quick else 5.0)
        self.stirred = self.drift(self.currents + [self.wake])
        self.calm = self.drift(self.currents)
        self.riding = self.on_waves(self.stirred.GetOutputPort())

    def drift(self, currents):
        """The particles, advected by currents."""
        drift = vtkCurrentDriftFilter()
        drift.SetInputConnection(0, self.particles.GetOutputPort())
        for current in currents:
            drift.AddCurrentConnection(current.GetOutputPort())
        drift.SetSeaLevel(DEPTH)
        drift.SetTimeStep(0.25)
        return drift

    def on_waves(self, port):
        """Points on their orbits in the swell."""
        orbits = vtkParticleOrbitFilter()
        orbits.SetInputConnection(0, port)
        orbits.SetSeaStateConnection(self.sea.GetOutputPort())
        return orbits


def places(data):
    """Points of a data set, a copy."""
    return vtk_to_numpy(data.GetPoints().GetData()).astype(float)


def cloud(points):
    """Points as polydata."""
    data, array = vtkPolyData(), vtkPoints()
    array.SetData(numpy_to_vtk(points, deep=True))
    data.SetPoints(array)
    return data


def measure_frond(scene, samples):
    """Motion of the tallest frond along the swell, at each node, and of the water at the mean position of the node.

    Heights over the foot [m], amplitudes of frond and water [m], phase lag of the frond [degrees; negative: lead].
    """
    scene.sea.Update()
    swell = scene.sea.GetOutput().GetColumnByName("AngularFrequency").GetValue(0)
    times = TIME + np.arange(samples) * 2.0 * np.pi / swell / samples
    moving = []
    for time in times:
        scene.kelp.UpdateTimeStep(time)
        bones = block(scene.kelp.GetOutput(), "High", "Skeleton")
        moving.append(places(bones))
    lines = bones.GetLines()
    nodes, offsets = (vtk_to_numpy(a) for a in (lines.GetConnectivityArray(), lines.GetOffsetsArray()))
    chains = [nodes[a:b] for a, b in zip(offsets[:-1], offsets[1:])]
    frond = max(chains, key=lambda chain: moving[0][chain[-1], 2] - moving[0][chain[0], 2])
    plant = np.array(moving)[:, frond]
    still, orbits = cloud(plant.mean(axis=0)), vtkParticleOrbitFilter()
    orbits.SetInputData(0, still)
    orbits.SetSeaStateConnection(scene.sea.GetOutputPort())
    water = []
    for time in times:
        orbits.UpdateTimeStep(time)
        water.append(places(orbits.GetOutput()))
    turn = np.exp(1j * swell * times) * 2.0 / samples
    of_plant, of_water = (np.tensordot(turn, way[..., 0], 1) for way in (plant, np.array(water)))
    behind = np.degrees(np.angle(of_plant[1:] / of_water[1:]))
    return plant.mean(axis=0)[1:, 2] - plant[0, 0, 2], np.abs(of_plant[1:]), np.abs(of_water[1:]), behind


def measure_wakes(scene, time):
    """Displacement of particles by wakes [m], and whether they started within the box of a plant."""
    ways = []
    for drift in (scene.stirred, scene.calm):
        drift.UpdateTimeStep(time)
        ways.append(places(drift.GetOutput())[::5])  # a square is the particle and four corners
    starts = places(scene.particles.GetOutput())[::5]
    scene.wake.UpdateTimeStep(0.0)
    arrays = scene.wake.GetOutput().GetPointData()
    boxes = vtk_to_numpy(arrays.GetArray("InfluenceBox")).reshape(-1, 3, 2)
    near = np.zeros(len(starts), dtype=bool)
    for box in boxes:
        near |= ((starts > box[:, 0]) & (starts < box[:, 1])).all(axis=1)
    return np.linalg.norm(ways[0] - ways[1], axis=1), near


def actor_of(data, color=None):
    """An actor of a surface in a color, or in its own ones."""
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputData(data)
    mapper.SetScalarVisibility(color is None)
    actor.SetMapper(mapper)
    if color:
        actor.GetProperty().SetColor(*color)
    return actor


def bed_actor(sand):
    """The bed as a surface."""
    land = vtkTerrainLevelOfDetailFilter()
    land.SetInputConnection(sand.GetOutputPort())
    land.SetNumberOfLevels(1)
    land.UseCullingOff()
    land.Update()
    return actor_of(land.GetOutput().GetBlock(0), (0.68, 0.62, 0.47))


def water_actor(sea, time):
    """The surface at a time [s], from below."""
    surface = vtkSeaSurfaceFilter()
    surface.SetInputConnection(sea.GetOutputPort())
    surface.SetCenter(*EYE[:2])
    surface.SetRadius(100.0)
    surface.SetSpacing(0.1)
    surface.SetSectors(240)
    surface.UpdateTimeStep(time)
    actor = actor_of(surface.GetOutput(), (1.0, 1.0, 1.0))
    vtkLandscapePass.SetMaterial(actor, vtkLandscapePass.Water)
    return actor


def kelp_actors(kelp):
    """Stipes and blades, which let light through."""
    for name in ("Skin", "Leaves"):
        actor = actor_of(block(kelp.GetOutput(), "High", name))
        vtkLandscapePass.SetTransmittance(actor, 0.4 if name == "Leaves" else 0.0)
        yield actor


def particle_actor(scene):
    """Squares with the textures of their kinds."""
    actor, texture = actor_of(scene.riding.GetOutput()), vtkTexture()
    texture.SetInputConnection(scene.particles.GetOutputPort(1))
    texture.InterpolateOn()
    texture.MipmapOn()
    actor.SetTexture(texture)
    actor.ForceTranslucentOn()
    return actor


def draw(scene, folder, frames, size):
    """Write the frames."""
    renderer, window = vtkRenderer(), vtkRenderWindow()
    light = set_properties(vtkLandscapePass(), LIGHT)
    renderer.SetPass(light)
    window.SetAlphaBitPlanes(1)
    window.AddRenderer(renderer)
    renderer.AddActor(bed_actor(scene.sand))
    camera = renderer.GetActiveCamera()
    camera.SetPosition(*EYE)
    camera.SetFocalPoint(*FOCUS)
    camera.SetViewUp(0.0, 0.0, 1.0)
    camera.SetViewAngle(VIEW_ANGLE)
    for frame in range(frames):
        time = TIME + frame * FRAME
        scene.riding.UpdateTimeStep(time)
        scene.kelp.UpdateTimeStep(time)
        light.SetWaterTime(time)
        actors = [*kelp_actors(scene.kelp), particle_actor(scene), water_actor(scene.sea, time)]
        for actor in actors:
            renderer.AddActor(actor)
        camera.SetClippingRange(0.2, 300.0)
        write_png(window, os.path.join(folder, f"swaying_kelp.{frame:04d}.png"), size)
        for actor in actors:
            renderer.RemoveActor(actor)


def main(folder, frames=1, quick=False):
    """Measure and draw."""
    scene = Scene(quick)
    heights, ways, of_water, behind = measure_frond(scene, SAMPLES // 3 if quick else SAMPLES)
    print("height over the foot [m], amplitudes of frond and water [m], phase lag of the frond [degrees]:")
    for row in list(zip(heights, ways, of_water, behind))[::2]:
        print("  {:5.2f}  {:6.3f}  {:6.3f}  {:6.1f}".format(*row))
    assert 0.05 < ways[-1] < 2.0 and ways[-1] > ways[0], "the frond does not sway as it should"
    moved, near = measure_wakes(scene, TIME)
    print(f"{len(moved)} particles, {near.sum()} of them among the kelp; its wakes moved those by "
          f"{1e3 * moved[near].mean():.1f} mm on average, {1e3 * moved.max():.0f} mm at most, "
          f"and {(moved == 0.0).sum()} not at all")
    assert moved[near].mean() > 10.0 * moved[~near].mean() > 0.0, "particles do not feel the kelp"
    os.makedirs(folder, exist_ok=True)
    draw(scene, folder, frames, (160, 90) if quick else (640, 360))


if __name__ == "__main__":
    words = [word for word in sys.argv[1:] if word != "--quick"]
    main(words[0] if words else tempfile.mkdtemp(prefix="littoral-"), *map(int, words[1:2]), quick="--quick" in sys.argv)
