# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes a scene of Blender from a scene file and renders it: blender -b -P render.py -- JOB.json

The job has: scene, the .glb file; and optionally picture, a PNG to write; blend, a .blend file to write; size; samples;
noise, at which a pixel is done; engine; frame, of the point caches, from 0 on; rate, frames a second; blur, the share
of a frame that the shutter is open; report, a JSON file to write with what the scene holds; litter, temporary folders,
with Blender's own: then standard input is a pipe that ends with the process that has started this.
"""

import json
import os
import sys
import threading

import bpy
import numpy as np

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from in_blender import gltf, light, versions, volumes  # noqa: E402
from in_blender.materials import Materials  # noqa: E402
from in_blender.objects import Builder  # noqa: E402
from in_blender.water import Water  # noqa: E402

#: A pixel is done when its noise is below this share (Cycles' noise threshold).
NOISE = 0.05


def build(path):
    """Make the scene of a file; returns the file and its parts that the light needs."""
    file = gltf.File(path)
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    extras = file.extras
    towards, lux, color = file.sun() or (np.array((0.3, -0.5, 0.8)) / np.linalg.norm((0.3, -0.5, 0.8)), 1e5, (1, 1, 1))
    fog, sky = extras.get("fog", {}), extras.get("sky", {})
    water = Water(extras["water"], towards, lux) if "water" in extras else None
    is_below = water is not None and eye(file)[2] < water.level
    air = light.Air(towards, None if is_below else fog.get("sight"), fog.get("height", 260.0), sky.get("dust", 1.0),
                    clouds=sky.get("clouds", 0.0))
    air.light_world()
    light.add_sun(water.towards if is_below else towards, lux, color, 0.3 if is_below else 1.0)
    if is_below:
        surfaces, low, high = water_box(file)
        water.focus(surfaces, eye(file), low[2])
        water.enclose(low, high)
    folder = os.path.dirname(os.path.abspath(path))
    for volume in extras.get("volumes", []):
        volumes.add(volume, folder)
    caches = {name: os.path.join(folder, cache) for name, cache in extras.get("caches", {}).items()}
    Builder(file, Materials(file, None if is_below else air, water if is_below else None), caches).build()
    return file, extras


def eye(file):
    """The place of the camera; far up if there is none."""
    return next((matrix[:3, 3] for node, matrix in file.nodes() if "camera" in node), np.array((0.0, 0.0, np.inf)))


def water_box(file):
    """The meshes of water, and the box of what is below it, without particles."""
    surfaces, low, high = [], np.full(3, np.inf), np.full(3, -np.inf)
    for node, matrix in file.nodes():
        for part in file.list("meshes")[node["mesh"]]["primitives"] if "mesh" in node else ():
            if part.get("mode", 4) != 4:
                continue
            points = file.array(part["attributes"]["POSITION"]) @ matrix[:3, :3].T + matrix[:3, 3]
            if file.kind(part.get("material")) == "water":
                normals = file.array(part["attributes"]["NORMAL"]) @ matrix[:3, :3].T
                normals *= np.where(normals[:, 2:] < 0.0, -1.0, 1.0)
                surfaces.append((points, normals, file.array(part["indices"]).reshape(-1, 3)))
            if not file.instances(node):
                low, high = np.minimum(low, points.min(axis=0)), np.maximum(high, points.max(axis=0))
    return surfaces, low, high


def set_quality(job, extras):
    """Size, samples and the lengths of light paths."""
    scene = bpy.context.scene
    scene.render.resolution_x, scene.render.resolution_y = job.get("size", (960, 540))
    scene.render.resolution_percentage = 100
    scene.render.image_settings.file_format = "PNG"
    scene.render.image_settings.color_mode = "RGB"
    scene.render.fps = job.get("rate", 12)
    scene.frame_set(1 + job.get("frame", 0))
    versions.set_shutter(scene, job.get("blur", 0.0))
    versions.set_film(scene, extras.get("exposure", 0.0))
    samples = job.get("samples", 48)
    if job.get("engine", "cycles") == "eevee":
        versions.use_eevee(scene)
        scene.eevee.taa_render_samples = samples
        return
    scene.render.engine = "CYCLES"
    cycles = scene.cycles
    cycles.samples, cycles.seed, noise = samples, job.get("seed", 0), job.get("noise", NOISE)
    cycles.use_adaptive_sampling, cycles.adaptive_threshold = noise > 0.0, max(noise, 1e-3)
    cycles.adaptive_min_samples = max(4, samples // 3)
    versions.denoise(scene)
    cycles.max_bounces, cycles.diffuse_bounces, cycles.glossy_bounces = 4, 2, 1
    cycles.transmission_bounces, cycles.volume_bounces, cycles.transparent_max_bounces = 4, 0, 24
    cycles.caustics_reflective = cycles.caustics_refractive = False
    cycles.sample_clamp_indirect, cycles.sample_clamp_direct = 2.0, 12.0
    cycles.blur_glossy = 1.0
    scene.render.use_persistent_data = False


def report():
    """Contents of the scene, by the names of meshes: counts, bounds and kinds, as Blender evaluates them."""
    found = {}
    for one in bpy.context.evaluated_depsgraph_get().object_instances:
        thing = one.object
        if thing.type == "MESH" and len(thing.data.polygons):
            found.setdefault(thing.data.name, (thing.data, []))[1].append([*map(tuple, one.matrix_world)])
    return {"blender": bpy.app.version_string, "meshes": {
        name: about_mesh(mesh, np.array(matrices)) for name, (mesh, matrices) in found.items()}}


def about_mesh(mesh, matrices):
    """Counts, kinds, and the box of all instances of a mesh, by the corners of its own box."""
    points = np.empty(3 * len(mesh.vertices), np.float32)
    mesh.vertices.foreach_get("co", points)
    low, high = points.reshape(-1, 3).min(axis=0), points.reshape(-1, 3).max(axis=0)
    box = np.array([[x, y, z] for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])])
    corners = np.einsum("nij,kj->nki", matrices[:, :3, :3], box) + matrices[:, None, :3, 3]
    return {"instances": len(matrices), "triangles": len(mesh.polygons), "low": corners.min(axis=(0, 1)).tolist(),
            "high": corners.max(axis=(0, 1)).tolist(),
            "kinds": sorted({material.get("kind", "") for material in mesh.materials if material})}


def end_with_starter(litter):
    """Watch for the end of standard input, and then become a program that takes along temporary folders.

    Nobody else would remove them. While they go, none of Blender's threads is left that could write to them, or end the
    process in between.
    """
    def watch():
        while os.read(0, 1):
            pass
        os.execvp("rm", ["rm", "-rf", "--", *litter])

    threading.Thread(target=watch, daemon=True).start()


def main(job):
    file, extras = build(job["scene"])
    set_quality(job, extras)
    if "report" in job:
        with open(job["report"], "w", encoding="utf-8") as out:
            json.dump(report(), out)
    if "blend" in job:
        bpy.ops.wm.save_as_mainfile(filepath=job["blend"], check_existing=False, compress=True)
    if "picture" in job:
        bpy.context.scene.render.filepath = job["picture"]
        bpy.context.scene.render.use_file_extension = False
        bpy.ops.render.render(write_still=True)


if __name__ == "__main__":
    with open(sys.argv[sys.argv.index("--") + 1], encoding="utf-8") as text:
        given = json.load(text)
    if "litter" in given:
        end_with_starter(given["litter"])
    main(given)
