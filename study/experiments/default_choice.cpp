// SPDX-License-Identifier: GPL-3.0-or-later
// Decoded tries as printed against depth, for the settings left to choose from after default_space.cpp, each from
// shallow to deep, at four module widths, lying, upright and slanted. The defaults (pipeline/default_patterns.h) are
// chosen on the models of kModelsToChooseBy; the figure reports the others.
#include "study/experiments/chosen_settings.h"
#include "study/experiments/experiments.h"

namespace qrelief::study {
namespace {

struct Family {
  ModulePattern modules;
  FinderPattern finders;
  double maxDepthModules;
  bool breakUpDarkAreas;
  std::vector<double> contrasts;
};

const std::vector<Family>& families() {
  using enum ModulePattern;
  static const std::vector<Family> kAll = {{None, FinderPattern::None, 4, true, {0.25}},
                                           {None, FinderPattern::None, 4, false, {0.25, 0.3}},
                                           {Diamond, FinderPattern::None, 4, false, {0.35}},
                                           {Diamond, FinderPattern::ThickPlusSharp, 4, false, {0.4, 0.45}},
                                           {ThickPlus, FinderPattern::None, 4, false, {0.2, 0.25, 0.27, 0.3, 0.35}},
                                           {ThickPlus, FinderPattern::ThickPlusSharp, 4, false, {0.25, 0.3, 0.35}},
                                           {ThickPlus, FinderPattern::ThickPlusSharp, 1.2, false, {0.3}},
                                           {Square, FinderPattern::ThickPlusSharp, 4, false, {0.4}}};
  return kAll;
}

}  // namespace

Experiment defaultChoice() {
  Experiment experiment = chosenSettingsExperiment("default_choice");
  for (const auto& models : {kModelsToChooseBy, kModelsToTestBy})
    for (const double moduleMm : {0.8, 1.0, 1.2, 1.6})
      for (const Family& family : families())
        for (const double contrast : family.contrasts)
          for (const char* model : models)
            for (const char* pose : {"code-up", "code-upright", kSlantedPose})
              experiment.cases.push_back(ChosenSettings{family.modules, family.finders, contrast,
                                                        family.maxDepthModules, family.breakUpDarkAreas}
                                             .key(model, moduleMm, pose));
  return experiment;
}

}  // namespace qrelief::study
