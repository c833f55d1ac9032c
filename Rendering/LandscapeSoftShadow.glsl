// Shadows as soft as the sun's disk is wide: the part of it that is seen over the edge of what casts them.

#ifdef LandscapeSoftShadows
uniform sampler2D landscapeMapDepths; // those of landscapeMaps, told, not compared
uniform float landscapeMapRange;      // between the depths 0 and 1 [m]

const float landscapeSunSlope = 0.004653; // tangent of the disk's radius of 0.2666 degrees
const float landscapeSoftest = 0.35;      // largest radius of a penumbra [m]
const float landscapeSearchTaps = 12.0;
const float landscapeSoftTaps = 8.0;

// Place from 0 to 1 of a pixel among 4 x 4, of which neighbours are far from each other  (Bayer 1973)
float landscapeTurn()
{
  ivec2 p = ivec2(gl_FragCoord.xy) & 3;
  int order = 8 * ((p.x ^ p.y) & 1) + 4 * (p.y & 1) + ((p.x ^ p.y) & 2) + (p.y >> 1);
  return (float(order) + 0.5) / 16.0;
}

// Direction of a tap of a spiral  (Vogel 1979)
vec2 landscapeSpiral(float tap, float turn)
{
  float angle = 2.3999632 * tap + 6.2831853 * turn;
  return vec2(cos(angle), sin(angle));
}

// Coordinates in the maps' texture of a place that is off another one [m], within its map.
vec2 landscapeInMap(int map, vec2 at, vec2 off)
{
  vec2 place = clamp(at + off / (landscapeTexel[map] * landscapeMapSize), 0.002, 0.998);
  return 0.5 * place + 0.5 * vec2(map & 1, map >> 1);
}

// Mean distance of what casts a shadow on a place, in three times the cone of the sun's disk, for all that is in the
// cone is found where some of it is; 0 without anything (Fernando, Percentage-closer soft shadows, 2005).
float landscapeCasterAway(int map, vec3 at)
{
  vec2 sum = vec2(0.0);
  float turn = landscapeTurn();
  for (float tap = 0.0; tap < landscapeSearchTaps; ++tap)
  {
    // More taps near the middle, as what is near has a small cone
    float part = (tap + turn) / landscapeSearchTaps;
    float off = 3.0 * landscapeSoftest * part * part * part * part;
    float depth = textureLod(landscapeMapDepths, landscapeInMap(map, at.xy, off * landscapeSpiral(tap, turn)), 0.0).r;
    float away = (at.z - depth) * landscapeMapRange;
    bool casts = away > 0.0 && off < 3.0 * landscapeSunSlope * away + 1.5 * landscapeTexel[map];
    sum += casts ? vec2(away, 1.0) : vec2(0.0);
  }
  return sum.x / max(sum.y, 1.0);
}

// Part of the sun's disk that is seen from a place of a map. A disk of the radius r = d tan(0.2666 degrees) around it,
// across the light, is what it sees at the distance d; not less than the texels blur.
float landscapeReachesSoftly(int map, vec3 at, float towards)
{
  float radius = landscapeSunSlope * landscapeCasterAway(map, at);
  radius = clamp(radius, 0.8 * landscapeTexel[map], max(landscapeSoftest, 0.8 * landscapeTexel[map]));
  // The surface itself rises by this against the light; what casts is 200 times as far as it is beside.
  float rise = min(sqrt(max(0.0, 1.0 - towards * towards)) / max(abs(towards), 0.02), 40.0);
  float seen = 0.0;
  float turn = landscapeTurn();
  for (float tap = 0.0; tap < landscapeSoftTaps; ++tap)
  {
    float off = radius * sqrt((tap + turn) / landscapeSoftTaps);
    float before = 1.5 * rise * max(off - 1.5 * landscapeTexel[map], 0.0) / landscapeMapRange;
    seen += texture(landscapeMaps, vec3(landscapeInMap(map, at.xy, off * landscapeSpiral(tap, turn)), at.z - before));
  }
  return seen / landscapeSoftTaps;
}
#endif
