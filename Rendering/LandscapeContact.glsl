//VTK::System::Dec
// What hides the sky within a short distance of what a picture shows, by the distances of its pixels (ContactShade).
#define ContactWays 0   // the distances
#define ContactHidden 1 // what hides

in vec2 texCoord;
uniform sampler2D contactWays;    // of the part before: distance along the view's axis [m]; 1e9 where nothing is
uniform sampler2D contactSurface; // outputs of SurfacePass
uniform sampler2D contactDepth;
uniform mat4 contactToView;       // from clip coordinates
uniform vec4 contactRays;         // x and y of the place of texture coordinates t, at a distance of 1: xy + zw t
uniform int contactIsParallel;    // 1: at each distance
uniform mat3 contactToWorld;
uniform float contactRadius;      // [m]
uniform vec2 contactCounts;       // slices, and taps on each of their sides
uniform float contactStep;        // pixels of the picture from one told of to the next
//VTK::Output::Dec

const float contactThin = 0.6; // part of what leaves and grass hide by their horizons, by eye

vec3 contactPlace(vec2 at, float way)
{
  vec2 xy = contactRays.xy + contactRays.zw * at;
  return vec3(contactIsParallel == 1 ? xy : xy * way, -way);
}

// Angle from 0 to pi of a cosine  (Abramowitz and Stegun 1964, 4.4.45)
float contactAngle(float c)
{
  float x = abs(c);
  float angle = sqrt(1.0 - x) * (1.5707288 + x * (-0.2121144 + x * (0.0742610 - 0.0187293 * x)));
  return c < 0.0 ? 3.14159265 - angle : angle;
}

// Integral of cos(t - g) |sin t| over angles t from the eye's direction to h in a slice, by cosine and sine of h and of
// the normal's angle g: (cos g - cos(2 h - g) + 2 h sin g) / 4  (Jimenez, Wu, Pesce and Jarabo 2016)
float contactArc(float h, vec2 ofH, vec2 ofG)
{
  return 0.5 * (ofG.x * ofH.y * ofH.y + ofG.y * (h - ofH.x * ofH.y));
}

// The pixel of these pictures at texCoord.
ivec2 contactPixel()
{
  return ivec2(texCoord * ceil(vec2(textureSize(contactDepth, 0)) / contactStep));
}

// Texture coordinates of the pixel of the picture that one of these pictures tells of.
vec2 contactCoord(ivec2 pixel)
{
  return (contactStep * vec2(pixel) + 0.5) / vec2(textureSize(contactDepth, 0));
}

// Distance of what the picture of this process shows.
float contactOwnWay(vec2 at)
{
  float depth = texture(contactDepth, at).r;
  float w = texture(contactSurface, at).w;
  vec4 place = contactToView * vec4(2.0 * vec3(at, depth) - 1.0, 1.0);
  float way = contactIsParallel == 1 || w <= 0.0 ? -place.z / place.w : w;
  return depth >= 1.0 ? 1e9 : way;
}

#if ContactPart == ContactWays
void main()
{
  gl_FragData[0] = vec4(contactOwnWay(contactCoord(contactPixel())));
}
#else
void main()
{
  ivec2 pixel = contactPixel();
  vec2 here = contactCoord(pixel);
  float way = texelFetch(contactWays, pixel, 0).r;
  vec4 surface = texture(contactSurface, here);
  vec3 place = contactPlace(here, way);
  vec3 eye = contactIsParallel == 1 ? vec3(0.0, 0.0, 1.0) : normalize(-place);
  // Normals of small parts may point away from the eye: those at right angles to it are taken for them.
  vec3 normal = landscapeUnfolded(surface.xy);
  normal = normalize(normal + max(0.02 - dot(normal, eye), 0.0) * eye);
  vec3 right = normalize(vec3(eye.z, 0.0, -eye.x));
  vec3 up = cross(eye, right);
  vec2 ahead = contactIsParallel == 1 ? vec2(0.0) : place.xy / way;
  float scale = contactRadius / (contactIsParallel == 1 ? 1.0 : way);
  // Four neighbours have other turns of the slices each, and all of their sides have taps at other places.
  pixel &= 1;
  float turn = 0.5 * float(pixel.x ^ pixel.y) + 0.25 * float(pixel.y);
  float begin = 0.5 * float(pixel.y) + 0.25 * float(pixel.x);
  // Less than two pixels are none, nor is what no light changes, and sprites are not where they are drawn. A loop
  // without turns costs nothing.
  vec2 size = vec2(textureSize(contactDepth, 0)) / contactStep;
  float pixels = scale / abs(contactRays.w) * size.y;
  float seen = clamp(0.5 * contactStep * pixels - 1.0, 0.0, 1.0);
  bool isFlat = surface.z < -0.5 || surface.w <= 0.0 || way > 1e8 || seen <= 0.0;
  float slices = isFlat ? 0.0 : contactCounts.x;
  float taps = clamp(ceil(0.25 * pixels), 1.0, contactCounts.y); // not closer than four pixels
  vec4 hidden = vec4(0.0); // its direction, and how much
  for (float slice = 0.0; slice < slices; ++slice)
  {
    float around = 3.14159265 * (slice + turn) / slices;
    vec3 along = cos(around) * right + sin(around) * up;
    vec3 across = cross(along, eye);
    vec3 upright = normal - dot(normal, across) * across;
    vec2 ofG = vec2(dot(upright, eye), dot(upright, along));
    float flat_ = length(ofG);
    ofG /= flat_;
    float g = sign(ofG.y) * contactAngle(ofG.x);
    vec2 reach = scale * (along.xy + ahead * along.z) / contactRays.zw;
    for (float side = -1.0; side < 2.0; side += 2.0)
    {
      float open = contactArc(g + side * 1.57079633, side * vec2(-ofG.y, ofG.x), ofG);
      float last = 0.0;
      for (float tap = 0.0; tap < taps; ++tap)
      {
        float part = (tap + begin + 0.125 * mod(slice, 2.0) + 0.03125 * (2.0 + side)) / taps;
        vec2 at = here + side * max(part * part, 1.5 / max(length(reach * size), 1.5)) * reach;
        ivec2 there = ivec2(floor(at * size + 0.5 - 0.5 / contactStep));
        at = contactCoord(there);
        vec3 off = contactPlace(at, texelFetch(contactWays, there, 0).r) - place;
        float away = length(off);
        float far = away / contactRadius;
        off /= away;
        if (far < 1.0 && dot(off, normal) > 0.03 && at == clamp(at, 0.0, 1.0))
        {
          // Directions weigh 1 - (s / r)2 by their distances s  (Bavoil and Sainz 2008), not less than that of the tap
          // before: this makes up for what lies beyond the last tap that finds anything.
          float c = clamp(dot(off, eye), -1.0, 1.0);
          float now = contactArc(side * contactAngle(c), vec2(c, side * sqrt(1.0 - c * c)), ofG);
          hidden += max(open - now, 0.0) * (1.0 - last * last) * flat_ * vec4(off, 1.0);
          open = min(open, now);
        }
        last = part * part;
      }
    }
  }
  // Among leaves and grass light comes between what is thin, of which the picture shows the front alone.
  bool isThin = (surface.z > 0.0 && surface.z < 1.5) || surface.z > 2.5;
  hidden *= (isThin ? contactThin : 1.0) * seen / max(slices, 1.0);
  // Another process has what is nearer.
  bool isOwn = contactOwnWay(here) <= way;
  gl_FragData[0] = vec4(hidden.w, (contactToWorld * hidden.xyz).xy, isOwn ? way : 0.0);
}
#endif
