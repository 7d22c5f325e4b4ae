#version 300 es
// Draws the finished picture on the canvas, with the marker; then applies sRGB's transfer curve, and noise of half a
// grey level against bands in the background. Does not draw prints (view_decal.frag).
precision highp float;
precision highp int;        // the defaults are mediump and lowp, for which Mesa takes 16 bits
precision highp sampler2D;

#include "view_camera.glsl"
#include "view_sight.glsl"
#include "srgb.glsl"

uniform highp sampler2D u_colour;  // linear
uniform vec3 u_accent;             // marker
uniform int u_markerShown;
uniform vec3 u_marker;  // view space

layout(location = 0) out vec4 o_colour;

float noise(vec2 pixel) {
  return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715)))) - 0.5;
}

void main() {
  vec3 colour = texture(u_colour, gl_FragCoord.xy / u_canvas).rgb;
  if (u_markerShown == 1) {
    Sight sight = sightThrough(gl_FragCoord.xy);
    float radius = length(sight.position - u_marker) / u_pixelMm;
    if (sight.isSolid && (radius < 3.0 || (radius > 7.0 && radius < 9.5))) colour = u_accent;
  }
  o_colour = vec4(srgbOf(colour) + noise(gl_FragCoord.xy) / 255.0, 1.0);
}
