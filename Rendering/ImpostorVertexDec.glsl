// The shader of impostors (ImpostorQuads): declarations of the vertices. The axes are those of the plant, lengths its
// radii, places relative to its middle, unless there is another word for them.
in vec4 instancePlace;         // relative to the anchor [m], and scale
in vec4 instanceTurn;          // quaternion x, y, z, w
in vec4 instanceTint;          // and how wide, beside the scale, below 0 if it fades
uniform mat4 impostorToView;   // from places relative to the anchor
uniform vec4 impostorEye;      // place relative to the anchor, and 1; or the direction towards it, and 0
uniform vec4 impostorSphere;   // around the plant, middle and radius [m]
uniform vec2 impostorGrid;     // frames along a side, and texels along a side of a frame
uniform float impostorPixel;   // side of a pixel, in perspective at a distance of 1 [m]
uniform mat4 impostorToClip;   // from the view
uniform vec2 impostorFade;     // distances between which instances that fade appear [m]
out vec3 impostorAtVSOutput[3]; // place on the quad, in the axes of three frames
out vec3 impostorToVSOutput[3]; // line of sight
out vec3 impostorAtViewVSOutput; // both in the view [m]
out vec3 impostorToViewVSOutput;
flat out vec2 impostorTileVSOutput[3]; // columns and rows of the frames
flat out vec3 impostorShareVSOutput;   // of each frame
flat out float impostorLevelVSOutput;  // of the textures
flat out float impostorShownVSOutput;  // part of the pixels that is shown
flat out vec4 impostorTurnVSOutput;
flat out vec4 impostorTintVSOutput;

// v + 2 q x (q x v + w v), of a quaternion q, w.
vec3 impostorTurned(vec3 v, vec4 turn)
{
  return v + 2.0 * cross(turn.xyz, cross(turn.xyz, v) + turn.w * v);
}

vec2 impostorSigns(vec2 v)
{
  return vec2(v.x >= 0.0 ? 1.0 : -1.0, v.y >= 0.0 ? 1.0 : -1.0);
}

// Axes of the picture from a direction: to the right, upward, and the direction.
mat3 impostorAxes(vec3 towards)
{
  vec3 right = normalize(cross(abs(towards.z) < 0.9137 ? vec3(0.0, 0.0, 1.0) : vec3(0.0, 1.0, 0.0), towards));
  return mat3(right, cross(towards, right), towards);
}
