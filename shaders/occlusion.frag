#version 300 es
// Horizon-based ambient occlusion of the engraved surface [Bavoil 2008; Papp 2022, §7], cosine-weighted
// [Jimenez 2016].
//
// Because every wall runs along a ray from the eye, the engraved surface is the distance map plus the depth of the cell
// a texel lies in: single-valued along the rays, so what lies below the horizon of a slice through the eye is blocked,
// and the horizon integral is the sky visibility itself. The march goes from cell border to cell border, where the
// walls stand, so no step is too long.
//
// Output: share of a uniform sky, cosine-weighted, that reaches the texel; 1 = unoccluded plane.
precision highp float;

#include "distance_map.glsl"

uniform int u_slices;          // half-planes pairs through the line of sight
uniform float u_radiusTexels;  // reach of the march
uniform float u_highestMm;     // no point of the map lies higher over the QR plane
uniform int u_rotate;          // 1: texels of each 4×4 block take turned slices, so that a block's mean has 16 times as many

layout(location = 0) out vec4 o_visibility;

const float kPi = 3.14159265359;

// Cosine of the greatest horizon angle's complement seen from `origin` along `step` (texel units, unit length).
float horizonCosine(vec2 start, vec2 direction, vec3 origin, vec3 toEye, float lowest) {
  float highest = lowest;
  float rise = max(u_highestMm - origin.z, 0.0);
  float lean = max(dot(toEye.xy, direction), 0.0);
  vec2 forward = sign(direction);
  vec2 perBorder = u_cellTexels / max(abs(direction), vec2(1e-6));
  vec2 cell = floor(start / u_cellTexels);
  vec2 border = (cell + max(forward, 0.0)) * u_cellTexels;
  vec2 next = abs(border - start) / max(abs(direction), vec2(1e-6));
  for (int i = 0; i < 256; ++i) {
    float travelled = min(next.x, next.y);
    if (travelled > u_radiusTexels) break;
    // Could even the map's highest point raise the horizon from here? (0.9: the surface lies nearer than the plane.)
    float reach = 0.9 * travelled * u_texelMm;
    if ((rise * toEye.z + reach * lean) * inversesqrt(rise * rise + reach * reach) <= highest) break;
    next += perBorder * vec2(lessThanEqual(next, vec2(travelled)));
    vec2 point = start + direction * travelled;
    vec2 owner = point + direction * 1e-3 + forward * 1e-3;
    if (!isInside(owner)) break;
    vec4 surface = texelFetch(u_surface, ivec2(owner), 0);
    if (!isModel(surface)) continue;
    vec3 towards = engravedPoint(surface, carvedDepth(owner), owner, point) - origin;
    highest = max(highest, dot(towards, toEye) * inversesqrt(dot(towards, towards)));
  }
  return highest;
}

// Cosine-weighted visibility of one side of a slice: angles from the line of sight; gamma = the normal's.
float visibleArc(float horizon, float gamma) {
  return 0.25 * (-cos(2.0 * horizon - gamma) + cos(gamma) + 2.0 * horizon * sin(gamma));
}

void main() {
  vec2 texel = gl_FragCoord.xy;
  vec4 surface = texelFetch(u_surface, ivec2(texel), 0);
  if (!isModel(surface)) {
    o_visibility = vec4(1.0);
    return;
  }
  vec3 ray = rayThrough(texel);
  vec3 origin = engravedPoint(surface, carvedDepth(texel), texel, texel);
  vec3 toEye = -normalize(ray);
  vec3 side = normalize(cross(vec3(0.0, 1.0, 0.0), toEye));
  vec3 upward = cross(toEye, side);

  ivec2 inBlock = ivec2(texel) & 3;
  float turn = u_rotate == 1 ? (float(inBlock.x + 4 * inBlock.y) + 0.5) / 16.0 : 0.5;
  float visibility = 0.0;
  for (int i = 0; i < u_slices; ++i) {
    float angle = (float(i) + turn) * kPi / float(u_slices);
    vec3 along = side * cos(angle) + upward * sin(angle);  // unit, square to the line of sight
    // The slice meets the QR plane in the line along which a point moving by `along` is projected.
    vec2 direction = normalize(along.xy * u_eyeDistance + ray.xy * along.z);
    float normalLength = length(vec2(dot(surface.xyz, along), dot(surface.xyz, toEye)));
    float gamma = atan(dot(surface.xyz, along), dot(surface.xyz, toEye));
    // Below the tangent plane nothing counts: that is the lowest horizon.
    float ahead = horizonCosine(texel, direction, origin, toEye, cos(min(gamma + 0.5 * kPi, kPi)));
    float behind = horizonCosine(texel, -direction, origin, toEye, cos(max(gamma - 0.5 * kPi, -kPi)));
    visibility += normalLength * (visibleArc(acos(clamp(ahead, -1.0, 1.0)), gamma) + visibleArc(-acos(clamp(behind, -1.0, 1.0)), gamma));
  }
  o_visibility = vec4(visibility / float(u_slices), 0.0, 0.0, 1.0);
}
