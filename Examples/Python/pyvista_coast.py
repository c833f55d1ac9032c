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
    vtkParticleOrbitFilter, vtkPlantScatterFilter, vtkQuadratPointSource, vtkReevesTreeSource, vtkSeaStateSource,
    vtkTurningBandsTerrainSource)
from littoral.elevation import array_from_image, image_from_array
from littoral.plants import add_daylight
from littoral.pyvista import add_plants
from littoral.gallery.heights import blur, normals, openness, sunlight
from littoral.glb import direction

EYE, FOCUS, VIEW_ANGLE = np.array((-8.0, -98.0, 3.0)), np.array((0.0, 0.0, 10.4)), 32.0
HORIZON = 0.37  # height in the image, as a fraction
SUN = (245.0, 32.0)  # azimuth and elevation [degrees]
SIZE = 220.0  # side of the square with the island [m]
SKY_LOW, SKY_HIGH = np.array((0.74, 0.83, 0.89)), np.array((0.34, 0.54, 0.78))
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


def ground_colors(image):
    """Sand, grass and rock in the light of sun and sky, as bytes."""
    z, spacing = array_from_image(image).astype(float), image.GetSpacing()
    slope = np.degrees(np.arccos(normals(z, spacing)[..., 2]))
    patches = blur(np.random.default_rng(1).standard_normal(z.shape), 6) * 12.0
    grain = np.random.default_rng(2).standard_normal(z.shape)
    sand, wet, grass, dry, rock = (np.array(c) for c in (
        (0.80, 0.73, 0.57), (0.50, 0.44, 0.33), (0.33, 0.42, 0.17), (0.52, 0.52, 0.26), (0.45, 0.42, 0.39)))

    def mix(one, other, value, low, high):
        return one + (other - one) * np.clip((value - low) / (high - low), 0.0, 1.0)[..., None]

    color = mix(wet, sand, z, 0.2, 0.7)
    color = mix(color, mix(grass, dry, patches, -0.6, 1.4), z + 0.3 * patches, 1.1, 1.9)
    color = mix(color, rock, slope + 5.0 * patches, 32.0, 44.0) * (1.0 + 0.05 * grain)[..., None]
    light = np.maximum(normals(z, spacing) @ direction(*SUN), 0.0) * sunlight(z, spacing, *SUN)
    light = 1.15 * light[..., None] * (1.0, 0.94, 0.82) + 0.5 * openness(z, spacing)[..., None] * (0.75, 0.86, 1.0)
    return np.clip(255.0 * color * light, 0.0, 255.0)


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


def shade_ground(colors, island, forest):
    """Darken the ground in the shadows of trees."""
    z, (step, _, _), origin = array_from_image(island), island.GetSpacing(), island.GetOrigin()
    y, x = (origin[k] + step * np.arange(z.shape[1 - k]) for k in (1, 0))
    away = -direction(SUN[0], 0.0) / np.tan(np.radians(SUN[1]))
    fields = pv.wrap(forest).field_data
    for foot, scale in zip(np.asarray(fields["Position"]).reshape(-1, 3), fields["Scale"]):
        center, radius = foot[:2] + away[:2] * 4.5 * scale, 3.4 * scale
        share = np.exp(-((x - center[0]) ** 2 + (y[:, None] - center[1]) ** 2) / radius ** 2)
        colors *= (1.0 - 0.5 * share)[..., None]


def make_sea(time=4.0):
    """The water in front of the camera, finer where it is near."""
    radius, angle = np.geomspace(3.0, 4000.0, 1100)[:, None], np.linspace(-0.6, 0.6, 900)
    plane = pv.StructuredGrid(
        (EYE[0] + radius * np.sin(angle))[..., None], (EYE[1] + radius * np.cos(angle))[..., None],
        np.zeros((1100, 900, 1)))
    distance = np.linalg.norm(plane.points - EYE, axis=1)
    plane["TrainCount"] = np.clip(9000.0 / distance, 12, 150).astype(np.int32)  # short waves are invisible far away
    sea = vtkSeaStateSource(wind_speed=7.5, mean_direction=20.0, number_of_trains=150, frequency_range=(0.6, 7.0))
    orbits = vtkParticleOrbitFilter(choppiness=1.0)
    orbits.SetInputDataObject(0, plane)
    orbits.SetSeaStateConnection(sea.GetOutputPort())
    orbits.UpdateTimeStep(time)
    return pv.wrap(orbits.GetOutput())


def water_colors(water):
    """Color of the water: reflected sky, refracted bed, sun glitter, and foam."""
    up = water["Normals"] / np.linalg.norm(water["Normals"], axis=1)[:, None]
    way = EYE - water.points
    distance = np.linalg.norm(way, axis=1)
    way /= distance[:, None]
    cosine = np.clip((up * way).sum(axis=1), 0.03, 1.0)
    mirrored = 2.0 * cosine[:, None] * up - way
    share = (0.02 + 0.98 * (1.0 - cosine) ** 5)[:, None]
    height = np.clip(mirrored[:, 2:], 0.0, 1.0) ** 0.6
    sky = SKY_LOW + (SKY_HIGH - SKY_LOW) * height
    below = np.array((0.015, 0.16, 0.19)) + np.clip(0.05 * (1.0 + water.points[:, 2:]), 0.0, 0.1) * (0.5, 1.0, 0.9)
    glitter = np.clip(mirrored @ direction(*SUN), 0.0, 1.0)[:, None] ** 400 * (1.0, 0.95, 0.8)
    color = below + (0.85 * sky - below) * share + glitter
    foam = np.clip((0.45 - water["Jacobian"]) / 0.35, 0.0, 1.0)[:, None]
    color += (0.93 - color) * 0.8 * foam
    haze = (1.0 - np.exp(-distance / 1800.0))[:, None]
    return np.clip(255.0 * (color + (SKY_LOW - color) * haze), 0.0, 255.0)


def main(folder):
    """Render the island."""
    island = make_island()
    forest = make_forest(island)
    colors = ground_colors(island)
    shade_ground(colors, island, forest)
    ground = pv.wrap(island).warp_by_scalar("Elevation")
    ground["Light"] = colors.reshape(-1, 3).astype(np.uint8)
    water = make_sea()
    water["Light"] = water_colors(water).astype(np.uint8)
    print(f"{len(pv.wrap(forest).field_data['Scale'])} trees, land up to {ground.bounds[5]:.0f} m, "
          f"waves from {water.bounds[4]:.2f} to {water.bounds[5]:.2f} m")

    plotter = pv.Plotter(off_screen=True, window_size=(1280, 640), lighting="none")
    plotter.set_background(SKY_LOW + (SKY_LOW - SKY_HIGH) * HORIZON / (1.0 - HORIZON), top=SKY_HIGH)
    plotter.enable_anti_aliasing("ssaa")
    add_daylight(plotter.renderer, SUN)
    for surface in (ground, water):
        plotter.add_mesh(surface, scalars="Light", rgb=True, lighting=False)
    add_plants(plotter, forest, levels=("High", "Medium", "Low"))
    plotter.camera_position = [EYE, FOCUS, (0.0, 0.0, 1.0)]
    plotter.camera.view_angle = VIEW_ANGLE
    os.makedirs(folder, exist_ok=True)
    plotter.screenshot(os.path.join(folder, "pyvista_coast.png"))
    plotter.close()


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else tempfile.mkdtemp(prefix="littoral-"))
