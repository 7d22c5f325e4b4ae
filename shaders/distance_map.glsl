// A distance map over the QR plane, and the carving in it. Texel (0, 0) is at the lower left; its content is
// (facet normal, distance from the eye) as geometry.frag writes it, 0 in the distance where the ray misses the model.

uniform sampler2D u_surface;
uniform sampler2D u_depth;       // carving depth of each cell, mm
uniform float u_eyeDistance;     // mm
uniform float u_texelMm;         // edge of a texel on the QR plane, mm
uniform float u_mapTexels;       // texels along the map's edge
uniform float u_cellTexels;      // texels along a cell's edge; depth is constant in a cell

// Unit direction from the eye through a point of the map (texel units).
vec3 rayThrough(vec2 texel) {
  return normalize(vec3((texel - 0.5 * u_mapTexels) * u_texelMm, -u_eyeDistance));
}

float carvedDepth(vec2 texel) {
  return texelFetch(u_depth, ivec2(texel / u_cellTexels), 0).r;
}

bool isInside(vec2 texel) {
  return all(greaterThanEqual(texel, vec2(0.0))) && all(lessThan(texel, vec2(u_mapTexels)));
}

// Distance along the ray through `point` to the plane of the facet that the texel at `owner` sees: exact where the
// surface is flat over half a texel.
float baseDistance(vec4 surface, vec2 owner, vec2 point) {
  vec3 towards = rayThrough(point);
  float slope = dot(surface.xyz, towards);
  if (slope > -0.1) return surface.w;  // seen at a grazing angle: extrapolating would leave the surface
  return surface.w * dot(surface.xyz, rayThrough(floor(owner) + 0.5)) / slope;
}
