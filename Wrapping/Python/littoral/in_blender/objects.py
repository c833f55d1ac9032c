# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Objects of Blender from the nodes of a scene file: meshes from arrays, plants as instances of geometry nodes."""

import os

import bpy
import mathutils
import numpy as np

from . import versions
from .gltf import euler

TRIANGLES, POINTS = 4, 0


class Builder:
    """Makes the objects of a file; `materials` gives the material of an index and a use, `caches` the point cache of the
    node of a name."""

    def __init__(self, file, materials, caches):
        self.file, self.materials, self.caches = file, materials, caches
        self.meshes, self.places = {}, {}
        self.prototypes = bpy.data.collections.new("Prototypes")  # in no scene: drawn by their instances alone

    def build(self):
        """Make all objects. Parts of a plant with the same instances become one mesh with several materials."""
        together = {}
        for node, matrix in self.file.nodes():
            if "mesh" not in node:
                continue
            instances = self.file.instances(node)
            if instances is None:
                self._follow(node, self._add(node.get("name", "Mesh"), self._mesh((node["mesh"],)), matrix))
                self._add_particles(node, matrix)
                continue
            attributes = node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]
            key = attributes.get("TRANSLATION"), attributes.get("ROTATION"), attributes.get("SCALE")
            found = together.setdefault(key, [[], matrix, instances])
            found[0].append(node["mesh"])
            if "_TINT" in attributes:
                found[2] = instances
        for meshes, matrix, instances in together.values():
            self._scatter(tuple(meshes), matrix, instances)
        for node, matrix in self.file.nodes():
            if "camera" in node:
                self._add_camera(self.file.json["cameras"][node["camera"]], matrix)

    def _add(self, name, mesh, matrix):
        if mesh is None:
            return None
        thing = bpy.data.objects.new(name, mesh)
        thing.matrix_world = mathutils.Matrix(matrix.tolist())
        bpy.context.scene.collection.objects.link(thing)
        return thing

    def _follow(self, node, thing):
        """Let the vertices of an object follow the point cache of its node, if there is one."""
        path = self.caches.get(node.get("name"))
        if path is None or thing is None:
            return
        with open(path, "rb") as file:
            header = file.read(32)
        points, samples = (int.from_bytes(header[at:at + 4], "little") for at in (16, 28))
        if points != len(thing.data.vertices):
            raise ValueError(f"{path} has {points} points, and {node.get('name')} {len(thing.data.vertices)}")
        cache = thing.modifiers.new("Motion", "MESH_CACHE")
        cache.cache_format, cache.filepath, cache.frame_start = "PC2", os.path.abspath(path), 1
        cache.forward_axis, cache.up_axis = "POS_Y", "POS_Z"
        bpy.context.scene.frame_end = max(bpy.context.scene.frame_end, samples)

    def _mesh(self, indices):
        """A mesh with the triangles of meshes of the file; None if they have none."""
        if indices in self.meshes:
            return self.meshes[indices]
        parts = [(part, self.file.list("meshes")[index]) for index in indices
                 for part in self.file.list("meshes")[index]["primitives"] if part.get("mode", TRIANGLES) == TRIANGLES]
        self.meshes[indices] = self._join([part for part, _ in parts], parts[0][1].get("name", "Mesh")) if parts else None
        return self.meshes[indices]

    def _join(self, parts, name):
        points = [self.file.array(part["attributes"]["POSITION"]) for part in parts]
        firsts = np.cumsum([0] + [len(p) for p in points])
        corners = [self.file.array(part["indices"]).reshape(-1, 3).astype(np.int32) + first
                   for part, first in zip(parts, firsts)]
        mesh = bpy.data.meshes.new(name)
        mesh.vertices.add(firsts[-1])
        mesh.vertices.foreach_set("co", np.concatenate(points).astype(np.float32).ravel())
        triangles = np.concatenate(corners)
        versions.set_triangles(mesh, triangles)
        slots = {}
        for part in parts:
            slots.setdefault(part.get("material"), len(slots))
        for index in slots:
            mesh.materials.append(self.materials.get(index))
        mesh.polygons.foreach_set("material_index", np.concatenate(
            [np.full(len(c), slots[part.get("material")], np.int32) for part, c in zip(parts, corners)]))
        flat = ("leaf", "grass")
        mesh.polygons.foreach_set("use_smooth", np.concatenate(
            [np.full(len(c), self.file.kind(part.get("material")) not in flat) for part, c in zip(parts, corners)]))
        self._set_colors(mesh, parts, points)
        if any("TEXCOORD_0" in part["attributes"] for part in parts):
            at = np.concatenate([self._attribute(part, "TEXCOORD_0", p, (0.0, 0.0)) for part, p in zip(parts, points)])
            layer = mesh.uv_layers.new(name="UVMap")
            layer.data.foreach_set("uv", (at * np.float32((1, -1)) + np.float32((0, 1)))[triangles.ravel()].ravel())
        if any("_VELOCITY" in part["attributes"] for part in parts):
            speeds = [self._attribute(part, "_VELOCITY", p, (0.0, 0.0, 0.0)) for part, p in zip(parts, points)]
            _set_attribute(mesh, "velocity", np.concatenate(speeds))
        mesh.update()
        return mesh

    def _set_colors(self, mesh, parts, points):
        """The linear colors of the vertices; white where there are none, as a shader would find black then."""
        colors = np.ones((len(mesh.vertices), 4), np.float32)
        found = [self._attribute(part, "COLOR_0", p, (1.0, 1.0, 1.0)) for part, p in zip(parts, points)]
        colors[:, :3] = np.concatenate([c[:, :3] for c in found])
        mesh.color_attributes.new("Color", "FLOAT_COLOR", "POINT").data.foreach_set("color", colors.ravel())

    def _attribute(self, part, name, points, absent):
        index = part["attributes"].get(name)
        return np.tile(np.float32(absent), (len(points), 1)) if index is None else self.file.array(index)

    def _scatter(self, meshes, matrix, instances):
        """Instances of meshes, as points with rotation, scale and tint and a group of geometry nodes."""
        mesh = self._mesh(meshes)
        if mesh is None:
            return
        prototype = bpy.data.objects.new(f"Prototype {mesh.name}", mesh)
        self.prototypes.objects.link(prototype)
        translations, rotations, scales, tints = instances
        points = _cloud(f"Places of {mesh.name}", translations, rotation=euler(rotations), scale=scales, tint=tints)
        thing = self._add(f"Instances of {mesh.name}", points, matrix)
        modifier = thing.modifiers.new("Instances", "NODES")
        modifier.node_group = _instances_of(prototype)

    def _add_particles(self, node, matrix):
        """Points with a radius, as spheres."""
        for part in self.file.list("meshes")[node["mesh"]]["primitives"]:
            if part.get("mode", TRIANGLES) != POINTS:
                continue
            chosen = self.file.array(part["indices"]).ravel() if "indices" in part else slice(None)
            places = self.file.array(part["attributes"]["POSITION"])
            radius = self._attribute(part, "_RADIUS", places, (0.01,))[chosen, 0]
            colors = self._attribute(part, "COLOR_0", places, (1.0, 1.0, 1.0))[chosen, :3]
            speeds = self._attribute(part, "_VELOCITY", places, (0.0, 0.0, 0.0))[chosen]
            some = {"velocity": speeds} if "_VELOCITY" in part["attributes"] else {}
            cloud = _cloud(f"{node.get('name', 'Points')} points", places[chosen], size=radius, tint=colors, **some)
            thing = self._add(cloud.name, cloud, matrix)
            self._follow(node, thing)
            thing.modifiers.new("Spheres", "NODES").node_group = _spheres(self.materials.get(part.get("material")))

    def _add_camera(self, about, matrix):
        lens = bpy.data.cameras.new("Camera")
        lens.sensor_fit = "VERTICAL"
        lens.angle = about["perspective"]["yfov"]
        lens.clip_start, lens.clip_end = 0.05, 1e5
        camera = self._add("Camera", lens, matrix)
        bpy.context.scene.camera = camera


def _cloud(name, places, **attributes):
    """Loose points with attributes of one or three numbers."""
    mesh = bpy.data.meshes.new(name)
    mesh.vertices.add(len(places))
    mesh.vertices.foreach_set("co", np.float32(places).ravel())
    for attribute, values in attributes.items():
        _set_attribute(mesh, attribute, values)
    mesh.update()
    return mesh


def _set_attribute(mesh, name, values):
    """An attribute of the vertices, of one or three numbers each."""
    kind, field = ("FLOAT", "value") if values.ndim == 1 else ("FLOAT_VECTOR", "vector")
    mesh.attributes.new(name, kind, "POINT").data.foreach_set(field, np.float32(values).ravel())


def _named(tree, name, kind="FLOAT_VECTOR"):
    """The output of a node that reads an attribute."""
    node = tree.nodes.new("GeometryNodeInputNamedAttribute")
    node.data_type = kind
    node.inputs["Name"].default_value = name
    return next(output for output in node.outputs if output.enabled and output.name == "Attribute")


def _instances_of(prototype):
    """Geometry nodes that put a prototype at each point."""
    tree = versions.geometry_tree(f"Instances of {prototype.name}")
    new, link = tree.nodes.new, tree.links.new
    start, end = new("NodeGroupInput"), new("NodeGroupOutput")
    about, place = new("GeometryNodeObjectInfo"), new("GeometryNodeInstanceOnPoints")
    about.inputs["Object"].default_value = prototype
    about.inputs["As Instance"].default_value = False
    link(start.outputs[0], place.inputs["Points"])
    link(about.outputs["Geometry"], place.inputs["Instance"])
    link(_named(tree, "rotation"), place.inputs["Rotation"])
    link(_named(tree, "scale"), place.inputs["Scale"])
    link(place.outputs["Instances"], end.inputs[0])
    return tree


def _spheres(material):
    """Geometry nodes that make a sphere of each point, with its radius."""
    tree = versions.geometry_tree("Spheres")
    new, link = tree.nodes.new, tree.links.new
    start, end = new("NodeGroupInput"), new("NodeGroupOutput")
    cloud, dress = new("GeometryNodeMeshToPoints"), new("GeometryNodeSetMaterial")
    dress.inputs["Material"].default_value = material
    link(start.outputs[0], cloud.inputs["Mesh"])
    link(_named(tree, "size", "FLOAT"), cloud.inputs["Radius"])
    link(cloud.outputs[0], dress.inputs["Geometry"])
    link(dress.outputs[0], end.inputs[0])
    return tree
