# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Landscapes in ParaView: terrain, woods, sky, sun and haze.

Everything works with the rasterizer of any ParaView, without ray tracing. Lengths are in metres, x is east, y north,
z up; azimuths are measured from north to east.
"""

import errno
import json
import os

import numpy as np
from vtkmodules.util.numpy_support import (
    numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy)
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkIOImage import vtkPNGWriter

from . import brooks, display, files, scene
from .elevation import array_from_image, image_from_array, read_elevation
from .versions import create_texture
from .LittoralFilters import vtkSitePreferenceFilter
from .LittoralSources import vtkQuadratPointSource, vtkTurningBandsTerrainSource
from .stand import table_of_words

try:
    from paraview import simple
except ImportError:  # plain VTK: all but the views works
    simple = None

#: Azimuth and elevation of the sun [degrees].
SUN = (120.0, 34.0)
#: Color of the haze, and its attenuation length [m].
HAZE, SIGHT = (0.70, 0.79, 0.88), 9000.0
#: Fraction of a cell under water from which no tree grows there.
WET_CELL = 0.12
#: Radius of the sky [m]. It is drawn behind everything at any distance: a dome beyond the land
#: would move the near plane of the view away from the camera.
SKY = 4000.0
BEHIND = [
    {"type": "fragment", "original": "//VTK::Depth::Impl",
     "replacement": "gl_FragDepth = 0.999999;"}]

PLACE = [
    {"type": "vertex", "original": "//VTK::PositionVC::Dec",
     "replacement": "//VTK::PositionVC::Dec\nout vec3 placeMC;"},
    {"type": "vertex", "original": "//VTK::PositionVC::Impl",
     "replacement": "//VTK::PositionVC::Impl\n  placeMC = vertexMC.xyz;"},
    {"type": "fragment", "original": "//VTK::PositionVC::Dec",
     "replacement": "//VTK::PositionVC::Dec\nin vec3 placeMC;"}]

AIR = f"""
  gl_FragData[0].rgb = mix(vec3{HAZE}, gl_FragData[0].rgb, exp(-length(vertexVC.xyz) / {SIGHT}));
"""

#: Grass and stones: noise in five octaves from half a metre upwards.
GRAIN = """
  vec2 at = 2.0 * placeMC.xy;
  float grain = 0.0, weight = 0.5;
  for (int octave = 0; octave < 5; ++octave)
  {
    vec2 cell = floor(at), part = fract(at);
    part = part * part * (3.0 - 2.0 * part);
    vec4 corners = vec4(dot(cell, vec2(127.1, 311.7)));
    corners += vec4(0.0, 127.1, 311.7, 438.8);
    corners = fract(sin(corners) * 43758.5453);
    grain += weight *
      mix(mix(corners.x, corners.y, part.x), mix(corners.z, corners.w, part.x), part.y);
    at *= 0.41;
    weight *= 0.8;
  }
  gl_FragData[0].rgb *= mix(vec3(0.50, 0.56, 0.46), vec3(0.96, 0.95, 0.88), 0.6 * grain);
"""


# Country ------------------------------------------------------------------------------------------


class Country:
    """A refined part of an elevation model, with synthetic small relief, lit colors and woods.

    image: the terrain, with the point arrays Elevation [m] and RGB; wood: fraction of the ground
    covered by trees, by row and column; water: where it runs, a `brooks.Water`. Meadows are along it, woods on
    what is drier and steeper, rock where it is too steep for both.
    """

    def __init__(self, corner=(10500.0, 6500.0), size=10000.0, refinements=3, seed=1):
        model = read_elevation()
        spacing = model.GetSpacing()[:2]
        column, row = (int(corner[k] / spacing[k]) for k in (0, 1))
        columns, rows = (int(size / spacing[k]) for k in (0, 1))
        z = array_from_image(model).astype(float)[row:row + rows, column:column + columns]
        for _ in range(refinements):
            z, spacing = scene.subdivide(z), (0.5 * spacing[0], 0.5 * spacing[1])
        relief, reflectance = _small_relief(z.shape, spacing, seed)
        self.z = z + relief * np.clip(scene.steepness(z, spacing) / 12.0, 0.15, 1.5)
        self.spacing = spacing
        self.image = image_from_array(self.z.astype(np.float32), (*spacing, 1.0))
        self.water = brooks.Water(self.image)
        cover = scene._relief(self.z, spacing, reflectance, self.water.wetness)
        self.wood = scene._wooded(*cover) * (self.water.cover < WET_CELL)
        self._paint(scene._colored(*cover))

    @classmethod
    def from_heights(cls, z, spacing, reflectance=None, wood=None):
        """A country from given heights [m], by row and column; wood: as the attribute, default none."""
        country = cls.__new__(cls)
        country.z, country.spacing = z, spacing
        country.wood = np.zeros(z.shape) if wood is None else wood
        country.water = None
        country.image = image_from_array(z.astype(np.float32), (*spacing, 1.0))
        country._paint(scene.natural_color(z, spacing, reflectance))
        return country

    def height(self, x, y):
        """Height of the ground at positions x, y [m]."""
        return _sampled(self.z, self.spacing, x, y)

    def _paint(self, color):
        """Lit colors of the ground as the array RGB."""
        seen = (scene.sunlight(self.z, self.spacing, *SUN), scene.openness(self.z, self.spacing))
        color = color * (1.0 - 0.35 * self.wood[..., None])  # little light passes the canopy
        normals = scene.normals(self.z, self.spacing)
        light = scene._lit(color, normals, scene.direction(*SUN), *seen)
        rgb = numpy_to_vtk(scene._to_bytes(light).reshape(-1, 3), deep=True)
        rgb.SetName("RGB")
        self.image.GetPointData().AddArray(rgb)


def _small_relief(shape, spacing, seed):
    """Heights and reflectance that the elevation model does not resolve."""
    source = vtkTurningBandsTerrainSource()
    source.SetModelToFractal()
    source.SetFractalDimension(2.25)
    source.SetRange(400.0)
    source.SetStandardDeviation(3.0)
    source.SetMean(0.0)
    source.SetWholeExtent(0, shape[1] - 1, 0, shape[0] - 1, 0, 0)
    source.SetSpacing(*spacing, 1.0)
    source.SetSeed(seed)
    source.ReflectanceOn()
    source.Update()
    image = source.GetOutput()
    return array_from_image(image), array_from_image(image, "Reflectance")


def _sampled(values, spacing, x, y):
    """Bilinear samples of a grid that starts at (0, 0)."""
    u, v = np.asarray(x) / spacing[0], np.asarray(y) / spacing[1]
    i = np.clip(u.astype(int), 0, values.shape[1] - 2)
    j = np.clip(v.astype(int), 0, values.shape[0] - 2)
    u, v = u - i, v - j
    low = values[j, i] * (1.0 - u) + values[j, i + 1] * u
    high = values[j + 1, i] * (1.0 - u) + values[j + 1, i + 1] * u
    return low * (1.0 - v) + high * v


# Woods --------------------------------------------------------------------------------------------


#: Preferences of the species of woods, as vtkSitePreferenceFilter reads them: pines on ridges and warm slopes, oaks on
#: low ground, birches where it is moist, shrubs on what is steep.
PREFERENCES = {
    "species": ("pine", "oak", "birch", "shrub"), "abundance": (1.0, 1.4, 0.8, 0.3),
    "relative_elevation": (0.75, 0.3, "", ""), "relative_elevation_tolerance": (0.3, 0.3, "", ""),
    "slope": (18.0, 8.0, 0.0, 30.0), "slope_tolerance": (12.0, 12.0, 16.0, 8.0),
    "aspect": (200.0, "", "", ""), "aspect_tolerance": (90.0, "", "", ""),
    "wetness": ("", "", 8.5, ""), "wetness_tolerance": ("", "", 2.5, "")}


def preferred_species(water, x, y, seed=1):
    """Indices of the species of PREFERENCES that grow at positions x, y [m], by the heights and the drainage of the ground."""
    sites = vtkSitePreferenceFilter()
    sites.SetInputData(points_with(np.column_stack((x, y, np.zeros(len(x))))))
    sites.SetInputData(1, water.image)
    sites.SetInputData(2, table_of_words(PREFERENCES, PREFERENCES.values()))
    sites.SetSeed(seed)
    sites.Update()
    arrays = sites.GetOutput().GetPointData()
    species = np.ones(len(x), int)  # oaks where nothing feels at home
    species[vtk_to_numpy(arrays.GetArray("SiteId"))] = vtk_to_numpy(arrays.GetArray("Species"))
    return species


def wood_sites(country, origin, size, mean_distance=13.0, seed=1, alone=None):
    """Sites of trees on a rectangle, with the point array Species: 0 pine, 1 oak, 2 birch, 3 shrub.

    Candidates are clustered by the Neyman type A law; they are kept in woods, a few also on meadows. Which species
    they are is decided by the ground (PREFERENCES); half of those on meadows are shrubs.

    alone: further trees, positions [n, 2] and species [n]; no other tree stands within 25 m.
    """
    source = vtkQuadratPointSource()
    source.SetOrigin(*origin)
    source.SetSize(*size)
    source.SetQuadrats(*(max(1, int(s / mean_distance)) for s in size))
    source.SetLaw(source.PoissonPoisson)
    source.SetClusterMean(1.5)
    source.SetMode(source.Sampling)
    source.SetSeed(seed)
    source.Update()
    points = vtk_to_numpy(source.GetOutput().GetPoints().GetData())
    x, y = points[:, 0].astype(float), points[:, 1].astype(float)
    chance = np.random.default_rng(seed).random((2, len(x)))
    wood = _sampled(country.wood, country.spacing, x, y)
    z = country.height(x, y)
    stays = chance[0] < np.clip(1.25 * wood - 0.2, 0.03, 1.0)
    species = preferred_species(country.water, x, y, seed)
    species[(wood < 0.35) & (chance[1] < 0.5)] = 3
    if alone is not None:
        places, kinds = alone
        apart = np.hypot(x[:, None] - places[:, 0], y[:, None] - places[:, 1]).min(axis=1)
        stays &= apart > 25.0
        x, y = (np.concatenate((v[stays], places[:, k])) for k, v in enumerate((x, y)))
        z, species = country.height(x, y), np.concatenate((species[stays], kinds))
        stays = np.ones(len(x), bool)
    return points_with(np.column_stack((x, y, z))[stays], Species=species[stays].astype(np.int32))


def shadows(country, places, radius, height, sun=SUN):
    """Soft shadows of crowns on the ground: translucent disks with four components in `RGB`.

    places: feet of the plants [n, 3]; radius: of the crowns, height: of their centers [m].
    """
    towards = scene.direction(*sun)
    steep = towards[2] / np.hypot(*towards[:2])
    angles = np.arange(12) * 2.0 * np.pi / 12.0
    ring = np.concatenate(([[0.0, 0.0]], *(
        share * np.column_stack((np.cos(angles), np.sin(angles))) for share in (0.75, 1.15))))
    along = -towards[:2] / np.hypot(*towards[:2])
    across = np.array((-along[1], along[0]))
    offset = ring[:, :1] * along * (0.5 + 0.5 / steep) + ring[:, 1:] * across
    center = places[:, None, :2] + (along / steep) * height[:, None, None]
    ground = center + radius[:, None, None] * offset
    z = country.height(ground[..., 0], ground[..., 1]) + 0.12
    points = np.concatenate((ground, z[..., None]), axis=-1).reshape(-1, 3)
    k, after = np.arange(12), (np.arange(12) + 1) % 12
    one = np.concatenate((
        np.column_stack((np.zeros(12, int), 1 + k, 1 + after)),
        np.column_stack((1 + k, 13 + k, 13 + after)),
        np.column_stack((1 + k, 13 + after, 1 + after))))
    triangles = one[None] + len(ring) * np.arange(len(places))[:, None, None]
    rgba = np.zeros((len(ring), 4), np.uint8)
    rgba[:, :3] = (30, 38, 34)
    rgba[:, 3] = np.repeat((135, 120, 0), (1, 12, 12))
    return polygons_with(points, triangles.reshape(-1, 3), np.tile(rgba, (len(places), 1)))


def brook_bands(country, near, reach):
    """Brooks within a distance [m] of a place as translucent bands on the ground, as `shadows`."""
    return polygons_with(*brooks.bands(country.water.courses, country.height, np.asarray(near)[:2], reach))


def polygons_with(points, triangles, colors):
    """Triangles between points [n, 3], with the point array `RGB`."""
    data, places, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    places.SetData(numpy_to_vtk(points.astype(np.float32), deep=True))
    cells.SetData(3, numpy_to_vtkIdTypeArray(triangles.astype(np.int64).ravel(), deep=True))
    data.SetPoints(places)
    data.SetPolys(cells)
    rgb = numpy_to_vtk(colors, deep=True)
    rgb.SetName("RGB")
    data.GetPointData().SetScalars(rgb)
    return data


def points_with(places, **arrays):
    """Vertices at positions [n, 3], with point arrays."""
    data, points, vertices = vtkPolyData(), vtkPoints(), vtkCellArray()
    points.SetData(numpy_to_vtk(places.astype(np.float32), deep=True))
    ids = np.arange(len(places), dtype=np.int64)
    vertices.SetData(1, numpy_to_vtkIdTypeArray(ids, deep=True))
    data.SetPoints(points)
    data.SetVerts(vertices)
    for name, values in arrays.items():
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        data.GetPointData().AddArray(array)
    return data


# Sky ----------------------------------------------------------------------------------------------


def write_sky(filename, columns=6144, rows=1024, seed=4):
    """A sky with fair-weather clouds as a PNG: azimuth along rows, elevation upwards."""
    clouds = np.pad(_cloud_field(2048, seed), (0, 1), mode="wrap")
    elevation = np.linspace(0.0, 0.5 * np.pi, rows)[:, None]
    azimuth = np.linspace(0.0, 2.0 * np.pi, columns)[None]
    # A few rows at a time: in double precision all of them would take 0.8 GB.
    parts = [_sky_colors(clouds, some, azimuth) for some in np.array_split(elevation, max(1, rows // 32))]
    _write_png(filename, np.concatenate(parts))


def _sky_colors(clouds, elevation, azimuth):
    """Bytes of the sky in some directions."""
    cells = len(clouds) - 1
    reach = 200.0 * np.cos(elevation) / (np.sin(elevation) + 0.06)  # on the layer of clouds
    density = _sampled(
        clouds, (1.0, 1.0), (reach * np.sin(azimuth)) % cells, (reach * np.cos(azimuth)) % cells)
    cover = scene._step(density, 0.45, 2.1) * np.clip((elevation - 0.03) / 0.25, 0.0, 0.92)
    low = np.exp(-3.4 * np.sin(elevation)) * np.ones_like(azimuth)
    blue = scene._mix(np.array((0.26, 0.46, 0.76)), np.array((0.76, 0.85, 0.92)), low)
    shade = 1.0 - 0.22 * np.clip((density - 1.2) / 1.6, 0.0, 1.0)
    color = scene._mix(blue, np.array((1.0, 0.99, 0.97)) * shade[..., None], cover)
    return np.round(255.0 * np.clip(color, 0.0, 1.0)).astype(np.uint8)


def _cloud_field(cells, seed):
    """Periodic noise of unit variance, with clouds of about 150 cells."""
    frequency = np.hypot(np.fft.fftfreq(cells)[:, None], np.fft.rfftfreq(cells)[None])
    frequency[0, 0] = np.inf
    strength = frequency ** -1.6 / np.sqrt(1.0 + (0.006 / frequency) ** 4)
    white = np.random.default_rng(seed).standard_normal((cells, cells))
    field = np.fft.irfft2(np.fft.rfft2(white) * strength, s=white.shape)
    return field / field.std()


def sky_dome(center):
    """The inside of a sphere around a center, with texture coordinates for `write_sky`."""
    elevation = np.linspace(-0.05, 0.5 * np.pi, 40)[:, None]
    azimuth = np.linspace(0.0, 2.0 * np.pi, 121)[None]
    away = np.stack(np.broadcast_arrays(
        np.cos(elevation) * np.sin(azimuth), np.cos(elevation) * np.cos(azimuth),
        np.sin(elevation)), axis=-1)
    dome = scene._surface([(SKY * away + np.asarray(center), np.zeros(away.shape, np.uint8))])
    upwards = 0.998 * np.clip(elevation / (0.5 * np.pi), 0.001, 1.0)
    places = np.stack(np.broadcast_arrays(azimuth / (2.0 * np.pi), upwards), axis=-1)
    array = numpy_to_vtk(places.reshape(-1, 2).astype(np.float32), deep=True)
    array.SetName("TCoords")
    dome.GetPointData().SetTCoords(array)
    return dome


def _write_png(filename, pixels):
    """Bytes [row, column, channel], the lowest row first, as a PNG."""
    image = vtkImageData()
    image.SetDimensions(pixels.shape[1], pixels.shape[0], 1)
    image.GetPointData().SetScalars(
        numpy_to_vtk(pixels.reshape(-1, pixels.shape[2]), deep=True))
    writer = vtkPNGWriter()
    writer.SetInputData(image)
    files.write(writer, filename)


# Views --------------------------------------------------------------------------------------------


def save_view(filename, view):
    """Write the picture of a view as a PNG. Raises OSError, with an old file as it was, or RuntimeError without a display."""
    display.require(view.GetRenderWindow())
    simple.Render(view)
    writer = vtkPNGWriter()
    writer.SetInputData(view.SMProxy.CaptureWindow(1))
    files.write(writer, filename)


def save_volume(filename, source):
    """Write the images of a source as an OpenVDB volume, by a server on this machine.

    Raises OSError, with an old file as it was.
    """
    def state():
        return os.path.exists(filename) and (os.stat(filename).st_ino, os.stat(filename).st_mtime_ns)

    before = state()
    simple.SaveData(filename, source)
    if state() == before:
        raise OSError(errno.EIO, "The volume cannot be written", filename)


def prepare_view(view):
    """Set up sun, sky light and light from the ground; no widgets; antialiasing."""
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.BackgroundColorMode = "Single Color"
    view.Background = HAZE
    view.UseFXAA = 1
    view.UseLight = 0
    view.AdditionalLights = []
    for towards, color, intensity in (
            (scene.direction(*SUN), (1.0, 0.93, 0.80), 1.15),
            ((0.0, 0.0, 1.0), (0.62, 0.76, 1.0), 0.5),
            (scene.direction(SUN[0] - 110.0, 10.0), (0.85, 0.88, 0.85), 0.4)):
        light = simple.AddLight(view=view)
        light.Coords = "Scene"
        light.Type = "Directional"
        light.Position = [1e5 * c for c in towards]
        light.FocalPoint = [0.0, 0.0, 0.0]
        light.DiffuseColor = list(color)
        light.Intensity = intensity


def look(view, eye, focus, angle):
    """Point the camera of a view; the angle is vertical [degrees]."""
    view.CameraPosition = list(eye)
    view.CameraFocalPoint = list(focus)
    view.CameraViewUp = [0.0, 0.0, 1.0]
    view.CameraViewAngle = angle


def show_ground(source, view):
    """Show a terrain with lit colors, grain and haze."""
    shown = _show_colored(source, view)
    _bake(shown)
    _shade(shown, PLACE, GRAIN + AIR)
    return shown


#: Visible blocks of scattered plants: the skeletons are lines, which have no normals for the shader.
PLANT_PARTS = ("/Root/High/Skin", "/Root/High/Leaves", "/Root/Medium/Trunk", "/Root/Medium/Crown", "/Root/Low")


def show_plants(source, view, parts=PLANT_PARTS):
    """Show parts of scattered or swaying plants, with the textures that they carry."""
    parts = simple.ExtractBlock(Input=source, Selectors=list(parts))
    shown = _show_colored(parts, view)
    shown.SetRepresentationType("Full Surface")
    shown.Ambient = 0.35
    shown.Specular = 0.0
    _shade(shown, [], AIR)
    return shown


def show_on_ground(source, view):
    """Show shadows or brooks on the ground."""
    shown = _show_colored(source, view)
    _bake(shown)
    return shown


def show_sky(source, view, picture):
    """Show a dome with its texture, a PNG file."""
    shown = simple.Show(source, view)
    simple.ColorBy(shown, None)
    shown.Texture = create_texture(picture)
    shown.SelectTCoordArray = "TCoords"
    shown.RepeatTextures = 0
    shown.AmbientColor = shown.DiffuseColor = [1.0, 1.0, 1.0]
    _bake(shown)
    shown.UseShaderReplacements = 1
    shown.ShaderReplacements = json.dumps(BEHIND)
    return shown


def _show_colored(source, view):
    shown = simple.Show(source, view)
    shown.ColorArrayName = ["POINTS", "RGB"]
    shown.MapScalars = 0
    return shown


def _bake(shown):
    """Show colors without lighting."""
    shown.Ambient, shown.Diffuse, shown.Specular = 1.0, 0.0, 0.0


def _shade(shown, changes, fragment):
    """Set shader replacements of a representation."""
    shown.CoordinateShiftScaleMethod = "Disable"  # positions in metres
    last = {"type": "fragment", "original": "//VTK::TCoord::Impl", "replacement": "//VTK::TCoord::Impl\n" + fragment}
    shown.UseShaderReplacements = 1
    shown.ShaderReplacements = json.dumps(changes + [last])
