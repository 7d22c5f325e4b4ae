// The viewer's camera and G-buffer. View space: origin at the camera's target, axes right, up, back, mm; the eye is at
// (0, 0, u_distance). Positions near the target stay precise, whatever the distance.

uniform highp sampler2D u_surface;  // shading normal and z. Its length: 1 + heat: front side, 0.7: cut, 0.5: back side,
                                   // 0: background
uniform vec2 u_tanHalf;             // tangents of half the field of view
uniform vec2 u_size;                // of the G-buffer, pixels
uniform vec2 u_jitter;              // offset of this sample in normalised device coordinates
uniform float u_distance;           // eye to target, mm

vec3 positionView(vec2 pixel, float z) {
  vec2 ndc = 2.0 * pixel / u_size - 1.0 - u_jitter;
  return vec3(ndc * u_tanHalf * (u_distance - z), z);
}

bool isSurface(vec3 normal) {
  return dot(normal, normal) > 0.1;
}

bool isFrontSide(vec3 normal) {
  return dot(normal, normal) > 0.8;
}

bool isCut(vec3 normal) {
  return !isFrontSide(normal) && dot(normal, normal) > 0.36;
}

float squareOf(float x) {
  return x * x;
}
