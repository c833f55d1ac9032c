  // In parallel projection, as for maps of the sun, what fades is not there.
  float impostorFar = length((impostorToView * vec4(instancePlace.xyz, 1.0)).xyz);
  impostorShownVSOutput = instanceTint.w > 0.0 ? 1.0 : impostorEye.w < 0.5 ? 0.0
    : clamp((impostorFar - impostorFade.x) / max(impostorFade.y - impostorFade.x, 1e-6), 0.0, 1.0);
  vec4 impostorWide = vec4(instanceTint.rgb, abs(instanceTint.w));
  // The eye, or the direction towards it
  vec3 impostorSize = instancePlace.w * vec3(impostorWide.ww, 1.0);
  vec3 impostorSeen = impostorTurned(impostorEye.xyz - impostorEye.w * instancePlace.xyz,
    vec4(-instanceTurn.xyz, instanceTurn.w)) / impostorSize;
  impostorSeen = (impostorSeen - impostorEye.w * impostorSphere.xyz) / impostorSphere.w;
  float impostorAway = length(impostorSeen);
  mat3 impostorFacing = impostorAxes(impostorSeen / impostorAway);
  // A square through the middle that covers the sphere: its outline is at 1 / sqrt(1 - 1 / away^2)
  float impostorHalf = impostorEye.w > 0.5 ? inversesqrt(1.0 - 1.0 / max(impostorAway * impostorAway, 1.44)) : 1.0;
  vec3 impostorAt = impostorHalf * (impostorFacing * vec3(vertexMC.xy, 0.0));
  vec3 impostorTo = impostorEye.w > 0.5 ? impostorAt - impostorSeen : -impostorFacing[2];
  // The triangle of the octahedron's grid that the eye is seen in
  vec3 impostorOn = impostorFacing[2] / dot(abs(impostorFacing[2]), vec3(1.0));
  vec2 impostorOct = impostorOn.z >= 0.0 ? impostorOn.xy : (1.0 - abs(impostorOn.yx)) * impostorSigns(impostorOn.xy);
  float impostorCells = 0.5 * (impostorGrid.x - 1.0);
  vec2 impostorCell = min(floor(impostorCells * abs(impostorOct)), impostorCells - 1.0);
  vec2 impostorIn = impostorCells * abs(impostorOct) - impostorCell;
  bool impostorIsOuter = impostorIn.x + impostorIn.y > 1.0;
  impostorShareVSOutput = impostorIsOuter
    ? vec3(impostorIn.x + impostorIn.y - 1.0, 1.0 - impostorIn.y, 1.0 - impostorIn.x)
    : vec3(1.0 - impostorIn.x - impostorIn.y, impostorIn.x, impostorIn.y);
  vec2 impostorCorners[3] = vec2[3](vec2(impostorIsOuter ? 1.0 : 0.0), vec2(1.0, 0.0), vec2(0.0, 1.0));
  for (int k = 0; k < 3; ++k)
  {
    vec2 o = impostorSigns(impostorOct) * (impostorCell + impostorCorners[k]) / impostorCells;
    impostorTileVSOutput[k] = impostorCells * (1.0 + o);
    vec3 n = vec3(o, 1.0 - abs(o.x) - abs(o.y));
    mat3 axes = impostorAxes(normalize(n.z >= 0.0 ? n : vec3((1.0 - abs(o.yx)) * impostorSigns(o), n.z)));
    impostorAtVSOutput[k] = impostorAt * axes;
    impostorToVSOutput[k] = impostorTo * axes;
  }
  // Texels along a pixel
  float impostorMetres = impostorEye.w > 0.5 ? impostorAway * impostorSphere.w : 1.0 / instancePlace.w;
  float impostorStep = impostorPixel * impostorMetres / impostorSphere.w;
  impostorLevelVSOutput = max(0.0, log2(0.5 * impostorGrid.y * impostorStep));
  impostorTurnVSOutput = instanceTurn;
  impostorTintVSOutput = impostorWide;
  vec3 impostorCorner = impostorSphere.xyz + impostorSphere.w * impostorAt;
  vec3 impostorMC = instancePlace.xyz + impostorTurned(impostorSize * impostorCorner, instanceTurn);
  vec3 impostorLine = impostorTurned(impostorSize * impostorSphere.w * impostorTo, instanceTurn);
  impostorAtViewVSOutput = (impostorToView * vec4(impostorMC, 1.0)).xyz;
  impostorToViewVSOutput = mat3(impostorToView) * impostorLine;
  gl_Position = impostorShownVSOutput > 0.0 ? impostorToClip * vec4(impostorAtViewVSOutput, 1.0) : vec4(vec3(2.0), 1.0);
