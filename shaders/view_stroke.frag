#version 300 es
// A stroke over the presented picture, with soft edges. What the model hides of it is faint.
//
// Output: sRGB colour times alpha, and alpha.
precision highp float;
precision highp int;        // the defaults are mediump and lowp, for which Mesa takes 16 bits
precision highp sampler2D;

#include "view_camera.glsl"
#include "view_sight.glsl"

in vec3 v_position;  // view space
in vec3 v_colour;
in vec4 v_place;     // see view_stroke.vert
flat in float v_isDot;

uniform float u_halo;         // pixels; 0: the stroke itself
uniform vec4 u_haloColour;    // sRGB colour, opacity

layout(location = 0) out vec4 o_colour;

const float kHidden = 0.3;    // opacity of what the model hides
const float kOnSurface = 3.0; // strokes this near to the surface are not hidden, in pixels at the target

void main() {
  vec3 place = v_place.xyz / v_place.w;
  float fromMiddle = v_isDot > 0.5 ? length(place.xy) : abs(place.y);
  float covered = clamp(place.z - fromMiddle + 0.5, 0.0, 1.0);
  Sight sight = sightThrough(gl_FragCoord.xy);
  bool isHidden = sight.isSolid && sight.position.z > v_position.z + kOnSurface * u_pixelMm;
  vec4 colour = u_halo > 0.0 ? u_haloColour : vec4(v_colour, 1.0);
  float alpha = covered * colour.a * (isHidden ? (u_halo > 0.0 ? 0.0 : kHidden) : 1.0);
  o_colour = vec4(colour.rgb * alpha, alpha);
}
