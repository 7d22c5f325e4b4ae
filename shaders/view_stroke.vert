#version 300 es
// A stroke of constant width on the screen, as a strip of four vertices; a stroke without length is a dot. Its depth is
// never clipped, as the plate's (view_plate.vert).
precision highp float;

layout(location = 0) in vec3 a_from;    // model space, mm, relative to u_target's origin
layout(location = 1) in vec3 a_to;
layout(location = 2) in vec3 a_colour;  // sRGB
layout(location = 3) in vec2 a_width;   // at both ends, pixels

uniform vec3 u_right;
uniform vec3 u_up;
uniform vec3 u_back;
uniform vec3 u_target;
uniform float u_distance;  // eye to target, mm
uniform vec2 u_tanHalf;    // tangents of half the field of view
uniform vec2 u_canvas;     // pixels
uniform float u_halo;      // widens the stroke on every side, pixels

out vec3 v_position;  // view space
out vec3 v_colour;
out vec4 v_place;     // along and across the stroke and half its width, pixels, times the distance from the eye; and that
                      // distance, mm
flat out float v_isDot;

const float kNearest = 0.01;  // distance from the eye where strokes are cut off, as a part of u_distance
const float kSoft = 1.0;      // room for the soft edge, pixels

vec3 inView(vec3 position) {
  vec3 fromTarget = position - u_target;
  return vec3(dot(fromTarget, u_right), dot(fromTarget, u_up), dot(fromTarget, u_back));
}

float depth(vec3 position) {
  return u_distance - position.z;
}

// Returns the point of the stroke in front of the eye that is nearest to `end`.
vec3 ahead(vec3 end, vec3 other) {
  float least = kNearest * u_distance;
  if (depth(end) >= least || depth(other) <= least) return end;
  return mix(end, other, (least - depth(end)) / (depth(other) - depth(end)));
}

vec2 onScreen(vec3 position) {
  return position.xy / (u_tanHalf * depth(position)) * 0.5 * u_canvas;
}

void main() {
  vec3 from = inView(a_from), to = inView(a_to);
  vec3 ends[2] = vec3[2](ahead(from, to), ahead(to, from));
  vec2 way = onScreen(ends[1]) - onScreen(ends[0]);
  v_isDot = a_from == a_to ? 1.0 : 0.0;
  vec2 along = length(way) > 1e-3 ? normalize(way) : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);

  int end = gl_VertexID >> 1;
  float side = float(gl_VertexID & 1) * 2.0 - 1.0;
  float halfWidth = 0.5 * (end == 0 ? a_width.x : a_width.y) + u_halo;
  float reach = halfWidth + kSoft;
  float back = (float(end) * 2.0 - 1.0) * reach * v_isDot;
  v_position = ends[end];
  v_colour = a_colour;
  float w = depth(v_position);
  v_place = vec4(back * w, side * reach * w, halfWidth * w, w);
  vec2 at = onScreen(v_position) + side * reach * across + back * along;
  gl_Position = w > 0.0 ? vec4(at / (0.5 * u_canvas) * w, 0.0, w) : vec4(2.0, 2.0, 2.0, 1.0);
}
