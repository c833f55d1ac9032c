//VTK::System::Dec
// The light of the surfaces that were drawn before, once a pixel, and the sky where there are none.
in vec2 texCoord;
uniform sampler2D landscapeAlbedo;  // outputs of SurfacePass
uniform sampler2D landscapeSurface;
uniform sampler2D landscapeDepth;
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

void main()
{
  vec4 surface = texture(landscapeSurface, texCoord);
  float depth = texture(landscapeDepth, texCoord).r;
  vec3 code = texture(landscapeAlbedo, texCoord).rgb;
  // The line of sight, from the middle of its part that is shown
  vec3 sight = landscapePlace(0.5);
  vec3 eye = landscapeEyeOf(sight);
  vec3 color = code;
  if (surface.z < -1.5)
  {
    if (landscapeBackground == 0) discard;
    depth = 0.9999999; // drawn, for who composes pictures by their depths
    vec3 d = normalize(landscapeToWorld * (landscapeIsParallel == 1 ? vec3(0.0, 0.0, -1.0) : sight));
    vec3 luminance = landscapeBeyond(d);
    // The disk of 0.53 degrees has the luminance E / solid angle.
    float fromSun = acos(clamp(dot(d, landscapeSun), -1.0, 1.0));
    luminance += d.z > 0.0 ? smoothstep(0.00475, 0.00455, fromSun) * landscapeSunLight / 6.8e-5 : vec3(0.0);
    vec4 clouds = landscapeCloudsIn(d);
    color = landscapeDisplayed(mix(luminance, clouds.rgb, clouds.w));
  }
  else if (surface.z > -0.5)
  {
    // In perspective w of the clip coordinates is the distance along the view's axis, more exact than the depth.
    vec3 place = landscapeIsParallel == 1 ? landscapePlace(depth) : sight * (surface.w / -sight.z);
    vec3 normal = landscapeUnfolded(surface.xy);
    vec3 albedo = landscapeLinear(code);
    float transmittance = surface.z;
    if (surface.z > 2.5)
    {
      vec4 growth = landscapeGrowth((landscapeEye + landscapeToWorld * place).xy);
      albedo *= landscapeCoverColor * growth.rgb;
      transmittance = 0.4;
    }
    else if (surface.z > 1.5)
    {
      vec3 up = landscapeToWorld * normal;
      float footprint = landscapePixel * (landscapeIsParallel == 1 ? 1.0 : -place.z) / max(0.2, abs(normal.z));
      albedo = landscapeGround(albedo, (landscapeEye + landscapeToWorld * place).xy, footprint, up);
      normal = up * landscapeToWorld;
      transmittance = 0.0;
    }
    color = landscapeLit(albedo, eye, place, normal, transmittance);
  }
  gl_FragData[0] = vec4(color, 1.0);
  gl_FragDepth = depth;
}
