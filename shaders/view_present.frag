#version 300 es
// The finished picture onto the canvas: codes as prints on the surface, carried there by the central projection from
// the reader's eye [Papp 2022, §3], what of their squares misses the surface, the marker; then sRGB's gamma, and noise
// of half a grey level against bands in the background. Prints are not part of the averaged picture, so that they may
// follow the pointer while it stays as it is.
precision highp float;

#include "view_camera.glsl"

uniform highp sampler2D u_colour;  // linear; alpha: luminance of the light on the surface
uniform vec2 u_canvas;             // pixels
uniform vec3 u_accent;             // outline and marker
uniform vec3 u_warn;               // what of a square misses the surface
uniform float u_pixelMm;           // size of a pixel at the target
uniform int u_markerShown;
uniform vec3 u_marker;  // view space

// A square picture over a QR plane, in view space, and the map of what its eye sees there.
struct Print {
  vec3 centre, right, up, normal;
  float eyeDistance;  // mm
  float edge;         // of the picture on the plane, mm
  float strength;     // 0: none … 1
  vec2 turn;          // cosine and sine: of the picture against the map
  float window;       // edge of the map on the plane, mm; 0: none, the eye sees all
};
uniform Print u_prints[2];
uniform sampler2D u_ink;           // red: 1 = dark; row 0 = top; of both
uniform highp sampler2D u_reach0;  // height over the plane, 1 = part of the surface about the centre, slope along right
uniform highp sampler2D u_reach1;  // and up

layout(location = 0) out vec4 o_colour;

const vec3 kPaper = vec3(0.78, 0.78, 0.77);
const vec3 kInk = vec3(0.035, 0.04, 0.055);
const float kMostHeight = 0.75;  // farthest surface from the plane that takes a print, of its edge
// Each row and column of an 8 × 8 grid over the pixel once.
const vec2 kRooks[8] = vec2[8](vec2(-7, -1), vec2(-5, 5), vec2(-3, -5), vec2(-1, 1), vec2(1, 7), vec2(3, -3),
                               vec2(5, 3), vec2(7, -7));

float noise(vec2 pixel) {
  return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715)))) - 0.5;
}

// Where the line of sight meets the surface's tangent plane: as fine as the canvas, however coarse the G-buffer is.
vec3 positionAlong(vec3 sight, vec3 found, vec3 normal) {
  vec3 eye = vec3(0.0, 0.0, u_distance);
  float slant = dot(normal, sight);
  vec3 met = eye + sight * (dot(normal, found - eye) / (abs(slant) > 1e-3 ? slant : 1e-3));
  return length(met - found) < 4.0 * u_pixelMm * u_canvas.y / u_size.y ? met : found;
}

vec2 inMap(Print print, vec2 onPlane) {
  vec2 turned = vec2(onPlane.x * print.turn.x - onPlane.y * print.turn.y,
                     onPlane.x * print.turn.y + onPlane.y * print.turn.x);
  return turned / print.window + 0.5;
}

// Share of the four nearest texels that belong to the surface about the centre, weighted.
float reached(Print print, highp sampler2D map, vec2 onPlane) {
  if (print.window == 0.0) return 1.0;
  ivec2 last = textureSize(map, 0) - 1;
  vec2 at = inMap(print, onPlane) * vec2(last + 1) - 0.5;
  ivec2 base = ivec2(floor(at));
  vec2 part = at - vec2(base);
  float values[4];
  for (int i = 0; i < 4; ++i)
    values[i] = texelFetch(map, clamp(base + ivec2(i & 1, i >> 1), ivec2(0), last), 0).g;
  return mix(mix(values[0], values[1], part.x), mix(values[2], values[3], part.x), part.y);
}

// Whether nothing stands between the eye and a point of that height.
bool isSeen(Print print, highp sampler2D map, vec2 onPlane, float height) {
  if (print.window == 0.0) return true;
  ivec2 size = textureSize(map, 0);
  vec2 at = inMap(print, onPlane) * vec2(size);
  ivec2 texel = clamp(ivec2(at), ivec2(0), size - 1);
  vec4 surface = texelFetch(map, texel, 0);
  float texelMm = print.window / float(size.x);
  vec2 off = (at - vec2(texel) - 0.5) * texelMm;
  return height > surface.r + dot(surface.ba, off) - (1.0 + length(surface.ba)) * texelMm;
}

float inkAt(vec2 onPlane, vec2 dx, vec2 dy, float edge) {
  float sum = 0.0;
  for (int i = 0; i < 8; ++i) {
    vec2 at = onPlane + (kRooks[i].x * dx + kRooks[i].y * dy) / 16.0;
    sum += textureLod(u_ink, vec2(0.5) + vec2(at.x, -at.y) / edge, 0.0).r;
  }
  return sum / 8.0;
}

// 1 in the dark halves of diagonal stripes.
float stripes(vec2 onPlane, float edge) {
  float across = (onPlane.x + onPlane.y) / (0.06 * edge);
  float soft = fwidth(across);
  return smoothstep(0.25 - soft, 0.25 + soft, abs(fract(across) - 0.5));
}

// Share of the pixel inside the square, and in its outline.
vec2 inSquare(vec2 onPlane, vec2 dx, vec2 dy, float edge) {
  float pixel = max(1e-6, max(length(dx), length(dy)));
  float beyond = (max(abs(onPlane.x), abs(onPlane.y)) - 0.5 * edge) / pixel;
  float inside = pixel > edge ? 0.0 : clamp(0.5 - beyond, 0.0, 1.0);  // not where the plane is seen from its side
  bool isGrazed = pixel > 0.02 * edge;  // a contour of the surface: its pixels reach too far to tell
  return vec2(inside, isGrazed ? 0.0 : clamp(2.5 - beyond, 0.0, 1.0) - inside);
}

vec3 printed(vec3 colour, float light, Print print, highp sampler2D map, vec3 position, vec3 normal, bool takesPrint) {
  vec3 fromCentre = position - print.centre;
  float height = dot(fromCentre, print.normal);
  vec2 onPlane = vec2(dot(fromCentre, print.right), dot(fromCentre, print.up)) *
                 (print.eyeDistance / (print.eyeDistance - height));
  vec2 dx = dFdx(onPlane), dy = dFdy(onPlane);
  vec2 square = inSquare(onPlane, dx, dy, print.edge);
  float striped = stripes(onPlane, print.edge);
  vec3 toReader = print.centre + print.normal * print.eyeDistance - position;
  bool isNear = abs(height) < kMostHeight * print.edge;
  if (!takesPrint || !isNear || square.x + square.y <= 0.0 || dot(normal, toReader) <= 0.0) return colour;
  if (!isSeen(print, map, onPlane, height)) return colour;
  float held = smoothstep(0.35, 0.65, reached(print, map, onPlane));
  vec3 code = mix(kPaper, kInk, inkAt(onPlane, dx, dy, print.edge)) * light;
  vec3 missed = mix(colour, u_warn * max(light, 0.4), 0.35 + 0.45 * striped);
  colour = mix(colour, mix(missed, code, held), print.strength * square.x);
  return mix(colour, mix(u_warn, u_accent, held), square.y * print.strength);
}

// The square on the QR plane where it lies over nothing that could take it.
vec3 overhung(vec3 colour, Print print, highp sampler2D map, vec3 sight, float surfaceZ) {
  vec3 eye = vec3(0.0, 0.0, u_distance);
  float slant = dot(sight, print.normal);
  vec3 met = eye + sight * (dot(print.centre - eye, print.normal) / (abs(slant) > 1e-4 ? slant : 1e-4));
  vec2 onPlane = vec2(dot(met - print.centre, print.right), dot(met - print.centre, print.up));
  vec2 square = inSquare(onPlane, dFdx(onPlane), dFdy(onPlane), print.edge);
  float striped = stripes(onPlane, print.edge);
  if (met.z < surfaceZ || met.z > u_distance || square.x <= 0.0) return colour;
  float missing = 1.0 - smoothstep(0.35, 0.65, reached(print, map, onPlane));
  return mix(colour, u_warn, missing * square.x * print.strength * (0.25 + 0.45 * striped));
}

void main() {
  vec2 ndc = 2.0 * gl_FragCoord.xy / u_canvas - 1.0;
  vec3 sight = vec3(ndc * u_tanHalf, -1.0);
  ivec2 texel = clamp(ivec2(0.5 * (ndc + 1.0 + u_jitter) * u_size), ivec2(0), ivec2(u_size) - 1);
  vec4 surface = texelFetch(u_surface, texel, 0);
  bool isSolid = isSurface(surface.xyz);
  bool takesPrint = isFrontSide(surface.xyz);
  vec3 normal = isSolid ? normalize(surface.xyz) : vec3(0.0, 0.0, 1.0);
  vec3 position = positionAlong(sight, positionView(vec2(texel) + 0.5, surface.w), normal);

  vec4 picture = texture(u_colour, gl_FragCoord.xy / u_canvas);
  vec3 colour = picture.rgb;
  float surfaceZ = isSolid ? position.z : -1e9;
  if (u_prints[0].strength > 0.0) {
    colour = printed(colour, picture.a, u_prints[0], u_reach0, position, normal, takesPrint);
    colour = overhung(colour, u_prints[0], u_reach0, sight, surfaceZ);
  }
  if (u_prints[1].strength > 0.0) {
    colour = printed(colour, picture.a, u_prints[1], u_reach1, position, normal, takesPrint);
    colour = overhung(colour, u_prints[1], u_reach1, sight, surfaceZ);
  }
  if (u_markerShown == 1 && isSolid) {
    float radius = length(position - u_marker) / u_pixelMm;
    if (radius < 3.0 || (radius > 7.0 && radius < 9.5)) colour = u_accent;
  }

  vec3 linear = clamp(colour, 0.0, 1.0);
  vec3 low = linear * 12.92;
  vec3 high = 1.055 * pow(max(linear, 1e-6), vec3(1.0 / 2.4)) - 0.055;
  vec3 encoded = mix(high, low, vec3(lessThan(linear, vec3(0.0031308))));
  o_colour = vec4(encoded + noise(gl_FragCoord.xy) / 255.0, 1.0);
}
