// The ground: a color of its own, that of the data, in patches; soil where little grows, rock where it is steep; its
// relief where the eye is near, and woods as they are seen from afar.

uniform float landscapeWoodCover; // part of the ground

// Color of what grows, relative to the data's, and in w the part of the ground that is bare.
vec4 landscapeGrowth(vec2 place)
{
  float wide = landscapeNoise(place, 16.0, 1u).x;
  float middle = landscapeNoise(place, 4.0, 2u).x;
  float small = landscapeNoise(place, 1.0, 3u).x;
  float dry = smoothstep(0.3, 0.7, 0.5 * wide + 0.3 * middle + 0.2 * small);
  float bare = smoothstep(0.58, 0.78, 0.35 * (1.0 - wide) + 0.4 * landscapeNoise(place, 4.0, 4u).x + 0.25 * small);
  return vec4(mix(vec3(0.80, 0.97, 0.80), vec3(1.22, 1.05, 0.90), dry), bare);
}

// Whether there is wood at a place modulo 64 km: more on slopes, which are not mown or ploughed.
float landscapeWoodAt(vec2 wide, float slope)
{
  const float scale = 16.0;
  float n = 0.0;
  float weight = 0.5;
  for (int octave = 0; octave < 6; ++octave)
  {
    n += weight * landscapeNoise(wide / scale, exp2(float(5 - octave)), uint(41 + octave)).x;
    weight *= 0.5;
  }
  // n is about normal: a value between corners has the variance 1/12 (181/231)^2, that of the sum is a third of it.
  float rarer = log(1.0 / max(landscapeWoodCover, 1e-4) - 1.0) / 1.702;
  float least = 0.492 + 0.1306 * rarer - 0.3 * min(slope, 0.4);
  return landscapeWoodCover <= 0.0 ? 0.0 : smoothstep(least - 0.01, least + 0.01, n);
}

// Where a flat line of sight to a place meets grass, in tufts of 0.25 m: the way from the place and, in z, the height
// there over that of the grass. Given is the way of the line while it crosses the grass.
vec3 landscapeTurfOn(vec2 place, vec2 way)
{
  const float steps = 5.0;
  float above = 0.3; // of the line over the grass, at the step before
  for (float step_ = steps - 1.0; step_ >= 0.0; --step_)
  {
    float high = step_ / steps;
    float next = high - landscapeNoise(place - high * way, 0.25, 10u).x;
    if (next <= 0.0)
    {
      high += next / (next - above) / steps; // between both, where it is 0
      return vec3(-high * way, high);
    }
    above = next;
  }
  return vec3(0.0);
}

// Albedo of the ground at a place; the normal gets its relief. A footprint is the side of a pixel there [m], a wide place
// is one modulo 64 km.
vec3 landscapeGround(vec3 albedo, vec2 place, vec2 wide, float footprint, inout vec3 normal)
{
  vec4 growth = landscapeGrowth(place);
  vec3 small = landscapeNoise(place, 1.0, 3u) - vec3(0.5, 0.0, 0.0);
  vec3 fine = landscapeNoise(place, 0.25, 5u) - vec3(0.5, 0.0, 0.0);
  vec3 grain = landscapeNoise(place, 0.0625, 6u) - vec3(0.5, 0.0, 0.0);
  // What is smaller than some pixels has no relief and no contrast.
  vec3 seen = clamp(2.0 - 2.0 * footprint / vec3(1.0, 0.25, 0.0625), 0.0, 1.0);
  float steep = smoothstep(0.22, 0.38, 1.0 - normal.z + 0.15 * small.x);
  const vec3 soil = vec3(0.115, 0.080, 0.052);
  const vec3 rock = vec3(0.235, 0.220, 0.195);
  vec3 color = mix(mix(albedo * growth.rgb, soil, 0.8 * growth.w), rock, steep);
  color *= 1.0 + 0.5 * small.x * seen.x + 0.7 * fine.x * seen.y + 0.8 * grain.x * seen.z;
  // Crowns of 8 m, dark between them
  float wood = landscapeWoodAt(wide, length(normal.xy) / max(normal.z, 0.1)) * (1.0 - steep);
  vec3 crown = landscapeNoise(place, 8.0, 8u) - vec3(0.5, 0.0, 0.0);
  float crowns = clamp(2.0 - 0.25 * footprint, 0.0, 1.0);
  const vec3 leaves = vec3(0.034, 0.052, 0.021);
  vec3 stand = vec3(0.75 + 0.5 * landscapeNoise(wide / 16.0, 4.0, 9u).x);
  color = mix(color, leaves * stand * mix(vec3(0.8), vec3(1.25, 1.15, 0.9), growth.r - 0.5) * (1.0 + 0.9 * crown.x * crowns), wood);
  normal.xy -= 0.5 * wood * crowns * crown.yz;
  seen *= 1.0 - wood;
  normal.xy -= 0.10 * small.yz * seen.x + 0.16 * fine.yz * seen.y + 0.2 * grain.yz * seen.z;
  normal = normalize(normal);
  return max(color, vec3(0.0));
}
