// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer/grid_plane.h"

namespace qrelief {

void drawGridPlane(const gl::Program& program, const GridPlane& plane, const CameraView& camera) {
  program.set("u_centre", camera.pointInView(plane.centre));
  program.set("u_right", camera.inView(plane.right));
  program.set("u_back", camera.inView(plane.back));
  program.set("u_half", glm::vec2(plane.halfMm));
  program.set("u_fade", static_cast<float>(plane.fadeMm));
  program.set("u_line", plane.line);
  program.set("u_ground", plane.ground);
  glBindVertexArray(0);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glDisable(GL_BLEND);
}

}  // namespace qrelief
