// An sRGB colour in one number, 0 … 1: red in 5 bits, green in 6, blue in 5.

const vec3 kChannelSteps = vec3(31.0, 63.0, 31.0);

float packedColour(vec3 srgb) {
  vec3 steps = floor(clamp(srgb, 0.0, 1.0) * kChannelSteps + 0.5);
  return (steps.r * 2048.0 + steps.g * 32.0 + steps.b) / 65536.0;
}

vec3 unpackedColour(float value) {
  float bits = floor(value * 65536.0 + 0.5);
  return vec3(floor(bits / 2048.0), mod(floor(bits / 32.0), 64.0), mod(bits, 32.0)) / kChannelSteps;
}
