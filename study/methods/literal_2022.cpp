// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/methods/literal_2022.h"

#include <algorithm>

#include "base/clock.h"
#include "study/methods/by_engine.h"

namespace qrelief::study {
namespace {

constexpr double kFirstDepthMm = 0.1;                         // O(x) for x = 1, and the layers of the paper's prints
constexpr double kReachPerDepth = 8, kLeastReachModules = 3;  // of the exact light, as in pipeline/depth_search_run.cpp

CellLayout layoutOf(const StudyPlacement& spot) { return {spot.symbol.size}; }

MapWindow windowOf(const StudyPlacement& spot) {
  const int cells = layoutOf(spot).cells();
  return {spot.submoduleMm() * cells, cells};
}

HeightMap heightsOver(const StudyPlacement& spot, const MapWindow& window) {
  const ProjectionFrame& frame = spot.placement.frame;
  return heightMapOf(spot.model->raster->draw(frame, window), window.texels, window.texelMm(), frame.eyeDistance);
}

std::unique_ptr<PlacementLight> lightOf(const StudyPlacement& spot, const EngraveRequest& request,
                                        const LiteralOptions& options) {
  const MapWindow window = windowOf(spot);
  const PlacementLightOptions light{layoutOf(spot).cells() / CellLayout::kN, spot.placement.moduleMm,
                                    static_cast<float>(request.marking.surfaceAlbedo()), request.lamps()};
  HeightMap map = heightsOver(spot, window);
  if (options.hbao) return std::make_unique<HbaoLight>(std::move(map), light, *options.hbao);
  const MapWindow around = surroundingsOf(window, spot.placement.frame, spot.model->box);
  return lightByProcessor(map, heightsOver(spot, around), light);
}

/// Returns the luminances that a DepthSolver reads, of a light's cells.
Grid<double> ofQuietZone(const std::vector<float>& cells, const CellLayout& layout) {
  const int edge = CellLayout::kN * (layout.modules + 2 * kQuietZoneModules);
  Grid<double> picked(edge, edge);
  for (int row = 0; row < edge; ++row)
    for (int column = 0; column < edge; ++column)
      picked.at(row, column) = static_cast<double>(cells[layout.ofQuietZone(row, column)]);
  return picked;
}

}  // namespace

Result<CarvedCode> carveBySearch(const std::string& search, const StudyPlacement& spot, const EngraveRequest& request) {
  return search == kLiteralSearch ? carveLiteral2022(spot, request) : carveByEngine(spot, request);
}

std::string versionOfSearch(const std::string& search, std::initializer_list<Part> others) {
  const std::string own = search == kLiteralSearch ? versionOf({kLiteral, kSearch}) : versionOf({kSearch});
  return others.size() == 0 ? own : own + " " + versionOf(others);
}

HeightMap cellHeights(const StudyPlacement& spot) { return heightsOver(spot, windowOf(spot)); }

Result<CarvedCode> carveLiteral2022(const StudyPlacement& spot, const EngraveRequest& request,
                                    const LiteralOptions& options) {
  const auto start = Clock::now();
  CarvedCode code{spot.symbol, {}, {}, {}};
  code.mask = submodulesToCarve(code.symbol, *request.code.modulePattern, *request.code.finderPattern);
  const CellLayout layout = layoutOf(spot);
  const std::vector<std::uint32_t> carved = carvedOf(code.mask);
  std::vector<std::uint32_t> cells;
  for (const std::uint32_t i : carved)
    cells.push_back(layout.ofSymbol(static_cast<int>(i) / code.mask.rows(), static_cast<int>(i) % code.mask.rows()));
  const std::unique_ptr<PlacementLight> light = lightOf(spot, request, options);

  DepthSearchOptions search;
  search.contrast = request.depth.contrastAsked();
  search.surroundings = options.surroundings;
  search.initialDepthMm = kFirstDepthMm;
  search.significantChange = options.significantChange;
  search.changeSince = options.changeSince;
  search.roundSteps = options.roundSteps;
  search.maxIterations = options.maxPasses;
  PaperStepSearch solver(
      {&code.symbol, &code.mask, spot.placement.symbolMm, spot.limitsMm(code.mask, *request.depth.maxDepthMm)}, search);
  std::vector<float> luminance,
      depthsMm(static_cast<std::size_t>(layout.cells()) * static_cast<std::size_t>(layout.cells()));
  while (!solver.finished()) {
    const std::vector<double>& depths = solver.depths().depthMm;
    for (std::size_t k = 0; k < carved.size(); ++k) depthsMm[cells[k]] = static_cast<float>(depths[carved[k]]);
    const double deepest = *std::max_element(depths.begin(), depths.end());
    luminance = light->luminance(cells, depthsMm,
                                 std::max(kLeastReachModules * spot.placement.moduleMm, kReachPerDepth * deepest));
    solver.update(ofQuietZone(luminance, layout));
  }
  for (const std::uint32_t cell : cells) code.ownEstimate.push_back(static_cast<double>(luminance[cell]));
  code.depths = solver.depths();
  code.passes = solver.iterations();
  code.limited = solver.limitedCount();
  code.milliseconds = millisecondsSince(start);
  return code;
}

}  // namespace qrelief::study
