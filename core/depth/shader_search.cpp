// SPDX-License-Identifier: GPL-3.0-or-later
#include "depth/shader_search.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "depth/fast_search.h"
#include "depth/light_neighbours.h"
#include "depth/pocket_sky.h"

namespace qrelief {
namespace {

constexpr int kN = kSubmodulesPerModule;
// Passes of a batch: nearly all searches end with the first.
constexpr int kFirstBatch = 9;  // after the passes in which depths may rise and fall
constexpr int kNextBatch = 4;
constexpr int kMostRecords = kFirstBatch + kFreePasses;

/// Rounds a depth that a shader computed to the nearest depth of the files: floats are off in the last digit.
double inFiles(float depthMm) { return std::round(static_cast<double>(depthMm) / kDepthQuantumMm) * kDepthQuantumMm; }

}  // namespace

std::vector<glm::vec4> floorSteps(int size, double submoduleMm) {
  const auto paths = floorPaths(size, submoduleMm);
  std::vector<glm::vec4> steps;
  for (std::size_t k = 0; k < paths.size(); ++k)
    for (std::size_t step = 0; step < paths[k].size(); ++step) {
      const std::size_t at = step * paths.size() + k;
      if (at >= steps.size()) steps.resize((step + 1) * paths.size(), glm::vec4(0));
      const auto& [cell, perMm] = paths[k][step];
      steps[at] = {cell.x, -cell.y, perMm, 0};  // maps count rows upwards
    }
  return steps;
}

ShaderSearch::ShaderSearch(CarvingTarget target, Place place) : target_(std::move(target)), place_(std::move(place)) {
  const SubmoduleMask& mask = *target_.mask;
  depths_ = {mask.rows(), target_.symbolMm, std::vector<double>(mask.size(), 0)};
  const LightNeighbours neighbours(*target_.symbol);
  const Grid<double> modules = moduleMeans(place_.luminance);
  for (std::uint32_t i = 0; i < mask.size(); ++i) {
    if (!mask[i]) continue;
    carved_.push_back(i);
    const int row = static_cast<int>(i) / mask.rows(), column = static_cast<int>(i) % mask.rows();
    around_.push_back(
        neighbours.darkestMean(static_cast<std::size_t>(row / kN * target_.symbol->size + column / kN), modules));
  }
  assert(place_.cells.size() == carved_.size());
}

Result<std::unique_ptr<ShaderSearch>> ShaderSearch::create(CarvingTarget target, const FastSearchOptions& options,
                                                           Place place) {
  std::unique_ptr<ShaderSearch> search(new ShaderSearch(std::move(target), std::move(place)));
  const CarvingTarget& ownTarget = search->target_;
  LuminancePass& light = *search->place_.light;
  auto passes = FloorPasses::create({.cellsAlongEdge = light.cellsAlongEdge(),
                                     .cells = search->place_.cells,
                                     .steps = floorSteps(ownTarget.mask->rows(), search->depths_.submoduleMm()),
                                     .quantumMm = static_cast<float>(kDepthQuantumMm),
                                     .records = kMostRecords},
                                    light.programs());
  QRELIEF_TRY(passes);
  search->passes_ = std::move(*passes);
  search->passes_.start(static_cast<float>(kFirstDepthModules * ownTarget.symbolMm / ownTarget.symbol->size),
                        static_cast<float>(firstDifference(static_cast<double>(options.albedo))));
  light.selectCells(search->place_.cells);
  search->restart(options);
  search->freePasses_ = kFreePasses;
  return search;
}

void ShaderSearch::restart(const FastSearchOptions& options) {
  assert(!options.hasLamps);
  options_ = options;
  targets_.clear();
  for (std::size_t k = 0; k < carved_.size(); ++k) {
    const int row = static_cast<int>(carved_[k]) / depths_.size, column = static_cast<int>(carved_[k]) % depths_.size;
    const auto module = static_cast<std::size_t>(row / kN * target_.symbol->size + column / kN);
    const double contrast = options.contrastOfModule.empty() ? options.contrast : options.contrastOfModule[module];
    targets_.push_back(
        {static_cast<float>(around_[k]), static_cast<float>(1 - contrast),
         static_cast<float>(quantisedDepth(std::numeric_limits<double>::max(), target_.limitMm[carved_[k]]))});
  }
  passes_.setTargets(targets_);
  freePasses_ = kFreePassesAfterAnother;
  iterations_ = readBacks_ = 0;
  finished_ = false;
}

bool ShaderSearch::measuresAll(int pass, int freePasses) {
  const int sinceFirstBatch = pass + 1 - (freePasses + kFirstBatch);
  return pass <= freePasses || (sinceFirstBatch >= 0 && sinceFirstBatch % kNextBatch == 0);
}

void ShaderSearch::runPass(int record, bool isLast) {
  const bool isFirst = iterations_ == 0, all = isLast || measuresAll(iterations_, freePasses_);
  LuminancePass& light = *place_.light;
  const FloorMove move{.sweeps = kSweepsPerPass,
                       .aim = static_cast<float>(kAimFraction),
                       .aimForTooBright = static_cast<float>(aimForTooBright(iterations_, freePasses_)),
                       .changeFraction = static_cast<float>(isFirst ? 0 : kChangeFraction),
                       .maxChange = static_cast<float>(kMaxChange),
                       .leastGrowthMm = static_cast<float>(leastGrowthMm(options_, iterations_)),
                       .isFree = iterations_ < freePasses_};
  passes_.move(light.luminance(), move);
  light.runOnFloors(passes_.floors(), !all);
  passes_.compare(light.luminance(), all, isFirst);
  passes_.record(light.luminance(), record);
  ++iterations_;
}

std::vector<SearchRecord::Pass> ShaderSearch::advance() {
  assert(!finished_);
  const int batch = iterations_ == 0 ? freePasses_ + kFirstBatch : kNextBatch;
  const int count = std::min(batch, options_.maxIterations - iterations_);
  for (int pass = 0; pass < count; ++pass) runPass(pass, pass + 1 == count);
  const std::vector<FloorPasses::Recorded> recorded = passes_.readRecords(count);
  ++readBacks_;
  std::vector<SearchRecord::Pass> measured(static_cast<std::size_t>(count));
  for (std::size_t at = 0; at < recorded.size(); ++at) {
    SearchRecord::Pass& pass = measured[at / carved_.size()];
    pass.depthMm.push_back(static_cast<float>(inFiles(recorded[at].depthMm)));
    pass.luminance.push_back(recorded[at].luminance);
  }
  take(measured.back());
  return measured;
}

void ShaderSearch::take(const SearchRecord::Pass& last) {
  limited_ = tooBright_ = 0;
  for (std::size_t k = 0; k < carved_.size(); ++k) {
    const int row = static_cast<int>(carved_[k]) / depths_.size, column = static_cast<int>(carved_[k]) % depths_.size;
    depths_.depthMm[carved_[k]] = inFiles(last.depthMm[k]);
    place_.luminance.at(row + kQuietZoneSubmodules, column + kQuietZoneSubmodules) =
        static_cast<double>(last.luminance[k]);
    if (last.luminance[k] <= targets_[k].greatestFraction * targets_[k].around) continue;
    ++(last.depthMm[k] < targets_[k].limitMm - static_cast<float>(kDepthQuantumMm) / 2 ? tooBright_ : limited_);
  }
  doneFraction_ = 1 - static_cast<double>(tooBright_) / static_cast<double>(carved_.size());
  finished_ = tooBright_ == 0 || iterations_ >= options_.maxIterations;
}

}  // namespace qrelief
