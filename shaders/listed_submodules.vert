#version 300 es
// Draws one texel of the map of cells for each listed cell.
precision highp float;

layout(location = 0) in vec4 a_cell;  // column and row from the map's lower left; the same in the computed target

uniform float u_cellsAlongEdge;

flat out ivec2 v_entry;

void main() {
  v_entry = ivec2(a_cell.zw);
  gl_Position = vec4(2.0 * (a_cell.xy + 0.5) / u_cellsAlongEdge - 1.0, 0.0, 1.0);
  gl_PointSize = 1.0;
}
