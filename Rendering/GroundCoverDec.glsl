// The shader of blades of grass (GroundCover): declarations.
in vec2 coverFoot;            // in its tile, from 0 to 1
uniform sampler2D coverGround; // depths of the ground, seen from the zenith
uniform float coverTexel;      // side of a texel of them [m]
uniform vec3 coverToMap;       // from places to the map, by x, y and z
uniform vec3 coverCorner;      // place of the anchor on the map
uniform vec3 coverEye;         // relative to the anchor [m]
uniform vec3 coverAnchor;      // modulo the period of the noise [m]
uniform float coverSide;       // of the tile [m]
uniform float coverFrom;       // distances of the first and the last blades [m]
uniform float coverReach;
uniform float coverTop;        // height of the eye over the ground from which there are none [m]
uniform float coverHeight;     // [m]
uniform vec3 coverPatches;     // size of the noise that says where there are some [m], and the values from where to where
uniform int coverSized;        // 1: sizes are metres, else parts of the height of the grass
uniform float coverLevel;      // of the sea above the anchor [m]; far below without one
