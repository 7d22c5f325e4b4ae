// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "gl/objects.h"
#include "math/vec.h"
#include "viewer/grid_plane.h"
#include "viewer/orbit_camera.h"

namespace qrelief {

/// A straight line of constant width on the screen, or, without length, a dot.
struct Stroke {
  Vec3 from{0}, to{0};                 ///< mm, model space
  Vec3f colour{0};                     ///< sRGB
  double widthPx = 2, endWidthPx = 2;  ///< device pixels, at `from` and `to`; they differ for the head of an arrow

  bool operator==(const Stroke&) const = default;
};

/// Lines over the model, and a plane among them.
struct LineDrawing {
  std::vector<Stroke> strokes;  ///< later ones over earlier ones
  std::optional<GridPlane> plane;

  bool operator==(const LineDrawing&) const = default;
};

/// Draws a LineDrawing over a presented picture. What the model hides of its lines is faint; it hides the plane.
///
/// Needs the GL context that was current when it was made.
class LinePass {
 public:
  static Result<LinePass> create();

  void set(const LineDrawing& drawing);
  bool isEmpty() const { return strokes_ == 0; }
  /// The program of the strokes, whose uniforms of view_sight.glsl draw() needs.
  const gl::Program& program() const { return program_; }
  void draw(const CameraView& camera, bool dark) const;

 private:
  gl::Program program_;
  gl::Buffer buffer_;
  gl::VertexArray array_;
  Vec3 origin_{0};
  int strokes_ = 0;
};

}  // namespace qrelief
