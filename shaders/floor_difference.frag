#version 300 es
// Compares the measured light of each floor with the light that a plane would give it.
precision highp float;
precision highp int;        // the defaults are mediump and lowp, for which Mesa takes 16 bits
precision highp sampler2D;

#include "depth_search.glsl"
#include "changed_submodules.glsl"

uniform sampler2D u_luminance;
uniform int u_all;      // 1: all floors were measured; 0: those that are due
uniform int u_isFirst;  // 1: there is no difference to compare with

layout(location = 0) out vec4 o_floor;

void main() {
  ivec2 cell = ivec2(gl_FragCoord.xy);
  vec4 before = texelFetch(u_floors, cell, 0);
  vec4 target = texelFetch(u_targets, cell, 0);
  o_floor = before;
  if (target.a == 0.0 || (u_all == 0 && !isDue(u_floors, cell))) return;
  float seen = texelFetch(u_luminance, cell, 0).r / target.r;
  float difference = darkness(seen) - darkness(skySeen(u_floors, cell, before.r).x);
  o_floor.yz = vec2(difference, u_isFirst == 1 ? 0.0 : abs(difference - before.g));
}
