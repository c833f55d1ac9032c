// The shader of impostors (ImpostorQuads): declarations of the fragments.
#define LandscapeOwnPlace
in vec3 impostorAtVSOutput[3];
in vec3 impostorToVSOutput[3];
in vec3 impostorAtViewVSOutput;
in vec3 impostorToViewVSOutput;
flat in vec2 impostorTileVSOutput[3];
flat in vec3 impostorShareVSOutput;
flat in float impostorLevelVSOutput;
flat in float impostorShownVSOutput;
flat in vec4 impostorTurnVSOutput;
flat in vec4 impostorTintVSOutput;
uniform mat4 impostorToClip;
uniform mat3 impostorToNormal;      // from directions of the anchor's axes to normals of the view
uniform vec2 impostorGrid;
uniform sampler2D impostorColors;   // textures of ImpostorAtlas
uniform sampler2D impostorForms;
uniform sampler2D impostorLeaves;

// Texture coordinates of a place in a frame's axes.
vec2 impostorTexel(vec2 at, vec2 tile)
{
  float edge = 0.5 * exp2(ceil(impostorLevelVSOutput)) / impostorGrid.y;
  return (tile + clamp(0.5 + 0.5 * at, edge, 1.0 - edge)) / impostorGrid.x;
}

// The display's code of a linear color  (IEC 61966-2-1)
vec3 impostorCode(vec3 c)
{
  return mix(12.92 * c, 1.055 * pow(max(c, vec3(1e-6)), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}
