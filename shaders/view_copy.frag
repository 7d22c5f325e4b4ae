#version 300 es
// Copies a finished picture, scaled to the canvas.
precision highp float;
precision highp int;        // the defaults are mediump and lowp, for which Mesa takes 16 bits
precision highp sampler2D;

uniform sampler2D u_picture;
uniform vec2 u_canvas;  // pixels

layout(location = 0) out vec4 o_colour;

void main() {
  o_colour = texture(u_picture, gl_FragCoord.xy / u_canvas);
}
