//VTK::System::Dec
// A lit picture of four pixels to one.
in vec2 texCoord;
uniform sampler2D landscapeLit;
uniform sampler2D landscapeDepth;
//VTK::Output::Dec

void main()
{
  gl_FragData[0] = vec4(texture(landscapeLit, texCoord).rgb, 1.0);
  gl_FragDepth = texture(landscapeDepth, texCoord).r;
}
