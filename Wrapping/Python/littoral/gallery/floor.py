# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The floor of a wood in plain VTK: uneven ground in the shade of crowns, litter, grass and woods afar.

    floor = Floor(places, heights, crowns, eye)
    for data in (floor.ground(), floor.litter(), floor.grass(), floor.woods()):
        renderer.AddActor(lit_actor(data))

All is made about an eye, finer where it is nearer, from a seed. Points carry colors, in which the shade is.
"""

import numpy as np
from .meshes import polygons

#: Colors of a floor: bare litter, other litter, grass, dry grass.
BROADLEAVED = ((0.31, 0.24, 0.16), (0.44, 0.34, 0.22), (0.28, 0.36, 0.13), (0.46, 0.44, 0.22))
SAVANNA = ((0.42, 0.34, 0.22), (0.54, 0.44, 0.28), (0.42, 0.45, 0.20), (0.66, 0.58, 0.33))
HAZE = (0.80, 0.86, 0.90)
#: Distance at which haze takes 63 % of a color [m].
HAZE_DISTANCE = 1800.0
SHADE_CELL = 0.4  # m


def shaded(places, corners, colors):
    """Polygons between positions, with colors of these from 0 to 1."""
    return polygons(places, corners, (255.0 * np.clip(colors, 0.0, 1.0)).astype(np.uint8))


class Floor:
    """Ground about an eye (x, y, height above it [m]) below trees: places, heights and crown diameters [m].

    colors: of litter and grass, as BROADLEAVED; cover: share of grass, 0 to 1; sun: azimuth and elevation [degrees].
    """

    def __init__(self, places, heights, crowns, eye, colors=BROADLEAVED, cover=0.3, sun=(215.0, 40.0), seed=1):
        self.eye, self.colors, self.cover, self.seed = eye, np.array(colors), cover, seed
        self.random = np.random.default_rng(seed)
        self.waves = self.random.normal(size=(24, 3))
        self._shade(np.asarray(places, float), np.asarray(heights, float), np.asarray(crowns, float), sun)

    def _shade(self, places, heights, crowns, sun):
        """Light that passes the crowns, on a raster: each takes most of it in a disc away from the sun."""
        azimuth = np.radians(sun[0])
        middle = 0.65 * heights / np.tan(np.radians(sun[1]))
        centers = places[:, :2] - middle[:, None] * np.array((np.sin(azimuth), np.cos(azimuth)))
        self.low = centers.min(axis=0) - 15.0
        shape = np.ceil((centers.max(axis=0) + 15.0 - self.low) / SHADE_CELL).astype(int)
        light = np.ones((shape[1], shape[0]), np.float32)
        for (x, y), radius in zip(centers - self.low, 0.55 * crowns):
            i0, i1 = (int(max(0.0, (x + s * 1.3 * radius) / SHADE_CELL)) for s in (-1, 1))
            j0, j1 = (int(max(0.0, (y + s * 1.3 * radius) / SHADE_CELL)) for s in (-1, 1))
            dx = (np.arange(i0, i1 + 1) + 0.5) * SHADE_CELL - x
            dy = (np.arange(j0, j1 + 1) + 0.5) * SHADE_CELL - y
            part = light[j0:j1 + 1, i0:i1 + 1]
            r2 = (dx[None, :part.shape[1]] ** 2 + dy[:part.shape[0], None] ** 2) / max(radius, 0.2) ** 2
            part *= 1.0 - 0.75 * np.exp(-r2 ** 3)
        # Flecks of light between leaves.
        flecks = self.random.random(light.shape).astype(np.float32)
        flecks = 0.25 * (flecks + np.roll(flecks, 1, 0) + np.roll(flecks, 1, 1) + np.roll(flecks, (1, 1), (0, 1)))
        self.light = light + (1.0 - light) * np.clip(6.0 * (flecks - 0.68), 0.0, 0.7)

    def height(self, x, y):
        """Height of the ground [m]: soft swells of a decimetre or two, none afar."""
        z = np.zeros(np.shape(x))
        for k, (a, b, phase) in enumerate(self.waves[:12]):
            wave = (0.25, 0.6, 1.6)[k % 3]
            z = z + (0.09, 0.05, 0.015)[k % 3] * np.sin(wave * (a * x + b * y) + 6.0 * phase)
        far = np.hypot(x - self.eye[0], y - self.eye[1])
        return z * np.clip(1.6 - far / 100.0, 0.0, 1.0)

    def brightness(self, x, y):
        """Light on the ground, 0.42 to 1.1."""
        i = ((x - self.low[0]) / SHADE_CELL).astype(int)
        j = ((y - self.low[1]) / SHADE_CELL).astype(int)
        inside = (i >= 0) & (j >= 0) & (i < self.light.shape[1]) & (j < self.light.shape[0])
        light = np.ones(np.shape(x))
        light[inside] = self.light[j[inside], i[inside]]
        return 0.42 + 0.68 * light

    def grassiness(self, x, y):
        """Share of grass at a place: patches of some metres."""
        patches = sum(np.sin(w * (a * x + b * y) + 6.0 * c)
                      for (a, b, c), w in zip(self.waves[12:], (0.06, 0.13, 0.11, 0.3, 0.23, 0.7, 0.5, 1.3)))
        return np.clip(self.cover + 0.22 * patches, 0.0, 1.0)

    def hazy(self, color, x, y):
        """Colors, the paler the farther."""
        share = 1.0 - np.exp(-np.hypot(x - self.eye[0], y - self.eye[1]) / HAZE_DISTANCE)
        return color + share[:, None] * (np.array(HAZE) - color)

    def ground(self, rings=420, sectors=900):
        """The ground as rings about the eye, from 0.3 m to 4 km."""
        radius = 0.3 * (4000.0 / 0.3) ** (np.arange(rings) / (rings - 1.0))
        angle = 2.0 * np.pi * np.arange(sectors) / sectors
        x = (self.eye[0] + radius[:, None] * np.sin(angle)).ravel()
        y = (self.eye[1] + radius[:, None] * np.cos(angle)).ravel()
        grass = self.grassiness(x, y)[:, None]
        grain = self.random.random((len(x), 2))
        litter = self.colors[0] + grain[:, :1] * (self.colors[1] - self.colors[0])
        green = self.colors[2] + grain[:, 1:] * (self.colors[3] - self.colors[2])
        color = (litter + grass * (green - litter)) * (0.82 + 0.30 * grain[:, 1:]) * self.brightness(x, y)[:, None]
        n = np.arange((rings - 1) * sectors)
        right = np.where(n % sectors == sectors - 1, n + 1 - sectors, n + 1)
        corners = np.column_stack((n, n + sectors, right + sectors, right))
        return shaded(np.column_stack((x, y, self.height(x, y))), corners, self.hazy(color, x, y))

    def _about(self, count, reach):
        """Random places about the eye, of a density that falls with the distance."""
        radius = reach * self.random.random(count) ** 0.9
        angle = 2.0 * np.pi * self.random.random(count)
        return self.eye[0] + radius * np.sin(angle), self.eye[1] + radius * np.cos(angle)

    def litter(self, count=140000, reach=40.0, size=0.11):
        """Fallen leaves, flat on the ground; size: of the largest [m]."""
        x, y = self._about(count, reach)
        turn = 2.0 * np.pi * self.random.random(count)
        half = 0.5 * size * (0.4 + 0.6 * self.random.random((count, 1)))
        along = half * np.column_stack((np.cos(turn), np.sin(turn)))
        across = 0.6 * half * np.column_stack((-np.sin(turn), np.cos(turn)))
        z = self.height(x, y) + 0.004
        tilt = 0.35 * half * self.random.normal(size=(count, 1))
        middle = np.column_stack((x, y))
        sides = ((along, tilt), (across, 0.0 * tilt), (-along, -tilt), (-across, 0.0 * tilt))
        quads = np.stack([np.column_stack((middle + flat, z[:, None] + np.abs(rise))) for flat, rise in sides], axis=1)
        shade = self.random.random((count, 1))
        warm = np.where(self.random.random((count, 1)) < 0.25, (1.25, 1.0, 0.7), (1.0, 1.0, 1.0))
        color = (self.colors[0] + shade * (1.5 * self.colors[1] - 0.6 * self.colors[0]) - 0.35 * self.colors[0]) * warm
        color = color * self.brightness(x, y)[:, None]
        return shaded(quads.reshape(-1, 3), np.arange(4 * count).reshape(-1, 4), np.repeat(color, 4, axis=0))

    def grass(self, count=30000, reach=60.0, height=0.3, blades=6):
        """Tufts of grass where there is grass; height: of the tallest [m]."""
        x, y = self._about(count, reach)
        kept = self.random.random(count) < self.grassiness(x, y)
        x, y = np.repeat(x[kept], blades), np.repeat(y[kept], blades)
        tall = np.repeat(height * (0.45 + 0.55 * self.random.random(kept.sum())), blades)
        turn = 2.0 * np.pi * self.random.random(len(x))
        lean = tall * (0.15 + 0.55 * self.random.random(len(x)))
        out = np.column_stack((np.cos(turn), np.sin(turn)))
        foot = np.column_stack((x, y)) + 0.05 * tall[:, None] * out
        wide = 0.016 * tall[:, None] * np.column_stack((-out[:, 1], out[:, 0])) / 0.5
        z = self.height(x, y)[:, None]
        tip = np.column_stack((foot + lean[:, None] * out, z[:, 0] + tall * (0.7 + 0.3 * self.random.random(len(x)))))
        corners = np.stack((np.column_stack((foot - wide, z)), np.column_stack((foot + wide, z)), tip), axis=1)
        dry = self.random.random((len(x), 1))
        top = (self.colors[2] + dry * (self.colors[3] - self.colors[2])) * 1.15 * self.brightness(x, y)[:, None]
        color = np.stack((0.6 * top, 0.6 * top, top), axis=1)
        return shaded(corners.reshape(-1, 3), np.arange(3 * len(x)).reshape(-1, 3), color.reshape(-1, 3))

    def woods(self, distance=420.0, height=24.0, color=(0.16, 0.24, 0.13)):
        """Woods on all sides, as rows of crowns that are paler the farther; height: of their trees [m]. An eye above
        them sees rows up to the end of the ground, none of which shows the ground behind it."""
        points, corners, colors = [], [], []
        radii = [distance * (1.0 + 0.35 * row) for row in range(4)]
        while self.eye[2] > height and radii[-1] < 3900.0:
            radii.append(min(3900.0, radii[-1] * min(1.3, self.eye[2] / (self.eye[2] - 0.8 * height))))
        for row, radius in enumerate(radii):
            count = 2600
            angle = 2.0 * np.pi * np.arange(count) / count
            rough = self.random.normal(size=count)
            crowns = np.convolve(np.concatenate((rough, rough[:8])), np.hanning(9), "valid") / 2.0
            tall = height * (1.0 + 0.05 * min(row, 3) + 0.10 * crowns + 0.03 * self.random.normal(size=count))
            x = self.eye[0] + radius * np.sin(angle)
            y = self.eye[1] + radius * np.cos(angle)
            first = sum(len(p) for p in points)
            points += [np.column_stack((x, y, np.full(count, -1.0))), np.column_stack((x, y, tall))]
            n = np.arange(count)
            right = (n + 1) % count
            corners.append(first + np.column_stack((n, right, right + count, n + count)))
            own = np.array(color) * (0.9 + 0.2 * self.random.random((count, 1)))
            colors += [self.hazy(0.7 * own, x, y), self.hazy(1.15 * own, x, y)]
        return shaded(np.concatenate(points), np.concatenate(corners), np.concatenate(colors))
