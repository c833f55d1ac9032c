# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Differences between versions of Blender, from 3.4 on, in one place. Each function names the versions."""

import bpy


def set_triangles(mesh, corners):
    """Fill the polygons of a mesh with triangles [n, 3].

    From 4.1 on the number of corners follows from where the next polygon starts, and cannot be set.
    """
    count = len(corners)
    mesh.loops.add(3 * count)
    mesh.loops.foreach_set("vertex_index", corners.ravel())
    mesh.polygons.add(count)
    mesh.polygons.foreach_set("loop_start", range(0, 3 * count, 3))
    if bpy.app.version < (4, 1):
        mesh.polygons.foreach_set("loop_total", [3] * count)


def geometry_tree(name):
    """A group of geometry nodes that turns a geometry into another; before 4.0 groups had no `interface`."""
    tree = bpy.data.node_groups.new(name, "GeometryNodeTree")
    if hasattr(tree, "interface"):
        tree.interface.new_socket("Geometry", in_out="INPUT", socket_type="NodeSocketGeometry")
        tree.interface.new_socket("Geometry", in_out="OUTPUT", socket_type="NodeSocketGeometry")
    else:
        tree.inputs.new("NodeSocketGeometry", "Geometry")
        tree.outputs.new("NodeSocketGeometry", "Geometry")
    return tree


def set_sky(node, elevation, rotation, dust):
    """Set a sky texture to that of a sun [rad], without its disc. The model's name, and that of dust, changed in 5.0."""
    kinds = node.bl_rna.properties["sky_type"].enum_items.keys()
    node.sky_type = next(kind for kind in ("NISHITA", "SINGLE_SCATTERING") if kind in kinds)
    node.sun_disc = False
    node.sun_elevation, node.sun_rotation = elevation, rotation
    setattr(node, "dust_density" if hasattr(node, "dust_density") else "aerosol_density", dust)


def use_eevee(scene):
    """Render by EEVEE, which was BLENDER_EEVEE_NEXT from 4.2 to 4.5."""
    kinds = bpy.types.RenderSettings.bl_rna.properties["engine"].enum_items.keys()
    scene.render.engine = "BLENDER_EEVEE_NEXT" if (4, 2) <= bpy.app.version < (5, 0) else "BLENDER_EEVEE"


def denoise(scene):
    """Let Cycles denoise by Open Image Denoise; False where this build of Blender has none, as Debian's 3.4."""
    try:
        scene.cycles.denoiser = "OPENIMAGEDENOISE"
    except TypeError:
        scene.cycles.use_denoising = False
        return False
    scene.cycles.use_denoising = True
    return True


def set_film(scene, exposure):
    """The film's response and exposure [EV]: Filmic, which versions with AgX still have."""
    scene.view_settings.view_transform = "Filmic"
    scene.view_settings.look = next(
        (look for look in ("Medium High Contrast", "Filmic - Medium High Contrast")
         if look in scene.view_settings.bl_rna.properties["look"].enum_items.keys()), "None")
    scene.view_settings.exposure = exposure


def roughness_specular(node, roughness, specular):
    """Roughness and specular of a Principled BSDF; the second changed its name in 4.0."""
    node.inputs["Roughness"].default_value = roughness
    node.inputs["Specular" if "Specular" in node.inputs else "Specular IOR Level"].default_value = specular


def no_lamp(material):
    """Let the glow of a material's haze not be sampled as that of a lamp; a property with another name before 3.5."""
    if hasattr(material.cycles, "emission_sampling"):
        material.cycles.emission_sampling = "NONE"
    else:
        material.cycles.sample_as_light = False


def long_steps(material, rate):
    """Let Cycles take longer steps through a volume, in versions where a material tells them."""
    if hasattr(material.cycles, "volume_step_rate"):
        material.cycles.volume_step_rate = rate


def no_hits(lamp):
    """Let light of a lamp be asked for by every surface, and not be found by chance as well: it has no mirror images. The
    property was Cycles' own before 5.0."""
    for settings in (getattr(lamp, "cycles", None), lamp):
        if hasattr(settings, "use_multiple_importance_sampling"):
            settings.use_multiple_importance_sampling = False


def set_shutter(scene, share):
    """The share of a frame that the shutter is open; up to 4.1 EEVEE had settings of its own."""
    for settings, switch in ((scene.render, "use_motion_blur"), (scene.eevee, "use_motion_blur")):
        if hasattr(settings, switch):
            setattr(settings, switch, share > 0.0)
        if share > 0.0 and hasattr(settings, "motion_blur_shutter"):
            settings.motion_blur_shutter = share
