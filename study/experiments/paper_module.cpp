// SPDX-License-Identifier: GPL-3.0-or-later
// Every method at its usual level (methods/methods.h) with modules of 1.2 mm, the width of the paper's prints
// [Papp 2022, §8], on models scaled with the module: depth and decoded tries, as designed and as printed lying.
#include "study/experiments/experiments.h"
#include "study/methods/methods.h"

namespace qrelief::study {
namespace {

constexpr double kPaperModuleMm = 1.2;

Result<Row> measure(const Row& key, StudyContext& context) {
  const Method& method = *findMethod(key[1]);
  const auto spot = context.spotOfWidth(key[0], kPaperModuleMm, method.direction);
  QRELIEF_TRY(spot);
  const auto code = method.carve(**spot, method.usual);
  QRELIEF_TRY(code);
  const auto judged = context.judge(**spot, *code);
  QRELIEF_TRY(judged);
  return readingRow(*judged);
}

}  // namespace

Experiment paperModule() {
  Experiment experiment{"paper_module", {"model", "method"}, readingColumns(), {}, measure, versionOfMethod};
  for (const std::string& model : StudyContext::models())
    for (const Method& method : methods()) experiment.cases.push_back({model, method.name});
  return experiment;
}

}  // namespace qrelief::study
