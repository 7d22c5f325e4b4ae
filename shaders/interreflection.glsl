// Light that matte material of an albedo reflects into what is hidden from the sky, as irradiance, 1 = the open sky.
//
// What a pocket's walls send to its floor grows with the root of the floor's own visibility (both see the sky through
// the same opening); the model's further surface, seen past the walls, is nearly as bright as an open one. The factor
// of the wall is a fit to path tracing of half the models at the albedos 0.5, 0.7 and 0.85; how far off it is on the
// other half: bench/luminance_table.cpp.
//
// visibility: of the sky; pastWalls: the same if nothing but the walls of pockets hid it, ≥ visibility.
float interreflection(float visibility, float pastWalls, float albedo) {
  float wall = 0.401 / (1.0 - 0.75 * albedo) * sqrt(max(visibility, 0.0));
  float surface = 0.910;
  return albedo * ((1.0 - pastWalls) * wall + max(pastWalls - visibility, 0.0) * surface);
}
