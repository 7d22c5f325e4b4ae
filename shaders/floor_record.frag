#version 300 es
// Records depth and luminance of the listed floors, packed next to each other.
precision highp float;
precision highp int;        // the defaults are mediump and lowp, for which Mesa takes 16 bits
precision highp sampler2D;

uniform sampler2D u_floors;
uniform sampler2D u_luminance;
uniform sampler2D u_list;  // columns and rows of the floors' cells
uniform int u_firstRow;    // of this record in the target

layout(location = 0) out vec4 o_record;

void main() {
  ivec2 cell = ivec2(texelFetch(u_list, ivec2(gl_FragCoord.xy) - ivec2(0, u_firstRow), 0).xy);
  o_record = vec4(texelFetch(u_floors, cell, 0).r, texelFetch(u_luminance, cell, 0).r, 0.0, 0.0);
}
