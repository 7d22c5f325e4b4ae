// SPDX-License-Identifier: GPL-3.0-or-later
// Depth and decoded tries by contrast for each module pattern, with the published steps, on a plate and a curved model,
// up to higher contrasts than anyone would carve. Shows from which contrast on the paper's order of methods holds [Papp
// 2022, figure 20].
#include "study/experiments/experiments.h"
#include "study/methods/by_engine.h"

namespace qrelief::study {
namespace {

Result<Row> measure(const Row& key, StudyContext& context) {
  const auto spot = context.usualSpot(key[0]);
  QRELIEF_TRY(spot);
  const auto modules = byName<ModulePattern>(key[1], modulePatternName);
  EngraveRequest request = publishedRequest(
      **spot, modules, modules == ModulePattern::None ? FinderPattern::None : FinderPattern::ThickPlus);
  request.depth.contrast = std::stod(key[2]);
  const auto code = carveByEngine(**spot, request);
  QRELIEF_TRY(code);
  const auto judged = context.judge(**spot, *code);
  QRELIEF_TRY(judged);
  Row row = readingRow(*judged);
  row.push_back(std::to_string(code->limited));
  return row;
}

}  // namespace

Experiment contrastSweep() {
  Row measures = readingColumns();
  measures.emplace_back("limited");
  Experiment experiment{"contrast_sweep", {"model", "modules", "contrast"},
                        measures,         {},
                        measure,          dependingOn({kSearch, kLight, kPrint, kDecoding})};
  for (const char* model : {"plate", "bunny"})
    for (int pattern = 0; pattern < 5; ++pattern)
      for (int step = 0; step < 13; ++step)
        experiment.cases.push_back(
            {model, std::string(modulePatternName(static_cast<ModulePattern>(pattern))), shown(0.2 + 0.05 * step, 2)});
  return experiment;
}

}  // namespace qrelief::study
