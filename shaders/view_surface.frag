#version 300 es
// The viewer's G-buffer: one RGBA32F texel says all that the later passes need (see view_camera.glsl).
precision highp float;

in vec3 v_position;
in vec3 v_normal;
in float v_heat;

layout(location = 0) out vec4 o_surface;  // normal towards the eye; z, mm

void main() {
  float lengthSquared = dot(v_normal, v_normal);
  vec3 normal = lengthSquared > 1e-12 ? v_normal * inversesqrt(lengthSquared) : vec3(0.0, 0.0, 1.0);
  o_surface = vec4(gl_FrontFacing ? normal * (1.0 + clamp(v_heat, 0.0, 1.0)) : -0.5 * normal, v_position.z);
}
