#version 300 es
// Distance from the eye to the first back-facing facet. Between the front and this distance there is material.
precision highp float;
precision highp int;        // the defaults are mediump and lowp, for which Mesa takes 16 bits
precision highp sampler2D;

in vec3 v_position;  // mm, relative to the code's centre

uniform float u_eyeDistance;

layout(location = 0) out vec4 o_distance;  // mm

void main() {
  o_distance = vec4(length(v_position - vec3(0.0, 0.0, u_eyeDistance)), 0.0, 0.0, 1.0);
}
