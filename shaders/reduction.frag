#version 300 es
// Mean over the computed texels of each cell: one output texel a cell.
precision highp float;
precision highp int;        // the defaults are mediump and lowp, for which Mesa takes 16 bits
precision highp sampler2D;

flat in ivec2 v_entry;

uniform sampler2D u_map;
uniform int u_computedTexels;  // along a cell's edge

layout(location = 0) out vec4 o_mean;

void main() {
  vec4 sum = vec4(0.0);
  for (int y = 0; y < u_computedTexels; ++y)
    for (int x = 0; x < u_computedTexels; ++x) sum += texelFetch(u_map, v_entry * u_computedTexels + ivec2(x, y), 0);
  o_mean = sum / float(u_computedTexels * u_computedTexels);
}
