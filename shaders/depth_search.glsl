// Floors of pockets in the map of cells, for the depth search on the GPU (render/floor_passes.h). The rule is that of
// depth/fast_search.h; a test compares both.

uniform sampler2D u_floors;   // depth, mm; measured minus predicted darkness; last change of that; 1: moved last time
uniform sampler2D u_targets;  // light of the surroundings; greatest fraction of it; greatest depth, mm; 1: carved
uniform sampler2D u_steps;    // paths of the 16 directions: column and row from the floor, 1 / distance; 0: beyond the end
uniform int u_stepCount;
uniform vec2 u_quantum;       // step of depths, mm, and its inverse (some software renderers divide to few bits)

// log((1 - v)/v)
float darkness(float fraction) {
  float v = clamp(fraction, 1e-3, 1.0 - 1e-3);
  return log((1.0 - v) / v);
}

// Returns the fraction of the sky that a floor sees if its own depth were `depthMm`, and the change per mm. See
// depth/floor_horizons.cpp.
vec2 skySeen(sampler2D depths, ivec2 cell, float depthMm) {
  vec2 seen = vec2(0.0);
  for (int direction = 0; direction < 16; ++direction) {
    float steepest = 0.0;
    float steepestPerMm = 0.0;
    for (int i = 0; i < u_stepCount; ++i) {
      vec3 onPath = texelFetch(u_steps, ivec2(direction, i), 0).xyz;
      if (depthMm * onPath.z <= steepest) break;  // nothing farther on is higher
      float steep = (depthMm - texelFetch(depths, cell + ivec2(onPath.xy), 0).r) * onPath.z;
      if (steep > steepest) {
        steepest = steep;
        steepestPerMm = onPath.z;
      }
    }
    float fraction = 1.0 / (1.0 + steepest * steepest);
    seen += vec2(fraction, -2.0 * steepest * steepestPerMm * fraction * fraction);
  }
  return seen / 16.0;
}

// Rounds up to the grid of the files, at most to the limit, which lies on the grid.
float quantisedDepth(float depthMm, float limitMm) {
  return min(ceil(depthMm * u_quantum.y - 1e-2) * u_quantum.x, limitMm);
}
