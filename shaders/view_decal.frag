#version 300 es
// Draws a code as a decal on the surface, by the central projection from the reader's eye [Papp 2022, §3], and marks
// the parts of its square that miss the surface. Drawn over the presented picture, so that a code may follow the
// pointer while the picture stays the same.
//
// Output: sRGB colour times alpha, and alpha.
//
// Software renderers run both sides of every `if` for every pixel, so no `if` here could save time.
precision highp float;
precision highp int;        // the defaults are mediump and lowp, for which Mesa takes 16 bits
precision highp sampler2D;

#include "view_camera.glsl"
#include "view_sight.glsl"
#include "srgb.glsl"

uniform highp sampler2D u_colour;  // linear; alpha: luminance of the light on the surface
uniform vec3 u_accent;             // outline
uniform vec3 u_warn;               // parts of the square that miss the surface
uniform vec3 u_paperColour;        // linear
uniform vec3 u_inkColour;          // linear
uniform float u_paper;             // opacity of paper, outline and warnings: 1, or 0: ink alone

// A square picture over a QR plane, in view space, and the map of the surface that its eye sees.
uniform vec3 u_centre, u_right, u_up, u_normal;
uniform float u_eyeDistance;  // mm
uniform float u_edge;         // of the picture on the plane, mm
uniform float u_strength;     // 0 … 1
uniform vec2 u_turn;          // cosine and sine: angle of the picture in the map
uniform float u_window;       // edge of the map on the plane, mm; 0: no map, the eye sees everything
uniform sampler2D u_ink;      // red: 1 = ink; green: the same in the light of lamps; row 0 = top
uniform float u_isUnderLamps;  // 1: lamps light the surface, 0: the viewer's own lights
uniform highp sampler2D u_reach;  // height over the plane, 1 = part of the surface about the centre, slope along right
                                  // and up

layout(location = 0) out vec4 o_colour;

const float kMostHeight = 0.75;  // greatest height of a surface that takes a decal, in decal edges

// Returns the position in the map, in texels, of a point on the plane.
vec2 inMap(vec2 onPlane, float texels) {
  vec2 turned = vec2(onPlane.x * u_turn.x - onPlane.y * u_turn.y, onPlane.x * u_turn.y + onPlane.y * u_turn.x);
  return (turned / u_window + 0.5) * texels;
}

// Returns the weighted fraction of the four nearest texels that belong to the surface around the centre.
float reached(vec2 at, int texels) {
  ivec2 last = ivec2(texels - 1);
  vec2 from = floor(at - 0.5);
  vec2 part = at - 0.5 - from;
  ivec2 low = clamp(ivec2(from), ivec2(0), last), high = clamp(ivec2(from) + 1, ivec2(0), last);
  return mix(mix(texelFetch(u_reach, low, 0).g, texelFetch(u_reach, ivec2(high.x, low.y), 0).g, part.x),
             mix(texelFetch(u_reach, ivec2(low.x, high.y), 0).g, texelFetch(u_reach, high, 0).g, part.x), part.y);
}

// Returns true if nothing blocks the line from the eye to a point of that height.
bool isSeen(vec2 at, int texels, float height) {
  ivec2 texel = clamp(ivec2(at), ivec2(0), ivec2(texels - 1));
  vec4 surface = texelFetch(u_reach, texel, 0);
  float texelMm = u_window / float(texels);
  vec2 off = (at - vec2(texel) - 0.5) * texelMm;
  return height > surface.r + dot(surface.ba, off) - (1.0 + length(surface.ba)) * texelMm;
}

float inkAt(vec2 onPlane, vec2 dx, vec2 dy) {
  vec2 at = vec2(0.5) + vec2(onPlane.x, -onPlane.y) / u_edge;
  vec2 x = vec2(dx.x, -dx.y) / (16.0 * u_edge), y = vec2(dy.x, -dy.y) / (16.0 * u_edge);
  // Each row and column of an 8 × 8 grid over the pixel occurs once.
  vec2 ink = textureLod(u_ink, at - 7.0 * x - y, 0.0).rg + textureLod(u_ink, at - 5.0 * x + 5.0 * y, 0.0).rg +
             textureLod(u_ink, at - 3.0 * x - 5.0 * y, 0.0).rg + textureLod(u_ink, at - x + y, 0.0).rg +
             textureLod(u_ink, at + x + 7.0 * y, 0.0).rg + textureLod(u_ink, at + 3.0 * x - 3.0 * y, 0.0).rg +
             textureLod(u_ink, at + 5.0 * x + 3.0 * y, 0.0).rg + textureLod(u_ink, at + 7.0 * x - 7.0 * y, 0.0).rg;
  return mix(ink.r, ink.g, u_isUnderLamps) / 8.0;
}

// Returns 1 in the dark halves of diagonal stripes.
float stripes(vec2 onPlane) {
  float across = (onPlane.x + onPlane.y) / (0.06 * u_edge);
  float soft = fwidth(across);
  return smoothstep(0.25 - soft, 0.25 + soft, abs(fract(across) - 0.5));
}

// Returns the fraction of the pixel inside the square, and in its outline.
vec2 inSquare(vec2 onPlane, vec2 dx, vec2 dy) {
  float pixel = max(1e-6, max(length(dx), length(dy)));
  float beyond = (max(abs(onPlane.x), abs(onPlane.y)) - 0.5 * u_edge) / pixel;
  float inside = pixel > u_edge ? 0.0 : clamp(0.5 - beyond, 0.0, 1.0);  // 0 where the plane is seen edge-on
  bool isGrazed = pixel > 0.02 * u_edge;  // a contour of the surface, where pixels cover too much to tell
  return vec2(inside, isGrazed ? 0.0 : clamp(2.5 - beyond, 0.0, 1.0) - inside);
}

// Puts a layer over the previous ones; linear colours times alpha.
vec4 over(vec4 below, vec3 colour, float alpha) {
  return below * (1.0 - alpha) + vec4(colour * alpha, alpha);
}

vec4 onSurface(Sight sight, float light, int texels) {
  vec3 fromCentre = sight.position - u_centre;
  float height = dot(fromCentre, u_normal);
  vec2 onPlane = vec2(dot(fromCentre, u_right), dot(fromCentre, u_up)) * (u_eyeDistance / (u_eyeDistance - height));
  vec2 dx = dFdx(onPlane), dy = dFdy(onPlane);
  vec2 square = inSquare(onPlane, dx, dy) * u_strength;
  float striped = stripes(onPlane);
  vec3 toReader = u_centre + u_normal * u_eyeDistance - sight.position;
  vec2 at = u_window > 0.0 ? inMap(onPlane, float(texels)) : vec2(0.5);
  bool takesPrint = sight.isFront && abs(height) < kMostHeight * u_edge && dot(sight.normal, toReader) > 0.0 &&
                    (u_window == 0.0 || isSeen(at, texels, height));
  float held = u_window > 0.0 ? smoothstep(0.35, 0.65, reached(at, texels)) : 1.0;
  float ink = inkAt(onPlane, dx, dy);
  float printed = held * mix(ink, 1.0, u_paper);
  vec3 code = mix(u_inkColour, mix(u_paperColour, u_inkColour, ink), u_paper) * light;
  float warned = u_paper * (1.0 - held) * (0.35 + 0.45 * striped);
  vec4 inside = vec4(printed * code + warned * u_warn * max(light, 0.4), printed + warned);
  return takesPrint ? over(inside * square.x, mix(u_warn, u_accent, held), u_paper * square.y) : vec4(0.0);
}

// Draws the square on the QR plane where no surface below could take the decal.
float overhang(Sight sight, int texels) {
  vec3 eye = vec3(0.0, 0.0, u_distance);
  float slant = dot(sight.direction, u_normal);
  vec3 met = eye + sight.direction * (dot(u_centre - eye, u_normal) / (abs(slant) > 1e-4 ? slant : 1e-4));
  vec2 onPlane = vec2(dot(met - u_centre, u_right), dot(met - u_centre, u_up));
  vec2 square = inSquare(onPlane, dFdx(onPlane), dFdy(onPlane));
  float striped = stripes(onPlane);
  float held = u_window > 0.0 ? smoothstep(0.35, 0.65, reached(inMap(onPlane, float(texels)), texels)) : 1.0;
  bool isBehind = (sight.isSolid && met.z < sight.position.z) || met.z > u_distance;
  return isBehind ? 0.0 : u_paper * (1.0 - held) * square.x * u_strength * (0.25 + 0.45 * striped);
}

void main() {
  Sight sight = sightThrough(gl_FragCoord.xy);
  int texels = textureSize(u_reach, 0).x;
  float light = texture(u_colour, gl_FragCoord.xy / u_canvas).a;
  vec4 decal = over(onSurface(sight, light, texels), u_warn, overhang(sight, texels));
  o_colour = vec4(srgbOf(decal.rgb / max(decal.a, 1e-3)) * decal.a, decal.a);
}
