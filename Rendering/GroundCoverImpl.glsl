  // The copy of the blade that is nearest to the eye, on the ground below it
  vec2 coverAt = coverSide * (coverFoot + floor(coverEye.xy / coverSide - coverFoot + 0.5));
  vec2 coverPlace = coverCorner.xy + coverToMap.xy * coverAt;
  float coverDepth = texture(coverGround, coverPlace).r;
  float coverZ = (coverDepth - coverCorner.z) / coverToMap.z;
  float coverStep = 4.0 * coverTexel;
  vec2 coverNext = coverPlace + coverStep * coverToMap.xy;
  vec2 coverRise = vec2(texture(coverGround, vec2(coverNext.x, coverPlace.y)).r,
    texture(coverGround, vec2(coverPlace.x, coverNext.y)).r) - coverDepth;
  float coverSlope = length(coverRise / coverToMap.z) / coverStep;
  // Lower at the rim, where the ground is bare or steep, and in tufts; none beyond the ground and in the sea
  vec4 coverGrowth = landscapeGrowth(coverAt + coverAnchor.xy);
  float coverTuft = landscapeNoise(coverAt + coverAnchor.xy, 0.5, 7u).x;
  float coverAway = distance(coverAt, coverEye.xy);
  float coverHigh = coverHeight * (1.0 - smoothstep(0.8 * coverReach, coverReach, coverAway)) *
    (coverFrom > 0.0 ? smoothstep(coverFrom, 1.25 * coverFrom, coverAway) : 1.0);
  coverHigh *= coverSized == 1 ? 1.0 / coverHeight : (1.0 - 0.9 * coverGrowth.w) * (0.45 + 0.75 * coverTuft);
  coverHigh *= 1.0 - smoothstep(0.5, 0.9, coverSlope);
  coverHigh *= 1.0 - smoothstep(0.8, 1.0, (coverEye.z - coverZ) / coverTop);
  for (float k = 0.0; k < coverPatches.z; k += 1.0) // a loop that does not begin takes no time
  {
    coverHigh *= smoothstep(coverPatches.y, coverPatches.z, landscapeNoise(coverAt + coverAnchor.xy, coverPatches.x, 8u).x);
  }
  coverHigh *= smoothstep(0.0, 2.0 * coverHeight, coverZ - coverLevel);
  coverHigh *= coverDepth < 0.9999 && coverHigh > 0.03 * coverHeight ? 1.0 : 0.0;
  vec4 coverMC = vec4(coverAt, coverZ, 1.0) + vec4(coverHigh * vertexMC.xyz, 0.0);
  vertexVCVSOutput = MCVCMatrix * coverMC;
  gl_Position = MCDCMatrix * coverMC;
