# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws figure-sea-8.jpg of the user guide: a bed of sugar kelp in a current and a swell, with particles.

    ./littoral run pvbatch Documentation/pictures/make_figure_sea_8.py [FOLDER]
"""

import os
import sys
import tempfile

import numpy as np
from paraview import simple

from littoral.gallery import bay, views
from littoral.gallery.heights import sampled
from littoral.gallery.meshes import vertices
from littoral.gallery.views import reader

SIZE = (960, 540)
DEPTH = 6.5  # of the water [m]
EYE, FOCUS, VIEW_ANGLE = (0.0, 0.0, -4.9), (0.0, 10.0, -4.6), 62.0
TIME, LEAD = 6.0, 15.0  # the swell has bent the kelp for so long [s]
PLANTS = 150  # in an area of 40 m along the view and 20 m across


def sites(bed, seed=11):
    """Sites of sugar kelp: in patches, with a lane before the eye."""
    random = np.random.default_rng(seed)
    patches = np.column_stack((random.uniform(-10.0, 10.0, 16), random.uniform(5.0, 36.0, 16)))
    patches[:3] = ((2.6, 5.6), (-2.9, 6.6), (4.6, 8.0))
    places = []
    while len(places) < PLANTS:
        x, y = patches[len(places) % len(patches)] + random.normal(0.0, 0.9, 2)
        if y > 3.6 and abs(x) > 0.16 * y * (y < 14.0):
            places.append((x, y, float(sampled(bed, x, y))))
    return vertices(np.array(places), Species=random.integers(0, 3, PLANTS).astype(np.int32),
                    Scale=random.uniform(0.75, 1.25, PLANTS))


def build(folder, view):
    """Sea, bed, kelp and particles, shown in a view."""
    sea = simple.SeaState(SeaBy="Height And Period", SignificantWaveHeight=0.4, PeakPeriod=5.5, WaterDepth=DEPTH,
                          MeanDirection=-60.0, NumberOfTrains=60)
    current = simple.FlowPrimitive(Strength=0.05, Axis=[1.0, 0.25, 0.0])
    surface = simple.SeaSurface(Input=sea, Radius=150.0, Sectors=300, Spacing=0.1, WaterColors=0)
    sand = bay.bed(DEPTH, EYE)
    plants = sites(sand)
    kelp = simple.PlantScatter(Sites=reader("KelpSites", plants, folder), FollowCamera=0, UseLevels=0, UseCulling=0,
                               Prototypes=[simple.Seaweed(Seed=seed, SegmentsPerBranch=14) for seed in (1, 2, 3)])
    bending = simple.SeaweedDeformation(
        Input=kelp, SeaState=sea, Currents=[current], FollowCamera=0, GenerateMotion=1,
        TimeStep=1.0 / 24.0, StartTime=TIME - LEAD)
    specks = reader("Specks", bay.particles(
        (-12.0, 1.0, -DEPTH + 0.1, 12.0, 30.0, -0.4), 40000, 0.0055, (0.84, 0.93, 0.84), plants=plants, share=0.25),
        folder)
    drift = simple.CurrentDrift(Input=specks, Currents=[current, simple.PlantWake(Input=bending)], WaterDepth=DEPTH,
                                StartTime=TIME - 1.0)
    riding = simple.ParticleOrbits(Input=drift, SeaState=sea)
    for animated in (surface, bending, riding):
        simple.UpdatePipeline(TIME, animated)
    view.ViewTime = TIME
    views.show_particles(riding, view)
    for each in (bending, simple.TerrainLevelOfDetail(Input=reader("Bed", sand, folder)), surface):
        simple.Show(each, view).SetRepresentationType("Full Surface")


def main(folder):
    """Draw it into a folder."""
    simple._DisableFirstRenderCameraReset()
    view = simple.GetActiveViewOrCreate("RenderView")
    view.ViewSize = list(SIZE)
    views.light(view, SunElevation=60.0, SunAzimuth=330.0, CloudCover=0.1, ExposureCompensation=1.4, ShadowDistance=40.0,
                WaterAbsorption=[0.31, 0.068, 0.035], WaterScattering=[0.02, 0.027, 0.03], WaterSlopeVariance=0.014,
                Quality="Best")
    views.look(view, EYE, FOCUS, VIEW_ANGLE)
    with tempfile.TemporaryDirectory() as data:
        build(data, view)
        simple.SaveScreenshot(os.path.join(folder, "figure-sea-8.jpg"), view, Quality=82)


main(sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__)))
