// SPDX-License-Identifier: GPL-3.0-or-later
// Settings that the program chooses on thick walls, by module width (pipeline/default_patterns.h). The figure of
// default_choice.cpp marks them.
#include "pipeline/default_patterns.h"
#include "study/experiments/chosen_settings.h"
#include "study/experiments/experiments.h"

namespace qrelief::study {
namespace {

Result<Row> measure(const Row& key, StudyContext&) {
  const EngraveRequest chosen = withDefaultPatterns({}, std::stod(key[0]));
  return Row{std::string(modulePatternName(*chosen.code.modulePattern)),
             std::string(finderPatternName(*chosen.code.finderPattern)), shown(*chosen.depth.contrast, 2)};
}

}  // namespace

Experiment defaultSettings() {
  Experiment experiment{"default_settings",    {"module_mm"}, {"modules", "finders", "contrast"}, {}, measure,
                        dependingOn({kSearch})};
  for (const double moduleMm : kDefaultModuleWidthsMm) experiment.cases.push_back({shown(moduleMm, 1)});
  return experiment;
}

}  // namespace qrelief::study
