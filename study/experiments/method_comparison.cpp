// SPDX-License-Identifier: GPL-3.0-or-later
// Every method at its usual level (methods/methods.h) at the eight models' centres: depth [Papp 2022,
// figure 20], decoding as designed and as printed lying, the time, and the error of the method's own estimate of the
// light in the carved submodules against path tracing of the carved mesh.
//
// Light: luminance of a submodule, 1 = an unoccluded surface. The error is own − traced; the columns have its mean and
// the mean of its absolute value. Traced with 64 paths a submodule, seed 1.
#include <cmath>

#include "study/carved_surface.h"
#include "study/experiments/experiments.h"
#include "study/methods/methods.h"
#include "study/path_tracer.h"

namespace qrelief::study {
namespace {

constexpr int kPaths = 64;

struct LightError {
  double mean = 0, meanSize = 0;
};

Result<LightError> lightError(const StudyPlacement& spot, const CarvedCode& code) {
  const auto surface = CarvedSurface::make(spot, code.depths);
  QRELIEF_TRY(surface);
  std::vector<SeenCell> cells;
  for (const std::uint32_t i : carvedOf(code.mask)) {
    const Vec2 corner =
        code.depths.corner(static_cast<int>(i) / code.mask.rows(), static_cast<int>(i) % code.mask.rows());
    const double h = code.depths.submoduleMm();
    cells.push_back({{corner.x, corner.y - h}, {corner.x + h, corner.y}});
  }
  PathTraceOptions options{.paths = kPaths, .albedo = static_cast<double>(spot.request.depth.albedo), .seed = 1};
  if (code.readUnder) options.lights = {*code.readUnder};
  const std::vector<CellLight> traced = traceCells(surface->tree(), spot.placement.frame, cells, options);
  LightError error;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const double apart = code.ownEstimate[k] - traced[k].luminance.mean;
    error.mean += apart / static_cast<double>(cells.size());
    error.meanSize += std::abs(apart) / static_cast<double>(cells.size());
  }
  return error;
}

Result<Row> measure(const Row& key, StudyContext& context) {
  const Method& method = *findMethod(key[1]);
  const auto spot = context.usualSpot(key[0], method.direction);
  QRELIEF_TRY(spot);
  const auto code = method.carve(**spot, method.usual);
  QRELIEF_TRY(code);
  const auto judged = context.judge(**spot, *code);
  QRELIEF_TRY(judged);
  const auto error = lightError(**spot, *code);
  QRELIEF_TRY(error);
  Row row = readingRow(*judged);
  for (const std::string& value : {std::to_string(code->passes), std::to_string(code->limited), shown(error->mean, 3),
                                   shown(error->meanSize, 3), shown(code->milliseconds, 0)})
    row.push_back(value);
  return row;
}

}  // namespace

Experiment methodComparison() {
  Row measures = readingColumns();
  for (const char* column : {"passes", "limited", "light_error", "light_error_size", "search_ms"})
    measures.emplace_back(column);
  Experiment experiment{"method_comparison", {"model", "method"}, measures, {}, measure, versionOfMethod};
  for (const std::string& model : StudyContext::models())
    for (const Method& method : methods()) experiment.cases.push_back({model, method.name});
  return experiment;
}

}  // namespace qrelief::study
