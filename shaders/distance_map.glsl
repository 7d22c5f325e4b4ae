// A distance map over the QR plane, and the carving in it. Texel (0, 0) is at the lower left. A texel holds (facet
// normal, height over the QR plane) as written by geometry.frag; the normal is zero where the ray misses the model.
//
// Code space: origin at the code's centre, axes right, up, normal, mm; the eye is at (0, 0, u_eyeDistance). The map
// stores heights rather than distances because some software renderers divide to 12 bits only: of 250 mm that would be
// the layer.

uniform sampler2D u_surface;
uniform sampler2D u_depth;       // carving depth of each cell along the ray, mm
uniform float u_eyeDistance;     // mm
uniform float u_texelMm;         // edge of a texel on the QR plane, mm
uniform float u_mapTexels;       // texels along the map's edge
uniform float u_cellTexels;      // texels along a cell's edge; depth is constant in a cell

// Returns the vector from the eye to a point of the map (texel units) on the QR plane; not a unit vector.
vec3 rayThrough(vec2 texel) {
  return vec3((texel - 0.5 * u_mapTexels) * u_texelMm, -u_eyeDistance);
}

float carvedDepth(vec2 texel) {
  return texelFetch(u_depth, ivec2(texel / u_cellTexels), 0).r;
}

bool isInside(vec2 texel) {
  return all(greaterThanEqual(texel, vec2(0.0))) && all(lessThan(texel, vec2(u_mapTexels)));
}

bool isModel(vec4 surface) {
  return dot(surface.xyz, surface.xyz) > 0.0;
}

// Returns the point of the engraved surface on the ray through `point`, by the texel around `middle`: on that texel's
// facet plane, moved along the ray by its depth. Exact where the surface is flat over half a texel.
vec3 engravedPoint(vec4 surface, float depth, vec2 middle, vec2 point) {
  vec3 ray = rayThrough(point);
  vec3 ownerRay = rayThrough(middle);
  float scale = 1.0 - surface.w / u_eyeDistance;
  vec3 seen = vec3(ownerRay.xy * scale, surface.w);
  // Intersect the neighbouring ray with the facet plane, as a small step from the texel's own point.
  vec2 offset = (point - middle) * u_texelMm;
  float slope = dot(surface.xyz, ray);
  if (slope < -0.1 * u_eyeDistance) seen += scale * (vec3(offset, 0.0) - ray * (dot(surface.xy, offset) / slope));
  return seen + ray * (depth * inversesqrt(dot(ray, ray)));
}

const float kSteepest = 100.0;  // cotangents are clamped to ± this
const float kGrowth = 1.15;     // of a march's steps: features narrower than a seventh of their distance may be missed

// Axes for measuring slices through a texel's line of sight. `side` and `upward` are perpendicular to it.
struct SightFrame {
  vec3 ray;  // not a unit vector
  vec3 toEye;
  vec3 side;
  vec3 upward;
};

SightFrame sightFrame(vec2 texel) {
  vec3 ray = rayThrough(texel);
  vec3 toEye = -normalize(ray);
  vec3 side = normalize(cross(vec3(0.0, 1.0, 0.0), toEye));
  return SightFrame(ray, toEye, side, cross(toEye, side));
}

// Returns a unit vector perpendicular to the line of sight.
vec3 directionAcross(SightFrame sight, float angle) {
  return sight.side * cos(angle) + sight.upward * sin(angle);
}

// Returns the unit vector perpendicular to the line of sight, in the slice through a lamp.
vec3 acrossTo(vec3 toLamp, SightFrame sight) {
  vec3 across = toLamp - sight.toEye * dot(toLamp, sight.toEye);
  return across / max(length(across), 1e-6);
}

// Returns the direction in the map in which the projection of a point moves when the point moves by `along`: where the
// slice meets the QR plane.
vec2 onPlane(vec3 along, vec3 ray) {
  return normalize(along.xy * u_eyeDistance + ray.xy * along.z);
}

// Returns the cotangent of the angle between the line of sight and the tangent plane, in a slice.
float tangentCotangent(vec3 normal, vec3 along, vec3 toEye) {
  return clamp(-dot(normal, along) / max(dot(normal, toEye), 1e-3), -kSteepest, kSteepest);
}
