# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Cards cut along the edges of what their picture shows. A ray that meets a mask has to ask for its picture there and to begin
anew behind a hole; one that meets a cut card has not."""

import numpy as np
from mathutils import geometry

#: By how much a cut may be off the edge [texels], how many triangles may be cut in different ways, and into how many each.
TOLERANCE, MANY, MOST = 0.3, 16, 200
#: The share that a picture may leave out of a triangle without a cut: a leaf within a hem stays whole.
HEM = 0.03
WHOLE = np.eye(3), np.array([[0, 1, 2]])
#: Even places in a triangle, as shares of its corners.
WITHIN = np.array([(i + 1 / 3, j + 1 / 3, 20 - 2 / 3 - i - j) for i in range(20) for j in range(20 - i)]) / 20.0


def patterns_of(alpha, corners):
    """How to cut triangles by an alpha [row, column], rows from below. corners: texture coordinates [n, 6] of the corners of
    distinct triangles. Returns a pair for each: places, as shares of the three corners, and triangles of them; None if a cut
    would need too many."""
    corners = corners.reshape(-1, 3, 2) * alpha.shape[::-1]
    inside = _alpha_at(alpha, (WITHIN @ corners).reshape(-1, 2)).reshape(len(corners), -1) > 0.5
    have_holes = inside.mean(axis=1) < 1.0 - HEM
    if have_holes.sum() > MANY:
        return None
    lines = outlines(alpha) if have_holes.any() else []
    found = [_cut(alpha, lines, corner) if has_holes else WHOLE for corner, has_holes in zip(corners, have_holes)]
    return found if max(len(faces) for _, faces in found) <= MOST else None


def cut(triangles, kinds, patterns, attributes):
    """Triangles [n, 3] cut by the patterns of their kinds [n]; returns the new ones, and attributes [vertex, part] of their
    vertices by name."""
    new, made, first = [], {name: [] for name in attributes}, 0
    for kind, (places, faces) in enumerate(patterns):
        own = triangles[kinds == kind]
        for name, values in attributes.items():
            made[name].append(np.einsum("pc,ncv->npv", places, values[own]).reshape(-1, values.shape[1]))
        starts = first + len(places) * np.arange(len(own))
        new.append((starts[:, None, None] + faces).reshape(-1, 3))
        first += len(places) * len(own)
    return np.concatenate(new).astype(np.int32), {name: np.concatenate(parts) for name, parts in made.items()}


def _alpha_at(alpha, places):
    """The alpha at places [n, 2] in texels, linear between the middles of texels."""
    rows, columns = alpha.shape
    x, y = np.clip(places[:, 0] - 0.5, 0.0, columns - 1.0), np.clip(places[:, 1] - 0.5, 0.0, rows - 1.0)
    column, row = np.minimum(x.astype(int), columns - 2), np.minimum(y.astype(int), rows - 2)
    s, t = x - column, y - row
    return (1 - t) * ((1 - s) * alpha[row, column] + s * alpha[row, column + 1]) + t * (
        (1 - s) * alpha[row + 1, column] + s * alpha[row + 1, column + 1])


def outlines(alpha):
    """Closed lines [n, 2] in texels about where an alpha is above a half, by marching squares."""
    values = np.pad(np.pad(alpha, 1, "edge"), 1)  # closed outside of the picture
    follows, crossing = {}, {}
    inside = values > 0.5
    mixed = inside[:-1, :-1] + 0 + inside[:-1, 1:] + inside[1:, 1:] + inside[1:, :-1]
    for row, column in np.argwhere((mixed > 0) & (mixed < 4)):
        around = [(row, column), (row, column + 1), (row + 1, column + 1), (row + 1, column)]
        ring = []  # crossings of the cell's sides, counter-clockwise, and whether the way around leaves the inside there
        for a, b in zip(around, around[1:] + around[:1]):
            if inside[a] != inside[b]:
                key = min(a, b), max(a, b)
                ring.append((key, inside[a]))
                share = (0.5 - values[a]) / (values[b] - values[a])
                crossing[key] = a[1] + share * (b[1] - a[1]) - 1.5, a[0] + share * (b[0] - a[0]) - 1.5
        if len(ring) == 4 and ring[0][1] != (np.mean([values[a] for a in around]) > 0.5):
            ring = ring[1:] + ring[:1]
        for (one, leaves), (other, _) in zip(ring[::2], ring[1::2]):
            follows.update([(one, other) if leaves else (other, one)])
    lines = []
    while follows:
        key, value = follows.popitem()
        keys = [key]
        while value != keys[0]:
            keys.append(value)
            value = follows.pop(value)
        lines.append(_simple(np.array([crossing[key] for key in keys])))
    return [line for line in lines if len(line) > 2]


def _simple(line):
    """A closed line without the points that are within the tolerance of it (Douglas and Peucker)."""
    far = int(np.argmax(np.linalg.norm(line - line[0], axis=1)))
    kept, left = {0, far}, [(0, far), (far, len(line))]
    closed = np.concatenate((line, line[:1]))
    while left:
        a, b = left.pop()
        if b - a < 2:
            continue
        along = closed[b] - closed[a]
        length = np.hypot(*along)
        away = closed[a + 1:b] - closed[a]
        away = np.abs(away[:, 0] * along[1] - away[:, 1] * along[0]) / length if length > 0.0 else np.hypot(*away.T)
        most = int(np.argmax(away))
        if away[most] > TOLERANCE:
            kept.add(a + 1 + most)
            left += [(a, a + 1 + most), (a + 1 + most, b)]
    return line[sorted(kept)]


def _cut(alpha, lines, corner):
    """The part of a triangle [3, 2] within lines, all in texels."""
    points, edges = [*corner], [(0, 1), (1, 2), (2, 0)]
    for line in lines:
        first = len(points)
        points += [*line]
        edges += [(first + k, first + (k + 1) % len(line)) for k in range(len(line))]
    places, _, faces, *_ = geometry.delaunay_2d_cdt([tuple(point) for point in points], edges, [], 0, 1e-5)
    places, faces = np.array(places, float), np.array(faces, int).reshape(-1, 3)
    shares = np.linalg.solve(np.vstack((corner.T, np.ones(3))), np.vstack((places.T, np.ones(len(places))))).T
    kept = (shares[faces].mean(axis=1) > 0.0).all(axis=1) & (_alpha_at(alpha, places[faces].mean(axis=1)) > 0.5)
    used, faces = np.unique(faces[kept], return_inverse=True)
    return shares[used], faces.reshape(-1, 3)
