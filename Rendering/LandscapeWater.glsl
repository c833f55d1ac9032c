// Water below a surface: what it reflects, what shows through it, and what is in it. Depths are below its mean level, or below it where it is looked through.

uniform int landscapeWater;              // 0: there is none; 1: the eye is above it; 2: below
uniform float landscapeEyeDepth;         // of the eye below the water's level [m]
uniform float landscapeIndex;            // of refraction
uniform vec3 landscapeAbsorption;        // a [1/m]
uniform vec3 landscapeScattering;        // b [1/m]
uniform float landscapeSlopeVariance;    // of what the surface's mesh does not have, in both directions together
uniform int landscapeHasRipples;         // 1: waves with these slopes are there
uniform float landscapeRippleSide;       // of the square in which they repeat themselves [m]
uniform vec4 landscapeRippleEye;         // place of the eye in its two layers, in squares
uniform vec2 landscapeRippleTurn;        // cosine and sine of the turn of the second layer
uniform sampler2D landscapeRippleSlopes; // for the variance 1; in the third channel s2
uniform sampler2D landscapeRippleLight;  // below them, over its mean, at four depths

uniform float landscapeFoamBegins;        // stretch of the surface below which it has foam

float landscapeBelow = 0.0; // depth of the eye below the surface: of its level, or where it is looked through from above [m]

const float landscapeBackward = 0.02;    // part of scattered light that goes backwards
const float landscapeForward = 0.9;      // mean cosine of scattering (Henyey and Greenstein)

// Part of unpolarized light that a surface reflects, by the cosine of incidence and the index of what is behind it over
// that before it  (Fresnel)
float landscapeFresnel(float cosine, float index)
{
  float c = clamp(cosine, 0.0, 1.0);
  float beyond = 1.0 - (1.0 - c * c) / (index * index);
  if (beyond <= 0.0)
  {
    return 1.0;
  }
  float t = sqrt(beyond);
  float across = (c - index * t) / (c + index * t);
  float along = (index * c - t) / (index * c + t);
  return 0.5 * (across * across + along * along);
}

// Diffuse attenuation of downward light, K = a + b_b [1/m]
vec3 landscapeDownward()
{
  return landscapeAbsorption + landscapeBackward * landscapeScattering;
}

// Direction towards the sun in the water.
vec3 landscapeSunInWater()
{
  vec3 s = landscapeSun / landscapeIndex;
  s.z = sqrt(max(0.0, 1.0 - dot(s.xy, s.xy)));
  return s;
}

// Light at right angles to the sun's rays just below the surface: E T(z) z / z_w
vec3 landscapeSunBelow()
{
  float z = max(landscapeSun.z, 0.0);
  return landscapeSunLight * (1.0 - landscapeFresnel(z, landscapeIndex)) * z / landscapeSunInWater().z;
}

// Light of the sky on a level plane just below the surface, which reflects 6.6 % of diffuse light.
vec3 landscapeSkyBelow()
{
  return 0.934 * landscapeSkyLightOn(vec3(0.0, 0.0, 1.0));
}

// Slopes of the waves at a place relative to the eye, as far as a footprint [m] shows them; in z the variance of the rest.
vec3 landscapeRipples(vec2 place, float footprint)
{
  if (landscapeHasRipples == 0)
  {
    return vec3(0.0, 0.0, landscapeSlopeVariance);
  }
  float texels = float(textureSize(landscapeRippleSlopes, 0).x);
  float level = log2(max(footprint * texels / landscapeRippleSide, 1.0));
  vec2 t = landscapeRippleTurn;
  vec2 turned = vec2(t.x * place.x + t.y * place.y, t.x * place.y - t.y * place.x);
  vec3 a = textureLod(landscapeRippleSlopes, landscapeRippleEye.xy + place / landscapeRippleSide, level).xyz;
  vec3 b = textureLod(landscapeRippleSlopes, landscapeRippleEye.zw + turned / landscapeRippleSide, level).xyz;
  vec2 slope = a.xy + vec2(t.x * b.x - t.y * b.y, t.y * b.x + t.x * b.y);
  // Of each layer, half of the variance: what is not in the mean of a footprint is E s2 - (E s)2
  float rest = a.z - dot(a.xy, a.xy) + b.z - dot(b.xy, b.xy);
  return vec3(sqrt(0.5 * landscapeSlopeVariance) * slope, 0.5 * landscapeSlopeVariance * max(rest, 0.0));
}

// Shares of the light's four channels, at 0.75 m 3^k, at a depth: none at the surface; below the last channel light is
// even as far as it is scattered.
vec4 landscapeChannels(float depth)
{
  float k = clamp(log(max(depth, 0.75) / 0.75) / log(3.0), 0.0, 3.0);
  float below = max(depth - 20.25, 0.0) / landscapeSunInWater().z;
  return min(depth / 0.75, 1.0) * exp(-landscapeScattering.y * below) * max(vec4(0.0), 1.0 - abs(vec4(k, k - 1.0, k - 2.0, k - 3.0)));
}

// The channels where the sun's rays come through the surface, relative to the eye, on the mean of a footprint [m].
vec4 landscapeLightBelow(vec2 above, float footprint)
{
  float texels = float(textureSize(landscapeRippleLight, 0).x);
  float level = log2(max(footprint * texels / landscapeRippleSide, 1.0));
  return textureLod(landscapeRippleLight, landscapeRippleEye.xy + above / landscapeRippleSide, level);
}

// Light of the sun at a place relative to the eye and a depth, on the mean of a footprint [m], over that below level water.
float landscapeGathered(vec2 place, float depth, float footprint)
{
  if (landscapeHasRipples == 0)
  {
    return 1.0;
  }
  vec3 s = landscapeSunInWater();
  // In water the sun is 0.4 degrees wide.
  vec4 light = landscapeLightBelow(place + s.xy / s.z * depth, max(0.007 * depth, footprint));
  return 1.0 + dot(landscapeChannels(depth), light - 1.0);
}

// Part of light from the sun's direction that water scatters into a line of sight along d, a steradian.
float landscapePhase(vec3 d)
{
  float g = landscapeForward;
  return (1.0 - g * g) / (4.0 * landscapePi * pow(1.0 + g * g - 2.0 * g * dot(d, landscapeSunInWater()), 1.5));
}

// Light that water of a depth at its begin scatters into a line of sight of a length along a direction:
// b p(d) E exp(-K z) (1 - exp(-k l)) / k, with k = c - K d_z, as the light changes along the line
vec3 landscapeScattered(vec3 d, float depth, float way)
{
  vec3 k = max(landscapeAbsorption + landscapeScattering - landscapeDownward() * d.z, vec3(1e-4));
  float sky = (0.5 + (0.5 - landscapeBackward) * d.z) / (2.0 * landscapePi);
  vec3 light = landscapePhase(d) * landscapeSunBelow() + sky * landscapeSkyBelow();
  return landscapeScattering * light * exp(-landscapeDownward() * max(depth, 0.0)) * (1.0 - exp(-k * way)) / k;
}

// Luminance at the end of a line of sight through water.
vec3 landscapeInWater(vec3 luminance, vec3 d, float depth, float way)
{
  return luminance * exp(-(landscapeAbsorption + landscapeScattering) * way) + landscapeScattered(d, depth, way);
}

// Where in a step of a line of sight it is sampled, from 0 to 1: another quarter for each of 2 x 2 pixels.
float landscapeQuarter()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy) & 1;
  return 0.125 + 0.5 * float(pixel.x ^ pixel.y) + 0.25 * float(pixel.y);
}

// Whether the sun is seen from a place in the water, by the first map that has it.
float landscapeSunThrough(vec3 placeV)
{
#ifndef LandscapeNoShadows
  for (int map = LandscapeFirstMap; map < 3; ++map)
  {
    vec3 at = (landscapeToMap[map] * vec4(placeV, 1.0)).xyz;
    if (landscapeTexel[map] > 0.0 && landscapeWithin(at) >= 1.0)
    {
      return landscapeReaches(map, at);
    }
  }
#endif
  return 1.0;
}

// What gathered light and shadows change in the light that water scatters into a line of sight from the eye: shafts, the
// sum of b p (V I - 1) E exp(-K z - c l) over parts of the line that send the same light, but for the last 2 % of it. The
// line crosses the sun's rays, along which light is about the same, by q = d_xy - d_z s_xy / s_z a metre: patterns are as
// sharp as its taps are dense.
vec3 landscapeShafts(vec3 d, float way)
{
  const int steps = 10;
  const int taps = 3;
  vec3 c = landscapeAbsorption + landscapeScattering;
  vec3 s = landscapeSunInWater();
  vec2 q = d.xy - d.z / s.z * s.xy;
  vec2 first = landscapeBelow / s.z * s.xy; // of the rays to the eye
  float all_ = min(1.0 - exp(-c.y * way), 0.98);
  float within = landscapeQuarter();
  float begin = 0.0;
  vec3 sum = vec3(0.0);
  for (int step_ = 0; step_ < steps; ++step_)
  {
    float end = -log(1.0 - all_ * float(step_ + 1) / float(steps)) / c.y;
    float part = (end - begin) / float(taps);
    float footprint = 0.2 * length(q) * part;
    vec4 light = vec4(0.0);
    for (int tap = 0; tap < taps; ++tap)
    {
      light += landscapeLightBelow(first + (begin + part * (float(tap) + within)) * q, footprint) / float(taps);
    }
    float l = mix(begin, end, within);
    float depth = max(landscapeBelow - d.z * l, 0.0);
    float sunny = landscapeSunThrough(l * d * landscapeToWorld) * (1.0 + dot(landscapeChannels(depth), light - 1.0));
    sum += (sunny - 1.0) * exp(-landscapeDownward() * depth - (c - c.y) * l);
    begin = end;
  }
  return landscapeScattering * landscapePhase(d) * landscapeSunBelow() * sum * all_ / (c.y * float(steps));
}

// Color of light that comes through a leaf, over that which it sends back: it passes the pigments once more, which hold
// back of each color what they hold back of the albedo, a / max a
vec3 landscapeThroughLeaf(vec3 albedo)
{
  return albedo / max(max(albedo.r, albedo.g), max(albedo.b, 1e-4));
}

// Luminance of a surface in the water, of an albedo and of a transmittance.
vec3 landscapeWet(vec3 albedo, vec3 placeV, vec3 normalV, float transmittance)
{
  vec3 normal = landscapeToWorld * normalV;
  float depth = max(landscapeBelow - (landscapeToWorld * placeV).z, 0.0);
  vec3 through = transmittance * landscapeThroughLeaf(albedo);
  float towards = dot(normal, landscapeSunInWater());
  float open = landscapeSkySeen(placeV, normalV);
  vec3 light = landscapeSkyBelow() * (0.5 + 0.5 * normal.z + through * (0.5 - 0.5 * normal.z));
  light *= open / (1.0 - albedo * (1.0 - open));
  vec3 facing = max(towards, 0.0) + through * max(-towards, 0.0);
  if (towards > 0.0 || transmittance > 0.0)
  {
    float seen = landscapeSunSeen(placeV, towards > 0.0 ? normalV : -normalV, towards);
    light += facing * seen * landscapeBelowClouds(landscapeToWorld * placeV) * landscapeSunBelow() *
      landscapeGathered((landscapeToWorld * placeV).xy, depth, landscapePixel * length(placeV));
  }
  return albedo / landscapePi * light * exp(-landscapeDownward() * depth);
}

// Normal of a facet of the surface, tilted from the normal n by slopes.
vec3 landscapeFacet(vec3 n, vec2 slope)
{
  return normalize(vec3(n.xy / n.z - slope, 1.0));
}

// Slopes and weights of five facets with a variance of their slopes: its own normal, and two along each axis by
// sqrt(3/2) of the whole deviation.
vec3 landscapeTilt(int facet, float variance)
{
  float tilt = sqrt(1.5 * variance);
  return facet == 4 ? vec3(0.0, 0.0, 1.0 / 3.0)
    : vec3(tilt * vec2(facet < 2 ? 1.0 - 2.0 * float(facet) : 0.0, facet < 2 ? 0.0 : 5.0 - 2.0 * float(facet)), 1.0 / 6.0);
}

// Softness of clouds on the surface.
float landscapeSoftClouds(float variance)
{
  return clamp(1.5 * sqrt(variance), 0.0, 0.3);
}

// Probability of a slope of the surface, Gaussian around that of its normal (Cox and Munk 1954)
float landscapeSlopeDensity(vec3 facet, vec3 n, float slopes)
{
  float variance = max(slopes, 1e-5);
  vec2 off = facet.xy / facet.z - n.xy / n.z;
  return exp(-dot(off, off) / variance) / (landscapePi * variance);
}

// Foam at a place of which it covers a part on the mean: in xy the slopes of its bubbles, in z their shade, 1 on the mean,
// in w its cover. It is strings along the middle value of a noise, which is about normal, as wide as P(|z| < w) = part,
// with a soft rim, and holes where it is whole. A footprint [m] above the size of an octave has none of it, and above the
// width of the strings the part alone.
vec4 landscapeLace(float part, vec2 place, float footprint)
{
  vec4 lace = vec4(0.0, 0.0, 1.0, 0.0);
  // A loop, which processors that draw leave at once where no pixel has foam, unlike a branch
  for (float k = 0.0; k < part; k += 1.0)
  {
    vec4 fades = 1.0 - smoothstep(0.5, 1.0, footprint / vec4(2.0, 0.5, 0.125, 0.03125));
    vec3 wide = landscapeNoise(place, 2.0, 34u) - vec3(0.5, 0.0, 0.0);
    vec3 strings = landscapeNoise(place, 0.5, 31u) - vec3(0.5, 0.0, 0.0);
    vec3 knots = landscapeNoise(place, 0.125, 32u) - vec3(0.5, 0.0, 0.0);
    vec3 bubbles = landscapeNoise(place, 0.03125, 33u) - vec3(0.5, 0.0, 0.0);
    // sum w n over its deviation, 0.226 sqrt(sum w2)
    float z = abs(0.65 * strings.x + 0.35 * knots.x + 0.1 * bubbles.x) / 0.168;
    float covered = min(part, 0.95);
    float width = log((1.0 + covered) / (1.0001 - covered)) / 1.702;
    float soft = 0.9 * min(width, 1.0) + 1e-4;
    lace.w = mix(1.0 - smoothstep(width - soft, width + soft, z), covered, smoothstep(0.15, 0.5, footprint));
    lace.xy = 0.15 * fades.y * strings.yz + 0.3 * fades.z * knots.yz + 0.4 * fades.w * bubbles.yz;
    lace.z = 1.0 + dot(fades, vec4(0.3, 0.5, 0.6, 0.6) * vec4(wide.x, strings.x, knots.x, bubbles.x));
  }
  return lace;
}

const float landscapeFoamAlbedo = 0.6;

// Luminance of foam on a surface with a normal: it is white, and half of its bubbles' walls are of all
// directions, so that it is bright against the sun too.
vec3 landscapeFoamLuminance(vec4 lace, vec3 placeV, vec3 n)
{
  return landscapeLuminance(vec3(landscapeFoamAlbedo * lace.z), placeV, landscapeFacet(n, lace.xy) * landscapeToWorld, 0.0, 0.5);
}

// Albedo of what grows at the rim of a river, and in w whether it is there, by the place between the banks, -1 and 1.
vec4 landscapeBank(float across, vec2 place)
{
  float wide = landscapeNoise(place, 16.0, 37u).x;
  float clump = landscapeNoise(place, 4.0, 38u).x;
  float w = smoothstep(0.70, 0.78, abs(across) + 0.3 * (wide - 0.5) + 0.3 * (clump - 0.5));
  return vec4(mix(vec3(0.055, 0.047, 0.034), vec3(0.040, 0.058, 0.022), smoothstep(0.3, 0.6, clump)), w);
}

// Way of water from its place at rest by the colors of SurfacePass [m].
vec2 landscapeWayOf(vec3 code)
{
  ivec3 c = ivec3(255.0 * code + 0.5);
  return vec2(((c.r << 4) | (c.g >> 4)) - 2048, (((c.g & 15) << 8) | c.b) - 2048) / 128.0;
}

// Part of the surface that is foam, by its stretch.
float landscapeFoamOf(float stretch)
{
  return stretch <= 0.0 ? 0.0 : 1.0 - smoothstep(landscapeFoamBegins - 0.25, landscapeFoamBegins, stretch);
}

float landscapeChannel = 0.0; // width of the river that is looked at [m]; 0: no bank is told of

// What stands on the bank of a river across the water: its luminance, and in w its height [m], that of sedges, or of
// bushes and trees here and there. From afar its height is even.
vec4 landscapeAcross(vec3 d, vec2 place, float footprint)
{
  vec2 at = place + landscapeChannel * normalize(d.xy + vec2(1e-6));
  float wide = mix(landscapeNoise(at, 32.0, 39u).x, 0.5, smoothstep(8.0, 32.0, footprint));
  float clump = mix(landscapeNoise(at, 4.0, 40u).x, 0.5, smoothstep(1.0, 4.0, footprint));
  float trees = smoothstep(0.45, 0.8, wide);
  vec3 facing = normalize(vec3(-d.xy, 0.4));
  vec3 light = 0.7 * landscapeSkyLightOn(facing) + 0.6 * max(dot(facing, landscapeSun), 0.0) * landscapeSunLight;
  vec3 albedo = mix(vec3(0.040, 0.058, 0.022), vec3(0.024, 0.036, 0.014), trees);
  return vec4(albedo / landscapePi * light, 0.2 + 0.8 * clump + 9.0 * trees);
}

// Part of a direction in which a bank of a height hides the sky, tan e w / h < 1, over the mean of the ways across.
float landscapeBankHides(vec3 direction, float height)
{
  float least = max(direction.z, 0.0) / max(length(direction.xy), 1e-3) * landscapeChannel / height;
  return landscapeChannel > 0.0 ? 1.0 - smoothstep(0.5, 2.0, least) : 0.0;
}

// Luminance of water seen from above along d, of a variance of the slopes around its normal, with the luminance of its
// own light, which comes from below.
vec3 landscapeWaterAbove(vec3 d, vec3 n, float variance, vec3 placeV, vec3 below, float footprint)
{
  // A loop, as for lace
  vec4 across = vec4(0.0, 0.0, 0.0, 1.0);
  for (float k = 0.0; k < landscapeChannel; k += 1e9)
  {
    across = landscapeAcross(d, (landscapeEye + landscapeToWorld * placeV).xy, footprint);
  }
  vec3 luminance = vec3(0.0);
  float weights = 0.0;
  for (int k = 0; k < 5; ++k)
  {
    vec3 tilt = landscapeTilt(k, variance);
    vec3 facet = landscapeFacet(n, tilt.xy);
    float cosine = -dot(d, facet);
    float weight = tilt.z * max(cosine, 1e-3); // as large as it looks
    float back = landscapeFresnel(cosine, landscapeIndex);
    vec3 mirrored = reflect(d, facet);
    mirrored.z = max(abs(mirrored.z), 1e-3);
    mirrored = normalize(mirrored);
    vec4 clouds = landscapeCloudsIn(mirrored, landscapeSoftClouds(variance));
    vec3 far = mix(mix(landscapeSkyAt(mirrored), clouds.rgb, clouds.w), across.rgb, landscapeBankHides(mirrored, across.w));
    luminance += weight * (back * far + (1.0 - back) * below);
    weights += weight;
  }
  luminance /= weights;
  // Glitter of the sun: E F p / (4 cos h_z^4)
  vec3 half_ = normalize(landscapeSun - d);
  if (landscapeSun.z > 0.0 && half_.z > 0.05)
  {
    float glint = landscapeFresnel(dot(half_, landscapeSun), landscapeIndex) * landscapeSlopeDensity(half_, n, variance) /
      (4.0 * max(-dot(d, n), 0.02) * pow(half_.z, 4.0));
    glint *= 1.0 - landscapeBankHides(landscapeSun, across.w);
    luminance += glint * landscapeBelowClouds(landscapeToWorld * placeV) * landscapeSunSeen(placeV, n * landscapeToWorld, 1.0) *
      landscapeSunLight;
  }
  return luminance;
}

// Luminance of the surface seen from below along d: the sky in Snell's window, water that it mirrors around it.
vec3 landscapeWaterBelow(vec3 d, vec3 n, float variance)
{
  vec3 luminance = vec3(0.0);
  float weights = 0.0;
  for (int k = 0; k < 5; ++k)
  {
    vec3 tilt = landscapeTilt(k, variance);
    vec3 facet = landscapeFacet(n, tilt.xy);
    float cosine = dot(d, facet);
    float weight = tilt.z * max(cosine, 1e-3);
    float back = landscapeFresnel(cosine, 1.0 / landscapeIndex);
    vec3 mirrored = reflect(d, facet);
    mirrored.z = -max(abs(mirrored.z), 1e-3);
    vec3 light = back * landscapeScattered(normalize(mirrored), 0.0, 1e3);
    if (back < 1.0)
    {
      vec3 out_ = refract(d, -facet, landscapeIndex);
      out_.z = max(out_.z, 1e-3);
      vec4 clouds = landscapeCloudsIn(out_, landscapeSoftClouds(variance));
      // n2 L: a beam of the sky is narrower in water. The sun is as wide as the slopes spread it.
      float spread = max(0.25 * variance, 2.2e-5);
      float off = 2.0 - 2.0 * min(dot(out_, landscapeSun), 1.0);
      vec3 sun = exp(-off / spread) / (landscapePi * spread) * (1.0 - clouds.w) * landscapeSunLight;
      light += (1.0 - back) * landscapeIndex * landscapeIndex * (mix(landscapeSkyAt(out_), clouds.rgb, clouds.w) + sun);
    }
    luminance += weight * light;
    weights += weight;
  }
  return luminance / weights;
}
