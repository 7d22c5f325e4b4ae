// The transfer curve of sRGB [IEC 61966-2-1] and its inverse, for colours 0 … 1.
vec3 srgbOf(vec3 colour) {
  vec3 linear = clamp(colour, 0.0, 1.0);
  vec3 high = 1.055 * pow(max(linear, 1e-6), vec3(1.0 / 2.4)) - 0.055;
  return mix(high, linear * 12.92, vec3(lessThan(linear, vec3(0.0031308))));
}

vec3 linearOf(vec3 srgb) {
  return mix(pow((srgb + 0.055) / 1.055, vec3(2.4)), srgb / 12.92, vec3(lessThanEqual(srgb, vec3(0.04045))));
}
