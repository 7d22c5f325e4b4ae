// Intersection of the line of sight through a pixel of the canvas with the surface in the G-buffer of view_camera.glsl.

uniform vec2 u_canvas;    // pixels
uniform float u_pixelMm;  // size of a pixel at the target

struct Sight {
  vec3 direction;  // view space, z = -1
  vec3 position;   // of the surface
  vec3 normal;
  bool isSolid;    // there is a surface
  bool isFront;    // and it is the outside
};

// Intersects the line of sight with the surface's tangent plane: as fine as the canvas, however coarse the G-buffer.
vec3 positionAlong(vec3 direction, vec3 found, vec3 normal) {
  vec3 eye = vec3(0.0, 0.0, u_distance);
  float slant = dot(normal, direction);
  vec3 met = eye + direction * (dot(normal, found - eye) / (abs(slant) > 1e-3 ? slant : 1e-3));
  return length(met - found) < 4.0 * u_pixelMm * u_canvas.y / u_size.y ? met : found;
}

Sight sightThrough(vec2 pixel) {
  Sight sight;
  vec2 ndc = 2.0 * pixel / u_canvas - 1.0;
  sight.direction = vec3(ndc * u_tanHalf, -1.0);
  ivec2 texel = clamp(ivec2(0.5 * (ndc + 1.0 + u_jitter) * u_size), ivec2(0), ivec2(u_size) - 1);
  vec4 surface = texelFetch(u_surface, texel, 0);
  bool isSolid = isSurface(surface.xyz);
  sight.normal = isSolid ? normalize(surface.xyz) : vec3(0.0, 0.0, 1.0);
  sight.position = positionAlong(sight.direction, positionView(vec2(texel) + 0.5, surface.w), sight.normal);
  sight.isSolid = isSolid;
  sight.isFront = isFrontSide(surface.xyz);
  return sight;
}
