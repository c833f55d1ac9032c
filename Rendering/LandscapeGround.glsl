// The ground: a color of its own, that of the data, in patches; soil where little grows, rock where it is steep; and its
// relief where the eye is near.

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

// Albedo of the ground at a place; the normal gets its relief. A footprint is the side of a pixel there [m].
vec3 landscapeGround(vec3 albedo, vec2 place, float footprint, inout vec3 normal)
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
  normal.xy -= 0.10 * small.yz * seen.x + 0.16 * fine.yz * seen.y + 0.2 * grain.yz * seen.z;
  normal = normalize(normal);
  return max(color, vec3(0.0));
}
