// SPDX-License-Identifier: GPL-3.0-or-later
// Settings drawn at random from the whole space of patterns, contrasts, depth limits, broken-up areas and error
// correction, for modules of 0.6 to 1.6 mm, lying and upright. The defaults are chosen from this table
// (default_choice.cpp). It uses four of the eight models, so that the other four can test the choice.
#include <array>
#include <set>

#include "base/random.h"
#include "study/experiments/chosen_settings.h"
#include "study/experiments/experiments.h"

namespace qrelief::study {
namespace {

constexpr int kDraws = 60;
constexpr std::uint64_t kSeed = 34;

constexpr std::array kContrasts = {0.2, 0.25, 0.3, 0.35, 0.4, 0.5};
constexpr std::array kDepthLimits = {0.8, 1.2, 2.0, 3.0, 4.0, 6.0};  // in modules

std::vector<ChosenSettings> draws() {
  Random random(kSeed);
  std::vector<ChosenSettings> drawn;
  for (int i = 0; i < kDraws; ++i) {
    ChosenSettings settings;
    settings.modules = static_cast<ModulePattern>(random.below(5));
    settings.finders = static_cast<FinderPattern>(random.below(5));
    settings.contrast = kContrasts[random.below(kContrasts.size())];
    settings.maxDepthModules = kDepthLimits[random.below(kDepthLimits.size())];
    settings.breakUpDarkAreas = random.below(2) == 1;
    settings.level = random.below(2) == 1 ? ErrorCorrection::H : ErrorCorrection::M;
    drawn.push_back(settings);
  }
  return drawn;
}

}  // namespace

Experiment defaultSpace() {
  Experiment experiment = chosenSettingsExperiment("default_space");
  int number = 0;
  std::set<Row> keys;  // the same draw may come twice
  for (const ChosenSettings& settings : draws()) {
    const char* pose = number++ % 2 == 0 ? "code-up" : "code-upright";
    for (const double moduleMm : kDefaultModuleWidthsMm)
      for (const char* model : kModelsToChooseBy)
        if (const Row key = settings.key(model, moduleMm, pose); keys.insert(key).second)
          experiment.cases.push_back(key);
  }
  return experiment;
}

}  // namespace qrelief::study
