# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Kelp in a bay, the surface from below, shafts of light and caustics, for Blender's path tracer.

    ./littoral render Examples/Blender/underwater.py [FOLDER]   the picture
    python3 underwater.py FILE.glb [FRAME]                      the scene alone

Sea, bed, kelp and currents are those of Examples/ParaView/underwater.py.
"""

import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkRectilinearGrid
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkFiltersGeometry import vtkRectilinearGridGeometryFilter

from littoral import (
    vtkFlowPrimitiveSource, vtkParticleOrbitFilter, vtkPlantScatterFilter, vtkSeaStateSource,
    vtkSeaweedDeformationFilter, vtkSeaweedSource)
from littoral.gallery import bay
from littoral.gallery.heights import sampled
from littoral.gallery.meshes import vertices
from littoral.glb import write_glb
from littoral.properties import set_properties

DEPTH = 9.5  # water depth [m]
EYE, FOCUS, VIEW_ANGLE = (0.0, 0.0, -7.4), (0.0, 10.0, -4.9), 64.0
SUN = (8.0, 50.0)  # azimuth and elevation [degrees]
#: Giant kelp that rises beyond the upper edge of the picture: middle of a group [m] and plants in it.
TALL = ((-4.4, 6.6, 3), (-6.3, 8.4, 3), (4.6, 6.9, 3), (6.9, 8.8, 3), (-2.9, 11.5, 2), (3.4, 13.0, 3), (-9.0, 13.0, 4),
        (10.5, 13.5, 4), (-1.0, 19.0, 3), (6.0, 20.0, 4), (-7.0, 22.0, 4))
#: Giant kelp, to be scaled by some 0.6 to this shallow water, with blades enlarged to keep their natural size.
GIANT_KELP = dict(
    NumberOfFronds=4, HoldfastRadius=0.35, StipeLength=14.0, StipeRadius=0.012, BladeLength=2.0, BladeWidth=0.30,
    BladeThickness=0.0014, BladeSpacing=0.40, FloatRadius=0.03, Ruffle=0.22, SpreadAngle=45.0, SegmentsPerBranch=12,
    StipeModulus=1.5e7, BladeModulus=5e6, StipeDensity=1040.0, BladeDensity=1026.0, FloatDensity=300.0, Variation=0.2)
TIME, FRAMES_A_SECOND = 7.3, 12
CURRENT = 0.08  # [m/s]
LEAD = 20.0  # time of kelp motion before the first frame [s]
#: Spacing of the surface [m], up to which distance from the camera, and the distance where it ends [m].
SPACING, NEAR, FAR = 0.09, (24.0, 30.0), 170.0


def sea_state():
    sea = vtkSeaStateSource()
    sea.SetSeaBy(sea.HeightAndPeriod)
    sea.SetSignificantWaveHeight(0.6)
    sea.SetPeakPeriod(6.2)
    sea.SetWaterDepth(DEPTH)
    sea.SetMeanDirection(-70.0)
    sea.SetNumberOfTrains(60)
    return sea


def ripples(time, count=14, seed=3):
    """Short waves as rows of k_x, k_y [rad/m], amplitude [m] and phase [rad] at a time [s], longest first."""
    random = np.random.default_rng(seed)
    length = 4.6 * 0.82 ** np.arange(count)
    k = 2.0 * np.pi / length
    angle = random.normal(0.5, 0.95, count)
    phase = random.uniform(0.0, 2.0 * np.pi, count) - np.sqrt(9.80665 * k) * time  # deep water
    return np.column_stack((k * np.cos(angle), k * np.sin(angle), 0.0105 * length ** 1.1, phase))


def surface(sea, time):
    """The surface at a time: wave trains move it, and short ripples lie on it."""
    out = np.geomspace(0.15, FAR, 70)
    x = np.concatenate((-NEAR[0] - out[::-1], np.arange(-NEAR[0], NEAR[0], SPACING), NEAR[0] + out))
    y = np.concatenate((-10.0 - out[::-1], np.arange(-10.0, NEAR[1], SPACING), NEAR[1] + out))
    lattice, level = vtkRectilinearGrid(), vtkRectilinearGridGeometryFilter()
    lattice.SetDimensions(len(x), len(y), 1)
    lattice.SetXCoordinates(numpy_to_vtk(x, deep=True))
    lattice.SetYCoordinates(numpy_to_vtk(y, deep=True))
    level.SetInputData(lattice)
    orbits = vtkParticleOrbitFilter()
    orbits.SetInputConnection(0, level.GetOutputPort())
    orbits.SetSeaStateConnection(sea.GetOutputPort())
    orbits.UpdateTimeStep(time)
    moved = orbits.GetOutput()
    places = vtk_to_numpy(moved.GetPoints().GetData()).astype(float)
    beyond = np.maximum(np.abs(places[:, 0]) - NEAR[0], np.abs(places[:, 1] - 10.0) - 20.0)
    for k_x, k_y, amplitude, phase in ripples(time):
        amplitude = amplitude * np.clip(1.0 - beyond * np.hypot(k_x, k_y) / 30.0, 0.0, 1.0)  # cells grow
        places[:, 2] += amplitude * np.cos(k_x * places[:, 0] + k_y * places[:, 1] + phase)
    moved.GetPoints().SetData(numpy_to_vtk(places.astype(np.float32), deep=True))
    moved.GetPointData().Initialize()
    normals = vtkPolyDataNormals()
    normals.SetInputData(moved)
    normals.SplittingOff()
    normals.Update()
    return normals.GetOutput()


def seaweed(preset, settings):
    return set_properties(vtkSeaweedSource(), {"Preset": preset, **settings})


def kelp_sites(bed, seed=9):
    """Sites of sugar kelp on the bed, and of giant kelp up to the surface."""
    random = np.random.default_rng(seed)
    low = bay.kelp_sites(bed, count=240)
    species = vtk_to_numpy(low.GetPointData().GetArray("Species"))
    scale = vtk_to_numpy(low.GetPointData().GetArray("Scale"))[species == 0]
    places = vtk_to_numpy(low.GetPoints().GetData())[species == 0]
    tall = np.array([(x, y) + random.normal(0.0, 0.55, 2) for x, y, count in TALL for _ in range(count)])
    feet = sampled(bed, *tall.T)
    return vertices(
        np.concatenate((places, np.column_stack((tall, feet)))), Species=np.repeat(np.int32((0, 1)), (len(places), len(tall))),
        Scale=np.concatenate((scale, (-0.5 - feet) / 14.6 * random.uniform(0.85, 1.0, len(tall)))))


def kelp(sea, sites, time):
    """The kelp in waves and current at a time. It starts long before: blades leave their rest pose slowly."""
    current = vtkFlowPrimitiveSource()
    current.SetStrength(CURRENT)
    current.SetAxis(1.0, 0.25, 0.0)
    prototypes = [seaweed(vtkSeaweedSource.SugarKelp, {}),
                  seaweed(vtkSeaweedSource.Custom, dict(GIANT_KELP, Form=vtkSeaweedSource.Canopy))]
    plants = vtkPlantScatterFilter()
    plants.SetInputData(0, sites)
    for prototype in prototypes:
        plants.AddPrototypeConnection(prototype.GetOutputPort())
    plants.SetUseLevels(False)
    plants.SetUseCulling(False)
    bending = vtkSeaweedDeformationFilter()
    bending.SetInputConnection(0, plants.GetOutputPort())
    bending.SetSeaStateConnection(sea.GetOutputPort())
    bending.AddCurrentConnection(current.GetOutputPort())
    bending.GenerateMotionOn()
    bending.SetTimeStep(1.0 / 24.0)
    bending.SetStartTime(TIME - LEAD)
    bending.UpdateTimeStep(time)
    return bending.GetOutput()


def specks(sea, time, plants):
    """Particles near the camera, moved by the waves."""
    points = bay.particles((-9.0, 0.8, -DEPTH + 0.1, 9.0, 14.0, -0.3), 40000, 0.0016, (0.90, 0.95, 0.88),
                                  clumps=0.3, plants=plants)
    orbits = vtkParticleOrbitFilter()
    orbits.SetInputData(0, points)
    orbits.SetSeaStateConnection(sea.GetOutputPort())
    orbits.UpdateTimeStep(time)
    return orbits.GetOutput()


def write_scene(filename, frame=0):
    """Write the scene at a frame."""
    time, sea = TIME + frame / FRAMES_A_SECOND, sea_state()
    sand = bay.bed(DEPTH, EYE)
    plants = kelp_sites(sand)
    sources = {"Surface": surface(sea, time), "Bed": sand, "Kelp": kelp(sea, plants, time),
               "Particles": specks(sea, time, plants)}
    write_glb(
        filename, sources, camera=(EYE, FOCUS, (0.0, 0.0, 1.0), VIEW_ANGLE), sun=(*SUN, 100000.0),
        kinds={"Surface": "water", "Bed": "ground", "Particles": "particle"},
        extras={"water": {"level": 0.0, "color": [0.32, 0.74, 1.0]},
                "exposure": 1.0}, LevelForm=2)


if __name__ == "__main__":
    write_scene(sys.argv[1], *map(int, sys.argv[2:3]))
