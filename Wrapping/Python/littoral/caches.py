# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Point caches (.pc2): where the points of a mesh are at each sample of a motion, for Blender's modifier Mesh Cache."""

import os
import struct

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from . import errors, files
from .glb import motion_of

#: Signature, version, points, first frame, frames a sample, samples; then x, y, z of each point in each sample.
HEADER = struct.Struct("<12siiffi")
CELLS = "Verts", "Lines", "Polys", "Strips"


def write_pc2(filename, source, times, block="", origin=(0.0, 0.0, 0.0)):
    """Write where the points of a moving surface or of particles are; raises OSError or ValueError.

    source: an algorithm or a port of one, whose data are a vtkPolyData, or blocks with one.
    times: begin and end of the motion [s] and its samples a second, as those of `write_glb`; 24 a second if left out.
    block: names of blocks down to the data, as in "High/Leaves".
    origin: what is subtracted from all points [m], as single precision has 7 digits; the translation of the mesh's node.

    Points must keep their number and cells. The file takes the place of an old one only when it is whole.
    """
    begin, end, rate = motion_of(times)
    if not (np.isfinite((begin, end, rate)).all() and end > begin and rate > 0.0):
        raise ValueError(f"times are {times}; begin, a later end and a positive rate are needed")
    port = source.GetOutputPort() if hasattr(source, "GetOutputPort") else source
    count = 1 + int((end - begin) * rate + 1e-9)
    first = None
    with files.replaced(filename) as path, open(path, "wb") as file:
        for sample in range(count):
            time = begin + sample / rate
            data = _data_at(port, time, block)
            points = _points_of(data, origin, f"at {time:g} s")
            if first is None:
                first = len(points), _cells_of(data)
                file.write(HEADER.pack(b"POINTCACHE2\0", 1, first[0], 0.0, 1.0, count))
            _check_same(first, points, data, f"at {time:g} s", begin)
            file.write(points.astype("<f4").tobytes())


def read_pc2(filename):
    """Positions [sample, point, 3] of a point cache [m]. Raises OSError, and ValueError if it is none."""
    with open(filename, "rb") as file:
        data = file.read()
    if len(data) < HEADER.size or data[:12] != b"POINTCACHE2\0":
        raise ValueError(f"{os.fspath(filename)} is no point cache")
    _, _, points, _, _, samples = HEADER.unpack_from(data)
    if len(data) != HEADER.size + 12 * points * samples:
        raise ValueError(f"{os.fspath(filename)} is not whole")
    return np.frombuffer(data, "<f4", offset=HEADER.size).reshape(samples, points, 3)


def _data_at(port, time, block):
    """The polygonal data of a port at a time."""
    producer = port.GetProducer()
    with errors.caught(producer) as messages:
        producer.UpdateTimeStep(time)
    if messages:
        raise ValueError(messages[0])
    data = producer.GetOutputDataObject(port.GetIndex())
    for name in filter(None, block.split("/")):
        data = _block(data, name)
    if data is None or not data.IsA("vtkPolyData"):
        raise ValueError(f"{producer.GetClassName()} has a {data.GetClassName() if data else 'block without data'}"
                         f"{' at ' + block if block else ''}, and no vtkPolyData; `block` chooses one")
    return data


def _block(blocks, name):
    """The block of a name."""
    if blocks is None or not hasattr(blocks, "GetNumberOfBlocks"):
        raise ValueError(f"there is no block {name}")
    for index in range(blocks.GetNumberOfBlocks()):
        about = blocks.GetMetaData(index)
        if about and about.Has(blocks.NAME()) and about.Get(blocks.NAME()) == name:
            return blocks.GetBlock(index)
    raise ValueError(f"there is no block {name}")


def _points_of(data, origin, where):
    """The points from the origin, in double precision."""
    if data.GetNumberOfPoints() == 0:
        raise ValueError(f"{where} there are no points")
    points = vtk_to_numpy(data.GetPoints().GetData()) - np.asarray(origin, float)
    wrong = np.flatnonzero(~np.isfinite(points).all(axis=1))
    if len(wrong):
        raise ValueError(f"{where} point {wrong[0]} is not finite")
    if np.abs(points).max() > np.finfo(np.float32).max:
        raise ValueError(f"{where} a point is beyond single precision")
    return points


def _cells_of(data):
    """The points of all cells, in order."""
    found = []
    for kind in CELLS:
        cells = getattr(data, "Get" + kind)()
        found += [vtk_to_numpy(cells.GetOffsetsArray()).copy(), vtk_to_numpy(cells.GetConnectivityArray()).copy()]
    return found


def _check_same(first, points, data, where, begin):
    """Raises ValueError if points or cells are other ones than those of the first sample."""
    if len(points) != first[0]:
        raise ValueError(f"{where} there are {len(points)} points, and {first[0]} at {begin:g} s; only data that keep "
                         "their points can be cached")
    if not all(np.array_equal(a, b) for a, b in zip(first[1], _cells_of(data))):
        raise ValueError(f"{where} the cells are other ones than at {begin:g} s; only data that keep them can be cached")
