// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of the paper's search by its words, one at a time, on a plate [Papp 2022, §7]: depth, passes and time with
//   - light: the program's exact one, or horizon-based ambient occlusion;
//   - neighbours: the light modules only, or all eight neighbours;
//   - steps: O(x) as in `papp-2022` (rounded up, a change of 0.005 is significant), or unrounded with a larger change,
//     since the last iteration or since the last significant change.
#include <array>

#include "study/experiments/experiments.h"
#include "study/methods/by_engine.h"
#include "study/methods/literal_2022.h"

namespace qrelief::study {
namespace {

constexpr const char* kRounded = "rounded";

/// Returns the search's options for "rounded", or for e.g. "0.02 last-iteration".
LiteralOptions optionsOf(const Row& key) {
  LiteralOptions options;
  if (key[3] == "hbao") options.hbao = HbaoOptions();
  if (key[4] == "light") options.surroundings = Surroundings::LightModules;
  options.roundSteps = key[5] == kRounded;
  options.significantChange = options.roundSteps ? DepthSearchOptions{}.significantChange : std::stod(key[5]);
  options.changeSince = key[5].ends_with("last-change") ? ChangeSince::LastChange : ChangeSince::LastIteration;
  return options;
}

Result<Row> measure(const Row& key, StudyContext& context) {
  const auto spot = context.usualSpot("plate");
  QRELIEF_TRY(spot);
  EngraveRequest request = publishedRequest(**spot, byName<ModulePattern>(key[0], modulePatternName),
                                            byName<FinderPattern>(key[1], finderPatternName));
  request.depth.contrast = std::stod(key[2]);
  const auto code = carveLiteral2022(**spot, request, optionsOf(key));
  QRELIEF_TRY(code);
  const DepthSummary depth = summarise(code->depths);
  return Row{shown(depth.meanMm, 3), shown(depth.maxMm, 2), std::to_string(code->passes), std::to_string(code->limited),
             shown(code->milliseconds, 0)};
}

}  // namespace

Experiment literalParts() {
  Experiment experiment{"literal_parts",
                        {"modules", "finders", "contrast", "light", "neighbours", "steps"},
                        {"depth_mm", "depth_max_mm", "passes", "limited", "search_ms"},
                        {},
                        measure,
                        dependingOn({kSearch, kHbao, kLiteral})};
  static constexpr std::array<std::array<const char*, 2>, 7> kPatterns = {{{"square", "thick-plus"},
                                                                           {"thick-plus", "thick-plus"},
                                                                           {"thin-plus", "thick-plus"},
                                                                           {"diamond", "thick-plus"},
                                                                           {"square", "diamond"},
                                                                           {"thin-plus", "diamond"},
                                                                           {"none", "none"}}};
  for (const char* contrast : {"0.3", "0.2"})
    for (const char* light : {"exact", "hbao"})
      for (const auto& [modules, finders] : kPatterns)
        for (const char* neighbours : {"light", "eight"})
          experiment.cases.push_back({modules, finders, contrast, light, neighbours, kRounded});
  for (const auto& [modules, finders] : {kPatterns.front(), kPatterns.back()})
    for (const char* light : {"exact", "hbao"})
      for (const char* steps : {"0.005 last-iteration", "0.01 last-iteration", "0.02 last-iteration",
                                "0.05 last-iteration", "0.02 last-change", "0.05 last-change"})
        experiment.cases.push_back({modules, finders, "0.3", light, "light", steps});
  return experiment;
}

}  // namespace qrelief::study
