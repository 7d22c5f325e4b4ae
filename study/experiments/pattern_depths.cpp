// SPDX-License-Identifier: GPL-3.0-or-later
// Depth by module pattern and finder pattern at the eight models' centres [Papp 2022, figures 15 and 16], with the
// published search and our default contrast, as the program reads it and by its words, and decoding as designed and as
// printed lying.
#include "study/experiments/experiments.h"
#include "study/methods/by_engine.h"
#include "study/methods/literal_2022.h"

namespace qrelief::study {
namespace {

Result<Row> measure(const Row& key, StudyContext& context) {
  const auto spot = context.usualSpot(key[0]);
  QRELIEF_TRY(spot);
  const EngraveRequest request = publishedRequest(**spot, byName<ModulePattern>(key[1], modulePatternName),
                                                  byName<FinderPattern>(key[2], finderPatternName));
  const auto code = carveBySearch(key[3], **spot, request);
  QRELIEF_TRY(code);
  const auto judged = context.judge(**spot, *code);
  QRELIEF_TRY(judged);
  return readingRow(*judged);
}

}  // namespace

Experiment patternDepths() {
  Experiment experiment{
      "pattern_depths", {"model", "modules", "finders", "search"},
      readingColumns(), {},
      measure,          [](const Row& key) { return versionOfSearch(key[3], {kLight, kPrint, kDecoding}); }};
  for (const std::string& model : StudyContext::models())
    for (const char* search : {kPublishedSearch, kLiteralSearch})
      for (int pattern = 0; pattern < 5; ++pattern)
        for (int finder = 0; finder < 5; ++finder)
          experiment.cases.push_back({model, std::string(modulePatternName(static_cast<ModulePattern>(pattern))),
                                      std::string(finderPatternName(static_cast<FinderPattern>(finder))), search});
  return experiment;
}

}  // namespace qrelief::study
