// SPDX-License-Identifier: GPL-3.0-or-later
// Every method at its usual level (methods/methods.h) at the eight models' centres: depth [Papp 2022,
// figure 20], decoding as designed and as printed lying, the time, and the error of the method's own estimate of the
// light in the carved submodules against path tracing of the carved mesh.
//
// Light: luminance of a submodule, 1 = an unoccluded surface. The error is own − traced; the columns have its mean and
// the mean of its absolute value. Traced with 64 paths a submodule, seed 1.
#include "study/experiments/experiments.h"
#include "study/light_error.h"
#include "study/methods/methods.h"

namespace qrelief::study {
namespace {

Result<Row> measure(const Row& key, StudyContext& context) {
  const Method& method = *findMethod(key[1]);
  const auto spot = context.usualSpot(key[0], method.direction);
  QRELIEF_TRY(spot);
  const auto code = method.carve(**spot, method.usual);
  QRELIEF_TRY(code);
  const auto judged = context.judge(**spot, *code);
  QRELIEF_TRY(judged);
  const auto traced = tracedLuminance(**spot, *code);
  QRELIEF_TRY(traced);
  const LightError error = lightErrorOf(code->ownEstimate, *traced);
  Row row = readingRow(*judged);
  for (const std::string& value : {std::to_string(code->passes), std::to_string(code->limited), shown(error.mean, 3),
                                   shown(error.meanSize, 3), shown(code->milliseconds, 0)})
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
