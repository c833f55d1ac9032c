//VTK::System::Dec
// A lit picture of four pixels to one.
in vec2 texCoord;
uniform sampler2D landscapeLit;
uniform sampler2D landscapeDepth;
//VTK::Output::Dec

void main()
{
  vec4 lit = texture(landscapeLit, texCoord);
  if (lit.a <= 0.0) discard; // nothing, and no background
  gl_FragData[0] = vec4(lit.rgb / lit.a, 1.0);
  gl_FragDepth = texture(landscapeDepth, texCoord).r;
}
