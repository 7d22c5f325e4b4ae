#version 300 es
// The viewer's G-buffer: one RGBA32F texel says all that the later passes need (see view_camera.glsl). A plane may cut
// away what lies before it. Where the first thing left is the surface's inside, the line of sight entered the solid
// through the cut: that is what is written, and the section of a closed solid is capped.
precision highp float;

in vec3 v_position;
in vec3 v_normal;
in float v_heat;

uniform int u_isCut;
uniform vec4 u_cut;        // view space: a unit normal and where along it the plane lies; what lies beyond is cut away
uniform float u_distance;  // eye to target, mm

layout(location = 0) out vec4 o_surface;  // normal towards the eye; z, mm

void main() {
  float lengthSquared = dot(v_normal, v_normal);
  vec3 normal = lengthSquared > 1e-12 ? v_normal * inversesqrt(lengthSquared) : vec3(0.0, 0.0, 1.0);
  o_surface = vec4(gl_FrontFacing ? normal * (1.0 + clamp(v_heat, 0.0, 1.0)) : -0.5 * normal, v_position.z);
  if (u_isCut == 0) return;
  if (dot(u_cut.xyz, v_position) > u_cut.w) discard;
  vec3 eye = vec3(0.0, 0.0, u_distance);
  float before = dot(u_cut.xyz, eye) - u_cut.w;
  if (gl_FrontFacing || before <= 0.0) return;
  vec3 sight = v_position - eye;
  o_surface = vec4(0.7 * u_cut.xyz, eye.z + sight.z * before / -dot(u_cut.xyz, sight));
}
