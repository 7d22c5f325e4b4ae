#version 300 es
// One rectangle for each run of listed cells of the map, so that a pass costs only what is carved.
precision highp float;

layout(location = 0) in vec4 a_cells;  // column, row from the map's lower left, columns, rows

uniform float u_cellsAlongEdge;

void main() {
  vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1));
  gl_Position = vec4(2.0 * (a_cells.xy + corner * a_cells.zw) / u_cellsAlongEdge - 1.0, 0.0, 1.0);
}
