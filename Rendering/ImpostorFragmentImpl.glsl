  // A pattern of pixels, of which the others have the plant in full (Jimenez, Next generation post processing, 2014)
  float impostorPattern = fract(dot(floor(gl_FragCoord.xy), vec2(0.06711056, 0.00583715)));
  if (impostorShownVSOutput <= fract(52.9829189 * impostorPattern)) discard;
  // Where the line of sight meets what each frame shows: its depths tried until they agree
  vec3 impostorAlbedo = vec3(0.0), impostorNormal = vec3(0.0);
  float impostorCovered = 0.0, impostorWay = 0.0, impostorMaterial = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    float share = impostorShareVSOutput[k];
    if (share < 0.01) continue;
    vec3 at = impostorAtVSOutput[k], to = impostorToVSOutput[k];
    float way = -at.z / to.z;
    vec4 form;
    vec2 texel;
    for (int step_ = 0; step_ < 3; ++step_)
    {
      texel = impostorTexel(at.xy + way * to.xy, impostorTileVSOutput[k]);
      form = textureLod(impostorForms, texel, impostorLevelVSOutput);
      way = (2.0 * form.a - 1.0 - at.z) / to.z;
    }
    vec4 color = textureLod(impostorColors, texel, impostorLevelVSOutput);
    share *= color.a;
    impostorCovered += share;
    impostorAlbedo += share * color.rgb;
    impostorNormal += share * (2.0 * form.rgb - 1.0);
    impostorMaterial += share * textureLod(impostorLeaves, texel, impostorLevelVSOutput).r;
    impostorWay += share * way;
  }
  if (impostorCovered < 0.5) discard;
  // Maps of the sun, whose projection is parallel, begin a little behind, so that leaves do not shade themselves.
  const float behind = 0.0156;
  impostorWay += impostorToClip[2][3] > -0.5 ? behind * impostorCovered : 0.0;
  impostorMaterial /= impostorCovered;
  vec4 impostorTurn = impostorTurnVSOutput;
  vec3 impostorN = impostorNormal / vec3(impostorTintVSOutput.ww, 1.0);
  impostorN += 2.0 * cross(impostorTurn.xyz, cross(impostorTurn.xyz, impostorN) + impostorTurn.w * impostorN);
  vec3 normalVCVSOutput = normalize(impostorToNormal * impostorN);
  // Leaves have the tint of their plant, wood has not
  vec3 impostorTint = impostorMaterial > 0.0 ? impostorTintVSOutput.rgb : vec3(1.0);
  diffuseColor = min(vec3(1.0), impostorTint * impostorCode(impostorAlbedo / impostorCovered));
  ambientColor = vec3(0.0);
  opacity = 1.0;
  vec4 impostorClip = impostorToClip *
    vec4(impostorAtViewVSOutput + impostorWay / impostorCovered * impostorToViewVSOutput, 1.0);
  gl_FragDepth = 0.5 + 0.5 * impostorClip.z / impostorClip.w;
  float landscapeOwnW = impostorClip.w;
  float landscapeAgreed = min(1.0, length(impostorNormal) / impostorCovered);
#define landscapeMaterial impostorMaterial
