//VTK::System::Dec
// The light of one kind of pixels, LandscapePart. A processor that draws takes the time of all branches of a shader, but
// none for pixels of another depth: the kinds are depths first, and each is drawn at its own.
#define LandscapeKinds 0   // the kinds
#define LandscapeSky 1     // where nothing is
#define LandscapeSurface 2 // surfaces of their own colors, and what no light changes
#define LandscapeGround 3  // ground and what grows on it
#define LandscapeAbove 4   // water seen from above, and what is in it
#define LandscapeBelow 5   // what an eye in water sees in it
#define LandscapeOver 6    // the surface of the water above such an eye
#define LandscapeOpen 7    // water alone before such an eye, and what no light changes
#define LandscapeShown 8   // what is lit, with the depths of surfaces
#define LandscapeFringe 9  // surfaces, with crowns on ridges
#define LandscapeShafts 10 // shafts of light before what an eye in water sees, of each landscapeStep-th pixel

in vec2 texCoord;
uniform sampler2D landscapeDrawn;   // of the kinds before
uniform sampler2D landscapeAlbedo;  // outputs of SurfacePass
uniform sampler2D landscapeSurface;
uniform sampler2D landscapeDepth;
uniform sampler2D landscapeWetColor; // the same of surfaces of water; there it is as SurfacePass tells
uniform sampler2D landscapeWetSurface;
uniform sampler2D landscapeWetDepth;
uniform mat4 landscapeToView;       // from clip coordinates
uniform vec3 landscapeEye;          // place of the eye in the world, modulo the period of noise [m]
uniform vec2 landscapeWideEye;      // the same modulo that of woods [m]
uniform vec3 landscapeCoverColor;   // albedo of grass
uniform vec2 landscapeTurf;         // height of grass, and distance of its last blades [m]
uniform float landscapePixel;       // side of a pixel, in perspective at a distance of 1 [m]
uniform int landscapeBackground;    // 1: sky behind the surfaces
//VTK::Landscape::Dec
//VTK::Output::Dec

const float landscapeRiverDepth = 0.8;  // of the bed of rivers, which is drawn by no data [m]
const float landscapeRiverCalm = 0.3;   // slopes over those at sea, where the wind has a fetch
const float landscapeRiverSlack = 0.002; // of the distance, by which ground may hide a river
const float landscapeWetGround = 0.5;    // luminance of wet ground, over that of dry one  (Lekner and Dorf 1988)

vec3 landscapePlace(float depth)
{
  vec4 place = landscapeToView * vec4(2.0 * vec3(texCoord, depth) - 1.0, 1.0);
  return place.xyz / place.w;
}

// Luminance of the sky, the sun and clouds in a direction.
vec3 landscapeBehindAll(vec3 d)
{
  vec3 luminance = landscapeBeyond(d);
  // The disk of 0.53 degrees has the luminance E / solid angle.
  float fromSun = acos(clamp(dot(d, landscapeSun), -1.0, 1.0));
  luminance += d.z > 0.0 ? smoothstep(0.00475, 0.00455, fromSun) * landscapeSunLight / 6.8e-5 : vec3(0.0);
  vec4 clouds = landscapeCloudsIn(d, 0.0);
  return landscapeBehindFog(mix(luminance, clouds.rgb, clouds.w), d);
}

// Albedo of a ground in a direction, whose normal gets its relief, or of grass.
#if LandscapePart == LandscapeGround || (LandscapePart == LandscapeAbove && LandscapeHasShore)
vec3 landscapeGrown(bool isGrass, vec3 albedo, vec3 d, vec3 place, inout vec3 normal)
{
  vec3 off = landscapeToWorld * place;
  vec2 at = landscapeEye.xy + off.xy;
  if (isGrass)
  {
    normal *= sign((landscapeToWorld * normal).z); // VTK turns it to the eye, which may be below
    return albedo * landscapeCoverColor * landscapeGrowth(at).rgb;
  }
  vec3 up = landscapeToWorld * normal;
#ifdef LandscapeHasTurf
  // Beyond the blades what grows still stands, and hides the ground where it is seen at a flat angle.
  float away = landscapePixel * (landscapeIsParallel == 1 ? 1.0 : -place.z);
  float flatness = -dot(d, up);
  float stands = smoothstep(0.6, 1.0, length(off) / landscapeTurf.y) * clamp(2.0 - 4.0 * away, 0.0, 1.0) *
    smoothstep(0.6, 0.3, flatness) * smoothstep(0.7, 0.8, up.z);
  vec3 turf = stands > 0.0 ? landscapeTurfOn(at, landscapeTurf.x / max(flatness, 0.05) * d.xy) : vec3(0.0);
  at += stands * turf.xy;
#endif
  float footprint = landscapePixel * (landscapeIsParallel == 1 ? 1.0 : -place.z) /
    sqrt(max(0.04, abs(normal.z))); // sharper than its length: what grows stands up
#ifdef LandscapeHasWoods
  vec3 smoothed = up;
  float moist = smoothstep(1.7, 2.4, albedo.g / max(albedo.r, 1e-3)); // lush grass of GroundColor
#endif
  albedo = landscapeGround(albedo, at, footprint, up);
#ifdef LandscapeHasTurf
  // Bright at its tips, dark between them, and as bright as the ground on average
  albedo *= mix(1.0, 0.3 + 1.35 * turf.z, stands * (1.0 - landscapeGrowth(at).w));
#endif
#ifdef LandscapeHasWoods
  vec3 level = smoothed;
  float width = landscapePixel * (landscapeIsParallel == 1 ? 1.0 : -place.z);
  albedo = landscapeWooded(albedo, moist, at, landscapeWideEye + off.xy, d, width, smoothed);
  up = normalize(up + smoothed - level);
#endif
  normal = up * landscapeToWorld;
  return albedo;
}
#endif

// Place of a surface along a line of sight: in perspective w of the clip coordinates, of what has one, is the distance
// along the view's axis, more exact than the depth.
vec3 landscapePlaceOf(float depth, float w, vec3 sight)
{
  return landscapeIsParallel == 1 || w <= 0.0 ? landscapePlace(depth) : sight * (w / -sight.z);
}

#ifdef LandscapeHasContact
uniform sampler2D landscapeContact;   // of ContactShade
uniform float landscapeContactRadius; // [m]
uniform int landscapeContactStep;     // pixels from one that it tells of to the next

// What is hidden near by: the mean of the four pixels around that it tells of, which have other directions each, but for
// those off the plane; where all are, the nearest to it.
vec3 landscapeContactAt(vec3 place, vec3 normal)
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  ivec2 first = (pixel + landscapeContactStep - 1) / landscapeContactStep - 1;
  ivec2 end = textureSize(landscapeContact, 0) - 1;
  vec2 line_ = landscapeIsParallel == 1 ? place.xy : -place.xy / place.z;
  vec4 sum = vec4(0.0);
  for (int k = 0; k < 4; ++k)
  {
    ivec2 at = clamp(first + ivec2(k & 1, k >> 1), ivec2(0), end);
    vec4 near = texelFetch(landscapeContact, at, 0);
    float scale = landscapeIsParallel == 1 ? 1.0 : near.w;
    vec2 off = vec2(landscapeContactStep * at - pixel);
    vec3 there = vec3(scale * (line_ + landscapePixel * off), -near.w);
    float high = abs(dot(there - place, normal)) / (0.1 * landscapeContactRadius);
    sum += max(1.0 - high, 1e-4 / (1.0 + high)) * vec4(near.xyz, 1.0);
  }
  return sum.xyz / sum.w;
}
#endif

#if LandscapePart == LandscapeAbove || LandscapePart == LandscapeBelow
// Luminance of what is in the water, of the albedo of its data.
vec3 landscapeWetLuminance(float material, vec3 albedo, vec3 place, vec3 normal)
{
  bool isGrass = material > 2.5;
  return landscapeWet(isGrass ? albedo * landscapeCoverColor : albedo, place, normal,
    isGrass ? 0.4 : material > 1.5 ? 0.0 : max(material, 0.0));
}
#endif

#if LandscapePart == LandscapeBelow || LandscapePart == LandscapeOver || LandscapePart == LandscapeOpen
#ifdef LandscapeHasShafts
uniform sampler2D landscapeShaftsBefore; // of LandscapeShafts, and the lengths of the lines of sight [m]
uniform int landscapeStep;               // pixels from one that has them to the next

// Shafts before a line of sight of a length: the mean of the four pixels around that have them, which sample other parts
// of their lines each, but for those of lines of other lengths; where all are, the most like it.
vec3 landscapeShaftsAt(float way)
{
  ivec2 first = (ivec2(gl_FragCoord.xy) + landscapeStep - 1) / landscapeStep - 1;
  ivec2 end = textureSize(landscapeShaftsBefore, 0) - 1;
  vec4 sum = vec4(0.0);
  for (int k = 0; k < 4; ++k)
  {
    vec4 near = texelFetch(landscapeShaftsBefore, clamp(first + ivec2(k & 1, k >> 1), ivec2(0), end), 0);
    float off = abs(near.w - way) / (0.1 * way);
    sum += max(1.0 - off, 1e-4 / (1.0 + off)) * vec4(near.rgb, 1.0);
  }
  return sum.rgb / sum.w;
}
#endif

// Luminance at the end of a line of sight from an eye in water.
vec3 landscapeSeenInWater(vec3 luminance, vec3 d, float way)
{
  luminance = landscapeInWater(luminance, d, landscapeEyeDepth, way);
#ifdef LandscapeHasShafts
  luminance += landscapeShaftsAt(way);
#endif
  return luminance;
}
#endif

#ifdef LandscapeHasLens
// Luminance that the display shows as a code: landscapeDisplayed backwards.
vec3 landscapeOfCode(vec3 code)
{
  vec3 c = landscapeLinear(code);
  if (landscapeFilmCurve == 1)
  {
    // (A x2 + C B x + D E) / (A x2 + B x + D F) = y, with the constants of the film's curve
    const float A = 0.22, B = 0.30, C = 0.10, D = 0.20, E = 0.01, F = 0.30, W = 11.2;
    float white = (W * (A * W + C * B) + D * E) / (W * (A * W + B) + D * F) - E / F;
    vec3 y = c * white + E / F;
    vec3 a = A * (1.0 - y), b = B * (C - y), d = D * (E - F * y);
    c = 0.25 * (sqrt(max(b * b - 4.0 * a * d, 0.0)) - b) / a;
  }
  return c / landscapeExposure;
}
#endif

#if LandscapePart == LandscapeShown && defined(LandscapeHasLens)
uniform sampler2D landscapeBlurred; // of Lens
uniform int landscapeSamples;       // along a side of a pixel

// What the display shows of a sample behind the lens: in focus what it is without it, else what is blurred; where taps
// lie apart, with those of its neighbours.
vec3 landscapeBehindLens(ivec2 at)
{
  ivec2 end = textureSize(landscapeBlurred, 0) - 1;
  float soft = texelFetch(landscapeBlurred, at, 0).a;
  vec4 sum = vec4(0.0);
  for (int k = 0; k < 9; ++k)
  {
    ivec2 off = ivec2(k % 3, k / 3) - 1;
    vec4 near = texelFetch(landscapeBlurred, clamp(at + off, ivec2(0), end), 0);
    float weight = (2.0 - abs(off.x)) * (2.0 - abs(off.y)) * clamp(0.25 * near.a - 1.0, 0.0, 1.0);
    sum += (k == 4 ? 4.0 : weight) * vec4(near.rgb, 1.0);
  }
  vec3 sharp = texelFetch(landscapeDrawn, at, 0).rgb;
  return landscapeDisplayed(mix(sharp, sum.rgb / sum.w, smoothstep(0.5, 1.0, soft)));
}

// The mean of the samples' codes, as without the lens.
vec3 landscapeBehindLens()
{
  ivec2 first = landscapeSamples * ivec2(texCoord * vec2(textureSize(landscapeDrawn, 0) / landscapeSamples));
  vec3 sum = vec3(0.0);
  for (int k = 0; k < landscapeSamples * landscapeSamples; ++k)
  {
    sum += landscapeBehindLens(first + ivec2(k % landscapeSamples, k / landscapeSamples));
  }
  return sum / float(landscapeSamples * landscapeSamples);
}
#endif

//VTK::Fringe::Dec
void main()
{
  vec4 surface = texture(landscapeSurface, texCoord);
  float depth = texture(landscapeDepth, texCoord).r;
#if LandscapePart == LandscapeFringe
  vec4 drawn = texture(landscapeAlbedo, texCoord);
  landscapeRaise(drawn, surface, depth);
  gl_FragData[0] = drawn;
  gl_FragData[1] = surface;
  gl_FragDepth = depth;
#else
  bool isThere = surface.z > -1.5;
#if LandscapeHasWater && LandscapePart != LandscapeBelow && LandscapePart != LandscapeOpen
  // Water before all else. The ground that a river lies on is coarser than its bands, and may be before it by a little.
  vec4 wet = texture(landscapeWetSurface, texCoord);
  float wetDepth = texture(landscapeWetDepth, texCoord).r;
  bool isRiver = wet.z > 4.5;
  // Below water the surfaces are those of all processes, of which others may be before it; its kind is told already.
  bool hasSurface = wet.z > -0.5 && (wetDepth < depth || LandscapePart == LandscapeAbove ||
    (isRiver && landscapeIsParallel == 0 && wet.w < (1.0 + landscapeRiverSlack) * surface.w));
  float shown = hasSurface ? wetDepth : depth;
  float wayOfWater = -landscapePlaceOf(wetDepth, wet.w, landscapePlace(0.5)).z;
#else
  const float wayOfWater = 0.0;
  const bool hasSurface = false;
  float shown = depth;
#endif
#if LandscapePart == LandscapeKinds
  int kind = hasSurface ? LandscapeAbove : !isThere ? LandscapeSky
    : surface.z > 1.5 && surface.z < 3.5 ? LandscapeGround : LandscapeSurface;
  int below = hasSurface ? LandscapeOver : surface.z > -0.5 ? LandscapeBelow : LandscapeOpen;
  gl_FragDepth = float(landscapeWater == 2 ? below : kind) / 8.0;
#elif LandscapePart == LandscapeShown
  vec4 drawn = texture(landscapeDrawn, texCoord);
  if (drawn.a <= 0.0) discard; // nothing, and no background
#ifdef LandscapeHasLens
  // Of several processes, those that have the nearest surface show it, or the sky.
  float way = hasSurface ? wayOfWater : -landscapePlaceOf(depth, surface.w, landscapePlace(0.5)).z;
  bool isNearest = isThere || hasSurface ? way <= 1.00001 * drawn.a : landscapeBackground == 1 && drawn.a > 1e8;
  if (!isNearest) discard;
  gl_FragData[0] = vec4(landscapeBehindLens(), 1.0);
#else
#ifdef LandscapeIsShared
  if (!isThere && !hasSurface && landscapeBackground == 0) discard; // what other processes have
#endif
  gl_FragData[0] = vec4(drawn.rgb / drawn.a, 1.0);
#endif
#if LandscapeHasWater
  // The depth of a river is that of the ground that it just hides, also of another process's: z = (f - f n / w) / (f - n)
  float near = -landscapePlace(0.0).z;
  float far = -landscapePlace(1.0).z;
  shown -= hasSurface && isRiver && landscapeIsParallel == 0 ? landscapeRiverSlack * near * far / ((far - near) * wet.w) : 0.0;
#endif
  gl_FragDepth = isThere || hasSurface ? shown : 0.9999999; // drawn, for who composes pictures by their depths
#else
  // The line of sight, from the middle of its part that is shown
  vec3 sight = landscapePlace(0.5);
  vec3 eye = landscapeEyeOf(sight);
  vec3 d = normalize(landscapeToWorld * (landscapeIsParallel == 1 ? vec3(0.0, 0.0, -1.0) : sight));
  vec4 texel = texture(landscapeAlbedo, texCoord);
  vec3 code = texel.rgb;
  vec3 place = landscapePlaceOf(depth, surface.w, sight);
  vec3 normal = landscapeUnfolded(surface.xy);
  bool isLit = surface.z > -0.5;
#ifdef LandscapeHasContact
  landscapeHidden = landscapeContactAt(place, normal);
#endif
  vec3 luminance = vec3(0.0);
#if LandscapePart == LandscapeSky
  luminance = landscapeBehindAll(d);
#elif LandscapePart == LandscapeSurface
  vec3 albedo = landscapeLinear(code);
  float transmittance = max(surface.z, 0.0);
#ifdef LandscapeHasBark
  if (isLit && surface.z < -0.1)
  {
    vec3 barked = landscapeToWorld * normal;
    float away = landscapePixel * (landscapeIsParallel == 1 ? 1.0 : -place.z);
    albedo = landscapeBark(albedo, landscapeEye + landscapeToWorld * place, away, barked);
    normal = barked * landscapeToWorld;
  }
#endif
#if LandscapeIsWet
  float film = surface.z > 0.0 ? 0.5 * landscapeWetness : landscapeWetness; // in drops on leaves
  luminance = landscapeMoist(landscapeWetness, film, false, albedo, d, place, normal, landscapeToWorld * normal,
    transmittance, 2.0 * texel.a - 1.0);
#else
  luminance = landscapeLuminance(albedo, place, normal, transmittance, 2.0 * texel.a - 1.0);
#endif
  luminance = landscapeBehindAir(luminance, eye, place);
#elif LandscapePart == LandscapeGround
  bool isGrass = surface.z > 2.5;
  vec3 smoothed = normal;
  vec3 albedo = landscapeGrown(isGrass, landscapeLinear(code), d, place, normal);
#if LandscapeIsWet || LandscapeHasShore
  vec2 at = (landscapeEye + landscapeToWorld * place).xy;
  float away = landscapePixel * (landscapeIsParallel == 1 ? 1.0 : -place.z);
  float wetness = landscapeWetness;
  float film = isGrass ? 0.1 * wetness : landscapePuddles(wetness, at, away, landscapeToWorld * smoothed);
#if LandscapeHasShore
  float height = (landscapeToWorld * place).z - landscapeEyeDepth;
  float washed = isGrass ? 0.0 : landscapeShoreWet(height, at);
  wetness = max(wetness, washed);
  film = max(film, washed);
#endif
  luminance = landscapeMoist(wetness, film, !isGrass, albedo, d, place, normal, landscapeFilm(smoothed, normal),
    isGrass ? 0.4 : 0.0, 1.0);
#if LandscapeHasShore
  vec4 surf = landscapeLace(isGrass ? 0.0 : landscapeShoreFoam(height, at), at, away);
  luminance = mix(luminance, landscapeFoamLuminance(surf, place, landscapeToWorld * smoothed), surf.w);
#endif
#else
  luminance = landscapeLuminance(albedo, place, normal, isGrass ? 0.4 : 0.0, 1.0);
#endif
  luminance = landscapeBehindAir(luminance, eye, place);
#elif LandscapePart == LandscapeBelow
  landscapeBelow = landscapeEyeDepth;
  luminance = landscapeWetLuminance(surface.z, landscapeLinear(code), place, normal);
  luminance = landscapeSeenInWater(luminance, d, length(place - eye));
#elif LandscapePart == LandscapeOpen
  landscapeBelow = landscapeEyeDepth;
  luminance = landscapeSeenInWater(vec3(0.0), d, isThere ? length(place - eye) : 1e3);
#elif LandscapePart == LandscapeShafts
  landscapeBelow = landscapeEyeDepth;
  vec3 end = hasSurface ? sight * (wayOfWater / -sight.z) : place;
  float way = isThere || hasSurface ? length(end - eye) : 1e3;
#else
  vec3 wetPlace = landscapePlaceOf(wetDepth, wet.w, sight);
  vec3 wetNormal = landscapeToWorld * landscapeUnfolded(wet.xy);
  wetNormal = normalize(wetNormal.z < 0.0 ? -wetNormal : wetNormal + vec3(0.0, 0.0, 1e-4));
  float wetAway = landscapePixel * (landscapeIsParallel == 1 ? 1.0 : -wetPlace.z);
  float footprint = wetAway / sqrt(sqrt(max(abs(dot(d, wetNormal)), 0.02))); // sharper than its length, which blurs
  vec3 ripples = hasSurface ? landscapeRipples((landscapeToWorld * wetPlace).xy, footprint) : vec3(0.0);
  ripples *= isRiver ? landscapeRiverCalm * vec3(1.0, 1.0, landscapeRiverCalm) : vec3(1.0);
  vec3 rippled = landscapeFacet(wetNormal, ripples.xy);
  // Facets are as large as they look: d n / n_z over that of the mesh, which at its crests turns away
  float side = LandscapePart == LandscapeOver ? 1.0 : -1.0;
  float looks = max(side * dot(d, rippled) * wetNormal.z / rippled.z, 0.05) / max(side * dot(d, wetNormal), 0.05);
  looks = min(looks, 2.0);
  wetNormal = rippled;
#if LandscapePart == LandscapeOver
  landscapeBelow = landscapeEyeDepth;
  luminance = looks * landscapeWaterBelow(d, wetNormal, ripples.z);
  luminance = landscapeSeenInWater(luminance, d, length(wetPlace - eye));
#else
  landscapeBelow = (landscapeToWorld * wetPlace).z;
  vec3 albedo = landscapeLinear(code);
#if LandscapeHasShore
  // Ground in shallow water is as beside it.
  vec3 ground = landscapeToWorld * place;
  float depthBelow = (landscapeToWorld * wetPlace).z - ground.z;
  vec2 groundAt = (landscapeEye + ground).xy;
  bool isShore = surface.z > 1.5 && surface.z < 2.5;
  float shallow = isShore ? 1.0 - smoothstep(2.0 * landscapeRunUp, 5.0 * landscapeRunUp, depthBelow) : 0.0;
  vec3 relief = normal;
  vec3 grown = landscapeGrown(false, albedo, d, place, relief);
  vec3 beside = landscapeMoist(1.0, 1.0, true, grown, d, place, relief, landscapeFilm(normal, relief), 0.0, 1.0);
  albedo = mix(albedo, grown, shallow);
  normal = shallow > 0.0 ? normalize(mix(normal, relief, shallow)) : normal;
#endif
  luminance = isLit ? landscapeWetLuminance(surface.z, albedo, place, normal) : vec3(0.0);
  // L / n2 leaves the water; below it a line of sight is steeper.
  vec3 down = refract(d, wetNormal, 1.0 / landscapeIndex);
  float way = isRiver ? landscapeRiverDepth / -down.z : isThere ? length(place - wetPlace) : 1e3;
  vec3 below = landscapeInWater(isRiver ? landscapeWetGround * luminance : luminance, down, 0.0, way);
  vec4 carried = texture(landscapeWetColor, texCoord);
  landscapeChannel = isRiver && carried.g > 0.002 ? exp2(16.0 * carried.g - 4.0) : 0.0;
  luminance =
    looks * landscapeWaterAbove(d, wetNormal, ripples.z, wetPlace, below / (landscapeIndex * landscapeIndex), footprint);
  float foam = landscapeFoamOf(carried.a);
#if LandscapeHasShore
  luminance = mix(luminance, beside, isShore ? 1.0 - smoothstep(0.0, 0.3 * landscapeRunUp, depthBelow) : 0.0);
  foam = max(foam, isShore ? landscapeShoreFoam(ground.z - landscapeEyeDepth, groundAt) : 0.0);
#endif
  vec2 rest = (landscapeEye + landscapeToWorld * wetPlace).xy - landscapeWayOf(carried.rgb);
  vec4 lace = landscapeLace(foam, rest, footprint);
  landscapeHidden = vec3(0.0);
  // Sedges and mud at the rims of a river, else foam
  vec4 rim = landscapeBank(2.0 * carried.r - 1.0, (landscapeEye + landscapeToWorld * wetPlace).xy);
  rim.w *= clamp(2.0 - wetAway, 0.0, 1.0); // narrower than pixels from afar
  vec4 on = isRiver ? rim : lace;
  vec3 foamed = landscapeFoamLuminance(isRiver ? vec4(0.0, 0.0, 1.0, 0.0) : lace, wetPlace, wetNormal);
  // A rim is foam of its own color.
  luminance = mix(luminance, isRiver ? foamed * rim.rgb / landscapeFoamAlbedo : foamed, on.w);
  luminance = landscapeBehindAir(luminance, eye, wetPlace);
#endif
#endif
  bool isPaint = isThere && !isLit && !hasSurface; // which no light changes
#if LandscapePart == LandscapeShafts
  gl_FragData[0] = vec4(landscapeShafts(d, way), way);
#elif defined(LandscapeHasLens)
#if LandscapePart == LandscapeAbove || LandscapePart == LandscapeOver
  place = hasSurface ? wetPlace : place;
#endif
  float away = isThere || hasSurface ? -place.z : 1e9;
  gl_FragData[0] = vec4(isPaint ? landscapeOfCode(code) : luminance, away);
#else
  gl_FragData[0] = vec4(isPaint ? code : landscapeDisplayed(luminance), 1.0);
#endif
#endif
#endif
}
