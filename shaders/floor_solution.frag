#version 300 es
// Solves for the depth at which each floor sees the wanted fraction of the sky while its neighbours keep theirs. A few
// passes come close to the solution for all, as all floors move at once. The first step is Newton's, as in
// depth/pocket_sky.cpp; between a depth that is too bright and one that is dark enough, a step follows the line through
// both, because at the kinks of the curve two steps by Newton may lead back to where they began.
precision highp float;
precision highp int;        // the defaults are mediump and lowp, for which Mesa takes 16 bits
precision highp sampler2D;

#include "depth_search.glsl"

uniform sampler2D u_solved;     // depths so far, mm
uniform sampler2D u_luminance;
uniform float u_aim;            // margin by which to aim darker, as a fraction of the threshold
uniform float u_lastAim;        // the same for floors that are too bright
uniform float u_changeFraction; // of the last change of difference, by which to aim darker still
uniform float u_maxChange;      // limit on the change that counts

layout(location = 0) out vec4 o_depth;

const int kSteps = 2;
const float kSettledMm = 2e-3;
const float kShortStepMm = 1e-2;

void main() {
  ivec2 cell = ivec2(gl_FragCoord.xy);
  vec4 target = texelFetch(u_targets, cell, 0);
  o_depth = vec4(0.0);
  if (target.a == 0.0 || target.b == 0.0) return;
  vec4 found = texelFetch(u_floors, cell, 0);
  bool isTooBright = texelFetch(u_luminance, cell, 0).r > target.g * target.r;
  float wanted = darkness(target.g * (1.0 - (isTooBright ? u_lastAim : u_aim))) +
                 u_changeFraction * min(found.b, u_maxChange) - found.g;
  vec2 tooBright = vec2(0.0);   // a depth that is, and its darkness; 0: none is known
  vec2 darkEnough = vec2(0.0);  // likewise
  float depth = clamp(texelFetch(u_solved, cell, 0).r, min(kSettledMm, target.b), target.b);
  for (int i = 0; i < kSteps; ++i) {
    vec2 seen = skySeen(u_solved, cell, depth);
    float v = clamp(seen.x, 1e-6, 1.0 - 1e-6);
    float now = log((1.0 - v) / v);
    if (now < wanted && depth >= target.b) break;
    if (now < wanted)
      tooBright = vec2(depth, now);
    else
      darkEnough = vec2(depth, now);
    float next = target.b;
    float perLogDepth = -seen.y * depth / (v * (1.0 - v));
    if (tooBright.x > 0.0 && darkEnough.x > 0.0) {
      float share = (wanted - tooBright.y) / max(darkEnough.y - tooBright.y, 1e-6);
      next = tooBright.x * pow(darkEnough.x / tooBright.x, share);
    } else if (perLogDepth > 0.0) {
      next = min(depth * exp(clamp((wanted - now) / perLogDepth, -20.0, 20.0)), target.b);
    }
    bool isShort = abs(next - depth) < kShortStepMm;
    depth = next;
    if (isShort) break;
  }
  o_depth = vec4(depth, 0.0, 0.0, 1.0);
}
