// SPDX-License-Identifier: GPL-3.0-or-later
// Depth by the number of lamps added to the sky, with and without patterns, at the eight models' centres [Papp 2022,
// figure 21], with the published steps. Each lamp is as strong as the sky, at an elevation of 33° over the code (123°
// in the paper's measure); the first is at the code's top, the second on its left.
#include "study/experiments/experiments.h"
#include "study/methods/by_engine.h"
#include "study/methods/literal_2022.h"

namespace qrelief::study {
namespace {

constexpr double kElevationDeg = 33;

Result<Row> measure(const Row& key, StudyContext& context) {
  const auto spot = context.usualSpot(key[0]);
  QRELIEF_TRY(spot);
  const auto modules = byName<ModulePattern>(key[1], modulePatternName);
  EngraveRequest request = publishedRequest(
      **spot, modules, modules == ModulePattern::None ? FinderPattern::None : FinderPattern::ThickPlus);
  for (int lamp = 0; lamp < std::stoi(key[2]); ++lamp)
    request.depth.lights.push_back(
        {.azimuthDeg = lamp == 0 ? 90.0 : 180.0, .elevationDeg = kElevationDeg, .strength = 1});
  const auto code = carveBySearch(key[3], **spot, request);
  QRELIEF_TRY(code);
  return Row{shown(summarise(code->depths).meanMm, 3), std::to_string(code->limited)};
}

}  // namespace

Experiment lampDepths() {
  Experiment experiment{
      "lamp_depths", {"model", "modules", "lamps", "search"}, {"depth_mm", "limited"}, {}, measure, [](const Row& key) {
        return versionOfSearch(key[3], {});
      }};
  for (const std::string& model : StudyContext::models())
    for (const char* modules : {"none", "square"})
      for (const char* lamps : {"0", "1", "2"})
        for (const char* search : {kPublishedSearch, kLiteralSearch})
          experiment.cases.push_back({model, modules, lamps, search});
  return experiment;
}

}  // namespace qrelief::study
