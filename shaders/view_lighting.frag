#version 300 es
// A matte material: under a soft sky, dimmed by occlusion, and one key light that moves with the camera; or under the
// uniform sky and the lamps that the code is carved for, with the luminance that the depth search works with.
//
// Output: linear colour; luminance of the light, for prints drawn on the surface later.
precision highp float;
precision highp int;        // the defaults are mediump and lowp, for which Mesa takes 16 bits
precision highp sampler2D;

#include "view_camera.glsl"
#include "interreflection.glsl"
#include "lamp_light.glsl"
#include "packed_colour.glsl"
#include "srgb.glsl"

uniform highp sampler2D u_visibility;  // sky visibility
uniform vec3 u_skyward;                // view space, unit
uniform vec3 u_background[2];          // at the lower and upper edge
uniform int u_heatShown;               // 1: the front side has its heat colours; 2: only where heat is above 0; 3: heat
                                       // is the surface's colour
uniform vec3 u_material;               // linear
uniform vec4 u_hatch;                  // direction across a cut's stripes (view space), and the target's position along
                                       // it, mm
uniform float u_hatchMm;               // distance between stripes
uniform vec4 u_plate;                  // the printer's vertical (view space, unit), and the plate's position along it, mm
uniform float u_overhangCosine;        // of the angle between normal and vertical where overhangs begin; -2: no plate

layout(location = 0) out vec4 o_colour;

const vec3 kBackSide = vec3(0.50, 0.16, 0.11);
const vec3 kCut = vec3(0.95, 0.40, 0.06);
const vec3 kOverhang = vec3(0.78, 0.30, 0.05);
const float kOverhangStrength = 0.55;
const float kOnPlateMm = 0.3;  // a surface this near to the plate lies on it
const vec3 kDarkest = vec3(0.02), kLightest = vec3(0.66);  // albedo of black, so that its shape shows, and of white
const vec3 kSky = vec3(0.66, 0.70, 0.77);
const vec3 kGround = vec3(0.24, 0.22, 0.21);
const vec3 kKey = vec3(0.88, 0.85, 0.79);
const float kHeadroom = 0.6;  // under lamps the brightest place has 1.6 times the luminance of the code's plane
const vec3 kTowardsKey = vec3(-0.55, 0.60, 0.58);

// Returns 1 where the surface hangs over the plate too steeply, 0 elsewhere.
float overhang(vec3 position, vec3 normal) {
  bool isOnPlate = dot(position, u_plate.xyz) - u_plate.w < kOnPlateMm;
  float cosine = dot(normal, u_plate.xyz);
  return isOnPlate ? 0.0 : 1.0 - smoothstep(u_overhangCosine - 0.03, u_overhangCosine + 0.03, cosine);
}

vec3 hatched(vec3 position) {
  float across = (dot(position, u_hatch.xyz) + u_hatch.w) / u_hatchMm;
  float soft = max(fwidth(across), 1e-4);
  return kCut * mix(0.72, 1.0, smoothstep(0.25 - soft, 0.25 + soft, abs(fract(across) - 0.5)));
}

// Viridis, which grows evenly brighter and works for every kind of colour vision: linear interpolation between five of
// its colours.
vec3 heatColour(float heat) {
  const vec3 kStops[5] = vec3[5](vec3(0.058, 0.0004, 0.089), vec3(0.043, 0.085, 0.259), vec3(0.015, 0.282, 0.264),
                                 vec3(0.112, 0.585, 0.121), vec3(0.983, 0.799, 0.019));
  float at = clamp(heat, 0.0, 1.0) * 4.0;
  int below = min(int(at), 3);
  return mix(kStops[below], kStops[below + 1], at - float(below));
}

vec3 ownLight(vec3 normal, float open) {
  // To the power of 2.5: the picture shows the shape and the code rather than the photometry.
  float light = open + interreflection(open, open, u_material.g);
  float visibility = squareOf(light) * sqrt(light);
  vec3 sky = mix(kGround, kSky, 0.5 + 0.5 * dot(normal, u_skyward));
  // The key light fades in pockets, too, where a soft lamp would be hidden.
  float key = max(0.0, dot(normal, normalize(kTowardsKey))) * visibility;
  return sky * visibility + kKey * key;
}

float underLamps(vec3 position, vec3 normal, float open) {
  vec2 lamps = lampLight(position, normal);
  float luminance = luminanceOf(open, open, lamps.x, lamps.y, u_albedo, u_openIrradiance);
  float brighter = max(0.0, luminance - 1.0);  // than the code's plane: rolls off as in a camera
  return min(luminance, 1.0) + brighter * kHeadroom / (brighter + kHeadroom);
}

void main() {
  vec4 surface = texelFetch(u_surface, ivec2(gl_FragCoord.xy), 0);
  vec3 position = positionView(gl_FragCoord.xy, surface.w);
  vec3 cut = hatched(position);
  if (!isSurface(surface.xyz)) {
    o_colour = vec4(mix(u_background[0], u_background[1], gl_FragCoord.y / u_size.y), 1.0);
    return;
  }
  bool isFront = isFrontSide(surface.xyz);
  float heat = length(surface.xyz) - 1.0;
  vec3 normal = normalize(surface.xyz);
  vec3 albedo = isFront ? u_material : isCut(surface.xyz) ? cut : kBackSide;
  if (isFront && (u_heatShown == 1 || (u_heatShown == 2 && heat > 1e-3))) albedo = heatColour(heat);
  if (isFront && u_heatShown == 3) albedo = mix(kDarkest, kLightest, linearOf(unpackedColour(heat)));
  bool showsBody = isFront && (u_heatShown == 0 || u_heatShown >= 3);
  if (showsBody) albedo = mix(albedo, kOverhang, kOverhangStrength * overhang(position, normal));

  float open = texelFetch(u_visibility, ivec2(gl_FragCoord.xy), 0).r;
  vec3 received = u_lamps < 0 ? ownLight(normal, open) : vec3(underLamps(position, normal, open));
  o_colour = vec4(albedo * received, dot(received, vec3(0.2126, 0.7152, 0.0722)));
}
