// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/floor_passes.h"

#include <cassert>

#include "gl/pass_timings.h"

namespace qrelief {
namespace {

constexpr int kDirections = 16;  // as in depth_search.glsl

std::size_t square(int edge) { return static_cast<std::size_t>(edge) * static_cast<std::size_t>(edge); }

}  // namespace

Result<FloorPasses::PingPong> FloorPasses::PingPong::create(int edge, gl::Format format) {
  PingPong pingPong;
  for (std::size_t i = 0; i < 2; ++i) {
    pingPong.textures[i] = gl::Texture(edge, edge, format);
    const gl::Texture* const colours[] = {&pingPong.textures[i]};
    auto target = gl::Framebuffer::create(colours, false);
    QRELIEF_TRY(target);
    pingPong.targets[i] = std::move(*target);
  }
  return pingPong;
}

Result<FloorPasses> FloorPasses::create(const Setup& setup, std::shared_ptr<const LuminancePrograms> programs) {
  assert(!setup.cells.empty() && setup.steps.size() % kDirections == 0);
  FloorPasses passes;
  passes.setup_ = setup;
  passes.programs_ = std::move(programs);
  const int edge = setup.cellsAlongEdge;
  auto floors = PingPong::create(edge, gl::Format::RGBA32F);
  QRELIEF_TRY(floors);
  passes.floors_ = std::move(*floors);
  auto solved = PingPong::create(edge, gl::Format::R32F);
  QRELIEF_TRY(solved);
  passes.solved_ = std::move(*solved);
  passes.steps_ = gl::Texture(kDirections, static_cast<int>(setup.steps.size()) / kDirections, gl::Format::RGBA32F,
                              setup.steps.data());
  std::vector<glm::vec4> places;
  for (const std::uint32_t cell : setup.cells)
    places.emplace_back(cell % static_cast<std::uint32_t>(edge), cell / static_cast<std::uint32_t>(edge), 0, 0);
  places.resize(static_cast<std::size_t>(passes.listRows()) * static_cast<std::size_t>(edge));
  passes.list_ = gl::Texture(edge, passes.listRows(), gl::Format::RGBA32F, places.data());
  passes.records_ = gl::Texture(edge, passes.listRows() * setup.records, gl::Format::RGBA32F);
  const gl::Texture* const colours[] = {&passes.records_};
  auto target = gl::Framebuffer::create(colours, false);
  QRELIEF_TRY(target);
  passes.recordsTarget_ = std::move(*target);
  return passes;
}

void FloorPasses::setTargets(std::span<const FloorTarget> targets) {
  assert(targets.size() == setup_.cells.size());
  std::vector<glm::vec4> texels(square(edge()), glm::vec4(0));
  for (std::size_t k = 0; k < targets.size(); ++k)
    texels[setup_.cells[k]] = {targets[k].around, targets[k].greatestFraction, targets[k].limitMm, 1};
  targets_ = gl::Texture(edge(), edge(), gl::Format::RGBA32F, texels.data());
}

void FloorPasses::start(float depthMm, float difference) {
  std::vector<glm::vec4> floors(square(edge()), glm::vec4(0));
  std::vector<float> solved(floors.size(), 0.0f);
  for (const std::uint32_t cell : setup_.cells) {
    floors[cell].y = difference;
    solved[cell] = depthMm;
  }
  floors_.textures[floors_.current].upload(floors.data());
  solved_.textures[solved_.current].upload(solved.data());
}

const gl::Program& FloorPasses::use(const gl::Program& program, const gl::Texture& luminance) const {
  glDisable(GL_BLEND);
  program.use();
  program.setTexture("u_floors", 0, floors_.now());
  program.setTexture("u_targets", 1, targets_);
  program.setTexture("u_steps", 2, steps_);
  program.setTexture("u_luminance", 3, luminance);
  program.set("u_stepCount", steps_.height());
  program.set("u_quantum", glm::vec2(setup_.quantumMm, 1 / setup_.quantumMm));
  return program;
}

void FloorPasses::compare(const gl::Texture& luminance, bool all, bool isFirst) {
  const gl::TimedPass timed("comparing");
  floors_.bindNext();
  const gl::Program& program = use(programs_->floorDifference, luminance);
  program.set("u_all", all ? 1 : 0);
  program.set("u_isFirst", isFirst ? 1 : 0);
  gl::drawFullscreen();
  floors_.flip();
}

void FloorPasses::move(const gl::Texture& luminance, const FloorMove& how) {
  const gl::TimedPass timed("solving");
  const gl::Program& solution = use(programs_->floorSolution, luminance);
  solution.set("u_aim", how.aim);
  solution.set("u_lastAim", how.aimForTooBright);
  solution.set("u_changeFraction", how.changeFraction);
  solution.set("u_maxChange", how.maxChange);
  for (int sweep = 0; sweep < how.sweeps; ++sweep) {
    solved_.bindNext();
    solution.setTexture("u_solved", 4, solved_.now());
    gl::drawFullscreen();
    solved_.flip();
  }
  floors_.bindNext();
  const gl::Program& depth = use(programs_->floorDepth, luminance);
  depth.setTexture("u_solved", 4, solved_.now());
  depth.set("u_isFree", how.isFree ? 1 : 0);
  depth.set("u_leastGrowthMm", how.leastGrowthMm);
  gl::drawFullscreen();
  floors_.flip();
}

void FloorPasses::record(const gl::Texture& luminance, int record) {
  assert(record < setup_.records);
  recordsTarget_.bind();
  glViewport(0, record * listRows(), edge(), listRows());
  const gl::Program& program = programs_->floorRecord;
  program.use();
  program.setTexture("u_floors", 0, floors_.now());
  program.setTexture("u_luminance", 1, luminance);
  program.setTexture("u_list", 2, list_);
  program.set("u_firstRow", record * listRows());
  gl::drawFullscreen();
}

std::vector<FloorPasses::Recorded> FloorPasses::readRecords(int count) const {
  assert(count <= setup_.records);
  const std::vector<float> texels = recordsTarget_.readRgba();
  std::vector<Recorded> read;
  const std::size_t perRecord = static_cast<std::size_t>(listRows()) * static_cast<std::size_t>(edge());
  for (std::size_t record = 0; record < static_cast<std::size_t>(count); ++record)
    for (std::size_t k = 0; k < setup_.cells.size(); ++k) {
      const float* const texel = &texels[4 * (record * perRecord + k)];
      read.push_back({texel[0], texel[1]});
    }
  return read;
}

}  // namespace qrelief
