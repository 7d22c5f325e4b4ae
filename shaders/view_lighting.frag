#version 300 es
// A matte material under a soft sky, dimmed by occlusion, and one key light that moves with the camera; the code's
// square as a print on the surface, carried there by the central projection from the reader's eye [Papp 2022, §3].
//
// Output: linear colour.
precision highp float;

#include "view_camera.glsl"
#include "interreflection.glsl"

uniform highp sampler2D u_visibility;  // sky visibility, z / u_blurUnit
uniform int u_blur;                    // 1: mean over a 4×4 block of like depth, 0: this pixel alone
uniform float u_blurUnit;              // mm
uniform float u_blurReach;             // difference of z up to which a neighbour counts, mm
uniform vec3 u_skyward;                // view space, unit
uniform vec3 u_background[2];          // at the lower and upper edge
uniform vec3 u_accent;                 // outline and marker
uniform float u_pixelMm;               // size of a pixel at the target

// The code's square: image over the QR plane, view space.
uniform int u_overlayShown;
uniform sampler2D u_ink;        // red: 1 = dark; row 0 = top
uniform vec3 u_codeCentre;
uniform vec3 u_codeRight;
uniform vec3 u_codeUp;
uniform vec3 u_codeNormal;
uniform float u_codeEyeDistance;  // mm
uniform float u_codeEdge;         // of the image on the QR plane, mm
uniform vec2 u_codeHeights;       // lowest and highest surface that takes the print, over the QR plane, mm

uniform int u_heatShown;  // 1: the front side has the colours of its heat
uniform int u_markerShown;
uniform vec3 u_marker;  // view space

layout(location = 0) out vec4 o_colour;

const vec3 kMaterial = vec3(0.56, 0.55, 0.53);
const vec3 kBackSide = vec3(0.50, 0.16, 0.11);
const vec3 kPaper = vec3(0.83, 0.83, 0.82);
const vec3 kInk = vec3(0.035, 0.04, 0.055);
const vec3 kSky = vec3(0.66, 0.70, 0.77);
const vec3 kGround = vec3(0.24, 0.22, 0.21);
const vec3 kKey = vec3(0.88, 0.85, 0.79);
const vec3 kTowardsKey = vec3(-0.55, 0.60, 0.58);

float skyVisibility(float z) {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  if (u_blur == 0) return texelFetch(u_visibility, pixel, 0).r;
  ivec2 last = ivec2(u_size) - 1;
  float sum = 0.0;
  float weights = 1e-6;
  for (int y = -2; y < 2; ++y) {
    for (int x = -2; x < 2; ++x) {
      vec2 found = texelFetch(u_visibility, clamp(pixel + ivec2(x, y), ivec2(0), last), 0).rg;
      float weight = max(0.0, 1.0 - abs(found.g * u_blurUnit - z) / u_blurReach);
      sum += weight * found.r;
      weights += weight;
    }
  }
  return sum / weights;
}

vec3 printed(vec3 albedo, vec3 position, vec3 normal) {
  vec3 fromCentre = position - u_codeCentre;
  float height = dot(fromCentre, u_codeNormal);
  vec3 toReader = u_codeCentre + u_codeNormal * u_codeEyeDistance - position;
  if (height < u_codeHeights.x || height > u_codeHeights.y || dot(normal, toReader) <= 0.0) return albedo;
  vec2 onPlane = vec2(dot(fromCentre, u_codeRight), dot(fromCentre, u_codeUp)) *
                 (u_codeEyeDistance / (u_codeEyeDistance - height));
  float beyond = max(abs(onPlane.x), abs(onPlane.y)) - 0.5 * u_codeEdge;
  if (beyond > 2.0 * u_pixelMm) return albedo;
  if (beyond > 0.0) return u_accent;
  float ink = texture(u_ink, vec2(0.5) + vec2(onPlane.x, -onPlane.y) / u_codeEdge).r;
  return mix(kPaper, kInk, ink);
}

vec3 marked(vec3 albedo, vec3 position) {
  float radius = length(position - u_marker) / u_pixelMm;
  return radius < 3.0 || (radius > 7.0 && radius < 9.5) ? u_accent : albedo;
}

// Viridis, which grows evenly brighter and is told apart by every kind of colour vision: five of its colours, linear,
// and straight lines between them.
vec3 heatColour(float heat) {
  const vec3 kStops[5] = vec3[5](vec3(0.058, 0.0004, 0.089), vec3(0.043, 0.085, 0.259), vec3(0.015, 0.282, 0.264),
                                 vec3(0.112, 0.585, 0.121), vec3(0.983, 0.799, 0.019));
  float at = clamp(heat, 0.0, 1.0) * 4.0;
  int below = min(int(at), 3);
  return mix(kStops[below], kStops[below + 1], at - float(below));
}

void main() {
  vec4 surface = texelFetch(u_surface, ivec2(gl_FragCoord.xy), 0);
  if (!isSurface(surface.xyz)) {
    o_colour = vec4(mix(u_background[0], u_background[1], gl_FragCoord.y / u_size.y), 1.0);
    return;
  }
  vec3 position = positionView(gl_FragCoord.xy, surface.w);
  bool isFront = dot(surface.xyz, surface.xyz) > 0.5;
  vec3 normal = normalize(surface.xyz);
  vec3 albedo = isFront ? kMaterial : kBackSide;
  if (u_heatShown == 1 && isFront) albedo = heatColour(length(surface.xyz) - 1.0);
  if (u_overlayShown == 1 && isFront) albedo = printed(albedo, position, normal);
  if (u_markerShown == 1) albedo = marked(albedo, position);

  // To the power of 2.5: the eye is to see the form and the code, not the photometry.
  float open = skyVisibility(surface.w);
  float light = open + interreflection(open, open, kMaterial.g);
  float visibility = squareOf(light) * sqrt(light);
  vec3 sky = mix(kGround, kSky, 0.5 + 0.5 * dot(normal, u_skyward));
  // The key light fades in pockets, too, where a soft lamp would be hidden.
  float key = max(0.0, dot(normal, normalize(kTowardsKey))) * visibility;
  o_colour = vec4(albedo * (sky * visibility + kKey * key), 1.0);
}
