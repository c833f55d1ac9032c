//VTK::System::Dec
// Blur of a lens that is open (Lens). Lit pixels have their luminance and, in w, the distance along the view's axis, 0
// where nothing is. Lengths are in pixels of the lit picture.
#define LensTiles 0  // largest blur in squares of pixels
#define LensGather 1 // the picture behind the lens

in vec2 texCoord;
uniform sampler2D lensLit;
uniform sampler2D lensTiles;
uniform float lensBlur;    // radius of blur over the difference of inverse distances [m]
uniform float lensFocus;   // [m]
uniform float lensLargest; // radius of blur, and side of a tile
uniform float lensTaps;
//VTK::Output::Dec

// Radius of the circle that a point at a distance s becomes: A F/2 |1/f - 1/s|, with the lens' diameter A, the focus f
// and the distance F in pixels at which the picture has its angle of view  (Potmesil and Chakravarty 1981)
float lensRadius(float way)
{
  return way <= 0.0 ? 0.0 : min(lensBlur * abs(1.0 / lensFocus - 1.0 / way), lensLargest);
}

#if LensPart == LensTiles
void main()
{
  int side = int(lensLargest);
  ivec2 size = textureSize(lensLit, 0);
  ivec2 corner = side * ivec2(texCoord * vec2((size - 1) / side + 1));
  ivec2 end = min(corner + side, size);
  float radius = 0.0;
  for (int y = corner.y; y < end.y; ++y)
  {
    for (int x = corner.x; x < end.x; ++x)
    {
      radius = max(radius, lensRadius(texelFetch(lensLit, ivec2(x, y), 0).w));
    }
  }
  gl_FragData[0] = vec4(radius);
}
#else

// Largest blur that may reach a pixel.
float lensReach(vec2 pixel)
{
  ivec2 tile = ivec2(pixel / lensLargest);
  ivec2 end = textureSize(lensTiles, 0) - 1;
  float reach = 0.0;
  for (int k = 0; k < 9; ++k)
  {
    reach = max(reach, texelFetch(lensTiles, clamp(tile + ivec2(k % 3, k / 3) - 1, ivec2(0), end), 0).r);
  }
  return reach;
}

void main()
{
  vec2 size = vec2(textureSize(lensLit, 0));
  vec2 pixel = texCoord * size;
  vec4 own = texture(lensLit, texCoord);
  float ownRadius = lensRadius(own.w);
  float reach = max(lensReach(pixel), 0.5);
  // Another turn of the taps in each of 4 x 4 pixels
  ivec2 p = ivec2(gl_FragCoord.xy) & 3;
  float turn = (float(8 * ((p.x ^ p.y) & 1) + 4 * (p.y & 1) + ((p.x ^ p.y) & 2) + (p.y >> 1)) + 0.5) / 16.0;
  vec4 behind = vec4(own.rgb, 1.0) / max(ownRadius * ownRadius, 0.25);
  vec4 before = vec4(0.0);
  float soft = ownRadius;
  float taps = reach > 0.5 ? lensTaps : 0.0;
  for (float tap = 0.0; tap < taps; ++tap)
  {
    float off = reach * sqrt((tap + turn) / taps);
    float angle = 2.3999632 * tap + 6.2831853 * turn;
    vec4 there = texture(lensLit, (pixel + off * vec2(cos(angle), sin(angle))) / size);
    float radius = lensRadius(there.w);
    // What is before a pixel spreads over it by its own blur; what is beside it or behind, by the pixel's.
    float nearer = clamp(20.0 * (1.0 - there.w / max(own.w, 1e-9)), 0.0, 1.0);
    float covers = nearer * clamp(radius - off + 0.5, 0.0, 1.0) / max(radius * radius, 0.25);
    before += covers * vec4(there.rgb, 1.0);
    soft = max(soft, covers > 0.0 ? radius : 0.0);
    behind += (1.0 - nearer) * clamp(ownRadius - off + 0.5, 0.0, 1.0) / max(ownRadius * ownRadius, 0.25) *
      vec4(there.rgb, 1.0);
  }
  // A tap stands for pi R2 / N pixels, of the pi r2 that a pixel covers
  before *= reach * reach / max(taps, 1.0);
  before /= max(before.a, 1.0);
  gl_FragData[0] = vec4(before.rgb + (1.0 - before.a) * behind.rgb / behind.a, soft);
}
#endif
