// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/luminance_pass.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <numeric>
#include <optional>

#include "gl/pass_timings.h"
#include "shaders.h"

namespace qrelief {
namespace {

constexpr int kHorizonDirections = 16;                      // as in horizon.frag
constexpr int kHorizonTexels = kHorizonDirections / 4 + 1;  // of a place: the last one is of the lamps

Status makeTarget(gl::Texture& texture, gl::Framebuffer& framebuffer, int width, int height, gl::Format format) {
  texture = gl::Texture(width, height, format);
  const gl::Texture* const colours[] = {&texture};
  auto created = gl::Framebuffer::create(colours, false);
  QRELIEF_TRY(created);
  framebuffer = std::move(*created);
  framebuffer.bind();
  glClearColor(1, 1, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  return {};
}

Status makeProgram(gl::Program& program, const char* name, const char* vertex, const char* fragment) {
  auto created = gl::Program::create(name, vertex, fragment);
  QRELIEF_TRY(created);
  program = std::move(*created);
  return {};
}

}  // namespace

Result<std::shared_ptr<const LuminancePrograms>> LuminancePrograms::create() {
  auto programs = std::make_shared<LuminancePrograms>();
  for (const Status& status :
       {makeProgram(programs->horizon, "horizon", shaders::fullscreen_vert, shaders::horizon_frag),
        makeProgram(programs->occlusion, "occlusion", shaders::fullscreen_vert, shaders::hbao_frag),
        makeProgram(programs->reduction, "reduction", shaders::listed_submodules_vert, shaders::reduction_frag),
        makeProgram(programs->lighting, "lighting", shaders::fullscreen_vert, shaders::lighting_frag),
        makeProgram(programs->floorDifference, "floor-difference", shaders::fullscreen_vert,
                    shaders::floor_difference_frag),
        makeProgram(programs->floorSolution, "floor-solution", shaders::fullscreen_vert, shaders::floor_solution_frag),
        makeProgram(programs->floorDepth, "floor-depth", shaders::fullscreen_vert, shaders::floor_depth_frag),
        makeProgram(programs->floorRecord, "floor-record", shaders::fullscreen_vert, shaders::floor_record_frag)})
    QRELIEF_TRY(status);
  return std::shared_ptr<const LuminancePrograms>(std::move(programs));
}

Result<LuminancePass> LuminancePass::create(const SurfaceMaps& maps, const SurfaceMaps* surroundings,
                                            double eyeDistance, const LuminanceOptions& options,
                                            std::shared_ptr<const LuminancePrograms> programs) {
  assert(maps.window.texels % options.cellTexels == 0);
  assert(options.lights.size() <= kMaxLights);
  LuminancePass pass;
  pass.maps_ = &maps;
  pass.eyeDistance_ = eyeDistance;
  pass.options_ = options;
  pass.cells_ = maps.window.texels / options.cellTexels;
  pass.programs_ = std::move(programs);
  if (!pass.programs_) {
    auto compiled = LuminancePrograms::create();
    QRELIEF_TRY(compiled);
    pass.programs_ = std::move(*compiled);
  }
  const int texels = maps.window.texels;
  for (const Status& status :
       {makeTarget(pass.received_, pass.receivedTarget_, texels, texels, gl::Format::RGBA32F),
        makeTarget(pass.means_, pass.meansTarget_, pass.cells_, pass.cells_, gl::Format::RGBA32F),
        makeTarget(pass.luminance_, pass.luminanceTarget_, pass.cells_, pass.cells_, gl::Format::R32F)})
    QRELIEF_TRY(status);
  pass.depths_ = gl::Texture(pass.cells_, pass.cells_, gl::Format::R32F);
  pass.setDepths(
      std::vector<float>(static_cast<std::size_t>(pass.cells_) * static_cast<std::size_t>(pass.cells_), 0.0f));
  QRELIEF_TRY(pass.findHorizon(surroundings));
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

int LuminancePass::computedTexels() const {
  int texels = std::min(options_.sampling.computedTexels, options_.cellTexels);
  while (options_.cellTexels % texels != 0) ++texels;
  return texels;
}

void LuminancePass::selectCells(std::span<const std::uint32_t> cells) {
  const auto edge = static_cast<std::uint32_t>(cells_);
  assert(!cells.empty() && cells.size() <= std::size_t{edge} * edge);
  const bool all = cells.size() == std::size_t{edge} * edge;
  std::vector<glm::vec4> places;
  for (std::uint32_t entry = 0; entry < cells.size(); ++entry) {
    const std::uint32_t computed = all ? cells[entry] : entry;
    places.emplace_back(cells[entry] % edge, cells[entry] / edge, computed % edge, computed / edge);
  }
  cellArray_.bind();
  cellBuffer_ = gl::Buffer(GL_ARRAY_BUFFER, std::as_bytes(std::span(places)));
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, 0, nullptr);
  glBindVertexArray(0);
  selected_ = static_cast<GLsizei>(cells.size());
  if (all) return;
  places.resize(static_cast<std::size_t>(listRows() * cells_));
  list_ = gl::Texture(cells_, listRows(), gl::Format::RGBA32F, places.data());
}

void LuminancePass::setMap(const gl::Program& program, const gl::Texture& depths) const {
  program.use();
  program.setTexture("u_surface", 0, maps_->surface);
  program.setTexture("u_depth", 1, depths);
  program.set("u_eyeDistance", static_cast<float>(eyeDistance_));
  program.set("u_texelMm", static_cast<float>(maps_->window.texelMm()));
  program.set("u_mapTexels", static_cast<float>(maps_->window.texels));
  program.set("u_cellTexels", static_cast<float>(options_.cellTexels));
  program.set("u_horizonSamples", static_cast<float>(options_.horizonSamples));
}

void LuminancePass::setLamps(const gl::Program& program) const {
  std::array<glm::vec4, kMaxLights> lamps{};
  for (std::size_t i = 0; i < options_.lights.size(); ++i)
    lamps[i] = glm::vec4(Vec3f(towards(options_.lights[i])), static_cast<float>(options_.lights[i].strength));
  program.set("u_lampCount", static_cast<int>(options_.lights.size()));
  program.set("u_lamps[0]", lamps[0]);
  program.set("u_lamps[1]", lamps[1]);
}

Status LuminancePass::findHorizon(const SurfaceMaps* surroundings) {
  const gl::TimedPass timed("horizon");
  const gl::Program& program = programs_->horizon;
  gl::Framebuffer target;
  QRELIEF_TRY(makeTarget(horizon_, target, kHorizonTexels * options_.horizonSamples, options_.horizonSamples,
                         gl::Format::RGBA32F));
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  setMap(program, depths_);
  program.setTexture("u_surroundings", 2, surroundings ? surroundings->surface : maps_->surface);
  program.set("u_surroundingsTexels", surroundings ? static_cast<float>(surroundings->window.texels) : 0.0f);
  program.set("u_surroundingsTexelMm", surroundings ? static_cast<float>(surroundings->window.texelMm()) : 1.0f);
  setLamps(program);
  program.set("u_startTexels", static_cast<float>(options_.horizonStartMm / maps_->window.texelMm()));
  gl::drawFullscreen();
  return {};
}

void LuminancePass::run(const gl::Texture& depths, bool onlyDue) {
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);

  const int texels = computedTexels();
  std::optional<gl::TimedPass> timed(std::in_place, "occlusion");
  receivedTarget_.bind();
  glViewport(0, 0, cells_ * texels, listRows() * texels);
  const gl::Program &occlusion = programs_->occlusion, &reduction = programs_->reduction,
                    &lighting = programs_->lighting;
  setMap(occlusion, depths);
  occlusion.setTexture("u_horizon", 2, horizon_);
  occlusion.set("u_slices", options_.sampling.slices);
  occlusion.set("u_radiusTexels", static_cast<float>(options_.radiusMm / maps_->window.texelMm()));
  occlusion.set("u_everyBorderTexels", static_cast<float>(options_.everyBorderMm / maps_->window.texelMm()));
  occlusion.set("u_reliefMm", options_.reliefMm);
  occlusion.set("u_turnSlices", options_.turnSlices ? 1 : 0);
  occlusion.set("u_computedTexels", texels);
  occlusion.set("u_stride", options_.cellTexels / texels);
  occlusion.set("u_cellsPerPixel", 1 / static_cast<float>(texels));
  occlusion.set("u_listed", listed());
  occlusion.set("u_onlyDue", onlyDue ? 1 : 0);
  occlusion.setTexture("u_list", 3, listed() ? list_ : horizon_);
  setLamps(occlusion);
  gl::drawFullscreen();

  timed.emplace("reduction");
  meansTarget_.bind();
  reduction.use();
  reduction.setTexture("u_map", 0, received_);
  reduction.set("u_computedTexels", texels);
  reduction.set("u_cellsAlongEdge", static_cast<float>(cells_));
  cellArray_.bind();
  glDrawArrays(GL_POINTS, 0, selected_);

  timed.emplace("lighting");
  luminanceTarget_.bind();
  lighting.use();
  lighting.setTexture("u_received", 0, means_);
  lighting.set("u_albedo", options_.albedo);
  lighting.set("u_openIrradiance", static_cast<float>(openIrradiance(options_.lights)));
  gl::drawFullscreen();
}

std::vector<float> LuminancePass::readLuminance() const { return luminanceTarget_.readRed(); }

std::vector<Received> LuminancePass::readReceived() const {
  const std::vector<float> means = meansTarget_.readRgba();
  std::vector<Received> received(means.size() / 4);
  for (std::size_t i = 0; i < received.size(); ++i)
    received[i] = {means[4 * i], means[4 * i + 1], means[4 * i + 2], means[4 * i + 3]};
  return received;
}

void LuminancePass::setReceived(std::span<const Received> received) {
  static_assert(sizeof(Received) == 4 * sizeof(float));  // the size of a texel of the means
  assert(received.size() == static_cast<std::size_t>(cells_) * static_cast<std::size_t>(cells_));
  means_.upload(received.data());
}

}  // namespace qrelief
