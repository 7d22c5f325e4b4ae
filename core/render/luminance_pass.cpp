// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/luminance_pass.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <numeric>

#include "shaders.h"

namespace qrelief {
namespace {

Status makeTarget(gl::Texture& texture, gl::Framebuffer& framebuffer, int edge) {
  texture = gl::Texture(edge, edge, gl::Format::R32F);
  const gl::Texture* const colours[] = {&texture};
  auto made = gl::Framebuffer::create(colours, false);
  if (!made) return tl::unexpected(made.error());
  framebuffer = std::move(*made);
  framebuffer.bind();
  glClearColor(1, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  return {};
}

Status makeProgram(gl::Program& program, const char* name, const char* vertex, const char* fragment) {
  auto made = gl::Program::create(name, vertex, fragment);
  if (!made) return tl::unexpected(made.error());
  program = std::move(*made);
  return {};
}

}  // namespace

Result<LuminancePass> LuminancePass::create(const SurfaceMaps& maps, double eyeDistance,
                                            const LuminanceOptions& options) {
  assert(maps.window.texels % options.cellTexels == 0);
  LuminancePass pass;
  pass.maps_ = &maps;
  pass.eyeDistance_ = eyeDistance;
  pass.options_ = options;
  pass.cells_ = maps.window.texels / options.cellTexels;
  const std::vector<float> surface = maps.framebuffer.readRgba(0);
  pass.highestMm_ = std::numeric_limits<float>::lowest();
  for (std::size_t i = 0; i < surface.size(); i += 4)
    if (surface[i + 2] > 0) pass.highestMm_ = std::max(pass.highestMm_, surface[i + 3]);
  for (const Status& made :
       {makeProgram(pass.occlusion_, "occlusion", shaders::cells_vert, shaders::occlusion_frag),
        makeProgram(pass.lighting_, "lighting", shaders::fullscreen_vert, shaders::lighting_frag),
        makeProgram(pass.reduction_, "reduction", shaders::fullscreen_vert, shaders::reduction_frag),
        makeTarget(pass.visibility_, pass.visibilityTarget_, maps.window.texels),
        makeTarget(pass.luminance_, pass.luminanceTarget_, maps.window.texels),
        makeTarget(pass.means_, pass.meansTarget_, pass.cells_)})
    if (!made) return tl::unexpected(made.error());
  pass.depths_ = gl::Texture(pass.cells_, pass.cells_, gl::Format::R32F);
  pass.setDepths(
      std::vector<float>(static_cast<std::size_t>(pass.cells_) * static_cast<std::size_t>(pass.cells_), 0.0f));
  pass.cellArray_ = gl::VertexArray::create();
  std::vector<std::uint32_t> all(static_cast<std::size_t>(pass.cells_) * static_cast<std::size_t>(pass.cells_));
  std::iota(all.begin(), all.end(), 0u);
  pass.selectCells(all);
  return pass;
}

void LuminancePass::setDepths(std::span<const float> depthsMm) {
  assert(depthsMm.size() == static_cast<std::size_t>(cells_) * static_cast<std::size_t>(cells_));
  depths_.upload(depthsMm.data());
}

void LuminancePass::selectCells(std::span<const std::uint32_t> cells) {
  // Neighbours in a row become one rectangle, all cells a single one: a renderer works on blocks of texels and wastes
  // those that a rectangle's edges cut.
  std::vector<glm::vec4> rectangles;
  const auto edge = static_cast<std::uint32_t>(cells_);
  if (cells.size() == static_cast<std::size_t>(edge) * edge) {
    rectangles.emplace_back(0, 0, edge, edge);
  } else {
    std::vector<std::uint32_t> sorted(cells.begin(), cells.end());
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      const bool continues = i > 0 && sorted[i] == sorted[i - 1] + 1 && sorted[i] % edge != 0;
      if (continues)
        rectangles.back().z += 1;
      else
        rectangles.emplace_back(sorted[i] % edge, sorted[i] / edge, 1, 1);
    }
  }
  cellArray_.bind();
  cellBuffer_ = gl::Buffer(GL_ARRAY_BUFFER, std::as_bytes(std::span(rectangles)));
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, 0, nullptr);
  glVertexAttribDivisor(0, 1);
  glBindVertexArray(0);
  selected_ = static_cast<GLsizei>(rectangles.size());
}

void LuminancePass::run() {
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  const double texelMm = maps_->window.texelMm();

  visibilityTarget_.bind();
  occlusion_.use();
  occlusion_.setTexture("u_surface", 0, maps_->surface);
  occlusion_.setTexture("u_depth", 1, depths_);
  occlusion_.set("u_eyeDistance", static_cast<float>(eyeDistance_));
  occlusion_.set("u_texelMm", static_cast<float>(texelMm));
  occlusion_.set("u_mapTexels", static_cast<float>(maps_->window.texels));
  occlusion_.set("u_cellTexels", static_cast<float>(options_.cellTexels));
  occlusion_.set("u_cellsAlongEdge", static_cast<float>(cells_));
  occlusion_.set("u_slices", options_.slices);
  occlusion_.set("u_radiusTexels", static_cast<float>(options_.radiusMm / texelMm));
  occlusion_.set("u_highestMm", highestMm_);
  occlusion_.set("u_rotate", options_.turnSlices ? 1 : 0);
  cellArray_.bind();
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, selected_);

  luminanceTarget_.bind();
  lighting_.use();
  lighting_.setTexture("u_visibility", 0, visibility_);
  lighting_.set("u_albedo", options_.albedo);
  gl::drawFullscreen();

  meansTarget_.bind();
  reduction_.use();
  reduction_.setTexture("u_map", 0, luminance_);
  reduction_.set("u_cellTexels", options_.cellTexels);
  gl::drawFullscreen();
}

std::vector<float> LuminancePass::readCellMeans() const { return meansTarget_.readRed(); }
std::vector<float> LuminancePass::readLuminance() const { return luminanceTarget_.readRed(); }
std::vector<float> LuminancePass::readVisibility() const { return visibilityTarget_.readRed(); }

}  // namespace qrelief
