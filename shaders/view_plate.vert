#version 300 es
// A rectangle of the printer's plate in the viewer's camera (spaces: view_camera.glsl), from gl_VertexID alone. Its depth
// is never clipped: the plate reaches beyond the model, for which the camera's depth range is made.
precision highp float;

uniform vec3 u_centre;      // of the footprint, view space
uniform vec3 u_right;       // axes of the plate, view space
uniform vec3 u_back;
uniform vec2 u_half;        // half edges of the footprint, mm
uniform float u_fade;       // width of the margin around it, mm
uniform vec2 u_tanHalf;     // tangents of half the field of view
uniform float u_distance;   // eye to target, mm

out vec2 v_onPlate;   // mm from the centre
out vec3 v_position;  // view space

void main() {
  vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 2.0 - 1.0;
  v_onPlate = corner * (u_half + u_fade);
  v_position = u_centre + v_onPlate.x * u_right + v_onPlate.y * u_back;
  gl_Position = vec4(v_position.xy / u_tanHalf, 0.0, u_distance - v_position.z);
}
