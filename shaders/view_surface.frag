#version 300 es
// The viewer's G-buffer: one RGBA32F texel has all that later passes need (see view_camera.glsl). A cutting plane may
// remove everything in front of it. If the first remaining surface is an inside, the line of sight entered the solid
// through the cut. The pass then writes the cut, which caps a closed solid's section.
precision highp float;
precision highp int;        // the defaults are mediump and lowp, for which Mesa takes 16 bits
precision highp sampler2D;

#include "packed_colour.glsl"

in vec3 v_position;
in vec3 v_normal;
in float v_heat;
in vec3 v_colour;

uniform int u_isColoured;  // 1: the heat is the surface's colour (packed_colour.glsl)
uniform int u_isCut;
uniform vec4 u_cut;        // view space: a unit normal and the plane's position along it; everything beyond is cut away
uniform float u_distance;  // eye to target, mm

layout(location = 0) out vec4 o_surface;  // normal towards the eye; z, mm

void main() {
  float lengthSquared = dot(v_normal, v_normal);
  vec3 normal = lengthSquared > 1e-12 ? v_normal * inversesqrt(lengthSquared) : vec3(0.0, 0.0, 1.0);
  float heat = u_isColoured == 1 ? packedColour(v_colour) : clamp(v_heat, 0.0, 1.0);
  o_surface = vec4(gl_FrontFacing ? normal * (1.0 + heat) : -0.5 * normal, v_position.z);
  if (u_isCut == 0) return;
  if (dot(u_cut.xyz, v_position) > u_cut.w) discard;
  vec3 eye = vec3(0.0, 0.0, u_distance);
  float before = dot(u_cut.xyz, eye) - u_cut.w;
  if (gl_FrontFacing || before <= 0.0) return;
  vec3 sight = v_position - eye;
  o_surface = vec4(0.7 * u_cut.xyz, eye.z + sight.z * before / -dot(u_cut.xyz, sight));
}
