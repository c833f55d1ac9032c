# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Sea water in shaders: ripples, caustics, shafts of light, haze.

The shaders compute in linear color space and convert at the end. Lengths are in metres, x is east, y north, z up, the sea
level at 0.

Ripples too short for the wave trains of a scene are a sum of a few waves in the shaders. They also refract the sun: where
their curvature focuses it, there are caustics on surfaces and shafts of light along view rays.
"""

import numpy as np

from ..seawater import DOWNWARD, EXTINCTION

#: Towards the sun, as seen from under the water: its azimuth from north to the east and zenith angle [degrees].
SUN = (12.0, 24.0)
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

#: Shader of fragments.
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


def with_functions(changes, fine=False):
    """Changes of shaders with the functions of the water in them; fine: shafts of light are looked up at vertices."""
    functions = {"vertex": water_shader(""),
                 "fragment": water_shader((SHAFTS_OF_VERTICES if fine else SHAFTS_OF_FRAGMENT) + THROUGH)}
    merged = {}
    for change in changes + SHAFTS if fine else changes:
        key, original = (change["type"], change["original"]), change["original"]
        text = change["replacement"].replace("//LITTORAL::WATER", functions[change["type"]])
        if key in merged:  # VTK replaces each original once
            merged[key]["replacement"] += text.replace(original, "")
        else:
            merged[key] = dict(change, replacement=text)
    return list(merged.values())
