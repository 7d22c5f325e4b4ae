// Lamps that light the view, with their shadows. Each lamp has two shadow maps (view_shadow.frag), tiles of one texture:
// the column is the lamp; the lower row shows the whole model, the upper row finely the surroundings of the code.

uniform int u_lamps;             // -1: the viewer's own lights; else the number of lamps in addition to the sky
uniform vec4 u_lamp[2];          // unit vector to the lamp (view space); irradiance of a surface that faces it, 1 = by
                                 // the whole sky
uniform vec3 u_lampRight[2];     // axes of the lamp's windows, view space
uniform vec3 u_lampUp[2];
uniform vec4 u_shadowWindow[2];  // whole model, surroundings of the code: middle (view space), half the edge, mm
uniform highp sampler2D u_shadow;
uniform float u_albedo;          // of the material
uniform float u_openIrradiance;  // of sky and lamps in the QR plane, 1 = of the sky

// A surface must not shade itself: it is looked up this far in front of itself. Interpolation reads heights of the
// tangent plane up to a texel's diagonal away.
const float kOffsetTexels = 1.5;

// Returns the position in a lamp's window in half edges, and the height towards the lamp in mm.
vec3 inWindow(vec4 window, int lamp, vec3 position) {
  vec3 fromMiddle = position - window.xyz;
  return vec3(dot(fromMiddle, u_lampRight[lamp]) / window.w, dot(fromMiddle, u_lampUp[lamp]) / window.w,
              dot(fromMiddle, u_lamp[lamp].xyz));
}

// Returns the fraction of a lamp's light that reaches the point, interpolated between four texels.
float reached(int lamp, vec3 position, vec3 normal) {
  int edge = textureSize(u_shadow, 0).y / 2;  // of a tile, texels
  vec3 fine = inWindow(u_shadowWindow[1], lamp, position);
  int row = max(abs(fine.x), abs(fine.y)) < 1.0 - 8.0 / float(edge) ? 1 : 0;
  vec4 window = u_shadowWindow[row];
  float offsetMm = kOffsetTexels * 2.0 * window.w / float(edge);
  vec3 found = inWindow(window, lamp, position + offsetMm * normal);
  vec2 at = (0.5 * found.xy + 0.5) * float(edge) - 0.5;
  ivec2 tile = ivec2(lamp, row) * edge;
  ivec2 low = tile + clamp(ivec2(floor(at)), ivec2(0), ivec2(edge - 2));
  vec4 heights = vec4(texelFetch(u_shadow, low, 0).r, texelFetch(u_shadow, low + ivec2(1, 0), 0).r,
                      texelFetch(u_shadow, low + ivec2(0, 1), 0).r, texelFetch(u_shadow, low + ivec2(1, 1), 0).r);
  vec4 open = step(heights, vec4(found.z));
  vec2 part = fract(at);
  return mix(mix(open.x, open.y, part.x), mix(open.z, open.w, part.x), part.y);
}

// Returns the light of all lamps on the point: with shadows, and without.
vec2 lampLight(vec3 position, vec3 normal) {
  vec2 sum = vec2(0.0);
  for (int lamp = 0; lamp < u_lamps; ++lamp) {
    float faced = u_lamp[lamp].w * max(0.0, dot(normal, u_lamp[lamp].xyz));
    sum += faced * vec2(reached(lamp, position, normal), 1.0);
  }
  return sum;
}
