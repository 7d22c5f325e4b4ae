#version 300 es
// Mean over the texels of each cell: one output texel a cell.
precision highp float;

uniform sampler2D u_map;
uniform int u_cellTexels;

layout(location = 0) out vec4 o_mean;

void main() {
  ivec2 first = ivec2(gl_FragCoord.xy) * u_cellTexels;
  vec4 sum = vec4(0.0);
  for (int y = 0; y < u_cellTexels; ++y)
    for (int x = 0; x < u_cellTexels; ++x) sum += texelFetch(u_map, first + ivec2(x, y), 0);
  o_mean = sum / float(u_cellTexels * u_cellTexels);
}
