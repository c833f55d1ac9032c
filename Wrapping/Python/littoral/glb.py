# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes as files of glTF 2.0 (.glb), for Blender and other renderers."""

import json
import os

import numpy as np

from . import errors
from .properties import set_properties


def write_glb(filename, sources, times=None, camera=None, sun=None, extras=None, kinds=None, **settings):
    """Write sources as a scene of glTF 2.0 for Blender and other renderers; raises OSError or ValueError.

    sources: algorithms or data by the names that they have in the scene, or a list of them.
    times: begin and end of a motion [s] and its samples a second; default: as the sources are.
    camera: a vtkCamera, or position, focal point, direction up and vertical angle [m, degrees].
    sun: azimuth and elevation [degrees]; if a third number follows, the illuminance [lx].
    extras: what renderers should know of water, fog, volumes and sky, as a dictionary.
    kinds: the kind of a source by its name, such as "water", where the data do not tell it.
    settings: any property of vtkGLTFSceneWriter, such as InstanceForm=1.

    The file takes the place of an old one only when it is whole.
    """
    writer = _glb_writer(sources, kinds or {}, settings)
    if times is not None:
        writer.WriteMotionOn()
        begin, end, rate = motion_of(times)
        writer.SetStartTime(begin)
        writer.SetEndTime(end)
        writer.SetFramesPerSecond(rate)
    if camera is not None:
        _set_camera(writer, camera)
    if sun is not None:
        writer.WriteSunOn()
        writer.SetSunDirection(*direction(*sun[:2]))
        if len(sun) > 2:
            writer.SetSunIlluminance(sun[2])
    if extras:
        writer.SetExtras(json.dumps(extras, allow_nan=False))
    writer.SetFileName(os.fspath(filename))
    messages = errors.kept(writer)
    if not writer.Write():
        raise OSError(messages[0] if messages else f"Cannot write the file {os.fspath(filename)}: a source failed.")


def _glb_writer(sources, kinds, settings):
    """A writer with sources, kinds and properties, by their names."""
    from . import vtkGLTFSceneWriter

    writer = vtkGLTFSceneWriter()
    named = sources.items() if hasattr(sources, "items") else ((f"Source {k}", s) for k, s in enumerate(sources))
    names = []
    for index, (name, source) in enumerate(named):
        if hasattr(source, "GetOutputPort"):
            writer.AddInputConnection(source.GetOutputPort())
        elif hasattr(source, "GetProducer"):  # a port of an algorithm
            writer.AddInputConnection(source)
        else:
            writer.AddInputDataObject(0, source)
        writer.SetSourceName(index, name)
        names.append(name)
    for name, kind in kinds.items():
        if name not in names:
            raise ValueError(f"kinds names {name!r}, which is no source")
        writer.SetSourceKind(names.index(name), _kind(writer, kind))
    return set_properties(writer, settings)


def _kind(writer, kind):
    """The number of a kind by its name, as in "water"."""
    number = getattr(writer, str(kind).capitalize(), None)
    if not isinstance(number, int):
        raise ValueError(f"there is no kind {kind!r}")
    return number


def _set_camera(writer, camera):
    if hasattr(camera, "GetFocalPoint"):
        camera = camera.GetPosition(), camera.GetFocalPoint(), camera.GetViewUp(), camera.GetViewAngle()
    position, focus, up, angle = camera
    writer.WriteCameraOn()
    writer.SetCameraPosition(*position)
    writer.SetCameraFocalPoint(*focus)
    writer.SetCameraViewUp(*up)
    writer.SetCameraViewAngle(angle)


def motion_of(times):
    """Begin, end and samples a second, 24 if there are only two numbers."""
    return tuple(float(time) for time in times) if len(times) > 2 else (float(times[0]), float(times[1]), 24.0)


def direction(azimuth, elevation):
    """Unit vector towards an azimuth, from north to the east, and an elevation [degrees]."""
    a, e = np.radians((azimuth, elevation))
    return np.array((np.sin(a) * np.cos(e), np.cos(a) * np.cos(e), np.sin(e)))
