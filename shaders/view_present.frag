#version 300 es
// The finished picture onto the canvas: sRGB's gamma, and noise of half a grey level against bands in the background.
precision highp float;

uniform highp sampler2D u_colour;  // linear
uniform vec2 u_canvas;             // pixels

layout(location = 0) out vec4 o_colour;

float noise(vec2 pixel) {
  return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715)))) - 0.5;
}

void main() {
  vec3 linear = clamp(texture(u_colour, gl_FragCoord.xy / u_canvas).rgb, 0.0, 1.0);
  vec3 low = linear * 12.92;
  vec3 high = 1.055 * pow(max(linear, 1e-6), vec3(1.0 / 2.4)) - 0.055;
  vec3 encoded = mix(high, low, vec3(lessThan(linear, vec3(0.0031308))));
  o_colour = vec4(encoded + noise(gl_FragCoord.xy) / 255.0, 1.0);
}
