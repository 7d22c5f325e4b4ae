#version 300 es
// Horizon of the uncarved surface, near and far, on a coarse grid of points, so that the march in hbao.frag need
// not find it again. Sixteen directions a point, in four texels side by side. To their right, a texel a point for the
// lamps: the edge of a shadow would be lost between directions.
//
// Output: cotangents of the angle between the line of sight and the horizon in four directions, turning anticlockwise,
// or towards the lamps.
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
uniform int u_lampCount;
uniform vec4 u_lamps[2];             // unit vector to the lamp, strength

const float kGrowthToLamp = 1.02;  // but at least a cell: a narrow part of the model has a dark shadow

layout(location = 0) out vec4 o_cotangents;

float horizonCotangent(vec2 start, vec3 along, vec3 origin, SightFrame sight, float lowest, float growth, float leastStep) {
  vec2 direction = onPlane(along, sight.ray);
  float highest = lowest;
  float distance = u_startTexels;
  for (int i = 0; i < 1024; ++i, distance = max(distance * growth, distance + leastStep)) {
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
  int samples = int(u_horizonSamples);
  bool isOfLamps = pixel.x >= 4 * samples;
  int column = isOfLamps ? pixel.x - 4 * samples : pixel.x >> 2;
  vec2 texel = floor((vec2(column, pixel.y) + 0.5) * u_mapTexels / u_horizonSamples) + 0.5;
  vec4 surface = texelFetch(u_surface, ivec2(texel), 0);
  if (!isModel(surface)) {
    o_cotangents = vec4(-kSteepest);
    return;
  }
  SightFrame sight = sightFrame(texel);
  vec3 origin = engravedPoint(surface, 0.0, texel, texel);
  vec4 cotangents = vec4(-kSteepest);
  for (int i = 0; i < 4; ++i) {
    if (isOfLamps && i >= u_lampCount) break;
    vec3 along = isOfLamps ? acrossTo(u_lamps[i & 1].xyz, sight)
                           : directionAcross(sight, float(4 * (pixel.x & 3) + i) * kPi / 8.0);
    // Each texel of a place faces a lamp by itself, so the place's own plane must not hide the lamp.
    cotangents[i] = isOfLamps
        ? horizonCotangent(texel, along, origin, sight, -kSteepest, kGrowthToLamp, u_cellTexels)
        : horizonCotangent(texel, along, origin, sight, tangentCotangent(surface.xyz, along, sight.toEye), kGrowth, 0.0);
  }
  o_cotangents = cotangents;  // WebGL allows only constant indices into an output
}
