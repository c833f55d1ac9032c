#!/usr/bin/env python3
# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draw the architecture from the #include lines of the tree: architecture.svg.

Usage: make_architecture.py [FILE] (default: architecture.svg beside this script)

An arrow stands for at least one #include; what the plugin links, by its CMakeLists.txt, is dashed. Testing/Documents
compares the picture with a fresh one.
"""

import os
import re
import sys
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
MODULES = ("Sources", "Filters", "Rendering", "IO")

# Column and floor of each room of Common, and what it holds. Each has a column of its own, so that arrows from above
# meet no other room.
ROOMS = {
    "Landscapes": (0, 3, ("evolution,", "growth")),
    "Drainage": (1, 2, ("flow, rivers,", "carving")),
    "Terrain": (2, 1, ("covariances, fits,", "turning bands")),
    "Kriging": (3, 2, ("kriging, fields", "through data")),
    "Patterns": (4, 2, ("quadrat laws,", "point processes")),
    "Wind": (5, 1, ("spectra, fields,", "loads")),
    "Sway": (6, 2, ("beams, trunks,", "leaves")),
    "Plants": (7, 1, ("skeletons, skins,", "scattering")),
    "Seaweed": (8, 3, ("growth, motion,", "wakes")),
    "Currents": (9, 2, ("flow primitives,", "drift")),
    "Sea": (10, 1, ("dispersion,", "trains, orbits")),
    "Particles": (11, 2, ("groups, levels,", "fog")),
    "Light": (12, 1, ("sun, sky,", "light on planes")),
}
GROUND = {
    "Geometry": "views, cells, height grids, textures",
    "Numerics": "random streams, Fourier transforms, lanes of numbers, quadrature, threads",
}
COLORS = {
    "Sources": "#b4531f",
    "Filters": "#2563a8",
    "IO": "#6b4c9a",
    "Rendering": "#a8722a",
    "Data": "#2f7d4f",
    "Pipeline": "#2f7d4f",
    "plugin": "#555b66",
    "room": "#8a6d1f",
}

WIDTH, HEIGHT, LEFT, PITCH, BOX = 1441, 812, 28, 107, 100
FLOOR_Y = {3: 390, 2: 476, 1: 562}
ROOM_HEIGHT = 78


# --- the tree -------------------------------------------------------------------------------------


def room_of(path):
    """The box that a file belongs to."""
    parts = path.relative_to(TOP).parts
    if parts[0] in ("Common", "Support"):
        return parts[1]
    return "plugin" if parts[0] == "paraview-plugin" else parts[0]


def read_arrows():
    """The pairs (includes, is included) of boxes."""
    bases = [TOP / name for name in ("Common", "Support", *MODULES, "paraview-plugin")]
    files = [file for base in bases for kind in ("*.h", "*.cxx") for file in base.rglob(kind)]
    known, arrows = set(files), set()
    for file in files:
        for name in re.findall(r'^#include "([^"]+)"', file.read_text(encoding="utf-8"), re.M):
            for folder in (*bases, file.parent):
                if folder / name in known:
                    arrows.add((room_of(file), room_of(folder / name)))
                    break
    return sorted(arrow for arrow in arrows if arrow[0] != arrow[1])


def read_links():
    """The modules that the plugin links."""
    text = (TOP / "paraview-plugin" / "CMakeLists.txt").read_text(encoding="utf-8")
    return [name for name in MODULES if f"Littoral::Littoral{name}" in text]


def check_rooms():
    """Each folder of Common has its box, and each box its folder."""
    folders = {path.name for path in (TOP / "Common").iterdir() if path.is_dir()}
    drawn = set(ROOMS) | set(GROUND)
    if folders != drawn:
        sys.exit(f"Rooms of Common and of this script differ: {sorted(folders ^ drawn)}")


# --- drawing --------------------------------------------------------------------------------------


class Drawing:
    """Lines of an SVG file: arrows below boxes."""

    def __init__(self):
        self.arrows, self.boxes = [], []

    def box(self, x, y, width, height, title, lines=(), fill="#fff", stroke="#c9c2b2", title_size=17):
        middle = x + width / 2
        self.boxes.append(
            f'<rect x="{x}" y="{y}" width="{width}" height="{height}" rx="7" fill="{fill}" stroke="{stroke}"/>')
        baseline = y + height / 2 - 7 * len(lines) + (7 if len(lines) > 1 else 4)
        self.text(middle, baseline, title, title_size, "#22262e", "600")
        for k, line in enumerate(lines):
            self.text(middle, baseline + 17 + 15 * k, line, 12.5, "#4d5363")

    def text(self, x, y, words, size, color, weight="400", anchor="middle"):
        self.boxes.append(
            f'<text x="{x:g}" y="{y:g}" font-size="{size}" font-weight="{weight}" fill="{color}"'
            f' text-anchor="{anchor}">{words}</text>')

    def arrow(self, points, color, dashed=False, head=True):
        """Along points [(x, y)], with round corners."""
        path = f"M{points[0][0]:g} {points[0][1]:g}"
        for before, corner, after in zip(points, points[1:], points[2:]):
            path += f" L{toward(corner, before)} Q{corner[0]:g} {corner[1]:g} {toward(corner, after)}"
        path += f" L{points[-1][0]:g} {points[-1][1]:g}"
        extra = ' stroke-dasharray="5 4"' if dashed else ""
        if head:
            extra += f' marker-end="url(#head-{color[1:]})"'
        self.arrows.append(f'<path d="{path}" fill="none" stroke="{color}" stroke-width="1.6"{extra}/>')

    def svg(self):
        heads = "\n".join(
            f'<marker id="head-{color[1:]}" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="7" markerHeight="7"'
            f' orient="auto"><path d="M0 0.6 L8 4 L0 7.4 Z" fill="{color}"/></marker>'
            for color in sorted(set(COLORS.values())))
        return "\n".join([
            "<!-- SPDX-FileCopyrightText: Littoral contributors -->",
            "<!-- SPDX-License-Identifier: BSD-3-Clause -->",
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}"'
            f' height="{HEIGHT}" font-family="Inter, Helvetica, Arial, sans-serif">',
            "<title>Architecture of Littoral</title>",
            f"<defs>\n{heads}\n</defs>",
            f'<rect width="{WIDTH}" height="{HEIGHT}" rx="10" fill="#fdfcf9"/>',
            *self.storeys(), *self.arrows, *self.boxes, "</svg>", ""])

    @staticmethod
    def storeys():
        """Background: the three storeys of the house."""
        for y, height, fill in ((118, 78, "#f1f4f9"), (222, 78, "#eef5f0"), (340, 456, "#f7f3e8")):
            yield f'<rect x="16" y="{y}" width="{WIDTH - 32}" height="{height}" rx="10" fill="{fill}"/>'


def toward(corner, other, radius=7):
    """The point at a radius from a corner on the way to another point."""
    dx, dy = other[0] - corner[0], other[1] - corner[1]
    length = max((dx * dx + dy * dy) ** 0.5, 1e-9)
    share = min(radius / length, 0.5)
    return f"{corner[0] + dx * share:g} {corner[1] + dy * share:g}"


def left_of(room):
    return LEFT + ROOMS[room][0] * PITCH


def draw_common(drawing, arrows):
    for room, (_, floor, lines) in ROOMS.items():
        x, y = left_of(room), FLOOR_Y[floor]
        drawing.box(x, y, BOX, ROOM_HEIGHT, room, lines, title_size=16)
        marks = "".join(name[0] for name in GROUND if (room, name) in arrows)
        drawing.text(x + BOX - 7, y + 14, marks, 10.5, "#9a8f70", "600", "end")
    for k, (room, words) in enumerate(GROUND.items()):
        drawing.box(LEFT, 664 + 58 * k, WIDTH - 2 * LEFT, 46, room, (words,), "#fffaf0")
    if ("Geometry", "Numerics") in arrows:
        drawing.arrow([(WIDTH / 2, 710), (WIDTH / 2, 721)], COLORS["room"])
    # From the foot of a room down, and sideways into the room that it includes.
    starts = {}
    for above, below in sorted(arrows, key=lambda arrow: ROOMS.get(arrow[1], (0,))[0]):
        if above in ROOMS and below in ROOMS:
            starts.setdefault(above, []).append(below)
    for above, targets in starts.items():
        for k, below in enumerate(targets):
            x = left_of(above) + BOX * (k + 1) / (len(targets) + 1)
            y = FLOOR_Y[ROOMS[below][1]] + ROOM_HEIGHT / 2 + 12
            side = left_of(below) + (BOX if ROOMS[below][0] < ROOMS[above][0] else 0)
            drawing.arrow([(x, FLOOR_Y[ROOMS[above][1]] + ROOM_HEIGHT), (x, y), (side, y)], COLORS["room"])


def draw_bus(drawing, arrows, name, trunk, start, bus, offset):
    """Arrows from a box above down to a level line, and from there into each room that it includes."""
    color = COLORS[name]
    if not any((name, room) in arrows for room in ROOMS):
        return
    drawing.arrow([(trunk, start), (trunk, bus)], color, head=False)
    for room in ROOMS:
        if (name, room) in arrows:
            x = left_of(room) + BOX / 2 + offset
            drawing.arrow([(trunk, bus), (x, bus), (x, FLOOR_Y[ROOMS[room][1]] - 1)], color)


def draw(drawing):
    arrows, links = read_arrows(), read_links()
    drawing.text(30, 136, "VTK classes", 14, "#4d5363", "600", "start")
    drawing.text(30, 240, "Support", 14, "#4d5363", "600", "start")
    drawing.text(30, 786, "Common, no VTK", 14, "#4d5363", "600", "start")
    boxes = {  # x, y, width, height
        "plugin": (410, 22, 300, 62), "Sources": (150, 130, 200, 54), "Filters": (365, 130, 200, 54),
        "Rendering": (580, 130, 180, 54), "IO": (775, 130, 200, 54), "Data": (210, 234, 330, 54),
        "Pipeline": (600, 234, 330, 54)}
    words = {
        "plugin": ("paraview-plugin", "menus, panels, the client's camera"),
        "Sources": ("Sources", "vtk...Source"),
        "Filters": ("Filters", "vtk...Filter"), "IO": ("IO", "rasters, volumes, scenes"),
        "Rendering": ("Rendering", "light, shadows, air"),
        "Data": ("Support/Data", "arrays, blocks, tables, images"),
        "Pipeline": ("Support/Pipeline", "progress, abort, ranges, the camera's view")}
    for name, (x, y, width, height) in boxes.items():
        drawing.box(x, y, width, height, words[name][0], (words[name][1],), stroke=COLORS[name])

    def across(name, share):
        return boxes[name][0] + boxes[name][2] * share

    def foot(name):
        return boxes[name][1] + boxes[name][3]

    # The plugin: what it links, and Pipeline that it includes.
    for name, share in zip(links, (0.2, 0.4, 0.6, 0.8)):
        x, y = across(name, 0.5), 100
        start = across("plugin", share)
        way = [(start, foot("plugin")), (start, y), (x, y), (x, boxes[name][1] - 1)]
        drawing.arrow(way if start != x else [way[0], way[-1]], COLORS["plugin"], dashed=True)
    if ("plugin", "Pipeline") in arrows:
        drawing.arrow([(across("plugin", 1), 53), (1010, 53), (1010, 261), (across("Pipeline", 1) + 1, 261)],
                      COLORS["plugin"])
    # Modules to Support.
    ways = (("Sources", "Data", 0.55, 0.22, 204), ("Sources", "Pipeline", 0.75, 0.2, 210),
            ("Filters", "Data", 0.25, 0.8, 204), ("Filters", "Pipeline", 0.5, 0.3, 204),
            ("IO", "Data", 0.3, 0.9, 216), ("IO", "Pipeline", 0.5, 0.75, 204))
    for above, below, begin, end, level in ways:
        if (above, below) in arrows:
            start, x = across(above, begin), across(below, end)
            drawing.arrow([(start, foot(above)), (start, level), (x, level), (x, boxes[below][1] - 1)], COLORS[above])
    if ("Data", "Pipeline") in arrows:
        drawing.arrow([(across("Data", 1), 261), (across("Pipeline", 0) - 1, 261)], COLORS["Data"])
    # Modules and Support to the rooms.
    draw_bus(drawing, arrows, "Sources", 180, foot("Sources"), 314, -16)
    draw_bus(drawing, arrows, "Data", across("Data", 0.5), foot("Data"), 324, 0)
    draw_bus(drawing, arrows, "Filters", 550, foot("Filters"), 334, 16)
    draw_bus(drawing, arrows, "Pipeline", across("Pipeline", 0.5), foot("Pipeline"), 344, 30)
    draw_bus(drawing, arrows, "IO", 950, foot("IO"), 354, -30)
    draw_bus(drawing, arrows, "Rendering", across("Rendering", 0.9), foot("Rendering"), 364, 44)
    draw_common(drawing, arrows)
    for k, line in enumerate(("arrow: includes", "dashed arrow: links", "N, G: includes Numerics, Geometry")):
        drawing.text(30, 40 + 20 * k, line, 14, "#4d5363", anchor="start")


def main():
    check_rooms()
    drawing = Drawing()
    draw(drawing)
    target = sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(__file__), "architecture.svg")
    Path(target).write_text(drawing.svg(), encoding="utf-8")


if __name__ == "__main__":
    main()
