#version 300 es
// Horizon of the uncarved surface, near and far, on a coarse grid of points, so that the march in hbao.frag need
// not find it again. Sixteen directions a point, in four texels side by side.
//
// Output: cotangents of the angle between the line of sight and the horizon in four directions, turning anticlockwise.
precision highp float;
precision highp int;        // the defaults are mediump and lowp, for which Mesa takes 16 bits
precision highp sampler2D;

#include "distance_map.glsl"
#include "pi.glsl"

uniform sampler2D u_surroundings;    // a wider, coarser map from the same eye
uniform float u_surroundingsTexels;  // along its edge; 0: there is none
uniform float u_surroundingsTexelMm;
uniform float u_horizonSamples;      // grid points along the edge
uniform float u_startTexels;         // the march covers anything nearer

layout(location = 0) out vec4 o_cotangents;

float horizonCotangent(vec2 start, float angle, vec3 origin, SightFrame sight, vec3 normal) {
  vec3 along = directionAcross(sight, angle);
  vec2 direction = onPlane(along, sight.ray);
  float highest = tangentCotangent(normal, along, sight.toEye);
  float distance = u_startTexels;
  for (int i = 0; i < 128; ++i, distance *= kGrowth) {
    vec2 point = start + direction * distance;
    vec2 middle = floor(point) + 0.5;
    vec4 surface;
    if (isInside(point)) {
      surface = texelFetch(u_surface, ivec2(point), 0);
    } else {
      vec2 owner = floor((point - 0.5 * u_mapTexels) * u_texelMm / u_surroundingsTexelMm + 0.5 * u_surroundingsTexels);
      if (any(lessThan(owner, vec2(0.0))) || any(greaterThanEqual(owner, vec2(u_surroundingsTexels)))) break;
      surface = texelFetch(u_surroundings, ivec2(owner), 0);
      middle = (owner + 0.5 - 0.5 * u_surroundingsTexels) * u_surroundingsTexelMm / u_texelMm + 0.5 * u_mapTexels;
    }
    if (!isModel(surface)) continue;
    vec3 towards = engravedPoint(surface, 0.0, middle, point) - origin;
    float across = dot(towards, along);
    if (across > 0.0) highest = max(highest, dot(towards, sight.toEye) / across);
  }
  return highest;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec2 texel = floor((vec2(pixel.x >> 2, pixel.y) + 0.5) * u_mapTexels / u_horizonSamples) + 0.5;
  vec4 surface = texelFetch(u_surface, ivec2(texel), 0);
  if (!isModel(surface)) {
    o_cotangents = vec4(-kSteepest);
    return;
  }
  SightFrame sight = sightFrame(texel);
  vec3 origin = engravedPoint(surface, 0.0, texel, texel);
  vec4 cotangents;
  for (int i = 0; i < 4; ++i)
    cotangents[i] = horizonCotangent(texel, float(4 * (pixel.x & 3) + i) * kPi / 8.0, origin, sight, surface.xyz);
  o_cotangents = cotangents;  // WebGL allows only constant indices into an output
}
