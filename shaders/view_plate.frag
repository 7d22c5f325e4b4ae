#version 300 es
// The printer's plate over the presented picture: thin lines every 10 mm, fading out around the model's footprint and
// where they would lie too densely. The model hides the plate.
//
// Output: sRGB colour times alpha, and alpha.
precision highp float;
precision highp int;        // the defaults are mediump and lowp, for which Mesa takes 16 bits
precision highp sampler2D;

#include "view_camera.glsl"
#include "view_sight.glsl"

in vec2 v_onPlate;   // mm from the centre of the footprint
in vec3 v_position;  // view space

uniform vec2 u_half;     // half edges of the footprint, mm
uniform float u_fade;    // width of the margin around it, mm
uniform vec4 u_line;     // sRGB colour, opacity
uniform vec4 u_ground;   // sRGB colour and opacity between the lines

layout(location = 0) out vec4 o_colour;

const float kPitchMm = 10.0;
const float kMajorMm = 100.0;
const float kMinorShare = 0.6;   // opacity of the lines in between
const float kSparsePx = 14.0;    // lines farther apart than this are fully visible,
const float kDensePx = 4.0;      // nearer ones than this not at all

// Returns the coverage of the pixel by lines of that pitch, in both directions.
float lines(float pitch, vec2 pixelMm) {
  vec2 fromLine = abs(fract(v_onPlate / pitch + 0.5) - 0.5) * pitch / pixelMm;
  vec2 covered = clamp(1.1 - fromLine, 0.0, 1.0) * smoothstep(kDensePx, kSparsePx, pitch / pixelMm);
  return max(covered.x, covered.y);
}

void main() {
  Sight sight = sightThrough(gl_FragCoord.xy);
  vec2 pixelMm = max(fwidth(v_onPlate), vec2(1e-6));
  float line = max(kMinorShare * lines(kPitchMm, pixelMm), lines(kMajorMm, pixelMm));
  vec2 beyond = max(abs(v_onPlate) - u_half, vec2(0.0)) / u_fade;
  float fade = 1.0 - smoothstep(0.0, 1.0, length(beyond));
  bool isHidden = sight.isSolid && sight.position.z > v_position.z;
  float ground = u_ground.a * (1.0 - line * u_line.a);
  float alpha = (line * u_line.a + ground) * fade;
  vec3 colour = (u_line.rgb * (line * u_line.a) + u_ground.rgb * ground) * fade;
  o_colour = isHidden ? vec4(0.0) : vec4(colour, alpha);
}
