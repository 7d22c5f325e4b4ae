// SPDX-License-Identifier: GPL-3.0-or-later
// Decoding against depth: every method from shallow to deep at the eight models' centres, as designed and as printed
// lying with the first process.
#include "study/experiments/experiments.h"
#include "study/methods/methods.h"

namespace qrelief::study {
namespace {

Result<Row> measure(const Row& key, StudyContext& context) {
  const Method& method = *findMethod(key[1]);
  const auto spot = context.usualSpot(key[0], method.direction);
  QRELIEF_TRY(spot);
  const auto code = method.carve(**spot, std::stod(key[2]));
  QRELIEF_TRY(code);
  const auto judged = context.judge(**spot, *code);
  QRELIEF_TRY(judged);
  return readingRow(*judged);
}

}  // namespace

Experiment frontier() {
  Experiment experiment{"frontier", {"model", "method", "level"}, readingColumns(), {}, measure, versionOfMethod};
  for (const std::string& model : StudyContext::models())
    for (const Method& method : methods())
      for (const double level : method.levels) experiment.cases.push_back({model, method.name, shown(level, 2)});
  return experiment;
}

}  // namespace qrelief::study
