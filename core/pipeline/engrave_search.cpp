// SPDX-License-Identifier: GPL-3.0-or-later
// Implements the depth search of EngraveJob (engrave.h).
#include <algorithm>

#include "base/clock.h"
#include "depth/submodule_luminances.h"
#include "pipeline/contrast_for_print.h"
#include "pipeline/depth_solver_of.h"
#include "pipeline/engrave_state.h"

namespace qrelief {
namespace {

constexpr int kN = kSubmodulesPerModule;
constexpr double kLeastReachModules = 3;

}  // namespace

void EngraveJob::State::startSearch() {
  if (makeOwnSearch) {
    search = makeOwnSearch(target);
  } else if (request.isForPrint()) {
    auto rough = makeSearchBeforePrint(request, target);
    searchBeforePrint = rough.get();
    search = std::move(rough);
  } else {
    search = makeDepthSolver(request, target);
  }
}

/// Measures the luminance of the submodules that the search requests, at its depths.
void EngraveJob::State::measure() {
  const std::span<const std::uint32_t> due = search->due().empty() ? allCarved : search->due();
  std::vector<std::uint32_t> cells;
  for (const std::uint32_t i : due)
    cells.push_back(layout.ofSymbol(static_cast<int>(i) / mask.size, static_cast<int>(i) % mask.size));
  std::vector<float> depths(static_cast<std::size_t>(layout.cells()) * static_cast<std::size_t>(layout.cells()), 0.0f);
  double deepest = 0;
  for (int row = 0; row < mask.size; ++row) {
    for (int column = 0; column < mask.size; ++column) {
      const double depth = search->depths().depth(row, column);
      depths[layout.ofSymbol(row, column)] = static_cast<float>(depth);
      deepest = std::max(deepest, depth);
    }
  }
  means = measured->light().luminance(
      cells, depths, std::max(kLeastReachModules * result.placement.moduleMm, kReachPerDepth * deepest));
}

void EngraveJob::State::startRecord(std::span<const double> limitMm) {
  for (std::size_t i = 0; i < mask.carved.size(); ++i) {
    if (!mask.carved[i]) continue;
    result.search.carved.push_back(static_cast<std::uint32_t>(i));
    result.search.limitMm.push_back(static_cast<float>(limitMm[i]));
  }
}

void EngraveJob::State::recordPass(const DepthField& tried, std::span<const double> luminance, double ms) {
  const SubmoduleLuminances seen(luminance, symbol.size);
  SearchRecord::Pass made;
  made.ms = ms;
  for (const std::uint32_t i : result.search.carved) {
    const int row = static_cast<int>(i) / mask.size, column = static_cast<int>(i) % mask.size;
    made.depthMm.push_back(static_cast<float>(tried.depthMm[i]));
    made.luminance.push_back(static_cast<float>(seen.of(row, column)));
  }
  result.search.passes.push_back(std::move(made));
  result.search.luminance.assign(luminance.begin(), luminance.end());
}

Status EngraveJob::State::searchOnce() {
  const auto start = Clock::now();
  measure();
  const int edge = kN * (symbol.size + 2 * kQuietZoneModules);
  std::vector<double> luminance(static_cast<std::size_t>(edge * edge));
  for (int row = 0; row < edge; ++row)
    for (int column = 0; column < edge; ++column)
      luminance[static_cast<std::size_t>(row * edge + column)] = means[layout.ofQuietZone(row, column)];
  const DepthField tried = request.depth.recordSearch ? search->depths() : DepthField{};
  search->update(luminance);
  const double ms = millisecondsSince(start);
  result.timingsMs.depthSearch += ms;
  if (request.depth.recordSearch) recordPass(tried, luminance, ms);
  if (!search->finished()) return {};
  result.depths = search->depths();
  result.searchIterations += search->iterations();
  result.limitedSubmodules = search->limitedCount();
  result.luminance = std::move(luminance);
  const std::vector<Received> received = measured->light().received();
  result.received.clear();
  for (int row = 0; row < edge; ++row)
    for (int column = 0; column < edge; ++column) result.received.push_back(received[layout.ofQuietZone(row, column)]);
  if (summarise(result.depths).maxMm == 0)
    return fail(ErrorKind::NoSolution,
                message("nothing-can-be-carved", with::lengthMm<"wall">(request.depth.minWallMm)));
  stage = Stage::Embedding;
  return {};
}

}  // namespace qrelief
