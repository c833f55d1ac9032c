// Normal of a place of the unfolded octahedron.
vec3 landscapeUnfolded(vec2 o)
{
  vec3 n = vec3(o, 1.0 - abs(o.x) - abs(o.y));
  vec2 s = vec2(o.x >= 0.0 ? 1.0 : -1.0, o.y >= 0.0 ? 1.0 : -1.0);
  return normalize(n.z >= 0.0 ? n : vec3((1.0 - abs(o.yx)) * s, n.z));
}
