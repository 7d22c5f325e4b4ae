#version 300 es
// Horizon-based ambient occlusion in screen space [Bavoil 2008], cosine-weighted [Jimenez 2016]: shades the pockets and
// the folds of a model. Far samples fade out, because the surface behind a silhouette is unknown. Directions turn from
// pixel to pixel and from sample to sample; the viewer averages them.
//
// Output: visibility of the sky (1 = all), z in units of u_radius (which fits half floats) for the blur that follows.
precision highp float;
precision highp int;        // the defaults are mediump and lowp, for which Mesa takes 16 bits
precision highp sampler2D;

#include "view_camera.glsl"
#include "pi.glsl"
#include "visible_arc.glsl"

uniform int u_slices;         // pairs of half-planes through the line of sight
uniform int u_steps;          // on each side of a slice
uniform float u_radius;       // mm
uniform float u_radiusLimit;  // pixels
uniform float u_turn;         // of this sample, sixteenths: 16 samples of one slice give every pixel the same directions
uniform float u_shift;        // of this sample along its directions, in steps

layout(location = 0) out vec4 o_visibility;

// Even 4×4 pattern: the 16 turns of a block are all different, so that a 4×4 mean has 16 times the slices.
float patternTurn(ivec2 pixel) {
  ivec2 p = pixel & 3;
  return (float((p.x * 4 + p.y) * 7 & 15) + 0.5) / 16.0;
}

float horizonCosine(vec2 direction, float radiusPx, float shift, vec3 origin, vec3 toEye, float lowest,
                    float inverseRadiusSquared) {
  float highest = lowest;
  for (int i = 0; i < u_steps; ++i) {
    float t = (float(i) + shift) / float(u_steps);
    vec2 pixel = gl_FragCoord.xy + direction * (1.0 + t * t * t * radiusPx);
    if (any(lessThan(pixel, vec2(0.0))) || any(greaterThanEqual(pixel, u_size))) break;
    vec4 surface = texelFetch(u_surface, ivec2(pixel), 0);
    if (!isSurface(surface.xyz)) continue;
    vec3 towards = positionView(floor(pixel) + 0.5, surface.w) - origin;
    float lengthSquared = dot(towards, towards);
    float near = clamp(1.0 - lengthSquared * inverseRadiusSquared, 0.0, 1.0);
    highest = max(highest, mix(lowest, dot(towards, toEye) * inversesqrt(lengthSquared), near));
  }
  return highest;
}

void main() {
  vec4 surface = texelFetch(u_surface, ivec2(gl_FragCoord.xy), 0);
  if (!isSurface(surface.xyz)) {
    o_visibility = vec4(1.0, 1e4, 0.0, 1.0);
    return;
  }
  vec3 origin = positionView(gl_FragCoord.xy, surface.w);
  vec3 normal = normalize(surface.xyz);
  vec3 toEye = normalize(vec3(0.0, 0.0, u_distance) - origin);
  float pixelsPerMm = u_size.y / (2.0 * u_tanHalf.y * (u_distance - surface.w));
  float radiusPx = min(u_radius * pixelsPerMm, u_radiusLimit);
  float radius = radiusPx / pixelsPerMm;

  float turn = fract(patternTurn(ivec2(gl_FragCoord.xy)) + u_turn);
  float shift = fract(turn * 7.0 + u_shift);  // depends on the direction only, so that the averages of all pixels agree
  float visibility = 0.0;
  for (int slice = 0; slice < u_slices; ++slice) {
    float angle = kPi * (float(slice) + turn) / float(u_slices);
    vec2 direction = vec2(cos(angle), sin(angle));
    vec3 across = vec3(direction, 0.0) - toEye * dot(vec3(direction, 0.0), toEye);
    vec3 axis = normalize(cross(across, toEye));
    vec3 inSlice = normal - axis * dot(normal, axis);
    float fraction = length(inSlice);
    float gamma = sign(dot(across, inSlice)) * acos(clamp(dot(inSlice, toEye) / max(fraction, 1e-4), -1.0, 1.0));
    float ahead = horizonCosine(direction, radiusPx, shift, origin, toEye, cos(gamma + 0.5 * kPi),
                                1.0 / squareOf(radius));
    float behind = horizonCosine(-direction, radiusPx, shift, origin, toEye, cos(gamma - 0.5 * kPi),
                                 1.0 / squareOf(radius));
    float right = gamma + min(acos(clamp(ahead, -1.0, 1.0)) - gamma, 0.5 * kPi);
    float left = gamma + max(-acos(clamp(behind, -1.0, 1.0)) - gamma, -0.5 * kPi);
    visibility += fraction * (visibleArc(right, gamma) + visibleArc(left, gamma));
  }
  o_visibility = vec4(clamp(visibility / float(u_slices), 0.0, 1.0), surface.w / u_radius, 0.0, 1.0);
}
