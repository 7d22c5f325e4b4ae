// Light that matte material of an albedo reflects into what is hidden from the sky, as irradiance, 1 = the open sky.
//
// What a pocket's wall sends to the floor grows with the root of the floor's own visibility (both see the sky through
// the same opening); what rises over the horizon of the uncarved surface is nearly as bright as the open surface.
// Factors fitted against path tracing: bench/luminance_table.cpp, which also says how far off they are.
//
// visibility: of the sky; open: the same before anything was carved.
float interreflection(float visibility, float open, float albedo) {
  float wall = (0.605 + 0.295 * albedo) * sqrt(max(visibility, 0.0));
  float surface = 0.93;
  return albedo * (max(open - visibility, 0.0) * wall + max(1.0 - open, 0.0) * surface);
}
