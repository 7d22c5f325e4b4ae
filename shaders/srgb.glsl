// The transfer curve of sRGB [IEC 61966-2-1], for linear colours 0 … 1.
vec3 srgbOf(vec3 colour) {
  vec3 linear = clamp(colour, 0.0, 1.0);
  vec3 high = 1.055 * pow(max(linear, 1e-6), vec3(1.0 / 2.4)) - 0.055;
  return mix(high, linear * 12.92, vec3(lessThan(linear, vec3(0.0031308))));
}
