#version 300 es
// The model in the viewer's camera (spaces: view_camera.glsl).
precision highp float;

layout(location = 0) in vec3 a_position;  // model space, mm, relative to the mesh's origin
layout(location = 1) in vec3 a_normal;    // model space, unit
layout(location = 2) in float a_heat;     // 0 … 1
layout(location = 3) in vec3 a_colour;    // sRGB

uniform vec3 u_right;
uniform vec3 u_up;
uniform vec3 u_back;
uniform vec3 u_target;      // in the same coordinates as a_position
uniform float u_distance;   // eye to target, mm
uniform vec2 u_tanHalf;
uniform vec2 u_jitter;      // normalised device coordinates
uniform vec2 u_depthRange;  // near and far distance along the line of sight, mm

out vec3 v_position;  // view space
out vec3 v_normal;    // view space
out float v_heat;
out vec3 v_colour;

void main() {
  vec3 fromTarget = a_position - u_target;
  v_position = vec3(dot(fromTarget, u_right), dot(fromTarget, u_up), dot(fromTarget, u_back));
  v_normal = vec3(dot(a_normal, u_right), dot(a_normal, u_up), dot(a_normal, u_back));
  v_heat = a_heat;
  v_colour = a_colour;
  float w = u_distance - v_position.z;
  float zScale = (u_depthRange.y + u_depthRange.x) / (u_depthRange.y - u_depthRange.x);
  float zShift = -2.0 * u_depthRange.x * u_depthRange.y / (u_depthRange.y - u_depthRange.x);
  gl_Position = vec4(v_position.xy / u_tanHalf + u_jitter * w, w * zScale + zShift, w);
}
