#version 300 es
// A lamp's shadow map (view_shadow.vert).
//
// Output: height of the lit surface over the window's middle towards the lamp, mm.
precision highp float;

in float v_height;
in float v_beyond;

layout(location = 0) out vec4 o_height;

void main() {
  if (v_beyond > 0.0) discard;
  o_height = vec4(v_height, 0.0, 0.0, 1.0);
}
