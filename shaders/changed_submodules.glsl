// Returns true if a floor, or one that touches it, moved last time: its light must be measured.
bool isDue(sampler2D floors, ivec2 cell) {
  float moved = 0.0;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) moved = max(moved, texelFetch(floors, cell + ivec2(x, y), 0).a);
  return moved > 0.0;
}
