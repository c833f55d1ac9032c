// Crowns on the ridge of a ground, against what is behind it: the march down a line of sight does not find them, as the
// line meets no ground there. They are put into the pictures of surfaces, before these are lit.
#if LandscapePart == LandscapeFringe
const int landscapeFringeReach = 24; // pixels from a ridge to the tops of crowns

// Inverse distance of what is at a pixel along the view's axis, 0 for the sky; it is linear on a plane [1/m].
float landscapeNearness(ivec2 pixel)
{
  vec4 surface = texelFetch(landscapeSurface, pixel, 0);
  return surface.z > -1.5 && surface.w > 0.0 ? 1.0 / surface.w : 0.0;
}

// Whether there is ground so many pixels below a pixel, well before a plane through what is at the pixel, of which the
// nearness and its growth by a pixel downwards are given.
bool landscapeIsRidge(ivec2 pixel, int below, vec2 plane)
{
  vec4 surface = texelFetch(landscapeSurface, ivec2(pixel.x, max(pixel.y - below, 0)), 0);
  bool isGround = surface.z > 1.5 && surface.z < 2.5 && surface.w > 0.0;
  return isGround && (1.03 * surface.w + 40.0) * (plane.x + 1.5 * float(below) * plane.y) < 1.0;
}

// Pixels down to the first ridge beyond so many, 0 if there is none.
int landscapeToRidge(ivec2 pixel, int beyond, vec2 plane)
{
  int found = landscapeIsRidge(pixel, landscapeFringeReach, plane) ? landscapeFringeReach : 0;
  while (found > beyond + 1)
  {
    int middle = (found + beyond) / 2;
    bool isRidge = landscapeIsRidge(pixel, middle, plane);
    found = isRidge ? middle : found;
    beyond = isRidge ? beyond : middle;
  }
  return found;
}

// Part of their height that crowns have on a ridge where pixels are so wide: none where they would reach too far up, or
// are as small as pixels.
float landscapeFringeGrown(float width)
{
  float high = landscapeCanopy / (width * float(landscapeFringeReach));
  return (1.0 - smoothstep(1.0, 1.5, high)) * clamp(2.0 - 0.25 * width, 0.0, 1.0);
}

// The color, surface and depth of a crown on a ridge some pixels below that a line of sight meets, instead of what is
// behind it. The line is as far as the ridge, and in two further rows, which stand as high.
void landscapeRaiseOn(int below, inout vec4 texel, inout vec4 surface, inout float depth)
{
  ivec2 ridge = ivec2(gl_FragCoord.xy) - ivec2(0, below);
  vec4 there = texelFetch(landscapeSurface, ridge, 0);
  vec3 ground = landscapeLinear(texelFetch(landscapeAlbedo, ridge, 0).rgb);
  vec3 up = landscapeToWorld * landscapeUnfolded(there.xy);
  vec3 sight = landscapePlace(0.5);
  sight /= -sight.z;
  float foot = (landscapeToWorld * (there.w * (sight - vec3(0.0, landscapePixel * float(below), 0.0)))).z;
  landscapeWoodLeast = landscapeWoodFrom(length(up.xy) / max(up.z, 0.1)) -
    0.12 * smoothstep(1.7, 2.4, ground.g / max(ground.r, 1e-3));
  float grown = landscapeFringeGrown(landscapePixel * there.w);
  for (int row = 2; row >= 0; --row)
  {
    float w = there.w + 5.0 * float(row);
    vec3 off = landscapeToWorld * (w * sight);
    vec4 crown = landscapeCrowns(landscapeEye.xy + off.xy, landscapeWideEye + off.xy);
    float high = off.z - foot;
    if (high < grown * crown.x)
    {
      float stand = landscapeNoise((landscapeWideEye + off.xy) / 16.0, 4.0, 9u).x;
      vec3 leaves = landscapeLeaves(crown.w, stand) * (0.75 + 0.5 * stand);
      leaves *= mix(0.5, 1.0, smoothstep(0.0, 0.7 * crown.x, high)); // dark below, as between crowns
      vec3 facing = normalize(vec3(-crown.yz - normalize(off.xy), 1.0)); // what is seen of a crown is before its middle
      texel = vec4(landscapeCodeOf(leaves), 1.0);
      surface = vec4(landscapeFolded(facing * landscapeToWorld), 0.0, w);
      // z = f / (f - n) (1 - n / w)
      float near = -landscapePlace(0.0).z;
      float far = -landscapePlace(1.0).z;
      depth = far / (far - near) * (1.0 - near / w);
    }
  }
}

// Crowns on the first two ridges below a pixel, of which the nearer one hides the other.
void landscapeRaise(inout vec4 texel, inout vec4 surface, inout float depth)
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float nearness = landscapeNearness(pixel);
  vec2 plane = vec2(nearness, max(nearness - landscapeNearness(pixel + ivec2(0, 1)), 0.0));
  int below = landscapeToRidge(pixel, 0, plane);
  // A loop, which processors that draw leave at once where no pixel is above a ridge
  for (int k = 0; k < 2 && below > 0; ++k)
  {
    landscapeRaiseOn(below, texel, surface, depth);
    vec2 steps = vec2(landscapeNearness(pixel - ivec2(0, below)), landscapeNearness(pixel - ivec2(0, below + 1)));
    // The same plane for pixels that are counted from the first
    float growth = max(steps.y - steps.x, 0.0);
    below = landscapeToRidge(pixel, below, vec2(max(steps.x - 1.5 * float(below) * growth, 0.0), growth));
  }
}
#endif
