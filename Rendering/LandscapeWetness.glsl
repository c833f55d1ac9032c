// Surfaces that are wet: below a film of water, which mirrors; and a shore, which waves wet and foam on.

uniform float landscapeWetness; // part of all surfaces that is wet
uniform float landscapeRunUp;   // height over the water's level, and depth below it, of the run of waves on a shore [m]
uniform float landscapeSwash;   // time of this run, in its periods

const float landscapeFilmVariance = 0.01; // of the slopes of a film, in both directions together
const float landscapeFilmEnters = 0.934;  // part of diffuse light that goes through a film's surface

// Luminance of the sky that a film mirrors.
vec3 landscapeMirrored(vec3 d, vec3 film)
{
  vec3 mirrored = reflect(d, film);
  vec4 clouds = landscapeCloudsIn(mirrored, 0.1);
  return mix(landscapeSkyAt(mirrored), clouds.rgb, clouds.w);
}

// Luminance of the sun in a film over its light: F p / (4 cos h^4), with the density p of slopes
float landscapeGlint(vec3 d, vec3 film)
{
  vec3 half_ = normalize(landscapeSun - d);
  float h = max(dot(half_, film), 0.1);
  float density = exp((1.0 - 1.0 / (h * h)) / landscapeFilmVariance) / (landscapePi * landscapeFilmVariance);
  return landscapeFresnel(dot(half_, landscapeSun), landscapeIndex) * density /
    (4.0 * max(-dot(d, film), 0.05) * pow(h, 4.0));
}

// Normal of a film on a ground in the world: it fills much of the relief.
vec3 landscapeFilm(vec3 smoothedV, vec3 reliefV)
{
  return normalize(landscapeToWorld * mix(smoothedV, reliefV, 0.3));
}

// Albedo of ground below a film, which sends a part p of what leaves the ground back to it:
// a' = (1 - R) a / (n2 (1 - p a)), p = 1 - (1 - R) / n2  (Angstrom 1925, in Lekner and Dorf 1988)
vec3 landscapeSoaked(vec3 albedo)
{
  float leaves = landscapeFilmEnters / (landscapeIndex * landscapeIndex);
  return leaves * albedo / (1.0 - (1.0 - leaves) * albedo);
}

// Luminance along d of a surface of which a part is wet, as landscapeLuminance of a dry one; the film has a normal of its
// own. What is mirrored is not lit below: L = (1 - F) L' + F L_sky
vec3 landscapeMoist(float wet, bool isGround, vec3 albedo, vec3 d, vec3 placeV, vec3 normalV, vec3 film,
  float transmittance, float agreed)
{
  vec3 sky;
  vec3 sun;
  float facing;
  float open = landscapeSkySeen(placeV, normalV);
  landscapeLightOn(albedo, open, placeV, normalV, transmittance, agreed, sky, sun, facing);
  vec3 dry = albedo / landscapePi * (sky + facing * sun);
  float back = agreed * landscapeFresnel(-dot(d, film), landscapeIndex);
  float enters = 1.0 - agreed * landscapeFresnel(abs(dot(landscapeSun, film)), landscapeIndex);
  vec3 below = isGround ? landscapeSoaked(albedo) : albedo;
  enters /= isGround ? landscapeFilmEnters : 1.0;
  below *= (sky + enters * facing * sun) / landscapePi;
  vec3 mirrored = mix(below, landscapeMirrored(d, film), open);
  return mix(dry, mix(below, mirrored, back) + agreed * landscapeGlint(d, film) * sun, wet);
}

// Part of a shore that waves wet, by its height over the water's level [m]: up to the run of waves, at places more.
float landscapeShoreWet(float height, vec2 place)
{
  return 1.0 - smoothstep(0.9, 1.2, height / landscapeRunUp + 0.4 * landscapeNoise(place, 4.0, 33u).x - 0.2);
}

// Part of a shore that is foam: fronts run from the depth -1 to the height 1 in a period, and leave foam behind, which
// fades.
float landscapeShoreFoam(float height, vec2 place)
{
  float h = height / landscapeRunUp;
  float bend = 1.5 * landscapeNoise(place, 16.0, 34u).x + 0.4 * landscapeNoise(place, 4.0, 35u).x;
  float since = fract(landscapeSwash + bend - 0.5 * h);
  return 0.8 * (1.0 - smoothstep(0.4, 1.0, abs(h))) * exp(-3.0 * since);
}
