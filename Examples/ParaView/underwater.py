# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvbatch together=ParaView args=. args=128 args=72 args=2 args=--quick
"""Under the waves: the surface from below, kelp on a sandy bed with stones, particles that fade into fog.

    ./littoral gui Examples/ParaView/underwater.py      opens it in ParaView
    pvbatch underwater.py FOLDER [WIDTH HEIGHT FRAMES] [--quick]
                                                        writes underwater.png and the OpenVDB volume
                                                        fog.vdb into FOLDER; with FRAMES, also
                                                        the frames and the film underwater.ogv

The same wave trains move the surface and the particles.
"""

import os
import sys

from paraview import simple

import littoral
from littoral.gallery import bay, views
from littoral.gallery.arguments import folder_size_frames

DEPTH = 9.5  # water depth [m]
EYE, FOCUS, VIEW_ANGLE = (0.0, 0.0, -6.3), (0.0, 10.0, -5.2), 66.0
#: Giant kelp, to be scaled by some 0.6 to this shallow water, with blades enlarged to keep their natural size.
GIANT_KELP = dict(
    Form="Canopy", NumberOfFronds=4, HoldfastRadius=0.35, StipeLength=14.0, StipeRadius=0.008, BladeLength=2.0,
    BladeWidth=0.28, BladeThickness=0.0014, BladeSpacing=0.45, FloatRadius=0.02, Ruffle=0.22, SpreadAngle=45.0,
    SegmentsPerBranch=12, StipeModulus=1.5e7, BladeModulus=5e6, StipeDensity=1040.0, BladeDensity=1026.0,
    FloatDensity=300.0, Variation=0.2)
TIME, FRAMES_A_SECOND = 7.3, 12
CURRENT = 0.08  # [m/s]
LEAD = 20.0  # time of kelp motion before the first frame [s]
#: The light: sun before the eye in clear water. Ripples that are shorter than the mesh gather it.
LIGHT = dict(SunElevation=56.0, SunAzimuth=10.0, CloudCover=0.1, ExposureCompensation=1.7, ShadowDistance=40.0,
             WaterAbsorption=[0.31, 0.068, 0.035], WaterScattering=[0.02, 0.027, 0.03], WaterSlopeVariance=0.014)
SEEN = ["/Root/Near", "/Root/MasterSlave"]  # levels of particles that are seen individually
STIR = 25.0  # strength of plant wakes [m2 s], above nature, to be visible


def drifting(name, particles, currents):
    """Particles in currents."""
    # With this time step the wake is requested only at frame times.
    return simple.CurrentDrift(registrationName=name, Input=particles, Currents=currents, WaterDepth=DEPTH,
                               StartTime=TIME - 1.0, TimeStep=2.0 / FRAMES_A_SECOND)


def levels(name, particles, sea, culling=1):
    """Levels of particles: those near enough to be seen individually, and the others for the fog."""
    return simple.ParticleLevelOfDetail(
        registrationName=name, Input=particles, SeaState=sea, VisibleDistance=30.0, UseCulling=culling)


def on_waves(name, particles, sea):
    """Particles of the levels that are seen individually, in waves, which do not move the others."""
    seen = simple.ExtractBlock(Input=particles, Selectors=SEEN)
    riding = simple.ParticleOrbits(registrationName=name, Input=seen, SeaState=sea)
    # Shown as this script says, and not as Littoral shows what is in waves.
    return simple.ExtractBlock(Input=riding, Selectors=SEEN)


def build(folder, view, quick=False):
    """Build the pipeline and show it in a view; quick: with few plants and particles, and little motion."""
    data = os.path.join(folder, "data")
    os.makedirs(data, exist_ok=True)
    sea = simple.SeaState(registrationName="Sea", SeaBy="Height And Period", SignificantWaveHeight=0.6,
                          PeakPeriod=6.2, WaterDepth=DEPTH, MeanDirection=-70.0, NumberOfTrains=60)
    surface = simple.SeaSurface(registrationName="Surface", Input=sea, Radius=150.0, Sectors=60 if quick else 300,
                                Spacing=0.5 if quick else 0.1, WaterColors=0)
    sand = bay.bed(DEPTH, EYE, samples=200 if quick else 900)
    floor = simple.TerrainLevelOfDetail(registrationName="Bed", Input=views.reader("Sand", sand, data))
    plants = bay.kelp_sites(sand, count=8 if quick else 130)
    sites = views.reader("KelpSites", plants, data)
    kelp = simple.PlantScatter(
        registrationName="Kelp", Sites=sites, FollowCamera=0, UseLevels=0, UseCulling=0, Prototypes=[
            simple.Seaweed(registrationName="SugarKelp"),
            simple.Seaweed(registrationName="GiantKelp", Preset="Custom", **GIANT_KELP)])
    # Motion starts long before the first frame: blades leave their rest pose slowly.
    current = simple.FlowPrimitive(registrationName="Current", Strength=CURRENT, Axis=[1.0, 0.25, 0.0])
    bending = simple.SeaweedDeformation(
        registrationName="Kelp in the swell", Input=kelp, SeaState=sea, Currents=[current], FollowCamera=0,
        GenerateMotion=1, TimeStep=1.0 / 24.0, StartTime=TIME - (0.5 if quick else LEAD))
    wake = simple.PlantWake(registrationName="Wake", Input=bending, Strength=STIR)
    # Only particles gathered around the kelp feel its wake; the others drift uniformly, without time steps.
    box, look = (-17.0, 1.2, -DEPTH + 0.1, 17.0, 29.0, -0.5), (0.0042, (0.84, 0.93, 0.84))
    about = bay.particles(box, 500 if quick else 24000, *look, plants=plants, share=1.0)
    beyond = bay.particles(box, 9500 if quick else 456000, *look, seed=2, clumps=0.9)
    stirred = levels("StirredLevels", drifting("Stirred", views.reader("ParticlesAboutKelp", about, data),
                                               [current, wake]), sea)
    # The current alone moves the others, all by the same step: their levels are chosen before, and again only when the
    # camera moves. In 6 s they drift by 0.5 m, the distance in which levels blend: paraview.TestDriftedLevels.
    carried = drifting("Drifting", levels("DriftingLevels", views.reader("OtherParticles", beyond, data), sea, culling=0),
                       [current])
    specks = [on_waves("StirredOnWaves", stirred, sea), on_waves("DriftingOnWaves", carried, sea)]
    fog = simple.ParticleFog(registrationName="Fog", Input=carried, GridBy="Spacing",
                             Spacing=0.5, UseBounds=1, Bounds=[-17.0, 17.0, -1.0, 29.0, -DEPTH, 0.0])

    views.light(view, Quality="Good" if quick else "Best", **LIGHT)
    views.look(view, EYE, FOCUS, VIEW_ANGLE)
    for animated in (surface, bending, *specks):
        simple.UpdatePipeline(TIME, animated)
    view.ViewTime = TIME
    # The color map editor of ParaView 5.11's window fails on the histogram of a fog that is still empty.
    simple.SetActiveSource(None)
    views.show_fog(fog, view)
    for near in specks:
        views.show_particles(near, view)
    for each in (floor, bending, surface):
        simple.Show(each, view).SetRepresentationType("Full Surface")


def film(view, folder, frames, told):
    """Write the frames and the film; `told` is called before each frame."""
    def turn_to(frame):
        view.ViewTime = TIME + frame / FRAMES_A_SECOND

    views.film_view(os.path.join(folder, "underwater.ogv"), view, frames, FRAMES_A_SECOND, turn_to, told)


def main(folder, size, frames=0, quick=False, told=lambda frame, frames: None):
    """Build the scene, write its image and fog and, with frames above 0, the film; quick: a coarse one, as a test."""
    simple._DisableFirstRenderCameraReset()
    os.makedirs(folder, exist_ok=True)
    view = simple.GetActiveViewOrCreate("RenderView")
    view.ViewSize = list(size)
    build(folder, view, quick)
    views.save_view(os.path.join(folder, "underwater.png"), view)
    if hasattr(littoral, "vtkVDBVolumeWriter"):
        views.save_volume(os.path.join(folder, "fog.vdb"), simple.FindSource("Fog"))
    if frames > 0:
        film(view, folder, frames, told)


if __name__ != "underwater":  # another script has run this one for its functions
    main(**folder_size_frames(sys.argv[1:]))
