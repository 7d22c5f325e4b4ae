// Light that matte material of some albedo reflects into areas hidden from the sky, as irradiance, 1 = the open sky.
//
// A pocket's walls reflect light onto its floor in proportion to the root of the floor's own visibility, because both
// see the sky through the same opening. The surface beyond the pocket, seen past the walls, is nearly as bright as an
// open one. The wall's factor is a fit to path tracing of half the models at the albedos 0.5, 0.7 and 0.85;
// bench/luminance_table.cpp measures its error on the other half.
//
// visibility: of the sky; pastWalls: visibility if only the walls of pockets hid the sky, ≥ visibility.
float interreflection(float visibility, float pastWalls, float albedo) {
  float wall = 0.401 / (1.0 - 0.75 * albedo) * sqrt(max(visibility, 0.0));
  float surface = 0.910;
  return albedo * ((1.0 - pastWalls) * wall + max(pastWalls - visibility, 0.0) * surface);
}

// Returns the luminance under sky and lamps with reflected light, 1 = an unoccluded surface in the QR plane. A lamp
// brings as much light into a pocket as the surface around it receives; the pocket reflects it like the sky's.
// Same formula as in core/light/received.cpp.
//
// lamps: direct light of the lamps; lampsUncarved: the same on the surface around; openIrradiance: of sky and lamps in
// the QR plane.
float luminanceOf(float visibility, float pastWalls, float lamps, float lampsUncarved, float albedo,
                  float openIrradiance) {
  float reflected = (1.0 + lampsUncarved) * interreflection(visibility, pastWalls, albedo);
  return (visibility + lamps + reflected) / openIrradiance;
}
