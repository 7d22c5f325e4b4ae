// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer/line_drawing.h"

#include <array>
#include <cstddef>
#include <span>

#include "shaders.h"

namespace qrelief {
namespace {

constexpr float kHaloPx = 1.5f;
constexpr glm::vec4 kLightHalo{1.0f, 1.0f, 1.0f, 0.55f}, kDarkHalo{0.02f, 0.03f, 0.05f, 0.6f};

/// A stroke in the vertex buffer.
struct Record {
  std::array<float, 3> from, to, colour;
  std::array<float, 2> width;
};

std::array<float, 3> listed(Vec3f v) { return {v.x, v.y, v.z}; }

void describeRecord() {
  const std::array<std::pair<int, std::size_t>, 4> fields = {{{3, offsetof(Record, from)},
                                                              {3, offsetof(Record, to)},
                                                              {3, offsetof(Record, colour)},
                                                              {2, offsetof(Record, width)}}};
  for (GLuint location = 0; location < fields.size(); ++location) {
    const auto [size, offset] = fields[location];
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, size, GL_FLOAT, GL_FALSE, sizeof(Record),
                          reinterpret_cast<const void*>(offset));  // NOLINT(performance-no-int-to-ptr): GL wants it so
    glVertexAttribDivisor(location, 1);
  }
}

}  // namespace

Result<LinePass> LinePass::create() {
  auto program = gl::Program::create("view stroke", shaders::view_stroke_vert, shaders::view_stroke_frag);
  QRELIEF_TRY(program);
  LinePass pass;
  pass.program_ = std::move(*program);
  return pass;
}

void LinePass::set(const LineDrawing& drawing) {
  strokes_ = static_cast<int>(drawing.strokes.size());
  if (strokes_ == 0) return;
  origin_ = drawing.strokes.front().from;
  std::vector<Record> records;
  records.reserve(drawing.strokes.size());
  for (const Stroke& stroke : drawing.strokes)
    records.push_back({listed(Vec3f(stroke.from - origin_)),
                       listed(Vec3f(stroke.to - origin_)),
                       listed(stroke.colour),
                       {static_cast<float>(stroke.widthPx), static_cast<float>(stroke.endWidthPx)}});
  array_ = gl::VertexArray::create();
  array_.bind();
  buffer_ = gl::Buffer(GL_ARRAY_BUFFER, std::as_bytes(std::span(records)));
  describeRecord();
  glBindVertexArray(0);
}

void LinePass::draw(const CameraView& camera, bool dark) const {
  program_.set("u_right", Vec3f(camera.right));
  program_.set("u_up", Vec3f(camera.up));
  program_.set("u_back", Vec3f(camera.back));
  program_.set("u_target", Vec3f(camera.target - origin_));
  program_.set("u_haloColour", dark ? kDarkHalo : kLightHalo);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  array_.bind();
  for (const float halo : {kHaloPx, 0.0f}) {
    program_.set("u_halo", halo);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, strokes_);
  }
  glBindVertexArray(0);
  glDisable(GL_BLEND);
}

}  // namespace qrelief
