#version 300 es
// Surface of the model as seen from the reader's eye, texel by texel.
precision highp float;
precision highp int;        // the defaults are mediump and lowp, for which Mesa takes 16 bits
precision highp sampler2D;

in vec3 v_position;  // mm, relative to the code's centre
in vec3 v_normal;

uniform float u_eyeDistance;

layout(location = 0) out vec4 o_surface;  // facet's unit normal (view space), height over the QR plane, mm
layout(location = 1) out vec4 o_smooth;   // interpolated unit normal (view space), distance from the eye, mm

void main() {
  o_surface = vec4(normalize(cross(dFdx(v_position), dFdy(v_position))), v_position.z);
  o_smooth = vec4(normalize(v_normal), length(v_position - vec3(0.0, 0.0, u_eyeDistance)));
}
