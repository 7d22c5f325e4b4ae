// SPDX-License-Identifier: GPL-3.0-or-later
#include "wasm/map_picture.h"

#include <algorithm>
#include <limits>

#include "shaders.h"

namespace qrelief {
namespace {

bool isOutside(const float* texel) { return texel[0] * texel[0] + texel[1] * texel[1] + texel[2] * texel[2] < 0.25f; }

}  // namespace

Result<MapPicture> MapPicture::create(const gl::Texture& map, const MapReading& reading, int sizePx) {
  MapPicture made;
  made.reading_ = reading;
  made.columns_ = map.width();
  made.rows_ = map.height();
  {
    const gl::Texture* const colours[] = {&map};
    const auto source = gl::Framebuffer::create(colours, false);
    if (!source) return tl::unexpected(source.error());
    made.texels_ = source->readRgba();
  }
  float lowest = std::numeric_limits<float>::max(), highest = std::numeric_limits<float>::lowest();
  for (std::size_t i = 0; i < made.texels_.size(); i += 4) {
    if (reading.hasSurface && isOutside(&made.texels_[i])) continue;
    const float value = made.texels_[i + static_cast<std::size_t>(reading.component)];
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
  }
  if (lowest <= highest) {
    made.lowest_ = lowest;
    made.highest_ = highest;
  }
  auto program = gl::Program::create("view map", shaders::fullscreen_vert, shaders::view_map_frag);
  if (!program) return tl::unexpected(program.error());
  made.picture_ = gl::Texture(sizePx, sizePx, gl::Format::RGBA8);
  const gl::Texture* const colours[] = {&made.picture_};
  const auto target = gl::Framebuffer::create(colours, false);
  if (!target) return tl::unexpected(target.error());
  target->bind();
  glDisable(GL_BLEND);
  glDisable(GL_SCISSOR_TEST);
  program->use();
  program->setTexture("u_map", 0, map);
  program->set("u_isNormal", reading.isNormal ? 1 : 0);
  program->set("u_component", reading.component);
  program->set("u_hasSurface", reading.hasSurface ? 1 : 0);
  program->set("u_topFirst", reading.topFirst ? 1 : 0);
  program->set("u_range", glm::vec2(made.lowest_, std::max(made.highest_, made.lowest_ + 1e-6f)));
  program->set("u_size", glm::vec2(sizePx, sizePx));
  gl::drawFullscreen();
  return made;
}

const float* MapPicture::texelAt(double across, double down) const {
  if (!(across >= 0 && across < 1 && down >= 0 && down < 1)) return nullptr;
  const auto column = static_cast<std::size_t>(across * columns_);
  auto row = static_cast<std::size_t>(down * rows_);
  if (!reading_.topFirst) row = static_cast<std::size_t>(rows_) - 1 - row;
  return &texels_[4 * (row * static_cast<std::size_t>(columns_) + column)];
}

}  // namespace qrelief
