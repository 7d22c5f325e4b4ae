#version 300 es
// Central projection of the model from the reader's eye [Papp 2022, §3].
//
// View space: origin at the eye, x right, y up, z towards the reader, mm. The QR plane is z = -u_eyeDistance.
precision highp float;

layout(location = 0) in vec3 a_position;  // model space, mm, relative to u_origin's origin
layout(location = 1) in vec3 a_normal;    // model space, unit

uniform vec3 u_right;
uniform vec3 u_up;
uniform vec3 u_normal;
uniform vec3 u_centre;        // the code's centre, in the same coordinates as a_position
uniform float u_eyeDistance;  // mm
uniform float u_extent;       // edge of the square on the QR plane that fills the viewport, mm
uniform vec2 u_depthRange;    // near and far distance along the axis, mm

out vec3 v_position;  // relative to the code's centre, axes of view space, mm: preserves float precision
out vec3 v_normal;    // view space

void main() {
  vec3 fromCentre = a_position - u_centre;
  v_position = vec3(dot(fromCentre, u_right), dot(fromCentre, u_up), dot(fromCentre, u_normal));
  v_normal = vec3(dot(a_normal, u_right), dot(a_normal, u_up), dot(a_normal, u_normal));
  float w = u_eyeDistance - v_position.z;
  float zScale = (u_depthRange.y + u_depthRange.x) / (u_depthRange.y - u_depthRange.x);
  float zShift = -2.0 * u_depthRange.x * u_depthRange.y / (u_depthRange.y - u_depthRange.x);
  gl_Position = vec4(v_position.xy * (2.0 * u_eyeDistance / u_extent), w * zScale + zShift, w);
}
