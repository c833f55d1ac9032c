# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: none
"""A wooded island in a fresh wind, in PyVista: terrain, forest and sea.

    python3 pyvista_coast.py [FOLDER]     writes pyvista_coast.png into FOLDER

Needs PyVista and VTK 9.4 or later, for keyword arguments of constructors and callable pipelines.
"""

import os
import sys
import tempfile

import numpy as np
import pyvista as pv

from littoral import (
    vtkLandscapePass, vtkPlantScatterFilter, vtkQuadratPointSource, vtkReevesTreeSource, vtkSeaStateSource,
    vtkSeaSurfaceFilter, vtkTerrainLevelOfDetailFilter, vtkTurningBandsTerrainSource)
from littoral.elevation import array_from_image, image_from_array
from littoral.pyvista import add_plants

EYE, FOCUS, VIEW_ANGLE = np.array((-8.0, -98.0, 3.0)), np.array((0.0, 0.0, 10.4)), 32.0
SIZE = 220.0  # side of the square with the island [m]
SAND = np.array((214.0, 196.0, 152.0))
SPECIES = (("Pine", 3), ("Oak", 5), ("Birch", 2), ("Pine", 8))  # presets and seeds


def make_island(cells=480):
    """Random relief on a hill that descends to the sea bed: an image with the array Elevation."""
    step = SIZE / cells
    relief = vtkTurningBandsTerrainSource(
        whole_extent=(0, cells, 0, cells, 0, 0), spacing=(step, step, 1.0), range=80.0, minimum_wavelength=3.0,
        mean=0.0, standard_deviation=1.5, seed=11)()
    z = array_from_image(relief).astype(float)
    y, x = np.mgrid[-0.5:0.5:z.shape[0] * 1j, -0.5:0.5:z.shape[1] * 1j]
    z += 15.0 * np.exp(-(x / 0.26) ** 2 - (y / 0.17) ** 2) - 4.9
    z = np.where(z < 1.0, 1.0 + 0.35 * (z - 1.0), z)  # a beach
    return image_from_array(z.astype(np.float32), (step, step, 1.0), (-0.5 * SIZE, -0.5 * SIZE))


def make_ground(island):
    """The surface of the island, sand on its beach."""
    levels = vtkTerrainLevelOfDetailFilter(number_of_levels=1, use_culling=False)(island)
    ground = pv.wrap(levels.GetBlock(0))
    land = np.clip((ground["Elevation"] - 1.2) / 0.6, 0.0, 1.0)[:, None]
    ground["RGB"] = (SAND + (ground["RGB"] - SAND) * land).astype(np.uint8)
    return ground


def make_forest(island):
    """Trees above the beach and on moderate slopes, in levels of detail."""
    sites = vtkQuadratPointSource(
        origin=(-0.5 * SIZE, -0.5 * SIZE), size=(SIZE, SIZE), quadrats=(50, 50), mean_per_quadrat=0.8, seed=3)
    forest = vtkPlantScatterFilter(
        view_point=EYE, view_direction=FOCUS - EYE, view_angle=VIEW_ANGLE, near_distance=125.0, far_distance=250.0,
        height_range=(2.2, 60.0), slope_limit=36.0, scale_variation=0.25)
    forest.SetInputConnection(0, sites.GetOutputPort())
    for name, seed in SPECIES:
        tree = vtkReevesTreeSource(preset=getattr(vtkReevesTreeSource, name), seed=seed)
        forest.AddPrototypeConnection(tree.GetOutputPort())
    forest.SetInputDataObject(2, island)
    forest.Update()
    return forest.GetOutputDataObject(0)


def make_sea(time=4.0):
    """The water around the camera."""
    sea = vtkSeaStateSource(wind_speed=7.5, mean_direction=20.0, number_of_trains=150, frequency_range=(0.6, 4.5))
    surface = vtkSeaSurfaceFilter(center=EYE[:2], spacing=0.1, sectors=900, water_colors=False)
    surface.SetInputConnection(sea.GetOutputPort())
    surface.UpdateTimeStep(time)
    return pv.wrap(surface.GetOutput())


def main(folder):
    """Render the island."""
    island = make_island()
    forest = make_forest(island)
    ground, water = make_ground(island), make_sea()
    print(f"{len(pv.wrap(forest).field_data['Scale'])} trees, land up to {ground.bounds[5]:.0f} m, "
          f"waves from {water.bounds[4]:.2f} to {water.bounds[5]:.2f} m")

    # With PyVista's lamps: without one VTK's shaders have no normals.
    plotter = pv.Plotter(off_screen=True, window_size=(1280, 640))
    vtkLandscapePass.SetMaterial(plotter.add_mesh(ground, scalars="RGB", rgb=True), vtkLandscapePass.Ground)
    vtkLandscapePass.SetMaterial(plotter.add_mesh(water), vtkLandscapePass.Water)
    for leaves in add_plants(plotter, forest, levels=("High", "Medium", "Low")):
        vtkLandscapePass.SetTransmittance(leaves, 0.3)
    plotter.renderer.SetPass(vtkLandscapePass(
        sun_azimuth=245.0, sun_elevation=32.0, quality=vtkLandscapePass.Best, shadow_distance=250.0, cover_height=0.0,
        exposure_compensation=0.7, water_slope_variance=0.01))
    plotter.camera_position = [EYE, FOCUS, (0.0, 0.0, 1.0)]
    plotter.camera.view_angle = VIEW_ANGLE
    os.makedirs(folder, exist_ok=True)
    plotter.screenshot(os.path.join(folder, "pyvista_coast.png"))
    plotter.close()


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else tempfile.mkdtemp(prefix="littoral-"))
