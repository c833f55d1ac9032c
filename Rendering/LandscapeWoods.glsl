// Woods as they are seen from a kilometre or more: crowns that stand on the ground, along a line of sight that is flat.

uniform float landscapeWoodCover; // part of the ground

#ifdef LandscapeHasWoods
const float landscapeCanopy = 22.0;   // height of the highest crowns [m]
const float landscapeCrownSide = 8.0; // of the cells that have a crown each [m]
float landscapeWoodLeast = 1.0;       // of the field of woods where there is one

// Field of woods at a place modulo 64 km, from 0 to 1, and its slopes [1/m].
vec3 landscapeWoodField(vec2 wide)
{
  const float scale = 16.0;
  vec3 n = vec3(0.0);
  float weight = 0.5;
  for (int octave = 0; octave < 3; ++octave)
  {
    float size = exp2(float(5 - octave));
    n += weight * landscapeNoise(wide / scale, size, uint(41 + octave)) / vec3(1.0, vec2(scale * size));
    weight *= 0.5;
  }
  return n;
}

// Value of the field from which on there is wood: more on slopes, which are not mown or ploughed.
float landscapeWoodFrom(float slope)
{
  // n is about normal: a value between corners has the variance 1/12 (181/231)^2, that of the sum is a third of it.
  float rarer = log(1.0 / max(landscapeWoodCover, 1e-4) - 1.0) / 1.702;
  return 0.4375 + 0.1306 * rarer - 0.3 * min(slope, 0.4);
}

// The crowns at a place: height, its slopes, and in w a number from 0 to 1 of the crown. A crown is there as a whole
// where the field at its middle says so: z = h - b (r / R)^2, round or pointed; lower at the rim of a wood.
vec4 landscapeCrowns(vec2 place, vec2 wide)
{
  vec3 field = landscapeWoodField(wide);
  vec2 at = place / landscapeCrownSide - 0.5;
  ivec2 corner = ivec2(floor(at));
  vec4 highest = vec4(0.0);
  for (int k = 0; k < 4; ++k)
  {
    ivec2 cell = corner + ivec2(k & 1, k >> 1);
    vec4 r = fract(landscapeRandom(cell, 512, 51u) * vec4(1.0, 64.0, 4096.0, 262144.0));
    vec2 off = landscapeCrownSide * (at - vec2(cell) - 0.64 * (r.xy - 0.5));
    float alone = r.x > 0.8 ? 1.2 * max(r.z - 0.9, 0.0) : 0.0;
    float inside = field.x - dot(field.yz, off) - landscapeWoodLeast + 0.09 * (r.w - 0.5) + alone;
    float radius = landscapeCrownSide * (0.40 + 0.28 * r.z);
    float grown = (0.5 + 0.5 * smoothstep(0.0, 0.02, inside)) * (0.62 + 0.38 * fract(3.0 * r.z + r.x));
    float t = dot(off, off) / (radius * radius);
    float deep = radius * (r.w > 0.6 ? 1.7 : 0.9); // pointed ones are deeper
    float z = landscapeCanopy * grown - deep * t;
    if (inside > 0.0 && t < 1.0 && z > highest.x)
    {
      highest = vec4(z, -2.0 * deep / (radius * radius) * off, r.w);
    }
  }
  return highest;
}

// Where a line of sight meets crowns or the ground: the way from the place to there, in z the height. Given is the way
// of the line while it is as high as crowns.
vec3 landscapeWoodOn(vec2 place, vec2 wide, vec2 way, int steps)
{
  float above = 1.0; // of the line over the crowns, at the step before
  float hit = 0.0;
  for (int k = steps - 1; k >= 0; --k)
  {
    float high = float(k) / float(steps);
    float next = high - landscapeCrowns(place - high * way, wide - high * way).x / landscapeCanopy;
    if (next <= 0.0 && k > 0)
    {
      hit = high + next / (next - above) / float(steps); // between both, where it is 0
      break;
    }
    above = next;
  }
  return vec3(-hit * way, hit * landscapeCanopy);
}

// Part of the sun that crowns let through to a place of a height [m].
float landscapeBelowCrowns(vec2 place, vec2 wide, float height, int steps)
{
  vec2 way = landscapeSun.xy / max(landscapeSun.z, 0.1);
  float through = 1.0;
  for (int k = 0; k < steps; ++k)
  {
    float rise = (float(k) + 0.4) / float(steps) * 0.6 * (landscapeCanopy - height);
    float over = landscapeCrowns(place + rise * way, wide + rise * way).x - height - rise;
    through *= 1.0 - 0.95 * smoothstep(0.0, 2.0, over);
  }
  return through;
}

// Albedo of a crown, by its number and by that of its stand: pines, oaks, birches.
vec3 landscapeLeaves(float crown, float stand)
{
  float kind = fract(7.0 * crown);
  vec3 broad = mix(vec3(0.036, 0.058, 0.020), vec3(0.074, 0.082, 0.027), kind * kind);
  return mix(broad, vec3(0.018, 0.033, 0.017), step(0.6 - 0.5 * (stand - 0.5), crown)) * (0.8 + 0.4 * kind);
}
#endif
