#version 300 es
// HBAO: horizon-based ambient occlusion of the engraved surface [Bavoil 2008; Papp 2022, §7], cosine-weighted [Jimenez 2016].
//
// Because every wall runs along a ray from the eye, the engraved surface is the distance map plus the depth of each
// texel's cell: single-valued along the rays. So everything below the horizon of a slice through the eye is blocked,
// and the horizon integral is the sky visibility itself. The march goes from cell border to cell border, where the
// walls are, so no step is too long.
//
// Computed texels lie side by side without gaps, whichever cells are listed: u_computedTexels² texels of each cell,
// with as many entries in a row as the map has cells.
//
// Output: fraction of a uniform sky, cosine-weighted, that reaches the texel, 1 = unoccluded plane; the same if only
// the walls of pockets occluded; irradiance by the lamps, 1 = the whole sky's; the same before anything was carved.
precision highp float;
precision highp int;        // the defaults are mediump and lowp, for which Mesa takes 16 bits
precision highp sampler2D;

#include "distance_map.glsl"
#include "changed_submodules.glsl"
#include "pi.glsl"
#include "visible_arc.glsl"

uniform sampler2D u_horizon;       // of the uncarved surface (horizon.frag)
uniform float u_horizonSamples;    // places along its edge
uniform int u_slices;              // pairs of half-planes through the line of sight
uniform float u_radiusTexels;      // reach of the march
uniform float u_everyBorderTexels;  // up to here the march stops at every border, beyond it at growing steps
uniform float u_reliefMm;          // depth carved into u_surface itself, in addition to u_depth
uniform int u_turnSlices;          // 1: texels of a 4×4 block turn them, so that its mean has 16 times as many
uniform int u_computedTexels;      // texels along a cell's edge that are computed
uniform int u_stride;              // distance between computed texels, texels
uniform float u_cellsPerPixel;     // 1 / u_computedTexels
uniform sampler2D u_list;          // columns and rows of the listed cells
uniform int u_listed;              // how many there are; 0: all
uniform int u_onlyDue;             // 1: of these, only floors that are due; u_depth then holds floors (depth_search.glsl)

uniform int u_lampCount;
uniform vec4 u_lamps[2];           // unit vector to the lamp, strength

layout(location = 0) out vec4 o_received;

// Returns the cotangent of the angle between the line of sight and the uncarved surface's horizon.
float horizonOfSurface(vec2 texel, float angle) {
  ivec2 place = ivec2(texel * u_horizonSamples / u_mapTexels);
  float sector = mod(angle * 8.0 / kPi, 16.0);
  int from = int(sector);
  int to = (from + 1) & 15;
  float first = texelFetch(u_horizon, ivec2(4 * place.x + (from >> 2), place.y), 0)[from & 3];
  float second = texelFetch(u_horizon, ivec2(4 * place.x + (to >> 2), place.y), 0)[to & 3];
  return mix(first, second, fract(sector));
}

// Returns the same towards a lamp.
float horizonToLamp(vec2 texel, int lamp) {
  ivec2 place = ivec2(texel * u_horizonSamples / u_mapTexels);
  return texelFetch(u_horizon, ivec2(4 * int(u_horizonSamples) + place.x, place.y), 0)[lamp];
}

// A march from cell border to cell border.
struct March {
  vec2 start;
  vec2 direction;
  vec2 forward;
  vec2 perBorder;
  vec2 next;  // distance to the next border across columns, rows
};

March marchFrom(vec2 start, vec2 direction) {
  March march;
  march.start = start;
  march.direction = direction;
  march.forward = sign(direction);
  march.perBorder = u_cellTexels / max(abs(direction), vec2(1e-6));
  vec2 border = (floor(start / u_cellTexels) + max(march.forward, 0.0)) * u_cellTexels;
  march.next = abs(border - start) / max(abs(direction), vec2(1e-6));
  return march;
}

// Steps to the next border and returns the vector from `origin` to the rim there, as seen from the cell behind it.
// False beyond the map.
bool stepMarch(inout March march, vec3 origin, out vec3 towards) {
  float travelled = min(march.next.x, march.next.y);
  march.next += march.perBorder * vec2(lessThanEqual(march.next, vec2(travelled)));
  if (travelled > u_everyBorderTexels) march.next = max(march.next, vec2(travelled * kGrowth));
  vec2 point = march.start + march.direction * travelled;
  vec2 owner = point + march.direction * 1e-3 + march.forward * 1e-3;
  towards = vec3(0.0);
  if (!isInside(owner)) return false;
  vec4 surface = texelFetch(u_surface, ivec2(owner), 0);
  if (isModel(surface)) towards = engravedPoint(surface, carvedDepth(owner), floor(owner) + 0.5, point) - origin;
  return true;
}

// Returns true if the march can end. From the floor of a pocket, nothing rises higher over the surface's own horizon
// than a pocket's depth; true if that is too little to matter at this distance. (0.9: the surface is nearer than the
// plane.)
bool isSettled(March march, float cotangent, float surfaceHorizon, float pocketMm) {
  float travelled = min(march.next.x, march.next.y);
  return travelled > u_radiusTexels || (cotangent - surfaceHorizon) * (0.9 * travelled * u_texelMm) >= pocketMm;
}

// Returns the cotangent of the angle between the line of sight and the horizon seen from `origin` in the slice along
// `along`.
float horizonCotangent(vec2 start, vec3 along, vec3 origin, SightFrame sight, float tangent, float surfaceHorizon,
                       float pocketMm) {
  March march = marchFrom(start, onPlane(along, sight.ray));
  float highest = tangent;
  for (int i = 0; i < 256 && !isSettled(march, highest, surfaceHorizon, pocketMm); ++i) {
    vec3 towards;
    if (!stepMarch(march, origin, towards)) break;
    float across = dot(towards, along);
    if (across > 0.0) highest = max(highest, dot(towards, sight.toEye) / across);
  }
  return highest;
}

// Returns the fraction of the texel that a lamp reaches, past rims and past the surface's own horizon. A shadow's edge
// is as wide as a texel, so that cell means do not jump, but not so wide that a plane shades itself.
vec2 lampReaches(vec2 start, int lamp, vec3 normal, vec3 origin, SightFrame sight, float pocketMm) {
  vec3 toLamp = u_lamps[lamp].xyz;
  float cosine = dot(toLamp, sight.toEye);
  float sine = length(toLamp - sight.toEye * cosine);
  if (sine < 1e-3) return vec2(1.0);  // next to the eye, which sees the texel
  vec3 along = acrossTo(toLamp, sight);
  float cotangent = cosine / sine;
  float surfaceHorizon = horizonToLamp(start, lamp);
  if (cotangent <= surfaceHorizon) return vec2(0.0);
  float tangent = tangentCotangent(normal, along, sight.toEye);
  surfaceHorizon = max(surfaceHorizon, tangent);
  March march = marchFrom(start, onPlane(along, sight.ray));
  float edgeMm = u_texelMm * max(cotangent, 0.05);
  float overOwnPlane = max(cotangent - tangent, 1e-3);
  float lit = 1.0;
  for (int i = 0; i < 256 && !isSettled(march, cotangent, surfaceHorizon, pocketMm); ++i) {
    vec3 towards;
    if (!stepMarch(march, origin, towards)) break;
    float away = dot(towards, along);
    float over = dot(towards, sight.toEye) - away * cotangent;
    lit = min(lit, clamp(0.5 - over / min(edgeMm, max(2.0 * overOwnPlane * away, 1e-6)), 0.0, 1.0));
  }
  return vec2(lit, 1.0);
}

// Returns sixteenths, each once in a 4×4 block, and each quarter once in every row and column, so that directions and
// positions are not correlated. Two orthogonal Latin squares over the field of four elements [Bose 1938].
float turnOf(ivec2 inBlock) {
  int turned = inBlock.y == 0 ? 0 : inBlock.y == 3 ? 1 : inBlock.y + 1;  // y times the field's generator
  int quarter = inBlock.x ^ inBlock.y;
  int within = inBlock.x ^ turned;
  return (float(4 * quarter + within) + 0.5) / 16.0;
}

// Returns the texel that is computed for a block. In two by two blocks, the four texels form a rotated grid.
ivec2 texelOf(ivec2 block) {
  return block * u_stride + (u_stride == 2 ? ivec2(block.y & 1, 1 - (block.x & 1)) : ivec2(u_stride >> 1));
}

// Returns the block in the map for a pixel of the output; negative beyond the list. (Some software renderers divide
// even integers to few bits.)
ivec2 blockOf(vec2 pixel) {
  if (u_listed == 0) return ivec2(pixel);
  ivec2 entry = ivec2(pixel * u_cellsPerPixel);
  if (entry.y * textureSize(u_list, 0).x + entry.x >= u_listed) return ivec2(-1);
  return ivec2(texelFetch(u_list, entry, 0).xy) * u_computedTexels + (ivec2(pixel) - entry * u_computedTexels);
}

void main() {
  ivec2 block = blockOf(gl_FragCoord.xy);
  if (block.x < 0) discard;
  if (u_onlyDue == 1 && !isDue(u_depth, ivec2((vec2(block) + 0.5) * u_cellsPerPixel))) discard;
  vec2 texel = vec2(texelOf(block)) + 0.5;
  vec4 surface = texelFetch(u_surface, ivec2(texel), 0);
  if (!isModel(surface)) {
    o_received = vec4(1.0, 1.0, 0.0, 0.0);
    return;
  }
  SightFrame sight = sightFrame(texel);
  float depth = carvedDepth(texel);
  vec3 origin = engravedPoint(surface, depth, texel, texel);
  float pocketMm = depth + u_reliefMm;

  ivec2 inBlock = u_stride == 2 ? (block & 1) * ivec2(1, 2) : block & 3;  // each of four texels gets another quarter
  float turn = u_turnSlices == 1 ? turnOf(inBlock) : 0.5;
  vec2 visibility = vec2(0.0);
  for (int i = 0; i < 2 * u_slices; ++i) {  // every slice has two sides
    float angle = (float(i) + turn) * kPi / float(u_slices);
    vec3 along = directionAcross(sight, angle);
    vec2 inSlice = vec2(dot(surface.xyz, along), dot(surface.xyz, sight.toEye));
    float gamma = atan(inSlice.x, inSlice.y);
    // Directions below the tangent plane do not count: it is the lowest horizon.
    float tangent = tangentCotangent(surface.xyz, along, sight.toEye);
    float far = max(tangent, horizonOfSurface(texel, angle));
    float wall = horizonCotangent(texel, along, origin, sight, tangent, far, pocketMm);
    visibility += length(inSlice) * vec2(visibleArc(atan(1.0, max(wall, far)), gamma), visibleArc(atan(1.0, wall), gamma));
  }
  visibility /= float(u_slices);
  // Outside pockets the march met only the surface itself.
  if (pocketMm == 0.0) visibility.y = 1.0;

  vec2 lamps = vec2(0.0);
  for (int i = 0; i < u_lampCount; ++i) {
    float facing = max(dot(surface.xyz, u_lamps[i].xyz), 0.0);
    if (facing > 0.0) lamps += u_lamps[i].w * facing * lampReaches(texel, i, surface.xyz, origin, sight, pocketMm);
  }
  o_received = vec4(visibility, lamps);
}
