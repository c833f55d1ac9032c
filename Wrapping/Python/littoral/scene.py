# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Relief models: a terrain as a block with natural colors, sunlight, cast shadows and haze.

The light is computed here and baked into the point array `RGB` of a `vtkPolyData`, so a picture
needs no lamp, no texture and no ray tracing, and looks the same in VTK and in ParaView.

Lengths are in metres, angles in degrees, colors linear until `_to_bytes` encodes them. x is east,
y north, z up; an azimuth counts from north to the east. Height fields are arrays z[row, column],
rows from south to north, with a spacing (dx, dy).
"""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from .elevation import array_from_image, image_from_array
from .glb import write_glb  # noqa: F401 (scenes as files)

#: Azimuth and elevation of the sun.
SUN = (248.0, 25.0)
#: How far blocks are turned from facing the camera, and how high the camera stands above them.
TURN, LIFT = 32.0, 39.0
SUN_LIGHT = 3.1 * np.array((1.00, 0.83, 0.60))
SKY_LIGHT = 0.85 * np.array((0.50, 0.68, 1.00))
GROUND_LIGHT = 0.16 * np.array((0.95, 0.80, 0.60))
#: The pale sky behind a relief model, sRGB at the lower and the upper edge of the picture.
BACKGROUND = (0.96, 0.955, 0.945), (0.74, 0.80, 0.86)

MEADOW = np.array((0.150, 0.168, 0.060))
PASTURE = np.array((0.238, 0.215, 0.104))
LUSH = np.array((0.098, 0.150, 0.044))
FOREST = np.array((0.050, 0.080, 0.034))
UPLAND = np.array((0.095, 0.105, 0.042))
ROCK = np.array((0.260, 0.225, 0.185))
#: From low to high land.
ATLAS = np.array((
    (0.115, 0.190, 0.140), (0.210, 0.265, 0.150), (0.360, 0.320, 0.170), (0.330, 0.205, 0.105),
    (0.420, 0.360, 0.310)))
LAKE = np.array((0.020, 0.062, 0.120))
SOIL = np.array((0.075, 0.052, 0.034))
BEDS = np.array(
    ((0.300, 0.235, 0.165), (0.200, 0.165, 0.130), (0.245, 0.170, 0.110), (0.260, 0.235, 0.200)))


def direction(azimuth, elevation):
    """Unit vector towards an azimuth and elevation [degrees]."""
    a, e = np.radians((azimuth, elevation))
    return np.array((np.sin(a) * np.cos(e), np.cos(a) * np.cos(e), np.sin(e)))


# Height fields ------------------------------------------------------------------------------------


def subdivide(z):
    """Double the resolution by one step of cubic B-spline subdivision; the border stays fixed."""
    for axis in (0, 1):
        z = np.moveaxis(z, axis, 0)
        fine = np.empty((2 * len(z) - 1,) + z.shape[1:])
        fine[1::2] = 0.5 * (z[:-1] + z[1:])
        fine[2:-1:2] = 0.75 * z[1:-1] + 0.125 * (z[:-2] + z[2:])
        fine[0], fine[-1] = z[0], z[-1]
        z = np.moveaxis(fine, 0, axis)
    return z


def refined(z, spacing, cells=600):
    """Subdivide until the longer side has at least `cells`; returns heights and spacing."""
    while max(z.shape) < cells:
        z, spacing = subdivide(z), (0.5 * spacing[0], 0.5 * spacing[1])
    return z, spacing


def blur(z, radius):
    """Three box filters of 2 radius + 1 cells: nearly a Gaussian."""
    size = 2 * radius + 1
    for axis in (0, 1) * 3:
        z = np.moveaxis(z, axis, 0)
        padded = np.concatenate((z[:1].repeat(radius + 1, 0), z, z[-1:].repeat(radius, 0)))
        sums = padded.cumsum(axis=0, dtype=np.float64)
        z = np.moveaxis((sums[size:] - sums[:-size]) / size, 0, axis)
    return z


def normals(z, spacing):
    """Unit normals [row, column, 3]."""
    slope_y, slope_x = np.gradient(z, spacing[1], spacing[0])
    n = np.stack((-slope_x, -slope_y, np.ones_like(z)), axis=-1)
    return n / np.linalg.norm(n, axis=-1, keepdims=True)


def steepness(z, spacing):
    """Angle between the ground and the horizontal [degrees].

    Of contiguous numbers: the last bit of NumPy's arccos of others depends on where they are in memory.
    """
    slope_y, slope_x = np.gradient(z, spacing[1], spacing[0])
    return np.degrees(np.arccos(1.0 / np.sqrt(slope_x**2 + slope_y**2 + 1.0)))


def sunlight(z, spacing, azimuth, elevation, softness=0.07):
    """Fraction [0..1] of the sun visible from each point; shadows fade over `softness` of slope."""
    rise = np.tan(np.radians(elevation))
    clear = np.ones(z.shape)
    for slope in _march(z, spacing, azimuth, np.ptp(z) / rise, growth=1.04):
        np.minimum(clear, np.subtract(rise, slope, out=slope), out=clear)
    return _step(clear, -0.5 * softness, 0.5 * softness)


def openness(z, spacing, farthest=None, directions=12):
    """Fraction [0..1] of the sky visible from each point, by relief up to `farthest` [m]."""
    farthest = farthest or 40.0 * max(spacing)
    total = np.zeros(z.shape)
    for azimuth in np.arange(directions) * 360.0 / directions:
        horizon = np.zeros(z.shape)
        for slope in _march(z, spacing, azimuth, farthest, growth=1.6):
            np.maximum(horizon, slope, out=horizon)
        total += 1.0 / (1.0 + horizon**2)
    return total / directions


def _march(z, spacing, azimuth, farthest, growth):
    """March from every point along an azimuth: yields the slopes of the lines of sight, in an array that is used again.

    Beyond the border the ground is as high as there.
    """
    towards, last = direction(azimuth, 0.0), np.subtract(z.shape, 1)
    steps, distance = [], min(spacing)
    while distance < farthest:
        steps.append([round(towards[1] * distance / spacing[1]), round(towards[0] * distance / spacing[0])])
        distance = max(distance + min(spacing), distance * growth)
    if not steps:
        return
    shifts = np.clip(steps, -last, last)
    before, after = np.maximum(-shifts.min(axis=0), 0), np.maximum(shifts.max(axis=0), 0)
    around, slope = np.pad(z, np.column_stack((before, after)), mode="edge"), np.empty(z.shape)
    for (rows, columns), (row, column) in zip(steps, before + shifts):
        np.subtract(around[row:row + z.shape[0], column:column + z.shape[1]], z, out=slope)
        slope /= np.hypot(columns * spacing[0], rows * spacing[1])
        yield slope


# Colors ------------------------------------------------------------------------------------------


def natural_color(z, spacing, reflectance=None):
    """Color of temperate terrain: meadows in hollows, woods on slopes, rock where steep.

    `reflectance` [0..1] decides between wood and meadow; default: random.
    """
    return _colored(*_relief(z, spacing, reflectance))


def wood_share(z, spacing, reflectance=None):
    """Fraction [0..1] of the ground covered by trees, as in `natural_color`."""
    return _wooded(*_relief(z, spacing, reflectance))


def _colored(slope, height, hollow, patches, grain, wet):
    """The natural color, by the factors of plant cover."""
    dry = _step(patches + 0.4 * grain - 0.3 * hollow - 0.8 * wet, -0.5, 1.8)
    high = _step(height + 0.4 * patches, 0.2, 2.2)
    steep = slope + 4.0 * np.maximum(height - 1.0, 0.0) + 2.0 * patches + grain
    wood = _mix(FOREST, UPLAND, high) * (1.0 + 0.14 * grain[..., None])
    open_land = _mix(_mix(MEADOW, PASTURE, dry), LUSH, 0.8 * _step(wet, 0.8, 2.4))
    color = _mix(open_land, wood, _wooded(slope, height, hollow, patches, grain, wet))
    return _mix(color, ROCK * (1.0 + 0.08 * grain[..., None]), 0.9 * _step(steep, 24.0, 36.0))


def _wooded(slope, height, hollow, patches, grain, wet):
    """The fraction covered by trees, by the factors of plant cover."""
    wooded = 0.10 * (slope - 7.0) + 0.45 * hollow + 0.35 * height - 0.6 * patches + 0.25 * grain - 0.4 * wet
    return _step(wooded, -0.9, 0.7)


def _relief(z, spacing, reflectance, wetness=None):
    """Factors of plant cover: slope [degrees], height, hollows, patches, grain, and wet ground, 0 unless it is known."""
    slope = steepness(z, spacing)
    slope *= 25.0 / max(25.0, np.percentile(slope, 95.0))  # rock stays rare in steep terrain
    patches = _noise(z.shape, 10, seed=1) if reflectance is None else 4.0 * (reflectance - 0.5)
    wet = np.zeros(z.shape) if wetness is None else _standard(wetness)
    return slope, _standard(z), _standard(z - blur(z, 28)), patches, _noise(z.shape, 0, seed=2), wet


def height_color(z, spacing, reflectance=None):
    """Color by height alone, as in an atlas."""
    share = np.clip(0.5 + 0.22 * _standard(z), 0.0, 1.0)
    steps = np.linspace(0.0, 1.0, len(ATLAS))
    return np.stack([np.interp(share, steps, channel) for channel in ATLAS.T], axis=-1)


def section_color(along, height, depth, thickness):
    """Color of soil and rock beds in a cut.

    All in metres: position along the cut, height above the base, depth below the ground, and
    thickness of the block.
    """
    u = along / thickness
    folds = 0.9 * np.sin(0.23 * u + 0.5) + 0.25 * np.sin(0.9 * u) + 0.05 * np.sin(4.3 * u)
    bed = 9.0 * height / thickness + folds
    random = np.random.default_rng(5)
    tops = random.exponential(1.0, 60).cumsum() - 6.0
    rock = BEDS[random.integers(len(BEDS), size=61)][np.searchsorted(tops, bed)]
    rock = rock * (1.0 + 0.05 * np.sin(5.0 * bed) + 0.04 * np.sin(12.0 * bed))[..., None]
    return _mix(SOIL, rock, _step(depth / thickness, 0.03, 0.08))


def _standard(z):
    return (z - z.mean()) / max(z.std(), 1e-9)


def _noise(shape, radius, seed):
    """Noise of unit standard deviation, blurred by a radius [cells]."""
    return _standard(blur(np.random.default_rng(seed).standard_normal(shape), radius))


def _mix(a, b, share):
    return a + (b - a) * share[..., None]


def _step(value, low, high):
    """0 below low, 1 above high, smooth between them."""
    t = np.clip((value - low) / (high - low), 0.0, 1.0)
    return t * t * (3.0 - 2.0 * t)


def _lit(color, normal, towards_sun, sun, sky):
    """Reflected light of a surface, by the visible fractions of sun and sky."""
    facing = np.maximum(normal @ towards_sun, 0.0) * sun
    above = (0.5 + 0.5 * normal[..., 2]) * sky
    below = 1.0 - 0.6 * sky
    light = [share[..., None] * lamp for share, lamp in
             ((facing, SUN_LIGHT), (above, SKY_LIGHT), (below, GROUND_LIGHT))]
    return color * sum(light)


def _to_bytes(light):
    """Linear light to sRGB; highlights are rolled off as on film."""
    x = 0.92 * light
    x = np.clip(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0)
    srgb = np.where(x < 0.0031308, 12.92 * x, 1.055 * x ** (1.0 / 2.4) - 0.055)
    return np.round(255.0 * srgb).astype(np.uint8)


# Surfaces -----------------------------------------------------------------------------------------


def relief_block(image, exaggeration=1.0, sun=SUN, coloring=natural_color, center=(0.0, 0.0)):
    """The terrain of an image as a block with cut sides that stands on z = 0, lit colors in `RGB`.

    exaggeration: of the heights; sun: azimuth and elevation [degrees]; center: of the block [m].
    An optional array `Reflectance` controls the colors. Missing heights become the lowest.
    """
    ground = array_from_image(image)
    if ground is None:
        raise ValueError("the image has no point array Elevation")
    ground = np.nan_to_num(ground.astype(np.float64), nan=np.nanmin(ground))
    reflectance = array_from_image(image, "Reflectance")
    if reflectance is not None:
        reflectance, _ = refined(reflectance, image.GetSpacing())
    ground, spacing = refined(ground, image.GetSpacing())
    rows, columns = ground.shape
    x = (np.arange(columns) - 0.5 * (columns - 1)) * spacing[0] + center[0]
    y = (np.arange(rows) - 0.5 * (rows - 1)) * spacing[1] + center[1]
    thickness = 0.07 * np.ptp(x)
    z = thickness + (ground - ground.min()) * exaggeration
    seen = sunlight(z, spacing, *sun), openness(z, spacing)
    color = coloring(ground, spacing, reflectance)
    light = _lit(color, normals(z, spacing), direction(*sun), *seen)
    top = np.stack(np.broadcast_arrays(x, y[:, None], z), axis=-1)
    sides = (
        (top[0], (0.0, -1.0, 0.0)), (top[:, -1], (1.0, 0.0, 0.0)),
        (top[-1, ::-1], (0.0, 1.0, 0.0)), (top[::-1, 0], (-1.0, 0.0, 0.0)))
    walls = [_wall(edge, normal, direction(*sun), thickness) for edge, normal in sides]
    return _surface([(top, _to_bytes(light))] + walls)


def lake_block(ground, exaggeration=1.0, center=(0.0, 0.0)):
    """The block of a terrain whose depressions are full of water: output of `vtkDrainageFilter`, not carved."""
    depth = array_from_image(ground, "DepressionDepth")
    level = image_from_array(array_from_image(ground) + depth, ground.GetSpacing())
    deep, _ = refined(depth, ground.GetSpacing())

    def coloring(z, spacing, reflectance):
        water = _step(deep, 0.0, 0.02 * np.std(z))
        return _mix(natural_color(z, spacing, reflectance), LAKE, 0.92 * water)

    return relief_block(level, exaggeration, coloring=coloring, center=center)


def river_lines(rivers, ground, exaggeration=1.0, center=(0.0, 0.0)):
    """Rivers on the block of a terrain: pairs of a `vtkPolyData` with `RGB` and its stream order, low orders first.

    What runs through lakes is left out, but for shallow pools.
    """
    bounds, depth = ground.GetBounds(), array_from_image(ground, "DepressionDepth")
    level = array_from_image(ground) + depth
    middle = 0.5 * np.array((bounds[0] + bounds[1], bounds[2] + bounds[3]))
    width = bounds[1] - bounds[0]
    places = vtk_to_numpy(rivers.GetPoints().GetData()).astype(np.float64)
    columns = np.round((places[:, 0] - bounds[0]) / ground.GetSpacing()[0]).astype(int)
    rows = np.round((places[:, 1] - bounds[2]) / ground.GetSpacing()[1]).astype(int)
    places[:, :2] += np.array(center)[:2] - middle
    places[:, 2] = 0.07 * width + (level[rows, columns] - level.min()) * exaggeration + 0.0025 * width
    dry = depth[rows, columns] <= 0.05 * np.std(level)  # shallow pools are part of a river
    points = vtkPoints()
    points.SetData(numpy_to_vtk(places, deep=True))
    orders = vtk_to_numpy(rivers.GetCellData().GetArray("StreamOrder"))
    for order in np.unique(orders):
        lines, cells = vtkPolyData(), vtkCellArray()
        for cell in np.flatnonzero(orders == order):
            ids = rivers.GetCell(int(cell)).GetPointIds()
            path = [ids.GetId(k) for k in range(ids.GetNumberOfIds())]
            for upper, lower in zip(path, path[1:]):
                if dry[upper] or dry[lower]:
                    cells.InsertNextCell(2, (upper, lower))
        lines.SetPoints(points)
        lines.SetLines(cells)
        lines.GetPointData().SetScalars(rivers.GetPointData().GetArray("RGB"))
        yield lines, int(order)


def floor_shadow(bounds, sun=SUN, cells=400):
    """Shadows of blocks on a floor at z = 0: translucent, four components in `RGB`.

    bounds: of each block [m]; empty blocks are skipped.
    """
    b = np.array([b for b in bounds if b[0] < b[1]])
    if not len(b):
        return vtkPolyData()
    height, margin = 0.8 * b[:, 5].mean(), 4.0 * b[:, 5].max()
    x = np.linspace(b[:, 0].min() - margin, b[:, 1].max() + margin, cells)
    y = np.linspace(b[:, 2].min() - margin, b[:, 3].max() + margin, cells)
    inside = np.zeros((cells, cells), bool)
    for west, east, south, north in b[:, :4]:
        inside |= ((x > west) & (x < east)) & ((y > south) & (y < north))[:, None]
    z, spacing = np.where(inside, height, 0.0), (x[1] - x[0], y[1] - y[0])
    direct = blur(sunlight(z, spacing, *sun, softness=0.2), 2)
    sky = openness(z, spacing, farthest=4.0 * height, directions=16)
    shade = np.where(inside, 0.6, 1.0 - (0.55 + 0.45 * direct) * (0.35 + 0.65 * sky))
    border = np.minimum(np.arange(cells), np.arange(cells)[::-1]) * spacing[0] / margin
    shade *= _step(np.minimum(border, border[:, None]), 0.0, 0.5)
    rgba = np.full(z.shape + (4,), (38, 44, 58, 0), np.uint8)
    rgba[..., 3] = np.round(255.0 * np.clip(blur(shade, 1), 0.0, 1.0))
    points = np.stack(np.broadcast_arrays(x, y[:, None], 0.0), axis=-1)
    return _surface([(points, rgba)])


def add_haze(data, eye, near, far, strength=0.3, color=(0.70, 0.78, 0.86)):
    """Blend `RGB` into haze with the distance [m] from the eye: none at near, `strength` at far."""
    rgb = vtk_to_numpy(data.GetPointData().GetArray("RGB"))
    away = np.linalg.norm(vtk_to_numpy(data.GetPoints().GetData()) - eye, axis=1)
    share = strength * np.clip((away - near) / (far - near), 0.0, 1.0)
    rgb[:] = np.round(_mix(rgb, 255.0 * np.array(color), share))
    return data


def _wall(edge, normal, towards_sun, thickness):
    """A cut from an edge [n, 3] of the terrain down to z = 0."""
    points = np.repeat(edge[None], 120, axis=0)
    points[..., 2] *= np.linspace(1.0, 0.0, 120)[:, None]
    height = points[..., 2]
    along = np.hypot(*(points - edge[0])[..., :2].transpose(2, 0, 1))
    color = section_color(along, height, edge[:, 2] - height, thickness)
    facing = np.broadcast_to(normal, points.shape)
    sky = 0.5 + 0.5 * np.minimum(height / thickness, 1.0)
    return points, _to_bytes(_lit(color, facing, towards_sun, np.ones_like(sky), sky))


def _surface(grids):
    """Polydata of grids, each given by points [row, column, 3] and colors as bytes."""
    quads, first = [], 0
    for points, _ in grids:
        k = first + np.arange(points[..., 0].size).reshape(points.shape[:2])
        quads.append(np.stack((k[:-1, :-1], k[:-1, 1:], k[1:, 1:], k[1:, :-1]), -1).ravel())
        first += k.size
    places = np.concatenate([p.reshape(-1, 3) for p, _ in grids]).astype(np.float32)
    colors = np.concatenate([c.reshape(-1, c.shape[-1]) for _, c in grids])
    points, cells, data = vtkPoints(), vtkCellArray(), vtkPolyData()
    points.SetData(numpy_to_vtk(places, deep=True))
    cells.SetData(4, numpy_to_vtkIdTypeArray(np.concatenate(quads).astype(np.int64), deep=True))
    rgb = numpy_to_vtk(colors, deep=True)
    rgb.SetName("RGB")
    data.SetPoints(points)
    data.SetPolys(cells)
    data.GetPointData().SetScalars(rgb)
    return data


# Blocks in a row ----------------------------------------------------------------------------------


def width_of(image):
    """Longer side of an image [m]."""
    bounds = image.GetBounds()
    return max(bounds[1] - bounds[0], bounds[3] - bounds[2])


def row_centers(width, count):
    """Centers [m] of `count` blocks of a width [m], side by side in the view of `row_camera`."""
    places = 1.44 * width * (np.arange(count) - 0.5 * (count - 1))
    return places[:, None] * direction(90.0 - TURN, 0.0)


def row_camera(width, count, aspect):
    """Camera position [m], focal point [m] and vertical view angle [degrees] for a row of blocks.

    aspect: width over height of the image.
    """
    angle, reach = 7.0, (0.25 + 0.65 * count) * width
    focus = 0.05 * width * direction(90.0 - TURN, 0.0) - (0.0, 0.0, 0.01 * width)
    distance = reach / min(aspect, 0.2 + 1.2 * count) / np.tan(np.radians(0.5 * angle))
    return focus + distance * direction(180.0 - TURN, LIFT), focus, angle


# ParaView -----------------------------------------------------------------------------------------


def prepare_view(view, width, count):
    """Set up a ParaView render view for a row of blocks: camera, pale sky, and no lamps."""
    eye, focus, angle = row_camera(width, count, view.ViewSize[0] / view.ViewSize[1])
    view.CameraPosition, view.CameraFocalPoint = list(eye), list(focus)
    view.CameraViewUp, view.CameraViewAngle = [0.0, 0.0, 1.0], angle
    view.UseColorPaletteForBackground = 0
    view.BackgroundColorMode = "Gradient"
    view.Background, view.Background2 = BACKGROUND
    view.OrientationAxesVisibility = 0
    view.UseLight = 0
    view.UseFXAA = 1


def show_lit(proxy, view):
    """Show a ParaView source in a render view with its array `RGB`, without lighting."""
    from paraview.simple import ColorBy, Show

    shown = Show(proxy, view)
    ColorBy(shown, ("POINTS", "RGB"))
    shown.MapScalars = 0
    shown.Ambient, shown.Diffuse, shown.Specular = 1.0, 0.0, 0.0
    return shown
