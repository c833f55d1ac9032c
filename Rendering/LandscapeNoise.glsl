// Noise on a plane that repeats itself after a period.

const int landscapePeriod = 4096; // [m]

// A number from 0 to 1 for each cell of a grid.
float landscapeRandom(ivec2 cell, int cells, uint seed)
{
  uvec2 c = uvec2(cell & (cells - 1));
  uint h = c.x * 0x9E3779B1u ^ (c.y + seed * 0x27220A95u) * 0x85EBCA77u;
  h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
  h = (h ^ (h >> 12)) * 0x297A2D39u;
  return float((h ^ (h >> 15)) >> 8) / 16777216.0;
}

// Noise of cells of a size [m], a power of two: its value from 0 to 1 and its slopes times the size.
vec3 landscapeNoise(vec2 place, float size, uint seed)
{
  int cells = int(float(landscapePeriod) / size);
  vec2 corner = floor(place / size);
  vec2 t = place / size - corner;
  ivec2 c = ivec2(corner);
  float a = landscapeRandom(c, cells, seed);
  float b = landscapeRandom(c + ivec2(1, 0), cells, seed);
  float d = landscapeRandom(c + ivec2(0, 1), cells, seed);
  float e = landscapeRandom(c + ivec2(1, 1), cells, seed);
  // s(t) = 6 t5 - 15 t4 + 10 t3
  vec2 s = t * t * t * (t * (6.0 * t - 15.0) + 10.0);
  vec2 slope = 30.0 * t * t * (t * (t - 2.0) + 1.0);
  float k = a - b - d + e;
  return vec3(a + (b - a) * s.x + (d - a) * s.y + k * s.x * s.y,
    slope * (vec2(b - a, d - a) + k * s.yx));
}
