#version 300 es
// Luminance of matte material under a uniform sky, linear, 1 = unoccluded.
//
// Light that bounces inside a pocket brightens it. A point that sees the sky in a share V of its directions sees
// material in the rest; taking that material to be as bright as the point itself gives L = V + albedo·(1 - V)·L, exact
// for a spherical cavity [integrating sphere], and too bright by up to 0.05 for the floor of a trench as deep as wide.
precision highp float;

uniform sampler2D u_visibility;
uniform float u_albedo;

layout(location = 0) out vec4 o_luminance;

void main() {
  float visibility = texelFetch(u_visibility, ivec2(gl_FragCoord.xy), 0).r;
  o_luminance = vec4(visibility / (1.0 - u_albedo * (1.0 - visibility)), 0.0, 0.0, 1.0);
}
