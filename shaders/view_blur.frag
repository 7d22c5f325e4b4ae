#version 300 es
// Smooths the occlusion of view_hbao.frag: the mean over a 4×4 block, all directions of its pattern, of similar depth.
//
// Output: visibility of the sky.
precision highp float;
precision highp int;        // the defaults are mediump and lowp, for which Mesa takes 16 bits
precision highp sampler2D;

#include "view_camera.glsl"

uniform highp sampler2D u_visibility;  // sky visibility, z / u_unit
uniform float u_unit;                  // mm
uniform float u_reach;                 // neighbours within this difference of z count, mm

layout(location = 0) out vec4 o_visibility;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy), last = ivec2(u_size) - 1;
  float z = texelFetch(u_surface, pixel, 0).w;
  float sum = 0.0;
  float weights = 1e-6;
  for (int y = -2; y < 2; ++y) {
    for (int x = -2; x < 2; ++x) {
      vec2 found = texelFetch(u_visibility, clamp(pixel + ivec2(x, y), ivec2(0), last), 0).rg;
      float weight = max(0.0, 1.0 - abs(found.g * u_unit - z) / u_reach);
      sum += weight * found.r;
      weights += weight;
    }
  }
  o_visibility = vec4(sum / weights, 0.0, 0.0, 1.0);
}
