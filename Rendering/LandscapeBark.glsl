// Bark: furrows along a trunk with cracks across them; that of birches, which is bright, is smooth but for dark marks.

// Albedo of bark at a place in the world, of the mean of its data; the normal gets its relief. A footprint is the side of a
// pixel there [m].
vec3 landscapeBark(vec3 albedo, vec3 place, float footprint, inout vec3 normal)
{
  // Furrows are a noise of the horizontal plane, which winds on its way up.
  float winding = landscapeNoise(vec2(place.x + place.y, place.z), 0.25, 11u).x;
  vec3 furrow = landscapeNoise(place.xy + 0.08 * winding, 0.0625, 12u);
  float crack = landscapeNoise(vec2(4.0 * (place.x - place.y), place.z), 0.125, 13u).x;
  float seen = clamp(2.0 - 2.0 * footprint / 0.0625, 0.0, 1.0);
  float rough = seen * (1.0 - smoothstep(0.3, 0.5, dot(albedo, vec3(0.2126, 0.7152, 0.0722))));
  normal = normalize(normal - 0.3 * rough * vec3(furrow.yz, 0.0));
  albedo *= 1.0 + 1.4 * rough * (0.6 * furrow.x + 0.4 * crack - 0.5);
  // Marks of 13 cm by 3 cm lie across a trunk.
  float mark = landscapeNoise(vec2(place.x - place.y, 4.0 * place.z), 0.125, 14u).x;
  return albedo * (1.0 + (seen - rough) * (0.13 - 0.7 * smoothstep(0.68, 0.8, mark)));
}
