#version 300 es
// Copies a finished picture.
precision highp float;
precision highp int;        // the defaults are mediump and lowp, for which Mesa takes 16 bits
precision highp sampler2D;

uniform sampler2D u_picture;

layout(location = 0) out vec4 o_colour;

void main() {
  o_colour = texelFetch(u_picture, ivec2(gl_FragCoord.xy), 0);
}
