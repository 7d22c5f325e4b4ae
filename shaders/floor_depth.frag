#version 300 es
// Moves each floor to its solution. Once depths may only grow, a floor moves if it is too bright, or if deeper
// neighbours are expected to make it so.
precision highp float;
precision highp int;        // the defaults are mediump and lowp, for which Mesa takes 16 bits
precision highp sampler2D;

#include "depth_search.glsl"

uniform sampler2D u_solved;
uniform sampler2D u_luminance;
uniform int u_isFree;  // 1: depths may rise and fall
uniform float u_leastGrowthMm;  // of a floor that is too bright

layout(location = 0) out vec4 o_floor;

void main() {
  ivec2 cell = ivec2(gl_FragCoord.xy);
  vec4 before = texelFetch(u_floors, cell, 0);
  vec4 target = texelFetch(u_targets, cell, 0);
  float depth = before.r;
  if (target.a > 0.0) {
    float next = quantisedDepth(max(texelFetch(u_solved, cell, 0).r, u_quantum.x), target.b);
    if (u_isFree == 1)
      depth = next;
    else if (texelFetch(u_luminance, cell, 0).r > target.g * target.r)
      depth = quantisedDepth(max(next, depth + u_leastGrowthMm), target.b);
    else if (next > depth && darkness(skySeen(u_solved, cell, depth).x) + before.g < darkness(target.g))
      depth = next;
  }
  o_floor = vec4(depth, before.gb, depth == before.r ? 0.0 : 1.0);
}
