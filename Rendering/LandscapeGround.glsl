// The ground: a color of its own, that of the data, in patches; soil where little grows, rock where it is steep; its
// relief where the eye is near, and woods as they are seen from afar.

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

#ifdef LandscapeHasWoods
// Puts woods on a color of the ground, along a line of sight d; the normal gets their relief. A pixel is as
// wide as away [m]: crowns face the eye. More trees stand where it is moist, 0 to 1.
vec3 landscapeWooded(vec3 color, float moist, vec2 place, vec2 wide, vec3 d, float away, inout vec3 normal)
{
  float slope = length(normal.xy) / max(normal.z, 0.1);
  landscapeWoodLeast = landscapeWoodFrom(slope) - 0.12 * moist;
  vec3 field = landscapeWoodField(wide);
  float inside = field.x - landscapeWoodLeast;
  float stand = landscapeNoise(wide / 16.0, 4.0, 9u).x;
  // Meadows are moist and green below, dry above
  float dry = landscapeNoise(wide / 16.0, 16.0, 47u).x + 0.6 * (stand - 0.5) + 1.5 * min(slope, 0.4);
  color *= mix(vec3(0.80, 0.92, 0.86), vec3(1.30, 1.04, 0.80), smoothstep(0.3, 0.85, dry));
  // From afar a wood is even
  float crowns = clamp(2.0 - 0.25 * away, 0.0, 1.0);
  float wood = smoothstep(-0.012, 0.012, inside);
  vec3 even = vec3(0.022, 0.033, 0.014) * (0.75 + 0.5 * stand);
  vec2 way = landscapeCanopy * normal.z / max(-dot(d, normal), 0.15) * d.xy;
  vec2 shade = landscapeCanopy * landscapeSun.xy / max(landscapeSun.z, 0.1);
  float near = inside + max(max(0.0, -dot(field.yz, way)), 0.7 * dot(field.yz, shade));
  bool hasCrowns = crowns > 0.0 && near > -0.06;
  vec3 hit = landscapeWoodOn(place, wide, way, hasCrowns ? int(clamp(length(way) / 6.0, 4.0, 12.0)) : 0);
  landscapeShaded = mix(1.0, landscapeBelowCrowns(place + hit.xy, wide + hit.xy, hit.z, hasCrowns ? 2 : 0), crowns);
  for (int k = 0; k < (hasCrowns ? 1 : 0); ++k)
  {
    vec4 crown = landscapeCrowns(place + hit.xy, wide + hit.xy);
    bool isCrown = hit.z > 0.0;
    vec3 between = color * mix(1.0, 0.4, wood);
    vec3 leaves = landscapeLeaves(crown.w, stand) * (0.75 + 0.5 * stand);
    leaves *= mix(0.35, 1.0, smoothstep(-6.0, 0.0, hit.z - crown.x));
    color = mix(color, even, (1.0 - crowns) * wood);
    color = mix(color, isCrown ? leaves : between, crowns);
    normal = isCrown ? normalize(normal + crowns * vec3(-crown.yz, 0.0)) : normal;
  }
  return hasCrowns ? color : mix(color, even, wood);
}
#endif

// Albedo of the ground at a place; the normal gets its relief. A footprint is the side of a pixel there [m].
vec3 landscapeGround(vec3 albedo, vec2 place, float footprint, inout vec3 normal)
{
  vec4 growth = landscapeGrowth(place);
  vec3 small = landscapeNoise(place, 1.0, 3u) - vec3(0.5, 0.0, 0.0);
  // What is smaller than some pixels has no relief and no contrast; a loop that does not begin takes no time.
  vec3 seen = clamp(2.0 - 2.0 * footprint / vec3(1.0, 0.25, 0.0625), 0.0, 1.0);
  vec3 fine = vec3(0.0);
  vec3 grain = vec3(0.0);
  for (int k = 0; k < (seen.y > 0.0 ? 1 : 0); ++k)
  {
    fine = landscapeNoise(place, 0.25, 5u) - vec3(0.5, 0.0, 0.0);
    grain = landscapeNoise(place, 0.0625, 6u) - vec3(0.5, 0.0, 0.0);
  }
  float steep = smoothstep(0.22, 0.38, 1.0 - normal.z + 0.15 * small.x);
  const vec3 soil = vec3(0.115, 0.080, 0.052);
  const vec3 rock = vec3(0.235, 0.220, 0.195);
  vec3 color = mix(mix(albedo * growth.rgb, soil, 0.8 * growth.w), rock, steep);
  color *= 1.0 + 0.5 * small.x * seen.x + 0.7 * fine.x * seen.y + 0.8 * grain.x * seen.z;
  normal.xy -= 0.10 * small.yz * seen.x + 0.16 * fine.yz * seen.y + 0.2 * grain.yz * seen.z;
  normal = normalize(normal);
  return max(color, vec3(0.0));
}
