#version 300 es
// The model as a lamp sees it, by parallel projection onto a square window.
precision highp float;

layout(location = 0) in vec3 a_position;  // model space, mm, relative to the mesh's origin

uniform vec3 u_right;    // axes of the lamp's view, model space
uniform vec3 u_up;
uniform vec3 u_towards;  // the lamp
uniform vec3 u_middle;   // of the window, in the same coordinates as a_position
uniform float u_half;    // half the window's edge, mm
uniform float u_reach;   // no part of the model is farther than this from the window's middle, mm
uniform vec4 u_cut;      // a unit normal (model space) and the plane's position along it; everything beyond is cut away

out float v_height;
out float v_beyond;  // the cut, mm

void main() {
  vec3 fromMiddle = a_position - u_middle;
  v_height = dot(fromMiddle, u_towards);
  v_beyond = dot(a_position, u_cut.xyz) - u_cut.w;
  gl_Position = vec4(dot(fromMiddle, u_right) / u_half, dot(fromMiddle, u_up) / u_half, -v_height / u_reach, 1.0);
}
