# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Cost over size: benchmarks with an argument `size`, the exponents of their time, and charts of it."""

import collections
import html
import math
import re

STEEP = 1.1  # exponent above which a benchmark is flagged
#: Benchmarks (regular expressions of program and name) whose work is n log n, and what makes it so: from 256^2 to 2048^2
#: its exponent is 1.08.
LOGARITHMIC = (("bench_drainage", r"(Flood|Breach|RouteByTiles|Carve\w+|GrowLikePlace|QuiltLikePlace)/.*", "a queue by height"),
               ("bench_terrain", r"MeasureVariogram/.*", "Fourier transforms"),
               ("bench_wind", r".*", "Fourier transforms"))

Series = collections.namedtuple("Series", "program name points")  # points: (size, time [ms])

# Of the charts [pixels]
WIDTH, HEIGHT = 860, 520
LEFT, RIGHT, TOP, BOTTOM = 70, 300, 30, 50
COLORS = "#cc451f", "#216b9e", "#4a8f59", "#8c66a6", "#cc9e33", "#66a8b8", "#7a7a7a"


def series_of(results):
    """Benchmarks that were run with two sizes or more."""
    found = {}
    for result in results:
        size = re.search(r"\bsize:(\d+)", result.name)
        if size and int(size[1]) > 0 and result.time > 0.0:
            name = result.name.replace(size[0], "size")
            found.setdefault((result.program, name), {}).setdefault(int(size[1]), result.time)
    return [Series(*key, sorted(points.items())) for key, points in found.items() if len(points) > 1]


def exponent_of(points):
    """Slope of the line through logarithms of sizes and times, by least squares."""
    x = [math.log(size) for size, _ in points]
    y = [math.log(time) for _, time in points]
    mean_x, mean_y = sum(x) / len(x), sum(y) / len(y)
    return sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / sum((a - mean_x) ** 2 for a in x)


def logarithm_of(series):
    """What makes the work of a series n log n; empty where nothing is known to."""
    return next((reason for program, name, reason in LOGARITHMIC
                 if program == series.program and re.fullmatch(name, series.name)), "")


def decades(values):
    """The powers of ten between which all values are, at least one decade."""
    low = math.floor(math.log10(min(values)) + 1e-9)
    return low, max(low + 1, math.ceil(math.log10(max(values)) - 1e-9))


def chart(title, series, across="size"):
    """SVG of times over sizes, or of what else a title says, both axes logarithmic, with exponents."""
    low_x, high_x = decades([size for one in series for size, _ in one.points])
    low_y, high_y = decades([time for one in series for _, time in one.points])

    def at(size, time):
        x = LEFT + (math.log10(size) - low_x) / (high_x - low_x) * (WIDTH - LEFT - RIGHT)
        y = HEIGHT - BOTTOM - (math.log10(time) - low_y) / (high_y - low_y) * (HEIGHT - TOP - BOTTOM)
        return f"{x:.1f}", f"{y:.1f}"

    def text(x, y, words, more=""):
        return f'<text x="{x}" y="{y}" {more}>{html.escape(words)}</text>'

    def line(begin, end, color):
        return f'<path d="M{",".join(begin)} L{",".join(end)}" stroke="{color}"/>'

    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" '
             'font-family="sans-serif" font-size="13" fill="none">',
             f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>', '<g fill="#333">',
             text(LEFT, 20, f"{title}, with exponents", 'font-weight="bold"'),
             text((LEFT + WIDTH - RIGHT) / 2, HEIGHT - 8, across, 'text-anchor="middle"')]
    for power in range(low_x, high_x + 1):
        x, y = at(10.0 ** power, 10.0 ** low_y)
        parts.append(text(x, float(y) + 18, f"1e{power}", 'text-anchor="middle"'))
    for power in range(low_y, high_y + 1):
        x, y = at(10.0 ** low_x, 10.0 ** power)
        parts.append(text(float(x) - 8, float(y) + 4, f"{10.0 ** power:g}", 'text-anchor="end"'))
    parts.append("</g>")
    for power in range(low_x, high_x + 1):
        parts.append(line(at(10.0 ** power, 10.0 ** low_y), at(10.0 ** power, 10.0 ** high_y), "#e0e0e0"))
    for power in range(low_y, high_y + 1):
        parts.append(line(at(10.0 ** low_x, 10.0 ** power), at(10.0 ** high_x, 10.0 ** power), "#e0e0e0"))
    for rank, one in enumerate(series):
        color = COLORS[rank % len(COLORS)]
        dashes = ' stroke-dasharray="7 4"' if rank // len(COLORS) % 2 else ""
        places = [at(*point) for point in one.points]
        parts.append(f'<polyline points="{" ".join(map(",".join, places))}" stroke="{color}" stroke-width="2"{dashes}/>')
        parts += [f'<circle cx="{x}" cy="{y}" r="4" fill="{color}"/>' for x, y in places]
        words = f"{one.name.removesuffix('/real_time')}: {exponent_of(one.points):.2f}"
        parts.append(text(WIDTH - RIGHT + 10, TOP + 18 * (rank + 1), words, f'fill="{color}"'))
    return "\n".join([*parts, "</svg>", ""])
