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

// Part of a ground that is below water which stands on it, of one of which a part is wet: hollows, as a noise that is about
// normal has them, of level ground. A footprint [m] above their size has the part alone.
float landscapePuddles(float wet, vec2 place, float footprint, vec3 up)
{
  float z = (landscapeNoise(place, 2.0, 36u).x - 0.5) / 0.226;
  float least = log((1.0 - wet + 1e-4) / (wet + 1e-4)) / 1.702;
  float stands = mix(smoothstep(least - 0.3, least + 0.3, z), wet, smoothstep(0.5, 2.0, footprint));
  return stands * (1.0 - smoothstep(0.03, 0.12, length(up.xy) / max(up.z, 0.1)));
}

// Luminance along d of a surface of which a part is wet, and a part below a film with a normal, as landscapeLuminance of a
// dry one. What is mirrored is not lit below: L = (1 - F) L' + F L_sky
vec3 landscapeMoist(float wet, float film, bool isGround, vec3 albedo, vec3 d, vec3 placeV, vec3 normalV, vec3 up,
  float transmittance, float agreed)
{
  vec3 sky;
  vec3 sun;
  float facing;
  float open = landscapeSkySeen(placeV, normalV);
  landscapeLightOn(albedo, open, placeV, normalV, transmittance, agreed, sky, sun, facing);
  film *= agreed;
  float back = film * landscapeFresnel(-dot(d, up), landscapeIndex);
  float enters = (1.0 - landscapeFresnel(abs(dot(landscapeSun, up)), landscapeIndex)) /
    (isGround ? landscapeFilmEnters : 1.0);
  vec3 below = isGround ? mix(albedo, landscapeSoaked(albedo), wet) : albedo;
  below *= (sky + mix(1.0, enters, film) * facing * sun) / landscapePi;
  vec3 mirrored = mix(below, landscapeMirrored(d, up), open);
  return mix(below, mirrored, back) + film * landscapeGlint(d, up) * sun;
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
