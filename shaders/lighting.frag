#version 300 es
// Luminance of matte material under sky and lamps, with light reflected by its surroundings, linear, 1 = an unoccluded
// surface in the QR plane.
precision highp float;
precision highp int;        // the defaults are mediump and lowp, for which Mesa takes 16 bits
precision highp sampler2D;

#include "interreflection.glsl"

uniform sampler2D u_received;  // as written by hbao.frag
uniform float u_albedo;
uniform float u_openIrradiance;  // of sky and lamps in the QR plane

layout(location = 0) out vec4 o_luminance;

void main() {
  vec4 received = texelFetch(u_received, ivec2(gl_FragCoord.xy), 0);
  float luminance = luminanceOf(received.r, received.g, received.b, received.a, u_albedo, u_openIrradiance);
  o_luminance = vec4(luminance, 0.0, 0.0, 1.0);
}
