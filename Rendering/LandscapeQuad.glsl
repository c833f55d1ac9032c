//VTK::System::Dec
// The light of the surfaces that were drawn before, once a pixel, and the sky where there are none.
in vec2 texCoord;
uniform sampler2D landscapeAlbedo;  // outputs of SurfacePass
uniform sampler2D landscapeSurface;
uniform sampler2D landscapeDepth;
uniform sampler2D landscapeWetColor; // the same of surfaces of water; there alpha is their stretch
uniform sampler2D landscapeWetSurface;
uniform sampler2D landscapeWetDepth;
uniform mat4 landscapeToView;       // from clip coordinates
uniform vec3 landscapeEye;          // place of the eye in the world, modulo the period of noise [m]
uniform vec3 landscapeCoverColor;   // albedo of grass
uniform float landscapePixel;       // side of a pixel, in perspective at a distance of 1 [m]
uniform int landscapeBackground;    // 1: sky behind the surfaces
//VTK::Landscape::Dec
//VTK::Output::Dec

vec3 landscapePlace(float depth)
{
  vec4 place = landscapeToView * vec4(2.0 * vec3(texCoord, depth) - 1.0, 1.0);
  return place.xyz / place.w;
}

// Normal of a place of the unfolded octahedron.
vec3 landscapeUnfolded(vec2 o)
{
  vec3 n = vec3(o, 1.0 - abs(o.x) - abs(o.y));
  vec2 s = vec2(o.x >= 0.0 ? 1.0 : -1.0, o.y >= 0.0 ? 1.0 : -1.0);
  return normalize(n.z >= 0.0 ? n : vec3((1.0 - abs(o.yx)) * s, n.z));
}

// Luminance of the sky, the sun and clouds in a direction.
vec3 landscapeBehindAll(vec3 d)
{
  vec3 luminance = landscapeBeyond(d);
  // The disk of 0.53 degrees has the luminance E / solid angle.
  float fromSun = acos(clamp(dot(d, landscapeSun), -1.0, 1.0));
  luminance += d.z > 0.0 ? smoothstep(0.00475, 0.00455, fromSun) * landscapeSunLight / 6.8e-5 : vec3(0.0);
  vec4 clouds = landscapeCloudsIn(d, 0.0);
  return mix(luminance, clouds.rgb, clouds.w);
}

// Albedo and transmittance of a surface by its material; the normal of a ground gets its relief.
vec4 landscapeMaterialOf(float material, vec3 albedo, vec3 place, inout vec3 normal)
{
  vec2 at = (landscapeEye + landscapeToWorld * place).xy;
  if (material > 2.5)
  {
    normal *= sign((landscapeToWorld * normal).z); // VTK turns it to the eye, which may be below
    return vec4(albedo * landscapeCoverColor * landscapeGrowth(at).rgb, 0.4);
  }
  if (material > 1.5)
  {
    vec3 up = landscapeToWorld * normal;
    float footprint = landscapePixel * (landscapeIsParallel == 1 ? 1.0 : -place.z) / max(0.2, abs(normal.z));
    albedo = landscapeGround(albedo, at, footprint, up);
    normal = up * landscapeToWorld;
    return vec4(albedo, 0.0);
  }
  return vec4(albedo, material);
}

// Place of a surface along a line of sight: in perspective w of the clip coordinates, of what has one, is the distance
// along the view's axis, more exact than the depth.
vec3 landscapePlaceOf(float depth, float w, vec3 sight)
{
  return landscapeIsParallel == 1 || w <= 0.0 ? landscapePlace(depth) : sight * (w / -sight.z);
}

void main()
{
  vec4 surface = texture(landscapeSurface, texCoord);
  float depth = texture(landscapeDepth, texCoord).r;
  vec4 code = texture(landscapeAlbedo, texCoord);
  // The line of sight, from the middle of its part that is shown
  vec3 sight = landscapePlace(0.5);
  vec3 eye = landscapeEyeOf(sight);
  vec3 d = normalize(landscapeToWorld * (landscapeIsParallel == 1 ? vec3(0.0, 0.0, -1.0) : sight));
  bool isThere = surface.z > -1.5;
  bool isLit = surface.z > -0.5;
  vec3 place = landscapePlaceOf(depth, surface.w, sight);
  vec4 wet = landscapeWater > 0 ? texture(landscapeWetSurface, texCoord) : vec4(-2.0);
  float wetDepth = landscapeWater > 0 ? texture(landscapeWetDepth, texCoord).r : 1.0;
  bool hasSurface = wet.z > -0.5 && wetDepth < depth; // of water before all else
  vec3 wetPlace = landscapePlaceOf(wetDepth, wet.w, sight);
  vec3 wetNormal = landscapeToWorld * landscapeUnfolded(wet.xy);
  wetNormal = normalize(wetNormal.z < 0.0 ? -wetNormal : wetNormal + vec3(0.0, 0.0, 1e-4));
  float wetAway = landscapePixel * (landscapeIsParallel == 1 ? 1.0 : -wetPlace.z);
  float footprint = wetAway / sqrt(sqrt(max(abs(dot(d, wetNormal)), 0.02))); // sharper than its length, which blurs
  vec3 ripples = hasSurface ? landscapeRipples((landscapeToWorld * wetPlace).xy, footprint) : vec3(0.0);
  vec3 rippled = landscapeFacet(wetNormal, ripples.xy);
  // Facets are as large as they look: d n / n_z over that of the mesh, which at its crests turns away
  float side = landscapeWater == 2 ? 1.0 : -1.0;
  float looks = max(side * dot(d, rippled) * wetNormal.z / rippled.z, 0.05) / max(side * dot(d, wetNormal), 0.05);
  looks = min(looks, 2.0);
  wetNormal = rippled;
  bool isInWater = landscapeWater == 2 ? !hasSurface : hasSurface;
  if (!isThere && landscapeBackground == 0 && !hasSurface) discard;

  // What is there, in air or in water
  vec3 luminance = vec3(0.0);
  if (isLit)
  {
    vec3 normal = landscapeUnfolded(surface.xy);
    // The bed of water keeps the color of its data.
    float kind = isInWater && surface.z > 1.5 && surface.z < 2.5 ? 0.0 : surface.z;
    vec4 material = landscapeMaterialOf(kind, landscapeLinear(code.rgb), place, normal);
    luminance = isInWater ? landscapeWet(material.rgb, place, normal, material.w)
                          : landscapeLuminance(material.rgb, place, normal, material.w, 2.0 * code.a - 1.0);
  }
  // The water before it, and its surface
  if (landscapeWater == 2)
  {
    float way = hasSurface ? length(wetPlace - eye) : isThere ? length(place - eye) : 1e3;
    luminance = hasSurface ? looks * landscapeWaterBelow(d, wetNormal, ripples.z) : luminance;
    luminance = landscapeInWater(luminance, d, landscapeEyeDepth, way);
    luminance += landscapeHasShafts == 1 ? landscapeShafts(d, way) : vec3(0.0);
  }
  else if (hasSurface)
  {
    // L / n2 leaves the water; below it a line of sight is steeper.
    vec3 down = refract(d, wetNormal, 1.0 / landscapeIndex);
    float way = isThere ? length(place - wetPlace) : 1e3;
    vec3 below = landscapeInWater(luminance, down, landscapeEyeDepth - (landscapeToWorld * wetPlace).z, way);
    luminance = looks * landscapeWaterAbove(d, wetNormal, ripples.z, wetPlace, below / (landscapeIndex * landscapeIndex));
    float foam = landscapeFoam(texture(landscapeWetColor, texCoord).a, (landscapeEye + landscapeToWorld * wetPlace).xy);
    luminance = mix(luminance, landscapeLuminance(vec3(0.6), wetPlace, wetNormal * landscapeToWorld, 0.0, 1.0), foam);
    luminance = landscapeBehindAir(luminance, wetPlace - eye);
  }
  else if (isLit)
  {
    luminance = landscapeBehindAir(luminance, place - eye);
  }
  else if (!isThere)
  {
    luminance = landscapeBehindAll(d);
  }
  bool isPaint = isThere && !isLit && !hasSurface; // which no light changes
  gl_FragData[0] = vec4(isPaint ? code.rgb : landscapeDisplayed(luminance), 1.0);
  gl_FragDepth = hasSurface ? wetDepth : isThere ? depth : 0.9999999; // drawn, for who composes pictures by their depths
}
