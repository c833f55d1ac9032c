# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Underwater scenes in ParaView: the surface from below, the bed with its caustics, shafts of light, haze, particles.

Everything works with the rasterizer of any ParaView, without ray tracing. Lengths are in metres, x is east, y north,
z up, the sea level at 0. The shaders compute in linear color space and convert at the end.

Ripples too short for the wave trains of a scene are a sum of a few waves in the shaders. They also refract the sun: where
their curvature focuses it, there are caustics on surfaces and shafts of light along view rays.
"""

import json
import math

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from .landscape import points_with, simple

#: Towards the sun, as seen from under the water: its azimuth from north to the east and zenith angle [degrees].
SUN = (12.0, 24.0)
#: Attenuation of red, green and blue [1/m]: of a ray, and of downward light.
EXTINCTION, DOWNWARD = (0.150, 0.056, 0.046), (0.20, 0.050, 0.040)
#: Light of the water along a long view ray up, level and down.
UPWARD_VIEW, LEVEL_VIEW, DOWNWARD_VIEW = (0.07, 0.50, 0.68), (0.008, 0.135, 0.235), (0.002, 0.040, 0.075)
#: Number of ripples, the longest ones, that focus light; for the others the sun is too large.
FOCUSING = 8
#: Largest number of steps along a view ray at which shafts of light are looked up; fewer up to what is near.
SHAFT_STEPS = 22
#: Exposure of the image.
EXPOSURE = 1.55

PLACES = [
    {"type": "vertex", "original": "//VTK::PositionVC::Dec",
     "replacement": "//VTK::PositionVC::Dec\nout vec3 placeMC;\nout vec3 eyeMC;"},
    {"type": "vertex", "original": "//VTK::PositionVC::Impl",
     "replacement": "//VTK::PositionVC::Impl\n  placeMC = vertexMC.xyz;\n"
                    "  eyeMC = -transpose(mat3(MCVCMatrix)) * MCVCMatrix[3].xyz;"},
    {"type": "fragment", "original": "//VTK::PositionVC::Dec",
     "replacement": "//VTK::PositionVC::Dec\nin vec3 placeMC;\nin vec3 eyeMC;"},
    {"type": "fragment", "original": "//VTK::Color::Dec", "replacement": "//VTK::Color::Dec\n//LITTORAL::WATER"}]

NORMALS = [
    {"type": "vertex", "original": "//VTK::PositionVC::Dec",
     "replacement": "//VTK::PositionVC::Dec\nout vec3 normalAtPlace;"},
    {"type": "vertex", "original": "//VTK::PositionVC::Impl",
     "replacement": "//VTK::PositionVC::Impl\n  normalAtPlace = normalMC;"},
    {"type": "fragment", "original": "//VTK::PositionVC::Dec",
     "replacement": "//VTK::PositionVC::Dec\nin vec3 normalAtPlace;"}]

#: Ripples, caustics, shafts and haze. h: heights of the ripples; Hessian as xx, xy, yy.
WATER = """
const vec4 ripples[RIPPLES] = vec4[RIPPLES](WAVES); // k_x, k_y, amplitude, phase at the time 0
const float rates[RIPPLES] = float[RIPPLES](RATES); // angular frequencies
// k x - omega t + phi. The time comes as the red of the specular color, a uniform that these surfaces have no use for.
float phaseAt(int n, vec2 at) { return dot(ripples[n].xy, at) + (ripples[n].w - rates[n] * specularColorUniform.r); }
float noiseAt(vec2 cell) { return fract(sin(dot(cell, vec2(127.1, 311.7))) * 43758.5453); }
float noise(vec2 at)
{
  vec2 cell = floor(at), part = fract(at);
  part = part * part * (3.0 - 2.0 * part);
  return mix(mix(noiseAt(cell), noiseAt(cell + vec2(1.0, 0.0)), part.x),
             mix(noiseAt(cell + vec2(0.0, 1.0)), noiseAt(cell + vec2(1.0, 1.0)), part.x), part.y);
}
vec2 rippleSlope(vec2 at, float least)
{
  vec2 slope = vec2(0.0);
  for (int n = 0; n < RIPPLES; ++n)
  {
    float seen = smoothstep(0.0, 1.0, 1.5 - least * length(ripples[n].xy));
    slope -= seen * ripples[n].z * ripples[n].xy * sin(phaseAt(n, at));
  }
  return slope;
}
// How much a surface of a Hessian focuses sunlight at a depth below it: one over the area of a ray's tube.
float focused(vec3 bend, float depth, float blur)
{
  float reach = 0.25 * depth;
  float area = (1.0 - reach * bend.x) * (1.0 - reach * bend.z) - reach * reach * bend.y * bend.y;
  return 1.0 / (abs(area) + blur);
}
// The same for rays that arrive at a place.
float caustic(vec2 at, float depth, float blur)
{
  float reach = 0.25 * depth;
  vec2 from = at;
  for (int step = 0; step < 2; ++step)
  {
    vec2 slope = vec2(0.0);
    for (int n = 0; n < FOCUSING; ++n)
      slope -= ripples[n].z * ripples[n].xy * sin(phaseAt(n, from));
    from = at + reach * slope;
  }
  vec3 bend = vec3(0.0);
  for (int n = 0; n < FOCUSING; ++n)
  {
    vec2 k = ripples[n].xy;
    bend -= ripples[n].z * cos(phaseAt(n, from)) * vec3(k.x * k.x, k.x * k.y, k.y * k.y);
  }
  return focused(bend, depth, blur);
}
const vec3 sun = normalize(vec3SUN);
vec3 downLight(float z) { return exp(vec3DOWNWARD * min(z, 0.0)); }
vec2 entry(vec3 place) { return place.xy - sun.xy / sun.z * place.z; }
// Light of the water along a direction of the view, without shafts.
vec3 veil(vec3 towards)
{
  float up = towards.z;
  vec3 light = up > 0.0 ? mix(vec3LEVEL_VIEW, vec3UPWARD_VIEW, pow(up, 1.15))
                        : mix(vec3LEVEL_VIEW, vec3DOWNWARD_VIEW, pow(-up, 0.6));
  float glow = max(0.0, dot(towards, sun));
  return light * (1.0 + 0.8 * pow(glow, 4.0) + 2.2 * pow(glow, 24.0));
}
// Shafts of light along the view ray to a place, summed at even steps from the eye, of which the first is a part long:
// there the ripples' phases grow evenly, and cos(p + d) = 2 cos(d) cos(p) - cos(p - d).
float shafts(vec3 eye, vec3 ray, float part)
{
  float way = length(ray);
  vec3 towards = ray / way;
  int steps = int(clamp(ceil(way / 26.0 * float(SHAFT_STEPS)), 4.0, float(SHAFT_STEPS)));
  float pace = min(way, 26.0) / float(steps);
  vec2 along = pace * (towards.xy - sun.xy / sun.z * towards.z), at = entry(eye) + part * along;
  float here[FOCUSING], before[FOCUSING], twice[FOCUSING];
  for (int n = 0; n < FOCUSING; ++n)
  {
    float phase = phaseAt(n, at), turn = dot(ripples[n].xy, along);
    here[n] = ripples[n].z * cos(phase);
    before[n] = ripples[n].z * cos(phase - turn);
    twice[n] = 2.0 * cos(turn);
  }
  float shaft = 0.0, weight = 0.0;
  float share = 1.0, fading = exp(pace * (0.09 * towards.z - 0.075)); // the same for both sums: from 1
  for (int step = 0; step < steps; ++step)
  {
    vec3 bend = vec3(0.0);
    for (int n = 0; n < FOCUSING; ++n)
    {
      vec2 k = ripples[n].xy;
      bend -= here[n] * vec3(k.x * k.x, k.x * k.y, k.y * k.y);
      float next = twice[n] * here[n] - before[n];
      before[n] = here[n];
      here[n] = next;
    }
    float focus = focused(bend, 5.0, 0.5);
    shaft += share * min(2.5, 1.02 * focus * focus);
    weight += share;
    share *= fading;
  }
  shaft = weight > 0.0 ? shaft / weight : 1.0;
  return mix(1.0, shaft * shaft * 0.72, 0.70 * smoothstep(-0.35, 0.25, towards.z) + 0.12);
}
"""

#: For fragments.
THROUGH = """
// A surface of a radiance, seen through the water between.
vec3 through(vec3 radiance)
{
  vec3 ray = placeMC - eyeMC;
  float way = length(ray);
  vec3 left = exp(-vec3EXTINCTION * way);
  return radiance * left + veil(ray / way) * (1.0 - left) * shaftsHere();
}
vec3 toned(vec3 light) { return pow(1.0 - exp(-EXPOSURE * light), vec3(1.0 / 2.0)); }
"""

#: Shafts of light at each fragment, or between vertices where triangles are smaller than a few pixels.
SHAFTS_OF_FRAGMENT = """
float shaftsHere()
{
  float part = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  return shafts(eyeMC, placeMC - eyeMC, part);
}
"""
SHAFTS_OF_VERTICES = "in float shaftsMC;\nfloat shaftsHere() { return shaftsMC; }\n"
SHAFTS = [
    {"type": "vertex", "original": "//VTK::PositionVC::Dec",
     "replacement": "//VTK::PositionVC::Dec\nuniform vec3 specularColorUniform;\nout float shaftsMC;\n"
                    "//LITTORAL::WATER"},
    {"type": "vertex", "original": "//VTK::PositionVC::Impl",
     "replacement": "//VTK::PositionVC::Impl\n  shaftsMC = shafts(eyeMC, placeMC - eyeMC, 0.5);"}]

#: The surface from below: the sky through Snell's window, mirrored water outside it.
SURFACE = """
  vec3 towards = normalize(placeMC - eyeMC);
  float away = length(placeMC - eyeMC);
  vec3 wave = normalize(normalAtPlace);
  vec2 slope = -wave.xy / wave.z + 1.15 * rippleSlope(placeMC.xy, 0.010 * away);
  vec3 below = normalize(vec3(slope, -1.0));
  float cosine = clamp(dot(-towards, below), 0.02, 1.0);
  vec3 mirrored = reflect(towards, below);
  mirrored.z = -abs(mirrored.z) - 0.02;
  vec3 water = veil(normalize(mirrored)) * 1.15;
  vec3 refracted = refract(towards, below, 1.333);
  vec3 light = water;
  float outside = 1.0 - 1.333 * 1.333 * (1.0 - cosine * cosine);
  if (outside > 0.0)
  {
    float c = sqrt(outside);
    float parallel = (1.333 * c - cosine) / (1.333 * c + cosine);
    float across = (1.333 * cosine - c) / (1.333 * cosine + c);
    float back = 0.5 * (parallel * parallel + across * across);
    vec3 sky = mix(vec3(0.85, 0.97, 1.02), vec3(0.42, 0.72, 1.0), pow(max(refracted.z, 0.0), 0.7));
    vec3 sunward = normalize(vec3(sun.xy * 1.333, sun.z));
    float glare = max(0.0, dot(refracted, sunward));
    sky *= 0.62 + 0.75 * noise(5.0 * refracted.xy + 3.0) * noise(13.0 * refracted.xy);
    sky += vec3(1.0, 0.96, 0.85) * (1.6 * pow(glare, 12.0) + 14.0 * pow(glare, 220.0));
    light = mix(sky * 2.1, water, back);
  }
  gl_FragData[0] = vec4(toned(through(light)), 1.0);
"""

#: Sand and stones under moving light. Vertex colors are their reflectance.
BED = """
  vec3 normal = normalize(normalAtPlace);
  float depth = -placeMC.z;
  float away = length(placeMC - eyeMC);
  float fine = exp(-0.10 * away);
  float grain = 0.55 * noise(9.0 * placeMC.xy) + 0.3 * noise(31.0 * placeMC.xy) + 0.15 * noise(83.0 * placeMC.xy);
  vec3 albedo = ambientColor * mix(1.0, 0.45 + 1.05 * grain, fine);
  float focus = caustic(entry(placeMC), depth, 0.16);
  float glint = caustic(entry(placeMC) + vec2(17.0, 5.0), 0.55 * depth, 0.24);
  float light = mix(1.0, min(focus, 4.5) * 0.60 + min(glint, 3.0) * 0.20, exp(-0.035 * away));
  float facing = max(0.0, dot(normal, sun));
  vec3 falling = downLight(placeMC.z) * (1.35 * facing * light + 0.35 + 0.25 * normal.z);
  gl_FragData[0] = vec4(toned(through(albedo * falling)), 1.0);
"""

#: Stipes and translucent blades. Vertex colors are their reflectance and transmittance.
SEAWEED = """
  vec3 normal = normalize(normalAtPlace);
  vec3 towards = normalize(placeMC - eyeMC);
  if (dot(normal, towards) > 0.0)
    normal = -normal;
  float facing = dot(normal, sun);
  float focus = mix(1.0, min(3.0, caustic(entry(placeMC), max(0.5, -placeMC.z), 0.3)), 0.6);
  vec3 reflected = ambientColor * (1.6 * max(0.0, facing) * focus + 0.42 + 0.22 * normal.z);
  vec3 passed = ambientColor * (0.4 + ambientColor) * 2.0 * max(0.0, -facing) * focus;
  float glow = pow(max(0.0, dot(towards, sun)), 3.0);
  vec3 light = downLight(placeMC.z) * (reflected + passed * (1.0 + 2.0 * glow));
  gl_FragData[0] = vec4(toned(through(light)), 1.0);
"""

#: Background: water.
BEYOND = "  gl_FragData[0] = vec4(toned(through(vec3(0.0))), 1.0);\n"


def ripples(time, count=14, seed=3):
    """Short waves as rows of k_x, k_y [rad/m], amplitude [m] and phase [rad] at a time [s], longest first."""
    random = np.random.default_rng(seed)
    length = 4.6 * 0.82 ** np.arange(count)
    k = 2.0 * np.pi / length
    angle = random.normal(0.5, 0.95, count)
    phase = random.uniform(0.0, 2.0 * np.pi, count) - _rates(k) * time
    return np.column_stack((k * np.cos(angle), k * np.sin(angle), 0.0105 * length ** 1.1, phase))


def _rates(k):
    """Angular frequencies [rad/s] of waves in deep water by their wavenumbers [rad/m]."""
    return np.sqrt(9.80665 * k)


def water_shader(more=SHAFTS_OF_FRAGMENT + THROUGH):
    """The GLSL functions of the water, the same at all times, with more functions that use them."""
    azimuth, zenith = np.radians(SUN)
    towards = (np.sin(zenith) * np.sin(azimuth), np.sin(zenith) * np.cos(azimuth), np.cos(zenith))
    waves = ripples(0.0)
    listed = ", ".join("vec4({:.6f}, {:.6f}, {:.6f}, {:.6f})".format(*wave) for wave in waves)
    rates = ", ".join(f"{rate:.6f}" for rate in _rates(np.hypot(waves[:, 0], waves[:, 1])))
    text = (WATER + more).replace("WAVES", listed).replace("RATES", rates).replace("RIPPLES", str(len(waves)))
    for name, number in (("FOCUSING", FOCUSING), ("SHAFT_STEPS", SHAFT_STEPS), ("EXPOSURE", f"{EXPOSURE:.3f}")):
        text = text.replace(name, str(number))
    for name, value in (("SUN", towards), ("DOWNWARD_VIEW", DOWNWARD_VIEW), ("UPWARD_VIEW", UPWARD_VIEW),
                        ("LEVEL_VIEW", LEVEL_VIEW), ("DOWNWARD", DOWNWARD), ("EXTINCTION", EXTINCTION)):
        text = text.replace("vec3" + name, "vec3({:.5f}, {:.5f}, {:.5f})".format(*value))
    return text


def set_time(shown, time):
    """Move the ripples of a representation to a time [s]. No shader is compiled for it."""
    shown.SpecularColor = [time, 0.0, 0.0]


# Meshes -------------------------------------------------------------------------------------------


def fan(reach=160.0, nearest=0.3, rings=260, spokes=420, angle=130.0, height=0.0):
    """A horizontal fan-shaped mesh from the origin to the north, with cells that grow with distance."""
    radius = np.concatenate(([0.0], np.geomspace(nearest, reach, rings)))
    turn = np.radians(np.linspace(-0.5 * angle, 0.5 * angle, spokes))
    x, y = np.outer(radius, np.sin(turn)), np.outer(radius, np.cos(turn))
    points = np.stack((x, y, np.full_like(x, height)), axis=-1)
    return points


def mesh(points, normals=None, colors=None):
    """Quadrilaterals between rows of points [row, column, 3]."""
    rows, columns = points.shape[:2]
    corner = (np.arange(rows - 1)[:, None] * columns + np.arange(columns - 1)).ravel()
    cells = np.column_stack((corner, corner + 1, corner + columns + 1, corner + columns))
    data, places, polygons = vtkPolyData(), vtkPoints(), vtkCellArray()
    places.SetData(numpy_to_vtk(points.reshape(-1, 3).astype(np.float32), deep=True))
    polygons.SetData(4, numpy_to_vtkIdTypeArray(cells.astype(np.int64).ravel(), deep=True))
    data.SetPoints(places)
    data.SetPolys(polygons)
    if normals is not None:
        array = numpy_to_vtk(normals.reshape(-1, 3).astype(np.float32), deep=True)
        array.SetName("Normals")
        data.GetPointData().SetNormals(array)
    if colors is not None:
        array = numpy_to_vtk(np.round(255.0 * np.clip(colors, 0.0, 1.0)).astype(np.uint8).reshape(-1, 3), deep=True)
        array.SetName("RGB")
        data.GetPointData().AddArray(array)
    return data


def bed(depth, eye, size=120.0, samples=900, seed=5):
    """A sandy bed with stones around a position, with the array RGB; and a function of its height [m].

    Of the samples some rows and columns away from the position are left out, so that a cell's sides are at most about
    1/75 of its distance, or as long as those of the samples.
    """
    heights = 0.45 * _field(size, samples, 30.0, 4.5, seed)
    stones = _field(size, samples, 7.0, 3.6, seed + 1)
    bumps = _field(size, samples, 2.2, 2.8, seed + 2)
    rock = np.clip((stones + 0.12 * bumps - 1.25) / 0.22, 0.0, 1.0)
    rock = rock * rock * (3.0 - 2.0 * rock)
    step = size / (samples - 1)
    along = np.arange(samples) * step - 0.5 * size
    x, y = np.meshgrid(along + eye[0], along + eye[1] + 0.35 * size)
    marks = np.sin(2.0 * np.pi * (0.45 * x + 1.25 * y + 0.9 * heights + 0.15 * bumps))  # ripple marks
    z = -depth + heights + (1.0 - rock) * 0.022 * marks + rock * (0.30 + 0.13 * bumps + 0.75 * (stones - 1.25))
    zy, zx = np.gradient(z, step)
    normals = np.stack((-zx, -zy, np.ones_like(z)), axis=-1)
    normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
    sand = np.array((0.66, 0.60, 0.46)) * (1.0 + 0.07 * bumps[..., None] + 0.05 * marks[..., None])
    stone = np.array((0.22, 0.23, 0.19)) * (1.0 + 0.30 * bumps[..., None])
    crust = np.array((0.40, 0.26, 0.27))  # coralline algae
    stone = stone + (crust - stone) * np.clip(0.7 * stones - 0.75 + 0.4 * bumps, 0.0, 0.8)[..., None]
    color = sand + (stone - sand) * rock[..., None]

    def height(at_x, at_y):
        column = np.clip(np.rint((np.asarray(at_x) - x[0, 0]) / step).astype(int), 0, samples - 1)
        row = np.clip(np.rint((np.asarray(at_y) - y[0, 0]) / step).astype(int), 0, samples - 1)
        return z[row, column]

    seen = np.ix_(_spread(along, -0.35 * size), _spread(along, 0.0))
    return mesh(np.stack((x, y, z), axis=-1)[seen], normals[seen], color[seen]), height


def _spread(along, middle, fineness=75.0):
    """Numbers of even samples, with steps that grow with the distance from a middle."""
    step, chosen = along[1] - along[0], [0]
    while chosen[-1] < len(along) - 1:
        skip = max(1, int(abs(along[chosen[-1]] - middle) / (fineness * step)))
        chosen.append(min(chosen[-1] + skip, len(along) - 1))
    return np.array(chosen)


def _field(size, samples, reach, smoothness, seed):
    """A periodic random field of unit variance; wavelengths below reach [m] have less power."""
    frequency = np.hypot(np.fft.fftfreq(samples)[:, None], np.fft.rfftfreq(samples)[None]) * samples / size
    strength = (1.0 + (frequency * reach) ** 2) ** (-0.5 * smoothness)
    strength[0, 0] = 0.0
    white = np.random.default_rng(seed).standard_normal((samples, samples))
    field = np.fft.irfft2(np.fft.rfft2(white) * strength, s=white.shape)
    return field / field.std()


def kelp_sites(height, count=130, seed=4, top=-0.8):
    """Sites for Plant Scatter before the camera, in groves, with Species (0 sugar kelp, 1 giant kelp) and Scale.

    height: function of the bed's height [m]; top: largest height of giant kelp [m].
    """
    random = np.random.default_rng(seed)
    groves = ((-6.0, 10.5), (7.0, 12.0), (-12.5, 19.0), (14.0, 20.0), (1.5, 25.0))
    near = ((2.2, 4.7), (3.0, 5.4), (1.9, 6.1), (3.9, 5.9), (2.9, 6.8), (4.9, 7.0), (3.8, 7.9), (5.6, 8.3), (-2.6, 5.2),
            (-3.6, 5.9), (-2.4, 6.7), (-4.5, 7.2), (-3.4, 8.0), (-5.4, 8.6), (-1.3, 9.4), (0.9, 10.4))
    places, species = [(x, y, float(height(x, y))) for x, y in near], [0] * len(near)
    for number in range(count):
        giant = number % 4 == 0
        x, y = np.array(groves[number // 4 % len(groves)]) + random.normal(0.0, 1.7 if giant else 2.6, 2)
        if y < 5.0 or abs(x) < 0.12 * y or (giant and y < 8.0):
            continue  # keep the view free
        places.append((x, y, float(height(x, y))))
        species.append(int(giant))
    places = np.array(places)
    largest = (top - places[:, 2]) / 14.6  # height of giant kelp [m]
    scale = np.where(species, largest * random.uniform(0.75, 1.0, len(places)), random.uniform(0.7, 1.15, len(places)))
    return points_with(places, Species=np.array(species, dtype=np.int32), Scale=scale)


def particles(box, count, radius, color, seed=1, clumps=0.0, plants=None, share=0.03):
    """Particles in a box (smallest, then largest x, y, z) with the arrays Radius [m] and RGB.

    radius: median [m]; clumps: 0 uniform to 1 gathered in clouds; plants: sites around which a fraction share gathers.
    """
    random = np.random.default_rng(seed)
    low, high = np.reshape(box, (2, 3))
    places = low + random.random((count, 3)) * (high - low)
    if clumps > 0.0:
        centers = low + (0.12, 0.35, 0.12) * (high - low) + random.random((max(1, count // 30000), 3)) * (
            0.76, 0.55, 0.6) * (high - low)
        near = centers[random.integers(len(centers), size=count)] + random.normal(0.0, 1.7, (count, 3)) * (1.5, 1.5, 0.6)
        inside = ((near > low) & (near < high)).all(axis=1, keepdims=True)
        places = np.where((random.random((count, 1)) < clumps) & inside, near, places)
    if plants is not None:
        feet = vtk_to_numpy(plants.GetPoints().GetData())
        gathered = feet[random.integers(len(feet), size=int(share * count))]
        gathered = gathered + random.normal(0.0, 0.5, gathered.shape) * (1.0, 1.0, 0.0)
        gathered[:, 2] += 2.2 * random.random(len(gathered))
        places[:len(gathered)] = np.clip(gathered, low, high)
    sizes = radius * np.exp(np.clip(0.5 * random.standard_normal(count), -1.5, 1.0))
    shade = np.clip(np.array(color) * random.uniform(0.75, 1.1, (count, 1)), 0.0, 1.0)
    return points_with(places, Radius=sizes.astype(np.float32), RGB=np.round(255.0 * shade).astype(np.uint8))


def split_about(points, sites, reach=1.0, top=-0.5):
    """Particles around plants, within a horizontal reach [m] and up to a height, and the other particles."""
    places, feet = (vtk_to_numpy(data.GetPoints().GetData()).astype(float) for data in (points, sites))
    about = np.zeros(len(places), dtype=bool)
    for foot, giant in zip(feet, vtk_to_numpy(sites.GetPointData().GetArray("Species"))):
        across = np.hypot(places[:, 0] - foot[0], places[:, 1] - foot[1])
        about |= (across < (1.4 if giant else 1.0) * reach) & (places[:, 2] < (top if giant else foot[2] + 2.0 * reach))
    return _selected(points, about), _selected(points, ~about)


def _selected(points, chosen):
    """The points selected by a mask, with their arrays."""
    arrays = points.GetPointData()
    return points_with(vtk_to_numpy(points.GetPoints().GetData())[chosen], **{
        arrays.GetArrayName(k): vtk_to_numpy(arrays.GetArray(k))[chosen] for k in range(arrays.GetNumberOfArrays())})


# Views --------------------------------------------------------------------------------------------


def prepare_view(view):
    """Set up a view without widgets and lights: the shaders compute the light."""
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.BackgroundColorMode = "Single Color"
    view.Background = [0.0, 0.25, 0.33]
    view.UseFXAA = 1
    view.DepthPeeling = 0  # it would draw the fog again for each layer of particles, which hide little of each other


def show_surface(source, view, time):
    """Show the surface of the water, moved by Particle Orbits, from below."""
    shown = simple.Show(source, view)
    shown.SetRepresentationType("Full Surface")  # whose bounds are those of the points, at each time
    shown.ColorArrayName = [None, ""]
    _shade(shown, PLACES + NORMALS, SURFACE, time)
    return shown


def show_bed(source, view, time):
    """Show a bed or other ground with the arrays RGB and Normals."""
    return _show_lit(source, view, BED, time)


def show_seaweeds(source, view, time):
    """Show the level High of seaweeds, from Seaweed or Plant Scatter."""
    parts = simple.ExtractBlock(Input=source, Selectors=["/Root/High/Skin", "/Root/High/Leaves"])
    shown = _show_lit(parts, view, SEAWEED, time, fine=True)
    shown.SetRepresentationType("Full Surface")
    return shown


def show_beyond(view, time, eye, radius=150.0):
    """Show the water behind all objects."""
    sphere = simple.Sphere(Center=list(eye), Radius=radius, ThetaResolution=64, PhiResolution=64)
    shown = simple.Show(sphere, view)
    shown.ColorArrayName = [None, ""]
    _shade(shown, PLACES, BEYOND, time)
    return shown


def show_particles(source, view, eye):
    """Show particles as soft spots with Radius, RGB and Alpha, faded by their distance in water from the camera."""
    shown = simple.Show(source, view, "GeometryRepresentation")
    shown.SetRepresentationType("Particles")
    shown.Extinction, shown.Strength, shown.Eye = 0.11, 0.75, list(eye)
    shown.ColorArrayName = ["POINTS", "RGB"]
    shown.MapScalars = 0
    shown.ShaderPreset = "Gaussian Blur"
    shown.GaussianRadius = 1.0
    shown.ScaleByArray, shown.SetScaleArray, shown.UseScaleFunction = 1, ["POINTS", "Radius"], 0
    shown.OpacityTransferFunction = simple.CreatePiecewiseFunction(Points=[0.0, 0.0, 0.5, 0.0, 1.0, 1.0, 0.5, 0.0])
    shown.Emissive = 0
    shown.Opacity = 0.99  # drawn as translucent, so that it does not hide the fog behind it
    return shown


def show_fog(source, view, color=(0.50, 0.78, 0.76)):
    """Show the image of Particle Fog as a volume of one color."""
    extinctions = (0.0, 0.005, 0.01, 0.02, 0.04, 0.08, 0.15, 0.3, 0.6, 1.2, 2.5, 5.0)
    shown = simple.Show(source, view, "UniformGridRepresentation")
    shown.SetRepresentationType("Fog")
    shown.SampleDistance = 2.0
    shown.ColorArrayName = ["POINTS", "Extinction"]
    shown.LookupTable = simple.CreateLookupTable(
        ColorSpace="RGB", RGBPoints=[0.0, *color, extinctions[-1], *color], AutomaticRescaleRangeMode="Never")
    shown.ScalarOpacityFunction = simple.CreatePiecewiseFunction(
        Points=[number for each in extinctions for number in (each, 1.0 - math.exp(-each), 0.5, 0.0)])
    shown.ScalarOpacityUnitDistance = 1.0
    shown.Shade = 0
    return shown


def _show_lit(source, view, fragment, time, fine=False):
    """Show a data set with the arrays RGB and Normals."""
    shown = simple.Show(source, view)
    shown.ColorArrayName = ["POINTS", "RGB"]
    shown.MapScalars = 0
    _shade(shown, PLACES + NORMALS, fragment, time, fine)
    return shown


def _shade(shown, changes, fragment, time, fine=False):
    """Set shader replacements of a representation; fine: look up shafts of light at its vertices, not fragments."""
    shown.CoordinateShiftScaleMethod = "Disable"  # positions in metres
    shown.Ambient, shown.Diffuse, shown.Specular = 1.0, 0.0, 0.0
    functions = {"vertex": water_shader(""),
                 "fragment": water_shader((SHAFTS_OF_VERTICES if fine else SHAFTS_OF_FRAGMENT) + THROUGH)}
    changes = json.loads(json.dumps(changes + SHAFTS if fine else changes))
    for change in changes:
        change["replacement"] = change["replacement"].replace("//LITTORAL::WATER", functions[change["type"]])
    last = {"type": "fragment", "original": "//VTK::TCoord::Impl", "replacement": fragment}
    shown.UseShaderReplacements = 1
    shown.ShaderReplacements = json.dumps(_merged(changes) + [last])
    set_time(shown, time)


def _merged(changes):
    """Merge replacements with the same original, since VTK replaces each original once."""
    merged = {}
    for change in changes:
        key = change["type"], change["original"]
        if key in merged:
            more = change["replacement"].replace(change["original"], "")
            merged[key]["replacement"] += more
        else:
            merged[key] = change
    return list(merged.values())
