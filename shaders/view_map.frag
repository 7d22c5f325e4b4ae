#version 300 es
// A map of the engraving in colours for the inspector: normals as red, green, blue, values on a scale from dark blue
// over green to yellow. What lies outside the model is dark grey.
precision highp float;

uniform highp sampler2D u_map;
uniform int u_isNormal;     // 1: first three components are a unit vector
uniform int u_component;    // of a value: 0 … 3
uniform int u_hasSurface;   // 1: texels whose first three components are zero are outside the model
uniform int u_topFirst;     // 1: row 0 of the map is the upper one
uniform vec2 u_range;       // values at the ends of the scale
uniform vec2 u_size;        // of the picture, pixels

layout(location = 0) out vec4 o_colour;

const vec3 kScale[5] = vec3[5](vec3(0.10, 0.06, 0.30), vec3(0.13, 0.33, 0.56), vec3(0.10, 0.56, 0.52),
                               vec3(0.48, 0.78, 0.30), vec3(0.99, 0.92, 0.24));

vec3 onScale(float t) {
  float scaled = clamp(t, 0.0, 1.0) * 4.0;
  int segment = min(int(scaled), 3);
  return mix(kScale[segment], kScale[segment + 1], scaled - float(segment));
}

void main() {
  vec2 at = gl_FragCoord.xy / u_size;
  if (u_topFirst == 1) at.y = 1.0 - at.y;
  vec4 texel = texture(u_map, at);
  bool outside = u_hasSurface == 1 && dot(texel.xyz, texel.xyz) < 0.25;
  float value = u_component == 0 ? texel.r : u_component == 1 ? texel.g : u_component == 2 ? texel.b : texel.a;
  vec3 colour = u_isNormal == 1 ? 0.5 + 0.5 * texel.xyz : onScale((value - u_range.x) / (u_range.y - u_range.x));
  o_colour = vec4(outside ? vec3(0.16) : colour, 1.0);
}
