// The light of sun and sky on a fragment. Directions and places with a V are in view coordinates, others in the
// world's with z up; light is in klx and luminance in kcd/m2.

uniform mat3 landscapeToWorld;          // from view coordinates, without the translation
uniform vec3 landscapeSun;              // towards the sun
uniform vec3 landscapeSunLight;         // at right angles to it [klx]
uniform sampler2D landscapeDome;        // luminance of the sky (SkyTables)
uniform sampler2D landscapeSkyLight;    // light of the sky on planes (SkyTables)
uniform float landscapeExtinction;      // of the air [1/m]
uniform vec3 landscapeFog;              // its extinction [1/m], its scale height and that of the eye above its level [m]
uniform int landscapeIsParallel;        // 1: the camera is
uniform float landscapeExposure;        // [m2/kcd]
uniform int landscapeFilmCurve;         // 1: luminances go through a film's curve
uniform sampler2DShadow landscapeMaps;  // depths: three maps seen from the sun, and one from the zenith (DepthMaps)
uniform mat4 landscapeToMap[4];         // from view coordinates to the maps' coordinates from 0 to 1
uniform mat3 landscapeZenithAxes;       // from the world's axes to those of the map of the zenith
uniform vec4 landscapeTexel;            // side of a texel of each map [m]; 0: there is no map
uniform float landscapeMapSize;         // texels along a side
uniform float landscapeOcclusion;       // distance of what hides the sky [m]; 0: nothing does
uniform float landscapeEyeHeight;       // above the earth around what is shown [m]
uniform float landscapeBareExtinction;  // of the haze before that earth [1/m]
uniform vec3 landscapeBare;             // luminance of that earth, if it is a ground; below 0: that of the sky's earth
uniform vec3 landscapeCloudEye;         // place of the eye below the drifting clouds, modulo their noise's period [m]
uniform vec2 landscapeClouds;           // part of the sky that they cover, and their height above the eye [m]

const float landscapePi = 3.14159265;

// Luminance of the sky by the angle from the sun's azimuth, and the sine of the elevation.
vec3 landscapeDomeAt(float angle, float rise)
{
  vec2 size = vec2(textureSize(landscapeDome, 0));
  float half_ = 0.5 * size.y;
  float t = (half_ - 1.0) * sqrt(abs(asin(clamp(rise, -1.0, 1.0))) / (0.5 * landscapePi));
  float row = rise >= 0.0 ? half_ + t : half_ - 1.0 - t;
  float column = sqrt(angle / landscapePi) * (size.x - 1.0);
  return texture(landscapeDome, (vec2(column, row) + 0.5) / size).rgb;
}

// Angle of a direction from the sun's azimuth.
float landscapeFromSun(vec3 d)
{
  float angle = abs(atan(d.y, d.x) - atan(landscapeSun.y, landscapeSun.x));
  return angle > landscapePi ? 2.0 * landscapePi - angle : angle;
}

// Luminance of the sky in a direction.
vec3 landscapeSkyAt(vec3 d)
{
  return landscapeDomeAt(landscapeFromSun(d), d.z);
}

// Luminance of the sky at the horizon before which a direction is. A steep one is before all of it, for which stands the
// horizon at right angles to the sun.
vec3 landscapeHorizonAt(vec3 d)
{
  float angle = 0.5 * landscapePi;
  if (d.x != 0.0 || d.y != 0.0) // else it has no azimuth
  {
    angle = mix(angle, landscapeFromSun(d), smoothstep(0.0, 0.5, length(d.xy) / length(d)));
  }
  return landscapeDomeAt(angle, 1e-3);
}

// A normal on the unfolded octahedron.
vec2 landscapeFolded(vec3 normal)
{
  vec3 n = normal / dot(abs(normal), vec3(1.0));
  vec2 s = vec2(n.x >= 0.0 ? 1.0 : -1.0, n.y >= 0.0 ? 1.0 : -1.0);
  return n.z >= 0.0 ? n.xy : (1.0 - abs(n.yx)) * s;
}

// Light of the sky on a plane with a normal.
vec3 landscapeSkyLightOn(vec3 normal)
{
  vec2 at = landscapeFolded(normal);
  float size = float(textureSize(landscapeSkyLight, 0).x);
  return texture(landscapeSkyLight, ((0.5 + 0.5 * at) * (size - 1.0) + 0.5) / size).rgb;
}

// Code of sRGB of a color.
vec3 landscapeCodeOf(vec3 color)
{
  return mix(12.92 * color, 1.055 * pow(max(color, vec3(1e-6)), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, color));
}

// What the eye or the film sees of a luminance, in the display's code.
vec3 landscapeDisplayed(vec3 luminance)
{
  vec3 c = landscapeExposure * luminance;
  if (landscapeFilmCurve == 1)
  {
    // A film's curve: linear in the shadows, shoulder towards white (Hable 2010, with his constants)
    const float A = 0.22, B = 0.30, C = 0.10, D = 0.20, E = 0.01, F = 0.30, W = 11.2;
    vec3 x = 2.0 * c;
    x = (x * (A * x + C * B) + D * E) / (x * (A * x + B) + D * F) - E / F;
    float white = (W * (A * W + C * B) + D * E) / (W * (A * W + B) + D * F) - E / F;
    c = x / white;
  }
  return landscapeCodeOf(clamp(c, 0.0, 1.0));
}

vec3 landscapeLinear(vec3 code)
{
  return mix(code / 12.92, pow((code + 0.055) / 1.055, vec3(2.4)), step(0.04045, code));
}

// Whether the light of a map reaches a place of it, between its texels in parts.
float landscapeReaches(int map, vec3 at)
{
  return texture(landscapeMaps, vec3(0.5 * at.xy + 0.5 * vec2(map & 1, map >> 1), at.z));
}

// How far a place is inside of a map: 1 within, 0 at its rim and outside.
float landscapeWithin(vec3 at)
{
  vec2 rim = abs(2.0 * at.xy - 1.0);
  return at.z > 0.0 && at.z < 1.0 ? clamp((0.98 - max(rim.x, rim.y)) / 0.08, 0.0, 1.0) : 0.0;
}

#ifdef LandscapeSoftShadows
float landscapeReachesSoftly(int map, vec3 at, float towards);
#endif

// The first map that there may be: a processor that draws takes the time of all in a loop.
#ifndef LandscapeFirstMap
#define LandscapeFirstMap 0
#endif

// Part of the sun that is seen from a place; the first map that covers it tells, and fades into the next at its rim.
float landscapeSunSeen(vec3 placeV, vec3 normalV, float towards)
{
#ifdef LandscapeNoShadows
  return 1.0;
#endif
  // The taps reach 2 texels, which on a surface at an angle are as much higher or lower.
  float lift = 0.5 + 2.0 * sqrt(max(0.0, 1.0 - towards * towards));
  float seen = 0.0;
  float left = 1.0;
  for (int map = LandscapeFirstMap; map < 3; ++map)
  {
    if (left <= 0.0)
    {
      break;
    }
    if (landscapeTexel[map] > 0.0)
    {
      vec3 at = (landscapeToMap[map] * vec4(placeV + lift * landscapeTexel[map] * normalV, 1.0)).xyz;
      float share = left * landscapeWithin(at);
#ifdef LandscapeSoftShadows
      seen += share > 0.0 ? share * landscapeReachesSoftly(map, at, towards) : 0.0;
#else
      vec3 a = vec3(0.75 / landscapeMapSize, 0.25 / landscapeMapSize, 0.0);
      seen += 0.25 * share * (landscapeReaches(map, at + a.xyz) + landscapeReaches(map, at + a.yxz * vec3(-1.0, 1.0, 1.0)) +
        landscapeReaches(map, at - a.xyz) + landscapeReaches(map, at + a.yxz * vec3(1.0, -1.0, 1.0)));
#endif
      left -= share;
    }
  }
  return seen + left;
}

// Part of the sky that is hidden near by from what is lit (ContactShade), and the sum of its directions to the east and
// to the north.
vec3 landscapeHidden = vec3(0.0);

// Part that is open near by, of what comes from directions around an azimuth: 1 - H - 2 h . u
float landscapeOpenNear(vec2 azimuth)
{
  return clamp(1.0 - landscapeHidden.x - 2.0 * dot(landscapeHidden.yz, azimuth), 0.0, 1.0);
}

// Part of the sun's light that what is drawn on a surface lets through to it.
float landscapeShaded = 1.0;

// Part of the light of the sky that reaches a place, by what is open to the zenith along 11 rays: one upward, for the
// quarter of the light from within 30 degrees of the zenith, five at 45 degrees for the half from within 60 degrees,
// and five at 15 degrees above the horizon for the rest; each ray is tried at two distances. What is below something
// has a way out only where nothing is above its own height. Light of a ray comes where nothing near by hides it either.
float landscapeSkySeen(vec3 placeV, vec3 normalV)
{
  float near = 1.0 - landscapeHidden.x;
#ifdef LandscapeNoOcclusion
  return near;
#endif
  if (landscapeOcclusion <= 0.0 || landscapeTexel[3] <= 0.0)
  {
    return near;
  }
  vec3 at = (landscapeToMap[3] * vec4(placeV + 2.0 * landscapeTexel[3] * normalV, 1.0)).xyz;
  float share = landscapeWithin(at);
  if (share <= 0.0)
  {
    return near;
  }
  float zenith = landscapeReaches(3, at);
  float seen = 0.25 * near * zenith;
  for (int ray = 0; ray < 5; ++ray)
  {
    float around = (ray + 0.3) * 0.4 * landscapePi;
    vec3 flat_ = vec3(cos(around), sin(around), 0.0);
    vec3 high = landscapeZenithAxes * (landscapeOcclusion * 0.7071 * (flat_ + vec3(0.0, 0.0, zenith)));
    vec3 low = landscapeZenithAxes * (landscapeOcclusion * (0.966 * flat_.yxz + vec3(0.0, 0.0, 0.259 * zenith)));
    seen += 0.05 * landscapeOpenNear(flat_.xy) *
      (landscapeReaches(3, at + 0.4 * high) + landscapeReaches(3, at + high));
    seen += 0.025 * landscapeOpenNear(flat_.yx) * (landscapeReaches(3, at + 0.4 * low) + landscapeReaches(3, at + low));
  }
  return mix(near, seen, share);
}

// Fog from far below its level up to a height above it, as the length of dense fog [m]: it is even below the level, and
// thins out by exp(-z / H) above.
float landscapeFogBelow(float z)
{
  return z < 0.0 ? z : landscapeFog.y * (1.0 - exp(-z / landscapeFog.y));
}

// Part of light that fog lets through along a line from a height above its level, of a length and a rise [m].
float landscapeThroughFog(float z, float way, float rise)
{
#ifdef LandscapeNoFog
  return 1.0;
#endif
  float even = exp(-max(z + 0.5 * rise, 0.0) / landscapeFog.y); // where the line hardly rises
  float mean = abs(rise) < 0.01 * landscapeFog.y ? even : (landscapeFogBelow(z + rise) - landscapeFogBelow(z)) / rise;
  return exp(-landscapeFog.x * mean * way);
}

// Luminance behind all the fog in a direction.
vec3 landscapeBehindFog(vec3 luminance, vec3 d)
{
#ifdef LandscapeNoFog
  return luminance;
#endif
  float above = landscapeFog.y - landscapeFogBelow(landscapeFog.z);
  float through = d.z > 0.0 ? exp(-landscapeFog.x * above / max(d.z, 1e-6)) : landscapeThroughFog(
    landscapeFog.z, landscapeEyeHeight / max(-d.z, 1e-6), -landscapeEyeHeight);
  return mix(landscapeHorizonAt(d), luminance, through);
}

// Luminance of the sky in a direction, or of the earth behind the air before it.
vec3 landscapeBeyond(vec3 d)
{
  if (d.z >= 0.0)
  {
    return landscapeSkyAt(d);
  }
  float through = exp(-landscapeBareExtinction * landscapeEyeHeight / max(-d.z, 1e-6));
  vec3 earth = landscapeBare.x < 0.0 ? landscapeSkyAt(d) : landscapeBare;
  return mix(landscapeHorizonAt(d), earth, through);
}

// Part of the light that clouds hold back at a place of their layer, relative to the eye; soft: as rough water mirrors
// them, without their edges.
float landscapeCloudAt(vec2 place, float soft)
{
  const float scale = 8.0; // so that the noise repeats itself after 32 km
  vec2 at = (landscapeCloudEye.xy + place) / scale;
  float least = mix(0.80, 0.22, landscapeClouds.x);
  float n = 0.0;
  float weight = 0.5;
  // Octaves that come add between 0 and twice their first weight: none is left that could change what is clear or whole.
  for (int octave = 0; octave < (soft > 0.0 ? 3 : 6) && n + 2.0 * weight > least - soft && n < least + 0.14 + soft; ++octave)
  {
    n += weight * landscapeNoise(at, exp2(float(7 - octave)), uint(20 + octave)).x;
    weight *= 0.5;
  }
  return smoothstep(least - soft, least + 0.14 + soft, n);
}

// Part of the sun's light that clouds let through to a place relative to the eye.
float landscapeBelowClouds(vec3 place)
{
#ifdef LandscapeNoClouds
  return 1.0;
#endif
  float up = landscapeClouds.y - place.z;
  return landscapeClouds.x <= 0.0 || up <= 0.0 || landscapeSun.z <= 0.02
    ? 1.0 : 1.0 - 0.85 * landscapeCloudAt(place.xy + landscapeSun.xy / landscapeSun.z * up, 0.0);
}

// Luminance of clouds in a direction, and in w the part of the sky that they hide there.
vec4 landscapeCloudsIn(vec3 d, float soft)
{
#ifdef LandscapeNoClouds
  return vec4(0.0);
#endif
  if (landscapeClouds.x <= 0.0 || d.z < 0.015)
  {
    return vec4(0.0);
  }
  vec2 place = landscapeClouds.y / d.z * d.xy;
  float density = landscapeCloudAt(place, soft);
  // They are thicker, and darker, where there are clouds between them and the sun.
  vec2 sunwards = landscapeSun.xy / max(length(landscapeSun.xy), 0.1);
  float before = landscapeCloudAt(place + 0.25 * landscapeClouds.y * sunwards, soft);
  float forward = 0.6 + 0.8 * pow(max(dot(d, landscapeSun), 0.0), 8.0) * (1.0 - density);
  vec3 light = forward * (1.0 - 0.65 * before * density) * landscapeSunLight + landscapeSkyLightOn(vec3(0.0, 0.0, 1.0));
  vec3 luminance = 0.8 / landscapePi * light;
  float through = exp(-landscapeExtinction * length(vec3(place, landscapeClouds.y)));
  vec3 horizon = landscapeHorizonAt(d);
  return vec4(mix(horizon, luminance, through), density * smoothstep(0.015, 0.09, d.z));
}

// Where the line of sight to a place begins.
vec3 landscapeEyeOf(vec3 placeV)
{
  return landscapeIsParallel == 1 ? vec3(placeV.xy, 0.0) : vec3(0.0);
}

// Luminance of a place behind air and fog: L exp(-k d) + L_h (1 - exp(-k d)), with the sky at the horizon L_h  (Koschmieder)
vec3 landscapeBehindAir(vec3 luminance, vec3 eyeV, vec3 placeV)
{
  vec3 d = landscapeToWorld * (placeV - eyeV);
  float way = length(d);
  float through = exp(-landscapeExtinction * way) *
    landscapeThroughFog(landscapeFog.z + (landscapeToWorld * eyeV).z, way, d.z);
  return mix(landscapeHorizonAt(d), luminance, through);
}

// Light on a surface of an albedo and of a transmittance: of the sky, open in part, of the sun at right angles to it, and
// what faces the sun. Normals of small parts may agree in part: those that do are the one given, the others are of all
// directions, for which |cos| is 1/2.
void landscapeLightOn(vec3 albedo, float open, vec3 placeV, vec3 normalV, float transmittance, float agreed,
  out vec3 light, out vec3 sun, out float facing)
{
  vec3 normal = landscapeToWorld * normalV;
  float towards = dot(normal, landscapeSun);
  // Light of the sky on both sides; what is hidden sends light that was sent before: a / (1 - albedo (1 - a))
  vec2 sides = mix(0.5 * vec2(1.0 + transmittance), vec2(1.0, transmittance), agreed);
  light = sides.x * landscapeSkyLightOn(normal) + sides.y * landscapeSkyLightOn(-normal);
  light *= open / (1.0 - albedo * (1.0 - open));
  facing = max(towards, 0.0) + transmittance * max(-towards, 0.0);
  facing = mix(0.25 * (1.0 + transmittance), facing, agreed);
  sun = vec3(0.0);
  if (facing > 0.0)
  {
    float seen = landscapeSunSeen(placeV, towards > 0.0 ? normalV : -normalV, towards);
    sun = landscapeShaded * seen * landscapeBelowClouds(landscapeToWorld * placeV) * landscapeSunLight;
  }
}

// Luminance of a surface of an albedo and of a transmittance, without the air before it.
vec3 landscapeLuminance(vec3 albedo, vec3 placeV, vec3 normalV, float transmittance, float agreed)
{
  vec3 light;
  vec3 sun;
  float facing;
  landscapeLightOn(
    albedo, landscapeSkySeen(placeV, normalV), placeV, normalV, transmittance, agreed, light, sun, facing);
  light += facing * sun;
  return albedo / landscapePi * light;
}

// Color that the display shows of a surface of an albedo and of a transmittance.
vec3 landscapeLit(vec3 albedo, vec3 eyeV, vec3 placeV, vec3 normalV, float transmittance)
{
  return landscapeDisplayed(
    landscapeBehindAir(landscapeLuminance(albedo, placeV, normalV, transmittance, 1.0), eyeV, placeV));
}
